#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Questions that every interface answers alike, and their answers: ../conformance.csv.

    make_conformance.py             write it (five minutes)
    make_conformance.py --check     compute it again and compare

The reference shares nothing with the library: it has the laws' unit wrenches from mpmath (pressure_laws.py), hence the
support function H(v, w) = v f + w m, and searches over all slip twists.

    wrench   slide spin            -> force moment      the wrench that a twist slips at, of magnitudes
    gauge    force moment          -> gauge             max over twists of (F v + M w)/H(v, w)
    closest  force moment chi      -> force moment      nearest point of the curve in f^2 + chi m^2, with the trial's
             signs;
                                                        the trial itself inside the curve
    hold     mu radius force moment -> load             least load whose limits, mu P and mu P a, hold the wrench;
             radius: a radius law
    margin   mu radius load force moment -> margin      1 - gauge of the wrench at this load, not less than 0

Numbers are unit wrenches, in units of mu P and mu P a, but for hold and margin (SI). `nan` is an answer: a number that
is none goes in. What is typed or read from a file is refused where it is not finite.
"""

import argparse
import csv
import io
import math
import sys
from pathlib import Path

from mpmath import mp, mpf

sys.dont_write_bytecode = True

from pressure_laws import Gaussian, PowerLaw, XydasKao  # noqa: E402
from rings import rings  # noqa: E402

OUTPUT = Path(__file__).parent.parent / "conformance.csv"
LAWS = {
    "hertz": PowerLaw(0.5), "uniform": PowerLaw(0), "power:n=-0.9": PowerLaw(-0.9), "power:n=-0.99": PowerLaw(-0.99),
    "xydas-kao:k=0.05": XydasKao(0.05), "gaussian:sigma=50": Gaussian(50),
}  # fmt: skip
SPECIAL = (math.nan, math.inf, -math.inf)
DIGITS = 24  # a maximum is found to half of them


class Curve:
    def __init__(self, law):
        self.law = law
        self.known = {}
        self.moment_max = law.at_zero()[1] if law.unit_wrench is None else law.unit_wrench(mpf(0))[1]

    def at(self, slide, spin):
        """f and m of a twist of magnitudes."""
        if slide == 0 and spin == 0:
            return mpf(0), mpf(0)
        if spin == 0:
            return mpf(1), mpf(0)
        if slide == 0:
            return mpf(0), self.moment_max
        s = slide / spin
        if s not in self.known:
            self.known[s] = (rings(self.law, s) if self.law.unit_wrench is None else self.law.unit_wrench(s))[:2]
        return self.known[s]

    def best(self, value):
        """The spin fraction of the largest value(slide, spin, f, m): a scan, then golden sections. One hill is
        assumed."""
        def of(u):
            return value(1 - u, u, *self.at(1 - u, u))

        # Even in the logarithm of the COR's distance, over 16 decades, and both ends.
        grid = [mpf(0), *(1 / (1 + mpf(10) ** (mpf(i) / 4)) for i in range(32, -33, -1)), mpf(1)]
        values = [of(u) for u in grid]
        top = values.index(max(values))
        low, high = grid[max(top - 1, 0)], grid[min(top + 1, len(grid) - 1)]
        golden = (mp.sqrt(5) - 1) / 2
        a, b = high - golden * (high - low), low + golden * (high - low)
        at_a, at_b = of(a), of(b)
        for _ in range(56):
            if at_a < at_b:
                low, a, at_a = a, b, at_b
                b = low + golden * (high - low)
                at_b = of(b)
            else:
                high, b, at_b = b, a, at_a
                a = high - golden * (high - low)
                at_a = of(a)
        return max((grid[top], (low + high) / 2), key=of)


def wrench(curve, slide, spin):
    v, w = abs(slide), abs(spin)
    if math.isnan(v) or math.isnan(w) or (math.isinf(v) and math.isinf(w)):
        return math.nan, math.nan
    if math.isinf(v):
        return mpf(1), mpf(0)
    if math.isinf(w):
        return mpf(0), curve.moment_max
    return curve.at(mpf(v), mpf(w))


def gauge(curve, force, moment):
    force, moment = abs(force), abs(moment)
    if math.isnan(force) or math.isnan(moment):
        return (math.nan,)
    if math.isinf(force) or math.isinf(moment):
        return (math.inf,)
    if force == 0 and moment == 0:
        return (mpf(0),)
    force, moment = mpf(force), mpf(moment)

    def ratio(v, w, f, m):
        return (force * v + moment * w) / (v * f + w * m)

    u = curve.best(ratio)
    return (ratio(1 - u, u, *curve.at(1 - u, u)),)


def closest(curve, force, moment, chi):
    if not all(map(math.isfinite, (force, moment, chi))):
        return math.nan, math.nan
    if gauge(curve, force, moment)[0] <= 1:
        return mpf(force), mpf(moment)
    f_trial, m_trial, chi = mpf(abs(force)), mpf(abs(moment)), mpf(chi)
    # The distance along the outward normal is largest at the foot of the perpendicular, in the metric of the springs.
    def distance(v, w, f, m):
        return (f_trial * v + m_trial * w - (v * f + w * m)) / mp.sqrt(v * v + w * w / chi)

    u = curve.best(distance)
    f, m = curve.at(1 - u, u)
    return f * (1 if force >= 0 else -1), m * (1 if moment >= 0 else -1)


def hold(curve, mu, radius, force, moment):
    if math.isnan(force) or math.isnan(moment):
        return (math.nan,)
    if math.isinf(force) or math.isinf(moment):
        return (math.inf,)
    a = radius_law(radius)

    def needed(load):
        return gauge(curve, mpf(force) / mu, mpf(moment) / (mu * a(load)))[0]

    if radius.startswith("constant"):  # the gauge is homogeneous
        return (needed(mpf(1)),)
    low, high = mpf(10) ** -2, mpf(10) ** 2
    for _ in range(42):
        middle = mp.sqrt(low * high)
        low, high = (middle, high) if needed(middle) > middle else (low, middle)
    return (high,)


def radius_law(text):
    kind, _, rest = text.partition(":")
    given = {key: mpf(float(value)) for key, value in (item.split("=") for item in rest.split(","))}
    if kind == "constant":
        return lambda load: given["a"]
    return lambda load: given["c"] * load ** given["gamma"]


def margin(curve, mu, radius, load, force, moment):
    limit = mpf(mu) * mpf(load)
    used = gauge(curve, mpf(force) / limit, mpf(moment) / (limit * radius_law(radius)(mpf(load))))[0]
    return (max(mpf(0), 1 - used),)


ANSWERS = {"wrench": wrench, "gauge": gauge, "closest": closest, "hold": hold, "margin": margin}


def questions():
    plain = [(0.6, 0.8), (0.9, 0.5), (1.5, 0.2)]
    signed = [(x * f, y * m) for f, m in plain for x in (1, -1) for y in (1, -1)]
    axes = [(0.0, 0.0), (-0.0, 0.0), (0.0, -0.0), (1.5, 0.0), (0.0, 1.5), (-1.5, -0.0), (1.0, 1.0), (-1.0, 1.0)]
    tiny = [(5e-324, 5e-324), (1e-300, 1e-300), (1e300, 1e300), (1e300, 1e-300), (1e-300, 1e300), (-1e300, 0.0)]
    none = [pair for x in SPECIAL for y in (0.0, 0.3) for pair in ((x, y), (y, x))] + [(math.nan, math.nan),
                                                                                       (math.nan, math.inf)]
    trials = [(2.0, 0.1), (-2.0, 0.1), (2.0, -0.1), (1.5, 0.0), (0.0, 1.5), (-1.1, 0.0), (0.0, -1.1), (0.0, 0.0),
              (0.3, -0.2), (1.155, 0.573)]
    for law in LAWS:
        usual, slow = law == "hertz", law.startswith("xydas")
        for quantity in "wrench", "gauge":
            for pair in signed + axes + tiny + none if usual else plain + axes[3:]:
                yield quantity, law, pair
        for chi in (1e-3, 0.1, 1.0, 76.823, 1e3):
            for pair in trials if usual else trials[3:5] + trials[-1:] if chi in (0.1, 76.823) else ():
                yield "closest", law, (*pair, chi)
        if usual:
            for pair in ((math.nan, 0.1), (0.1, math.nan), (math.inf, 0.1), (0.1, -math.inf), (1e-300, 0.0),
                         (1e30, 1e30), (1e300, 1e300)):
                yield "closest", law, (*pair, 1.0)
            yield from (("closest", law, of) for of in ((2.0, 0.1, math.nan), (2e38, -2e38, 1e3), (1e37, 0.1, 1e-3),
                                                        (0.1, 1e37, 1e3), (1e306, 0.1, 1e-3), (0.1, -1e306, 1e3)))
            for pair in ((0.0, 0.0), (math.nan, 0.0), (1.0, math.nan), (math.inf, 0.0), (1e-300, 0.0), (1e300, 0.0)):
                yield "hold", law, (0.6, "constant:a=0.005", *pair)
        for radius in ("constant:a=0.005", "power:c=0.00207,gamma=0.259") if usual else ("constant:a=0.005",):
            for pair in ((1.0, 0.002), (-1.0, -0.002), (1.0, 0.0), (0.0, 0.002))[: 2 if slow else 4]:
                yield "hold", law, (0.6, radius, *pair)
        for load in (1.9, 3.0):
            yield "margin", law, (0.6, "constant:a=0.005", load, -1.0, 0.002)


def number(value):
    if isinstance(value, str):
        return value
    value = float(value)
    return str(value) if not math.isfinite(value) else repr(value)


def made():
    text = io.StringIO()
    text.write(
        "# Questions that every interface answers alike; arguments and answers are explained in "
        "reference/make_conformance.py.\n"
    )
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(["quantity", "law", "arguments", "answer"])
    curves = {name: Curve(law) for name, law in LAWS.items()}
    with mp.workdps(DIGITS):
        for quantity, law, arguments in questions():
            answer = ANSWERS[quantity](curves[law], *arguments)
            rows.writerow([quantity, law, " ".join(map(number, arguments)), " ".join(map(number, answer))])
    return text.getvalue()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--check", action="store_true", help="compare with the file")
    text = made()
    if parser.parse_args().check:
        return OUTPUT.read_text(encoding="utf-8") != text
    OUTPUT.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
