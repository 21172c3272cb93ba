#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the figures of docs/stability.md from what `stability_study` measured.

usage: figures.py MEASURED OUTPUT_FOLDER     every FIGURE.csv as FIGURE.svg (and .png), the same bytes each time
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import motion_figures  # noqa: E402
import numerics_figures  # noqa: E402
from report.chart_style import Table, save  # noqa: E402

MODULES = (numerics_figures, motion_figures)
LARGEST = 60_000  # bytes of a figure in docs/


def main():
    folder, output = map(Path, sys.argv[1:])
    output.mkdir(parents=True, exist_ok=True)
    figures = {name: draw for module in MODULES for name, draw in module.FIGURES.items()}
    measured = {path.stem for path in folder.glob("*.csv")} - {"summary"}
    if measured != set(figures):
        sys.exit(f"figures.py: error: measured but not drawn, or drawn but not measured: {sorted(measured ^ set(figures))}")
    for name, draw in figures.items():
        save(draw(Table.read(folder / f"{name}.csv")), output, name)
        size = (output / f"{name}.svg").stat().st_size
        if size > LARGEST:
            sys.exit(f"figures.py: error: {name}.svg has {size} bytes: expected at most {LARGEST}")


if __name__ == "__main__":
    main()
