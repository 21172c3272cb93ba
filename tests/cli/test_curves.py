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

    def test_every_listed_law_can_be_evaluated(self):
        for row in rows("laws"):
            pure_twist = rows("eval", "--law", row["law"], "--c", "0")[0]
            self.assertEqual(pure_twist["moment"], row["moment_ratio"])


class Eval(CommandLineTest):
    def test_numbers_read_back_exactly(self):
        places = [0.1, 1 / 3, 2**-1074, 1.7976931348623157e308, 1 + 2**-52]
        for row, place in zip(rows("eval", "--law", "hertz", "--c", numbers(places)), places):
            self.assertEqual(row["c"], place)

    def test_json_holds_the_same(self):
        call = ["eval", "--law", "hertz", "--c", "0.25,inf"]
        parsed = json.loads(run(*call, "--format", "json").stdout)
        self.assertEqual(parsed[1]["c"], "inf")
        parsed[1]["c"] = math.inf
        self.assertEqual(parsed, rows(*call))


class MeasuredProfiles(CommandLineTest):
    def profile(self, text):
        return "samples:" + str(self.file("profile.csv", text))

    def test_bad_profiles(self):
        for text, told in [("", "profile.csv:1:1"), ("radius\n1\n", "'pressure'"),
                           ("radius,pressure\n0,1\n1", "profile.csv:3"),
                           ("radius,pressure\n0,1\n0.5,nan\n1,0\n", "profile.csv:3:5"),
                           ("radius,pressure\n-1,1\n1,0\n", "profile.csv:2:1"),
                           ("radius,pressure\n0,1\n1,1\n", "profile.csv"),
                           ("radius,pressure\n0,0\n1,0\n2,0\n3,0\n", "profile.csv"),
                           ("radius,pressure\n0,1\n2,1\n1,1\n3,1\n", "profile.csv")]:
            self.assert_fails(2, ["--law", told, "expected"], "eval", "--law", self.profile(text), "--c", "1")
        self.assert_fails(2, ["absent.csv"], "eval", "--law", "samples:absent.csv", "--c", "1")
        self.assert_fails(2, ["samples:", "expected"], "eval", "--law", "samples:", "--c", "1")


class Curves(CommandLineTest):
    def test_a_measured_radius_law(self):
        radii = self.file("radii.csv", "load,radius\n1,0.002\n4,0.003\n")
        found = rows("c-curves", "--law", "hertz", "--radius-law", f"samples:{radii}", "--mu", "0.5", "--cors", "0",
                     "--loads", "1,2,4")
        self.assert_close(found[0]["moment"], 3 * math.pi / 16 * 0.5 * 0.002, 1e-14)
        call = ["p-curves", "--law", "hertz", "--mu", "1", "--loads", "1", "--radius-law"]
        for text, told in [("load\n1\n", "'radius'"), ("load,radius\n1,0.002\n", "expected at least 2"),
                           ("load,radius\n1,0\n2,1\n", "bad.csv:2:3"), ("load,radius\n2,0.002\n1,0.003\n", "bad.csv")]:
            self.assert_fails(2, ["--radius-law", told], *call, f"samples:{self.file('bad.csv', text)}")


if __name__ == "__main__":
    unittest.main()
