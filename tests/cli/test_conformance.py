# SPDX-License-Identifier: MIT
"""Questions that every interface answers alike (data/conformance.csv): here the exported header in C."""

import math
import subprocess
import unittest
from collections import defaultdict

from command_line import CommandLineTest, data, rows

# Reads "quantity numbers" a line.
ASK = """
#include <stdio.h>
#include <string.h>
#include "t.h"
int main(void) {
  char what[16];
  double a, b, chi;
  while (scanf("%15s %lf %lf %lf", what, &a, &b, &chi) == 4) {
    const t_friction found = what[0] == 'w' ? t_wrench((REAL)a, (REAL)b) : t_closest_point((REAL)a, (REAL)b, (REAL)chi);
    if (what[0] == 'g') printf("%.17g\\n", (double)t_gauge((REAL)a, (REAL)b));
    else printf("%.17g %.17g\\n", (double)found.force, (double)found.moment);
  }
  return 0;
}
"""


def questions():
    """By law: quantity, radius law, arguments and answer."""
    result = defaultdict(list)
    for row in data("conformance.csv", str):
        words = row["arguments"].split()
        radius = next((word for word in words if ":" in word), "")
        result[row["law"]].append((row["quantity"], radius, [float(word) for word in words if word != radius],
                                   [float(x) for x in row["answer"].split()]))
    return result


class Questions(CommandLineTest):
    def check(self, question, got, tolerance):
        for value, expected in zip(got, question[3], strict=True):
            if math.isnan(expected):
                self.assertTrue(math.isnan(value), (question, got))
            elif math.isinf(expected):
                self.assertEqual(value, expected, question)
            else:
                self.assertLessEqual(abs(value - expected), tolerance * max(1, abs(expected)), (question, got))

    def test_the_exported_header(self):
        for law, asked in questions().items():
            self.of_header(law, asked, "double", 2e-9, 0, math.inf)

    def test_the_exported_header_in_single_precision(self):
        self.of_header("hertz", questions()["hertz"], "float", 2e-6, 2.0**-149, 2.0**128)

    def of_header(self, law, asked, real, tolerance, least, most):
        rows("table", "--law", law, "--tolerance", tolerance / 2, "--name", "t", "--real", real, "-o",
             self.directory / "t.h")
        self.file("ask.c", ASK)
        subprocess.run(["cc", "-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-DREAL=" + real, "ask.c", "-o", "ask"],
                       cwd=self.directory,
                       check=True)
        asked = [question for question in asked if question[0] in ("wrench", "gauge", "closest")
                 and not any(0 < abs(x) < least or most <= abs(x) < math.inf for x in question[2])]
        lines = "".join(f"{what} {' '.join(map(repr, [*of, 1.0][:3]))}\n" for what, _, of, _ in asked)
        answers = subprocess.run([self.directory / "ask"], input=lines, capture_output=True, text=True,
                                 check=True).stdout.splitlines()
        self.assertEqual(len(answers), len(asked))
        ratio = rows("eval", "--law", law, "--c", 0)[0]["moment"]
        for question, line in zip(asked, answers):
            # Errors of a table are in units of the larger of 1 and m0.
            self.check(question, [float(word) for word in line.split()], tolerance * max(ratio, 1 / ratio))


if __name__ == "__main__":
    unittest.main()
