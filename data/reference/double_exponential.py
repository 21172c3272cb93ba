# SPDX-License-Identifier: MIT
"""Integration over an interval with singular ends, and the working precisions of the reference."""

from functools import lru_cache

from mpmath import mp, mpf

FORMULA_DIGITS = 60
QUADRATURE_DIGITS = 50


@lru_cache(maxsize=None)
def double_exponential_rule(steps_per_unit, weakest_exponent):
    """Nodes (distance from the left end, distance from the right end, weight) on an interval of length one.

    Both distances are exact in relative terms: an integrand that is singular at an end must not have to
    subtract. weakest_exponent > -1 is the worst power with which the integrand behaves at an end; the closer it
    is to -1, the nearer to the end the nodes have to go.
    """
    with mp.workdps(QUADRATURE_DIGITS + 10):
        wanted = (QUADRATURE_DIGITS - 10) * mp.log(10)
        reach = mp.asinh(wanted / (mp.pi * (1 + mpf(weakest_exponent))))
        count = int(mp.ceil(reach * steps_per_unit))
        nodes = []
        for index in range(-count, count + 1):
            t = mpf(index) / steps_per_unit
            odds = mp.exp(mp.pi * mp.sinh(t))
            left, right = odds / (1 + odds), 1 / (1 + odds)
            nodes.append((left, right, mp.pi * mp.cosh(t) * left * right / steps_per_unit))
        return nodes


def graded_edges(left, right, beyond_left, beyond_right, ratio=100):
    """Edges that grade [left, right] towards singularities at the given distances beyond its two ends.

    A singularity at an end itself (distance 0 or None) needs no grading: the rule is made for it. One that is
    closer than the width times ratio^-12 acts as if it were at the end from there on.
    """
    half = (right - left) / 2

    def offsets(distance):
        found = []
        while distance and distance < half and len(found) < 12:
            found.append(distance)
            distance *= ratio
        return found

    from_left = [left + offset for offset in offsets(beyond_left)]
    from_right = [right - offset for offset in reversed(offsets(beyond_right))]
    return [left] + from_left + from_right + [right]
