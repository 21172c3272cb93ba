# SPDX-License-Identifier: MIT
"""The pressure laws of the reference, for a contact of radius one with unit load.

Each has the formulas (unit_wrench, for 0 <= s < inf), or None, and the projection (A, A2) with the power by which A
vanishes at the rim.
"""

from chords import project_numerically
from double_exponential import FORMULA_DIGITS
from mpmath import mp, mpf


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
        # The pressure falls within about 1/k of the rim: a scale that the quadrature needs.
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
