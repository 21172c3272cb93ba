# SPDX-License-Identifier: MIT
"""Friction within a table in arrays of NumPy, JAX, torch or another library of the array API standard; differentiable.

>>> import limitcurve as lc, numpy as np
>>> from limitcurve import arrays
>>> cells = arrays.cells(lc.Table("hertz", 1e-8))  # arrays.cells(table, jax.numpy) for JAX
>>> f, m, slips = arrays.closest_point(cells, np.array([0.2, 2.0]), np.array([0.1, 0.0]), np.array([1.0, 1.0]))
>>> [round(float(x), 6) for x in f], slips.tolist()
([0.2, 1.0], [False, True])
"""

import os
import sys
from typing import Any, NamedTuple

import numpy as np

from ._core import Table

Cells = NamedTuple("Cells", [("inside", Any), ("outside", Any), ("rows", Any)])  # where cells begin on each side of the rim; (x, c0 ... c6) of all

def cells(table: "Table | str | os.PathLike[str]", library: Any = np, dtype: Any = None) -> Cells:
    """The cells of a Table, or of a file of one, as arrays of a library; `dtype` is one of its floating types, float64 if None."""
    rows = (table if isinstance(table, Table) else Table.load(table)).cells
    rows = rows[np.lexsort((rows[:, 1], rows[:, 0]))]
    parts = rows[rows[:, 0] == 0, 1], rows[rows[:, 0] == 1, 1], rows[:, 1:].copy()
    return Cells(*(library.asarray(part, dtype=dtype or library.float64) for part in parts))

def _jet(xp: Any, cells: Cells, outside: Any, x: Any) -> "tuple[Any, Any, Any]":
    """D, D' and D'' of the support function at x, which is c/a inside the rim and a/c outside."""
    beyond = cells.inside.shape[0] + xp.searchsorted(cells.outside, x, side="right")
    cell = cells.rows[xp.where(outside, beyond, xp.searchsorted(cells.inside, x, side="right")) - 1]
    t, d, first, second = x - cell[..., 0], 0 * x, 0 * x, 0 * x
    for k in range(7, 0, -1):
        d, first, second = d * t + cell[..., k], first * t + d, second * t + first
    return d, first, 2 * second

def wrench(cells: Cells, slide: Any, spin: Any) -> "tuple[Any, Any]":
    """F/(mu P) and M/(mu P a) of slips: arrays of one shape of slide |v| and spin a|omega|, >= 0 and not both 0. Error: certified_error."""
    xp = slide.__array_namespace__() if hasattr(slide, "__array_namespace__") else sys.modules[type(slide).__module__.partition(".")[0]]
    outside, x = slide > spin, xp.minimum(slide, spin) / xp.maximum(slide, spin)
    d, first, _ = _jet(xp, cells, outside, x)
    return xp.where(outside, d - x * first, first), xp.where(outside, first, d - x * first)

def closest_point(cells: Cells, force: Any, moment: Any, chi: Any, steps: int = 14) -> "tuple[Any, Any, Any]":
    """(force, moment, slips): trial unit wrenches >= 0, arrays of one shape; those that slip become the curve's points nearest to them, where
    a change of the moment costs chi = a^2 k_l/k_r, in [1e-3, 1e3], times one of the force. Newton's method in a bracket."""
    xp = force.__array_namespace__() if hasattr(force, "__array_namespace__") else sys.modules[type(force).__module__.partition(".")[0]]
    eps, one = float(xp.finfo(force.dtype).eps), 0 * force + 1
    rim_force, rim_moment = wrench(cells, one, one)
    outside = force - rim_force > chi * (moment - rim_moment)
    leading, trailing = xp.where(outside, moment, force), xp.where(outside, force, moment)
    kappa, low, high, x = xp.where(outside, 1 / chi, chi), 0 * one, one, one / 2
    for step in range(steps):
        d, first, second = _jet(xp, cells, outside, x)
        over = kappa * (trailing - d + x * first)
        value, slope = leading - first - x * over, second * (1 + kappa * x * x) + over
        low, high = xp.where(value > 0, x, low), xp.where(value > 0, high, x)
        # Below its rounding the sign of the residual is chance, and would cut the root out of the bracket. The last step is always taken,
        # because the derivatives of the result are its.
        moves = (step == steps - 1) | (xp.abs(value) > 4 * eps * (leading + x * kappa * trailing))
        new = x + xp.where(slope > 0, value, 0 * x) / xp.where(slope > 0, slope, one)
        new = xp.where((slope > 0) & (new >= low) & (new <= high), new, x if step == steps - 1 else (low + high) / 2)
        x = xp.where(moves, new, x)
    d, first, _ = _jet(xp, cells, outside, x)
    slips = trailing + x * leading > d * (1 + (1e-12 if eps < 1e-10 else 2**-18))  # slip_onset
    to = xp.where(outside, d - x * first, first), xp.where(outside, first, d - x * first)
    return xp.where(slips, to[0], force), xp.where(slips, to[1], moment), slips
