# SPDX-License-Identifier: MIT
"""Slip margin of a grasp over a trajectory: a 200 g tool, held beside its centre of mass, swings up and down."""

import limitcurve as lc
import matplotlib.pyplot as plt
import numpy as np

mass, offset, gravity = 0.2, 0.02, 9.81  # [kg], from the grasp to the centre of mass [m], [m/s²]
mu, radius_law, grip = 0.8, "hertz:R=0.008,E=2e5", 10.0  # of each of two fingers [N]
table = lc.Table("hertz", tolerance=1e-6)

time = np.linspace(0, 2, 501)
acceleration = 4 * np.sin(2 * np.pi * time)  # of the hand, upwards [m/s²]
force = mass * np.abs(gravity + acceleration) / 2  # on each finger
moment = force * offset

needed = table.load_to_hold(force, moment, mu=mu, radius_law=radius_law)
without_moment = force / mu  # the grip by a rule without torsion
print(f"grip needed: {needed.max():.2f} N at most; without the moment one would think {without_moment.max():.2f} N")
assert (needed >= without_moment).all()
assert needed.max() < grip

figure, axes = plt.subplots(layout="constrained")
axes.plot(time, needed, label="needed: force and moment on the limit curve")
axes.plot(time, without_moment, "--", label="needed, if the moment is forgotten")
axes.axhline(grip, color="0.4", linewidth=0.8, label="grip")
axes.set(xlabel="time [s]", ylabel="load of a finger [N]", ylim=(0, None))
axes.legend(frameon=False)
figure.savefig("4_slip_margin.svg")
