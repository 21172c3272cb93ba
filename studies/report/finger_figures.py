# SPDX-License-Identifier: MIT
"""The report's figures of the god-object: on traces, at a steady twist, and with a block between two fingers. One function
each: takes the CSVs (see csv_files.py for their columns), returns a figure."""

import math

from .chart_style import BLUE, FAINT, INK, VERMILION, legend_in_sight, mark_ratios, plt, quadrant

def repositionings(rows, run):
    """Per step the trial point [r, rho] before, and the point after repositioning (m, rad), recomputed from the log."""
    steps = []
    for before, here in zip(rows, rows[1:]):
        if here["load"] <= 0 or before["load"] <= 0:
            continue
        goal_x, goal_y = here["px"] - here["fx"] / run["stiffness"], here["py"] - here["fy"] / run["stiffness"]
        goal_angle = here["angle"] - here["moment"] / run["twist_stiffness"]
        steps.append({
            "state": here["state"],
            "load": here["load"],
            "trial": (math.hypot(before["px"] - goal_x, before["py"] - goal_y), abs(before["angle"] - goal_angle)),
            "new": (math.hypot(here["fx"], here["fy"]) / run["stiffness"], abs(here["moment"]) / run["twist_stiffness"]),
        })
    return steps


TITLES = {"ellipse": "Ellipse, radial (the paper's)", "table": "Exact curve, closest point"}
TRACE_TITLES = {"press_drag_release": "press, drag, release", "press_twist_release": "press, twist, release",
                "slide_twist_load": "slide and twist, load falls and rises"}


def god_object(data):
    """Paper, Figs. 5 and 9: the god-object in the [r, rho] plane on each trace, for ellipse and exact curve."""
    traces = list(data["replay"].groups("trace"))
    boundaries = list(data["replay"].groups("boundary"))
    figure, panels = plt.subplots(len(boundaries), len(traces), figsize=(9.6, 3.1 * len(boundaries)), layout="constrained",
                                  sharex=True, sharey=True)
    for across, trace in enumerate(traces):
        run = data["replay_runs"].where(trace=trace)[0]
        for down, boundary in enumerate(boundaries):
            axes = panels[down][across]
            for load, rows in data["replay_limits"].where(trace=trace, boundary=boundary).groups("load").items():
                rho = rows.column("moment", 1 / run["twist_stiffness"])
                axes.plot(rows.column("force", 1e3 / run["stiffness"]), rho, color="#c4c4c4", linewidth=0.9)
                axes.annotate(f"{load:g} N", (0, max(rho)), (4, 2), textcoords="offset points", color=FAINT, fontsize=7)
            steps = repositionings(data["replay"].where(trace=trace, boundary=boundary), run)
            draw_steps(axes, steps)
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


def draw_steps(axes, steps):
    """The path of the repositioned point, one line for each stretch of one state."""
    begin = 0
    for i in range(1, len(steps) + 1):
        if i == len(steps) or steps[i]["state"] != steps[begin]["state"]:
            path = [steps[j]["new"] for j in range(max(begin - 1, 0), i)]
            slips_here = steps[begin]["state"] == "slip"
            axes.plot([1e3 * r for r, _ in path], [rho for _, rho in path], color=BLUE if slips_here else FAINT,
                      linewidth=1.8 if slips_here else 1.1, solid_capstyle="round")
            begin = i


LENS_STEPS, LENS_STRIDE = 6, 5


def repositioning(data):
    """Paper, Fig. 5: single steps of a slip while the load falls, magnified; every fifth step, so that they are separate."""
    trace = list(data["replay"].groups("trace"))[-1]
    run = data["replay_runs"].where(trace=trace)[0]
    boundaries = list(data["replay"].groups("boundary"))
    figure, panels = plt.subplots(1, len(boundaries), figsize=(9.6, 4.4), layout="constrained")
    for axes, boundary in zip(panels, boundaries):
        rows = data["replay"].where(trace=trace, boundary=boundary)
        steps = repositionings(rows, run)
        start = falling_load(steps)
        shown = steps[start:start + LENS_STEPS * LENS_STRIDE:LENS_STRIDE]
        limits = data["replay_limits"].where(trace=trace, boundary=boundary).groups("load")
        largest = max(limits)
        for step in shown:
            scale = step["load"] / largest
            grown = scale ** (1 + radius_exponent(run["radius_law"]))
            axes.plot(limits[largest].column("force", 1e6 * scale / run["stiffness"]),
                      limits[largest].column("moment", 1e3 * grown / run["twist_stiffness"]), color="#c4c4c4", linewidth=0.9)
            (r, rho), (new_r, new_rho) = step["trial"], step["new"]
            axes.plot([1e6 * r, 1e6 * new_r], [1e3 * rho, 1e3 * new_rho], color=INK, linewidth=0.9)
            axes.plot(1e6 * r, 1e3 * rho, "D", color=INK, markersize=4)
            axes.plot(1e6 * new_r, 1e3 * new_rho, "o", color=BLUE, markersize=4.5)
        # One scale for both axes in the metric of the springs' energy, in which the closest point lies at a right angle.
        equal = math.sqrt(run["twist_stiffness"] / run["stiffness"]) * 1e3
        across = [1e6 * point[0] for step in shown for point in (step["trial"], step["new"])]
        along = [1e3 * point[1] for step in shown for point in (step["trial"], step["new"])]
        half = 0.62 * max(max(across) - min(across), (max(along) - min(along)) * equal)
        middle = (0.5 * (max(across) + min(across)), max(0.5 * (max(along) + min(along)), half / equal))
        axes.set(title=TITLES.get(boundary, boundary), xlabel="r  [µm]", ylabel="ρ  [mrad]", aspect=equal,
                 xlim=(middle[0] - half, middle[0] + half), ylim=(middle[1] - half / equal, middle[1] + half / equal))
    panels[0].plot([], [], "D", color=INK, markersize=4, label="goal has moved: before repositioning")
    panels[0].plot([], [], "o", color=BLUE, markersize=4.5, label="god-object moved on to the p-curve")
    panels[0].plot([], [], color="#c4c4c4", label="p-curve of each step's load")
    legend_in_sight(figure, panels[0])
    return figure


def falling_load(steps):
    """Index of the first step of the slip in the middle of the longest fall of the load while slipping."""
    best, longest, begin = 0, 0, None
    for i in range(1, len(steps)):
        falls = steps[i]["state"] == "slip" and steps[i]["load"] < steps[i - 1]["load"]
        if falls and begin is None:
            begin = i
        if begin is not None and not falls:
            if i - begin > longest and min(steps[begin]["new"]) > 0:
                best, longest = (begin + i - LENS_STEPS * LENS_STRIDE) // 2, i - begin
            begin = None
    return best


def radius_exponent(text):
    kind, _, parameters = text.partition(":")
    if kind == "power":
        return float(dict(item.split("=") for item in parameters.split(","))["gamma"])
    return {"constant": 0.0, "hertz": 1 / 3}[kind]


def felt(data):
    """Rendered force and moment against time on each trace, for ellipse and exact curve."""
    traces = list(data["replay"].groups("trace"))
    figure, panels = plt.subplots(3, len(traces), figsize=(9.6, 5.2), layout="constrained", sharex="col", sharey="row",
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
            column[1].plot(times, [math.hypot(row["fx"], row["fy"]) for row in rows], label=TITLES.get(boundary, boundary), **look)
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
    """Intervals of time in which the state is slip."""
    begin, intervals = None, []
    for row in rows:
        if row["state"] == "slip" and begin is None:
            begin = row["time"]
        elif row["state"] != "slip" and begin is not None:
            intervals.append((begin, row["time"]))
            begin = None
    return intervals + ([(begin, rows[-1]["time"])] if begin is not None else [])


BLOCK_LENGTH, BLOCK_HEIGHT = 0.12, 0.04  # m, `limitcurve pivot`'s default
CASES = {"coupled": "Coupled: ellipse, radial (A)", "exact": "Exact curve, closest point", "uncoupled": "Uncoupled: box (B)"}


LOST = 0.005  # m: a block that has slid so far past the grip, or has left it, is lost


def angle_at_loss(rows):
    """By how much the block has turned [°] when it is lost, and when that is [s]; linear between rows. Of a block that stays: at the end."""
    for before, row in zip(rows, rows[1:]):
        if row["state"] == "free":
            return math.degrees(before["angle"]), before["time"]
        if row["grip_slip"] >= LOST:
            share = (LOST - before["grip_slip"]) / (row["grip_slip"] - before["grip_slip"])
            return tuple(scale * (before[name] + share * (row[name] - before[name])) for name, scale in (("angle", 180 / math.pi), ("time", 1)))
    return math.degrees(rows[-1]["angle"]), rows[-1]["time"]


def held_rows(rows):
    """The rows until the block has left the fingers."""
    end = next((i for i, row in enumerate(rows) if row["state"] == "free"), len(rows))
    return type(rows)(rows[:end])


def draw_block(axes, rows):
    """Outlines of the block each time it has turned or slid visibly on: darker is later."""
    held = held_rows(rows)
    shown = [held[0]]
    for row in held:
        if abs(row["angle"] - shown[-1]["angle"]) > 0.2 or row["grip_slip"] - shown[-1]["grip_slip"] > 0.006:
            shown.append(row)
    for i, row in enumerate(shown):
        shade = str(0.82 - 0.7 * i / max(len(shown) - 1, 1))
        cosine, sine = math.cos(row["angle"]), math.sin(row["angle"])
        corners = [(x * BLOCK_LENGTH / 2, y * BLOCK_HEIGHT / 2) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))]
        axes.plot([1e3 * (row["x"] + x * cosine - y * sine) for x, y in corners],
                  [1e3 * (row["y"] + x * sine + y * cosine) for x, y in corners], color=shade, linewidth=1.1)
        axes.annotate(f"{row['time']:.1f} s", [1e3 * place for place in (row["x"] - 0.06 * cosine - 0.02 * sine, row["y"] - 0.06 * sine + 0.02 * cosine)],
                      (-3, 0), textcoords="offset points", fontsize=8, color=INK, ha="right", va="center")
    axes.plot([1e3 * row["x"] for row in held], [1e3 * row["y"] for row in held], color=BLUE, linewidth=1.6)
    axes.plot(0, 0, "o", color=VERMILION, markersize=6)


def pivot_map(data):
    """How far the block has turned when it is lost, over the centre of mass's offset and the rate of release."""
    figure, panels = plt.subplots(1, len(CASES), figsize=(9.6, 3.4), layout="constrained", sharey=True)
    rows = data["pivot_map"]
    offsets, rates = sorted(rows.groups("offset")), sorted(rows.groups("rate"))
    sandpaper = data["materials"].where(material="sandpaper")[0]
    for axes, (case, title) in zip(panels, CASES.items()):
        angles = {(row["offset"], row["rate"]): math.degrees(row["angle"]) for row in rows.where(case=case)}
        grid = [[angles[offset, rate] for offset in offsets] for rate in rates]
        picture = axes.pcolormesh([1e3 * offset for offset in offsets], rates, grid, vmin=0, vmax=90, cmap="cividis", shading="nearest",
                                  edgecolors="face")
        for (offset, rate), angle in angles.items():
            axes.annotate(f"{abs(angle):.0f}", (1e3 * offset, rate), ha="center", va="center", fontsize=6.5,
                          color="white" if angle < 50 else INK)
        # Up to this offset the uncoupled limits hold the moment to the end.
        for edge, marker in ((0, "^"), (1, "v")):
            axes.plot(1e3 * sandpaper["mu_r"] / sandpaper["mu"], edge, marker, color=VERMILION, markersize=6, clip_on=False,
                      transform=axes.get_xaxis_transform())
        axes.set(title=title, yscale="log", xlabel="offset of the centre of mass  [mm]")
        axes.grid(False)
        axes.set_yticks(rates, [f"{rate:g}" for rate in rates])
        axes.minorticks_off()
    panels[0].set_ylabel("release  [N/s]")
    bar = figure.colorbar(picture, ax=panels, ticks=(0, 30, 60, 90), pad=0.02)
    bar.set_label("turned by  [°]")
    return figure


TWIST_LOOKS = {
    ("table", "closest-point"): ("exact curve, closest point", {"color": BLUE, "linewidth": 2.2}),
    ("table", "radial"): ("exact curve, radial", {"color": VERMILION}),
    ("ellipse", "closest-point"): ("ellipse, closest point", {"color": BLUE, "dashes": (5, 3)}),
    ("ellipse", "radial"): ("ellipse, radial (the paper's)", {"color": VERMILION, "dashes": (5, 3)}),
}


def steady_twist(data):
    """Driven long at a constant twist: the error of the wrench over the stiffness ratio, and where it settles on the curve."""
    rows = data["steady_twist"]
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.6, 4.3), layout="constrained", width_ratios=(1.18, 1))
    for key, part in rows.groups("boundary", "projection").items():
        label, look = TWIST_LOOKS[key]
        left.plot(part.column("stiffness_ratio"), part.column("error", 100), label=label, **look)
    left.set(title=f"Error of the steady wrench [%], {rows[0]['law']}, c = {rows[0]['cor']:g} a", xscale="log", xlabel="stiffness ratio  κ = $k_r/(k_l m_0^2 a^2)$", ylim=(-3, None))
    left.set_xlim(min(rows.column("stiffness_ratio")), max(rows.column("stiffness_ratio")))
    ratios = (0.1, 0.2, 0.5, 1, 2, 5, 10)
    left.set_xticks(ratios, [f"{ratio:g}" for ratio in ratios])
    left.minorticks_off()
    left.legend(loc="upper left", bbox_to_anchor=(0, 0.86), handlelength=3)
    mark_ratios(left)

    law = rows[0]["law"]
    curve = data["curves"].where(law=law)
    moment_ratio = data["laws"].where(law=law)[0]["moment_ratio"]
    right.plot(curve.column("x"), curve.column("y"), color=FAINT, linewidth=1.2)
    radial = rows.where(boundary="table", projection="radial")
    right.plot(radial.column("force"), radial.column("moment", 1 / moment_ratio), color=VERMILION, linewidth=2.2)
    for ratio in (0.1, 0.5, 1, 2.88, 10):
        row = min(radial, key=lambda one: abs(math.log(one["stiffness_ratio"] / ratio)))
        point = (row["force"], row["moment"] / moment_ratio)
        right.plot(*point, "o", color=VERMILION, markersize=4)
        beside = {"xytext": (-8, -4), "ha": "right"} if point[0] > 0.3 else {"xytext": (-1, -14), "ha": "center"}
        right.annotate(f"κ = {ratio:g}", point, textcoords="offset points", color=VERMILION, fontsize=8, **beside)
    truth = (rows[0]["exact_force"], rows[0]["exact_moment"] / moment_ratio)
    right.plot(*truth, "o", color=BLUE, markersize=7)
    right.annotate("closest point:\nevery κ", truth, (6, 3), textcoords="offset points", color=BLUE, fontsize=8.5)
    quadrant(right, "Where the wrench settles", "force  $F/(μP)$", "moment  $M/Γ$")
    right.set(xlim=(0, 1.24), ylim=(0, 1.1), aspect="equal")
    return figure
