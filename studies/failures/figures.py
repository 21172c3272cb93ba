# SPDX-License-Identifier: MIT
"""Draws the figures of docs/stability.md from what `stability_study` measured: each an entry of FIGURES."""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from report.chart_style import (BLUE, DASHES, FAINT, GREEN, INK, ORANGE, PURPLE, VERMILION, Table,  # noqa: E402
                                law_style, legend_below, plt, save)

OURS = "limitcurve"
COLOURS = (VERMILION, ORANGE, GREEN, PURPLE, FAINT)
LAWS = ("hertz", "uniform", "flat-punch", "cone")
COR = "centre of rotation  s = c/a"


def styles(names):
    """Ours blue and above the others; a law in its own colour and dashes; else colours and dashes in order."""
    others = [name for name in names if name != OURS and name not in LAWS]
    style = {name: {"color": COLOURS[i], "dashes": DASHES[i], "linewidth": 1.2} for i, name in enumerate(others)}
    style |= {name: {**law_style(name), "linewidth": 1.2} for name in names if name in LAWS}
    return style | {OURS: {"color": BLUE if "hertz" not in names else INK, "linewidth": 1.5, "zorder": 3}}


def error(title, **labels):
    """Axes of a relative error."""
    return {
        "title": title,
        "xlabel": COR,
        **labels, "yscale": "log",
        "ylim": (1e-17, 1e2),
        "yticks": [10.0 ** k for k in range(-16, 3, 4)]
    }


RATE = {"xlabel": "rate [Hz]", "xscale": "log", "yscale": "log", "xlim": (100, 1e4)}
# Of each figure what is set of the axes of its panels.
FIGURES = {
    "quadrature_rim": {
        "across": error("Relative error of the force, 1e-9 asked", xlim=(0, 2))
    },
    "quadrature_singular": {
        "exponent": error("Error of the force at s = ½, pressure $(1-\\rho^2)^n$",
                          xlabel="n + 1   (½: flat punch;  → 0: ring)",
                          xscale="log",
                          xlim=(1, 1e-3)),
        "cor": error("… against the COR, n = −0.9", xlim=(0, 3))
    },
    "closed_forms_far": {
        "far": error("Relative error of the moment far away: as printed, and ours", xscale="log", xlim=(1.1, 1e8))
    },
    "tables_spacing": {
        "numbers": {
            "title": "Largest error of f and m, flat punch",
            "xlabel": "numbers in the table",
            "xscale": "log",
            "yscale": "log",
            "xlim": (15, 3000)
        }
    },
    "turns_half": {
        "moment": {
            "title": "Moment of a slow twist over its limit; slips after 4 rad",
            "xlabel": "turned by [rad]",
            "xlim": (0, 12),
            "ylim": (-1.15, 1.15),
            "xticks": [math.pi * k for k in range(4)],
            "xticklabels": ["0", "π", "2π", "3π"]
        }
    },
    "reality_rates": {
        "force": {
            "title": "Largest friction / limit, scrubbing up to 0.25 m/s",
            "ylim": (0.5, 1e3),
            **RATE
        },
        "error": {
            "title": "Our error of the friction while stirring / limit",
            "ylim": (1e-3, 1),
            **RATE
        }
    },
}


def draw(measured, folder):
    """Every FIGURE.csv of one folder as FIGURE.svg (and .png) in another."""
    for name, panels in FIGURES.items():
        rows = Table.read(measured / f"{name}.csv")
        figure, axes = plt.subplots(1,
                                    len(panels),
                                    figsize=(9.6 if len(panels) > 1 else 6.4, 3.2),
                                    squeeze=False)
        style = styles(list(rows.groups("series")))
        for one, (panel, labels) in zip(axes[0], panels.items()):
            for series, points in rows.where(panel=panel).groups("series").items():
                one.plot(points.column("x"), points.column("value"), label=series, **style[series])
            one.set(**labels)
            one.minorticks_off()
        legend_below(figure, axes[0][0], 5 if len(style) > 3 else 3)
        save(figure, folder, name)
