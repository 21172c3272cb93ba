# SPDX-License-Identifier: MIT
"""A limit curve in ten lines: of a soft pad and of an elastic sphere, with the usual ellipse."""

import limitcurve as lc
import limitcurve.plot
import matplotlib.pyplot as plt

axes = lc.plot.limit_curve(["hertz", "uniform"], fits=["ellipse"])
axes.set_title("What a soft finger bears at once")
plt.savefig("1_limit_curve.svg")

table = lc.validate("hertz")
error = table["max_over_estimate"][table["model"] == "ellipse"][0]
print(f"the ellipse promises up to {100 * error:.1f} % too much")
assert 0.06 < error < 0.07
