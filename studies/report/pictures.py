# SPDX-License-Identifier: MIT
"""The report's pictures of what is computed (the paper's Figs. 1, 2 and 5). One function: takes the CSVs (see csv_files.py for their columns),
returns a figure."""

import math

from .chart_style import BLUE, FAINT, INK, VERMILION, plt


def what_is_computed(data):
    """Paper, Figs. 1, 2 and 5: the friction cone, a pad that turns about its centre of rotation, and the cone of loads over [F, M]."""
    figure = plt.figure(figsize=(9.6, 3.5), layout="constrained")
    left, middle = figure.add_subplot(131), figure.add_subplot(132)
    right = figure.add_subplot(133, projection="3d", computed_zorder=False)
    draw_friction_cone(left)
    draw_pad(middle)
    draw_loads(right, data["curves"].where(law="hertz"), data["laws"].where(law="hertz")[0]["moment_ratio"])
    for axes in (left, middle):
        axes.set_axis_off()
        axes.set_aspect("equal")
    return figure


def section():
    """The report's first part: heading, figure with what to see in it, what follows."""
    return ("What is computed", [
        ("what_is_computed", """Left (the paper’s Fig. 1): friction holds a finger as long as its proxy is within μd of the surface
point; d is its depth. Middle (Fig. 2): a pad slides and turns about one centre of rotation C. Friction opposes that at every
place, and its sum is a force and a moment. Right (Fig. 5): all centres C together make the limit curve of a load, and all loads a
cone. A trial outside (diamond) is brought back to the curve of its load.""",
         "Use the curve wherever a contact slides and turns at once. For one of the two, Coulomb’s law is enough."),
    ], "")


def arrow(axes, start, end, colour=INK, width=1.3, head=9):
    axes.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": width, "shrinkA": 0, "shrinkB": 0,
                                              "mutation_scale": head})


def draw_friction_cone(axes):
    """Fig. 1: the finger at depth d, the surface point above it, and how far from there the proxy may stay."""
    reach = 0.75
    axes.fill_between([-1.5, 1.9], 0, -1.5, color="#f0f0f0", linewidth=0)
    axes.fill([0, -reach, reach], [-1, 0, 0], color="#cfe0ee", linewidth=0)
    axes.plot([-1.5, 1.9], [0, 0], color=INK, linewidth=1.2)
    for side in (-1, 1):
        axes.plot([0, side * reach], [-1, 0], color=BLUE, linewidth=1.4)
    axes.plot([0, 0], [-1, 0], color=FAINT, linewidth=0.9, dashes=(4, 3))
    for x, y, text, colour, offset in ((0, -1, "finger $x_h$", INK, (7, -4)), (0, 0, "$x_g$", INK, (-5, 7)),
                                       (1.35, 0, "proxy, trial", VERMILION, (-22, 9)), (reach, 0, "$x_p$", BLUE, (-9, 8))):
        axes.plot(x, y, "D" if text == "proxy, trial" else "o", color=colour, markersize=5)
        axes.annotate(text, (x, y), offset, textcoords="offset points", color=colour, fontsize=8.5)
    arrow(axes, (1.28, 0), (reach + 0.07, 0), VERMILION)
    axes.annotate("$d = P/k_l$", (0, -0.3), (-3, 0), textcoords="offset points", fontsize=8, ha="right")
    axes.annotate("μd", (reach / 2, 0), (0, -13), textcoords="offset points", ha="center", color=BLUE, fontsize=8.5)
    axes.set_title("Friction cone: the proxy stays\nwithin μd of $x_g$")
    axes.set(xlim=(-1.5, 1.9), ylim=(-1.8, 1.3))


def draw_pad(axes):
    """Fig. 2: every place of the contact slides at right angles to its line to the centre of rotation C."""
    distance = 0.62
    rings = [(1.0, "#e9f0f7"), (0.85, "#d6e4f0"), (0.65, "#c0d6e8"), (0.4, "#a9c7e0")]
    for radius, colour in rings:
        axes.add_patch(plt.Circle((0, 0), radius, color=colour, linewidth=0))
    axes.add_patch(plt.Circle((0, 0), 1, fill=False, color=INK, linewidth=1.1))
    for ring, count in ((0.0, 1), (0.42, 6), (0.8, 11)):
        for i in range(count):
            angle = 2 * math.pi * (i + 0.35) / count
            x, y = ring * math.cos(angle), ring * math.sin(angle)
            away = math.hypot(x - distance, y)
            if away < 0.2:
                continue
            across = (-y / away * 0.2, (x - distance) / away * 0.2)
            arrow(axes, (x - across[0] / 2, y - across[1] / 2), (x + across[0] / 2, y + across[1] / 2), VERMILION, 1.1, 7)
    axes.plot([0, distance], [0, 0], color=INK, linewidth=1)
    axes.plot(0, 0, "o", color=INK, markersize=4)
    axes.plot(distance, 0, "o", color=BLUE, markersize=6)
    axes.annotate("O", (0, 0), (-9, -11), textcoords="offset points", fontsize=8.5)
    axes.annotate("C", (distance, 0), (5, -12), textcoords="offset points", color=BLUE, fontsize=9)
    axes.annotate("c", (distance / 2, 0), (0, 3), textcoords="offset points", ha="center", fontsize=8.5)
    arrow(axes, (0, 0), (-math.cos(0.9), -math.sin(0.9)), FAINT, 1)
    axes.annotate("a", (-0.5 * math.cos(0.9), -0.5 * math.sin(0.9)), (-3, 4), textcoords="offset points", ha="right", fontsize=8.5)
    axes.set_title("Sliding pad: every place turns about\nC, the centre of rotation (COR)")
    axes.set(xlim=(-1.3, 1.3), ylim=(-1.19, 1.19))


def draw_loads(axes, curve, moment_ratio):
    """Fig. 5: the limit curve grows with the load P to a cone; a trial outside is moved on to the curve of its load."""
    half = list(zip(curve.column("x"), curve.column("y")))
    quarter = half if half[0][0] < half[-1][0] else half[::-1]  # from pure moment to pure force
    front = [(x, -y) for x, y in reversed(quarter)] + [(-x, -y) for x, y in quarter]
    ring = quarter + front + [(-x, y) for x, y in reversed(quarter)]
    ring = ring[::4] + ring[:1]
    for load in (0.25, 0.5, 0.75, 1.0):
        chosen = load == 0.75
        axes.plot([load * x for x, _ in ring], [load * y for _, y in ring], [load] * len(ring), color=BLUE if chosen else FAINT,
                  linewidth=2 if chosen else 0.9)
    for i in range(0, len(ring) - 1, max(1, (len(ring) - 1) // 12)):
        x, y = ring[i]
        axes.plot([0, x], [0, y], [0, 1], color="#c4c4c4", linewidth=0.7)
    place = quarter[len(quarter) // 2]
    new, trial = [0.75 * value for value in place], [1.25 * value for value in place]
    axes.plot([0, trial[0]], [0, trial[1]], [0.75, 0.75], color=FAINT, linewidth=0.8, dashes=(3, 2))
    axes.plot([new[0], trial[0]], [new[1], trial[1]], [0.75, 0.75], color=VERMILION, linewidth=1.5)
    axes.plot(*[[value] for value in trial], [0.75], "D", color=VERMILION, markersize=5)
    axes.plot(*[[value] for value in new], [0.75], "o", color=BLUE, markersize=5)
    axes.plot([0, 0], [0, 0], [0, 1.15], color=FAINT, linewidth=0.8)
    axes.plot([0, 1.25], [0, 0], [0, 0], color=FAINT, linewidth=0.8)
    axes.plot([0, 0], [0, 1.25], [0, 0], color=FAINT, linewidth=0.8)
    axes.text(1.38, 0, 0, "F/μ", fontsize=8.5, ha="center")
    axes.text(0, 1.45, 0, "M/μ$_r$", fontsize=8.5, ha="center")
    axes.text(0, 0, 1.2, "P", fontsize=8.5, ha="center")
    axes.text(trial[0] * 1.1, trial[1] * 1.1, 0.66, "trial", color=VERMILION, fontsize=8.5, ha="center")
    axes.view_init(elev=24, azim=35)
    axes.set_axis_off()
    axes.set_box_aspect((1, 1, 0.85), zoom=1.45)
    axes.set_title("Cone of loads: the limit curve of\nforce and moment grows with P", loc="left")
