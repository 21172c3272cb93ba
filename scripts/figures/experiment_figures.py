# SPDX-License-Identifier: MIT
"""The report's figures of the paper's experiment (section 6), of Table 1 and of form closure. One function
each: takes the CSVs (see report.py for their columns), returns a figure."""

import math

from chart_style import BLUE, FAINT, GREEN, INK, ORANGE, VERMILION, legend_below, plt
from finger_figures import BLOCK_HEIGHT, BLOCK_LENGTH, CASES, LOST, angle_at_loss, draw_block, held_rows

# The part of the [r, rho] plane in the figure [N, mN m]: the operator's grip begins and ends at twice the load.
PLANES = {"release": (0.9, 5.4), "operator": (1.75, 10.6)}


def pivot(data):
    """Paper, Figs. 7 to 11: the grip is released slowly."""
    return experiment(data, "release")


def pivot_operator(data):
    """Paper, Figs. 7 to 11: an operator eases and tightens the grip, and regrips."""
    return experiment(data, "operator")


def experiment(data, grip):
    """For each case: poses of the block; x, y of its centre of mass and its angle against time; the repositioning in the [r, rho] plane."""
    figure, panels = plt.subplots(4, len(CASES), figsize=(9.6, 10.6), layout="constrained", sharex="row", sharey="row",
                                  height_ratios=(1.5, 1, 1, 1.5))
    sandpaper = data["materials"].where(material="sandpaper")[0]
    for (poses, place, angle, plane), (case, title) in zip(zip(*panels), CASES.items()):
        rows = data["pivot"].where(case=case, grip=grip)
        held = held_rows(rows)
        draw_block(poses, rows)
        poses.set(title=title, aspect="equal", xlim=(-80, 80), ylim=(-95, 55), xlabel="x  [mm]")
        times = held.column("time")
        place.plot(times, held.column("x", 1e3), color=BLUE, label="x")
        place.plot(times, held.column("y", 1e3), color=VERMILION, dashes=(5, 2), label="y")
        angle.plot(times, held.column("angle", 180 / math.pi), color=BLUE)
        if grip == "release":
            lost, time = angle_at_loss(rows)
            angle.plot(time, lost, "o", color=VERMILION, markersize=5, label=f"lost: has slid {1e3 * LOST:g} mm")
        angle.set_xlabel("time  [s]")
        draw_plane(plane, held, unit_curve(data, case), sandpaper, PLANES[grip])
    for row, label in zip(panels, ("y  [mm]", "centre of mass  [mm]", "angle α  [°]", "$k_r ρ$  [mN m]")):
        row[0].set_ylabel(label)
    panels[1][0].set_ylim(-25, 6)
    panels[2][0].set_ylim(-4, 60)
    figure.align_ylabels()
    panels[1][0].legend(loc="lower left", ncols=2)
    if grip == "release":
        panels[2][0].legend(loc="upper left")
    legend_plane(figure, panels[3][0], grip == "operator")
    return figure


def unit_curve(data, case):
    """The case's limit curve in the normalised plane, from pure moment to pure force."""
    if case == "coupled":
        return [(math.sin(step * math.pi / 120), math.cos(step * math.pi / 120)) for step in range(61)]
    if case == "uncoupled":
        return [(0, 1), (1, 1), (1, 0)]
    hertz = data["curves"].where(law="hertz")
    return list(zip(hertz.column("x"), hertz.column("y")))


SHOWN_STEPS = 9


def draw_plane(axes, held, unit, material, limits):
    """Fig. 9: trials (diamonds), their projections, the p-curves of both, and the p-curve of the final grip."""
    def p_curve(load, **look):
        axes.plot([material["mu"] * load * x for x, _ in unit], [1e3 * material["mu_r"] * load * y for _, y in unit], **look)

    # A block that falls out of the grip is far beyond it.
    slips = [row for row in held if row["state"] == "slip" and row["trial_r"] < limits[0]]
    last = slips[-1]
    chosen = slips[::max(1, len(slips) // SHOWN_STEPS)]
    for row in chosen:
        p_curve(row["load"], color="#c4c4c4", linewidth=0.8)
    if held[-1]["state"] == "stick" and held[-1]["load"] > last["load"]:
        # The grip grows until its p-curve lies outside the block's wrench.
        p_curve(held[-1]["load"], color=GREEN, linewidth=1.6, dashes=(6, 2))
    axes.plot(held.column("r"), held.column("rho", 1e3), color=FAINT, linewidth=0.9)
    for row in chosen:
        axes.plot([row["trial_r"], row["r"]], [1e3 * row["trial_rho"], 1e3 * row["rho"]], color=VERMILION, linewidth=0.9)
    axes.plot([row["trial_r"] for row in chosen], [1e3 * row["trial_rho"] for row in chosen], "D", color=INK, markersize=3.5)
    axes.plot([row["r"] for row in chosen], [1e3 * row["rho"] for row in chosen], "o", color=BLUE, markersize=3.5)
    axes.plot(held[0]["r"], 1e3 * held[0]["rho"], "s", color=INK, markersize=4.5)
    axes.set(xlabel="$k_l r$  [N]", xlim=(0, limits[0]), ylim=(0, limits[1]))


def legend_plane(figure, axes, regrips):
    looks = [({"marker": "s", "color": INK, "linestyle": "none", "markersize": 4.5}, "at rest, level"),
             ({"marker": "D", "color": INK, "linestyle": "none", "markersize": 3.5}, "trial"),
             ({"marker": "o", "color": BLUE, "linestyle": "none", "markersize": 3.5}, "after step b"),
             ({"color": "#c4c4c4"}, "p-curves")]
    if regrips:
        looks.append(({"color": GREEN, "dashes": (6, 2)}, "p-curve after regripping"))
    for look, label in looks:
        axes.plot([], [], label=label, **look)
    legend_below(figure, axes, 5)


def pivot_stiffness(data):
    """Rotation of the block before it leaves the fingers, against the twist stiffness, which the paper does not give."""
    figure, axes = plt.subplots(figsize=(6.4, 3.4), layout="constrained")
    looks = {"coupled": {"color": VERMILION, "dashes": (5, 2)}, "exact": {"color": BLUE}}
    for case, rows in data["pivot_stiffness"].groups("case").items():
        axes.plot(rows.column("ratio"), rows.column("angle", 180 / math.pi), marker="o", markersize=4, label=CASES[case], **looks[case])
    axes.set(xscale="log", xlabel="stiffness ratio  $k_r/(k_l (μ_r/μ_l)^2)$", ylabel="turned before it leaves  [°]", ylim=(0, 95))
    ticks = (0.1, 1, 10, 100)
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.axvline(1, color=FAINT, linewidth=0.8, dashes=(3, 3))
    axes.annotate("this project’s default", (1, 92), (4, -3), textcoords="offset points", color=FAINT, fontsize=8)
    axes.legend(loc="upper right")
    return figure


MATERIAL_LOOKS = {"sandpaper": {"color": BLUE}, "suede": {"color": ORANGE, "dashes": (5, 2)}, "rayon": {"color": GREEN, "dashes": (1.5, 1.5)}}


def one_ratio(data):
    """`fit ratio` of Table 1: the weighted mean and its standard error [m], chi squared and the p-value."""
    found = {row["parameter"]: row for row in data["fits"].where(data="materials")}
    return found["ratio"]["value"], found["ratio"]["std_error"], found["chi_squared"]["value"], found["p_value"]["value"]


def table_1(data):
    """Left: the published ratios and their weighted mean. Right: the block between fingers of each material."""
    figure, panels = plt.subplots(1, 1 + len(CASES), figsize=(9.6, 3.4), layout="constrained", width_ratios=(1.25, 1, 1, 1))
    left, rows = panels[0], data["table_1"]
    mean, error, chi_squared, p_value = one_ratio(data)
    left.axhspan(1e3 * (mean - error), 1e3 * (mean + error), color="#dcdcdc", linewidth=0)
    left.axhline(1e3 * mean, color=INK, linewidth=1.2)
    left.annotate(f"one for all: {1e3 * mean:.2f} ± {1e3 * error:.2f} mm\nχ² = {chi_squared:.2f}, p = {p_value:.2f}", (-0.4, 0.5), fontsize=8)
    for place, row in enumerate(rows):
        colour = MATERIAL_LOOKS[row["material"]]["color"]
        left.errorbar(place, 1e3 * row["ratio"], 1e3 * row["ratio_sd"], fmt="o", color=colour, capsize=3, markersize=5)
    left.set(title="Table 1: $μ_r/μ_l$, mean ± SD", ylabel="$μ_r/μ_l$  [mm]", xlim=(-0.5, 2.5), ylim=(0, 9.5))
    left.set_xticks(range(len(rows)), rows.column("material"))
    left.grid(False, axis="x")
    for axes, (case, title) in zip(panels[1:], CASES.items()):
        for material, part in data["pivot_materials"].where(case=case).groups("material").items():
            held = held_rows(part)
            # Over the load as a share of the first, for the loads that hold differ by four.
            axes.plot([row["load"] / held[0]["load"] for row in held], held.column("angle", 180 / math.pi), label=material, **MATERIAL_LOOKS[material])
        axes.set(title=title.replace(": ", ":\n"), xlim=(1, 0.5), ylim=(-3, 60), xlabel="load / first load")
        if axes is not panels[1]:
            axes.set_yticklabels([])
    panels[1].set_ylabel("angle  [°]")
    panels[1].legend(loc="upper left", fontsize=8, handlelength=2.4)
    return figure


def turn_of(row, prefix):
    """About z, of the quaternion prefix+w, …x, …y, …z [deg]."""
    return math.degrees(2 * math.atan2(row[f"{prefix}z"], row[f"{prefix}w"]))


def pinch(data):
    """Form closure by two fingers that carry and turn a block, with and without a friction moment."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.6, 3.2), layout="constrained", width_ratios=(1.25, 1))
    trace = data["pinch_trace"]
    right.plot(trace.column("time"), [turn_of(row, "q") for row in trace], color=INK, dashes=(4, 2), label="the fingers")
    for friction, colour, label in (("soft", BLUE, "soft fingers"), ("point", VERMILION, "point fingers ($μ_r = 0$)")):
        rows = data["pinch"].where(friction=friction)
        right.plot(rows.column("time"), [turn_of(row, "bq") for row in rows], color=colour, label=label)
        for i, row in enumerate((rows[0], rows[len(rows) // 2], rows[-1])):
            angle = math.radians(turn_of(row, "bq"))
            outline = [(60 * x * math.cos(angle) - 20 * y * math.sin(angle) + 1e3 * row["bx"],
                        60 * x * math.sin(angle) + 20 * y * math.cos(angle) + 1e3 * row["by"])
                       for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))]
            left.plot(*zip(*outline), color=colour, linewidth=0.7 + 0.6 * i, alpha=0.35 + 0.32 * i)
    ends = (trace[0], trace[-1])
    left.plot([1e3 * row["x"] for row in ends], [1e3 * row["y"] for row in ends], "o", color=INK, markersize=5)
    left.set(title="Seen along the fingers (dots): begin, middle, end", aspect="equal", xlabel="x  [mm]", ylabel="y  [mm]")
    right.set(title="Turned about the fingers", xlabel="time  [s]", ylabel="angle  [°]")
    right.legend(loc="upper left")
    return figure


def section(data):
    """The report's section on the experiment: heading, figures with captions, conclusions."""
    sandpaper = data["table_1"].where(material="sandpaper")[0]
    turned = {case: angle_at_loss(rows)[0] for case, rows in data["pivot"].where(grip="release").groups("case").items()}
    lost = f"{1e3 * LOST:g} mm"
    kept = {case: rows[-1] for case, rows in data["pivot"].where(grip="operator").groups("case").items()}
    offset = -1e3 * data["pivot"][0]["x"]
    scan = {case: dict(zip(rows.column("ratio"), rows.column("angle", 180 / math.pi)))
            for case, rows in data["pivot_stiffness"].groups("case").items()}
    soft, softest, stiff = 1, min(scan["coupled"]), max(scan["coupled"])
    mean, error, _, p_value = one_ratio(data)
    level, above = offset, 7
    farthest = max(data["pivot_map"].where(case="uncoupled", offset=1e-3 * above).column("angle", 180 / math.pi))
    turn = {friction: turn_of(rows[-1], "bq") for friction, rows in data["pinch"].groups("friction").items()}
    return ("A block between two fingers", [
        ("pivot", "The paper’s experiment (its Figs. 7 to 11): a block, its centre of mass beside the grip, on sandpaper; the grip eases. Where force and moment share one limit the block "
         f"turns before it is lost: by {turned['coupled']:.1f}° and {turned['exact']:.1f}° when it has slid {lost} past the grip (dots), with limits of their own by "
         f"{abs(turned['uncoupled']):.1f}°. Bottom: the [r, ρ] plane of one finger. From the paper are the friction, the cases and the level start; the block "
         f"({1e3 * BLOCK_LENGTH:.0f} × {1e3 * BLOCK_HEIGHT:.0f} mm, 0.1 kg, {offset:.0f} mm off), springs, dampers and the time step are ours.",
         "limits that know of each other, or the object slides out level."),
        ("pivot_operator", "An operator eases until the block turns, and regrips at 30°. He stops it at "
         f"{math.degrees(kept['coupled']['angle']):.1f}° (A, coupled) and {math.degrees(kept['exact']['angle']):.1f}° (exact); with limits of their own (B) it is kept, "
         f"{1e3 * kept['uncoupled']['grip_slip']:.1f} mm lower and level.", "coupled limits, where easing the grip is to turn an object."),
        ("pivot_stiffness", f"The paper does not give the stiffness of the twist’s spring. With the radial projection the block turns by {scan['coupled'][softest]:.0f}° to "
         f"{scan['coupled'][stiff]:.1f}° (ratios {softest:g} to {stiff:g}), with the closest point by {min(scan['exact'].values()):.0f}° to {max(scan['exact'].values()):.0f}°.",
         f"the closest point, or a ratio near {soft}."),
        ("pivot_map", f"The block’s angle when it has slid {lost} past the grip and is lost, over the offset of its centre of mass and the rate of the grip, both ours. With limits of "
         f"their own it turns only where the offset exceeds μ<sub>r</sub>/μ = {1e3 * sandpaper['mu_r'] / sandpaper['mu']:.2f} mm (triangles): at {level:g} mm it slides out level, at "
         f"{above:g} mm it turns by up to {farthest:.0f}°.", "state the offset when you compare such experiments."),
        ("table_1", f"Left: by the paper’s Table 1 one ratio μ<sub>r</sub>/μ of {1e3 * mean:.2f} ± {1e3 * error:.2f} mm explains three materials (p = {p_value:.2f}: the data do not speak "
         "against it). Right: with one ratio their blocks move alike.", "one measured ratio, as a start, for any material of the object."),
        ("pinch", f"Two soft fingers carry a block and turn it by {turn['soft']:.1f}° of {turn_of(data['pinch_trace'][-1], 'q'):.1f}°; without a friction moment by "
         f"{abs(turn['point']):.1f}°.", "a soft contact, where two fingers must turn an object."),
    ], "")
