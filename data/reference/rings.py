# SPDX-License-Identifier: MIT
"""Rings of pressure: they confirm the chords if a law has no formulas."""

from double_exponential import QUADRATURE_DIGITS, double_exponential_rule, graded_edges
from mpmath import mp, mpf

# Quadrature nodes a unit of the transformed variable, enough for agreement to 1e-30, found by refinement.
RING_STEPS = 32


def elliptic_integrals(q, complement):
    """E, B = (E - (1 - q^2) K)/q^2 and D = (K - E)/q^2 of the modulus q; complement is 1 - q.

    By the arithmetic-geometric mean, with q^2 divided out of its differences before they are summed, so that
    small moduli cost no digits.
    """
    minor = mp.sqrt(complement * (1 + q))
    a, b = (1 + minor) / 2, mp.sqrt(minor)
    # difference is (a - b)/2 of the preceding pair, divided by q.
    difference = q / (2 * (1 + minor))
    total, factor = difference**2, 1
    while True:
        a, b = (a + b) / 2, mp.sqrt(a * b)
        difference = q * difference**2 / (4 * a)
        factor *= 2
        term = factor * difference**2
        total += term
        if term <= mp.eps * total:
            break
    k = mp.pi / (2 * a)
    d = k * (mpf(1) / 2 + total)
    return k - q * q * d, k * (mpf(1) / 2 - total), d


def rings(law, s):
    """Force, moment and slope as sums over rings of pressure, split at the radius of the COR."""
    with mp.workdps(QUADRATURE_DIGITS):
        force, moment, slope = mpf(0), mpf(0), mpf(0)
        beyond = [distance for distance in (abs(1 - s), law.rim_scale) if distance]
        if s < 1:
            edges = graded_edges(mpf(0), s, None, 1 - s) + graded_edges(s, mpf(1), s, law.rim_scale)[1:]
        else:
            edges = graded_edges(mpf(0), mpf(1), None, min(beyond) if beyond else None)
        rule = double_exponential_rule(RING_STEPS, 0.0)
        for left, right in zip(edges, edges[1:]):
            width = right - left
            for from_left, from_right, weight in rule:
                r = left + width * from_left
                load = 4 * width * weight * r * law.pressure(r, (1 - right) + width * from_right)
                if right <= s:
                    q = r / s
                    e, b, d = elliptic_integrals(q, ((s - right) + width * from_right) / s)
                    force += load * e
                    moment += load * r * q * b
                    slope += load * q * q * d / s
                else:
                    q = s / r
                    e, b, d = elliptic_integrals(q, ((left - s) + width * from_left) / r)
                    force += load * q * b
                    moment += load * r * e
                    slope += load * d / r
        return force, moment, slope
