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


def wrench_log():
    """Time, load, force, moment of docs/measure_and_fit.md, and which rows are slips by its rule."""
    path = Path(__file__).resolve().parents[2] / "data" / "fit" / "wrench_log.csv"
    rows = list(csv.DictReader(line for line in path.read_text().splitlines() if not line.startswith("#")))
    fx, fy, fz, moment = ([float(row["field.wrench." + axis])
                           for row in rows]
                          for axis in ("force.x", "force.y", "force.z", "torque.z"))
    load, force = [-z for z in fz], [math.hypot(x, y) for x, y in zip(fx, fy)]
    size = [math.hypot(f, m / 0.004) for f, m in zip(force, moment)]
    slips = [
        i for i in range(10, len(rows))
        if min(load[i], load[i - 10]) > 0.5 and abs(size[i] - size[i - 10]) < 0.05 * load[i]
    ]
    return [0.02 * i for i in range(len(rows))], load, force, moment, slips


def log_slips(_):
    time, _, force, moment, slips = wrench_log()
    figure, axes = plt.subplots(figsize=(6.4, 2.6), layout="constrained")
    for values, colour, label in ((force, BLUE, "force [N]"), ([1e3 * m for m in moment], ORANGE, "moment [N mm]")):
        axes.plot(time, values, color=colour, linewidth=0.8, label=label)
        axes.plot([time[i] for i in slips], [values[i] for i in slips],
                  ".",
                  color=INK,
                  markersize=1.5,
                  label="slips" if colour == BLUE else None)
    axes.legend(loc="upper left", ncols=3)
    axes.set(title="A row is a slip if its wrench no longer grows",
             xlabel="time [s]",
             xlim=(0, time[-1]),
             ylim=(-14, 16))
    return figure


def log_fit(limitcurve):
    _, load, force, moment, slips = wrench_log()
    rows = "load,force,moment\n" + "".join(f"{load[i]},{force[i]},{moment[i]}\n" for i in slips)
    fitted = ("fit", "ratio", "--law", "hertz", "--data", "-", "--quiet")
    value = dict(
        zip(column(limitcurve, "parameter", *fitted, kind=str, input=rows),
            column(limitcurve, "value", *fitted, input=rows)))
    figure, axes = plt.subplots(figsize=(4.2, 3.6), layout="constrained")
    axes.plot(column(limitcurve, "x", "curve", "--law", "hertz"),
              column(limitcurve, "y", "curve", "--law", "hertz"),
              color=BLUE,
              label="Hertz")
    axes.plot([force[i] / (value["mu"] * load[i]) for i in slips],
              [abs(moment[i]) / (value["mu_r"] * load[i]) for i in slips],
              ".",
              color=INK,
              markersize=2,
              label="slips")
    axes.legend(loc="lower left")
    axes.set(title=f"Fit: mu = {value['mu']:.4f}, mu_r = {1e3 * value['mu_r']:.4f} mm",
             xlabel="force / (mu load)",
             ylabel="moment / (mu_r load)")
    return figure


def log_grip(limitcurve):
    time, load, force, moment, _ = wrench_log()
    wrenches = "force,moment\n" + "".join(f"{f},{m}\n" for f, m in zip(force, moment))
    needed = column(limitcurve,
                    "hold_load",
                    "hold",
                    "--law",
                    "hertz",
                    "--mu",
                    "0.6",
                    "--mu-r",
                    "0.00212",
                    "--data",
                    "-",
                    input=wrenches)
    figure, axes = plt.subplots(figsize=(6.4, 2.6), layout="constrained")
    axes.plot(time, load, color=INK, linewidth=0.8, label="load")
    axes.plot(time, needed, color=BLUE, linewidth=0.8, label="load that holds")
    axes.legend(loc="upper left")
    axes.set(title="Where the load that holds meets the load [N], the finger slips",
             xlabel="time [s]",
             xlim=(0, time[-1]))
    return figure


def main():
    limitcurve, folder = sys.argv[1:]
    for draw in (cor_in_engine, groove, human_fingers, log_fit, log_grip, log_slips, when_a_table_pays):
        save(draw(limitcurve), folder, draw.__name__)


if __name__ == "__main__":
    main()
