# SPDX-License-Identifier: MIT
"""What all engines share: the contact, the twists, the free body that is dragged, and the comparison with the exact
curve.

A finger of mu = 0.8 is pressed by 3 N on a plane and dragged about imposed centres of rotation, from pure slide to pure
twist. Two of them: a ball with one contact point, given the coefficients of `limitcurve translate` for a Hertz contact
of a = 5 mm; and a flat disc of 50 mm, for which engines make several contact points and friction is mu alone: the exact
curve is then the uniform law's.
"""

import csv
import io
import math
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
MU, RADIUS, LOAD, GRAVITY = 0.8, 0.005, 3.0, 10.0
DISC_RADIUS, DISC_HEIGHT, BALL_RADIUS = 0.05, 0.001, 0.02
MASS, INERTIA = LOAD / GRAVITY, 1e-4
SPEED, DT, STEPS = 0.3, 2.5e-4, 2000


def limitcurve(*words):
    executable = os.environ.get("LIMITCURVE", ROOT / "build/ci/cli/limitcurve")
    text = subprocess.run([executable, *map(str, words)], check=True, capture_output=True, text=True).stdout
    return list(csv.DictReader(io.StringIO(text)))


def moment_ratio(law):
    return float(limitcurve("eval", "--law", law, "--c", 0)[0]["moment"])


M0 = moment_ratio("hertz")


def translated(engine):
    rows = limitcurve("translate", "--law", "hertz", "--radius-law", f"constant:a={RADIUS}", "--mu", MU, "--load", LOAD)
    return {
        row["parameter"]: float(row["value"])
        for row in rows
        if row["engine"] == engine and row["model"] != "diamond"
    }


def drag_free_body(set_motion, step, motion, slide, spin):
    """Force, moment and normal force that a free body of MASS and INERTIA meets, from the velocity that it loses in a
    step; `set_motion(v_x, w_z)` leaves its vertical velocity alone, `motion()` gives v_x, v_z, w_z. Mean of the last
    quarter of the steps."""
    force = moment = normal = 0.0
    for i in range(STEPS):
        set_motion(slide, spin)
        before = motion()[1]
        step()
        v_x, v_z, w_z = motion()
        if i >= 3 * STEPS // 4:
            force += MASS * (slide - v_x) / DT
            moment += INERTIA * (spin - w_z) / DT
            normal += MASS * ((v_z - before) / DT + GRAVITY)
    return force, moment, normal


def measure(engine, version, contact, model, drag, law=None, radius=None):
    """Rows of drag_pypi.csv. `drag(slide [m/s], spin [rad/s])` gives force [N], moment [N m], normal force [N], signs
    as they come."""
    law = law or {"ball": "hertz", "disc": "uniform"}[contact]
    radius = radius or {"ball": RADIUS, "disc": DISC_RADIUS}[contact]
    m0 = moment_ratio(law)
    steps = 16
    twists = [((1 - i / steps) * m0, i / steps) for i in range(steps + 1)]
    places = [slide / spin if spin else math.inf for slide, spin in twists]
    exact = limitcurve("eval", "--law", law, "--c", ",".join(map(str, places)))
    for (slide, spin), c, truth in zip(twists, places, exact):
        force, moment, normal = drag(SPEED * slide, SPEED * spin / radius)
        yield {
            "engine": engine,
            "version": version,
            "model": model,
            "c": f"{c:.6g}",
            "force": f"{abs(force) / (MU * normal):.6f}",
            "moment": f"{abs(moment) / (m0 * MU * normal * radius):.6f}",
            "exact_force": f"{float(truth['force']):.6f}",
            "exact_moment": f"{float(truth['moment']) / m0:.6f}",
            "law": law,
            "contact": contact,
        }


def errors(rows):
    """(largest radial error against the exact curve, largest distance of the wrenches at one centre of rotation), in
    the normalised plane."""
    curve = limitcurve("curve", "--law", rows[0]["law"], "--points", 2001)
    polar = sorted((math.atan2(float(r["y"]), float(r["x"])), math.hypot(float(r["x"]), float(r["y"]))) for r in curve)
    radial = apart = 0.0
    for row in rows:
        x, y, e_x, e_y = (float(row[name]) for name in ("force", "moment", "exact_force", "exact_moment"))
        nearest = min(polar, key=lambda place: abs(place[0] - math.atan2(y, x)))[1]
        radial = max(radial, abs(math.hypot(x, y) / nearest - 1))
        apart = max(apart, math.hypot(x - e_x, y - e_y))
    return radial, apart
