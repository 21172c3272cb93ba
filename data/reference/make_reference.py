#!/usr/bin/python3
"""Reference values of the unit limit curve: limit_curve.csv beside this script.

    make_reference.py                   write limit_curve.csv (about 12 minutes)
    make_reference.py --check           compute it again, compare it byte by byte with the file, and let a
                                        second derivation confirm every value (about 14 minutes)
    make_reference.py --check LAW ...   the same for some laws only: two seconds each for those with formulas, about a
                                        minute for the cone and 100 s for each k of xydas-kao

For a contact of radius a that turns about a centre of rotation (COR) at the distance c, the unit wrench at
s = c/a is f = F/(mu P), m = M/(mu P a). The third quantity is the slope df/ds; dm/ds is -s df/ds. Every s, and
every parameter of a law, is the exact value of the double that its decimal is read as. So are the weights of
a mixture, which are then divided by their sum: a law carries unit load.

Two derivations, which share nothing but the definition of the pressure:

 1. Formulas: hypergeometric ones for p ~ (1 - r^2)^n, confluent ones for the Gaussian, elementary ones for the
    cone, each at a precision raised by whatever it loses.
 2. Chords, that is, polar coordinates centred on the COR. Along a chord at the distance h from the contact
    centre the pressure enters by two numbers only,
        A(h) = int p dx,   A2(h) = int p x^2 dx,
    and with H = min(s, 1)
        f     = 2 int_0^H A  sqrt(1 - h^2/s^2) dh,
        m     = 2 int_0^H A2 / sqrt(s^2 - h^2) dh,
        df/ds = 2/s^2 int_0^H A h^2 / sqrt(s^2 - h^2) dh.
    A and A2 are integrated numerically from the pressure wherever they are not elementary.

The file holds the formulas, which the chords confirm. The law of Xydas and Kao has no formula: there the file
holds the chords, and rings of pressure with complete elliptic integrals confirm them.
"""

import argparse
import math
import sys
import time
from functools import lru_cache
from pathlib import Path

from mpmath import mp, mpf

OUTPUT = Path(__file__).with_name("limit_curve.csv")
HEADER = (
    "# Unit wrench f = F/(mu P), m = M/(mu P a) and df/ds at s = c/a; s is the exact double printed."
    " Made by make_reference.py.\n"
    "law,c_over_a,force,moment,force_slope\n"
)
PRINTED_DIGITS = 30
FORMULA_DIGITS = 60
QUADRATURE_DIGITS = 50
AGREEMENT = mpf(10) ** -30
# Quadrature nodes a unit of the transformed variable: what AGREEMENT takes, found by refining.
CHORD_STEPS = 24
PROJECTION_STEPS = 24
RING_STEPS = 32

POINTS = [
    0.0, 1e-300, 1e-150, 1e-12, 1e-8, 1e-4, 0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99, 0.9999,
    1 - 1e-8, 1 - 1e-12, 1 - 2.0**-53, 1.0, 1 + 2.0**-52, 1 + 1e-12, 1 + 1e-8, 1.0001,
    1.01, 1.1, 1.4, 1.5, 2.0, 3.0, 10.0, 100.0, 1e4, 1e8, 1e12, 1e150, math.inf,
]  # fmt: skip


# ---- Quadrature ------------------------------------------------------------------------------------------


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


class Chords:
    """The second derivation for one law: A and A2 on panels whose edges include every s inside the contact."""

    def __init__(self, law):
        self.support = mpf(law.support)
        # At s = 1 the kernel's square root meets the rim.
        rule = double_exponential_rule(CHORD_STEPS, min(-0.5, law.projection_exponent - 0.5))
        grading = [1e-10, 1e-6, 1e-3, 1 - 1e-3, 1 - 1e-6, 1 - 1e-10, 1 - 1e-14]
        inside = sorted(mpf(s) for s in set(POINTS + grading) if 0 < s < self.support)
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


# ---- Laws ------------------------------------------------------------------------------------------------
# Each has the formulas (unit_wrench, for 0 <= s < inf), or None, and the projection (A, A2) with the power by which
# A vanishes at the rim.


class PowerLaw:
    """p = (n + 1)(1 - r^2)^n / pi."""

    support = 1

    def __init__(self, n):
        self.n = mpf(n)
        self.projection_exponent = float(n) + 0.5
        with mp.workdps(FORMULA_DIGITS):
            n, half = self.n, mpf(1) / 2
            self.m0 = mp.gamma(3 * half) * mp.gamma(n + 2) / mp.gamma(n + 5 * half)
            self.first_scale = (n + 1) / mp.pi * mp.beta(half, n + 1)
            self.second_scale = (n + 1) / mp.pi * mp.beta(3 * half, n + 1)

    def unit_wrench(self, s):
        with mp.workdps(FORMULA_DIGITS):
            n, half = self.n, mpf(1) / 2
            if s <= 1:
                z = s * s
                force = (n + 3 * half) * self.m0 * s * mp.hyp2f1(half, -n - half, 2, z)
                moment = self.m0 * mp.hyp2f1(half, -n - 3 * half, 1, z)
                slope = (n + 3 * half) * self.m0 * mp.hyp2f1(3 * half, -n - half, 2, z)
            else:
                z = 1 / (s * s)
                force = mp.hyp2f1(-half, half, n + 2, z)
                moment = mp.hyp2f1(half, half, n + 3, z) / (2 * (n + 2) * s)
                slope = mp.hyp2f1(half, 3 * half, n + 3, z) / (2 * (n + 2) * s**3)
            return force, moment, slope

    def projection(self, h, gap):
        base = gap * (1 + h)
        power = base ** (self.n + mpf(1) / 2)
        return self.first_scale * power, self.second_scale * power * base


class Cone:
    """p = arccosh(1/r) / pi."""

    support = 1
    projection_exponent = 1.0
    rim_scale = None

    def unit_wrench(self, s):
        # For s > 1 terms of the order s^3 cancel down to 1/s.
        lost = 4 * int(mp.log10(s)) if s > 1 else 0
        with mp.workdps(FORMULA_DIGITS + lost):
            if s <= 1:
                force = mp.pi * s / 2 - 2 * s**2 / 3
                moment = mp.pi / 6 - mp.pi * s**2 / 4 + 4 * s**3 / 9
                return force, moment, mp.pi / 2 - 4 * s / 3
            angle, t = mp.asin(1 / s), mp.sqrt((s - 1) * (s + 1))
            force = (s**2 * angle + t + 2 * t**3 / 3 - 2 * s**3 / 3) / s
            moment = (mpf(1) / 3 - s**2 / 2) * angle - t / 6 - 4 * t**3 / 9 + 4 * s**3 / 9
            slope = angle + 2 * t - t / s**2 - 2 * t**3 / (3 * s**2) - 4 * s / 3
            return force, moment, slope

    def pressure(self, r, gap):
        return mp.log((1 + mp.sqrt(gap * (1 + r))) / r) / mp.pi

    def central_projection(self):
        return mpf(1), mpf(1) / 6

    def projection(self, h, gap):
        return project_numerically(self, h, gap)


class Gaussian:
    """p = exp(-r^2 / (2 sigma^2)) / (2 pi sigma^2) with sigma in units of the radius, and no rim."""

    projection_exponent = 0.0

    def __init__(self, sigma):
        self.sigma = mpf(sigma)
        # Where the chords stop: what lies beyond weighs e^-450.
        self.support = 30 * self.sigma

    def unit_wrench(self, s):
        with mp.workdps(FORMULA_DIGITS):
            sigma, half = self.sigma, mpf(1) / 2
            x = (s / sigma) ** 2 / 2
            scale = mp.sqrt(mp.pi / 8) / sigma
            force = scale * s * mp.hyp1f1(half, 2, -x)
            moment = sigma * mp.sqrt(mp.pi / 2) * mp.hyp1f1(half, 1, -x)
            # From dm/ds = -s df/ds: the derivative of the force itself cancels for large s.
            slope = scale * mp.hyp1f1(3 * half, 2, -x)
            return force, moment, slope

    def projection(self, h, gap):
        density = mp.exp(-((h / self.sigma) ** 2) / 2) / (self.sigma * mp.sqrt(2 * mp.pi))
        return density, density * self.sigma**2


class XydasKao:
    """p = C (1 - r^k)^(1/k) / pi."""

    support = 1
    unit_wrench = None

    def __init__(self, k):
        self.k = mpf(k)
        self.projection_exponent = 0.5
        # The pressure falls within about 1/k of the rim: a scale that the quadrature must be told.
        self.rim_scale = 1 / self.k if self.k > 2 else None
        with mp.workdps(FORMULA_DIGITS):
            k = self.k
            self.inverse = 1 / k
            self.pressure_scale = 3 * k / (2 * mp.pi) * mp.gamma(3 / k) / (mp.gamma(1 / k) * mp.gamma(2 / k))

    def pressure(self, r, gap):
        # Two terms suffice near the rim, where 1 - r^k would subtract.
        base = 1 - r**self.k if gap > 1e-20 else self.k * gap * (1 - (self.k - 1) * gap / 2)
        return self.pressure_scale * base**self.inverse

    def central_projection(self):
        first = self.pressure_scale / self.k * mp.beta(1 / self.k, 1 + 1 / self.k)
        second = self.pressure_scale / self.k * mp.beta(3 / self.k, 1 + 1 / self.k)
        return 2 * first, 2 * second

    def at_zero(self):
        with mp.workdps(FORMULA_DIGITS):
            k = self.k
            m0 = 3 * mp.gamma(3 / k) ** 2 / (4 * mp.gamma(2 / k) * mp.gamma(4 / k))
            return mpf(0), m0, mp.pi / 2 * self.central_projection()[0]

    def projection(self, h, gap):
        return project_numerically(self, h, gap)


class Mixture:
    support = 1

    def __init__(self, *parts):
        self.laws = [law for _, law in parts]
        with mp.workdps(FORMULA_DIGITS):
            total = sum(mpf(weight) for weight, _ in parts)
            self.weights = [mpf(weight) / total for weight, _ in parts]
        self.projection_exponent = min(law.projection_exponent for law in self.laws)

    def _mix(self, values):
        return tuple(mp.fdot(self.weights, column) for column in zip(*values))

    def unit_wrench(self, s):
        with mp.workdps(FORMULA_DIGITS):
            return self._mix([law.unit_wrench(s) for law in self.laws])

    def projection(self, h, gap):
        return self._mix([law.projection(h, gap) for law in self.laws])


LAWS = {
    "hertz": PowerLaw(0.5),
    "uniform": PowerLaw(0.0),
    "parabolic": PowerLaw(1.0),
    "flat-punch": PowerLaw(-0.5),
    "cone": Cone(),
    **{f"power:n={n}": PowerLaw(n) for n in (-0.99, -0.75, 0.25, 2.3, 7, 40)},
    **{f"xydas-kao:k={k}": XydasKao(k) for k in (0.2, 0.5, 1, 1.8, 3, 4, 10, 1000)},
    **{f"gaussian:sigma={sigma}": Gaussian(sigma) for sigma in (0.4, 0.1, 1)},
    "mix:0.7*hertz+0.3*uniform": Mixture((0.7, PowerLaw(0.5)), (0.3, PowerLaw(0.0))),
}


# ---- Rings: the witness where there are no formulas --------------------------------------------------------


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


# ---- The file --------------------------------------------------------------------------------------------


def rows(name, witness):
    """The lines of one law and, if asked for, the worst relative difference of its two derivations."""
    law = LAWS[name]
    chords = Chords(law) if witness or law.unit_wrench is None else None
    lines, worst = [], mpf(0)
    for point in POINTS:
        s = mpf(point)
        if point == math.inf:
            values = (mpf(1), mpf(0), mpf(0))
        elif law.unit_wrench is not None:
            values = law.unit_wrench(s)
        elif point == 0:
            values = law.at_zero()
        else:
            values = chords.unit_wrench(s)
        if point == 0:
            at_zero = values
        if witness and 0 < point < math.inf:
            other = chords.unit_wrench(s) if law.unit_wrench is not None else rings(law, s)
            # The chords are 0/0 at s = 0; moment and slope of the next point are the same to every digit.
            if point == 1e-300:
                worst = max(worst, abs(at_zero[1] / other[1] - 1), abs(at_zero[2] / other[2] - 1))
            for value, confirmed in zip(values, other):
                worst = max(worst, abs(value / confirmed - 1))
        printed = ",".join(mp.nstr(value, PRINTED_DIGITS, min_fixed=0, max_fixed=0) for value in values)
        lines.append(f"{name},{point!r},{printed}\n")
    return lines, worst


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="compare with the file instead of writing it")
    parser.add_argument("laws", nargs="*", metavar="LAW", help="with --check: only these laws")
    arguments = parser.parse_args()
    unknown = [name for name in arguments.laws if name not in LAWS]
    if unknown or (arguments.laws and not arguments.check):
        parser.error(f"unknown law {unknown[0]}" if unknown else "laws can be chosen with --check only")

    # Agreement is judged at a precision that does not limit it.
    mp.dps = FORMULA_DIGITS
    text, failed = HEADER, False
    committed = OUTPUT.read_text() if arguments.check else ""
    for name in arguments.laws or LAWS:
        start = time.monotonic()
        lines, worst = rows(name, witness=arguments.check)
        text += "".join(lines)
        note = ""
        if arguments.check:
            failed |= worst > AGREEMENT or "".join(lines) not in committed
            note = f", derivations agree to {mp.nstr(worst, 2)}"
            if "".join(lines) not in committed:
                note += ", DIFFERS from the file"
        print(f"{name}: {time.monotonic() - start:.0f} s{note}", file=sys.stderr)
    if not arguments.check:
        OUTPUT.write_text(text)
    elif not arguments.laws:
        failed |= text != committed
    if failed:
        sys.exit(f"{OUTPUT.name}: the check failed")


if __name__ == "__main__":
    main()
