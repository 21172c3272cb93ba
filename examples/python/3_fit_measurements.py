# SPDX-License-Identifier: MIT
"""Fit my measurements: from slips seen by a force-torque sensor to the parameters of a finger, with standard errors."""

import limitcurve as lc
import limitcurve.plot
import matplotlib.pyplot as plt
import numpy as np

# Slips of a finger with mu = 0.7 and a = 5 mm under a uniform pressure, at random centres of rotation, with 2 % of
# noise.
random = np.random.default_rng(1)
load = random.uniform(1, 4, 200)
f, m = lc.Law("uniform").evaluate(10 ** random.uniform(-1.5, 1.5, 200))
slips = {
    "load": load,
    "force": 0.7 * load * (f + 0.02 * random.normal(size=200)),
    "moment": 0.7 * load * 0.005 * (m + 0.02 * 2 / 3 * random.normal(size=200)),
}

table = lc.fit("ratio", slips, law="uniform", quiet=True)
found = dict(zip(table["parameter"].tolist(), zip(table["value"].tolist(), table["std_error"].tolist())))
for name, (value, error) in found.items():
    print(f"{name:8} {value:.5g} ± {error:.2g}")
assert abs(found["mu"][0] - 0.7) < 4 * found["mu"][1] and abs(found["radius"][0] - 0.005) < 4 * found["radius"][1]

axes = lc.plot.limit_curve("uniform", fits=[], points=slips, mu=found["mu"][0], radius=found["radius"][0])
axes.set_title("200 slips and the curve through them")
plt.savefig("3_fit_measurements.svg")
