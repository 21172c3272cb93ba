# SPDX-License-Identifier: MIT
"""data/engines/cors.csv: a ball in MuJoCo (Hertz, mu = 0.8, a = 5 mm, 3 N) is pushed slowly. numbers: those of
`limitcurve translate`, or of `tangent_ellipse`; lever: moment over force of friction [a]; error: the distance of the
centre of rotation over the exact, less 1."""

import csv
import sys

import limitcurve as lc
import mujoco
import numpy as np

MU, A, LOAD = 0.8, 0.005, 3


def pushed(table, lever, follows):
    """Relative errors of the gauge and of the centre of rotation, and the lever of friction [a], where the push has
    `lever`."""
    wrench = np.zeros(6)
    typed = f'condim="4" priority="1" friction="{MU} {MU * A * table.moment_ratio} 0"'
    model = mujoco.MjModel.from_xml_string(
        f"""<mujoco><option timestep="0.001" gravity="0 0 -10" cone="elliptic" impratio="100" tolerance="1e-14"/>
      <worldbody><geom type="plane" size="0 0 1"/><body pos="0 0 0.02"><joint type="slide" axis="0 0 1" damping="20"/>
      <joint type="slide" axis="1 0 0" damping="100"/><joint type="hinge" axis="0 0 1" damping="{100 * A * A}"/>
      <geom type="sphere" size="0.02" mass="{LOAD / 10}" {typed}/></body></worldbody></mujoco>""")
    data, push = mujoco.MjData(model), np.array([1.0, lever * A]) / table.gauge(1.0, lever) * MU * LOAD
    for _ in range(2000):
        data.qfrc_applied[1:] = push * (1.05 if follows else 1.12)  # the ellipse is stronger
        mujoco.mj_step(model, data)
        mujoco.mj_contactForce(model, data, 0, wrench)
        force, moment, friction = np.hypot(*wrench[1:3]), abs(wrench[3]) / A, data.contact.friction[0]
        if follows:
            p, q = table.tangent_ellipse(force, moment, friction[0] / MU, friction[2] / (MU * A))
            model.geom_friction[1, :2] = MU * p, MU * A * q
    cors = np.geomspace(1e-3, 1e3, 100_001)
    on_ray = np.divide(*table.evaluate(cors))
    cor = np.exp(np.interp(np.log(force / moment), np.log(on_ray), np.log(cors)))
    return table.gauge(force, moment) / (MU * wrench[0]) - 1, abs(
        data.qvel[1] / data.qvel[2]) / A / cor - 1, moment / force


def main():
    table, writer = lc.Table("hertz", 1e-8), csv.writer(sys.stdout, lineterminator="\n")
    print("# Measured by studies/engines/push.py: " + " ".join(__doc__.split(": ", 1)[1].split()))
    writer.writerow(["engine", "version", "numbers", "lever", "error"])
    for numbers in ("typed", "touching"):
        for push in np.geomspace(0.05, 2.5, 18):
            _, error, lever = pushed(table, push, numbers == "touching")
            writer.writerow(["mujoco", mujoco.__version__, numbers, f"{lever:.4f}", f"{error:.2e}"])


if __name__ == "__main__":
    main()
