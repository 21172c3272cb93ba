# SPDX-License-Identifier: MIT
"""A haptic loop at 1 kHz: a finger presses on a plane, slides, turns and lifts; plots the force on the user."""

import limitcurve as lc
import matplotlib.pyplot as plt
import numpy as np

table = lc.Table("hertz", tolerance=1e-6)
finger = lc.SoftFinger(table,
                       mu=0.6,
                       mu_dynamic=0.5,
                       radius_law="power:c=0.00207,gamma=0.259",
                       stiffness=800,
                       twist_stiffness=0.003,
                       damping=1.5)

dt = 1e-3
normal = (0.0, 0.0, 1.0)
felt = []
for step in range(2000):
    time = step * dt
    # The device: here a scripted motion, in a real loop the encoders.
    depth = 0.003 * np.sin(np.pi * time / 2) - 0.0005
    place = (0.01 * np.sin(2 * np.pi * time), 0.0, 0.0)
    twist = 0.8 * np.sin(3 * np.pi * time)
    out = finger.update(place, normal, depth, twist, dt)
    felt.append((time, out.load, out.force[0], 1e3 * out.moment, int(out.state)))

time, load, force, moment, state = np.array(felt).T
slips = state == lc.ContactState.slip
print(f"{int(slips.sum())} of {len(time)} steps slip; {load.max():.2f} N at most")
assert slips.any() and (state == lc.ContactState.free).any() and np.isfinite(force).all()
assert (np.abs(force) <= 0.6 * (load + 1) + 1e-9).all()

figure, (upper, lower) = plt.subplots(2, 1, sharex=True, layout="constrained")
upper.plot(time, load, label="load")
upper.plot(time, force, label="friction")
upper.set_ylabel("[N]")
upper.legend(frameon=False)
lower.plot(time, moment, color="C2", label="friction moment")
lower.set(xlabel="time [s]", ylabel="[N mm]")
lower.legend(frameon=False)
figure.savefig("5_haptic_loop.svg")
