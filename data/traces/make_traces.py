#!/usr/bin/python3
"""Scripted finger motions for `limitcurve replay`: the CSV files beside this script, on a plane, and those in
../scenes, on other surfaces and on bodies that move.

    make_traces.py            write them
    make_traces.py --check    compare them with the files instead; exit 1 if one differs

The motions suit a contact with stiffness 1000 N/m, twist stiffness 0.036 N m/rad and friction near 0.6:
each presses, sticks, then slips. The script uses only additions, multiplications, divisions and square roots, which are
exact to the last bit, so that every machine writes the same bytes.
"""

import argparse
import math
import sys
from pathlib import Path

FOLDER = Path(__file__).parent
SAMPLES_PER_SECOND = 1000
FREE = 0.001  # height above the surface at which a finger starts and ends [m]


def blend(time, start, end):
    """Minimum-jerk rise from 0 to 1 between two times."""
    u = min(max((time - start) / (end - start), 0.0), 1.0)
    return u * u * u * (10 + u * (6 * u - 15))


def press_drag_release(time):
    z = FREE - (FREE + 0.003) * (blend(time, 0.05, 0.35) - blend(time, 1.15, 1.45))
    return 0.008 * blend(time, 0.4, 1.1), 0.0, z, 0.0


def press_twist_release(time):
    z = FREE - (FREE + 0.003) * (blend(time, 0.05, 0.35) - blend(time, 1.15, 1.45))
    return 0.0, 0.0, z, 0.8 * blend(time, 0.4, 1.1)


def slide_twist_load(time):
    # The load falls to a third and comes back while the finger slides along an arch and turns.
    dip = blend(time, 0.65, 0.85) - blend(time, 0.9, 1.1)
    z = FREE - (FREE + 0.003) * (blend(time, 0.05, 0.35) - blend(time, 1.2, 1.5)) + 0.002 * dip
    way = blend(time, 0.4, 1.15)
    return 0.008 * way, 0.008 * way * (1 - way), z, 0.8 * way


def constant_twist(time):
    # 20 mm/s and 4 rad/s, so c = 5 mm, after a linear ramp of speed that keeps this ratio: twist = x / c always.
    z = FREE - (FREE + 0.002) * blend(time, 0.0, 0.25)
    ramp_start, ramp_end, speed = 0.25, 0.35, 0.02
    if time <= ramp_start:
        x = 0.0
    elif time <= ramp_end:
        x = speed * (time - ramp_start) * (time - ramp_start) / (2 * (ramp_end - ramp_start))
    else:
        x = speed * (time - (ramp_start + ramp_end) / 2)
    return x, 0.0, z, x / 0.005


def around_a_ball(time):
    # A finger whose axis stays upright on the surface runs along a slanted arc of a ball of radius 50 mm, 2 mm deep.
    t = 0.6 * blend(time, 0.2, 0.8)
    along, up = 2 * t / (1 + t * t), (1 - t * t) / (1 + t * t)  # sine and cosine of the way's angle, 2 atan t
    depth = -0.001 + 0.003 * (blend(time, 0.0, 0.15) - blend(time, 0.85, 1.0))
    reach = 0.05 - depth
    # Turned by the same angle about (-0.6, 0.8, 0), which carries +z to the normal.
    return (0.8 * reach * along, 0.6 * reach * along, reach * up, *quaternion(-0.6 * t, 0.8 * t, 0.0))


def pinch(time):
    # Two fingers 3 mm deep in the faces z = 20 mm and z = -20 mm of a block carry it along x and turn it about z.
    way, t = 0.03 * blend(time, 0.2, 0.7), 0.2 * blend(time, 0.3, 0.8)
    turn = quaternion(0.0, 0.0, t)
    return way, 0.0, 0.017, *turn, way, 0.0, -0.017, *turn


def turntable(time):
    # A plate turns under a finger at rest, 5 mm beside its axis: the slip's centre of rotation is that axis.
    z = FREE - (FREE + 0.002) * blend(time, 0.0, 0.1)
    return 0.005, 0.0, z, 0.0, 0.0, 0.0, 0.0, *quaternion(0.0, 0.0, 0.6 * max(time - 0.1, 0.0))


def quaternion(x, y, z):
    """The unit quaternion along (1, x, y, z)."""
    length = math.sqrt(1 + x * x + y * y + z * z)
    return 1 / length, x / length, y / length, z / length


FINGER = "x,y,z,qw,qx,qy,qz"
PLANE = "x,y,z,twist"

TRACES = {
    "press_drag_release.csv": (press_drag_release, 1.55, PLANE),
    "press_twist_release.csv": (press_twist_release, 1.55, PLANE),
    "slide_twist_load.csv": (slide_twist_load, 1.6, PLANE),
    "constant_twist.csv": (constant_twist, 2.0, PLANE),
    "../scenes/around_a_ball.csv": (around_a_ball, 1.0, FINGER),
    "../scenes/pinch.csv": (pinch, 1.0, FINGER + ",x2,y2,z2,qw2,qx2,qy2,qz2"),
    "../scenes/turntable.csv": (turntable, 1.0, "x,y,z,twist,bx,by,bz,bqw,bqx,bqy,bqz"),
}


def trace_text(motion, duration, columns):
    lines = ["# A scripted motion, not a measurement; made by make_traces.py.\n", f"time,{columns}\n"]
    for sample in range(round(duration * SAMPLES_PER_SECOND) + 1):
        time = sample / SAMPLES_PER_SECOND
        # Picometres and picoradians: far below what matters, and no noise of rounding in the last digits.
        values = [round(value, 12) + 0.0 for value in motion(time)]
        lines.append(",".join(f"{value:.9g}" for value in (time, *values)) + "\n")
    return "".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="compare with the files instead of writing them")
    arguments = parser.parse_args()
    differing = []
    for name, (motion, duration, columns) in TRACES.items():
        path, text = FOLDER / name, trace_text(motion, duration, columns)
        if not arguments.check:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            differing.append(name)
    if differing:
        sys.exit(f"differs from what make_traces.py makes: {', '.join(differing)}")


if __name__ == "__main__":
    main()
