# SPDX-License-Identifier: MIT
"""A block between two fingers of the plugin, which grip it beside its centre: it holds as `load_to_hold` says, and does
not creep.

    python demo.py LIBRARY.so
"""

import sys

import limitcurve as lc
import limitcurve.mujoco
import mujoco
import numpy as np

MU, RADIUS, MASS, OFFSET, HALF = 0.8, 0.005, 0.1, 0.005, 0.02  # [1], [m], [kg], [m], [m]
FORCE = MASS * 9.81 / 2  # of a finger


def scene(law: str = "hertz", keys: str = "") -> str:
    """The block, and two balls on slides along z; `keys` of the plugin beside its law, radius and mu."""
    config = (f'<config key="law" value="{law}"/><config key="radius_law" value="constant:a={RADIUS}"/><config '
              f'key="mu" value="{MU}"/>')
    ball = '<geom type="sphere" size=".008" mass=".02" condim="1" priority="1"/><plugin instance="skin"/>'
    return f"""<mujoco><option timestep=".001" gravity="0 -9.81 0"/><extension><plugin plugin="limitcurve.finger">
      <instance name="skin">{config}<config key="contacts" value="2"/>{keys}</instance></plugin></extension><worldbody>
      <body pos="{-OFFSET} 0 0"><freejoint/><geom type="box" size=".06 .02 {HALF}" mass="{MASS}"/></body>
      <body pos="0 0 {HALF + 0.008}"><joint type="slide" axis="0 0 -1"/>{ball}</body>
      <body pos="0 0 {-HALF - 0.008}"><joint type="slide" axis="0 0 1"/>{ball}</body></worldbody></mujoco>"""


def gripped(text: str, grip: float) -> "tuple[mujoco.MjModel, mujoco.MjData]":
    """The scene under a grip [N], after gravity has come slowly and the grip has eased to it."""
    model = mujoco.MjModel.from_xml_string(text)
    data, gravity = mujoco.MjData(model), model.opt.gravity.copy()
    for i in range(3500):
        model.opt.gravity[:] = gravity * min(max(i - 500, 0) / 1000, 1)
        data.qfrc_applied[6:] = grip * (1.6 - 0.6 * min(max(i - 2500, 0) / 1000, 1))
        mujoco.mj_step(model, data)
    return model, data


def moved(text: str, grip: float, seconds: float = 3.0) -> "tuple[float, float]":
    """Turn [rad] and way [m] of the block."""
    model, data = gripped(text, grip)
    start, angle = data.qpos[:2].copy(), 2 * np.arctan2(data.qpos[6], data.qpos[3])
    mujoco.mj_step(model, data, round(seconds / model.opt.timestep))
    return abs(2 * np.arctan2(data.qpos[6], data.qpos[3]) - angle), float(np.hypot(*(data.qpos[:2] - start)))


def main() -> None:
    limitcurve.mujoco.register(sys.argv[1])
    least = lc.Table("hertz", tolerance=1e-8).load_to_hold(FORCE,
                                                           FORCE * OFFSET,
                                                           mu=MU,
                                                           radius_law=f"constant:a={RADIUS}")
    for share in (0.99, 1.01, 1.5):
        turn, way = moved(scene(), share * least)
        print(
            f"grip {share:.2f} of the {least:.4f} N to hold: turned {np.degrees(turn):.1e} degrees, moved "
            f"{1e3 * way:.1e} mm in 3 s"
        )
        assert (turn > 0.05) if share < 1 else (turn < 1e-6 and way < 1e-8)


if __name__ == "__main__":
    main()
