# SPDX-License-Identifier: MIT
"""Charts with matplotlib. Each function draws on the given axes or on new ones, and returns them.

>>> import limitcurve as lc
>>> import limitcurve.plot
>>> axes = lc.plot.limit_curve("hertz")
"""

from __future__ import annotations

import csv
import itertools
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ._core import Law
from ._call import Columns, Data, named_columns
from ._tables import run, validate

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        raise ImportError("limitcurve.plot needs matplotlib: pip install 'limitcurve[plot]'") from error
    return plt.subplots(layout="constrained")[1]


def _finished(ax: Axes, force: str, moment: str) -> Axes:
    ax.set(xlabel=force, ylabel=moment, xlim=(0, None), ylim=(0, None))
    ax.legend(frameon=False)
    return ax


def _model(model: str, parameter: float, m0: float, law: Law, points: int = 257) -> tuple[Any, Any]:
    """Points (f, m) of a model of `validate` with its parameter."""
    angle = np.linspace(0, np.pi / 2, points)
    x, y = np.cos(angle), np.sin(angle)
    if model.startswith("ellipse"):
        return parameter * x, parameter * m0 * y
    if model == "box":
        return np.array([1.0, 1.0, 0.0]), np.array([0.0, m0, m0])
    if model == "diamond":
        return np.array([1.0, 0.0]), np.array([0.0, m0])
    if model == "pade":  # of a slip at x/y radii; exact in the slope of the moment at a pure slide
        far = 1e9
        half = float(law.evaluate(far)[1]) * far / m0
        return x / (x + max(parameter, 1e-300) * y), m0 * half * y / (x + half * y)
    raise ValueError(f"fits: {model} has no drawing")


def limit_curve(
    law: str | Law | Sequence[str | Law],
    *,
    fits: Sequence[str] = ("ellipse",),
    points: Data | None = None,
    mu: float | None = None,
    radius: ArrayLike | None = None,
    radius_law: str | None = None,
    ax: Axes | None = None,
) -> Axes:
    """Limit curves of one or several laws, in units of mu P and mu P a, with models of `validate` for the first law,
    listed in `fits`.

    points: measured slips (columns load, force, moment [N, N, N m]); they need mu and the contact radius [m], one for
    all, one for each, or a radius law, which gives each the radius at its own load.
    """
    ax = _axes(ax)
    given = [law] if isinstance(law, (str, Law)) else list(law)
    laws = [one if isinstance(one, Law) else Law(one) for one in given]
    if not laws:
        raise ValueError("law: got an empty list, expected one or more")
    s = np.concatenate([np.linspace(0, 1, 129), 1 / np.linspace(1, 0, 128, endpoint=False)[1:], [np.inf]])
    for one in laws:
        ax.plot(*one.evaluate(s), label=one.name)
    if fits:
        first = laws[0]
        errors = validate(first)
        dashes = itertools.cycle(["--", ":", "-."])
        unequal_ellipses = {"ellipse-least-squares", "ellipse-inner"}
        for name in (word.replace("_", "-") for word in fits):
            rows = np.flatnonzero(errors["model"] == name)
            if rows.size == 0:
                raise ValueError(f"fits: got {name!r}, expected one of {', '.join(errors['model'])}")
            parameter = float(errors["parameter"][rows[0]])
            m0 = first.moment_ratio
            if name in unequal_ellipses:  # its other semi-axis is a row of fit
                criterion = name.removeprefix("ellipse-")
                values = run("fit", "ellipse", law=first, criterion=criterion, quiet=True)["value"]
                parameter, m0 = float(values[0]), float(values[1]) / float(values[0])
            worst = 100 * float(errors["max_error"][rows[0]])
            ax.plot(*_model(name, parameter, m0, first),
                    linestyle=next(dashes),
                    linewidth=1,
                    color="0.3",
                    label=f"{name}, off by up to {worst:.2g} %")
    if points is not None:
        if mu is None or (radius is None) == (radius_law is None):
            raise ValueError("points: expected mu and one of radius and radius_law too, which make them unit wrenches")
        data = _columns("points", points, ("load", "force", "moment"))
        limit = mu * data["load"]
        if radius_law is not None:
            loads, places = np.unique(data["load"], return_inverse=True)
            spins = run("p-curves", law=laws[0], radius_law=radius_law, mu=mu, loads=loads, points=2)
            moments = spins["moment"][spins["c"] == 0]  # of a pure spin at each load: mu P a m0
            radius = (moments / (mu * loads * laws[0].moment_ratio))[places]
        ax.plot(np.abs(data["force"]) / limit,
                np.abs(data["moment"]) / (limit * radius),
                ".",
                color="0.5",
                markersize=4,
                label="measured")
    return _finished(ax, r"force $F/(\mu P)$ [1]", r"moment $M/(\mu P a)$ [1]")


def _columns(name: str, data: Data, needed: Sequence[str]) -> dict[str, Any]:
    if isinstance(data, (str, os.PathLike)):
        with open(data, encoding="utf-8", newline="") as lines:
            rows = list(csv.reader(line for line in lines if line.strip() and not line.startswith("#")))
        data = {column: _numbers([row[i] for row in rows[1:]]) for i, column in enumerate(rows[0])}
    columns, refused = named_columns(name, data)
    for column, wrong in zip((column for column, _ in columns), refused):
        if column in needed and wrong:
            raise ValueError(wrong)
    found = dict(columns)
    if missing := [column for column in needed if column not in found]:
        raise ValueError(f"{name}: no column {missing[0]!r}, expected {', '.join(needed)}")
    return found


def _numbers(texts: list[str]) -> list[Any]:
    """Or the texts, where one is no number."""
    try:
        return [float(text) for text in texts]
    except ValueError:
        return texts


def p_curves(law: str | Law,
             radius_law: str,
             mu: float,
             loads: ArrayLike,
             *,
             points: int = 129,
             ax: Axes | None = None) -> Axes:
    """Limit curves in N and N m at several loads [N]: force is proportional to mu P, moment to mu P a(P)."""
    ax = _axes(ax)
    table = run("p-curves", law=law, radius_law=radius_law, mu=mu, loads=np.atleast_1d(loads), points=points)
    for load in np.unique(table["load"]):
        rows = table["load"] == load
        ax.plot(table["force"][rows], 1e3 * table["moment"][rows], label=f"P = {load:g} N")
    return _finished(ax, "force $F$ [N]", "moment $M$ [N mm]")


def c_curves(law: str | Law,
             radius_law: str,
             mu: float,
             cors: ArrayLike,
             loads: ArrayLike,
             *,
             ax: Axes | None = None) -> Axes:
    """The wrenches of slips about fixed centres of rotation `cors` [m], over the `loads` [N]; curved if a depends on
    P."""
    ax = _axes(ax)
    table = run("c-curves", law=law, radius_law=radius_law, mu=mu, cors=np.atleast_1d(cors), loads=np.atleast_1d(loads))
    for cor in np.unique(table["c"]):
        rows = table["c"] == cor
        ax.plot(table["force"][rows],
                1e3 * table["moment"][rows],
                label="pure sliding" if np.isinf(cor) else f"c = {1e3 * cor:g} mm")
    return _finished(ax, "force $F$ [N]", "moment $M$ [N mm]")


def approximation_errors(law: str | Law | Sequence[str | Law] | None = None, *, ax: Axes | None = None) -> Axes:
    """The largest over- and under-estimate of every model of `validate`, in percent, with a group of bars for each
    law."""
    ax = _axes(ax)
    table = validate(law)
    laws = list(dict.fromkeys(table["law"]))
    models = list(dict.fromkeys(table["model"]))
    width = 0.8 / len(laws)
    for i, name in enumerate(laws):
        rows = table["law"] == name
        places = np.array([models.index(model) for model in table["model"][rows]]) + width * (i - (len(laws) - 1) / 2)
        over = ax.bar(places, 100 * table["max_over_estimate"][rows], width, label=str(name))
        ax.bar(places, -100 * table["max_under_estimate"][rows], width, color=over.patches[0].get_facecolor())
    ax.axhline(0, color="0.3", linewidth=0.8)
    ax.set_xticks(range(len(models)), models, rotation=30, ha="right")
    ax.set_ylabel("too weak (below 0) and too strong [%]")
    ax.legend(frameon=False)
    return ax


def replay(
    table: Columns,
    *,
    stiffness: float,
    twist_stiffness: float,
    law: str | Law | None = None,
    mu: float | None = None,
    radius_law: str | None = None,
    ax: Axes | None = None,
) -> Axes:
    """A replay, the result of `limitcurve.replay`, drawn in the [r, rho] plane of the paper: the distance and the angle
    between finger and proxy, by which springs of these stiffnesses give its force and moment.

    With law, mu and radius_law, also the limits at the least, the median and the largest load that slips.
    """
    ax = _axes(ax)
    r = 1e3 * np.hypot(np.hypot(table["fx"], table["fy"]), table.get("fz", 0)) / stiffness
    rho = np.degrees(np.abs(table["moment"])) / twist_stiffness
    touching = (table["state"] == "stick") | (table["state"] == "slip")
    ax.plot(np.where(touching, r, np.nan), np.where(touching, rho, np.nan), color="0.6", linewidth=0.8)
    for state, colour in (("stick", "C0"), ("slip", "C1")):
        rows = table["state"] == state
        ax.plot(r[rows], rho[rows], ".", markersize=3, color=colour, label=state)
    slips = table["load"][(table["state"] == "slip") & (table["load"] > 0)]
    if law is not None and mu is not None and radius_law is not None and slips.size:
        curves = run("p-curves",
                     law=law,
                     radius_law=radius_law,
                     mu=mu,
                     loads=np.unique(np.quantile(slips, (0, 0.5, 1))),
                     points=129)
        for load in np.unique(curves["load"]):
            rows = curves["load"] == load
            ax.plot(1e3 * curves["force"][rows] / stiffness,
                    np.degrees(curves["moment"][rows] / twist_stiffness),
                    "k--",
                    linewidth=1,
                    alpha=0.3 + 0.7 * float(load / slips.max()),
                    label=f"limit at P = {load:.3g} N")
    return _finished(ax, "deflection $r$ [mm]", r"twist deflection $\rho$ [°]")
