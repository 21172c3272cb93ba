# SPDX-License-Identifier: MIT
"""The report's page: one file that loads nothing."""

import html
import re
from pathlib import Path

from .chart_style import Table, save, write_whole


class Data:
    """The CSV files of a folder as tables, each read when it is asked for; `used` has the names since it was
    cleared."""

    def __init__(self, folder):
        self.folder, self.tables, self.used = folder, {}, {}

    def __getitem__(self, name):
        self.used[name] = None
        if name not in self.tables:
            self.tables[name] = Table.read(self.folder / f"{name}.csv")
        return self.tables[name]


def picture(data, draw, name):
    """Draws a figure beside its data; returns its SVG, and the names of the tables that it shows."""
    data.used.clear()
    figure = draw(data)
    return save(figure, data.folder, name), tuple(data.used)


def links(name, tables):
    return '<p class="files">' + ", ".join(f'<a href="{file}">{file}</a>'
                                           for file in (*(f"{table}.csv"
                                                          for table in tables), f"{name}.svg", f"{name}.png")) + "</p>"


def anchor(title):
    return re.sub(r"\W+", "-", title.lower()).strip("-")


def write(data, numbers, sections, pictures):
    """Writes index.html. `numbers` is (value, text); `sections` is (title, [(figure, caption, what to use)], HTML
    folded after them); `pictures` has what `picture` returned of each figure."""
    head = "".join(f"<li><b>{html.escape(value)}</b>{html.escape(text)}</li>" for value, text in numbers)
    contents = "".join(f'<li><a href="#{anchor(title)}">{title}</a></li>' for title, _, _ in sections)
    parts = []
    for title, figures, after in sections:
        plain = html.escape(title, quote=True)
        parts.append(f'<section><h2 id="{anchor(title)}">{title}</h2>')
        for name, caption, use in figures:
            svg, tables = pictures[name]
            picture = svg.replace("<svg ", f'<svg role="img" aria-label="{plain}" ', 1)
            parts.append(f'<figure id="{name}"><div class="still">{picture}</div><figcaption>{caption}'
                         f'<p class="use"><b>So:</b> {use}</p>{links(name, tables)}</figcaption></figure>')
        if after:
            parts.append(
                f'<details><summary>The numbers</summary><div class="wide" role="region" aria-label="{plain}: table" '
                f'tabindex="0">{after}</div></details>'
            )
        parts.append("</section>")
    style = Path(__file__).with_name("page.css").read_text(encoding="utf-8")
    write_whole(
        data.folder / "index.html", f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<title>Limit curves of a soft finger</title>
<style>
{style}</style>
</head>
<body>
<main>
<h1>Limit curves of a soft finger</h1>
<p>A finger pad that slides and twists at once cannot bear its full friction force and its full friction moment
together: the limit curve is the pairs that it can just bear. f = F/(μP) and m = M/(μPa) are force and moment in units
of load P, friction coefficient μ and contact radius a; the centre of rotation (COR) is the point that does not move.
Eq. (n) is that of the paper named at the end. Each figure has its data below it.</p>
<ul class="numbers">{head}</ul>
<nav aria-labelledby="contents"><h2 id="contents">Contents</h2><ol>{contents}</ol></nav>
{"".join(parts)}
<footer>A. Frisoli, F. Barbagli, E. Ruffaldi, K. Salisbury, M. Bergamasco, <em>A limit-curve based soft finger
god-object algorithm</em>, Haptics Symposium 2006.</footer>
</main>
</body>
</html>
""".encode("utf-8"))
