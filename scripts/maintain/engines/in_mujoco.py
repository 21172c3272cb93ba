# SPDX-License-Identifier: MIT
"""MuJoCo: both cones, and a disc."""

import mujoco
import numpy as np

import drag


def measure():
    given = drag.translated("mujoco")
    ball = f'condim="4" friction="{given["geom.friction[0]"]} {given["geom.friction[1]"]} 0"'
    elliptic = f'cone="elliptic" impratio="{given["option.impratio"]}"'
    disc = f'condim="3" friction="{drag.MU} 0 0"'
    for contact, model, geom, option, speed in (("ball", "ellipse", ball, elliptic, 0.01), ("ball", "diamond", ball, 'cone="pyramidal"', 0.1), ("disc", "points", disc, elliptic, 0.01)):
        yield from drag.measure("mujoco", mujoco.__version__, contact, model, lambda v, w, a=(contact, geom, option, speed): one(*a, v, w))


def one(contact, geom, option, speed, slide, spin):
    size = f'type="sphere" size="{drag.BALL_RADIUS}"' if contact == "ball" else f'type="cylinder" size="{drag.DISC_RADIUS} {drag.DISC_HEIGHT / 2}"'
    height = drag.BALL_RADIUS if contact == "ball" else drag.DISC_HEIGHT / 2
    # On a slide and a hinge so inert that friction does not slow them. Contacts are soft: slow slip meets viscous friction, fast slip lifts the finger.
    model = mujoco.MjModel.from_xml_string(f"""<mujoco><option timestep="0.0005" gravity="0 0 {-drag.GRAVITY}" tolerance="0" iterations="200" {option}/>
      <worldbody><geom type="plane" size="0 0 1" {geom}/><body pos="0 0 {height}"><joint type="slide" axis="0 0 1"/>
      <joint type="slide" axis="1 0 0" armature="1e6"/><joint type="hinge" axis="0 0 1" armature="1e3"/>
      <geom {size} mass="{drag.MASS}" {geom}/></body></worldbody></mujoco>""")
    data = mujoco.MjData(model)
    total, frame_force = np.zeros(3), np.zeros(6)
    for i in range(3000):
        # The disc stays where it began; the ball leaves no trace.
        data.qpos[1:] = 0
        data.qvel[1:] = np.array([slide, spin]) * speed / drag.SPEED
        mujoco.mj_forward(model, data)
        if i >= 2000:
            for k in range(data.ncon):
                mujoco.mj_contactForce(model, data, k, frame_force)
                frame = data.contact.frame[k].reshape(3, 3)
                force, place = frame.T @ frame_force[:3], data.contact.pos[k]
                moment = place[0] * force[1] - place[1] * force[0] + frame[0, 2] * frame_force[3]
                total += force[0], moment, frame_force[0]
        mujoco.mj_step(model, data)
    return tuple(total)
