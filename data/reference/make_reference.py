#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Reference values of the unit limit curve: limit_curve.csv beside this script.

    make_reference.py                   write limit_curve.csv (about 12 minutes)
    make_reference.py LAW ...           write the rows of these laws only
    make_reference.py --check           compute it again, compare it byte by byte with the file, and let a
                                        second derivation confirm every value (about 14 minutes)
    make_reference.py --check LAW ...   the same for some laws only: two seconds each for those with formulas, about a
                                        minute for the cone and 100 s for each k of xydas-kao

For a contact of radius a that turns about a centre of rotation (COR) at the distance c, the unit wrench at
s = c/a is f = F/(mu P), m = M/(mu P a). The third quantity is the slope df/ds; dm/ds is -s df/ds. Every s, and
every parameter of a law, is the exact value of the double nearest to its decimal. So are the weights of
a mixture, which are then divided by their sum: a law has unit load.

Two derivations that share only the definition of the pressure:

 1. Formulas: hypergeometric ones for p ~ (1 - r^2)^n, confluent ones for the Gaussian, elementary ones for the
    cone, each at a precision increased by the digits that it loses.
 2. Chords, that is, polar coordinates centred on the COR. Along a chord at the distance h from the contact
    centre the pressure enters by two numbers only,
        A(h) = int p dx,   A2(h) = int p x^2 dx,
    and with H = min(s, 1)
        f     = 2 int_0^H A  sqrt(1 - h^2/s^2) dh,
        m     = 2 int_0^H A2 / sqrt(s^2 - h^2) dh,
        df/ds = 2/s^2 int_0^H A h^2 / sqrt(s^2 - h^2) dh.
    A and A2 are integrated numerically from the pressure wherever they are not elementary.

The file has the values of the formulas, which the chords confirm. The law of Xydas and Kao has no formula: there
the file has those of the chords, and rings of pressure with complete elliptic integrals confirm them.
"""

import argparse
import math
import sys
import time
from pathlib import Path

from mpmath import mp, mpf

sys.dont_write_bytecode = True

from chords import Chords  # noqa: E402
from double_exponential import FORMULA_DIGITS  # noqa: E402
from pressure_laws import LAWS  # noqa: E402
from rings import rings  # noqa: E402

OUTPUT = Path(__file__).with_name("limit_curve.csv")
HEADER = (
    "# Unit wrench f = F/(mu P), m = M/(mu P a) and df/ds at s = c/a; s is the exact double printed."
    " Made by make_reference.py.\n"
    "law,c_over_a,force,moment,force_slope\n"
)
PRINTED_DIGITS = 30
AGREEMENT = mpf(10) ** -30

POINTS = [
    0.0, 1e-300, 1e-150, 1e-12, 1e-8, 1e-4, 0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99, 0.9999,
    1 - 1e-8, 1 - 1e-12, 1 - 2.0**-53, 1.0, 1 + 2.0**-52, 1 + 1e-12, 1 + 1e-8, 1.0001,
    1.01, 1.1, 1.4, 1.5, 2.0, 3.0, 10.0, 100.0, 1e4, 1e8, 1e12, 1e150, math.inf,
]  # fmt: skip


def rows(name, witness):
    """The lines of one law and, if asked for, the worst relative difference of its two derivations."""
    law = LAWS[name]
    chords = Chords(law, POINTS) if witness or law.unit_wrench is None else None
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
    parser.add_argument("laws", nargs="*", metavar="LAW", help="only these laws")
    arguments = parser.parse_args()
    unknown = [name for name in arguments.laws if name not in LAWS]
    if unknown:
        parser.error(f"unknown law {unknown[0]}")

    # Agreement is judged at a precision that does not limit it.
    mp.dps = FORMULA_DIGITS
    fresh, failed = {}, False
    committed = OUTPUT.read_text() if arguments.check or arguments.laws else ""
    for name in arguments.laws or LAWS:
        start = time.monotonic()
        lines, worst = rows(name, witness=arguments.check)
        fresh[name] = "".join(lines)
        note = ""
        if arguments.check:
            failed |= worst > AGREEMENT or fresh[name] not in committed
            note = f", derivations agree to {mp.nstr(worst, 2)}"
            if fresh[name] not in committed:
                note += ", DIFFERS from the file"
        print(f"{name}: {time.monotonic() - start:.0f} s{note}", file=sys.stderr)
    if arguments.laws:  # the others stay as they are
        for line in committed.removeprefix(HEADER).splitlines(keepends=True):
            law = line.split(",")[0]
            if law not in arguments.laws:
                fresh[law] = fresh.get(law, "") + line
    text = HEADER + "".join(fresh[name] for name in LAWS if name in fresh)
    if not arguments.check:
        OUTPUT.write_text(text)
    elif not arguments.laws:
        failed |= text != committed
    if failed:
        sys.exit(f"{OUTPUT.name}: the check failed")


if __name__ == "__main__":
    main()
