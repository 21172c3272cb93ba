# SPDX-License-Identifier: MIT
"""MuJoCo: both cones, a disc, and what two fingers hold."""

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
    disc = f'type="cylinder" size="{drag.DISC_RADIUS} {drag.DISC_HEIGHT / 2}"'
    size = f'type="sphere" size="{drag.BALL_RADIUS}"' if contact == "ball" else disc
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


def scene(geom, option):
    """As MJCF; its first three numbers of qpos are the place of the body."""
    pad = f'<geom mass="{hold.PAD_MASS}" priority="1" {geom}/>'
    half, z = " ".join(map(str, hold.HALF)), hold.HALF[2] + hold.BALL
    slide = [f'<joint type="slide" axis="0 0 {way}" damping="{hold.SLOWED}"/>{pad}' for way in (-1, 1)]
    return f"""<mujoco><option timestep="0.001" gravity="0 0 0" {option}/><worldbody>
      <body><freejoint/><geom type="box" size="{half}" mass="{hold.MASS}"/></body>
      <body pos="0 0 {z}">{slide[0]}</body><body pos="0 0 {-z}">{slide[1]}</body></worldbody></mujoco>"""


def turn_and_height(qpos):
    return 2 * np.arctan2(qpos[..., 6], qpos[..., 3]), qpos[..., 1]


def gripped(geom, option, offset):
    model = mujoco.MjModel.from_xml_string(scene(geom, option))
    data = mujoco.MjData(model)
    data.qpos[0], data.qfrc_applied[6:] = -offset, hold.GRIP

    def step(weight):
        data.xfrc_applied[1, 1] = -weight
        mujoco.mj_step(model, data)
        return turn_and_height(data.qpos)

    return step


def ball(*contact):
    mu_r = hold.typed(*contact, engine="mujoco")["geom.friction[1]"]
    return mu_r, f'type="sphere" size="{hold.BALL}" condim="4" friction="{hold.MU} {mu_r} 0"'


NOSLIP = 'noslip_iterations="3"'
PYRAMID = 'cone="pyramidal"'
ELLIPTIC = 'cone="elliptic" impratio="10"'
STIFF = 'cone="elliptic" impratio="1e4"'
# What a ball is measured with under each name of MuJoCo.
OPTIONS = {
    "ball, elliptic, impratio 10, noslip 3": f"{ELLIPTIC} {NOSLIP}",
    "ball, elliptic, impratio 10": ELLIPTIC,
    "ball, elliptic, impratio 1e4": STIFF,
    "ball, pyramid": PYRAMID,
    "ball, pyramid, impratio 10": f'{PYRAMID} impratio="10"',
}


def held_in_worlds(engine, version, step_of):
    """The rows of a relative of MuJoCo that steps many worlds at a time. `step_of(model, qpos, grip)` puts the worlds
    at the rows of qpos under the generalised forces `grip`, and returns a function of the forces and torques on the
    bodies that steps all worlds and returns their qpos."""
    geom, worlds = ball(*hold.DISC)[1], 26

    def gripped_in(model, offsets):
        qpos = np.tile(model.qpos0, (len(offsets), 1))
        qpos[:, 0] -= offsets
        step, force = step_of(model, qpos, np.array([0] * 6 + [hold.GRIP] * 2)), np.zeros((model.nbody, 6))

        def go_on(weight):
            force[1, 1] = -weight
            return turn_and_height(step(force))

        return go_on

    for setting, option in OPTIONS.items():
        model = mujoco.MjModel.from_xml_string(scene(geom, option))
        yield engine, version, setting, hold.DISC, lambda offsets, m=model: gripped_in(m, offsets), worlds


def held():
    patch = ("--patch", "rectangle:x=0.02,y=0.012")
    (_, disc), (mu_r, pad) = ball(*hold.DISC), ball(*patch)
    box, more = 'type="box" size="0.01 0.006 0.01"', f'{ELLIPTIC} noslip_iterations="200"'
    for setting, contact, geom, option in (
        *((setting, hold.DISC, disc, option) for setting, option in OPTIONS.items()),
        ("ball, pyramid, noslip 3", hold.DISC, disc, f"{PYRAMID} {NOSLIP}"),
        ("box 20x12 mm by one ball", patch, pad, f"{ELLIPTIC} {NOSLIP}"),
        ("box 20x12 mm, noslip 200, condim 4", patch, f'{box} condim="4" friction="{hold.MU} {mu_r} 0"', more),
        ("box 20x12 mm, noslip 200, condim 3", patch, f'{box} condim="3" friction="{hold.MU} 0 0"', more),
        ("disc of radius m0 a, noslip 200, condim 3", patch,
         f'type="cylinder" size="{mu_r / hold.MU} 0.01" condim="3" friction="{hold.MU} 0 0"', more),
    ):
        yield "mujoco", mujoco.__version__, setting, contact, lambda offset, a=(geom, option): gripped(*a, offset), 1
