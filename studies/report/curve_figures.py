# SPDX-License-Identifier: MIT
"""The report's figures of limit curves, approximations, tables and fits."""

import math

from .chart_style import (BLUE, ELLIPSE, FAINT, GREEN, GRID, INK, ORANGE, VERMILION, Table, framed, law_style,
                          legend_in_sight, note, only_ticks, pair, plt, quadrant, short)

CIRCLE = [[along(math.pi / 2 * i / 72) for i in range(73)] for along in (math.cos, math.sin)]


def limit_curves(data):
    """Paper, Fig. 3, corrected: every law lies inside the ellipse."""
    figure, (left, right) = pair(4.7)
    lens = left.inset_axes([0.06, 0.06, 0.52, 0.52])
    for law, rows in data["curves"].groups("law").items():
        rows = Table(rows[::5])  # chords of 2.5 degrees look round
        for axes in (left, lens):
            axes.plot(*rows.columns("x", "y"), label=law, **law_style(law))
        right.plot(*rows.columns("force", "moment"), **law_style(law))
    for axes in (left, lens):
        axes.plot(*CIRCLE, label="ellipse", **ELLIPSE)
        axes.set_aspect("equal", adjustable="box")
    quadrant(left, "Normalised by each law's own limits", "force  $F/(μP)$", "moment  $M/Γ$")
    left.set(xlim=(0, 1.05), ylim=(0, 1.05))
    lens.set(xlim=(0.61, 0.76), ylim=(0.61, 0.76), xticks=[], yticks=[])
    framed(lens)
    left.indicate_inset_zoom(lens, edgecolor=FAINT)
    quadrant(right, "In units of friction × load × contact radius", "force  $F/(\\mu P)$", "moment  $M/(\\mu P a)$")
    right.set(xlim=(0, 1.05), ylim=(0, 1.05 * max(data["curves"].column("moment"))))
    legend_in_sight(figure, left)
    return figure


def load_curves(data):
    """Paper, Fig. 4: p-curves (load fixed) and c-curves (COR fixed), with a constant and with a growing radius."""
    radius_laws = list(data["p_curves"].groups("radius_law"))
    figure, panels = plt.subplots(1, len(radius_laws), figsize=(9.6, 4.4), sharex=True, sharey=True)
    top_force = 1.28 * max(data["p_curves"].column("force"))
    top_moment = 1.12 * 1e3 * max(data["p_curves"].column("moment"))
    for axes, radius_law in zip(panels, radius_laws):
        for load, rows in data["p_curves"].where(radius_law=radius_law).groups("load").items():
            axes.plot(rows.column("force"), rows.column("moment", 1e3), color=BLUE)
            note(axes, f"{load:g} N", (0, max(rows.column("moment", 1e3))), (3, 3), color=BLUE,
                 bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6})
        for cor, rows in data["c_curves"].where(radius_law=radius_law).groups("c").items():
            force, moment = rows.column("force"), rows.column("moment", 1e3)
            inside = [i for i in range(len(force)) if force[i] <= top_force * 0.85 and moment[i] <= top_moment * 0.94]
            axes.plot(force[:inside[-1] + 1], moment[:inside[-1] + 1], color=ORANGE, linewidth=1.2)
            if 0 < cor < math.inf:
                end = (force[inside[-1]], moment[inside[-1]])
                note(axes, f"c = {cor * 1e3:g} mm", end, (3, 1), color="#a06a00")
        quadrant(axes, title_of_radius_law(radius_law), "friction force  F  [N]", "friction moment  M  [N mm]")
        axes.set(xlim=(0, top_force), ylim=(0, top_moment))
        axes.label_outer()
    return figure


def title_of_radius_law(text):
    kind, _, parameters = text.partition(":")
    values = dict(item.split("=") for item in parameters.split(","))
    if kind == "constant":
        return f"Contact radius constant: a = {float(values['a']) * 1e3:.3g} mm"
    if kind == "power":
        return (f"Growing with the load: a = {float(values['c']) * 1e3:.3g} mm × "
                f"$(P/\\mathrm{{N}})^{{{values['gamma']}}}$")
    return f"Growing with the load: {text}"


def ellipse_error(data):
    figure, (left, right) = pair(3.9)
    groups = data["ellipse_error"].groups("law")
    for law in sorted(groups, key=lambda name: -max(groups[name].column("over_estimate"))):
        rows = groups[law]
        degrees = rows.column("angle", 180 / math.pi)
        left.plot(degrees, rows.column("over_estimate", 100), label=law, **law_style(law))
        right.plot(degrees, rows.column("cor_ratio"), **law_style(law))
    direction = "direction of the wrench, 0° force … 90° moment"
    left.set(title="Capacity over-estimated by [%]", xlabel=direction, xlim=(0, 90), ylim=(0, None))
    right.set(title="COR distance, ellipse / true", xlabel=direction, xlim=(0, 90), yscale="log")
    right.axhline(1, color=INK, linewidth=0.8)
    only_ticks(right.yaxis, (0.6, 0.7, 0.8, 1, 1.2, 1.5, 1.8))
    for axes in (left, right):
        axes.set_xticks(range(0, 91, 15))
    legend_in_sight(figure, left)
    return figure


# Model of validate.csv: what the legend says, marker and colour.
MODELS = {
    "ellipse-inner": ("ellipse, inside the curve", "s", GREEN),
    "ellipse-least-squares": ("ellipse, best fit", "o", FAINT),
    "ellipse": ("ellipse through the limits", "o", INK),
    "diamond": ("diamond", "D", ORANGE),
    "box": ("box (uncoupled)", "X", VERMILION),
}


def models(data):
    laws = list(data["validate"].groups("law"))
    figure, axes = plt.subplots(figsize=(9.6, 0.32 * len(laws) + 1.0))
    for model, (label, marker, colour) in MODELS.items():
        rows = data["validate"].where(model=model)
        axes.plot(rows.column("max_error", 100), [laws.index(row["law"]) for row in rows],
                  marker,
                  color=colour,
                  label=label,
                  markersize=6)
    axes.set(title="Largest error of the capacity in any direction [%]", xscale="log", ylim=(len(laws) - 0.5, -0.5))
    axes.set_yticks(range(len(laws)), laws)
    only_ticks(axes.xaxis, (0.2, 0.5, 1, 2, 5, 10, 20, 50))
    legend_in_sight(figure, axes)
    return figure


def tables(data):
    figure, (left, right) = pair(3.9, width_ratios=(1, 1.15))
    for law, rows in data["tables"].groups("law").items():
        left.plot(*rows.columns("tolerance", "bytes"), marker="o", markersize=3, label=law, **law_style(law))
    tolerances = data["tables"].column("tolerance")
    left.set(title="Size of the table [bytes]", xscale="log", yscale="log", xlabel="tolerance in f and m")
    left.set_xlim(max(tolerances) * 2, min(tolerances) / 2)
    level_one = 32768
    left.axhline(level_one, color=FAINT, linewidth=0.8, dashes=(2, 2))
    note(left, "a level-1 cache, 32 KiB", (max(tolerances) * 1.5, level_one), (0, 3), color=FAINT)
    left.legend(loc="upper left", bbox_to_anchor=(0.0, 0.9), fontsize=7.5, handlelength=2.6, labelspacing=0.25)
    tolerance = min(data["table_error"].column("tolerance"))
    shown = data["table_error"].where(tolerance=tolerance)
    for law, rows in shown.groups("law").items():
        style = law_style(law)
        for part, look in (("force", style), ("moment", {"alpha": 0.45, "color": style["color"]})):
            right.plot(rows.column("spin_fraction"), rows.column(f"{part}_error", 1 / tolerance), linewidth=0.9,
                       label=f"{law}, {'f' if part == 'force' else 'm'}", **look)
    right.axhspan(-1, 1, color=GRID, alpha=0.5, zorder=0, linewidth=0)
    right.set(title=f"Error of a table of {short(tolerance)}, in tolerances", xlim=(0, 1), ylim=(-1.45, 1.45),
              xlabel="spin fraction u of the slip:  0 slides, ½ turns about the rim, 1 spins")
    right.legend(loc="upper center", ncols=4, fontsize=7.5, handlelength=1.8, columnspacing=1.2)
    return figure


RESIDUALS_SHOWN = 6


def fits(data):
    figure, (left, right) = pair(4.1)
    samples, curve = data["fit_residuals"], data["curves"].where(law="hertz")
    mu, mu_r, gamma = (data["fits"].where(data="slips", parameter=name)[0]["value"] for name in ("mu", "mu_r", "gamma"))
    left.plot([row["force"] / row["load"] for row in samples],
              [1e3 * row["moment"] / row["load"] ** (1 + gamma) for row in samples],
              ".",
              color=FAINT,
              markersize=2.5,
              alpha=0.6,
              label="a slip, scaled to 1 N")
    left.plot(curve.column("x", mu), curve.column("y", 1e3 * mu_r), color=BLUE, label="fitted limit curve")
    quadrant(left, "Slips and the limit curve fitted to them", "force at 1 N:  $F/P$  [N]",
             f"moment at 1 N:  $M/P^{{{1 + gamma:.3f}}}$  [N mm]")
    left.set(xlim=(0, 1.2 * mu), ylim=(0, 1.25e3 * mu_r))
    left.legend(loc="lower left", markerscale=3, handlelength=2)

    near = [row for row in samples if abs(row["residual"]) <= RESIDUALS_SHOWN]
    right.axhspan(-1.96, 1.96, color=GRID, alpha=0.5, zorder=0, linewidth=0)
    right.axhline(0, color=FAINT, linewidth=0.8)
    right.plot([row["load"] for row in near], [row["residual"] for row in near],
               ".",
               color=BLUE,
               markersize=3,
               alpha=0.5)
    right.set(
        title=
        f"Residuals in standard deviations ({len(samples) - len(near)} of {len(samples)} beyond ±{RESIDUALS_SHOWN})",
        xlabel="load  [N]",
        ylim=(-RESIDUALS_SHOWN, RESIDUALS_SHOWN))
    return figure


ENGINE_STYLES = {  # marker, colour, filled
    "mujoco ellipse": ("o", BLUE, False),
    "mujoco diamond": ("D", GREEN, False),
    "ode box": ("s", ORANGE, False),
    "bullet box": ("x", VERMILION, True),
}


def engines(data):
    figure, (left, right) = pair(4.4)
    drag = data["engine_drag"]
    exact = drag.where(engine=drag[0]["engine"], model=drag[0]["model"])
    curve = data["curves"].where(law="hertz")
    left.plot(*curve.columns("x", "y"), color=INK, linewidth=1.8, label="exact (Hertz)", zorder=3)
    left.plot(*CIRCLE, color=BLUE, linewidth=0.9)
    left.plot([0, 1], [1, 0], color=GREEN, linewidth=0.9)
    left.plot([0, 1, 1], [1, 1, 0], color=ORANGE, linewidth=0.9)
    ends = (min(row["c"] for row in exact if row["c"] > 0), max(row["c"] for row in exact if math.isfinite(row["c"])))
    for (engine, model), rows in drag.groups("engine", "model").items():
        marker, colour, filled = ENGINE_STYLES[f"{engine} {model}"]
        style = {"color": colour, "marker": marker, "markersize": 5.5, "clip_on": False,
                 "markerfacecolor": colour if filled else "none"}
        name = {"mujoco": "MuJoCo", "ode": "ODE", "bullet": "Bullet"}[engine]
        label = f"{name} {rows[0]['version'].removeprefix('PyBullet ')}, {model}"
        left.plot(*rows.columns("force", "moment"), linestyle="", label=label, zorder=4, **style)
        between = [row for row in rows if ends[0] <= row["c"] <= ends[1]]
        right.plot(
            [row["c"] for row in between],
            [math.hypot(row["force"] - row["exact_force"], row["moment"] - row["exact_moment"]) for row in between],
            linewidth=0.9,
            **style)
    quadrant(left, "Wrenches measured by dragging a finger", "force  $F/(\\mu P)$", "moment  $M/(m_0\\mu P a)$")
    left.set(xlim=(0, 1.08), ylim=(0, 1.08))
    left.set_aspect("equal", adjustable="box")
    quadrant(right, "Error at the same centre of rotation", "centre of rotation  $c/a$",
             "distance from the exact wrench, limits = 1")
    right.set(xscale="log", xlim=(0.9 * ends[0], 1.1 * ends[1]), ylim=(0, 1.1))
    only_ticks(right.xaxis, (0.1, 0.3, 1, 3))
    legend_in_sight(figure, left)
    return figure
