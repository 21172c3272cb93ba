#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the figures of docs/stability.md from what `stability_atlas` measured.

usage: stability_figures.py ATLAS_FOLDER OUTPUT_FOLDER     every FIGURE.csv as FIGURE.svg (and .png), the same bytes each time
"""

import re
import sys
from pathlib import Path

import stability_motion
import stability_numerics
from chart_style import Table, save

MODULES = (stability_numerics, stability_motion)
LARGEST = 60_000  # bytes of a figure in docs/


def shorter(match):
    text = match[0]
    return text if text.startswith("scale") else f"{float(text):.2f}".rstrip("0").rstrip(".")


def slim(svg):
    """The same picture in fewer bytes: hundredths of a point, short names of glyphs, no comments, no indentation."""
    for i, glyph in enumerate(dict.fromkeys(re.findall(r'id="(DejaVu[^"]+)"', svg))):
        svg = re.sub(rf'(id="|href="#){glyph}"', rf'\g<1>g{i}"', svg)
    svg = re.sub(r"<!--.*?-->\s*|<metadata>.*?</metadata>\s*", "", svg, flags=re.S)
    svg = re.sub(r"scale\([^)]*\)|\d+\.\d{3,}", shorter, svg)
    return re.sub(r"\s*\n\s*", "\n", svg)


def main():
    atlas, output = map(Path, sys.argv[1:])
    output.mkdir(parents=True, exist_ok=True)
    figures = {name: draw for module in MODULES for name, draw in module.FIGURES.items()}
    measured = {path.stem for path in atlas.glob("*.csv")} - {"summary"}
    if measured != set(figures):
        sys.exit(f"stability_figures.py: error: measured but not drawn, or drawn but not measured: {sorted(measured ^ set(figures))}")
    for name, draw in figures.items():
        save(draw(Table.read(atlas / f"{name}.csv")), output, name)
        file = output / f"{name}.svg"
        file.write_text(slim(file.read_text(encoding="utf-8")), encoding="utf-8")
        if file.stat().st_size > LARGEST:
            sys.exit(f"stability_figures.py: error: {name}.svg has {file.stat().st_size} bytes: expected at most {LARGEST}")


if __name__ == "__main__":
    main()
