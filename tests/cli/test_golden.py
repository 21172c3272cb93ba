# SPDX-License-Identifier: MIT
"""What replay and pivot gave when it was recorded, they give still: data/golden.txt, to 1e-9 of the largest magnitude
of a column in its case.

    LIMITCURVE=EXECUTABLE LIMITCURVE_DATA=data tests/cli/test_golden.py --record 'plane/*'

records the cases of these names again, the same columns and rows. A new case begins as the line `case NAME: ARGUMENTS`,
a line of columns that begins with `row`, and lines that hold the numbers of rows.
"""

import fnmatch
import math
import sys
import unittest

from command_line import DATA, number_or_text, run, table

FILE = DATA / "golden.txt"
TOLERANCE = 1e-9
# Below these magnitudes a column is only rounding [m, rad, N, N m]; other columns have no unit.
FLOORS = {
    **dict.fromkeys(["px", "py", "pz", "depth", "bx", "by", "bz", "x", "y", "grip_slip"], 1e-3), "angle": 1e-2,
    "moment": 1e-5,
    "friction_moment": 1e-5,
    **dict.fromkeys(["fx", "fy", "fz", "load", "friction_force"], 1e-2), "r": 1e-5,
    "trial_r": 1e-5,
    "rho": 1e-4,
    "trial_rho": 1e-4
}


def read_cases():
    """Of each case its lines: the arguments, the columns, and the rows."""
    cases = {}
    for line in FILE.read_text().splitlines():
        if line.startswith("case "):
            name, arguments = line.removeprefix("case ").split(": ", 1)
            cases[name] = [arguments]
        elif line and not line.startswith("#"):
            cases[name].append(line)
    return cases


def output(case):
    """The cells of the recorded columns and rows, as the command prints them now."""
    done = run(*case[0].split(), cwd=DATA.parent)
    if done.returncode:
        raise AssertionError(done.stderr)
    rows = table(done.stdout, str)
    return [[rows[int(line.split(",")[0])][name] for name in case[1].split(",")[1:]] for line in case[2:]]


def differences(column, expected, found):
    """Of each cell of a column its difference in tolerances."""
    expected, found = [list(map(number_or_text, cells)) for cells in (expected, found)]
    kind = column.rstrip("0123456789")
    if kind == "cor":  # a centre of rotation at c is as good as a wrench at c/(c + a)
        expected, found = [[1.0 if cell == math.inf else cell / (cell + 0.005)
                            for cell in cells]
                           for cells in (expected, found)]
    scale = max(
        [FLOORS.get(kind, 1.0), *(abs(cell) for cell in expected if not isinstance(cell, str) and math.isfinite(cell))])
    for one, other in zip(expected, found):
        same = isinstance(one, str) or isinstance(other, str) or math.isnan(one) or math.isnan(other)
        yield (0.0 if str(one) == str(other) else math.inf) if same else abs(one - other) / (TOLERANCE * scale)


class Recorded(unittest.TestCase):
    def test_every_case_gives_what_it_gave(self):
        cases = read_cases()
        self.assertTrue(cases)
        for name, case in cases.items():
            with self.subTest(name):
                rows = [line.split(",")[1:] for line in case[2:]]
                for column, expected, found in zip(case[1].split(",")[1:], zip(*rows), zip(*output(case))):
                    for line, one, other, off in zip(case[2:], expected, found, differences(column, expected, found)):
                        self.assertLessEqual(
                            off, 1.0,
                            f"row {line.split(',')[0]}, {column}: expected {one}, got {other}, off by so many "
                            "tolerances"
                        )


def record(patterns):
    cases = read_cases()
    names = [name for name in cases if any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns)]
    for name in names:
        found = [[f"{value:.12g}" if isinstance(value, float) else value
                  for value in map(number_or_text, row)]
                 for row in output(cases[name])]
        cases[name][2:] = [",".join([line.split(",")[0], *row]) for line, row in zip(cases[name][2:], found)]
    FILE.write_text("\n".join(
        [FILE.read_text().split("\n", 1)[0], *(f"\ncase {name}: " + "\n".join(case)
                                               for name, case in cases.items())]) + "\n")
    print(f"{len(names)} of {len(cases)} cases recorded")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--record"]:
        record(sys.argv[2:])
    else:
        unittest.main()
