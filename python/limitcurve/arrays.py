# SPDX-License-Identifier: MIT
"""Friction within a table in arrays of NumPy, JAX, torch or another library of the array API standard; differentiable
once.

>>> import limitcurve as lc
>>> from limitcurve import arrays
>>> cells = arrays.cells(lc.Table("hertz", 1e-8))  # arrays.cells(table, jax.numpy) for JAX
>>> f, m, slips = arrays.closest_point(cells, [0.2, -2.0], [0.1, 0.0], 1.0)
>>> [round(float(x), 6) for x in f], slips.tolist()
([0.2, -1.0], [False, True])

Numbers, lists and arrays broadcast against each other, and become arrays of the cells' library and type. NaN stays
NaN.
"""

import os
import sys
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from ._core import Table

newton_steps = 12  # 8 may be off by 1e-3
part_size = 10_000
Cells = NamedTuple("Cells", [("inside", Any), ("outside", Any),
                             ("rows", Any)])  # where cells begin on each side of the rim; (x, c0 ... c6) of all

def cells(table: "Table | str | os.PathLike[str]", library: Any = np, dtype: Any = None) -> Cells:
    """The cells of a Table, or of a file of one, as arrays of a library; `dtype` is one of its floating types, float64
    if None."""
    rows = (table if isinstance(table, Table) else Table.load(table)).cells
    rows = rows[np.lexsort((rows[:, 1], rows[:, 0]))]
    parts = rows[rows[:, 0] == 0, 1], rows[rows[:, 0] == 1, 1], rows[:, 1:].copy()
    return Cells(*(library.asarray(part, dtype=dtype or library.float64) for part in parts))

def _given(cells: Cells, *numbers: Any) -> "tuple[Any, ...]":
    """The library of the cells, and the numbers as its arrays."""
    if not isinstance(cells, Cells):
        raise TypeError(f"cells: got {type(cells).__name__}, expected what cells() made of a table")
    rows = cells.rows
    xp = rows.__array_namespace__() if hasattr(
        rows, "__array_namespace__") else sys.modules[type(rows).__module__.partition(".")[0]]
    if any(map(np.ma.is_masked, numbers)):
        raise ValueError("got masked numbers, expected none: fill or compress them")
    return xp, *(xp.asarray(number, dtype=rows.dtype) for number in numbers)

def _constant(array: Any) -> Any:
    """The array, without its derivative."""
    if hasattr(array, "detach"):
        return array.detach()
    jax = sys.modules.get("jax")
    return jax.lax.stop_gradient(array) if jax and isinstance(array, jax.Array) else array

def _magnitude(xp: Any, x: Any) -> "tuple[Any, Any]":
    """The sign of x, 1 for 0, and |x|, whose derivative at 0 is that on the right."""
    one = xp.ones_like(x)
    sign = xp.where(x < 0, -one, one)
    return sign, sign * x

def _jet(cell: Any, x: Any) -> "tuple[Any, Any, Any]":
    """D, D' and D'' of the support function at x, which is c/a inside the rim and a/c outside."""
    t, d, first, second = x - cell[..., 0], 0 * x, 0 * x, 0 * x
    for k in range(7, 0, -1):
        d, first, second = d * t + cell[..., k], first * t + d, second * t + first
    return d, first, 2 * second


def _root(xp: Any, cells: Cells, outside: Any, residual: "Callable[..., tuple[Any, Any, Any]]", *given:
          Any) -> "tuple[Any, Any]":
    """Cell and x in [0, 1] where `residual(given, x, D, D', D'')` is 0: a value that falls with x, minus its slope, and
    the value's rounding. The cell is found by bisection, then x by Newton's method in a bracket. Only the last step has
    a derivative: that of the implicit function."""
    inside, count = cells.inside.shape[0], cells.rows.shape[0]
    fixed, rows = tuple(map(_constant, given)), _constant(cells.rows)
    begin, end = xp.where(outside, inside, 0), xp.where(outside, count, inside)
    high = xp.ones_like(rows[begin, 0])
    for _ in range(max(inside, count - inside).bit_length()):
        middle = (begin + end) // 2
        x = rows[middle, 0]
        above = (residual(fixed, x, rows[middle, 1], rows[middle, 2], 0 * x)[0] > 0) | (middle == begin)
        begin, end, high = xp.where(above, middle, begin), xp.where(above, end, middle), xp.where(above, high, x)
    cell = rows[begin]
    x = low = cell[..., 0]
    for _ in range(newton_steps):
        value, slope, rounding = residual(fixed, x, *_jet(cell, x))
        low, high = xp.where(value > 0, x, low), xp.where(value > 0, high, x)
        new = x + value / xp.where(slope > 0, slope, 1.0)
        new = xp.where((slope > 0) & (new >= low) & (new <= high), new, (low + high) / 2)
        x = xp.where(xp.abs(value) > rounding, new,
                     x)  # below its rounding the sign is chance, and would cut the root out
    cell = cells.rows[begin]
    value, slope, _ = residual(given, x, *_jet(cell, x))
    new = x + value / _constant(xp.where(slope > 0, slope, 1.0))
    return cell, new + _constant(xp.where((slope > 0) & (new >= low) & (new <= high), new, x) - new)

def _wrench(xp: Any, outside: Any, cell: Any, x: Any) -> "tuple[Any, Any]":
    d, first, _ = _jet(cell, x)
    return xp.where(outside, d - x * first, first), xp.where(outside, first, d - x * first)

def _slip(cells: Cells, slide: Any, spin: Any) -> "tuple[Any, ...]":
    """Library, whether nothing slips, whether beyond the rim, cell and x of slips."""
    xp, slide, spin = _given(cells, slide, spin)
    slide, spin = _magnitude(xp, slide)[1], _magnitude(xp, spin)[1]
    outside, rests = slide > spin, (slide == 0) & (spin == 0)
    x = xp.where(outside, spin, slide) / xp.where(rests, 1.0, xp.where(outside, slide, spin))
    beyond = cells.inside.shape[0] + xp.searchsorted(cells.outside, x, side="right")
    return xp, rests, outside, cells.rows[xp.where(outside, beyond, xp.searchsorted(cells.inside, x, side="right")) -
                                          1], x

def wrench(cells: Cells, slide: Any, spin: Any) -> "tuple[Any, Any]":
    """F/(mu P) and M/(mu P a) of slips of slide |v| and spin a|omega|, without signs; no slip gives 0. Error:
    checked_error."""
    xp, rests, *place = _slip(cells, slide, spin)
    force, moment = _wrench(xp, *place)
    return xp.where(rests, 0.0, force), xp.where(rests, 0.0, moment)

def closest_point(cells: Cells, force: Any, moment: Any, chi: Any) -> "tuple[Any, Any, Any]":
    """(force, moment, slips): trial unit wrenches; those that slip become the curve's points nearest to them, with the
    trial's signs, where a change of the moment costs chi = a^2 k_l/k_r, in [1e-3, 1e3], times one of the force."""
    xp, *given = _given(cells, force, moment, chi)
    if xp is np and np.broadcast(*given).size > part_size:  # what is calculated on the way then stays in the cache
        given = list(np.broadcast_arrays(*given))
        parts = [
            closest_point(cells, *(one.flat[at:at + part_size]
                                   for one in given))
            for at in range(0, given[0].size, part_size)
        ]
        force, moment, slips = (np.concatenate(part).reshape(given[0].shape) for part in zip(*parts))
        return force, moment, slips
    force, moment, chi = given
    (force_sign, f), (moment_sign, m) = _magnitude(xp, force), _magnitude(xp, moment)
    eps = float(xp.finfo(f.dtype).eps)
    far = xp.maximum(f, m) * eps * eps
    f, m = (part / xp.where(far > 1, far, 1.0) for part in (f, m))  # from afar only the direction counts
    rim_force, rim_moment = wrench(cells, 1.0, 1.0)
    outside = f - rim_force > chi * (m - rim_moment)
    leading, trailing = xp.where(outside, m, f), xp.where(outside, f, m)

    def residual(trial: Any, x: Any, d: Any, first: Any, second: Any) -> "tuple[Any, Any, Any]":
        lead, trail, kappa = trial
        over = kappa * (trail - d + x * first)
        return lead - first - x * over, second * (1 + kappa * x * x) + over, 4 * eps * (lead + x * kappa * trail)

    cell, x = _root(xp, cells, outside, residual, leading, trailing, xp.where(outside, 1 / chi, chi))
    d, first, _ = _jet(cell, x)
    to_force, to_moment = _wrench(xp, outside, cell, x)
    slips = ~(trailing + x * leading <= d * (1 + (1e-12 if eps < 1e-10 else 2**-18)))  # slip_onset
    nothing = sum(0 * _constant(number) for number in (force, moment, chi))
    return xp.where(slips, force_sign * to_force, force) + nothing, xp.where(slips, moment_sign * to_moment,
                                                                             moment) + nothing, slips


def tangent_ellipse(cells: Cells,
                    force: Any = None,
                    moment: Any = None,
                    p: Any = None,
                    q: Any = None,
                    *,
                    slip: Any = None) -> "tuple[Any, Any]":
    """Semi-axes, as Table.tangent_ellipse: of the unit wrench that an engine found with the semi-axes p and q; without
    these on its ray; or of slip = (|v|, a|omega|)."""
    limits = _given(cells)[0].finfo(cells.rows.dtype)
    if ((force is None) != (moment is None) or (force is None) == (slip is None) or (p is None) != (q is None)
            or (p is not None and force is None) or (slip is not None and len(slip) != 2)):
        raise ValueError("tangent_ellipse: expected force and moment, or these with p and q, or slip=(v, u)")

    def per_x(x: Any, first: Any, second: Any) -> Any:  # D'/x, D'(0) = 0
        least = float(limits.tiny) * 2.0**30
        return xp.where(x > least, first / xp.where(x > least, x, 1.0), second)

    def on_ray(to: Any, x: Any, d: Any, first: Any, second: Any) -> "tuple[Any, Any, Any]":
        up, down = to[0] * (d - x * first), to[1] * first
        return up - down, second * (to[1] + x * to[0]), 4 * float(limits.eps) * (up + down)

    def split(to: Any, x: Any, d: Any, first: Any, second: Any) -> "tuple[Any, Any, Any]":
        each = per_x(x, first, second)  # x sqrt(each/D) is the root of the leading share of the power
        rise = (each / d) ** 0.5
        return to[0] - x * rise, (each + second - first * first / d) / (
            2 * d * xp.where(rise == 0, 1.0, rise)), 4 * float(limits.eps) * to[0]

    if slip is not None:
        xp, rests, outside, cell, x = _slip(cells, *slip)
        nothing = 0 * x
    else:
        xp, force, moment, *axes = _given(cells, force, moment, *(() if p is None else (p, q)))
        f, m = _magnitude(xp, force)[1], _magnitude(xp, moment)[1]
        largest = xp.maximum(f, m)
        f, m = (part / xp.where(largest == 0, 1.0, largest) for part in (f, m))
        if axes:
            f, m = f / _magnitude(xp, axes[0])[1], m / _magnitude(xp, axes[1])[1]
        size = xp.hypot(f, m)
        rests, nothing = size == 0, 0 * _constant(size)
        f, m = f / xp.where(rests, 1.0, size), m / xp.where(rests, 1.0, size)
        rim_force, rim_moment = wrench(cells, 1.0, 1.0)
        outside = f * rim_moment > m * rim_force if p is None else f * f * rim_moment > m * m * rim_force
        cell, x = _root(xp, cells, outside, on_ray if p is None else split, xp.where(outside, m, f),
                        xp.where(outside, f, m))
    d, first, second = _jet(cell, x)
    leading, trailing = (d * per_x(x, first, second)) ** 0.5, (d * (d - x * first)) ** 0.5
    usual = cells.rows[cells.inside.shape[0], 1], cells.rows[0, 1]
    return (xp.where(rests, usual[0], xp.where(outside, trailing, leading)) + nothing,
            xp.where(rests, usual[1], xp.where(outside, leading, trailing)) + nothing)
