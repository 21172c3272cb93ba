# SPDX-License-Identifier: MIT
"""laws, eval, curve, p-curves, c-curves: columns, and that they agree with each other."""

import json
import math
import re
import unittest
from pathlib import Path

from command_line import CommandLineTest, numbers, rows, run


class Laws(CommandLineTest):
    def test_lists_every_kind_with_its_ratio(self):
        listed = {row["law"]: row for row in rows("laws")}
        contract = (Path(__file__).resolve().parents[2] / "cli" / "README.md").read_text(encoding="utf-8")
        self.assertEqual(list(listed), re.search(r"^\| law \| `([^`]*)`", contract, re.M)[1].split())
        self.assertEqual(listed["hertz"]["moment_ratio"], 3 * math.pi / 16)
        self.assertEqual(listed["uniform"]["moment_ratio"], 2 / 3)
        self.assert_close(listed["xydas-kao:k=3"]["moment_ratio"], 0.620245007350, 1e-11)
        self.assertEqual({row["method"] for row in listed.values()}, {"closed", "ring"})


class Eval(CommandLineTest):
    def test_numbers_read_back_exactly(self):
        places = [0.1, 1 / 3, 2**-1074, 1.7976931348623157e308, 1 + 2**-52]
        for row, place in zip(rows("eval", "--law", "hertz", "--c", numbers(places)), places):
            self.assertEqual(row["c"], place)

    def test_json_holds_the_same(self):
        call = ["eval", "--law", "hertz", "--c", "0.25,inf"]
        first, last = json.loads(run(*call, "--format", "json").stdout)
        self.assertEqual(last["c"], "inf")
        self.assertEqual([first, {**last, "c": math.inf}], rows(*call))


if __name__ == "__main__":
    unittest.main()
