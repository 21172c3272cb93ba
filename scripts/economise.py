#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Polynomials for the closed forms in double precision: the headers limitcurve/economised_*.hpp and, for the Gaussian, which no
public header uses, limitcurve/internal/economised_gaussian.hpp.

    economise.py            write the headers (a third of a minute; needs mpmath)
    economise.py --check    compute them again and compare them byte by byte with the files

Every function is interpolated at Chebyshev nodes in 50-digit arithmetic and written in powers of the distance from the
middle of its piece, where Horner's scheme loses nothing. The pieces keep away from the function's singularities, which are
known; the script measures what each polynomial misses, between the nodes, and refuses to write one that misses more than
2^-54 of the value (a quarter of a unit in the last place).

With q = 1/s (COR outside the rim) or q = s (inside), eta = 1 - q^2 and w = sqrt(eta):

  outside the rim force f, moment s m and slope s^3 df/ds are analytic in z = q^2 up to the rim, z = 1. From s = 1 + 1/16 on, a
  piece for every eighth of an octave of s - 1, up to 4, and one beyond: so the leading bits of s - 1 name the piece.

  nearer to the rim, those of the pressures whose limit curve is elementary outside (Hertz, flat punch, cone) are analytic in w up
  to w = -1: one piece. Those that have a logarithm at the rim (uniform, parabolic) are combinations of the elliptic
  integrals B and D.

  B and D of modulus q (DLMF 19.2.6: B = K - D, D = (K - E)/q^2): in eta on [1/8, 1], four pieces an octave; below, split into what
  is analytic and what multiplies the logarithm (DLMF 19.12.1, in the manner of Hastings 1955, Cody 1965, Fukushima 2009),
      B = B0(eta) - eta log(eta) B1(eta),   D = D0(eta) - log(eta) D1(eta).

  the Gaussian, with x = s/(2 sigma), z = x^2, y = 1/(1+x): exp(-z) (I0+I1), exp(-z) I0 and exp(-z) (I0-I1) of z, over the powers
  of y that leave them neither 0 nor infinite at y = 0: seventeen pieces of equal width in y.
"""

import argparse
import sys
from functools import cache
from pathlib import Path

from mpmath import mp, mpf

mp.dps = 50
FOLDER = Path(__file__).resolve().parent.parent / "limitcurve"
LARGEST_ERROR = mpf(2) ** -54
RIM_MIDDLE = mpf(87) / 512  # half of w at s = 1 + 1/16, and a little


def family(n):
    """Outside the rim, pressure ~ (1 - rho^2)^n: f, s m, s^3 df/ds of z = 1/s^2 (DLMF 15.5.1 for the slope)."""
    scale = 1 / (2 * (n + 2))
    half = mpf(1) / 2
    return [
        lambda z: mp.hyp2f1(-half, half, n + 2, z),
        lambda z: scale * mp.hyp2f1(half, half, n + 3, z),
        lambda z: scale * mp.hyp2f1(half, 3 * half, n + 3, z),
    ]


def cone():
    """The same for the cone, whose even pressure moments are k!/((k+1)(3/2)_k), by the power series or, near the rim, by
    the elementary form, which cancels where the series is short."""

    def terms(z):
        moment, e, b = mpf(1), mpf(1), mpf(1) / 2
        force = twist = slope = mpf(0)
        power = mpf(1)
        for k in range(400):
            after = moment * (k + 1) ** 2 / (k + 2) / (mpf(3) / 2 + k)
            e_after = e * (k - mpf(1) / 2) * (k + mpf(1) / 2) / (k + 1) ** 2
            force += e * moment * power
            twist += b * after * power
            slope += -2 * (k + 1) * e_after * after * power
            b *= (k + mpf(1) / 2) ** 2 / (k + 2) / (k + 1)
            e, moment, power = e_after, after, power * z
        return force, twist, slope

    def closed(z):
        s = 1 / mp.sqrt(z)
        t = mp.sqrt(s * s - 1)
        angle = mp.asin(1 / s)
        force = (s * s * angle + t + 2 * t**3 / 3 - 2 * s**3 / 3) / s
        twist = (mpf(1) / 3 - s * s / 2) * angle - t / 6 - 4 * t**3 / 9 + 4 * s**3 / 9
        slope = angle + 2 * t - 4 * s / 3 - t / (s * s) * (1 + 2 * t * t / 3)
        return force, s * twist, s**3 * slope

    @cache
    def all_three(z):
        return terms(z) if z < mpf(2) / 3 else closed(z)

    return [lambda z, i=i: all_three(z)[i] for i in range(3)]


def elliptic(eta):
    m = 1 - eta
    if m < mpf(10) ** -20:  # q^2, beyond what the doubles show
        return mp.pi / 4 * (1 + m / 8), mp.pi / 4 * (1 + 3 * m / 8)
    k, e = mp.ellipk(m), mp.ellipe(m)
    return (e - eta * k) / m, (k - e) / m


def elliptic_at_rim(eta):
    """B0, D0, B1, D1 of the docstring. K = K0 - log(eta) K(1-q^2)/pi, and E likewise with (K - E)/pi."""
    k1 = mp.ellipk(eta) / mp.pi
    e1 = (mp.ellipk(eta) - mp.ellipe(eta)) / mp.pi
    b1 = (e1 - eta * k1) / (1 - eta)
    d1 = (k1 - e1) / (1 - eta)
    b, d = elliptic(eta)
    return b + mp.log(eta) * b1, d + mp.log(eta) * d1, b1 / eta, d1


def gaussian(y):
    """exp(-z)(I0+I1)/y sqrt(pi/2), exp(-z) I0/y, exp(-z)(I0-I1)/y^3 at x = 1/y - 1."""
    if y == 0:
        return 1, 1 / mp.sqrt(2 * mp.pi), 1 / mp.sqrt(2 * mp.pi) / 2
    x = 1 / y - 1
    z = x * x
    zero = mp.exp(-z) * mp.besseli(0, z)
    one = mp.exp(-z) * mp.besseli(1, z)
    return mp.sqrt(mp.pi / 2) * (zero + one) / y, zero / y, (zero - one) / y**3


def chebyshev(function, left, right, terms):
    """Coefficients of the interpolating polynomial in powers of (x - middle) / unit, unit = 1."""
    middle, half = (left + right) / 2, (right - left) / 2
    nodes = [mp.cos(mp.pi * (2 * i + 1) / (2 * terms)) for i in range(terms)]
    values = [function(middle + half * x) for x in nodes]
    series = [
        (1 if j == 0 else 2) * sum(v * mp.cos(mp.pi * j * (2 * i + 1) / (2 * terms)) for i, v in enumerate(values)) / terms
        for j in range(terms)
    ]
    powers = [mpf(0)] * terms
    before, now = [mpf(1)], [mpf(0), mpf(1)]
    for j in range(terms):
        basis = before if j == 0 else now
        for i, c in enumerate(basis):
            powers[i] += series[j] * c
        if j > 0:
            after = [mpf(0)] + [2 * c for c in now]
            for i, c in enumerate(before):
                after[i] -= c
            before, now = now, after
    return [c / half**i for i, c in enumerate(powers)]


def piece(function, left, right, terms, unit, loudest=0):
    """Coefficients in (x - middle) / unit, as the doubles they will be, once they are known to be good enough. `loudest` is
    what the function is measured against, if not itself."""
    exact = chebyshev(function, left, right, terms)
    middle, half = (left + right) / 2, (right - left) / 2
    for i in range(terms + 1):
        # The extremes of the Chebyshev polynomial that the error nearly is; but not the very ends, where a formula may have a 0/0.
        x = half * (1 - mpf(2) ** -20) * mp.cos(mp.pi * i / terms)
        truth = function(middle + x)
        error = abs(mp.polyval(exact[::-1], x) - truth) / max(abs(truth), loudest)
        if not error <= LARGEST_ERROR:
            sys.exit(f"{terms} terms miss {mp.nstr(error, 3)} on [{left}, {right}]")
    return [float(c * unit**i) for i, c in enumerate(exact)]


def equal_pieces(functions, count, terms):
    """On [0, 1], in units of a piece's width; per piece and power the functions' coefficients side by side."""
    rows = []
    for i in range(count):
        columns = [piece(g, mpf(i) / count, mpf(i + 1) / count, terms, mpf(1) / count) for g in functions]
        rows += [value for power in zip(*columns) for value in power]
    return rows


def octave_pieces(functions, octaves, terms):
    """On [2^-octaves, 1], four pieces an octave, in units of 1."""
    rows = []
    for octave in range(-octaves, 0):
        for quarter in range(4):
            left = mpf(2) ** octave * (1 + mpf(quarter) / 4)
            right = mpf(2) ** octave * (1 + mpf(quarter + 1) / 4)
            columns = [piece(g, left, right, terms, mpf(1)) for g in functions]
            rows += [value for power in zip(*columns) for value in power]
    return rows


def outside_pieces():
    """The middle and half width in z of each piece of s >= 1 + 1/16. The middles are rounded, so that a float holds them, and the
    last is pure sliding, z = 0, so that f = 1 there to the last bit."""
    edges = [mpf(2) ** octave * (1 + mpf(eighth) / 8) for octave in range(-4, 2) for eighth in range(8)] + [mpf(4), mp.inf]
    for inner, outer in zip(edges, edges[1:]):
        right = 1 / (1 + inner) ** 2
        left = -right if mp.isinf(outer) else 1 / (1 + outer) ** 2
        middle = mp.nint((left + right) * 2**19) / 2**20
        yield middle, max(middle - left, right - middle)


def outside(functions, terms):
    """On those, in units of 1."""
    rows = []
    for middle, half in outside_pieces():
        columns = [piece(g, middle - half, middle + half, terms, mpf(1)) for g in functions]
        rows += [value for power in zip(*columns) for value in power]
    return rows


def array(comment, name, values):
    lines = [f"/// {comment}", f"inline constexpr std::array<double, {len(values)}> {name}{{"]
    numbers = [repr(v) for v in values]
    line = "   "
    for number in numbers:
        if len(line) + len(number) + 2 > 138:
            lines.append(line)
            line = "   "
        line += f" {number},"
    lines.append(line.rstrip(",") + "};")
    return "\n".join(lines) + "\n"


def outside_forms(name, functions, terms):
    """With a term more for the slope, whose singularity at the rim is the stronger."""
    return [
        array(f"{name}: f and s·m in s⁻², 49 pieces of {terms} terms.", f"{name}_wrench", outside(functions[:2], terms)),
        array(f"{name}: s³·df/ds in s⁻², 49 pieces of {terms + 1} terms.", f"{name}_slope", outside(functions[2:], terms + 1)),
    ]


def rim_forms(name, functions):
    columns = [piece(lambda w, g=g: g(1 - w * w), mpf(0), 2 * RIM_MIDDLE, 16, mpf(1)) for g in functions]
    wrench = [value for power in zip(*columns[:2]) for value in power]
    return [
        array(f"{name}: f and s·m in w near the rim, 16 terms.", f"{name}_rim_wrench", wrench),
        array(f"{name}: s³·df/ds in w near the rim, 16 terms.", f"{name}_rim_slope", columns[2]),
    ]


def places():
    middles = [float(middle) for middle, _ in outside_pieces()]
    return [
        array("In s⁻², of each piece from s = 1 + 1/16 on.", "outside_middles", middles),
        f"/// In w, of the piece near the rim.\ninline constexpr double rim_middle = {float(RIM_MIDDLE)!r};\n",
    ]


def elliptic_forms():
    parts = []
    both = [lambda eta, i=i: elliptic(eta)[i] for i in range(2)]
    parts.append(array("B and D in η, 12 pieces of 13 terms.", "elliptic", octave_pieces(both, 3, 13)))
    rim = mpf(1) / 8
    at_rim = [lambda eta, i=i: elliptic_at_rim(eta)[i] for i in range(4)]
    for i, (comment, name) in enumerate((("B0 and D0", "elliptic_at_rim"), ("B1 and D1", "elliptic_logarithm"))):
        columns = [piece(g, mpf(0), rim, 12, mpf(1)) for g in at_rim[2 * i : 2 * i + 2]]
        parts.append(array(f"{comment} on η ≤ 1/8, 12 terms.", name, [v for power in zip(*columns) for v in power]))
    return parts


def gaussian_forms():
    bessel = [lambda y, i=i: gaussian(y)[i] for i in range(3)]
    return [
        array("f/(x·y) and m/(σ√(π/2)·y) in y, 17 pieces of 15 terms.", "gaussian_wrench", equal_pieces(bessel[:2], 17, 15)),
        array("The slope over y³ in y, 17 pieces of 17 terms.", "gaussian_slope", equal_pieces(bessel[2:], 17, 17)),
    ]


def polynomials(whose):
    return f"Polynomials in double precision: {whose}. Coefficients per piece and power, lowest first, one a function."


HEADERS = {
    "economised_outside.hpp": ("The middles of the pieces of all closed forms outside the rim.", places),
    "economised_hertz.hpp": (polynomials("Hertz"), lambda: outside_forms("hertz", family(mpf(1) / 2), 8) + rim_forms("hertz", family(mpf(1) / 2))),
    "economised_flat_punch.hpp": (polynomials("the flat punch"), lambda: outside_forms("flat_punch", family(-mpf(1) / 2), 9)
                                  + rim_forms("flat_punch", family(-mpf(1) / 2))),
    "economised_cone.hpp": (polynomials("the cone"), lambda: outside_forms("cone", cone(), 8) + rim_forms("cone", cone())),
    "economised_uniform.hpp": (polynomials("uniform pressure"), lambda: outside_forms("uniform", family(mpf(0)), 8)),
    "economised_parabolic.hpp": (polynomials("parabolic pressure"), lambda: outside_forms("parabolic", family(mpf(1)), 8)),
    "economised_elliptic.hpp": (polynomials("the elliptic integrals B and D"), elliptic_forms),
    "internal/economised_gaussian.hpp": (polynomials("the Gaussian's Bessel functions"), gaussian_forms),
}


def header(what, parts):
    return (
        "// SPDX-License-Identifier: MIT\n"
        "// Made by scripts/economise.py, which says what these are; do not edit.\n"
        "// clang-format off\n"
        "#pragma once\n\n"
        "#include <array>\n\n"
        f"/// {what}\n"
        "namespace limitcurve::economised {\n\n" + "\n".join(parts) + "\n}  // namespace limitcurve::economised\n"
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--check", action="store_true", help="compare with the files instead of writing them")
    check = parser.parse_args().check
    for name, (what, forms) in HEADERS.items():
        text = header(what, forms())
        file = FOLDER / name
        if not check:
            file.write_text(text)
        elif not file.exists() or file.read_text() != text:
            sys.exit(f"{file} is not what this script makes")


if __name__ == "__main__":
    main()
