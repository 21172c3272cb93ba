# SPDX-License-Identifier: MIT
"""The second derivation of the unit wrench: chords through the pressure (make_reference.py has the formulas)."""

from double_exponential import QUADRATURE_DIGITS, double_exponential_rule, graded_edges
from mpmath import mp, mpf

# Quadrature nodes a unit of the transformed variable, enough for agreement to 1e-30, found by refinement.
CHORD_STEPS = 24
PROJECTION_STEPS = 24


class Chords:
    """The chords of one law: A and A2 on panels whose edges include every point s inside the contact."""

    def __init__(self, law, points):
        self.support = mpf(law.support)
        # At s = 1 the kernel's square root meets the rim.
        rule = double_exponential_rule(CHORD_STEPS, min(-0.5, law.projection_exponent - 0.5))
        grading = [1e-10, 1e-6, 1e-3, 1 - 1e-3, 1 - 1e-6, 1 - 1e-10, 1 - 1e-14]
        inside = sorted(mpf(s) for s in set(points + grading) if 0 < s < self.support)
        edges = [mpf(0)] + inside + [self.support]
        self.panels = []
        with mp.workdps(QUADRATURE_DIGITS):
            for left, right in zip(edges, edges[1:]):
                width = right - left
                nodes = []
                for from_left, from_right, weight in rule:
                    h = left + width * from_left
                    to_edge = width * from_right
                    first, second = law.projection(h, (self.support - right) + to_edge)
                    nodes.append((h, to_edge, 2 * width * weight * first, 2 * width * weight * second))
                self.panels.append((right, nodes))

    def unit_wrench(self, s):
        force, moment, slope = mpf(0), mpf(0), mpf(0)
        with mp.workdps(QUADRATURE_DIGITS):
            for right, nodes in self.panels:
                if right > s:
                    break
                for h, to_edge, first, second in nodes:
                    root = mp.sqrt(((s - right) + to_edge) * (s + h))
                    force += first * root
                    moment += second / root
                    slope += first * (h * h / root)
            return force / s, moment, slope / (s * s)


def project_numerically(law, h, gap):
    """A and A2 at the distance h from the centre and gap = 1 - h from the rim, from the pressure itself."""
    if h < mpf(10) ** -45:
        return law.central_projection()
    first, second = mpf(0), mpf(0)
    # The pressure may be singular at the centre, h to the left of the chord's nearest point.
    edges = graded_edges(mpf(0), gap, h, law.rim_scale)
    rule = double_exponential_rule(PROJECTION_STEPS, -0.5)
    for left, right in zip(edges, edges[1:]):
        width = right - left
        for from_left, from_right, weight in rule:
            u = left + width * from_left
            x = mp.sqrt(u * (2 * h + u))
            r = h + u
            share = weight * width * r * law.pressure(r, (gap - right) + width * from_right) / x
            first += share
            second += share * x * x
    return 2 * first, 2 * second
