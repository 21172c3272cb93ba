# SPDX-License-Identifier: MIT
"""Newton's solver XPBD, on a processor; and what two fingers hold in its solver MuJoCo, which in_mujoco.py drags."""

import newton
import numpy as np
import warp as wp

import drag
import hold
import in_mujoco

wp.config.quiet = True
STEPS = 300


def measure():
    # The mean of both shapes counts: both get the same.
    given = drag.translated("newton-xpbd")
    xpbd = Finger(given, lambda model: newton.solvers.SolverXPBD(model, iterations=20))
    yield from drag.measure("newton-xpbd", newton.__version__, "ball", "box", xpbd.drag)


class Finger:
    def __init__(self, given, make):
        builder = newton.ModelBuilder(gravity=(0, 0, -drag.GRAVITY))
        shape = newton.ModelBuilder.ShapeConfig(density=0.0,
                                                mu=given["ShapeConfig.mu"],
                                                mu_torsional=given["ShapeConfig.mu_torsional"],
                                                mu_rolling=0.0)
        builder.add_ground_plane(cfg=shape)
        inertia = wp.mat33(*(drag.INERTIA * np.eye(3)).ravel())
        body = builder.add_body(xform=wp.transform((0, 0, drag.BALL_RADIUS), wp.quat_identity()),
                                mass=drag.MASS,
                                inertia=inertia,
                                lock_inertia=True)
        builder.add_shape_sphere(body, radius=drag.BALL_RADIUS, cfg=shape)
        self.model = builder.finalize(device="cpu")
        self.solver = make(self.model)

    def drag(self, slide, spin):
        now, then, control = self.model.state(), self.model.state(), self.model.control()
        mean = np.zeros(3)
        for i in range(STEPS):
            place, motion = now.body_q.numpy(), now.body_qd.numpy()
            place[0] = (0, 0, place[0, 2], 0, 0, 0, 1)
            before = motion[0, 2]
            motion[0] = (slide, 0, before, 0, 0, spin)
            now.body_q.assign(place)
            now.body_qd.assign(motion)
            newton.eval_ik(self.model, now, now.joint_q, now.joint_qd)
            now.clear_forces()
            self.solver.step(now, then, control, self.model.collide(now), drag.DT)
            after = then.body_qd.numpy()[0]
            if i >= 3 * STEPS // 4:
                mean += (drag.MASS * (slide - after[0]) / drag.DT, drag.INERTIA * (spin - after[5]) / drag.DT,
                         drag.MASS * ((after[2] - before) / drag.DT + drag.GRAVITY))
            now, then = then, now
        return tuple(mean)


def held():
    geom, worlds = in_mujoco.ball(*hold.DISC)[1], 26
    for setting, cone, impratio in (("ball, elliptic, impratio 10", "elliptic", 10),
                                    ("ball, elliptic, impratio 1e4", "elliptic", 1e4),
                                    ("ball, pyramid", "pyramidal", 1), ("ball, pyramid, impratio 10", "pyramidal", 10)):
        yield "newton", newton.__version__, setting, hold.DISC, lambda offsets, a=(geom, cone, impratio): gripped(
            *a, offsets), worlds


def gripped(geom, cone, impratio, offsets):
    one, builder = (newton.ModelBuilder(gravity=(0, 0, 0)) for _ in range(2))
    newton.solvers.SolverMuJoCo.register_custom_attributes(one)
    one.add_mjcf(in_mujoco.scene(geom, ""))
    builder.replicate(one, len(offsets))
    model = builder.finalize(device="cpu")
    solver = newton.solvers.SolverMuJoCo(model, cone=cone, impratio=impratio)
    states, control = [model.state(), model.state()], model.control()
    place = states[0].joint_q.numpy().reshape(len(offsets), -1)
    place[:, 0] -= offsets
    states[0].joint_q.assign(place.ravel())
    newton.eval_fk(model, states[0].joint_q, states[0].joint_qd, states[0])

    def step(weight):
        now, then = states
        forces = [[0, -weight, 0, 0, 0, 0], *([0, 0, grip, 0, 0, 0] for grip in (-hold.GRIP, hold.GRIP))]
        now.body_f.assign(forces * len(offsets))
        solver.step(now, then, control, None, 1e-3)
        states.reverse()
        place = then.body_q.numpy().reshape(len(offsets), -1, 7)[:, 0]
        return 2 * np.arctan2(place[:, 5], place[:, 6]), place[:, 1]

    return step
