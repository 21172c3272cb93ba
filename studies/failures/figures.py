#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the figures of docs/stability.md from what `stability_study` measured: a function for each figure takes its rows and returns it.

usage: figures.py MEASURED OUTPUT_FOLDER     every FIGURE.csv as FIGURE.svg (and .png), the same bytes each time
"""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from report.chart_style import (  # noqa: E402
    BLUE, DASHES, FAINT, GREEN, GRID, INK, ORANGE, PURPLE, VERMILION, Table, law_style, legend_below, mark_ratios, plt, save)

LARGEST = 60_000  # bytes of a figure in docs/
OURS = "limitcurve"
COLOURS = (VERMILION, ORANGE, GREEN, PURPLE, FAINT)
LAWS = ("hertz", "uniform", "parabolic", "flat-punch", "cone")
ERRORS = (1e-17, 1e2)  # an axis of relative errors; what is not a number is drawn along its top
COR = "centre of rotation  s = c/a"
RATIO = "stiffness ratio  $k_r/(k_l\\,(m_0a)^2)$"


def styles(names):
    """Ours blue and above the others; a law in its own colour and dashes; else colours and dashes in order."""
    others = [name for name in names if name != OURS and name not in LAWS]
    style = {name: {"color": COLOURS[i % len(COLOURS)], "dashes": DASHES[i % len(DASHES)], "linewidth": 1.2}
             for i, name in enumerate(others)}
    style |= {name: {**law_style(name), "linewidth": 1.2} for name in names if name in LAWS}
    return style | {OURS: {"color": BLUE if "hertz" not in names else INK, "linewidth": 1.5, "zorder": 3}}


def frame(count, height=3.2, **more):
    figure, axes = plt.subplots(1, count, figsize=(9.6 if count > 1 else 6.4, height), layout="constrained", squeeze=False, **more)
    return figure, axes[0]


def chart(rows, columns, panels, top=math.inf, sharey=True):
    """Lines, in a panel for each name (None: all rows) with what is set of its axes; the legend below has so many columns."""
    figure, all_axes = frame(len(panels), sharey=sharey)
    style = styles(list(rows.groups("series"))) | {"eq. (17)": {"color": GRID, "linewidth": 5, "zorder": 1}}
    for axes, (panel, labels) in zip(all_axes, panels.items()):
        for series, points in (rows.where(panel=panel) if panel else rows).groups("series").items():
            axes.plot(points.column("x"), [min(value, top) for value in points.column("value")], label=series, **style[series])
        axes.set(**labels)
        axes.minorticks_off()
    legend_below(figure, all_axes[0], columns)
    return figure


def error(title, **labels):
    """Axes of a relative error."""
    return {"title": title, "xlabel": COR, **labels, "yscale": "log", "ylim": ERRORS, "yticks": [10.0**k for k in range(-16, 3, 4)]}


def quadrature_rim(rows):
    return chart(rows, 3, {
        "across": error("Relative error of the force, 1e-9 asked", xlim=(0, 2)),
        "near": error("… towards the rim, from inside", xlabel="distance from the rim  1 − s", xscale="log", xlim=(1, 1e-15))})


def quadrature_singular(rows):
    return chart(rows, 3, {
        "exponent": error("Error of the force at s = ½, pressure $(1-\\rho^2)^n$", xlabel="n + 1   (½: flat punch;  → 0: ring)",
                          xscale="log", xlim=(1, 1e-3)),
        "cor": error("… against the COR, n = −0.9", xlim=(0, 3))})


def quadrature_complement(rows):
    figure = chart(rows, 3, {None: error(
        "Relative error of the elliptic integral K next to ρ = s", xlabel="distance  |ρ − s|/(ρ + s)",
        xscale="log", xlim=(1, 1e-300), xticks=[10.0**k for k in range(0, -301, -50)])}, top=ERRORS[1])
    figure.axes[0].annotate("threw, or returned NaN", (1e-25, ERRORS[1]), (0, -4), textcoords="offset points", va="top", color=FAINT)
    return figure


def quadrature_kinks(rows):
    return chart(rows, 2, {None: error("Relative error of the force of a profile with four kinks", xlim=(0, 2))})


def closed_forms(rows, title, low, high):
    figure = chart(rows, 5, {None: error(f"Relative error of the {title}: as printed, and ours", xscale="log", xlim=(low, high))}, top=1)
    figure.axes[0].annotate("no digit left", (math.sqrt(low * high), 1), (0, 4), textcoords="offset points", ha="center", color=FAINT)
    return figure


def closed_forms_far(rows):
    return closed_forms(rows, "moment far away", 1.1, 1e8)


def closed_forms_near(rows):
    return closed_forms(rows, "force near the centre", 1e-10, 0.9)


def tables_spacing(rows):
    return chart(rows, 2, {
        "numbers": {"title": "Largest error of f and m, flat punch", "xlabel": "numbers in the table", "xscale": "log", "yscale": "log",
                    "xlim": (15, 3000)},
        "cor": {"title": "… against the COR, as many numbers as our table of 1e-8", "xlabel": COR, "yscale": "log",
                "xlim": (0, 3), "ylim": (1e-12, 1e-1)}})


def tables_equilibria(rows):
    figure, (power, rests) = frame(2)
    style = styles(list(rows.groups("series")))
    for series, points in rows.where(panel="power").groups("series").items():
        power.plot(points.column("x"), points.column("value"), label=series, **style[series])
    power.set(title="Power of one twist along the curve", xlabel="place on the curve (spin fraction)",
              ylabel="less the largest  [1e-4 µPaω]")
    for series, points in rows.where(panel="rests").groups("series").items():
        marker = "o" if series == OURS else "s"
        rests.plot(points.column("x"), points.column("value"), marker=marker, markersize=3, label=series, **style[series])
    rests.set(title="Wrenches at which one steady twist can rest", xlabel="nodes (limitcurve: cells)",
              xscale="log", yscale="log", ylim=(0.8, 60))
    for axis, ticks in ((rests.yaxis, (1, 2, 5, 10, 20, 50)), (rests.xaxis, (2, 5, 10, 20, 50, 100, 200, 500))):
        axis.set_ticks(ticks, [f"{tick:g}" for tick in ticks])
    rests.minorticks_off()
    legend_below(figure, power, 2)
    return figure


def fits_cor(rows):
    ticks = (0.1, 0.2, 0.5, 1, 2, 5, 10)
    return chart(rows, 4, {None: {
        "title": "COR implied over the true one, flat punch", "xlabel": COR, "xscale": "log", "yscale": "log",
        "xlim": (1e-3, 1e3), "ylim": (0.05, 20), "yticks": ticks, "yticklabels": [f"{tick:g}" for tick in ticks]}})


def fits_shape(rows):
    figure, (cloud, errors) = frame(2)
    valley = rows.where(panel="cloud", series="same moment")
    cloud.plot(valley.column("x"), valley.column("value"), color=BLUE, label="same moment, limitcurve reports it")
    points = rows.where(panel="cloud", series="a fit")
    cloud.plot(points.column("x")[::2], points.column("value")[::2], ".", color=VERMILION, markersize=4, label="fits of n and a")
    cloud.plot([0.5], [5], "+", color=INK, markersize=11, markeredgewidth=1.6, label="truth")
    cloud.set(title="Measurements of one contact, 1 % noise", xlabel="fitted shape n", ylabel="fitted radius a  [mm]", xlim=(-0.8, 3),
              ylim=(3.4, 7.6))
    cloud.legend(loc="upper left", handlelength=2)
    for series, colour in (("Hertz assumed", VERMILION), (OURS, BLUE)):
        values = sorted(max(value, 0.01) for value in rows.where(panel="errors", series=series).column("value"))[1::3]
        errors.plot(values, [(i + 0.5) / len(values) for i in range(len(values))], color=colour,
                    label={OURS: "limitcurve, shape free"}.get(series, series))
    errors.axvline(1.96, color=FAINT, linewidth=0.8, dashes=(2, 2))
    errors.annotate("95 % should be\nleft of this", (1.96, 0.2), (5, 0), textcoords="offset points", color=FAINT)
    errors.set(title="The radius of a uniform pad", xlabel="error / standard error stated", ylabel="share of measurements",
               xscale="log", xlim=(0.02, 200), ylim=(0, 1))
    errors.set_xticks((0.1, 1, 10, 100), ("0.1", "1", "10", "100"))
    errors.minorticks_off()
    errors.legend(loc="upper left", handlelength=2)
    return figure


def turns_half(rows):
    labels = {"xlabel": "turned by [rad]", "xlim": (0, 12), "ylim": (-1.15, 1.15),
              "xticks": [math.pi * k for k in range(4)], "xticklabels": ["0", "π", "2π", "3π"]}
    return chart(rows, 3, {"stiff": {"title": "Moment felt, of its limit; slips after 0.1 rad", **labels},
                           "soft": {"title": "… slips after 4 rad", **labels}})


def projection_stiffness(rows):
    figure = chart(rows, 2, {None: {
        "title": "Error of the wrench of a steady twist, c = a", "xlabel": RATIO, "ylabel": "in the normalised plane",
        "xscale": "log", "xlim": (1e-6, 1e6), "ylim": (-0.03, None)}})
    figure.axes[0].lines[0].set(linewidth=3.5)  # the exact curve's lies on it
    mark_ratios(figure.axes[0])
    return figure


def steady_twist(rows, **labels):
    """Force and moment that a steady twist ends with, eq. (17) as a broad line beneath."""
    labels |= {"xscale": "log", "ylim": (-0.03, 1.06)}
    return chart(rows, 4, {"force": {"title": "Force of a steady twist / its largest", **labels},
                           "moment": {"title": "Moment / its largest", **labels}})


def projection_small(rows):
    return steady_twist(rows, xlabel="size of the contact, as its  $\\mu_r$  [mm]   (c = 5 mm, $k_r$ = 0.036 N m/rad)", xlim=(1e-3, 100))


def projection_growth(rows):
    return steady_twist(rows, xlabel="centre of rotation  c  [mm]   (a = 6 mm at 1 N)", xlim=(0.2, 100))


def projection_order(rows):
    return steady_twist(rows, xlabel=COR, xlim=(0.01, 100))


def projection_newton(rows):
    return chart(rows, 3, {
        "stiffness": {"title": "Slips with no closest point found", "xlabel": RATIO, "ylabel": "share",
                      "xscale": "log", "xlim": (1e-6, 1e6), "ylim": (-0.02, 1)},
        "load": {"title": "… against the trial's distance, ratio 1", "xlabel": "trial wrench / limit − 1",
                 "xscale": "log", "xlim": (1e-4, 1e8)}})


MARKS = {"defaults": ("o", "defaults"), "pivot": ("s", "pivot"), "10 g": ("D", "10 g")}


def time_map(rows):
    figure, panels_ = frame(3, sharey=True)
    for axes, name in zip(panels_, ("explicit Euler", "symplectic Euler", "limitcurve")):
        part = rows.where(panel=name)
        cells = part.groups("series")
        dampings = [series for series in cells if isinstance(series, float)]
        stiffnesses = cells[dampings[0]].column("x")
        gains = [cells[series].column("value") for series in dampings]
        colours = plt.matplotlib.colors.ListedColormap(["#cfe3f2", "#f3cdb8"])
        axes.pcolormesh(stiffnesses, dampings, gains, cmap=colours, vmin=0, vmax=1, shading="nearest", rasterized=True, linewidth=0)
        for series in ("least damping", "most damping"):
            if series in cells:
                axes.plot(cells[series].column("x"), cells[series].column("value"), color=INK, linewidth=1.2,
                          label="analytic limit" if series == "most damping" else None)
        for series, (marker, label) in MARKS.items():
            axes.plot(cells[series].column("x"), cells[series].column("value"), marker, color=BLUE, markeredgecolor="white", markersize=6,
                      clip_on=False, zorder=5, label=label, linestyle="none")
        axes.set(title=f"{name}, the default" if name == "limitcurve" else name, xscale="log", xlim=(1e-2, 1e3), ylim=(-0.05, 2),
                 xlabel="stiffness  $k\\,\\Delta t^2/m$")
        axes.set_xticks([1e-2, 1, 1e2])
        axes.set_yticks([0, 1, 2])
        axes.minorticks_off()
        axes.grid(False)
    panels_[0].set_ylabel("damping  $ζ = b/(2√(km))$")
    panels_[0].annotate("held", (0.05, 0.9), ha="center", color=INK)
    panels_[0].annotate("gains energy", (10, 1), ha="center", color=INK)
    legend_below(figure, panels_[1], 4)
    return figure


def time_delay(rows):
    figure, (axes,) = frame(1)
    looks = {"no delay": (BLUE, "o"), "one sample late": (ORANGE, "^"), "two samples late": (VERMILION, "s")}
    for series, points in rows.groups("series").items():
        if series.endswith(", formula"):
            axes.plot(points.column("x"), points.column("value"), color=INK, linewidth=0.8, dashes=(4, 3),
                      label="$k(½ + d)T$" if "no delay" in series else None)
        else:
            colour, marker = looks[series]
            axes.plot(points.column("x"), points.column("value"), marker, markersize=4, color=colour, label=series)
    axes.set(title="Damping with which a device of 0.1 kg settles on a contact, 1 kHz", xlabel="stiffness  [N/m]", ylabel="[N s/m]",
             xscale="log", yscale="log", xlim=(45, 5500))
    axes.minorticks_off()
    legend_below(figure, axes, 4)
    return figure


def reality_rates(rows):
    labels = {"xlabel": "rate [Hz]", "xscale": "log", "yscale": "log", "xlim": (100, 1e4)}
    return chart(rows, 2, {
        "force": {"title": "Largest friction / limit, scrubbing up to 0.25 m/s", "ylim": (0.5, 1e3), **labels},
        "error": {"title": "Our error of the friction while stirring / limit", "ylim": (1e-3, 1), **labels}}, sharey=False)


DRAWN = (
    quadrature_rim, quadrature_singular, quadrature_kinks, quadrature_complement, closed_forms_far, closed_forms_near, tables_spacing,
    tables_equilibria, fits_cor, fits_shape, turns_half, projection_stiffness, projection_small, projection_growth, projection_newton,
    projection_order, time_map, time_delay, reality_rates)


def main():
    folder, output = map(Path, sys.argv[1:])
    output.mkdir(parents=True, exist_ok=True)
    figures = {figure.__name__: figure for figure in DRAWN}
    measured = {path.stem for path in folder.glob("*.csv")} - {"summary"}
    if measured != set(figures):
        sys.exit(f"figures.py: error: measured but not drawn, or drawn but not measured: {sorted(measured ^ set(figures))}")
    for name, figure in figures.items():
        save(figure(Table.read(folder / f"{name}.csv")), output, name)
        size = (output / f"{name}.svg").stat().st_size
        if size > LARGEST:
            sys.exit(f"figures.py: error: {name}.svg has {size} bytes: expected at most {LARGEST}")


if __name__ == "__main__":
    main()
