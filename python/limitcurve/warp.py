# SPDX-License-Identifier: MIT
"""Friction within a table as functions for kernels of NVIDIA Warp, in single precision: for Newton, MuJoCo Warp, Isaac Lab. Needs warp-lang.

>>> import limitcurve as lc, warp as wp
>>> import limitcurve.warp as lw
>>> @wp.kernel
... def hold(cells: lw.Cells, trials: wp.array(dtype=wp.vec2), chi: float):
...     i = wp.tid()
...     force, moment, slips = lw.closest_point(cells, trials[i][0], trials[i][1], chi)
...     trials[i] = wp.vec2(force, moment)
>>> trials = wp.array([[0.2, 0.1], [2.0, 0.0]], dtype=wp.vec2, device="cpu")
>>> wp.launch(hold, 2, [lw.cells(lc.Table("hertz", 1e-6), "cpu"), trials, 1.0], device="cpu")
>>> [round(float(x), 6) for x in trials.numpy().ravel()]
[0.2, 0.1, 1.0, 0.0]
"""

import os
from typing import Any

import numpy as np
import warp as wp  # type: ignore[import-not-found, unused-ignore]

from . import arrays
from ._core import Table


@wp.struct
class Cells:
    """A table on a device: (x, c0 ... c6) of its cells, those inside the rim first, how many these are, and the wrench on the rim."""

    rows: wp.array2d(dtype=float)  # type: ignore[valid-type]
    inside: int
    rim: wp.vec2


def cells(table: "Table | str | os.PathLike[str]", device: Any = None) -> Any:
    """The Cells of a Table, or of a file of one, on a device of Warp."""
    host, found = arrays.cells(table, np, np.float32), Cells()
    one = np.ones(1, np.float32)
    found.rows, found.inside = wp.array(host.rows, dtype=float, device=device), len(host.inside)
    found.rim = wp.vec2(*(float(part[0]) for part in arrays.wrench(host, one, one)))
    return found


@wp.func
def _jet(cells: Cells, outside: bool, x: float):  # type: ignore[no-untyped-def]
    """D', D - x D' and D'' of the support function at x, which is c/a inside the rim and a/c outside."""
    low = wp.where(outside, cells.inside, 0)
    high = wp.where(outside, cells.rows.shape[0], cells.inside)
    while high - low > 1:
        middle = (low + high) // 2
        if cells.rows[middle, 0] <= x:
            low = middle
        else:
            high = middle
    t = x - cells.rows[low, 0]
    d, first, half_second = float(0.0), float(0.0), float(0.0)
    for k in range(7):
        half_second = half_second * t + first
        first = first * t + d
        d = d * t + cells.rows[low, 7 - k]
    return first, d - x * first, 2.0 * half_second


@wp.func
def wrench(cells: Cells, slide: float, spin: float):  # type: ignore[no-untyped-def]
    """(force, moment): F/(mu P) and M/(mu P a) of a slip with speed |v| and rim speed a|omega|, >= 0 and not both 0."""
    outside = slide > spin
    leading, trailing, _second = _jet(cells, outside, wp.min(slide, spin) / wp.max(slide, spin))
    return wp.where(outside, trailing, leading), wp.where(outside, leading, trailing)


@wp.func
def closest_point(cells: Cells, force: float, moment: float, chi: float):  # type: ignore[no-untyped-def]
    """(force, moment, slips): a trial unit wrench >= 0; if it slips, the curve's point nearest to it, where a change of the moment costs
    chi = a^2 k_l/k_r, in [1e-3, 1e3], times one of the force. As limitcurve.arrays.closest_point."""
    outside = force - cells.rim[0] > chi * (moment - cells.rim[1])
    to_lead, to_trail = wp.where(outside, moment, force), wp.where(outside, force, moment)
    kappa = wp.where(outside, 1.0 / chi, chi)
    low, high, x = float(0.0), float(1.0), wp.where(to_lead > 0.0, 0.5, 0.0)
    leading, trailing, second = _jet(cells, outside, x)
    for _step in range(32):
        over = kappa * (to_trail - trailing)
        value = to_lead - leading - x * over
        # Below its rounding the sign of the residual is chance.
        if wp.abs(value) <= 5.0e-7 * (to_lead + x * kappa * to_trail):
            break
        if value > 0.0:
            low = x
        else:
            high = x
        slope = second * (1.0 + kappa * x * x) + over
        new = x + value / slope
        x = wp.where(slope > 0.0 and new > low and new < high, new, 0.5 * (low + high))
        leading, trailing, second = _jet(cells, outside, x)
    if not to_trail + x * to_lead > (trailing + x * leading) * (1.0 + 1.0 / 262144.0):  # slip_onset
        return force, moment, False
    return wp.where(outside, trailing, leading), wp.where(outside, leading, trailing), True
