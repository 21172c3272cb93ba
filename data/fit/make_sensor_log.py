#!/usr/bin/python3
"""A synthetic force-torque sensor log of a soft finger, with known truth, and the input of fits from it.

    make_sensor_log.py            write the CSV files beside this script
    make_sensor_log.py --check    compare them with the files instead; exit 1 if one differs

A silicone finger presses on a plate at 40 loads in turn. Each trial lasts one second: the finger is dragged and twisted
about its own centre of rotation, sticks while force and moment grow, then slips on the exact Hertz limit curve. The
sensor has Gaussian noise and a resolution; an encoder on the plate gives slide and twist. A sample is a slip if the
encoder moves, which is sometimes wrong near the onset, as in reality: those samples lie inside the limit curve.

wrench_log.csv is what a force-torque sensor alone gives, as `rostopic echo -p` writes it: pushes of the same kind by a
finger of constant radius, the load along -z of the sensor, rows of the empty gripper between the pushes.

Standard library only; the seed is below. Numbers are rounded to the sensor's resolution, so that every machine writes
the same bytes.
"""

import argparse
import math
import random
import sys
from pathlib import Path

FOLDER = Path(__file__).parent
SEED = 20060325
RATE = 50  # samples a second and a trial
TRIALS = 40

# The truth: Hertz pressure, a = C P^GAMMA.
MU = 0.75
C = 0.004353
GAMMA = 0.2569
MOMENT_RATIO = 3 * math.pi / 16

# The sensor: standard deviation and step of each channel.
LOAD_NOISE, LOAD_STEP = 0.01, 0.002  # [N]
FORCE_NOISE, FORCE_STEP = 0.02, 0.005  # [N]
MOMENT_NOISE, MOMENT_STEP = 1.0e-4, 2.0e-5  # [N m]
SLIDE_NOISE, SLIDE_STEP = 5.0e-6, 1.0e-6  # [m]
TWIST_NOISE, TWIST_STEP = 1.0e-3, 2.0e-4  # [rad]


def hertz(s):
    """Unit wrench (f, m) at s = c/a."""
    if s <= 1:
        return 3 * math.pi / 8 * s * (1 - s * s / 4), 3 * math.pi / 16 * (1 - s * s + 0.375 * s**4)
    if s > 30:
        # The closed form cancels; two terms of the series in 1/s: <rho^2> = 2/5, <rho^4> = 8/35.
        return 1 - 0.1 / s**2, 0.2 / s + 0.0142857142857 / s**3
    a, t = math.asin(1 / s), math.sqrt(s * s - 1)
    force = 3 / (16 * s) * (s * s * (4 - s * s) * a + (s * s + 2) * t)
    moment = 3 / 64 * ((8 - 8 * s * s + 3 * s**4) * a + 3 * (2 - s * s) * t)
    return force, moment


def radius(load):
    return C * load**GAMMA


def rounded(value, step):
    digits = max(0, math.ceil(-math.log10(step)))
    return f"{round(value / step) * step:.{digits}f}"


def trials(noise):
    """Rows time, load, force, moment, slide, twist of the log, as measured."""
    rows = []
    for trial in range(TRIALS):
        load = 1.0 * 12.0 ** (trial / (TRIALS - 1))
        # Spread over the curve, in an order that mixes loads and centres of rotation.
        spin = ((trial * 17) % TRIALS + 0.5) / TRIALS
        s = (1 - spin) / spin * MOMENT_RATIO
        force, moment = hertz(s)
        limit_force, limit_moment = MU * load * force, MU * load * radius(load) * moment
        onset = 0.45 + 0.1 * noise.random()
        speed = 0.004  # of the contact's rim or centre, whichever is faster [m/s]
        slide_speed = speed * min(1.0, s)
        twist_speed = speed * min(1.0, 1 / s) / radius(load)
        for k in range(RATE):
            time = k / RATE
            grip = min(time / onset, 1.0)
            moving = max(time - onset, 0.0)
            rows.append((trial + time,
                         load + noise.gauss(0, LOAD_NOISE),
                         limit_force * grip + noise.gauss(0, FORCE_NOISE),
                         limit_moment * grip + noise.gauss(0, MOMENT_NOISE),
                         slide_speed * moving + noise.gauss(0, SLIDE_NOISE),
                         twist_speed * moving + noise.gauss(0, TWIST_NOISE)))
    return rows


def slips(rows):
    """The samples between which slide or twist moved clearly more than the encoder's noise."""
    chosen = []
    for before, here in zip(rows, rows[1:]):
        if int(before[0]) != int(here[0]):
            continue
        moved = max(
            abs(here[4] - before[4]) / (SLIDE_NOISE * math.sqrt(2)),
            abs(here[5] - before[5]) / (TWIST_NOISE * math.sqrt(2)))
        if moved > 3.0:
            chosen.append(here)
    return chosen


def wrench_log(noise):
    """24 pushes of 1 s, 0.3 s of the empty gripper before each; force and moment grow for half a second, then the
    finger slips."""
    rate, pushes, mu, mu_r, height = 50, 24, 0.6, 0.00212, 0.03
    names = [f"field.wrench.{part}.{axis}" for part in ("force", "torque") for axis in "xyz"]
    lines = [
        f"# Synthetic, not measured: made by make_sensor_log.py from mu = {mu}, mu_r = {mu_r} m and the Hertz law.\n",
        ",".join(["%time", "field.header.seq", "field.header.stamp", "field.header.frame_id", *names]) + "\n"
    ]
    stamp = 1_700_000_000_000_000_000
    for push in range(pushes):
        full = 1.0 + 5.0 * push / (pushes - 1)
        spin = ((push * 7) % pushes + 0.5) / pushes
        unit_force, unit_moment = hertz((1 - spin) / spin * MOMENT_RATIO)
        direction = 2.4 * push
        for k in range(-15, rate):
            load, grip = (full, min(2.0 * k / rate, 1.0)) if k >= 0 else (-0.02, 0.0)
            force, moment = grip * mu * load * unit_force, (
                -1) ** push * grip * mu_r / MOMENT_RATIO * load * unit_moment
            fx, fy = force * math.cos(direction), force * math.sin(direction)
            wrench = [rounded(value + noise.gauss(0, 0.01), 0.001) for value in (fx, fy, -load)]
            wrench += [rounded(value + noise.gauss(0, 5e-5), 1e-5) for value in (-height * fy, height * fx, moment)]
            sequence = len(lines) - 2
            time = stamp + sequence * 20_000_000
            lines.append(f"{time},{sequence},{time},ft_sensor,{','.join(wrench)}\n")
    return "".join(lines)


def files():
    noise = random.Random(SEED)
    rows = trials(noise)
    out = {}
    head = "# Synthetic, not measured: made by make_sensor_log.py; the truth is in truth.csv.\n"
    log = [head, "time,load,force,moment,slide,twist\n"]
    for time, load, force, moment, slide, twist in rows:
        log.append(f"{time:.2f},{rounded(load, LOAD_STEP)},{rounded(force, FORCE_STEP)},{rounded(moment, MOMENT_STEP)},"
                   f"{rounded(slide, SLIDE_STEP)},{rounded(twist, TWIST_STEP)}\n")
    out["sensor_log.csv"] = "".join(log)

    # The error of the load moves both limits. A fit assumes exact loads, so the sigmas include this error, from rough
    # limits.
    sigma_force = math.hypot(FORCE_NOISE, 0.7 * LOAD_NOISE)
    table = [head, "load,force,moment,sigma_force,sigma_moment\n"]
    for _, load, force, moment, _, _ in slips(rows):
        sigma_moment = math.hypot(MOMENT_NOISE, 0.7 * 0.6 * 0.007 * LOAD_NOISE)
        table.append(f"{rounded(load, LOAD_STEP)},{rounded(force, FORCE_STEP)},{rounded(moment, MOMENT_STEP)},"
                     f"{sigma_force:.5f},{sigma_moment:.7f}\n")
    out["slips.csv"] = "".join(table)

    table = [head, "load,radius,sigma_radius\n"]
    for step in range(12):
        load = 0.5 * 1.4**step
        table.append(f"{load:.3f},{rounded(radius(load) + noise.gauss(0, 1e-4), 1e-6)},0.0001\n")
    out["radii.csv"] = "".join(table)

    out["truth.csv"] = head + ("parameter,value,unit\n"
                               f"mu,{MU},1\n"
                               f"mu_r,{MU * MOMENT_RATIO * C:.17g},m/N^gamma\n"
                               f"ratio,{MOMENT_RATIO * C:.17g},m/N^gamma\n"
                               f"c,{C},m/N^gamma\n"
                               f"gamma,{GAMMA},1\n")
    out["wrench_log.csv"] = wrench_log(noise)
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 when a file differs")
    check = parser.parse_args().check
    wrong = 0
    for name, text in files().items():
        path = FOLDER / name
        if not check:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            print(f"{path}: differs from what this script makes", file=sys.stderr)
            wrong = 1
    return wrong


if __name__ == "__main__":
    sys.exit(main())
