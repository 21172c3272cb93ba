# SPDX-License-Identifier: MIT
"""Bullet, by PyBullet; its bodies are of the kind that createMultiBody makes."""

import importlib.metadata
import math

import pybullet as p

import drag
import hold


VERSION = "PyBullet " + importlib.metadata.version("pybullet")
UNDAMPED = {"linearDamping": 0, "angularDamping": 0, "activationState": p.ACTIVATION_STATE_DISABLE_SLEEPING}
OTHER = {"lateralFriction": 1, "spinningFriction": 0, "rollingFriction": 0}  # of what the finger touches


def typed(given):
    return {"lateralFriction": given["setFriction"], "spinningFriction": given["setSpinningFriction"],
            "rollingFriction": given["setRollingFriction"]}


def measure():
    given = drag.translated("bullet")
    yield from drag.measure("bullet", VERSION, "ball", "box", lambda v, w: one(given, v, w))


def one(given, slide, spin):
    p.connect(p.DIRECT)
    try:
        p.setGravity(0, 0, -drag.GRAVITY)
        p.setPhysicsEngineParameter(fixedTimeStep=drag.DT, numSolverIterations=200, numSubSteps=1)
        floor = p.createMultiBody(0, p.createCollisionShape(p.GEOM_PLANE))
        shape = p.createCollisionShape(p.GEOM_SPHERE, radius=drag.BALL_RADIUS)
        body = p.createMultiBody(drag.MASS, shape, basePosition=[0, 0, drag.BALL_RADIUS])
        p.changeDynamics(floor, -1, **OTHER)
        p.changeDynamics(body, -1, localInertiaDiagonal=[drag.INERTIA] * 3, **typed(given), **UNDAMPED)
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


def held():
    yield "bullet", VERSION, "ball", hold.DISC, gripped, 1


def gripped(offset):
    p.resetSimulation() if p.isConnected() else p.connect(p.DIRECT)
    p.setPhysicsEngineParameter(fixedTimeStep=1e-3, numSolverIterations=200, numSubSteps=1)
    given = hold.typed(*hold.DISC, engine="bullet")
    body = p.createMultiBody(hold.MASS,
                             p.createCollisionShape(p.GEOM_BOX, halfExtents=hold.HALF),
                             basePosition=[-offset, 0, 0])
    p.changeDynamics(body, -1, **OTHER, **UNDAMPED)
    shape, pads = p.createCollisionShape(p.GEOM_SPHERE, radius=hold.BALL), []
    for way in (-1, 1):
        place = [0, 0, -way * (hold.HALF[2] + hold.BALL)]
        pads.append(
            p.createMultiBody(0,
                              -1,
                              basePosition=place,
                              linkMasses=[hold.PAD_MASS],
                              linkCollisionShapeIndices=[shape],
                              linkVisualShapeIndices=[-1],
                              linkPositions=[[0, 0, 0]],
                              linkOrientations=[[0, 0, 0, 1]],
                              linkInertialFramePositions=[[0, 0, 0]],
                              linkInertialFrameOrientations=[[0, 0, 0, 1]],
                              linkParentIndices=[0],
                              linkJointTypes=[p.JOINT_PRISMATIC],
                              linkJointAxis=[[0, 0, way]]))
        p.changeDynamics(pads[-1], 0, jointDamping=hold.SLOWED, **typed(given))
        p.setJointMotorControl2(pads[-1], 0, p.VELOCITY_CONTROL, force=0)

    def step(weight):
        for pad in pads:
            p.setJointMotorControl2(pad, 0, p.TORQUE_CONTROL, force=hold.GRIP)
        place, turn = p.getBasePositionAndOrientation(body)
        p.applyExternalForce(body, -1, [0, -weight, 0], place, p.WORLD_FRAME)
        p.stepSimulation()
        return 2 * math.atan2(turn[2], turn[3]), place[1]

    return step
