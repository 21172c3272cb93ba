# SPDX-License-Identifier: MIT
"""The report's figures of the paper's experiment (section 6), of Table 1 and of force closure. One function
each: takes the CSVs (see csv_files.py for their columns), returns a figure."""

import math

from .chart_style import BLUE, FAINT, GREEN, INK, ORANGE, VERMILION, legend_in_sight, mark_ratios, plt
from .finger_figures import BLOCK_HEIGHT, BLOCK_LENGTH, CASES, LOST, angle_at_loss, draw_block, held_rows

def pivot(data):
    """Paper, Figs. 7 to 11: the grip is released slowly."""
    return experiment(data, "release")


def pivot_operator(data):
    """Paper, Figs. 7 to 11: an operator eases and tightens the grip, and regrips."""
    return experiment(data, "operator")


def experiment(data, grip):
    """For each case: poses of the block; x, y of its centre of mass, its angle, the load of a finger and the slip's COR against time; the
    god-object in the [r, rho] plane."""
    figure, panels = plt.subplots(6, len(CASES), figsize=(9.6, 14), layout="constrained", sharex="row", sharey="row",
                                  height_ratios=(1.5, 1, 1, 0.6, 0.8, 1.5))
    sandpaper = data["materials"].where(material="sandpaper")[0]
    for (poses, place, angle, load, cor, plane), (case, title) in zip(zip(*panels), CASES.items()):
        rows = data["pivot"].where(case=case, grip=grip)
        held = held_rows(rows)
        draw_block(poses, rows)
        poses.set(title=title, aspect="equal", xlim=(-95, 75), ylim=(-95, 55), xlabel="x  [mm]")
        times = held.column("time")
        place.plot(times, held.column("x", 1e3), color=BLUE, label="x")
        place.plot(times, held.column("y", 1e3), color=VERMILION, dashes=(5, 2), label="y")
        angle.plot(times, held.column("angle", 180 / math.pi), color=BLUE)
        load.plot(times, held.column("load"), color=INK, linewidth=1.1)
        if grip == "release":
            lost, time = angle_at_loss(rows)
            angle.plot(time, lost, "o", color=VERMILION, markersize=5, label=f"lost: has slid {1e3 * LOST:g} mm")
        cor.plot(times, held.column("cor", 1e3), color=BLUE, linewidth=1.1)
        cor.set(xlabel="time  [s]", yscale="log", ylim=(5, 200), xlim=angle.get_xlim())
        draw_plane(plane, held, unit_curve(data, case), sandpaper)
    for row, label in zip(panels, ("y  [mm]", "centre of mass  [mm]", "angle α  [°]", "load  [N]", "COR of the slip c  [mm]", "ρ  [mrad]")):
        row[0].set_ylabel(label)
    panels[1][0].set_ylim(-25, 6)
    panels[2][0].set_ylim(-4, 60)
    panels[3][0].set_ylim(0, None)
    figure.align_ylabels(panels[:, 0])
    panels[1][0].legend(loc="lower left", ncols=2)
    if grip == "release":
        panels[2][0].legend(loc="upper left")
    legend_plane(figure, panels[5][0], grip == "operator")
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
FASTEST = 3e-5  # m in a step of 1 ms: a block that falls out of the grip is faster
STIFFNESS = 1000.0  # k_l [N/m], `limitcurve pivot`'s default; k_r = k_l (mu_r/mu)^2


def draw_plane(axes, held, unit, material):
    """Fig. 9: the god-object before (diamonds) and after step b, their p-curves, that of the final grip; without one, one step magnified."""
    twist_stiffness = STIFFNESS * (material["mu_r"] / material["mu"]) ** 2

    def p_curve(where, load, **look):
        where.plot([1e6 * material["mu"] * load * x / STIFFNESS for x, _ in unit],
                   [1e3 * material["mu_r"] * load * y / twist_stiffness for _, y in unit], **look)

    slips = [row for row in held if row["state"] == "slip" and math.hypot(row["trial_r"] - row["r"], 6e-3 * (row["trial_rho"] - row["rho"])) < FASTEST]
    chosen = slips[::max(1, len(slips) // SHOWN_STEPS)]

    def steps(where, shown, **look):
        for row in shown:
            p_curve(where, row["load"], color="#c4c4c4", **look)
            where.plot([1e6 * row["trial_r"], 1e6 * row["r"]], [1e3 * row["trial_rho"], 1e3 * row["rho"]], color=VERMILION, linewidth=0.9)
        where.plot([1e6 * row["trial_r"] for row in shown], [1e3 * row["trial_rho"] for row in shown], "D", color=INK, markersize=3.5)
        where.plot([1e6 * row["r"] for row in shown], [1e3 * row["rho"] for row in shown], "o", color=BLUE, markersize=3.5)

    steps(axes, chosen, linewidth=0.8)
    axes.plot(held.column("r", 1e6), held.column("rho", 1e3), color=FAINT, linewidth=0.9)
    if held[-1]["state"] == "stick" and held[-1]["load"] > slips[-1]["load"]:
        # The grip grows until its p-curve lies outside the god-object.
        p_curve(axes, held[-1]["load"], color=GREEN, linewidth=1.6, dashes=(6, 2))
    else:  # With dampers, as the operator's, the springs alone are not on the p-curve.
        middle = chosen[len(chosen) // 2]
        lens = axes.inset_axes((0.18, 0.14, 0.45, 0.45))
        half = 1.2 * max(1e6 * abs(middle["trial_r"] - middle["r"]), 1e3 * 6 * abs(middle["trial_rho"] - middle["rho"]), 1)
        lens.set(xlim=(1e6 * middle["r"] - half, 1e6 * middle["r"] + half), ylim=(1e3 * middle["rho"] - half / 6, 1e3 * middle["rho"] + half / 6))
        lens.tick_params(labelsize=8)
        lens.grid(False)
        steps(lens, [middle], linewidth=1.6)
        for spine in lens.spines.values():
            spine.set(visible=True, color=FAINT)
    axes.plot(1e6 * held[0]["r"], 1e3 * held[0]["rho"], "s", color=INK, markersize=4.5)
    largest = max(chosen[0]["load"], held[-1]["load"] if held[-1]["state"] == "stick" else 0)
    axes.set(xlabel="r  [µm]", xlim=(0, 1.1e6 * material["mu"] * largest / STIFFNESS), ylim=(0, 1.1e3 * material["mu_r"] * largest / twist_stiffness))


def legend_plane(figure, axes, regrips):
    looks = [({"marker": "s", "color": INK, "linestyle": "none", "markersize": 4.5}, "at rest, level"),
             ({"marker": "D", "color": INK, "linestyle": "none", "markersize": 3.5}, "before step b"),
             ({"marker": "o", "color": BLUE, "linestyle": "none", "markersize": 3.5}, "after step b"),
             ({"color": "#c4c4c4"}, "p-curves")]
    if regrips:
        looks.append(({"color": GREEN, "dashes": (6, 2)}, "p-curve after regripping"))
    for look, label in looks:
        axes.plot([], [], label=label, **look)
    legend_in_sight(figure, axes)


def pivot_offsets(data):
    """What an operator achieves over the offset of the centre of mass: angle, slip, how often it turned back; a column for each material."""
    materials = data["pivot_offsets"].groups("material")
    looks = {"coupled": {"color": VERMILION, "dashes": (5, 2)}, "exact": {"color": BLUE}, "uncoupled": {"color": INK, "dashes": (1.5, 1.5)}}
    figure, panels = plt.subplots(3, len(materials), figsize=(9.6, 6.6), layout="constrained", sharex=True, sharey="row")
    for (turned, slid, back), (material, part) in zip(zip(*panels), materials.items()):
        numbers = data["table_1"].where(material=material)[0]
        for case, rows in part.groups("case").items():
            offsets = rows.column("offset", 1e3)
            turned.plot(offsets, rows.column("angle", 180 / math.pi), marker="o", markersize=3, label=CASES[case], **looks[case])
            slid.plot(offsets, rows.column("grip_slip", 1e3), marker="o", markersize=3, **looks[case])
            back.plot(offsets, rows.column("turned_back"), marker="o", markersize=3, **looks[case])
        for axes in (turned, slid, back):
            axes.axvline(1e3 * numbers["mu_r"] / numbers["mu"], color=FAINT, linewidth=0.8, dashes=(3, 3))
        turned.set_title(material)
        back.set_xlabel("offset of the centre of mass  [mm]")
    for row, label in zip(panels, ("angle reached  [°]", "slipped  [mm]", "times turned back")):
        row[0].set_ylabel(label)
    figure.align_ylabels(panels[:, 0])
    legend_in_sight(figure, panels[0][0])
    return figure


def pivot_stiffness(data):
    """Rotation of the block before it leaves the fingers, against the twist stiffness, which the paper does not give."""
    figure, axes = plt.subplots(figsize=(9.6, 3.9), layout="constrained")
    looks = {"coupled": {"color": VERMILION, "dashes": (5, 2)}, "exact": {"color": BLUE}}
    for case, rows in data["pivot_stiffness"].groups("case").items():
        axes.plot(rows.column("ratio"), rows.column("angle", 180 / math.pi), marker="o", markersize=4, label=CASES[case], **looks[case])
    axes.set(xscale="log", xlabel="stiffness ratio  $k_r/(k_l (μ_r/μ_l)^2)$", ylabel="turned before it leaves  [°]", ylim=(0, 95))
    ticks = (0.1, 1, 10, 100)
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    mark_ratios(axes)
    legend_in_sight(figure, axes)
    return figure


MATERIAL_LOOKS = {"sandpaper": {"color": BLUE}, "suede": {"color": ORANGE, "dashes": (5, 2)}, "rayon": {"color": GREEN, "dashes": (1.5, 1.5)}}


def one_ratio(data):
    """`fit ratio` of Table 1: the weighted mean [m], chi squared by n, and the n that refutes one ratio."""
    found = {row["parameter"]: row["value"] for row in data["fits"].where(data="materials")}
    return found["ratio"], found["chi_squared_per_n"], found["n_for_p_0.05"]


def table_1(data):
    """Left: the published ratios and their weighted mean. Right: the block between fingers of each material."""
    figure, panels = plt.subplots(1, 1 + len(CASES), figsize=(9.6, 3.4), layout="constrained", width_ratios=(1.25, 1, 1, 1))
    left, rows = panels[0], data["table_1"]
    mean, chi_squared, _ = one_ratio(data)
    left.axhline(1e3 * mean, color=INK, linewidth=1.2)
    left.annotate(f"weighted mean: {1e3 * mean:.2f} mm\nχ² = {chi_squared:.2f} n, n not given", (-0.4, 0.5), fontsize=8)
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
    """Force closure by two fingers that carry and turn a block, with and without a friction moment."""
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
    mean, chi_squared, refuted = one_ratio(data)
    level, above = offset, 7
    farthest = max(data["pivot_map"].where(case="uncoupled", offset=1e-3 * above).column("angle", 180 / math.pi))
    turn = {friction: turn_of(rows[-1], "bq") for friction, rows in data["pinch"].groups("friction").items()}
    reached = {(row["case"], row["offset"]): row for row in data["pivot_offsets"].where(material="sandpaper")}
    between, far = reached["uncoupled", 0.0065], reached["uncoupled", 0.009]
    coupled = [row for row in data["pivot_offsets"] if row["case"] != "uncoupled"]
    edge = 1e3 * sandpaper["mu_r"] / sandpaper["mu"]
    first = {(row["material"], row["case"]): row["load"] for row in reversed(data["pivot_materials"])}
    margins = sorted(first[row["material"], "coupled"] / holding_load(row, offset) for row in data["table_1"])
    return ("A block between two fingers", [
        ("pivot", f"""The paper’s experiment (Figs. 7 to 11): cases A and B, and the exact curve. The grip on a sandpaper block loosens
slowly, without dampers. The centre of mass (blue path) lies beside the grip (dot). With coupled limits the block pivots before it is
lost: by {turned['coupled']:.1f}° and {turned['exact']:.1f}° once it has slid {lost} past the grip (dots). With uncoupled limits it
turns by {abs(turned['uncoupled']):.1f}°. Top to bottom: poses (Figs. 7, 10); centre of mass, angle and load over time (Figs. 8, 11);
the slip’s centre of rotation; one finger’s [r, ρ] plane (Fig. 9) with one step magnified: the goal has moved on (diamond), and step b
moves the god-object to the p-curve of its load. Friction, cases and level start are the paper’s; block
({1e3 * BLOCK_LENGTH:.0f} × {1e3 * BLOCK_HEIGHT:.0f} mm, 0.1 kg, {offset:.0f} mm off-centre), springs and time step are our choice.""",
         "Use coupled limits, or the object slides out level. For this, the ellipse is good enough."),
        ("pivot_operator", f"""A simulated operator loosens the grip until the block turns, and tightens it at 30°. The motion is slow (0.1 rad/s)
and the fingers are damped like a hand: 86 N s/m, a damping ratio of 1. Digits of young adults mostly have more (Park et al.,
Clinical Biomechanics 29:129–137, 2014). The block stops at {math.degrees(kept['coupled']['angle']):.1f}° (A) and
{math.degrees(kept['exact']['angle']):.1f}° (exact). In case B it is caught {1e3 * kept['uncoupled']['grip_slip']:.1f} mm lower, still
level.""",
         "Use coupled limits if loosening the grip should turn an object."),
        ("pivot_offsets", f"""The same operator with three materials, against the offset of the centre of mass: the angle, the slip, and how
often the block turned back by more than 0.1°. With coupled limits it turned back up to
{max(row['turned_back'] for row in coupled):.0f} times (from 5 mm on:
{max(row['turned_back'] for row in coupled if row['offset'] > 0.0045):.0f}). In case B it does not turn below
μ<sub>r</sub>/μ<sub>l</sub> (dashed; {edge:.2f} mm on sandpaper). At 6.5 mm it stops at {math.degrees(between['angle']):.0f}° after
sliding {1e3 * between['grip_slip']:.1f} mm; at 9 mm, at {math.degrees(far['angle']):.0f}° after
{1e3 * far['grip_slip']:.1f} mm, where case A slides {1e3 * reached['coupled', 0.009]['grip_slip']:.1f} mm.""",
         "Expect uncoupled limits to fail at small offsets, not everywhere."),
        ("pivot_stiffness", f"""The paper does not state the twist stiffness. With the radial projection the block turns
by {scan['coupled'][softest]:.0f}° to {scan['coupled'][stiff]:.1f}° (ratios {softest:g} to {stiff:g}), with the closest point
by {min(scan['exact'].values()):.0f}° to {max(scan['exact'].values()):.0f}°.""",
         f"Use the closest point, or a ratio near {soft}."),
        ("pivot_map", f"""The block’s angle when it has slid {lost} past the grip and is lost, against the offset of its centre of mass and
how fast the grip loosens (neither is in the paper). With uncoupled limits the block turns only if the offset
exceeds μ<sub>r</sub>/μ<sub>l</sub> = {edge:.2f} mm (triangles): at {level:g} mm it slides out level, at {above:g} mm it turns by up
to {farthest:.0f}°.""",
         "Report offset and rate when you compare such experiments."),
        ("table_1", f"""Left: in Table 1 the ratio μ<sub>r</sub>/μ<sub>l</sub> barely depends on the material. Bars are means ± standard
deviations of n measurements; the table does not give n. The weighted mean is {1e3 * mean:.2f} mm. Overlapping bars neither prove nor
refute a common ratio: χ² = {chi_squared:.2f} n with 2 degrees of freedom, so p < 0.05 from n = {math.ceil(refuted)} on. Right: the
block between fingers of each material, with that material’s ratio. The grip starts at {margins[0]:.2f} to {margins[-1]:.2f} times
the load that the ellipse needs to hold the block.""",
         "Start with one measured ratio for any object material."),
        ("pinch", f"""Two soft fingers carry a block and turn it by {turn['soft']:.1f}° of
{turn_of(data['pinch_trace'][-1], 'q'):.1f}°: force closure. Without a friction moment it turns by {abs(turn['point']):.1f}°.""",
         "Use soft contacts if two fingers must turn an object."),
    ], "")


def holding_load(material, offset):
    """Load of each finger that just holds the block of 0.1 kg by eq. (19) [N]; offset in mm."""
    return 0.5 * 0.1 * 9.81 * math.hypot(1 / material["mu"], 1e-3 * offset / material["mu_r"])
