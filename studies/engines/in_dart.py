# SPDX-License-Identifier: MIT
"""DART, by dartpy: it has no friction moment at a contact point; nothing but mu can be typed."""

import importlib.metadata

import dartpy as dart
import numpy as np

import drag


def measure():
    version = importlib.metadata.version("dartpy")
    yield from drag.measure("dart", version, "ball", "point", one)


def one(slide, spin):
    world = dart.simulation.World()
    world.setGravity([0, 0, -drag.GRAVITY])
    world.setTimeStep(drag.DT)

    def skeleton(name, shape, joint):
        made = dart.dynamics.Skeleton(name)
        body = (made.createFreeJointAndBodyNodePair if joint else made.createWeldJointAndBodyNodePair)()[1]
        node = body.createShapeNode(shape)
        node.createCollisionAspect()
        node.createDynamicsAspect().setFrictionCoeff(drag.MU)
        world.addSkeleton(made)
        return made, body

    ground, _ = skeleton("ground", dart.dynamics.BoxShape([1, 1, 0.2]), False)
    pose = dart.math.Isometry3()
    pose.set_translation([0, 0, -0.1])
    ground.getJoint(0).setTransformFromParentBodyNode(pose)
    finger, body = skeleton("finger", dart.dynamics.SphereShape(drag.BALL_RADIUS), True)
    inertia = dart.dynamics.Inertia(drag.MASS, np.zeros(3), np.eye(3) * drag.INERTIA)
    body.setInertia(inertia)
    finger.setPositions([0, 0, 0, 0, 0, drag.BALL_RADIUS])

    def set_motion(v, w):
        finger.setPositions([0, 0, 0, 0, 0, finger.getPositions()[5]])
        finger.setVelocities([0, 0, w, v, 0, finger.getVelocities()[5]])

    def motion():
        w, v = body.getAngularVelocity(), body.getLinearVelocity()
        return v[0], v[2], w[2]

    return drag.drag_free_body(set_motion, world.step, motion, slide, spin)
