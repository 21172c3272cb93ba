# SPDX-License-Identifier: MIT
"""The functions that return tables: the command line's own code, with arrays in place of files.

Errors, columns and defaults are the command line's, because its own code runs. The command reads arrays as it does
files; rows come back as arrays, without conversion to text.
"""

from __future__ import annotations

import difflib
import functools
import inspect
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._call import Call, Columns, Data
from ._core import Law, Patch, finger_parameter_table


_Function = TypeVar("_Function", bound=Callable[..., Any])


def _check_keywords(function: _Function) -> _Function:
    """Names an unknown keyword, and the one that was meant."""
    parameters = inspect.signature(function).parameters
    known = [name for name in parameters if name not in ("cls", "finger")]
    if "finger" in parameters:
        known += finger_parameter_table

    @functools.wraps(function)
    def wrapper(*arguments: Any, **given: Any) -> Any:
        for name in given:
            if name not in known:
                near = difflib.get_close_matches(name, known, 1)
                raise TypeError(f"{function.__name__}: unknown parameter {name!r}, expected {', '.join(known)}" +
                                "".join(f"; did you mean {one!r}?" for one in near))
        for name in ("columns", "units"):
            if given.get(name) is not None and not isinstance(given[name], Mapping):
                raise ValueError(f"{name}: got {given[name]!r}, expected a dict, such as " +
                                 ("{'load': 'Fz'}" if name == "columns" else "{'moment': 'Nmm'}"))
        return function(*arguments, **given)

    return cast("_Function", wrapper)


def run(subcommand: str, *arguments: str, **options: Any) -> Columns:
    """Runs any subcommand of the command line and returns its table; `limitcurve SUBCOMMAND --help` lists options,
    columns and units.

    Options are keywords with `_` in place of `-`; flags are True; lists are sequences; files may be columns (a dict of
    arrays).

    >>> import limitcurve as lc
    >>> table = lc.run("eval", law="hertz", c=[0.25, 0.5, 1])
    >>> list(table)
    ['c', 'force', 'moment', 'force_error', 'moment_error']
    """
    return _run([subcommand, *arguments], options)


def _run(words: list[str], options: dict[str, Any], notes: list[str] | None = None) -> Columns:
    call = Call(*words)
    for name, value in options.items():
        call.option(name, value)
    return call.run(notes)


@_check_keywords
def validate(
    law: str | Law | Sequence[str | Law] | None = None,
    *,
    patch: str | Patch | Sequence[str | Patch] | None = None,
    points: Data | None = None,
    mu: float | None = None,
    load: float | None = None,
    radius: float | None = None,
) -> Columns:
    """Errors of ellipse, box, diamond and Padé model against the exact curve of one, several or all laws; or of round
    models of patches; or of `points`.

    `limitcurve validate --help` explains the columns; errors are fractions.

    >>> import limitcurve as lc
    >>> table = lc.validate("hertz")
    >>> round(float(table["max_error"][table["model"] == "ellipse"][0]), 4)
    0.0638
    """
    return run("validate", **locals())


@_check_keywords
def choose(
    law: str | Law | None = None,
    tolerance: float = 0.01,
    *,
    patch: str | Patch | None = None,
    scene: bool = False,
    mu: float | None = None,
    radius_law: str | None = None,
    mu_r: float | None = None,
    loads: ArrayLike | None = None,
    stiffness: float | None = None,
    twist_stiffness: float | None = None,
    sample_time: float | None = None,
    slide_speed: float | None = None,
    twist_rate: float | None = None,
    slide: float | None = None,
    twist: float | None = None,
) -> Columns:
    """The cheapest limit curve whose error is at most `tolerance`, and the others; with `scene` the whole step of a
    scene.

    `limitcurve choose --help` explains the columns.

    >>> import limitcurve as lc
    >>> table = lc.choose("hertz", tolerance=0.01)
    >>> int(table["chosen"].sum())
    1
    """
    return run("choose", **locals())


class Fit(Columns):
    """A fit: its columns by name, and what belongs to all of them.

    `covariance` is the matrix of the parameters' covariances, in the order of the rows, in the product of their units:
    None without data, for a curve has no noise, and for `friction`. `note` is the fitted model with its assumptions;
    `notes` are remarks on the fit and the options that use its result.
    """

    covariance: NDArray[np.float64] | None
    note: str
    notes: list[str]


@_check_keywords
def fit(
    model: str,
    data: Data | None = None,
    *,
    columns: Mapping[str, str] | None = None,
    units: Mapping[str, str] | None = None,
    least_load: float | None = None,
    zero: bool = False,
    law: str | Law | None = None,
    patch: str | Patch | None = None,
    load: float | None = None,
    criterion: str | None = None,
    loss: str | None = None,
    load_model: str | None = None,
    gamma: float | None = None,
    fit_gamma: bool = False,
    residuals: bool = False,
    largest_radius: float | None = None,
    quiet: bool = False,
) -> Fit:
    """Fits a friction model to measurements, or an approximation to the exact curve of a law (no `data`).

    Models: ellipse, ratio, law (data: load, force, moment[, sigma_force, sigma_moment]); load (data: load and radius or
    moment); friction (with `patch`). `columns` are the data's names where they differ, {"load": "Fz"}; `units` its
    units where they are not SI, {"length": "mm", "moment": "Nmm", "angle": "deg"}. Rows with a smaller load than
    `least_load` and rows with NaN are left out. Of a sensor's log, `zero` subtracts what the pauses show, a moment
    "Fx:Fy:Fz:Tx:Ty:Tz" is about the contact wherever the sensor sits, and loss="edge" needs no marks of slips.
    Columns: parameter, value, std_error, unit, note; with `residuals` instead the residual [standard deviations outside
    the curve] and row of each slip. Warnings are Python's; none, and no notes, if `quiet`.

    >>> import limitcurve as lc
    >>> table = lc.fit("ellipse", law="hertz", quiet=True)
    >>> [str(name) for name in table["parameter"]]
    ['force_max', 'moment_max']
    """
    options = dict(locals(), covariance=data is not None and model != "friction" and not residuals)
    notes: list[str] = []
    found = _run(["fit", options.pop("model")], options, notes)
    rows = [found.pop(name) for name in list(found) if name.startswith("covariance_")]
    result = Fit(found)
    result.covariance = np.array(rows) if rows else None
    result.note = "" if residuals else str(found["note"][0])
    result.notes = notes
    return result


@_check_keywords
def hold(
    law: str | Law | None = None,
    radius_law: str | None = None,
    mu: float | None = None,
    *,
    force: ArrayLike | None = None,
    moment: float | None = None,
    data: Data | None = None,
    columns: Mapping[str, str] | None = None,
    units: Mapping[str, str] | None = None,
    least_load: float | None = None,
    zero: bool = False,
    mu_r: float | None = None,
    gamma: float | None = None,
    curve: str | None = None,
    patch: str | Patch | None = None,
    fingers: int | None = None,
    mass: float | None = None,
    offset: float | None = None,
    down: ArrayLike | None = None,
    gravity: float | None = None,
) -> Columns:
    """The smallest load [N] that carries a force and a moment without slip: of one wrench, of each row of `data`, or of
    an object held by `fingers`.

    `limitcurve hold --help` explains the columns. `columns`, `units`, `least_load` and `zero` are as in `fit`.

    >>> import limitcurve as lc
    >>> table = lc.hold("hertz", "constant:a=0.006", mu=0.6, force=1.2, moment=0)
    >>> round(float(table["hold_load"][0]), 9)
    2.0
    """
    return run("hold", **locals())


@_check_keywords
def translate(
    law: str | Law | None = None,
    radius_law: str | None = None,
    mu: ArrayLike | None = None,
    load: float | None = None,
    *,
    mu_r: float | None = None,
    gamma: float | None = None,
    patch: str | Patch | None = None,
    loads: ArrayLike | None = None,
    engine: str | None = None,
    read: str | Sequence[str] | None = None,
    explain: bool = False,
) -> Columns:
    """The coefficients for physics engines, with the error that remains in each; of one `engine` alone, if it is named.

    With `mu_r` and `gamma`, as measured, in place of radius_law. With `patch` in place of law, radius law and load: for
    a contact that is not round. `limitcurve translate --help` explains the columns.

    `read`, with law and mu alone: what numbers in a scene mean. Numbers of one engine belong to one contact, until a
    parameter comes again.

    >>> import limitcurve as lc
    >>> table = lc.translate("hertz", "constant:a=0.006", mu=0.6, load=2)
    >>> "mujoco" in table["engine"]
    True
    >>> round(float(lc.translate("hertz", mu=1, read="mujoco.torsional=0.005")["radius"][0]), 6)
    0.008488
    """
    return run("translate", **locals())


@_check_keywords
def replay(
    trace: Data,
    law: str | Law | None = None,
    *,
    patch: str | Patch | None = None,
    point_radius: float | None = None,
    radius_law: str | None = None,
    curve: str | None = None,
    projection: str | None = None,
    tolerance: float | None = None,
    surface: str | None = None,
    body: str | None = None,
    fingers: int | None = None,
    columns: Mapping[str, str] | None = None,
    units: Mapping[str, str] | None = None,
    details: bool = False,
    **finger: float | None,
) -> Columns:
    """Runs the god-object over a recorded motion: columns time, x, y, z, twist [s, m, rad] (`limitcurve replay --help`
    lists more).

    `finger` are the numbers of SoftFinger; mu, stiffness and twist_stiffness are required. `columns` and `units` are as
    in `fit`.

    Columns: time, state, px, py, angle, depth, load, fx, fy, moment, cor, and the columns of the options.

    >>> import limitcurve as lc, numpy as np
    >>> t = np.linspace(0, 1, 101)
    >>> trace = {"time": t, "x": 0.02 * t, "y": 0 * t, "z": 0 * t - 0.002, "twist": 0 * t}
    >>> table = lc.replay(trace, "hertz", radius_law="constant:a=0.006", mu=0.6, stiffness=1000, twist_stiffness=0.036)
    >>> str(table["state"][-1]), round(float(table["fx"][-1]), 9)
    ('slip', -1.2)
    """
    options = dict(locals())
    del options["finger"]
    if isinstance(trace, np.ndarray) and trace.dtype.names is None:
        if trace.ndim != 2 or trace.shape[1] != 5:
            raise ValueError(f"trace: got the shape {trace.shape}, expected (n, 5): time, x, y, z, twist")
        trace = dict(zip(("time", "x", "y", "z", "twist"), trace.T))
    return run("replay", **options | finger | {"trace": trace})
