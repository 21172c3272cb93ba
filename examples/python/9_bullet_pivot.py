# SPDX-License-Identifier: MIT
"""The paper's experiment inside Bullet (PyBullet): the block, the grip and the fingers of `8_mujoco_pivot.py`, another engine's normal forces.

Bullet's contacts have no friction. Before each step the two `SoftFinger`s get the contact's place, turn and normal force, and the wrench
that they give is applied to the block with `applyExternalForce` and `applyExternalTorque`, which act in the next step alone.
Every joint has a velocity motor at first, which must be switched off; joints and bodies have damping at first, which must be 0.
"""

import importlib
import time as clock
from types import SimpleNamespace
from typing import Any

import limitcurve as lc
import matplotlib.pyplot as plt
import numpy as np
import pybullet as p  # type: ignore[import-not-found]

scene = importlib.import_module("8_mujoco_pivot")
RADIUS = 0.008  # of the balls that press [m]


def press() -> int:
    """Two balls on slides along z, one joint each, as one body with a fixed base."""
    ball = p.createCollisionShape(p.GEOM_SPHERE, radius=RADIUS)
    far = scene.HALF + RADIUS
    nothing = [-1, -1]
    fingers: int = p.createMultiBody(
        0, linkMasses=[0.02, 0.02], linkCollisionShapeIndices=[ball, ball], linkVisualShapeIndices=nothing,
        linkPositions=[[0, 0, far], [0, 0, -far]], linkOrientations=[[0, 0, 0, 1]] * 2, linkInertialFramePositions=[[0, 0, 0]] * 2,
        linkInertialFrameOrientations=[[0, 0, 0, 1]] * 2, linkParentIndices=[0, 0], linkJointTypes=[p.JOINT_PRISMATIC] * 2,
        linkJointAxis=[[0, 0, -1], [0, 0, 1]])
    for link in range(2):
        p.setJointMotorControl2(fingers, link, p.VELOCITY_CONTROL, force=0)  # switches the motor off that every joint has at first
    return fingers


def simulate(fingers: Any) -> dict[str, Any]:
    p.connect(p.DIRECT)
    p.setPhysicsEngineParameter(fixedTimeStep=scene.DT, numSubSteps=1, numSolverIterations=200, solverResidualThreshold=0)
    box = p.createCollisionShape(p.GEOM_BOX, halfExtents=[size / 2 for size in scene.SIZE])
    block, balls = p.createMultiBody(scene.MASS, box, basePosition=[-scene.OFFSET, 0, 0]), press()
    for body, link in ((block, -1), (balls, 0), (balls, 1)):
        p.changeDynamics(body, link, lateralFriction=0, rollingFriction=0, spinningFriction=0, linearDamping=0, angularDamping=0,
                         jointDamping=0, activationState=p.ACTIVATION_STATE_DISABLE_SLEEPING)
    inertia = np.array(p.getDynamicsInfo(block, -1)[2])

    def step(grip: float) -> list[float]:
        """One step; the normal forces of the two contacts [N]."""
        for link in range(2):
            p.setJointMotorControl2(balls, link, p.TORQUE_CONTROL, force=grip)
        p.stepSimulation()
        return [sum(contact[9] for contact in p.getContactPoints(balls, block, link, -1)) for link in range(2)]

    for _ in range(500):  # the fingers close before there is gravity
        loads = step(scene.GRIP_LOAD[0])
    p.setGravity(0, -scene.WEIGHT / scene.MASS, 0)

    angle, rows = 0.0, []
    began = clock.perf_counter()
    for i in range(round(scene.DURATION / scene.DT)):
        place, orientation = p.getBasePositionAndOrientation(block)
        velocity, spin = map(np.array, p.getBaseVelocity(block))
        turn = np.array(p.getMatrixFromQuaternion(orientation)).reshape(3, 3)
        own_spin = turn.T @ spin
        # What `Fingers.apply` reads of MuJoCo's data, under MuJoCo's names: places and turns of ground, block and balls, the block's velocity.
        data = SimpleNamespace(xpos=np.array([np.zeros(3), place, *(link[0] for link in p.getLinkStates(balls, [0, 1]))]), xfrc_applied=np.zeros((2, 6)),
                               xmat=np.array([np.eye(3).ravel(), turn.ravel()]), qvel=np.array([*velocity, *own_spin]))
        fingers.apply(data, loads)
        p.applyExternalForce(block, -1, data.xfrc_applied[1, :3], place, p.WORLD_FRAME)
        p.applyExternalTorque(block, -1, data.xfrc_applied[1, 3:], p.WORLD_FRAME)
        energy = (scene.MASS * velocity @ velocity + own_spin @ (inertia * own_spin)) / 2 + scene.WEIGHT * place[1] + fingers.spring_energy()
        off_plane = abs(place[2]) + scene.HALF * np.hypot(turn[0, 2], turn[1, 2])
        rows.append((i * scene.DT, angle, *place[:2], off_plane, energy, sum(loads) / 2))
        loads = step(float(np.interp(i * scene.DT, scene.GRIP_TIME, scene.GRIP_LOAD)))
        angle += float(turn[:, 2] @ p.getBaseVelocity(block)[1]) * scene.DT
    cost = (clock.perf_counter() - began) / len(rows)
    p.disconnect()
    return dict(zip(("time", "angle", "x", "y", "off_plane", "energy", "load"), np.array(rows).T)) | {"cost": cost}


def main() -> None:
    ours = simulate(scene.Fingers(lc.Table("hertz", tolerance=1e-8), "closest-point"))
    grip = {"time": scene.GRIP_TIME, "load": scene.GRIP_LOAD}
    planar = lc.run("pivot", case="exact", material="sandpaper", grip=grip, duration=scene.DURATION, time_step=scene.DT)
    held = round(scene.GRIP_TIME[1] / scene.DT)
    gain = float((ours["energy"] - np.minimum.accumulate(ours["energy"])).max())
    apart = np.degrees(np.abs(ours["angle"] - planar["angle"][: len(ours["angle"])])).max()
    begins = ours["time"][(np.degrees(np.abs(ours["angle"] - ours["angle"][held])) > 1).argmax()]
    print(f"begins to turn at {begins:.2f} s, turned {np.degrees(ours['angle'][-1]):.1f} deg, never further than {apart:.3f} deg from pivot; "
          f"creep held {np.degrees(ours['angle'][held]):.1e} deg/s, energy gained {gain:.1e} J, off plane {ours['off_plane'].max():.1e} m, "
          f"load {ours['load'].min():.3f} to {ours['load'].max():.3f} N, {1e6 * ours['cost']:.0f} us a step")
    assert apart < 0.2 and gain < 1e-9 and ours["off_plane"].max() < 1e-7
    assert abs(ours["angle"][held]) < 1e-6  # held, it does not creep
    figure, axes = plt.subplots(layout="constrained")
    axes.plot(planar["time"][::20], np.degrees(planar["angle"][::20]), label="pivot, exact curve")
    axes.plot(ours["time"][::20], np.degrees(ours["angle"][::20]), "--", label="Bullet, friction by two SoftFingers")
    axes.set(xlabel="time [s]", ylabel="turn of the block [deg]", title="A block between two soft fingers whose grip eases")
    axes.legend(frameon=False)
    figure.savefig("9_bullet_pivot.svg")


if __name__ == "__main__":
    main()
