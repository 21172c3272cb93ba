# SPDX-License-Identifier: MIT
"""data/engines/holds.csv: does it hold? Two fingers grip a body of 0.5 kg by 15 N each, mu = 0.9, beside its centre. The greatest offset at which
it turns by less than 2 degrees in 1 s, and its turn in 1 s at half of what `hold` allows, with the numbers of `limitcurve translate`."""

import csv
import sys

import limitcurve as lc
import mujoco
import numpy as np

MU, GRIP, MASS = 0.9, 15.0, 0.5
A = 0.01
DISC, PAD = f"constant:a={A}", "rectangle:x=0.02,y=0.012"


def turned(geom, option, offset, seconds=1.0):
    """Degrees; 90 where the body falls."""
    pad = f'<geom mass="0.05" priority="1" {geom}/>'
    model = mujoco.MjModel.from_xml_string(f"""<mujoco><option timestep="0.001" gravity="0 -9.81 0" {option}/><worldbody>
      <body pos="{-offset} 0 0"><freejoint/><geom type="box" size="0.15 0.04 0.02" mass="{MASS}"/></body>
      <body pos="0 0 0.03"><joint type="slide" axis="0 0 -1" damping="5"/>{pad}</body>
      <body pos="0 0 -0.03"><joint type="slide" axis="0 0 1" damping="5"/>{pad}</body></worldbody></mujoco>""")
    data = mujoco.MjData(model)
    data.qfrc_applied[6:] = GRIP
    for i in range(1000):
        model.opt.gravity[1] = -9.81 * min(max(i - 300, 0) / 600, 1)
        mujoco.mj_step(model, data)
    angle = lambda: 2 * np.arctan2(data.qpos[6], data.qpos[3])  # noqa: E731
    began, height = angle(), data.qpos[1]
    mujoco.mj_step(model, data, round(seconds * 1000))
    return 90.0 if height - data.qpos[1] > 0.03 or height < -0.03 else float(np.degrees(abs(angle() - began)))


def greatest(geom, option):
    """The greatest offset [m] that holds, to 0.2 mm."""
    low, high = 0.0, 0.12
    while high - low > 2e-4:
        middle = (low + high) / 2
        low, high = (middle, high) if turned(geom, option, middle) < 2 else (low, middle)
    return low


def allowed(load_to_hold):
    """The offset [m] that the grip just holds."""
    low, high = 0.0, 0.3
    while high - low > 1e-6:
        middle = (low + high) / 2
        low, high = (middle, high) if load_to_hold(MASS * 9.81 / 2, MASS * 9.81 / 2 * middle) < GRIP else (low, middle)
    return low


def main():
    table = lc.Table("hertz", 1e-8)
    disc = allowed(lambda force, moment: table.load_to_hold(force, moment, mu=MU, radius_law=DISC))
    patch = lc.Patch(PAD)
    pad = allowed(lambda force, moment: patch.load_to_hold(force, 0.0, moment, mu=MU))
    typed = {p: v for p, v, m in zip(*(lc.translate("hertz", DISC, mu=MU, load=GRIP, engine="mujoco")[k] for k in ("parameter", "value", "model"))) if m == "ellipse"}
    of_pad = dict(zip(*(lc.translate(patch=PAD, mu=MU, engine="mujoco")[k] for k in ("parameter", "value"))))
    ball = f'type="sphere" size="0.01" condim="4" friction="{MU} {typed["geom.friction[1]"]} 0"'
    small = f'type="sphere" size="0.01" condim="4" friction="{MU} {of_pad["geom.friction[1]"]} 0"'
    box = 'type="box" size="0.01 0.006 0.01"'
    elliptic = 'cone="elliptic" impratio="10"'
    noslip, more = elliptic + ' noslip_iterations="3"', elliptic + ' noslip_iterations="200"'
    writer = csv.writer(sys.stdout, lineterminator="\n")
    print("# Measured by scripts/maintain/engines/hold.py: " + " ".join(__doc__.split(": ", 1)[1].split()))
    writer.writerow(["engine", "version", "setting", "hold", "greatest_offset", "turned_at_half"])
    for setting, limit, geom, option in (
        ("ball as typed", disc, ball, noslip), ("ball without noslip", disc, ball, elliptic),
        ("ball without noslip, impratio 1e4", disc, ball, 'cone="elliptic" impratio="1e4"'),
        ("ball, pyramid", disc, ball, 'cone="pyramidal"'), ("ball, pyramid and noslip", disc, ball, 'cone="pyramidal" noslip_iterations="3"'),
        ("box pad 20 x 12 mm by one ball", pad, small, noslip),
        ("box pad 20 x 12 mm, noslip 200, condim 4", pad, f'{box} condim="4" friction="{MU} {of_pad["geom.friction[1]"]} 0"', more),
        ("box pad 20 x 12 mm, noslip 200, condim 3", pad, f'{box} condim="3" friction="{MU} 0 0"', more),
        ("disc of radius m0 a, noslip 200, condim 3", pad, f'type="cylinder" size="{of_pad["geom.friction[1]"] / MU} 0.01" condim="3" friction="{MU} 0 0"', more),
    ):
        writer.writerow(["mujoco", mujoco.__version__, setting, f"{limit:.4f}", f"{greatest(geom, option):.4f}", f"{turned(geom, option, limit / 2):.3f}"])
        sys.stdout.flush()


if __name__ == "__main__":
    main()
