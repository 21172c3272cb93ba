# SPDX-License-Identifier: MIT
"""Which coefficient does MuJoCo need? For a silicone fingertip: mu = 0.8, a = 4 mm at 2 N, growing as P^(1/3)."""

import limitcurve as lc
import limitcurve.plot
import matplotlib.pyplot as plt

radius_law = f"power:c={0.004 / 2 ** (1 / 3)},gamma={1 / 3}"
table = lc.translate("hertz", radius_law, mu=0.8, load=2, loads=[1, 4])
for engine, parameter, value, model, error in zip(
    table["engine"], table["parameter"], table["value"], table["model"], table["loads_error"]
):
    print(f"{engine:10} {parameter:45} {value:10.6g}   ({model}, off by up to {100 * error:.0f} % from 1 to 4 N)")

# Torsional friction in MuJoCo is the radius at which the moment limit is mu_r P: m0 mu a.
torsional = table["value"][(table["engine"] == "mujoco") & (table["parameter"] == "geom.friction[1]")][0]
assert abs(torsional - lc.Law("hertz").moment_ratio * 0.8 * 0.004) < 1e-12

axes = lc.plot.p_curves("hertz", radius_law, 0.8, [1, 2, 4])
axes.set_title("What constant coefficients cannot follow")
plt.savefig("2_engine_coefficients.svg")
