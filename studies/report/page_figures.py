#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the figures of docs/ that the report does not have.

usage: page_figures.py LIMITCURVE FOLDER, which gets (each also as .png)

when_a_table_pays.svg  the scatter of fingers (data/materials.csv) beside errors of models
cor_in_engine.svg      error of the centre of rotation in MuJoCo (data/engines/cors.csv)
log_*.svg              from a log to a grip (data/fit/wrench_log.csv)
groove.svg             a finger in a groove, and what is passed of its walls
human_fingers.svg      the load that holds a force and a torque, by `limitcurve hold`, for rayon
"""

import csv
import math
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from report.chart_style import BLUE, FAINT, INK, ORANGE, VERMILION, Table, plt, save  # noqa: E402


def column(limitcurve, name, *arguments, kind=float, **options):
    """A column of what the command line prints."""
    printed = subprocess.run([limitcurve, *arguments], check=True, capture_output=True, text=True, **options)
    return [kind(row[name]) for row in csv.DictReader(printed.stdout.splitlines())]


def human_fingers(limitcurve):
    """Kinoshita and others (1997) measured fingers under such forces and torques."""
    rayon = Table.read(Path(__file__).resolve().parents[2] / "data" / "materials.csv").where(material="rayon")[0]
    mu, mu_r = rayon["mu"], rayon["mu_r"]
    torques = [0.05 * i / 30 for i in range(31)]
    figure, axes = plt.subplots(figsize=(6.4, 3.4), layout="constrained")
    for force in (0, 1.7, 3.4):
        wrenches = "force,moment\n" + "".join(f"{force},{torque!r}\n" for torque in torques)
        loads = column(limitcurve,
                       "hold_load",
                       "hold",
                       "--law",
                       "hertz",
                       "--radius-law",
                       f"constant:a={mu_r / mu * 16 / (3 * math.pi)!r}",
                       "--mu",
                       str(mu),
                       "--data",
                       "-",
                       input=wrenches)
        least, most = force / mu, 0.05 / mu_r
        axes.plot((0, 50), (least, least + most), color=ORANGE, linewidth=1, dashes=(5, 1.5), label="diamond")
        axes.plot((0, 1e3 * mu_r * least, 50), (least, least, most),
                  color=VERMILION,
                  linewidth=1,
                  dashes=(1.5, 1.2),
                  label="box")
        axes.plot([1e3 * torque for torque in torques], loads, color=BLUE, label="eq. (17), Hertz")
        axes.annotate(f"at {force:g} N", (50, loads[-1]),
                      textcoords="offset points",
                      xytext=(4, 0),
                      va="bottom" if force else "top",
                      color=BLUE,
                      annotation_clip=False)
    axes.legend(*[part[:3] for part in axes.get_legend_handles_labels()], loc="upper left")
    axes.set(title="Load at which rayon slips from a finger, by Table 1 [N]",
             xlabel="torque [N mm]",
             xlim=(0, 50),
             ylim=(0, 25))
    return figure


def when_a_table_pays(limitcurve):
    materials = Table.read(Path(__file__).resolve().parents[2] / "data" / "materials.csv")
    laws, models = (column(limitcurve, name, "validate", kind=str) for name in ("law", "model"))
    errors = {
        name: [
            error
            for law, model, error in zip(laws, models, column(limitcurve, name, "validate"))
            if model == "ellipse" and law != "uniform-wear"
        ]
        for name in ("max_over_estimate", "max_cor_error")
    }  # uniform-wear: of no fingertip
    (m0, moment), (_, force) = (column(limitcurve, name, "eval", "--law", "hertz", "--c", "0,1")
                                for name in ("moment", "force"))
    radial = [
        math.hypot(1 / math.hypot(1, kappa * m0) - force, kappa * m0 / math.hypot(1, kappa * m0) - moment / m0)
        for kappa in (1, 10)
    ]
    bars = [("scatter of fingers, Table 1 (SD)", FAINT,
             [row[f"{name}_sd"] / row[name] for row in materials for name in ("mu", "mu_r")]),
            ("ellipse: load", BLUE, errors["max_over_estimate"]),
            ("ellipse: centre of rotation", VERMILION, errors["max_cor_error"]),
            ("radial projection, κ = 1 to 10", ORANGE, radial)]
    figure, axes = plt.subplots(figsize=(6.4, 1.9), layout="constrained")
    for name, colour, values in bars:
        axes.barh(name, 100 * (max(values) - min(values)), left=100 * min(values), height=0.5, color=colour)
    axes.set(title="Off by [%]", xlim=(0, 100))
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    return figure


def cor_in_engine(limitcurve):
    pushed = Table.read(Path(__file__).resolve().parents[2] / "data" / "engines" / "cors.csv")
    cors, forces, moments = (column(limitcurve, name, "curve", "--law", "hertz", "--points", "401")[1:-1]
                             for name in ("c", "force", "moment"))
    levers = [moment / force for moment, force in zip(moments, forces)]
    m0 = column(limitcurve, "moment", "eval", "--law", "hertz", "--c", "0")[0]
    figure, axes = plt.subplots(figsize=(6.4, 3.2), layout="constrained")
    axes.plot(levers, [100 * (m0 ** 2 / lever / cor - 1) for lever, cor in zip(levers, cors)],
              color=VERMILION,
              label="ellipse, by its equation")
    for numbers, colour, marker, label in (("typed", VERMILION, "o", "as entered"), ("touching", BLUE, "s",
                                                                                     "that follow the slip")):
        found = pushed.where(numbers=numbers)
        axes.plot(found.column("lever"),
                  found.column("error", 100),
                  marker,
                  color=colour,
                  markersize=5,
                  label=f"MuJoCo {found[0]['version']}, numbers {label}")
    axes.set(title="Error of the centre of rotation [%]",
             xlabel="lever of the friction over the contact radius, M/(F a)",
             xscale="log",
             xlim=(0.04, 3),
             ylim=(-40, 80))
    axes.set_xticks([0.05, 0.1, 0.2, 0.5, 1, 2], [0.05, 0.1, 0.2, 0.5, 1, 2])
    axes.legend()
    return figure


def groove(_):
    """A ball of radius 1, 0.3 deep in both walls of a groove of 120°; its walls have the normals (∓½, √¾)."""
    up = math.sqrt(0.75)
    centre, outside = (0, 0.7 / up), (0, 1 / up)
    figure, panels = plt.subplots(1, 2, figsize=(6.4, 2.5), layout="constrained")
    for axes, title in zip(panels, ("deepest wall: noise decides which", "joined: the centre, outside of moved walls")):
        axes.fill_between((-2, 0, 2), (1 / up, 0, 1 / up), -1, color=FAINT, alpha=0.4, linewidth=0)
        axes.add_patch(plt.Circle(centre, 1, fill=False, color=INK))
        axes.set(title=title, xlim=(-2, 2), ylim=(-0.4, 2), aspect="equal")
        axes.axis("off")
    for x in (-0.5, 0.5):
        panels[0].annotate("", (0.7 * x, centre[1] - 0.7 * up), (x, centre[1] - up),
                           arrowprops={"arrowstyle": "->", "color": VERMILION})
    panels[1].plot((-2, 0, 2), (2 / up, 1 / up, 2 / up), color=INK, linewidth=0.8, dashes=(5, 3))
    panels[1].annotate("", outside, centre, arrowprops={"arrowstyle": "->", "color": BLUE})
    panels[1].plot(*centre, "o", color=INK, markersize=3)
    return figure


SIX = [f"field.wrench.{name}" for name in ("force.x", "force.y", "force.z", "torque.x", "torque.y", "torque.z")]
# Of docs/measure_and_fit.md.
LOG = ("--law", "hertz", "--data", Path(__file__).resolve().parents[2] / "data" / "fit" / "wrench_log.csv",
       "--least-load", "0.5", "--zero", "--columns",
       f"load=-{SIX[2]},force={':'.join(SIX[:2])},moment={':'.join(SIX)}", "--quiet")


def wrench_log(limitcurve):
    """Fitted mu and mu_r, and force, moment, load and the load that holds of each loaded row."""
    fit = ("fit", "ratio", *LOG, "--loss", "edge")
    value = dict(zip(column(limitcurve, "parameter", *fit, kind=str), column(limitcurve, "value", *fit)))
    # With ten times the friction no margin is cut off at 0, and the load is a tenth of the load that holds over
    # 1 - margin.
    hold = ("hold", *LOG, "--mu", str(10 * value["mu"]), "--mu-r", str(10 * value["mu_r"]))
    force, moment, tenth, margin = (column(limitcurve, name, *hold)
                                    for name in ("force", "moment", "hold_load", "margin"))
    load = [least / (1 - left) for least, left in zip(tenth, margin)]
    return value, force, moment, load, [10 * least for least in tenth]


def log_fit(limitcurve):
    value, force, moment, load, _ = wrench_log(limitcurve)
    figure, axes = plt.subplots(figsize=(4.2, 3.6), layout="constrained")
    axes.plot([f / (value["mu"] * p) for f, p in zip(force, load)],
              [abs(m) / (value["mu_r"] * p) for m, p in zip(moment, load)],
              ".",
              color=INK,
              markersize=1.5,
              markevery=3,
              label="every third row of the log")
    axes.plot(column(limitcurve, "x", "curve", "--law", "hertz"),
              column(limitcurve, "y", "curve", "--law", "hertz"),
              color=BLUE,
              label="Hertz")
    axes.legend(loc="upper right")
    axes.set(title=f"Fit: mu = {value['mu']:.4f}, mu_r = {1e3 * value['mu_r']:.4f} mm",
             xlabel="force / (mu load)",
             ylabel="moment / (mu_r load)")
    return figure


def log_grip(limitcurve):
    *_, load, needed = wrench_log(limitcurve)
    time = [0.02 * i for i in range(len(needed))]
    figure, axes = plt.subplots(figsize=(6.4, 2.6), layout="constrained")
    axes.plot(time, load, color=INK, linewidth=0.8, label="load")
    axes.plot(time, needed, color=BLUE, linewidth=0.8, label="load that holds")
    axes.legend(loc="upper left", ncols=2)
    axes.set(title="Where the load that holds meets the load [N], the finger slips",
             xlabel="time of loaded rows [s]",
             xlim=(0, time[-1]),
             ylim=(0, 1.3 * max(load)))
    return figure


def main():
    limitcurve, folder = sys.argv[1:]
    for draw in (cor_in_engine, groove, human_fingers, log_fit, log_grip, when_a_table_pays):
        save(draw(limitcurve), folder, draw.__name__)


if __name__ == "__main__":
    main()
