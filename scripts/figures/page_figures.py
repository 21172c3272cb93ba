#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the figures of docs/ that the report does not have.

usage: page_figures.py LIMITCURVE FOLDER, which gets (each also as .png)

textbook_forms.svg   where the closed forms of the textbooks lose their digits, in double, against
                     `limitcurve eval`. Truth is mpmath at 60 digits (python3-mpmath): the
                     hypergeometric forms, which cancel nowhere
human_fingers.svg    the load that holds a force and a torque, by `limitcurve hold`, for rayon
"""

import csv
import math
import subprocess
import sys
from pathlib import Path

import mpmath

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python" / "limitcurve"))

from report.chart_style import BLUE, FAINT, INK, ORANGE, VERMILION, Table, law_style, plt, save  # noqa: E402

DIGITS = 60
CORS = [10 ** (k / 24) for k in range(-2 * 24, 5 * 24 + 1)]


def uniform_textbook(s):
    """Moment of the uniform law as printed, with K and E in double."""
    with mpmath.workdps(16):
        square = min(s, 1 / s) ** 2
        first, second = float(mpmath.ellipk(square)), float(mpmath.ellipe(square))
    if s <= 1:
        return 4 / (9 * math.pi) * ((4 - 2 * s**2) * second + (s**2 - 1) * first)
    return 4 * s / (9 * math.pi) * ((4 - 2 * s**2) * second + (2 * s**2 - 5 + 3 / s**2) * first)


def hertz_textbook(s):
    """Moment of the Hertz law as printed."""
    if s <= 1:
        return 3 * math.pi / 16 * (1 - s**2 + 3 / 8 * s**4)
    angle, root = math.asin(1 / s), math.sqrt(s**2 - 1)
    return 3 / 64 * ((8 - 8 * s**2 + 3 * s**4) * angle + 3 * (2 - s**2) * root)


def power_truth(n, s):
    """Moment of p ∝ (1−ρ²)ⁿ by its hypergeometric forms."""
    s, n = mpmath.mpf(s), mpmath.mpf(n)
    if s <= 1:
        scale = mpmath.gamma(1.5) * mpmath.gamma(n + 2) / mpmath.gamma(n + 2.5)
        return scale * mpmath.hyp2f1(0.5, -n - 1.5, 1, s**2)
    return mpmath.hyp2f1(0.5, 0.5, n + 3, 1 / s**2) / (2 * (n + 2) * s)


LAWS = {"uniform": (0, uniform_textbook), "hertz": (0.5, hertz_textbook)}


def column(limitcurve, name, *arguments, **options):
    """A column of what the command line prints."""
    printed = subprocess.run([limitcurve, *arguments], check=True, capture_output=True, text=True, **options)
    return [float(row[name]) for row in csv.DictReader(printed.stdout.splitlines())]


def relative_error(value, truth):
    # An error below the last bit is drawn at the floor.
    return max(float(abs(value / truth - 1)), 2.0**-54)


def textbook_forms(limitcurve):
    mpmath.mp.dps = DIGITS
    cors = ",".join(map(repr, CORS))
    figure, axes = plt.subplots(figsize=(6.4, 3.4), layout="constrained")
    for law, (n, textbook) in LAWS.items():
        truth = [power_truth(n, s) for s in CORS]
        style = law_style(law)
        colour = style["color"]
        printed = [relative_error(textbook(s), m) for s, m in zip(CORS, truth)]
        axes.loglog(CORS, printed, linewidth=1.2, **style)
        ours = column(limitcurve, "moment", "eval", "--law", law, "--c", cors)
        axes.loglog(CORS, [relative_error(value, m) for value, m in zip(ours, truth)], color=colour, linewidth=1, alpha=0.9)
        last = next(i for i, error in enumerate(printed) if CORS[i] > 1 and error > (1e-6 if law == "hertz" else 1e-9))
        axes.annotate(f"{law}, as printed", (CORS[last], printed[last]), textcoords="offset points",
                      xytext=(-6, 2) if law == "hertz" else (18, -6), ha="right" if law == "hertz" else "left", color=colour)
    axes.axhline(1, color=FAINT, linewidth=0.8)
    axes.annotate("no digit left", (1e-2, 1), textcoords="offset points", xytext=(2, 4), color=FAINT)
    axes.annotate("limitcurve, both laws", (1e3, 1e-16), textcoords="offset points", xytext=(2, 6), color=INK)
    axes.set_ylim(2e-17, 30)
    axes.set_yticks([10.0**power for power in range(-16, 1, 4)])
    axes.minorticks_off()
    axes.set_xlabel("distance of the centre of rotation  s = c/a")
    axes.set_ylabel("relative error of the moment m")
    axes.set_title("The closed forms as printed lose every digit of the moment as s grows")
    return figure


def human_fingers(limitcurve):
    """Kinoshita and others (1997) measured fingers under such forces and torques."""
    rayon = Table.read(Path(__file__).resolve().parents[2] / "data" / "materials.csv").where(material="rayon")[0]
    mu, mu_r = rayon["mu"], rayon["mu_r"]
    torques = [0.05 * i / 30 for i in range(31)]
    figure, axes = plt.subplots(figsize=(6.4, 3.4), layout="constrained")
    for force in (0, 1.7, 3.4):
        wrenches = "force,moment\n" + "".join(f"{force},{torque!r}\n" for torque in torques)
        loads = column(limitcurve, "hold_load", "hold", "--law", "hertz", "--radius-law", f"constant:a={mu_r / mu * 16 / (3 * math.pi)!r}", "--mu", str(mu),
                       "--data", "-", input=wrenches)
        least, most = force / mu, 0.05 / mu_r
        axes.plot((0, 50), (least, least + most), color=ORANGE, linewidth=1, dashes=(5, 1.5), label="diamond")
        axes.plot((0, 1e3 * mu_r * least, 50), (least, least, most), color=VERMILION, linewidth=1, dashes=(1.5, 1.2), label="box")
        axes.plot([1e3 * torque for torque in torques], loads, color=BLUE, label="eq. (17), Hertz")
        axes.annotate(f"at {force:g} N", (50, loads[-1]), textcoords="offset points", xytext=(4, 0), va="bottom" if force else "top", color=BLUE,
                      annotation_clip=False)
    axes.legend(*[part[:3] for part in axes.get_legend_handles_labels()], loc="upper left")
    axes.set(title="Load at which rayon slips from a finger, by Table 1 [N]", xlabel="torque [N mm]", xlim=(0, 50), ylim=(0, 25))
    return figure


def main():
    limitcurve, folder = sys.argv[1:]
    for draw in (textbook_forms, human_fingers):
        save(draw(limitcurve), folder, draw.__name__)


if __name__ == "__main__":
    main()
