# SPDX-License-Identifier: MIT
"""Figures of docs/stability.md, entries quadrature, tables, fits, and of geometry the turns: one function a figure, takes its rows, returns a figure."""

import math

from report.chart_style import BLUE, DASHES, FAINT, GREEN, GRID, INK, ORANGE, PURPLE, VERMILION, law_style, legend_below, plt

OURS = "limitcurve"
COLOURS = (VERMILION, ORANGE, GREEN, PURPLE, FAINT)
LAWS = ("hertz", "uniform", "parabolic", "flat-punch", "cone")
ERRORS = (1e-17, 1e2)  # an axis of relative errors; what is not a number is drawn along its top
COR = "centre of rotation  s = c/a"


def styles(names):
    """Ours blue and above the others; a law in its own colour and dashes; else colours and dashes in order."""
    others = [name for name in names if name != OURS and name not in LAWS]
    style = {name: {"color": COLOURS[i % len(COLOURS)], "dashes": DASHES[i % len(DASHES)], "linewidth": 1.2} for i, name in enumerate(others)}
    style |= {name: {**law_style(name), "linewidth": 1.2} for name in names if name in LAWS}
    return style | {OURS: {"color": BLUE if "hertz" not in names else INK, "linewidth": 1.5, "zorder": 3}}


def draw(axes, rows, style, top=math.inf):
    for series, points in rows.groups("series").items():
        axes.plot(points.column("x"), [min(value, top) for value in points.column("value")], label=series, **style[series])


def frame(count, height=3.2, **more):
    figure, panels = plt.subplots(1, count, figsize=(9.6 if count > 1 else 6.4, height), layout="constrained", **more)
    return figure, panels if count > 1 else [panels]


def error_axes(axes, **more):
    axes.set(yscale="log", ylim=ERRORS, **more)
    axes.set_yticks([10.0**k for k in range(-16, 3, 4)])
    axes.minorticks_off()


def quadrature_rim(rows):
    figure, (across, near) = frame(2, sharey=True)
    style = styles(list(rows.groups("series")))
    draw(across, rows.where(panel="across"), style)
    draw(near, rows.where(panel="near"), style)
    error_axes(across, title="Relative error of the force, 1e-9 asked", xlabel=COR, xlim=(0, 2))
    error_axes(near, title="… towards the rim, from inside", xlabel="distance from the rim  1 − s", xscale="log", xlim=(1, 1e-15))
    legend_below(figure, across, 3)
    return figure


def quadrature_adaptive(rows):
    figure, (axes,) = frame(1)
    for (series, points), style in zip(rows.groups("series").items(), ({"color": VERMILION, "marker": "."}, {"color": BLUE, "marker": "o", "linestyle": "none"})):
        axes.plot(points.column("x"), points.column("value"), label=series, **style)
    error_axes(axes, title="Largest relative error of the force, 50 CORs under the finger", xlabel="evaluations of the pressure, at most", xscale="log",
               xlim=(50, 1e6))
    legend_below(figure, axes, 2)
    return figure


def quadrature_singular(rows):
    figure, (exponent, cor) = frame(2, sharey=True)
    style = styles(list(rows.groups("series")))
    draw(exponent, rows.where(panel="exponent"), style)
    draw(cor, rows.where(panel="cor"), style)
    error_axes(exponent, title="Error of the force at s = ½, pressure $(1-\\rho^2)^n$", xlabel="n + 1   (½: flat punch;  → 0: ring)", xscale="log", xlim=(1, 1e-3))
    error_axes(cor, title="… against the COR, n = −0.9", xlabel=COR, xlim=(0, 3))
    legend_below(figure, exponent, 3)
    return figure


def quadrature_kinks(rows):
    figure, (axes,) = frame(1)
    draw(axes, rows, styles(list(rows.groups("series"))))
    error_axes(axes, title="Relative error of the force of a profile with four kinks", xlabel=COR, xlim=(0, 2))
    legend_below(figure, axes, 2)
    return figure


def quadrature_complement(rows):
    figure, (axes,) = frame(1)
    draw(axes, rows, styles(list(rows.groups("series"))), top=ERRORS[1])
    error_axes(axes, title="Relative error of the elliptic integral K next to ρ = s", xlabel="distance  |ρ − s|/(ρ + s)", xscale="log")
    axes.set_xlim(1, 1e-300)
    axes.set_xticks([10.0**k for k in range(0, -301, -50)])
    axes.annotate("threw, or returned NaN", (1e-25, ERRORS[1]), (0, -4), textcoords="offset points", ha="left", va="top", color=FAINT)
    legend_below(figure, axes, 3)
    return figure


def closed_forms_far(rows):
    return closed_forms(rows, "Relative error of the moment far away: as printed, and ours")


def closed_forms_near(rows):
    return closed_forms(rows, "Relative error of the force near the centre: as printed, and ours")


def closed_forms(rows, title):
    figure, (axes,) = frame(1)
    draw(axes, rows, styles(list(rows.groups("series"))), top=1)
    places = rows.column("x")
    error_axes(axes, title=title, xlabel=COR, xscale="log", xlim=(min(places), max(places)))
    axes.annotate("no digit left", (math.sqrt(min(places) * max(places)), 1), (0, 4), textcoords="offset points", ha="center", color=FAINT)
    legend_below(figure, axes, 5)
    return figure


def tables_spacing(rows):
    figure, (numbers, cor) = frame(2, sharey=True)
    style = styles(list(rows.groups("series")))
    draw(numbers, rows.where(panel="numbers"), style)
    numbers.set(title="Largest error of f and m, flat punch", xlabel="numbers in the table", xscale="log", yscale="log", xlim=(15, 3000))
    draw(cor, rows.where(panel="cor"), style)
    cor.set(title="… against the COR, as many numbers as our table of 1e-8", xlabel=COR, yscale="log", xlim=(0, 3), ylim=(1e-12, 1e-1))
    for axes in (numbers, cor):
        axes.minorticks_off()
    legend_below(figure, numbers, 2)
    return figure


def tables_extrapolation(rows):
    figure, (axes,) = frame(1)
    draw(axes, rows, styles(list(rows.groups("series"))), top=1e6)
    axes.set(title="Relative error of the moment of a table that ends at s = 5", xlabel=COR, xscale="log", yscale="log", xlim=(1, 1e6), ylim=(1e-10, 1e6))
    axes.minorticks_off()
    legend_below(figure, axes, 4)
    return figure


def tables_equilibria(rows):
    figure, (power, rests) = frame(2)
    style = styles(list(rows.groups("series")))
    for series, points in rows.where(panel="power").groups("series").items():
        power.plot(points.column("x"), points.column("value"), label=series, **style[series])
    power.set(title="Power of one twist along the curve", xlabel="place on the curve (spin fraction)",
              ylabel="less the largest  [1e-4 µPaω]")
    for series, points in rows.where(panel="rests").groups("series").items():
        rests.plot(points.column("x"), points.column("value"), marker="o" if series == OURS else "s", markersize=3, label=series, **style[series])
    rests.set(title="Wrenches at which one steady twist can rest", xlabel="nodes (limitcurve: cells)", xscale="log", yscale="log", ylim=(0.8, 60))
    for axis, ticks in ((rests.yaxis, (1, 2, 5, 10, 20, 50)), (rests.xaxis, (2, 5, 10, 20, 50, 100, 200, 500))):
        axis.set_ticks(ticks, [f"{tick:g}" for tick in ticks])
    rests.minorticks_off()
    legend_below(figure, power, 2)
    return figure


def fits_cor(rows):
    figure, (axes,) = frame(1)
    draw(axes, rows, styles(list(rows.groups("series"))))
    axes.set(title="COR implied over the true one, flat punch", xlabel=COR, xscale="log", yscale="log", xlim=(1e-3, 1e3), ylim=(0.05, 20))
    axes.set_yticks((0.1, 0.2, 0.5, 1, 2, 5, 10), ("0.1", "0.2", "0.5", "1", "2", "5", "10"))
    axes.minorticks_off()
    legend_below(figure, axes, 4)
    return figure


def fits_tails(rows):
    figure, (moment, cor) = frame(2, sharey=True)
    style = styles(list(rows.groups("series")))
    for axes, panel in ((moment, "moment"), (cor, "cor")):
        draw(axes, rows.where(panel=panel), style, top=10)
        axes.axvspan(0.05, 5, color=GRID, alpha=0.5, linewidth=0, zorder=0)
        axes.set(xlabel=COR, xscale="log", yscale="log", xlim=(0.05, 100), ylim=(1e-6, 10))
        axes.minorticks_off()
    moment.set(title="Relative error of the moment (shaded: fitted)")
    cor.set(title="… of the COR that the curve implies")
    legend_below(figure, moment, 2)
    return figure


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
    figure, (stiff, soft) = frame(2, sharey=True)
    style = styles(list(rows.groups("series")))
    for axes, panel in ((stiff, "stiff"), (soft, "soft")):
        draw(axes, rows.where(panel=panel), style)
        axes.set(xlabel="turned by [rad]", xlim=(0, 12), ylim=(-1.15, 1.15))
        axes.set_xticks([math.pi * k for k in range(4)], ["0", "π", "2π", "3π"])
    stiff.set(title="Moment felt, of its limit; slips after 0.1 rad")
    soft.set(title="… slips after 4 rad")
    legend_below(figure, stiff, 3)
    return figure


def turns_many(rows):
    figure, (axes,) = frame(1)
    draw(axes, rows, styles(list(rows.groups("series"))))
    axes.set(title="Error of the unwrapped angle [rad]", xlabel="turns, of 100 steps each", xscale="log", yscale="log", xlim=(1, 1e4), ylim=(1e-16, 1e4))
    axes.minorticks_off()
    legend_below(figure, axes, 3)
    return figure


FIGURES = {figure.__name__: figure for figure in (
    quadrature_rim, quadrature_adaptive, quadrature_singular, quadrature_kinks, quadrature_complement, closed_forms_far, closed_forms_near,
    tables_spacing, tables_extrapolation, tables_equilibria, fits_cor, fits_tails, fits_shape, turns_half, turns_many)}
