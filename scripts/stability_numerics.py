# SPDX-License-Identifier: MIT
"""Figures of docs/stability.md, entries quadrature, tables and fits: one function a figure, takes its rows, returns a figure."""

from chart_style import BLUE, FAINT, GREEN, ORANGE, PURPLE, VERMILION, legend_below, plt

OURS = "limitcurve"
COLOURS = (VERMILION, ORANGE, GREEN, PURPLE, FAINT)
NO_DIGIT_LEFT = 1.0


def error_panels(rows, titles, x_label, y_label, x_scale="linear", columns=4, floor=2e-17, top=30):
    """A panel for each of `titles` (panel -> title): one line a series, ours in blue over the others."""
    figure, panels = plt.subplots(1, len(titles), figsize=(9.6 if len(titles) > 1 else 6.4, 3.4), layout="constrained", sharey=True,
                                  squeeze=False)
    names = list(dict.fromkeys(row["series"] for row in rows if row["series"] != OURS))
    for axes, (panel, title) in zip(panels[0], titles.items()):
        for series, points in rows.where(panel=panel).groups("series").items():
            ours = series == OURS
            axes.plot(points.column("x"), points.column("value"), label=series, color=BLUE if ours else COLOURS[names.index(series)],
                      linewidth=1.4 if ours else 1.1, zorder=3 if ours else 2)
        axes.set(title=title, xlabel=x_label, xscale=x_scale, yscale="log", ylim=(floor, top))
    panels[0][0].set_ylabel(y_label)
    legend_below(figure, panels[0][0], columns)
    return figure


def quadrature_rim(rows):
    return error_panels(rows, {"force": "The force of a Hertz contact by one integral over the radius"},
                        "distance of the centre of rotation  s = c/a", "relative error of f")


FIGURES = {"quadrature_rim": quadrature_rim}
