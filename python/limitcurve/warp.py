# SPDX-License-Identifier: MIT
"""Friction within a table as functions for kernels of NVIDIA Warp, in single precision: for Newton, MuJoCo Warp, Isaac
Lab. Needs warp-lang.

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
    """A table on a device: (x, c0 ... c6) of its cells, those inside the rim first, how many these are, and the wrench
    on the rim."""

    rows: wp.array2d(dtype=float)  # type: ignore[valid-type]
    inside: int
    rim: wp.vec2


def cells(table: "Table | str | os.PathLike[str]", device: Any = None) -> Any:
    """The Cells of a Table, or of a file of one, on a device of Warp."""
    host, found = arrays.cells(table, np, np.float32), Cells()
    found.rows, found.inside = wp.array(host.rows, dtype=float, device=device), len(host.inside)
    found.rim = wp.vec2(*(float(part) for part in arrays.wrench(host, 1.0, 1.0)))
    return found


@wp.func
def _cell(cells: Cells, outside: bool, x: float):  # type: ignore[no-untyped-def]
    """The row of the cell with x, which is c/a inside the rim and a/c outside."""
    low = wp.where(outside, cells.inside, 0)
    high = wp.where(outside, cells.rows.shape[0], cells.inside)
    while high - low > 1:
        middle = (low + high) // 2
        if cells.rows[middle, 0] <= x:
            low = middle
        else:
            high = middle
    return low


@wp.func
def _jet(cells: Cells, row: int, x: float):  # type: ignore[no-untyped-def]
    """D', D - x D' and D'' of the support function at x."""
    t = x - cells.rows[row, 0]
    d, first, half_second = float(0.0), float(0.0), float(0.0)
    for k in range(7):
        half_second = half_second * t + first
        first = first * t + d
        d = d * t + cells.rows[row, 7 - k]
    return first, d - x * first, 2.0 * half_second


@wp.func
def _magnitude(x: float):  # type: ignore[no-untyped-def]
    """|x|, whose derivative at 0 is that on the right."""
    return wp.where(x < 0.0, -x, x)


@wp.func
def wrench(cells: Cells, slide: float, spin: float):  # type: ignore[no-untyped-def]
    """(force, moment): F/(mu P) and M/(mu P a) of a slip with speed |v| and rim speed a|omega|, without signs; no slip
    gives 0."""
    v, u = _magnitude(slide), _magnitude(spin)
    outside = v > u
    if v == 0.0 and u == 0.0:
        return 0.0, 0.0
    x = wp.where(outside, u, v) / wp.where(outside, v, u)
    leading, trailing, _second = _jet(cells, _cell(cells, outside, x), x)
    return wp.where(outside, trailing, leading), wp.where(outside, leading, trailing)


@wp.func
def _foot(cells: Cells, outside: bool, to_lead: float, to_trail: float, kappa: float):  # type: ignore[no-untyped-def]
    """The row and the x of the closest point, by Newton's method in a bracket."""
    low, high, x = float(0.0), float(1.0), wp.where(to_lead > 0.0, 0.5, 0.0)
    for _step in range(32):
        leading, trailing, second = _jet(cells, _cell(cells, outside, x), x)
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
    return _cell(cells, outside, x), x


@wp.func_grad(_foot)
def _foot_slope(cells: Cells, outside: bool, to_lead: float, to_trail: float, kappa: float, adj_row: int,
                adj_x: float):  # type: ignore[no-untyped-def]
    """The step after the search has the derivative."""


@wp.func
def _stay(x: float, step: float):  # type: ignore[no-untyped-def]
    """x, with the derivative of the step from it: what is left of the step is rounding."""
    return x


@wp.func_grad(_stay)
def _step_slope(x: float, step: float, adj_x: float):  # type: ignore[no-untyped-def]
    wp.adjoint[step] += adj_x


@wp.func
def closest_point(cells: Cells, force: float, moment: float, chi: float):  # type: ignore[no-untyped-def]
    """(force, moment, slips): as limitcurve.arrays.closest_point, with the derivative under wp.Tape."""
    far = wp.max(1.0, 1.0e-14 * wp.max(wp.abs(force), wp.abs(moment)))
    f, m = _magnitude(force) / far, _magnitude(moment) / far  # from afar only the direction counts
    outside = f - cells.rim[0] > chi * (m - cells.rim[1])
    to_lead, to_trail = wp.where(outside, m, f), wp.where(outside, f, m)
    kappa = wp.where(outside, 1.0 / chi, chi)
    row, start = _foot(cells, outside, to_lead, to_trail, kappa)
    # The derivative of a further Newton step: that of the implicit function.
    lead_there, trail_there, second = _jet(cells, row, start)
    over = kappa * (to_trail - trail_there)
    slope = second * (1.0 + kappa * start * start) + over
    x = _stay(start, (to_lead - lead_there - start * over) / wp.where(slope > 0.0, slope, 1.0))
    leading, trailing, _second = _jet(cells, row, x)
    not_finite = force - force + (moment - moment) + (chi - chi)
    if to_trail + x * to_lead <= (trailing + x * leading) * (1.0 + 1.0 / 262144.0):  # slip_onset
        return force + not_finite, moment + not_finite, False
    to_force, to_moment = wp.where(outside, trailing, leading), wp.where(outside, leading, trailing)
    return (wp.where(force < 0.0, -to_force, to_force) + not_finite,
            wp.where(moment < 0.0, -to_moment, to_moment) + not_finite, True)


@wp.func
def tangent_ellipse(cells: Cells, force: float, moment: float, p: float, q: float):  # type: ignore[no-untyped-def]
    """(p, q), as Table.tangent_ellipse: of the unit wrench that an engine found with the semi-axes p and q > 0. No
    derivative."""
    if force == 0.0 and moment == 0.0:
        return cells.rows[cells.inside, 1], cells.rows[0, 1]
    largest = wp.max(_magnitude(force), _magnitude(moment))
    f, m = force / largest / p, moment / largest / q
    size = wp.sqrt(f * f + m * m)
    sliding, turning = f * f / (size * size), m * m / (size * size)  # shares of the power
    outside = sliding * cells.rim[1] > turning * cells.rim[0]
    share = wp.where(outside, turning, sliding)
    root = wp.sqrt(share)
    # The cell, by bisection over their edges, then x in it, where x sqrt(D'/(x D)) is the root of the leading share.
    row = int(wp.where(outside, cells.inside, 0))
    end = int(wp.where(outside, cells.rows.shape[0], cells.inside))
    while end - row > 1:
        middle = (row + end) // 2
        if cells.rows[middle, 0] * cells.rows[middle, 2] < share * cells.rows[middle, 1]:
            row = middle
        else:
            end = middle
    low, high = float(cells.rows[row, 0]), float(1.0)
    if end < wp.where(outside, cells.rows.shape[0], cells.inside):
        high = float(cells.rows[end, 0])
    x = float(low)
    for _step in range(24):
        leading, trailing, second = _jet(cells, row, x)
        d, each = trailing + x * leading, wp.where(x > 1.0e-30, leading / wp.max(x, 1.0e-30), second)
        rise = wp.sqrt(each / d)
        value = root - x * rise
        if wp.abs(value) <= 5.0e-7 * root:
            break
        if value > 0.0:
            low = x
        else:
            high = x
        new = x + value * 2.0 * d * rise / (each + second - leading * leading / d)
        x = wp.where(new >= low and new <= high, new, 0.5 * (low + high))
    leading, trailing, second = _jet(cells, row, x)
    d, each = trailing + x * leading, wp.where(x > 1.0e-30, leading / wp.max(x, 1.0e-30), second)
    not_finite = size - size
    lead, trail = wp.sqrt(d * each) + not_finite, wp.sqrt(d * trailing) + not_finite
    return wp.where(outside, trail, lead), wp.where(outside, lead, trail)


@wp.func_grad(tangent_ellipse)
def _no_slope(cells: Cells, force: float, moment: float, p: float, q: float, adj_p: float,
              adj_q: float):  # type: ignore[no-untyped-def]
    """Coefficients of an engine are settings."""
