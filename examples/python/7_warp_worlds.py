# SPDX-License-Identifier: MIT
"""32 worlds of MuJoCo Warp, in each a disc that slides and spins on a floor; and what many contacts cost in a kernel of
NVIDIA Warp.

MuJoCo's own friction is off; the kernel `brake` has that of a limitcurve table, before every step. It is implicit: the
trial is the impulse that would stop the disc within the step, and friction takes of it the closest point of the limit
curve, in the metric of the kinetic energy. So it stops the disc and needs no spring. Beside it the disc's own equations
are integrated: dv/dt = -mu g f, d(omega)/dt = -mu P a m/I. Whatever it starts with, a uniform disc ends with v/(a
omega) = 0.653 (Farkas et al., Phys. Rev. Lett. 90:248302, 2003).
"""

import time
from typing import Any

import limitcurve as lc
import limitcurve.warp as lw
import matplotlib.pyplot as plt
import mujoco  # type: ignore[import-untyped]
import mujoco_warp as mjw  # type: ignore[import-untyped]
import numpy as np
import warp as wp

wp.config.log_level = wp.LOG_WARNING  # not what it compiles: the first run takes minutes, the next seconds
WORLDS, STEPS, DT, RADIUS, MASS, MU, G = 32, 2500, 1e-4, 0.05, 0.5, 0.4, 9.81
INERTIA, LIMIT = 0.5 * MASS * RADIUS**2, MU * MASS * G
MODEL = f"""<mujoco><option timestep="{DT}" gravity="0 0 0"/><worldbody><body>
  <joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint type="hinge" axis="0 0 1"/>
  <geom type="cylinder" size="{RADIUS} 0.005" mass="{MASS}" contype="0" conaffinity="0"/></body></worldbody></mujoco>"""


@wp.kernel
def brake(cells: lw.Cells, dt: float, velocity: wp.array2d(dtype=float),  # type: ignore
          applied: wp.array2d(dtype=wp.spatial_vector)):  # type: ignore
    world = wp.tid()
    push = wp.vec3(velocity[world, 0] * MASS / dt, velocity[world, 1] * MASS / dt, 0.0)
    turn = velocity[world, 2] * INERTIA / dt  # push and turn would stop it
    force, moment = wp.length(push) / LIMIT, wp.abs(turn) / (LIMIT * RADIUS)
    kept_force, kept_moment, _slips = lw.closest_point(cells, force, moment, MASS * RADIUS * RADIUS / INERTIA)
    push, turn = push * (kept_force / wp.max(force, 1.0e-20)), turn * (kept_moment / wp.max(moment, 1.0e-20))
    applied[world, 1] = wp.spatial_vector(-push, wp.vec3(0.0, 0.0, -turn))


def in_mujoco_warp(speed: Any, spin: Any) -> Any:
    """(|v|, omega) of all worlds after each step."""
    model = mujoco.MjModel.from_xml_string(MODEL)
    m, d = mjw.put_model(model), mjw.put_data(model, mujoco.MjData(model), nworld=WORLDS)
    d.qvel.assign(np.stack([speed, 0 * speed, spin], axis=1).astype(np.float32))
    rows = []
    for _ in range(STEPS):
        wp.launch(brake, WORLDS, [cells, DT, d.qvel, d.xfrc_applied])
        mjw.step(m, d)
        now = d.qvel.numpy()
        rows.append((np.hypot(now[:, 0], now[:, 1]), np.abs(now[:, 2])))
    return np.array(rows)


def by_the_equations(state: Any, parts: int = 10) -> Any:
    """The same by Heun's method in double precision, with smaller steps."""
    table, h, rows = lc.Table("uniform", 1e-10), DT / parts, []

    def rate(state: Any) -> Any:
        force, moment = table.wrench(state[0], RADIUS * state[1])
        return np.array([-LIMIT / MASS * force, -LIMIT * RADIUS / INERTIA * moment])

    for _ in range(STEPS):
        for _ in range(parts):
            first = rate(state)
            state = np.maximum(state + h / 2 * (first + rate(np.maximum(state + h * first, 0))), 0)
        rows.append(state)
    return np.array(rows)


random, cells = np.random.default_rng(0), lw.cells(lc.Table("uniform", 1e-6))
start = np.array([random.uniform(0.1, 0.5, WORLDS), random.uniform(2, 12, WORLDS)])
found, exact = in_mujoco_warp(*start), by_the_equations(start)
moving = (exact[:, 0] > 0.01) & (RADIUS * exact[:, 1] > 0.01)
apart = [size * np.abs(found - exact)[:, i][moving].max() for i, size in enumerate((1, RADIUS))]
print(
    f"{WORLDS} worlds on {wp.get_device()}: v is never further than {apart[0]:.1e} m/s from the equations, a omega "
    f"{apart[1]:.1e} m/s"
)
assert max(apart) < 1e-4 and found[-1].max() < 1e-6  # a step changes v by 4e-4 m/s; in the end all rest

for n in (1, 1000, 1_000_000):
    arrays = [
        wp.array(random.uniform(-1e-3, 1e-3, (n, 3)) / (1, 1, RADIUS), dtype=float),
        wp.empty((n, 2), dtype=wp.spatial_vector)
    ]
    seconds = []
    for _ in range(20):
        began = time.perf_counter()
        wp.launch(brake, n, [cells, DT, *arrays])
        wp.synchronize()
        seconds.append(time.perf_counter() - began)
    print(f"{n:9,} contacts: {1e6 * min(seconds):9.1f} us a step")
figure, axes = plt.subplots(layout="constrained")
axes.plot(np.where(moving, found[:, 0] / np.maximum(RADIUS * found[:, 1], 1e-9), np.nan))
axes.set(xlabel="step", ylabel="v/(a omega)", ylim=(0, 4), title=f"{WORLDS} discs end alike, at 0.653")
figure.savefig("7_warp_worlds.svg")
