# SPDX-License-Identifier: MIT
"""MuJoCo: both cones, a disc, and what two fingers hold."""

import importlib.metadata

import mujoco
import numpy as np

import drag
import hold


def measure():
    given = drag.translated("mujoco")
    ball = f'condim="4" friction="{given["geom.friction[0]"]} {given["geom.friction[1]"]} 0"'
    elliptic = f'cone="elliptic" impratio="{given["option.impratio"]}"'
    disc = f'condim="3" friction="{drag.MU} 0 0"'
    for contact, model, geom, option, speed in (("ball", "ellipse", ball, elliptic, 0.01), ("ball", "diamond", ball,
                                                                                            'cone="pyramidal"', 0.1),
                                                ("disc", "points", disc, elliptic, 0.01)):
        yield from drag.measure("mujoco",
                                mujoco.__version__,
                                contact,
                                model,
                                lambda v, w, a=(contact, geom, option, speed): one(*a, v, w))


def one(contact, geom, option, speed, slide, spin):
    size = f'type="sphere" size="{drag.BALL_RADIUS}"' if contact == "ball" else f'type="cylinder" size="{drag.DISC_RADIUS} {drag.DISC_HEIGHT / 2}"'
    height = drag.BALL_RADIUS if contact == "ball" else drag.DISC_HEIGHT / 2
    # On a slide and a hinge so inert that friction does not slow them. Contacts are soft: slow slip meets viscous
    # friction, fast slip lifts the finger.
    model = mujoco.MjModel.from_xml_string(
        f"""<mujoco><option timestep="0.0005" gravity="0 0 {-drag.GRAVITY}" tolerance="0" iterations="200" {option}/>
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


def scene(geom, option, offset):
    """As MJCF."""
    pad = f'<geom mass="{hold.PAD_MASS}" priority="1" {geom}/>'
    half, z = " ".join(map(str, hold.HALF)), hold.HALF[2] + hold.BALL
    slide = [f'<joint type="slide" axis="0 0 {way}" damping="{hold.SLOWED}"/>{pad}' for way in (-1, 1)]
    return f"""<mujoco><option timestep="0.001" gravity="0 0 0" {option}/><worldbody>
      <body pos="{-offset} 0 0"><freejoint/><geom type="box" size="{half}" mass="{hold.MASS}"/></body>
      <body pos="0 0 {z}">{slide[0]}</body><body pos="0 0 {-z}">{slide[1]}</body></worldbody></mujoco>"""


def gripped(geom, option, offset):
    model = mujoco.MjModel.from_xml_string(scene(geom, option, offset))
    data = mujoco.MjData(model)
    data.qfrc_applied[6:] = hold.GRIP

    def step(weight):
        data.xfrc_applied[1, 1] = -weight
        mujoco.mj_step(model, data)
        return 2 * np.arctan2(data.qpos[6], data.qpos[3]), data.qpos[1]

    return step


def gripped_in_warp(geom, offset):
    import mujoco_warp

    model = mujoco.MjModel.from_xml_string(scene(geom, 'cone="elliptic" impratio="1e4"', offset))
    there, now = mujoco_warp.put_model(model), mujoco_warp.put_data(model, mujoco.MjData(model))
    now.qfrc_applied.assign([[0] * 6 + [hold.GRIP] * 2])

    def step(weight):
        now.xfrc_applied.assign([[[0] * 6, [0, -weight, 0, 0, 0, 0], [0] * 6, [0] * 6]])
        mujoco_warp.step(there, now)
        place = now.qpos.numpy()[0]
        return 2 * np.arctan2(place[6], place[3]), place[1]

    return step


def ball(*contact):
    mu_r = hold.typed(*contact, engine="mujoco")["geom.friction[1]"]
    return mu_r, f'type="sphere" size="{hold.BALL}" condim="4" friction="{hold.MU} {mu_r} 0"'


def held():
    patch = ("--patch", "rectangle:x=0.02,y=0.012")
    (_, disc), (mu_r, pad) = ball(*hold.DISC), ball(*patch)
    box, elliptic, pyramid = 'type="box" size="0.01 0.006 0.01"', 'cone="elliptic" impratio="10"', 'cone="pyramidal"'
    noslip, more = 'noslip_iterations="3"', f'{elliptic} noslip_iterations="200"'
    for setting, contact, geom, option in (
        ("ball as listed", hold.DISC, disc, f"{elliptic} {noslip}"),
        ("ball without noslip", hold.DISC, disc, elliptic),
        ("ball without noslip, impratio 1e4", hold.DISC, disc, 'cone="elliptic" impratio="1e4"'),
        ("ball, pyramid", hold.DISC, disc, pyramid),
        ("ball, pyramid and noslip", hold.DISC, disc, f"{pyramid} {noslip}"),
        ("box 20x12 mm by one ball", patch, pad, f"{elliptic} {noslip}"),
        ("box 20x12 mm, noslip 200, condim 4", patch, f'{box} condim="4" friction="{hold.MU} {mu_r} 0"', more),
        ("box 20x12 mm, noslip 200, condim 3", patch, f'{box} condim="3" friction="{hold.MU} 0 0"', more),
        ("disc of radius m0 a, noslip 200, condim 3", patch,
         f'type="cylinder" size="{mu_r / hold.MU} 0.01" condim="3" friction="{hold.MU} 0 0"', more),
    ):
        yield "mujoco", mujoco.__version__, setting, contact, lambda offset, a=(geom, option): gripped(*a, offset)
    yield "mujoco-warp", importlib.metadata.version(
        "mujoco-warp"), "ball, impratio 1e4", hold.DISC, lambda offset: gripped_in_warp(disc, offset)
