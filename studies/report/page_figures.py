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

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from report.chart_style import BLUE, FAINT, INK, ORANGE, VERMILION, Table, note, plt, save  # noqa: E402
from report.command import Command, numbers  # noqa: E402
from report.csv_files import DATA  # noqa: E402


def human_fingers(command):
    """Kinoshita and others (1997) measured fingers under such forces and torques."""
    rayon = Table.read(DATA / "materials.csv").where(material="rayon")[0]
    mu, mu_r = rayon["mu"], rayon["mu_r"]
    torques = [0.05 * i / 30 for i in range(31)]
    finger = ("hold", "--law", "hertz", "--radius-law", f"constant:a={mu_r / mu * 16 / (3 * math.pi)!r}", "--mu", mu)
    figure, axes = plt.subplots(figsize=(6.4, 3.4))
    for force in (0, 1.7, 3.4):
        calls = [(*finger, "--force", force, "--moment", torque) for torque in torques]
        loads = [float(row["hold_load"]) for [row] in command.each(calls)]
        least, most = force / mu, 0.05 / mu_r
        axes.plot((0, 50), (least, least + most), color=ORANGE, linewidth=1, dashes=(5, 1.5), label="diamond")
        axes.plot((0, 1e3 * mu_r * least, 50), (least, least, most), color=VERMILION, linewidth=1, dashes=(1.5, 1.2),
                  label="box")
        axes.plot([1e3 * torque for torque in torques], loads, color=BLUE, label="eq. (17), Hertz")
        note(axes, f"at {force:g} N", (50, loads[-1]), (4, 0), va="bottom" if force else "top", color=BLUE, fontsize=9,
             annotation_clip=False)
    axes.legend(*[part[:3] for part in axes.get_legend_handles_labels()], loc="upper left")
    axes.set(title="Load at which rayon slips from a finger, by Table 1 [N]", xlabel="torque [N mm]", xlim=(0, 50),
             ylim=(0, 25))
    return figure


def when_a_table_pays(command):
    materials = Table.read(DATA / "materials.csv")
    ellipses = [row for row in command.rows("validate")
                if row["model"] == "ellipse" and row["law"] != "uniform-wear"]  # which is of no fingertip
    over, cor = zip(*numbers(ellipses, "max_over_estimate", "max_cor_error"))
    (_, m0), (force, moment) = numbers(command.rows("eval", "--law", "hertz", "--c", "0,1"), "force", "moment")
    radial = [
        math.hypot(1 / math.hypot(1, kappa * m0) - force, kappa * m0 / math.hypot(1, kappa * m0) - moment / m0)
        for kappa in (1, 10)
    ]
    bars = [("scatter of fingers, Table 1 (SD)", FAINT,
             [row[f"{name}_sd"] / row[name] for row in materials for name in ("mu", "mu_r")]),
            ("ellipse: load", BLUE, over),
            ("ellipse: centre of rotation", VERMILION, cor),
            ("radial projection, κ = 1 to 10", ORANGE, radial)]
    figure, axes = plt.subplots(figsize=(6.4, 1.9))
    for name, colour, values in bars:
        axes.barh(name, 100 * (max(values) - min(values)), left=100 * min(values), height=0.5, color=colour)
    axes.set(title="Off by [%]", xlim=(0, 100))
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    return figure


def cor_in_engine(command):
    pushed = Table.read(DATA / "engines" / "cors.csv")
    (_, _, m0), *curve = numbers(command.rows("curve", "--law", "hertz", "--points", 401)[:-1], "c", "force", "moment")
    levers = [moment / force for _, force, moment in curve]
    figure, axes = plt.subplots(figsize=(6.4, 3.2))
    axes.plot(levers, [100 * (m0 ** 2 / lever / cor - 1) for lever, (cor, _, _) in zip(levers, curve)],
              color=VERMILION, label="ellipse, by its equation")
    for typed, colour, marker, label in (("typed", VERMILION, "o", "as entered"),
                                         ("touching", BLUE, "s", "that follow the slip")):
        found = pushed.where(numbers=typed)
        axes.plot(found.column("lever"), found.column("error", 100), marker, color=colour, markersize=5,
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
    figure, panels = plt.subplots(1, 2, figsize=(6.4, 2.5))
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
LOG = ("--law", "hertz", "--data", DATA / "fit" / "wrench_log.csv", "--least-load", "0.5", "--zero", "--columns",
       f"load=-{SIX[2]},force={':'.join(SIX[:2])},moment={':'.join(SIX)}")


def wrench_log(command):
    """Fitted mu and mu_r, and force, moment, load and the load that holds of each loaded row."""
    value = {row["parameter"]: float(row["value"]) for row in command.rows("fit", "ratio", *LOG, "--loss", "edge")}
    # With ten times the friction no margin is cut off at 0, and the load is a tenth of the load that holds over
    # 1 - margin.
    hold = command.rows("hold", *LOG, "--mu", 10 * value["mu"], "--mu-r", 10 * value["mu_r"])
    force, moment, tenth, margin = zip(*numbers(hold, "force", "moment", "hold_load", "margin"))
    load = [least / (1 - left) for least, left in zip(tenth, margin)]
    return value, force, moment, load, [10 * least for least in tenth]


def log_fit(command):
    value, force, moment, load, _ = wrench_log(command)
    figure, axes = plt.subplots(figsize=(4.2, 3.6))
    axes.plot([f / (value["mu"] * p) for f, p in zip(force, load)],
              [abs(m) / (value["mu_r"] * p) for m, p in zip(moment, load)], ".", color=INK, markersize=1.5, markevery=3,
              label="every third row of the log")
    axes.plot(*zip(*numbers(command.rows("curve", "--law", "hertz"), "x", "y")), color=BLUE, label="Hertz")
    axes.legend(loc="upper right")
    axes.set(title=f"Fit: mu = {value['mu']:.4f}, mu_r = {1e3 * value['mu_r']:.4f} mm", xlabel="force / (mu load)",
             ylabel="moment / (mu_r load)")
    return figure


def log_grip(command):
    *_, load, needed = wrench_log(command)
    time = [0.02 * i for i in range(len(needed))]
    figure, axes = plt.subplots(figsize=(6.4, 2.6))
    axes.plot(time, load, color=INK, linewidth=0.8, label="load")
    axes.plot(time, needed, color=BLUE, linewidth=0.8, label="load that holds")
    axes.legend(loc="upper left", ncols=2)
    axes.set(title="Where the load that holds meets the load [N], the finger slips",
             xlabel="time of loaded rows [s]",
             xlim=(0, time[-1]),
             ylim=(0, 1.3 * max(load)))
    return figure


def main():
    executable, folder = sys.argv[1:]
    for draw in (cor_in_engine, groove, human_fingers, log_fit, log_grip, when_a_table_pays):
        save(draw(Command([executable])), folder, draw.__name__)


if __name__ == "__main__":
    main()
