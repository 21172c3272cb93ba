# SPDX-License-Identifier: MIT
"""How every chart of this project is drawn: one palette, one set of line weights, files that a redraw repeats bit for
bit."""

import csv
import io
import os
import secrets
import re
from collections import defaultdict
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend first)
from matplotlib.backends.backend_svg import RendererSVG  # noqa: E402

INK = "#222222"
FAINT = "#8a8a8a"
GRID = "#e4e4e4"
# Okabe and Ito's palette, which the colour-blind can tell apart; a law keeps its colour in every figure.
BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY = "#0072B2", "#D55E00", "#009E73", "#E69F00", "#CC79A7", "#56B4E9"
LAW_COLOURS = {
    "hertz": BLUE,
    "uniform": VERMILION,
    "parabolic": GREEN,
    "flat-punch": ORANGE,
    "cone": PURPLE,
    "xydas-kao": SKY,
    "power": "#7a5c3e",
    "gaussian": "#6f6f6f",
    "mix": "#3c3c8c",
    "samples": "#000000",
}
# And its dashes: no two laws are told apart by colour alone. Hertz is solid.
LAW_DASHES = {
    "uniform": (7, 1.5),
    "parabolic": (4, 1.5, 1, 1.5),
    "flat-punch": (2.2, 1.2),
    "cone": (7, 1.5, 1, 1.5, 1, 1.5),
    "xydas-kao": (4, 1.2),
    "power": (10, 1.5, 3, 1.5),
    "gaussian": (1.2, 1.2),
    "mix": (3, 1, 1, 1),
}
# Verdana's letters are as wide as DejaVu's, which matplotlib measures; most others are narrower.
FONTS = "DejaVu Sans, Verdana, sans-serif"
# For lines that are not laws', in the order of their colours.
DASHES = ((), (5, 1.5), (1.5, 1.2), (5, 1.5, 1.2, 1.5), (8, 2, 3, 2))
ELLIPSE = {"color": INK, "linewidth": 1.2, "dashes": (5, 3)}
MARGIN = 0.06  # inches around a figure
PHONE = 0.54  # share of a figure that 390 pixels show: page.css keeps it 40 rem wide

plt.rcParams.update({
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "axes.titlesize": 9.5,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.labelcolor": INK,
    "axes.edgecolor": FAINT,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": GRID,
    "grid.linewidth": 0.6,
    "axes.axisbelow": True,
    "xtick.color": FAINT,
    "ytick.color": FAINT,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "text.color": INK,
    "lines.linewidth": 1.5,
    "legend.frameon": False,
    "legend.fontsize": 8.5,
    "legend.handlelength": 3,
    "mathtext.fontset": "dejavusans",
    "figure.constrained_layout.use": True,
    "figure.dpi": 100,
    "savefig.dpi": 160,
    # words stay text: half the bytes, and a reader can search it; FONTS says what replaces a missing font
    "svg.fonttype": "none",
    "svg.hashsalt": "limitcurve",
})


draw_text = RendererSVG.draw_text


def draw_formulas_as_paths(self, gc, x, y, s, prop, angle, ismath=False, mtext=None):
    """Readers such as librsvg set the parts of a formula on top of each other if they are text."""
    with plt.rc_context({"svg.fonttype": "path" if ismath else "none"}):
        draw_text(self, gc, x, y, s, prop, angle, ismath, mtext)


RendererSVG.draw_text = draw_formulas_as_paths


def law_style(law):
    """Colour and dashes of a law string: its kind decides, not its parameters."""
    kind = law.split(":")[0]
    style = {"color": LAW_COLOURS.get(kind, INK)}
    if kind in LAW_DASHES:
        style["dashes"] = LAW_DASHES[kind]
    return style


def short(number):
    """1e-8, not 1e-08."""
    return f"{number:g}".replace("e-0", "e-")


class Table(list):
    """Rows of a CSV as dictionaries, numbers as float, lines that begin with # left out; `groups` keeps the file's
    order."""

    @classmethod
    def read(cls, path):
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        if not rows:
            raise ValueError(f"{path}: no rows")
        return cls({name: _value(text) for name, text in row.items()} for row in rows)

    def where(self, **wanted):
        return Table(row for row in self if all(row[name] == value for name, value in wanted.items()))

    def groups(self, *names):
        parts = defaultdict(Table)
        for row in self:
            parts[tuple(row[name] for name in names) if len(names) > 1 else row[names[0]]].append(row)
        return parts

    def columns(self, *names):
        return [self.column(name) for name in names]

    def column(self, name, scale=None):
        return [row[name] if scale is None else row[name] * scale for row in self]


def _value(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return text


def pair(height, **options):
    """A figure as wide as the page, with two panels."""
    return plt.subplots(1, 2, figsize=(9.6, height), **options)


def quadrant(axes, title, x_label, y_label):
    axes.set(title=title, xlabel=x_label, ylabel=y_label, xlim=(0, None), ylim=(0, None))


def note(axes, text, place, offset, **look):
    axes.annotate(text, place, offset, **{"textcoords": "offset points", "fontsize": 8, **look})


def only_ticks(axis, values):
    axis.set_ticks(values, [f"{value:g}" for value in values])
    axis.set_minor_locator(matplotlib.ticker.NullLocator())


def framed(lens):
    for spine in lens.spines.values():
        spine.set(visible=True, color=FAINT)


def mark_ratios(axes):
    """Marks on an axis of κ = k_r/(k_l (m0 a)^2) where the radial projection is exact for the ellipse, and a pad's own
    ratio (k_r = k_l a^2)."""
    for ratio, what, side in ((1, "κ = 1: radial is exact\nfor the ellipse", "right"), (2.88, "κ = 2.88:\na pad’s own",
                                                                                        "left")):
        axes.axvline(ratio, color=FAINT, linewidth=0.8, dashes=(3, 3), zorder=0)
        axes.annotate(what, (ratio, 1), (4 if side == "left" else -4, -3),
                      xycoords=("data", "axes fraction"),
                      textcoords="offset points",
                      color=FAINT,
                      fontsize=7,
                      ha=side,
                      va="top")


def legend_below(figure, axes, columns):
    figure.legend(*axes.get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.5, 0), ncols=columns)


def legend_in_sight(figure, axes):
    """Below, from the left edge, and no wider than what a phone shows of a figure before it is scrolled."""
    for columns in range(5, 0, -1):
        legend = figure.legend(*axes.get_legend_handles_labels(),
                               loc="upper left",
                               bbox_to_anchor=(0, 0),
                               ncols=columns)
        if columns == 1 or legend.get_window_extent().width < PHONE * figure.bbox.width:
            return
        legend.remove()


def write_whole(path, contents):
    """The file appears under its name whole or not at all: bytes go to a hidden file beside it, which is then
    renamed."""
    path = Path(path).resolve()  # a link stays one
    part = path.with_name(f".limitcurve-{secrets.token_hex(16)}.tmp")
    try:
        with open(part, "xb") as file:
            file.write(contents)
            file.flush()
            os.fsync(file.fileno())
        os.replace(part, path)
    except BaseException as error:
        part.unlink(missing_ok=True)
        if isinstance(error, OSError):
            error.filename = str(path)  # that of the hidden file, or none
        raise


def picture(figure, form, metadata, frame):
    buffer = io.BytesIO()
    figure.savefig(buffer, format=form, metadata=metadata, bbox_inches=frame, pad_inches=MARGIN)
    return buffer.getvalue()


def slim(svg):
    """The same picture in fewer bytes: hundredths of a point (tenths within a path), short names, one font, one style
    for markers in a row."""

    def shorter(match):
        text = match[0]
        return text if text.startswith("scale") else f"{float(text):.2f}".rstrip("0").rstrip(".")

    def font(match):
        slant, weight, size = match.groups()
        return f"font-size: {size}" + (f"; font-weight: {weight}" if weight else "") + ("; font-style: oblique"
                                                                                        if slant else "")

    svg = re.sub(r"<!--.*?-->\s*|<metadata>.*?</metadata>\s*", "", svg, flags=re.S)
    # In tags only: the text of a label stays as it is.
    svg = re.sub(r"<[^>]*>", lambda tag: re.sub(r"scale\([^)]*\)|\d+\.\d{3,}", shorter, tag[0]), svg)
    svg = re.sub(r"font: (oblique |italic )?(?:(\d+) )?([\d.]+px) 'DejaVu Sans'", font,
                 svg).replace("<svg ", f'<svg font-family="{FONTS}" ', 1)
    svg = re.sub(r' transform="rotate\(-?0 [^)]*\)"', "", svg)
    used = dict.fromkeys(re.findall(r'href="#([mp][0-9a-f]{6,})"|url\(#([mp][0-9a-f]{6,})\)', svg))
    for i, name in enumerate(first or second for first, second in used):
        svg = svg.replace(name, f"{name[0]}{i}")
    svg = ungrouped(re.sub(r"\s*\n\s*", "\n", svg))
    svg = re.sub(r' d="([^"]*)"', lambda match: f' d="{path(match[1])}"', svg)
    return re.sub(r'(?:<use [^>]*? style="([^"]*)"/>\n)(?:<use [^>]*? style="\1"/>\n)+', one_style, svg)


def ungrouped(svg):
    """Without the groups that have a name and nothing else."""
    lines, meant = [], []
    for line in svg.split("\n"):
        if re.fullmatch(r"<g[^>]*/>", line):
            continue
        if line.startswith("<g"):
            meant.append(not re.fullmatch(r'<g( id="[^"]*")?>', line))
        if not line.startswith(("<g", "</g>")) or meant[-1]:
            lines.append(line)
        if line == "</g>":
            meant.pop()
    return "\n".join(lines)


def path(data):
    """Path data without the letters that repeat, in tenths of a point."""
    last, parts = "", []
    for part in re.findall(r"[A-Za-z][^A-Za-z]*", data):
        letter, numbers = part[0], " ".join(f"{float(number):.1f}".removesuffix(".0") for number in part[1:].split())
        parts.append((" " if letter == last else letter) + numbers)
        last = "L" if letter == "M" else letter
    return "".join(parts)


def one_style(match):
    """Markers in a row that look alike, in a group that has their style."""
    return f'<g style="{match[1]}">\n' + match[0].replace(f' style="{match[1]}"', "") + "</g>\n"


def save(figure, folder, name):
    """Writes NAME.svg and NAME.png, the same bytes each time; returns the SVG for a page, its ids made its own."""
    folder = Path(folder)
    svg = slim(picture(figure, "svg", {"Date": None, "Creator": None}, "tight").decode("utf-8"))
    write_whole(folder / f"{name}.svg", svg.encode("utf-8"))
    # It has been laid out: the second picture takes half of the time of the first.
    figure.set_layout_engine("none")
    figure.set_dpi(plt.rcParams["savefig.dpi"])
    write_whole(folder / f"{name}.png", picture(figure, "png", {"Software": None},
                                                figure.get_tightbbox().padded(MARGIN)))
    plt.close(figure)
    svg = svg[svg.index("<svg"):]
    svg = re.sub(r'\b(id=")', rf"\g<1>{name}-", svg)
    return re.sub(r'(xlink:href="#|url\(#)', rf"\g<1>{name}-", svg)
