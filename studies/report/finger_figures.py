# SPDX-License-Identifier: MIT
"""The report's figures of the god-object: on traces and at a steady twist."""

import math

from .chart_style import (BLUE, FAINT, INK, VERMILION, legend_in_sight, mark_ratios, note, only_ticks, pair, plt,
                          quadrant)

TITLES = {"ellipse": "Ellipse, radial (the paper's)", "table": "Exact curve, closest point"}
TRACE_TITLES = {"press_drag_release": "press, drag, release", "press_twist_release": "press, twist, release",
                "slide_twist_load": "slide and twist, load falls and rises"}


def god_object(data):
    """Paper, Figs. 5 and 9: the god-object in the [r, rho] plane on each trace, for ellipse and exact curve."""
    traces = list(data["replay"].groups("trace"))
    boundaries = list(data["replay"].groups("boundary"))
    run = data["replay_run"][0]
    figure, panels = plt.subplots(len(boundaries),
                                  len(traces),
                                  figsize=(9.6, 3.1 * len(boundaries)),
                                  sharex=True,
                                  sharey=True)
    for across, trace in enumerate(traces):
        for down, boundary in enumerate(boundaries):
            axes = panels[down][across]
            for load, rows in data["replay_limits"].where(boundary=boundary).groups("load").items():
                rho = rows.column("moment", 1 / run["twist_stiffness"])
                axes.plot(rows.column("force", 1e3 / run["stiffness"]), rho, color="#c4c4c4", linewidth=0.9)
                note(axes, f"{load:g} N", (0, max(rho)), (4, 2), color=FAINT, fontsize=7)
            draw_steps(axes, data["replay"].where(trace=trace, boundary=boundary), run)
            if down == 0:
                axes.set_title(TRACE_TITLES.get(trace, trace))
            axes.set(xlim=(-0.03, None), ylim=(-0.01, None))
            if across == 0:
                axes.set_ylabel(f"{TITLES.get(boundary, boundary)}\nρ  [rad]")
            if down == len(boundaries) - 1:
                axes.set_xlabel("r  [mm]")
    for state, colour in (("stick", FAINT), ("slip", BLUE)):
        panels[0][0].plot([], [], color=colour, linewidth=2, label=state)
    panels[0][0].plot([], [], color="#c4c4c4", label="p-curves")
    legend_in_sight(figure, panels[0][0])
    return figure


def draw_steps(axes, rows, run):
    """The path of the springs' deflection while they touch, one line for each stretch of one state."""
    rows = [row for row in rows if row["load"] > 0]
    begin = 0
    for i in range(1, len(rows) + 1):
        if i == len(rows) or rows[i]["state"] != rows[begin]["state"]:
            path = rows[max(begin - 1, 0):i]
            slips_here = rows[begin]["state"] == "slip"
            axes.plot([1e3 * math.hypot(row["fx"], row["fy"]) / run["stiffness"] for row in path],
                      [abs(row["moment"]) / run["twist_stiffness"] for row in path],
                      color=BLUE if slips_here else FAINT,
                      linewidth=1.8 if slips_here else 1.1,
                      solid_capstyle="round")
            begin = i


def felt(data):
    traces = list(data["replay"].groups("trace"))
    figure, panels = plt.subplots(3, len(traces), figsize=(9.6, 5.2), sharex="col", sharey="row",
                                  height_ratios=(0.6, 1, 1))
    looks = {"ellipse": {"color": INK, "dashes": (4, 2), "linewidth": 1.1}, "table": {"color": BLUE, "linewidth": 1.6}}
    for column, trace in zip(zip(*panels), traces):
        for boundary, rows in data["replay"].where(trace=trace).groups("boundary").items():
            look = looks.get(boundary, {"color": FAINT})
            times = rows.column("time")
            if boundary != "ellipse":
                column[0].plot(times, rows.column("load"), color=INK, linewidth=1.1)
                for begin, end in slips(rows):
                    for axes in column:
                        axes.axvspan(begin, end, color=BLUE, alpha=0.07, linewidth=0)
            column[1].plot(times, [math.hypot(row["fx"], row["fy"]) for row in rows],
                           label=TITLES.get(boundary, boundary),
                           **look)
            column[2].plot(times, [1e3 * abs(row["moment"]) for row in rows], **look)
        column[0].set_title(TRACE_TITLES.get(trace, trace))
        column[2].set_xlabel("time  [s]")
        for axes in column:
            axes.margins(x=0)
            axes.xaxis.set_major_locator(plt.MultipleLocator(0.5))
    panels[0][0].yaxis.set_major_locator(plt.MultipleLocator(1))
    for axes, label in zip((row[0] for row in panels), ("load  [N]", "force  [N]", "moment  [N mm]")):
        axes.set_ylabel(label)
        axes.set_ylim(0, None)
    figure.align_ylabels(panels[:, 0])
    legend_in_sight(figure, panels[1][0])
    return figure


def slips(rows):
    begin, intervals = None, []
    for row in rows:
        if row["state"] == "slip" and begin is None:
            begin = row["time"]
        elif row["state"] != "slip" and begin is not None:
            intervals.append((begin, row["time"]))
            begin = None
    return intervals + ([(begin, rows[-1]["time"])] if begin is not None else [])


TWIST_LOOKS = {
    ("table", "closest-point"): ("exact curve, closest point", {"color": BLUE, "linewidth": 2.2}),
    ("table", "radial"): ("exact curve, radial", {"color": VERMILION}),
    ("ellipse", "closest-point"): ("ellipse, closest point", {"color": BLUE, "dashes": (5, 3)}),
    ("ellipse", "radial"): ("ellipse, radial (the paper's)", {"color": VERMILION, "dashes": (5, 3)}),
}


def steady_twist(data):
    rows = data["steady_twist"]
    figure, (left, right) = pair(4.3, width_ratios=(1.18, 1))
    for key, part in rows.groups("boundary", "projection").items():
        label, look = TWIST_LOOKS[key]
        left.plot(part.column("stiffness_ratio"), part.column("error", 100), label=label, **look)
    left.set(title=f"Error of the steady wrench [%], {rows[0]['law']}, c = {rows[0]['cor']:g} a",
             xscale="log",
             xlabel="stiffness ratio  κ = $k_r/(k_l m_0^2 a^2)$",
             ylim=(-3, None))
    left.set_xlim(min(rows.column("stiffness_ratio")), max(rows.column("stiffness_ratio")))
    only_ticks(left.xaxis, (0.1, 0.2, 0.5, 1, 2, 5, 10))
    left.legend(loc="upper left", bbox_to_anchor=(0, 0.86), handlelength=3)
    mark_ratios(left)

    law = rows[0]["law"]
    curve = data["curves"].where(law=law)
    moment_ratio = data["laws"].where(law=law)[0]["moment_ratio"]
    right.plot(*curve.columns("x", "y"), color=FAINT, linewidth=1.2)
    radial = rows.where(boundary="table", projection="radial")
    right.plot(radial.column("force"), radial.column("moment", 1 / moment_ratio), color=VERMILION, linewidth=2.2)
    for ratio in (0.1, 0.5, 1, 2.88, 10):
        row = min(radial, key=lambda one: abs(math.log(one["stiffness_ratio"] / ratio)))
        point = (row["force"], row["moment"] / moment_ratio)
        right.plot(*point, "o", color=VERMILION, markersize=4)
        offset, side = ((-8, -4), "right") if point[0] > 0.3 else ((-1, -14), "center")
        note(right, f"κ = {ratio:g}", point, offset, color=VERMILION, ha=side)
    truth = (rows[0]["exact_force"], rows[0]["exact_moment"] / moment_ratio)
    right.plot(*truth, "o", color=BLUE, markersize=7)
    note(right, "closest point:\nevery κ", truth, (6, 3), color=BLUE, fontsize=8.5)
    quadrant(right, "Where the wrench settles", "force  $F/(μP)$", "moment  $M/Γ$")
    right.set(xlim=(0, 1.24), ylim=(0, 1.1), aspect="equal")
    return figure
