# SPDX-License-Identifier: MIT
"""The report's figures of the paper's experiment (section 6)."""

import math

from .chart_style import BLUE, FAINT, GREEN, INK, VERMILION, framed, legend_in_sight, mark_ratios, note, plt

BLOCK_LENGTH, BLOCK_HEIGHT = 0.12, 0.04  # m, `limitcurve pivot`'s default
CASES = {
    "coupled": "Coupled: ellipse, radial (A)",
    "exact": "Exact curve, closest point",
    "uncoupled": "Uncoupled: box (B)"
}
LOST = 0.005  # m: a block that has slid so far past the grip, or has left it, is lost


def angle_at_loss(rows):
    """By how much the block has turned [°] when it is lost, and when that is [s]; linear between rows. Of a block that
    stays: at the end."""
    for before, row in zip(rows, rows[1:]):
        if row["state"] == "free":
            return math.degrees(before["angle"]), before["time"]
        if row["grip_slip"] >= LOST:
            share = (LOST - before["grip_slip"]) / (row["grip_slip"] - before["grip_slip"])
            return tuple(scale * (before[name] + share * (row[name] - before[name]))
                         for name, scale in (("angle", 180 / math.pi), ("time", 1)))
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
        corners = [(x * BLOCK_LENGTH / 2, y * BLOCK_HEIGHT / 2)
                   for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))]
        axes.plot([1e3 * (row["x"] + x * cosine - y * sine) for x, y in corners],
                  [1e3 * (row["y"] + x * sine + y * cosine) for x, y in corners], color=shade, linewidth=1.1)
        note(axes, f"{row['time']:.1f} s", [1e3 * place for place in (row["x"] - 0.06 * cosine - 0.02 * sine,
             row["y"] - 0.06 * sine + 0.02 * cosine)], (-3, 0), color=INK, ha="right", va="center")
    axes.plot([1e3 * row["x"] for row in held], [1e3 * row["y"] for row in held], color=BLUE, linewidth=1.6)
    axes.plot(0, 0, "o", color=VERMILION, markersize=6)


def pivot(data):
    """Paper, Figs. 7 to 11: the grip is released slowly."""
    return experiment(data, "release")


def pivot_operator(data):
    """Paper, Figs. 7 to 11: an operator eases and tightens the grip, and regrips."""
    return experiment(data, "operator")


def experiment(data, grip):
    """For each case: poses of the block; x, y of its centre of mass, its angle, the load of a finger and the slip's COR
    against time; the god-object in the [r, rho] plane."""
    figure, panels = plt.subplots(6, len(CASES), figsize=(9.6, 14), sharex="row", sharey="row",
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
        if not any(map(math.isfinite, held.column("cor"))):
            cor.text(0.5,
                     0.5,
                     "infinite: the block only slides",
                     transform=cor.transAxes,
                     ha="center",
                     va="center",
                     fontsize=9,
                     color=FAINT)
        cor.set(xlabel="time  [s]", yscale="log", ylim=(5, 200), xlim=angle.get_xlim())
        draw_plane(plane, held, unit_curve(data, case), sandpaper)
    for row, label in zip(
            panels,
        ("y  [mm]", "centre of mass  [mm]", "angle α  [°]", "load  [N]", "COR of the slip c  [mm]", "ρ  [mrad]")):
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
    return list(zip(*hertz.columns("x", "y")))


SHOWN_STEPS = 9
FASTEST = 3e-5  # m in a step of 1 ms: a block that falls out of the grip is faster
STIFFNESS = 1000.0  # k_l [N/m], `limitcurve pivot`'s default; k_r = k_l (mu_r/mu)^2


def draw_plane(axes, held, unit, material):
    """Fig. 9: the god-object before (diamonds) and after step b, their p-curves, that of the final grip; without one,
    one step magnified."""
    twist_stiffness = STIFFNESS * (material["mu_r"] / material["mu"]) ** 2

    def p_curve(where, load, **look):
        where.plot([1e6 * material["mu"] * load * x / STIFFNESS for x, _ in unit],
                   [1e3 * material["mu_r"] * load * y / twist_stiffness for _, y in unit], **look)

    slips = [
        row for row in held if row["state"] == "slip" and math.hypot(row["trial_r"] - row["r"], 6e-3 *
                                                                     (row["trial_rho"] - row["rho"])) < FASTEST
    ]
    chosen = slips[::max(1, len(slips) // SHOWN_STEPS)]

    def steps(where, shown, **look):
        for row in shown:
            p_curve(where, row["load"], color="#c4c4c4", **look)
            where.plot([1e6 * row["trial_r"], 1e6 * row["r"]], [1e3 * row["trial_rho"], 1e3 * row["rho"]],
                       color=VERMILION,
                       linewidth=0.9)
        where.plot([1e6 * row["trial_r"] for row in shown], [1e3 * row["trial_rho"] for row in shown],
                   "D",
                   color=INK,
                   markersize=3.5)
        where.plot([1e6 * row["r"] for row in shown], [1e3 * row["rho"] for row in shown],
                   "o",
                   color=BLUE,
                   markersize=3.5)

    steps(axes, chosen, linewidth=0.8)
    axes.plot(held.column("r", 1e6), held.column("rho", 1e3), color=FAINT, linewidth=0.9)
    if held[-1]["state"] == "stick" and held[-1]["load"] > slips[-1]["load"]:
        # The grip grows until its p-curve lies outside the god-object.
        p_curve(axes, held[-1]["load"], color=GREEN, linewidth=1.6, dashes=(6, 2))
    else:  # With dampers, as the operator's, the springs alone are not on the p-curve.
        middle = chosen[len(chosen) // 2]
        lens = axes.inset_axes((0.18, 0.14, 0.45, 0.45))
        half = 1.2 * max(1e6 * abs(middle["trial_r"] - middle["r"]), 1e3 * 6 * abs(middle["trial_rho"] - middle["rho"]),
                         1)
        lens.set(xlim=(1e6 * middle["r"] - half, 1e6 * middle["r"] + half),
                 ylim=(1e3 * middle["rho"] - half / 6, 1e3 * middle["rho"] + half / 6))
        lens.tick_params(labelsize=8)
        lens.grid(False)
        steps(lens, [middle], linewidth=1.6)
        framed(lens)
    axes.plot(1e6 * held[0]["r"], 1e3 * held[0]["rho"], "s", color=INK, markersize=4.5)
    largest = max(chosen[0]["load"], held[-1]["load"] if held[-1]["state"] == "stick" else 0)
    axes.set(xlabel="r  [µm]",
             xlim=(0, 1.1e6 * material["mu"] * largest / STIFFNESS),
             ylim=(0, 1.1e3 * material["mu_r"] * largest / twist_stiffness))


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


def pivot_stiffness(data):
    figure, axes = plt.subplots(figsize=(9.6, 3.9))
    looks = {"coupled": {"color": VERMILION, "dashes": (5, 2)}, "exact": {"color": BLUE}}
    for case, rows in data["pivot_stiffness"].groups("case").items():
        axes.plot(rows.column("ratio"),
                  rows.column("angle", 180 / math.pi),
                  marker="o",
                  markersize=4,
                  label=CASES[case],
                  **looks[case])
    axes.set(xscale="log",
             xlabel="stiffness ratio  $k_r/(k_l (μ_r/μ_l)^2)$",
             ylabel="turned before it leaves  [°]",
             ylim=(0, 95))
    axes.set_xticks((0.1, 1, 10, 100), ("0.1", "1", "10", "100"))
    mark_ratios(axes)
    legend_in_sight(figure, axes)
    return figure


def section(data):
    turned = {case: angle_at_loss(rows)[0] for case, rows in data["pivot"].where(grip="release").groups("case").items()}
    lost = f"{1e3 * LOST:g} mm"
    kept = {case: rows[-1] for case, rows in data["pivot"].where(grip="operator").groups("case").items()}
    offset = -1e3 * data["pivot"][0]["x"]
    scan = {case: dict(zip(rows.column("ratio"), rows.column("angle", 180 / math.pi)))
            for case, rows in data["pivot_stiffness"].groups("case").items()}
    soft, softest, stiff = 1, min(scan["coupled"]), max(scan["coupled"])
    return ("A block between two fingers", [
        ("pivot",
         f"""The paper’s experiment (Figs. 7 to 11): cases A and B, and the exact curve. The grip on a sandpaper block
loosens slowly, without dampers. The centre of mass (blue path) lies beside the grip (dot). With coupled limits the
block pivots before it is lost: by {turned['coupled']:.1f}° and {turned['exact']:.1f}° once it has slid {lost} past the
grip (dots). With uncoupled limits it turns by {abs(turned['uncoupled']):.1f}°. Top to bottom: poses (Figs. 7, 10);
centre of mass, angle and load over time (Figs. 8, 11); the slip’s centre of rotation; one finger’s [r, ρ] plane (Fig.
9) with one step magnified: the goal has moved on (diamond), and step b moves the god-object to the p-curve of its
load. Friction, cases and level start are the paper’s; block ({1e3 * BLOCK_LENGTH:.0f} × {1e3 * BLOCK_HEIGHT:.0f} mm,
0.1 kg, {offset:.0f} mm off-centre), springs and time step are our choice.""",
         "Use coupled limits, or the object slides out level. For this, the ellipse is good enough."),
        ("pivot_operator",
         f"""A simulated operator loosens the grip until the block turns, and tightens it at 30°. The motion is slow
(0.1 rad/s) and the fingers are damped like a hand: 86 N s/m, a damping ratio of 1. Digits of young adults mostly have
more (Park et al., Clinical Biomechanics 29:129–137, 2014). The block stops at
{math.degrees(kept['coupled']['angle']):.1f}° (A) and {math.degrees(kept['exact']['angle']):.1f}° (exact). In case B it
is caught {1e3 * kept['uncoupled']['grip_slip']:.1f} mm lower, still level.""",
         "Use coupled limits if loosening the grip should turn an object."),
        ("pivot_stiffness", f"""The paper does not state the twist stiffness. With the radial projection the block turns
by {scan['coupled'][softest]:.0f}° to {scan['coupled'][stiff]:.1f}° (ratios {softest:g} to {stiff:g}), with the closest
point by {min(scan['exact'].values()):.0f}° to {max(scan['exact'].values()):.0f}°.""",
         f"Use the closest point, or a ratio near {soft}."),
    ], "")
