# SPDX-License-Identifier: MIT
"""Bullet, by PyBullet; its bodies are of the kind that createMultiBody makes."""

import importlib.metadata

import pybullet as p

import drag


def measure():
    version = "PyBullet " + importlib.metadata.version("pybullet")
    given = drag.translated("bullet")
    yield from drag.measure("bullet", version, "ball", "box", lambda v, w: one(given, v, w))


def one(given, slide, spin):
    p.connect(p.DIRECT)
    try:
        p.setGravity(0, 0, -drag.GRAVITY)
        p.setPhysicsEngineParameter(fixedTimeStep=drag.DT, numSolverIterations=200, numSubSteps=1)
        floor = p.createMultiBody(0, p.createCollisionShape(p.GEOM_PLANE))
        shape = p.createCollisionShape(p.GEOM_SPHERE, radius=drag.BALL_RADIUS)
        body = p.createMultiBody(drag.MASS, shape, basePosition=[0, 0, drag.BALL_RADIUS])
        p.changeDynamics(floor, -1, lateralFriction=1, spinningFriction=0, rollingFriction=0)
        p.changeDynamics(body, -1, lateralFriction=given["setFriction"], linearDamping=0, angularDamping=0, localInertiaDiagonal=[drag.INERTIA] * 3,
                         activationState=p.ACTIVATION_STATE_DISABLE_SLEEPING)
        p.changeDynamics(body, -1, spinningFriction=given["setSpinningFriction"], rollingFriction=given["setRollingFriction"])
        vertical = [0.0]  # resetting a place also resets the velocity

        def set_motion(v, w):
            p.resetBasePositionAndOrientation(body, [0, 0, p.getBasePositionAndOrientation(body)[0][2]], [0, 0, 0, 1])
            p.resetBaseVelocity(body, [v, 0, vertical[0]], [0, 0, w])

        def motion():
            v, w = p.getBaseVelocity(body)
            vertical[0] = v[2]
            return v[0], v[2], w[2]

        return drag.drag_free_body(set_motion, p.stepSimulation, motion, slide, spin)
    finally:
        p.disconnect()
