# SPDX-License-Identifier: MIT
"""Figures of docs/stability.md, entries projection, time, geometry and reality: one function a figure, takes its rows, returns a figure."""

from report.chart_style import BLUE, GRID, INK, ORANGE, VERMILION, legend_below, mark_ratios, plt
from numerics_figures import COR, draw, frame, styles


def panels(rows, names, **more):
    """A panel for each name, with all series in the same style."""
    figure, axes = frame(len(names), **more)
    style = styles(list(rows.groups("series")))
    for one, name in zip(axes, names):
        draw(one, rows.where(panel=name), style)
    return figure, axes


RATIO = "stiffness ratio  $k_r/(k_l\\,(m_0a)^2)$"


def projection_quotients(rows):
    """Ten steps, each a line: what is felt, as printed and by us."""
    figure, axes = frame(2, height=2.9, sharey=True)
    steps = list(rows.groups("panel"))
    marks = {0: ("o", BLUE, "right"), 1: ("x", VERMILION, "wrong"), 2: ("s", VERMILION, "NaN")}
    for one, series in zip(axes, ("as printed", "limitcurve")):
        for value, (marker, colour, label) in marks.items():
            found = [(row["x"], steps.index(row["panel"])) for row in rows.where(series=series) if row["value"] == value]
            one.plot([x for x, _ in found], [y for _, y in found], marker, color=colour, label=label, linestyle="none", markersize=6, markeredgewidth=1.6,
                     markerfacecolor="none" if value == 2 else colour)
        one.set(title="Eqs. (21)–(23) as printed" if series == "as printed" else series, xlim=(-0.5, 1.5), ylim=(len(steps) - 0.4, -0.6))
        one.set_xticks([0, 1], ["force", "moment"])
        one.set_yticks(range(len(steps)), steps)
        one.tick_params(length=0)
    legend_below(figure, axes[0], 3)
    return figure


def projection_stiffness(rows):
    figure, (axes,) = panels(rows, ["error"])
    axes.lines[0].set(linewidth=3.5)  # the exact curve's lies on it
    axes.set(title="Error of the wrench of a steady twist, c = a", xlabel=RATIO, xscale="log", xlim=(1e-6, 1e6), ylim=(-0.03, None),
             ylabel="in the normalised plane")
    axes.minorticks_off()
    mark_ratios(axes)
    legend_below(figure, axes, 2)
    return figure


def steady_twist(rows, xlabel, **more):
    """Force and moment that a steady twist ends with, eq. (17) as a broad line beneath."""
    figure, (force, moment) = frame(2, sharey=True)
    style = styles(list(rows.groups("series"))) | {"eq. (17)": {"color": GRID, "linewidth": 5, "zorder": 1}}
    for axes, panel in ((force, "force"), (moment, "moment")):
        draw(axes, rows.where(panel=panel), style)
        axes.set(xlabel=xlabel, xscale="log", ylim=(-0.03, 1.06), **more)
        axes.minorticks_off()
    force.set(title="Force of a steady twist / its largest")
    moment.set(title="Moment / its largest")
    legend_below(figure, force, 4)
    return figure


def projection_small(rows):
    return steady_twist(rows, "size of the contact, as its  $\\mu_r$  [mm]   (c = 5 mm, $k_r$ = 0.036 N m/rad)", xlim=(1e-3, 100))


def projection_growth(rows):
    return steady_twist(rows, "centre of rotation  c  [mm]   (a = 6 mm at 1 N)", xlim=(0.2, 100))


def projection_newton(rows):
    figure, (stiffness, load) = panels(rows, ["stiffness", "load"], sharey=True)
    stiffness.set(title="Slips with no closest point found", xlabel=RATIO, xscale="log", xlim=(1e-6, 1e6), ylim=(-0.02, 1), ylabel="share")
    load.set(title="… against the trial's distance, ratio 1", xlabel="trial wrench / limit − 1", xscale="log", xlim=(1e-4, 1e8))
    for axes in (stiffness, load):
        axes.minorticks_off()
    legend_below(figure, stiffness, 3)
    return figure


def projection_corners(rows):
    figure, (axes,) = frame(1, height=4.2)
    axes.plot([0, 1, 1], [1, 1, 0], color=INK, linewidth=1.2)
    for series, points in rows.groups("series").items():
        ours = series.startswith("ours")
        axes.plot(points.column("x"), points.column("value"), color=BLUE if ours else VERMILION, linewidth=1, zorder=3 if ours else 2,
                  linestyle="-" if ours else (0, (3, 2)), label={"ours 0": "limitcurve", "search 0": "search for the wrench whose normal fits"}.get(series))
        axes.plot(points.column("x")[-1:], points.column("value")[-1:], "o" if ours else "x", markersize=4, color=BLUE if ours else VERMILION, zorder=4)
    axes.set(title="From trial to wrench, box", xlabel="force / its largest", ylabel="moment / its largest", xlim=(0, 1.7), ylim=(0, 1.7), aspect="equal",
             xticks=(0, 1), yticks=(0, 1))
    legend_below(figure, axes, 2)
    return figure


def projection_order(rows):
    figure, (force, moment) = panels(rows, ["force", "moment"], sharey=True)
    force.set(title="Force of a steady twist / its largest", xlabel=COR, xscale="log", xlim=(0.01, 100), ylim=(-0.03, 1.06))
    moment.set(title="Moment / its largest", xlabel=COR, xscale="log", xlim=(0.01, 100))
    for axes in (force, moment):
        axes.minorticks_off()
    legend_below(figure, force, 3)
    return figure


def projection_chatter(rows):
    figure, (force, period) = frame(2)
    colours = {"static limit in every step": VERMILION, "limitcurve": BLUE, "exact": INK}
    for series, points in rows.where(panel="force").groups("series").items():
        force.plot(points.column("x"), points.column("value"), color=colours[series], linewidth=1.2, label=series)
    force.set(title="Friction of a drag at 5 mm/s", xlabel="time [ms]", ylabel="[N]", xlim=(0, 200), ylim=(0.45, 0.65))
    for series, points in rows.where(panel="period").groups("series").items():
        dashes = {"dashes": (4, 3), "linewidth": 2.2} if series == "exact" else {"linewidth": 1.2}
        period.plot(points.column("x"), points.column("value"), color=colours[series], label=series, **dashes)
    period.set(title="Period of stick–slip of a drawn mass", xlabel="speed [mm/s]", ylabel="[ms]", xlim=(20, 200), ylim=(0, None))
    legend_below(figure, period, 3)
    return figure


def projection_collapse(rows):
    figure, (axes,) = frame(1)
    for series, style in (("limit", {"color": INK, "linewidth": 3, "alpha": 0.35}), ("bristles of a fixed stiffness", {"color": VERMILION, "linewidth": 1.2}),
                          ("bristles of a stiffness in proportion to the load", {"color": ORANGE, "dashes": (4, 2)}), ("limitcurve", {"color": BLUE})):
        points = rows.where(series=series)
        axes.step(points.column("x"), points.column("value"), where="post", label={"limit": "limit µP"}.get(series, series), **style)
    axes.set(title="Friction of a finger at rest, let go from 5 N to 5 mN", xlabel="samples", ylabel="[N]", yscale="log", xlim=(-10, 10), ylim=(1e-3, 10))
    axes.set_xticks(range(-10, 11, 5))
    axes.minorticks_off()
    legend_below(figure, axes, 3)
    return figure


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
                axes.plot(cells[series].column("x"), cells[series].column("value"), color=INK, linewidth=1.2, label="analytic limit" if series == "most damping" else None)
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
    axes.set(title="Damping with which a device of 0.1 kg settles on a contact, 1 kHz", xlabel="stiffness  [N/m]", ylabel="[N s/m]", xscale="log", yscale="log",
             xlim=(45, 5500))
    axes.minorticks_off()
    legend_below(figure, axes, 4)
    return figure


def time_passivity(rows):
    figure, (axes,) = frame(1)
    # Hollow and each smaller than the one before, so that dots in one place are all seen.
    for (series, points), colour, marker, size in zip(rows.groups("series").items(), (VERMILION, ORANGE, BLUE), "soD", (9, 5.5, 2.5)):
        axes.plot(points.column("x"), points.column("value"), marker, markersize=size, color=colour, label=series, linestyle="none", markerfacecolor="none")
    ends = [min(rows.column("x")), max(rows.column("x"))]
    axes.plot(ends, ends, color=INK, linewidth=0.8, label="$kT/2 + |b|$", zorder=1)
    axes.set(title="Damping that a device needs: measured, against the formula", xlabel="$kT/2 + |b|$  [N s/m]", ylabel="measured [N s/m]", xscale="log", yscale="log")
    axes.minorticks_off()
    legend_below(figure, axes, 4)
    return figure


def reality_rates(rows):
    figure, (force, error) = panels(rows, ["force", "error"])
    force.set(title="Largest friction / limit, scrubbing up to 0.25 m/s", xlabel="rate [Hz]", xscale="log", yscale="log", xlim=(100, 1e4), ylim=(0.5, 1e3))
    error.set(title="Our error of the friction while stirring / limit", xlabel="rate [Hz]", xscale="log", yscale="log", xlim=(100, 1e4), ylim=(1e-3, 1))
    for axes in (force, error):
        axes.minorticks_off()
    legend_below(figure, force, 2)
    return figure


def reality_plate(rows):
    figure, (axes,) = panels(rows, ["load"])
    for line in axes.lines:
        line.set(marker="o", markersize=3.5, linestyle="none", clip_on=False)
    axes.set(title="Load after lost samples / right; a plate of 1 mm, 0.4 m/s, 1 kHz", xlabel="samples lost", xlim=(0, 20), ylim=(-0.8, 1.1))
    axes.set_xticks(range(0, 21, 5))
    legend_below(figure, axes, 2)
    return figure


def one_panel(panel, columns, **labels):
    """A figure of one panel whose legend has so many columns."""
    def figure_of(rows):
        figure, (axes,) = panels(rows, [panel])
        axes.set(**labels)
        if "xscale" in labels or "yscale" in labels:
            axes.minorticks_off()
        legend_below(figure, axes, columns)
        return figure
    return figure_of


FIGURES = {figure.__name__: figure for figure in (
    projection_quotients, projection_stiffness, projection_small, projection_growth, projection_newton, projection_corners, projection_order, projection_chatter, projection_collapse,
    time_map, time_delay, time_passivity,
    reality_rates, reality_plate)} | {
    "time_block": one_panel("height", 3, title="Height of 10 g between two fingers of 2000 N/m, 1 kHz, undamped", xlabel="time [ms]", ylabel="[mm]", xlim=(0, 120), ylim=(-0.5, 0.1)),
    "time_release": one_panel("energy", 3, title="Energy of 10 g after the grip is let go from 10 N to 0.2 N in one step", xlabel="time [ms]", ylabel="of what there was", xlim=(0, 200), ylim=(0, 1.5)),
    "time_encoder": one_panel("force", 2, title="Largest friction force / limit; encoder of 10 µm, 5 N s/m, a drag at 5 mm/s", xlabel="rate [Hz]", xscale="log", xlim=(100, 1e4), ylim=(0.9, 2.1)),
    "geometry_plate": one_panel("force", 2, title="Force towards the finger's side, pressed into a plate of 1 mm (1000 N/m)", xlabel="depth [mm]", ylabel="[N]", xlim=(-0.2, 3), ylim=(-1, 3)),
    "geometry_normals": one_panel("normal", 2, title="Friction along the normal / µP, round a rod of eight edges", xlabel="angle [°]", xlim=(10, 80), ylim=(-0.7, 0.2)),
    "reality_clock": one_panel("load", 2, title="Damper's share of the load at a steady speed, 1 kHz ± 30 %", xlabel="time [ms]", ylabel="of b v", xlim=(0, 50), ylim=(0, 2)),
    "reality_samples": one_panel("load", 2, title="Load; one sample leaps, one is NaN, from 500 ms on there are none", xlabel="time [ms]", ylabel="[N]", xlim=(0, 1000), ylim=(0, 6.2)),
    "reality_frozen": one_panel("force", 2, title="Friction / limit of a device that froze, and goes on 2 cm away", xlabel="samples", yscale="log", xlim=(-10, 30), ylim=(0.1, 100)),
}
