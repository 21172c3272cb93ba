#!/usr/bin/python3
"""A synthetic force-torque sensor log of a soft finger, with known truth, and the input of fits from it.

    make_sensor_log.py            write the CSV files beside this script
    make_sensor_log.py --check    compare them with the files instead; exit 1 if one differs

A silicone finger presses on a plate at 40 loads in turn. Each trial lasts one second: the finger is dragged and twisted
about its own centre of rotation, sticks while force and moment grow, then slips on the exact Hertz limit curve. The
sensor has Gaussian noise and a resolution; an encoder on the plate gives slide and twist. A sample is a slip if the
encoder moves, which is sometimes wrong near the onset, as in reality: those samples lie inside the limit curve.

wrench_log.csv is what a force-torque sensor behind a finger gives, as `rostopic echo -p` writes it, of a finger that is
no limit curve: a brush of bristles that stick until the friction of their own load, then slide; each is a spring beside
a Maxwell element, so that a hold relaxes. A gripper closes, drags, twists, holds, opens. The sensor sits 3 mm beside
the finger's axis, where each grip lands a little elsewhere; it has an offset, drift, noise and steps, and some rows
are blank.

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


# The finger of wrench_log.csv, and what it does.
BRISTLES = 120
BRUSH_MU, BRUSH_RADIUS = 0.6, 0.004  # [1], [m]
STIFFNESS, CREEP, RELAXATION = 5e3, 0.3, 0.3  # [N/m], share of it that relaxes, in [s]
BRUSH_RATE, GRIPS = 50, 32
AXES = [f"{part}.{axis}" for part in ("force", "torque") for axis in "xyz"]


def bristles():
    """Places in the unit disc, of equal areas, and shares of a Hertz load."""
    places = []
    for i in range(BRISTLES):
        rho = math.sqrt((i + 0.5) / BRISTLES)
        angle = math.pi * (3 - math.sqrt(5)) * i
        places.append((rho * math.cos(angle), rho * math.sin(angle), math.sqrt(1 - rho * rho)))
    total = sum(share for _, _, share in places)
    mid_x, mid_y = (sum(place[axis] * place[2] for place in places) / total for axis in (0, 1))
    return [(x - mid_x, y - mid_y, share / total) for x, y, share in places]


def brush(steps, dt):
    """Force x, y and moment of the finger for steps of load, velocity x, y and turning."""
    pad = bristles()
    stretch = [[0.0] * 4 for _ in pad]  # of the spring, x and y, and force of the Maxwell element, x and y
    k, forget = STIFFNESS / BRISTLES, math.exp(-dt / RELAXATION)
    for load, vx, vy, turning in steps:
        fx = fy = moment = 0.0
        for state, (x, y, share) in zip(stretch, pad):
            if load <= 0:
                state[:] = [0.0] * 4
                continue
            x, y = BRUSH_RADIUS * x, BRUSH_RADIUS * y
            for axis, move in ((0, (vx - turning * y) * dt), (1, (vy + turning * x) * dt)):
                state[axis] += move
                state[2 + axis] = state[2 + axis] * forget + CREEP * k * move
            force = [(1 - CREEP) * k * state[axis] + state[2 + axis] for axis in (0, 1)]
            size, limit = math.hypot(*force), BRUSH_MU * load * share
            if size > limit:
                for axis in (0, 1):
                    back = force[axis] * (limit / size - 1)
                    state[axis] += back / k
                    state[2 + axis] += CREEP * back
                    force[axis] += back
            fx, fy, moment = fx + force[0], fy + force[1], moment + x * force[1] - y * force[0]
        yield fx, fy, moment


def grips(noise):
    """Steps of load, velocity x, y, turning and the number of the grip: slides, twists, both, and holds."""
    rows = []
    for grip in range(GRIPS):
        load = 1.5 + 4.5 * (grip * 13 % GRIPS) / (GRIPS - 1)
        way = 2.4 * grip
        speed, turning = 0.004, (-1)**(grip // 4) * 1.2
        kind = ("slide", "twist", "both", "hold")[grip % 4]
        vx, vy = speed * math.cos(way), speed * math.sin(way)
        motion = {"slide": (vx, vy, 0), "twist": (0, 0, turning), "both": (0.7 * vx, 0.7 * vy, turning)}.get(kind)
        full = motion or tuple(noise.uniform(0.1, 0.3) * part for part in (vx, vy, turning))
        rest = (0, 0, 0)
        before = 0.0
        for seconds, after, moves in ((0.5, 0, rest), (0.3, load, rest), (1.0 if motion else 0.3, load, full),
                                      (0.5, load, rest), (0.3, 0, rest)):
            count = round(seconds * BRUSH_RATE)
            rows += [(before + (after - before) * (i + 1) / count, *moves, grip) for i in range(count)]
            before = after
    return rows


def wrench_log(noise):
    names = ["field.wrench." + axis for axis in AXES]
    lever = sum(share * math.hypot(x, y) for x, y, share in bristles())
    truth = f"mu = {BRUSH_MU}, mu_r = {BRUSH_MU * BRUSH_RADIUS * lever:.6g} m"
    lines = [
        f"# Synthetic, not measured: made by make_sensor_log.py, a brush under a Hertz load with {truth}.\n",
        ",".join(["%time", "field.header.seq", "field.header.stamp", "field.header.frame_id", *names]) + "\n"
    ]
    stamp = 1_700_000_000_000_000_000
    rows = grips(noise)
    places = [(0.0024 + noise.gauss(0, 1e-3), -0.0018 + noise.gauss(0, 1e-3), 0.03) for _ in range(GRIPS)]
    offset = [noise.uniform(-0.1, 0.1) for _ in range(3)] + [noise.uniform(-1e-3, 1e-3) for _ in range(3)]
    drift = [noise.uniform(-0.02, 0.02) for _ in range(3)] + [noise.uniform(-2e-4, 2e-4) for _ in range(3)]
    steps = brush([row[:4] for row in rows], 1 / BRUSH_RATE)
    for sequence, ((load, *_, grip), (fx, fy, moment)) in enumerate(zip(rows, steps)):
        x, y, z = places[grip]
        wrench = [fx, fy, -load, -y * load - z * fy, z * fx + x * load, x * fy - y * fx + moment]
        minutes = sequence / BRUSH_RATE / 60
        sigma = [0.006] * 3 + [3e-5] * 3
        wrench = [value + offset[i] + drift[i] * minutes + noise.gauss(0, sigma[i]) for i, value in enumerate(wrench)]
        cells = [rounded(value, 0.001 if i < 3 else 1e-5) for i, value in enumerate(wrench)]
        if noise.random() < 0.005:
            cells = [""] * 6
        time = stamp + sequence * 1_000_000_000 // BRUSH_RATE
        lines.append(f"{time},{sequence},{time},ft_sensor,{','.join(cells)}\n")
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
