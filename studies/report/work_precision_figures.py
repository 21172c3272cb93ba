# SPDX-License-Identifier: MIT
"""The work-precision charts: error of every way to a friction wrench against what it costs, from
data/work_precision/."""

import math

import matplotlib.pyplot as plt
from .chart_style import BLUE, FAINT, GREEN, GRID, INK, PURPLE, VERMILION

# Errors below the rounding of a double are drawn there.
ROUNDING = 1e-16
# Family: colour, marker, dashes, and whether its dots are named by their parameter alone (the legend then tells the
# family). What is not ours has one colour; marker and dashes tell it apart.
FAMILIES = {
    "box": (INK, "s", "-", False),
    "diamond": (INK, "D", "-", False),
    "ellipse": (INK, "o", "-", False),
    "table": (BLUE, "o", "-", True),
    "large table": (BLUE, "s", (0, (1, 1)), True),
    "closed": (GREEN, "*", "-", False),
    "forces": (GREEN, "D", "-", False),
    "ring": (PURPLE, "D", "-", True),
    "punch": (PURPLE, "v", "-", True),
    "direct": (PURPLE, "X", "-", True),
    "Hermite": (VERMILION, "o", "-", True),
    "grid": (VERMILION, "s", (0, (4, 2)), True),
    "Boost split": (VERMILION, "^", (0, (1, 1)), True),
    "Boost nested": (VERMILION, "v", (0, (6, 1.5, 1, 1.5)), True),
    "scipy dblquad": (VERMILION, "P", (0, (1, 3)), True),
}
# Of these, which lie close, the first and the last dot are named.
ENDS_NAMED = ("grid", "Boost split", "Boost nested", "scipy dblquad")
LEGEND = {
    "table": "look-up table, its tolerance",
    "large table": "look-up table in 96 KiB, its tolerance",
    "ring": "one integral over the radius",
    "punch": "superposed flat punches",
    "direct": "eq. (17) as printed",
    "Hermite": "evenly spaced Hermite cubics, entries",
    "grid": "N × N grid, N",
    "Boost split": "Boost, elliptic integrals, tolerance",
    "Boost nested": "Boost, nested, tolerance",
    "scipy dblquad": "scipy dblquad, tolerance",
}
# What to take, and for what.
CHOICES = {
    ("ellipse", ""): "ellipse:\na rough answer",
    ("table", "1e-8"): "table of 1e-8:\na loop",
    ("closed", "double"): "closed form:\na few values",
    ("ring", "80 bit"): "evaluate:\nthe reference",
}
ERROR = "largest error over all centres of rotation, in the norm of a tolerance"
RADIAL_SHOWN = ("ellipse", "float ellipse", "table 1e-8")
# Projection: colour, marker of a finger, marker of a contact in a batch.
PROJECTIONS = {"radial": (PURPLE, "^", "+"), "closest-point": (BLUE, "o", "x")}


def parameter(row):
    text = row["parameter"]
    if not isinstance(text, float):
        return text
    return f"{text:.0e}".replace("e-0", "e-") if text <= 0.1 else f"{text:g}"


def name(row):
    return " ".join(part for part in (row["family"], parameter(row)) if part)


def cheapest_first(rows):
    """The rows that no other beats in error and time, from the largest error on."""
    front, best = [], math.inf
    for row in sorted(rows, key=lambda item: (max(item["max_error"], ROUNDING), item["mean_ns"])):
        if row["mean_ns"] < best:
            front.append(row)
            best = row["mean_ns"]
    return front[::-1]


def steps(front, right):
    """The frontier as a staircase: what is to be had at every error, up to the right edge."""
    xs, ys = [], []
    for i, row in enumerate(front):
        error = max(row["max_error"], ROUNDING)
        following = max(front[i + 1]["max_error"], ROUNDING) if i + 1 < len(front) else right
        xs += [error, following]
        ys += [row["mean_ns"], row["mean_ns"]]
    return xs, ys


def error_axis(axes, left):
    """Errors fall to the right; what is not above the rounding of a double stands on its line."""
    axes.set(xscale="log", yscale="log", xlim=(left, ROUNDING / 4))
    axes.set_xticks([10.0 ** -k for k in range(0, 17, 2)],
                    [*(f"$10^{{-{k}}}$" if k else "1" for k in range(0, 16, 2)), "below\n$10^{-16}$"])
    axes.axvspan(2 * ROUNDING, ROUNDING / 4, color=GRID, linewidth=0, zorder=-1)
    axes.minorticks_off()
    axes.set_xlabel(ERROR, fontsize=8)


class Labels:
    """Puts words beside dots so that none covers another: each takes the nearest free place around its dot."""

    def __init__(self, figure, axes, size):
        self.axes, self.size = axes, size
        self.renderer = figure.canvas.get_renderer()
        self.taken = []
        self.wanted = []

    def dot(self, x, y, word, colour, radius=4.5):
        at = self.axes.transData.transform((x, y))
        self.taken.append((at[0] - radius, at[1] - radius, at[0] + radius, at[1] + radius))
        if word:
            self.wanted.append((at, word, colour))

    def line(self, xs, ys):
        """Words keep off lines too."""
        points = [self.axes.transData.transform(point) for point in zip(xs, ys)]
        for (x0, y0), (x1, y1) in zip(points, points[1:]):
            count = max(2, int(math.hypot(x1 - x0, y1 - y0) / 4))
            self.taken += [(x0 + (x1 - x0) * i / count - 0.5, y0 + (y1 - y0) * i / count - 0.5,
                            x0 + (x1 - x0) * i / count + 0.5, y0 + (y1 - y0) * i / count + 0.5)
                           for i in range(count + 1)]

    @staticmethod
    def overlap(one, other):
        width = min(one[2], other[2]) - max(one[0], other[0])
        height = min(one[3], other[3]) - max(one[1], other[1])
        return width * height if width > 0 and height > 0 else 0

    def place(self):
        frame = self.axes.get_window_extent(self.renderer)
        crowd = [sum(math.hypot(at[0] - other[0][0], at[1] - other[0][1]) < 60 for other in self.wanted)
                 for at, _, _ in self.wanted]
        for (at, word, colour), _ in sorted(zip(self.wanted, crowd), key=lambda item: -item[1]):
            probe = self.axes.text(0, 0, word, fontsize=self.size)
            extent = probe.get_window_extent(self.renderer)
            probe.remove()
            width, height = extent.width, extent.height * 0.85
            best = None
            for ring, distance in enumerate((7, 12, 18, 26, 36, 48, 62, 78, 96)):
                for turn in range(16):
                    angle = math.pi / 8 * turn
                    x, y = (place + distance * part + (extent / 2 if part > 0.3 else -extent / 2 if part < -0.3 else 0)
                            for place, part, extent in zip(at, (math.cos(angle), math.sin(angle)), (width, height)))
                    box = (x - width / 2 - 1, y - height / 2 - 1, x + width / 2 + 1, y + height / 2 + 1)
                    outside = (box[0] < frame.x0 + 2 or box[2] > frame.x1 - 2 or box[1] < frame.y0 + 2
                               or box[3] > frame.y1 - 2)
                    cost = 3.0 * sum(self.overlap(box, other)
                                     for other in self.taken) + 1e4 * outside + 3.0 * distance + 2.0 * (turn % 4 != 0)
                    if best is None or cost < best[0]:
                        best = (cost, x, y, box, ring)
                if best[0] < 3.0 * distance + 3:
                    break
            _, x, y, box, ring = best
            self.taken.append(box)
            inverse = self.axes.transData.inverted()
            if ring > 1:
                near = (min(max(at[0], box[0]), box[2]), min(max(at[1], box[1]), box[3]))
                self.axes.plot(*zip(inverse.transform(at), inverse.transform(near)),
                               color=colour,
                               linewidth=0.4,
                               zorder=1)
            self.axes.text(*inverse.transform((x, y)),
                           word,
                           fontsize=self.size,
                           color=colour,
                           ha="center",
                           va="center_baseline")


def size(count):
    for factor, unit in ((1024**2, "MiB"), (1024, "KiB")):
        if count >= factor:
            return f"{count / factor:.{int(count < 10 * factor)}f}".removesuffix(".0") + f" {unit}"
    return f"{count:.0f} B"


def draw_many(axes, labels, rows, colour):
    """From a table in the first cache up to one of 64 tables, visited at random."""
    for row in rows:
        if row["many_ns"] != "":
            ends = [max(row["max_error"], ROUNDING)] * 2, [row["mean_ns"], row["many_ns"]]
            axes.plot(*ends, color=colour, linewidth=0.8, zorder=2)
            axes.plot(*[end[1:] for end in ends], "_", color=colour, markersize=7, zorder=3)
            labels.line(*ends)


def law_panel(figure, axes, rows, law):
    right = ROUNDING / 4
    axes.set(title=law, ylim=(0.15, 2e8), ylabel="mean time of a wrench  [ns]")
    error_axis(axes, 10)
    labels = Labels(figure, axes, 7)
    for kind, colour in (("ours", BLUE), ("others", VERMILION)):
        axes.plot(*steps(cheapest_first(rows.where(kind=kind)), right), solid_capstyle="butt", zorder=0, color=colour,
                  linewidth=5, alpha=0.16)
    for family, of_family in rows.groups("family").items():
        by_parameter = FAMILIES[family][3]
        points, colour = draw_family(axes, labels, family, of_family, by_parameter,
                                     7 if FAMILIES[family][1] == "*" else 4.2)
        for i, (point, row) in enumerate(zip(points, of_family)):
            named = family not in ENDS_NAMED or i in (0, len(points) - 1)
            labels.dot(*point, (parameter(row) if by_parameter else name(row)) if named else "", colour)
    labels.place()


def draw_family(axes, labels, family, rows, keeps_off, marker_size):
    """Its dots and line, which words keep off or not: the dots' places, and their colour."""
    colour, marker, dashes, by_parameter = FAMILIES[family]
    points = [(max(row["max_error"], ROUNDING), row["mean_ns"]) for row in rows]
    hollow = {"markerfacecolor": "white"} if rows[0]["kind"] != "ours" else {}
    axes.plot(*zip(*points), marker=marker, markersize=marker_size, color=colour, linewidth=0.6,
              linestyle=dashes if by_parameter else "none", zorder=3, label=LEGEND.get(family, family), **hollow)
    if keeps_off:
        labels.line(*zip(*points))
    draw_many(axes, labels, rows, colour)
    return points, colour


def step_panel(figure, axes, rows):
    axes.set(title="a god-object's step (hertz): error of the steady wrench",
             ylim=(0.3, 3e3),
             ylabel="mean time of a step  [ns]")
    error_axis(axes, 1e3)
    labels = Labels(figure, axes, 7)
    for projection, (colour, marker, in_batch) in PROJECTIONS.items():
        for row in rows.where(projection=projection):
            # Under the radial projection every boundary is as wrong as the curve itself.
            if projection == "radial" and row["boundary"] not in RADIAL_SHOWN:
                continue
            error = max(row["max_error"], ROUNDING)
            axes.plot([error], [row["batch_1024_ns"]], in_batch, color=colour, markersize=5, zorder=3)
            if row["warm_ns"] == "":  # stepped in batches only
                labels.dot(error, row["batch_1024_ns"], row["boundary"], colour)
                continue
            axes.plot([error, error], [row["batch_1024_ns"], row["cold_ns"]], color=colour, linewidth=0.6, zorder=2)
            axes.plot([error], [row["warm_ns"]], marker, color=colour, markersize=4.6, zorder=3)
            axes.plot([max(row["mean_error"], ROUNDING), error], [row["warm_ns"]] * 2,
                      color=colour,
                      linewidth=3,
                      alpha=0.35,
                      zorder=1)
            axes.plot([error], [row["cold_ns"]], "_", color=colour, markersize=6, zorder=3)
            labels.line([error, error], [row["batch_1024_ns"], row["cold_ns"]])
            labels.dot(error, row["cold_ns"], "", colour)
            labels.dot(error, row["batch_1024_ns"], "", colour)
            labels.dot(error, row["warm_ns"], row["boundary"], colour)
    labels.place()
    for projection, (colour, marker, in_batch) in PROJECTIONS.items():
        axes.plot([], [], marker, color=colour, label=f"{projection}, warm")
        axes.plot([], [], in_batch, color=colour, label=f"{projection}, a contact in a batch of 1024")
    axes.plot([], [], "_", color=INK, label="cold")
    axes.plot([], [],
              color=INK,
              linewidth=3,
              alpha=0.35,
              label="from the mean to the largest error, κ and c/a 0.1 to 10")
    axes.legend(loc="lower right", fontsize=7, handlelength=1.2)


PATCH_MARKERS = {"sums": "*", "table": "o", "ellipsoid": "s"}


def patch_panel(figure, axes, rows, quantity, title):
    """Contacts that are not round: one colour a patch."""
    axes.set(title=title, ylim=(3, 2e5), ylabel=f"mean time of a {quantity}  [ns]")
    error_axis(axes, 10)
    labels = Labels(figure, axes, 7)
    for colour, (patch, of_patch) in zip((INK, BLUE, GREEN, PURPLE, VERMILION), rows.groups("patch").items()):
        for way, marker in PATCH_MARKERS.items():
            points = [(max(row[f"{quantity}_error"], ROUNDING), row[f"{quantity}_ns"])
                      for row in of_patch.where(way=way)]
            axes.plot(*zip(*points), marker=marker, color=colour, linewidth=0.6, markersize=4.5)
            for point in points:
                labels.dot(*point, patch if way == "sums" else "", colour)
    labels.place()
    stored = rows.where(way="table")
    tolerances = ", ".join(dict.fromkeys(parameter(row) for row in stored))
    bytes_ = sorted(stored.column("bytes"))
    for way, word in (("sums", "sums, their stated error"), ("ellipsoid", "ellipsoid"),
                      ("table", f"table of {tolerances} ({size(bytes_[0])} to {size(bytes_[-1])})")):
        axes.plot([], [], PATCH_MARKERS[way], color=FAINT, label=word)
    axes.legend(loc="lower right", fontsize=7)


def footer(figure, height, font_size, text):
    figure.text(0.5, height, text, ha="center", fontsize=font_size, color=FAINT)


def work_precision(data):
    rows = data["work_precision_wrench"].where(law="hertz")
    figure, axes = plt.subplots(figsize=(8.4, 6.2), layout="none")
    figure.subplots_adjust(left=0.09, right=0.985, top=0.95, bottom=0.16)
    figure.canvas.draw()
    axes.set(title="One friction wrench of a Hertz contact: error against time",
             ylim=(0.7, 4e8),
             ylabel="mean time of a wrench  [ns]")
    error_axis(axes, 30)
    labels = Labels(figure, axes, 8.5)
    for family, of_family in rows.groups("family").items():
        points, colour = draw_family(axes, labels, family, of_family, True, 4.5)
        chosen = [CHOICES.get((family, parameter(row)), "") for row in of_family]
        for point, word in zip(points, chosen):
            if word:
                axes.plot(*point, "o", markersize=13, color=colour, fillstyle="none", markeredgewidth=1.6, zorder=4)
            labels.dot(*point, word, colour, 8 if word else 4.5)
        for point, row in zip(points, of_family):
            if row["many_ns"] != "":
                labels.dot(*point, size(row["bytes"]), colour)
        if family in LEGEND and family != "ring":
            labels.dot(*points[-1 if family in ("table", *ENDS_NAMED) else len(points) // 2],
                       LEGEND[family].rsplit(", ", 1)[0], colour)
        elif family not in LEGEND:
            for point, row, word in zip(points, of_family, chosen):
                labels.dot(*point, "" if word else name(row), colour)
    labels.place()
    footer(figure, 0.012, 8, "Ringed: what to take, and for what. Filled: this library. Hollow: others. Dashes above "
           "dots: one of 64 tables, visited at random.\nError against 50-digit values of eq. (17), between them "
           f"against evaluate in 80 bits. Measured on {data['work_precision_step'][0]['machine']}.")
    return figure


def all_work_precision(data):
    wrench, step = data["work_precision_wrench"], data["work_precision_step"]
    laws = list(wrench.groups("law"))
    figure, panels = plt.subplots(4, 2, figsize=(10, 19.2), layout="none")
    figure.subplots_adjust(left=0.07, right=0.99, top=0.983, bottom=0.095, hspace=0.27, wspace=0.16)
    figure.canvas.draw()
    for axes, law in zip(panels.flat, laws):
        law_panel(figure, axes, wrench.where(law=law), law)
    step_panel(figure, panels.flat[5], step)
    patches = data["work_precision_patch"]
    patch_panel(figure, panels.flat[6], patches, "wrench", "a wrench of a contact that is not round")
    patch_panel(figure, panels.flat[7], patches, "step", "a step of a finger on it, which slips: error of friction")
    handles = {label: handle for axes in panels.flat[:len(laws)]
               for handle, label in zip(*axes.get_legend_handles_labels()) if label in LEGEND.values()}
    order = [label for label in LEGEND.values() if label in handles]
    figure.legend([handles[label] for label in order],
                  order,
                  loc="lower center",
                  ncols=4,
                  bbox_to_anchor=(0.5, 0.025),
                  handlelength=3.5)
    footer(figure, 0.004, 8.5, "Filled: this library. Hollow: others. Bands: the cheapest at each error, of ours "
           "(blue) and of the others (red).\nDashes above dots: one of 64 tables, visited at random. Error against "
           "50-digit values, between them against evaluate.\n"
           f"Measured on {step[0]['machine']}; contacts that are not round on {patches[0]['machine']}.")
    return figure
