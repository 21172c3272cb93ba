# SPDX-License-Identifier: MIT
"""A million contacts a step, compared with plain NumPy for the ellipse and the radial projection."""

import time
from typing import Any

import limitcurve as lc
import matplotlib.pyplot as plt
import numpy as np
from numpy.typing import DTypeLike, NDArray

Array = NDArray[Any]
N = 1_000_000
MU, RADIUS, STIFFNESS, TWIST_STIFFNESS, M0 = 0.6, 0.005, 1000.0, 0.025, lc.Law("hertz").moment_ratio


class NumpyBatch:
    """Step b of the paper by its equations: springs, and the trial projected radially onto the ellipse."""

    def __init__(self, n: int) -> None:
        self.proxy = np.zeros((3, n))
        self.fx = np.zeros(n)

    def update(self, x: Array, y: Array, depth: Array, twist: Array) -> None:
        load = STIFFNESS * np.maximum(depth, 0)
        trial = self.proxy - np.stack([x, y, twist])
        force = STIFFNESS * np.hypot(trial[0], trial[1]) / (MU * load)
        moment = TWIST_STIFFNESS * np.abs(trial[2]) / (MU * load * RADIUS * M0)
        trial /= np.maximum(np.sqrt(force**2 + moment**2), 1)
        self.proxy = trial + np.stack([x, y, twist])
        self.fx = STIFFNESS * trial[0]


def batch(curve: lc.Table | lc.Curve, projection: str, dtype: DTypeLike = np.float64) -> lc.Batch:
    return lc.Batch(curve,
                    N,
                    projection=projection,
                    dtype=dtype,
                    mu=MU,
                    radius_law=f"constant:a={RADIUS}",
                    stiffness=STIFFNESS,
                    twist_stiffness=TWIST_STIFFNESS)


random = np.random.default_rng(1)
steps = [[1e-3 * random.normal(size=N), 1e-3 * random.normal(size=N),
          np.full(N, 0.001), 0.1 * random.normal(size=N)] for _ in range(3)]
ellipse, table = lc.ellipse(1, M0), lc.Table("hertz", 1e-6)
batches: dict[str, NumpyBatch | lc.Batch] = {
    "NumPy, ellipse, radial": NumpyBatch(N),
    "ellipse, radial": batch(ellipse, "radial"),
    "ellipse, radial, float32": batch(ellipse, "radial", np.float32),
    "exact to 1e-6, closest point": batch(table, "closest-point"),
    "exact to 1e-6, closest point, float32": batch(table, "closest-point", np.float32),
}
cost, forces = {}, {}
for name, contacts in batches.items():
    kind = np.float32 if "float32" in name else np.float64
    contacts.update(np.zeros(N), np.zeros(N), np.full(N, 0.001), np.zeros(N))  # all make contact at the origin
    seconds = []
    for step in steps:
        x, y, depth, twist = (array.astype(kind) for array in step)
        began = time.perf_counter()
        contacts.update(x, y, depth, twist)
        seconds.append(time.perf_counter() - began)
    cost[name] = 1e9 * min(seconds) / N
    forces[name] = contacts.fx
    print(f"{name:40} {cost[name]:7.1f} ns a contact")
assert np.allclose(forces["ellipse, radial"], forces["NumPy, ellipse, radial"], rtol=1e-9, atol=1e-9)

figure, axes = plt.subplots(layout="constrained")
axes.barh(list(cost), list(cost.values()))
axes.invert_yaxis()
axes.set_xlabel("a contact and step [ns]")
figure.savefig("6_million_contacts.svg")
