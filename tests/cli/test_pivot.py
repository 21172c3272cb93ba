# SPDX-License-Identifier: MIT
"""pivot: the paper's experiment by its options; what is wrong with them is told."""

import math
import unittest

from command_line import CommandLineTest, header, rows, run

CASES = ["coupled", "uncoupled", "exact"]


class Pivot(CommandLineTest):
    def test_columns(self):
        self.assertEqual(header("pivot", "--case", "coupled", "--duration", "0"),
                         "time,x,y,angle,grip_slip,load,friction_force,friction_moment,state,cor")

    def test_a_firm_grip_holds(self):
        for case in CASES:
            found = rows("pivot", "--case", case, "--release", "from=3,to=3,over=1", "--duration", "1", "--offset", "0.002")
            self.assertEqual({row["state"] for row in found}, {"stick"}, case)
            self.assertAlmostEqual(found[-1]["time"], 1, delta=2e-3)
            self.assertEqual(found[-1]["grip_slip"], 0)
            # The weight, and its moment about the grip.
            self.assertAlmostEqual(found[0]["friction_force"], 0.1 * 9.81, delta=1e-9)

    def test_an_operator_lets_the_block_turn_and_regrips(self):
        for case in ["coupled", "exact"]:
            found = rows("pivot", "--case", case, "--material", "sandpaper", "--operator", "target=30deg")
            self.assertIn("slip", {row["state"] for row in found})
            self.assertEqual(found[-1]["state"], "stick")
            self.assertAlmostEqual(math.degrees(found[-1]["angle"]), 30, delta=3)

    def test_without_coupling_it_slides_out_with_hardly_a_turn(self):
        found = rows("pivot", "--case", "uncoupled", "--release", "from=1,to=0,over=4", "--duration", "5")
        self.assertEqual(found[-1]["state"], "free")
        self.assertLess(max(abs(row["angle"]) for row in found if row["grip_slip"] < 0.01), math.radians(5))

    def test_grip_from_a_file_is_the_release(self):
        grip = self.file("grip.csv", "# eased\ntime,load\n0,1.5\n1,0.5\n")
        call = ["pivot", "--case", "exact", "--duration", "1"]
        self.assertEqual(rows(*call, "--grip", grip)[-1]["angle"], rows(*call, "--release", "over=1,from=1.5,to=0.5")[-1]["angle"])

    def test_a_block_that_has_begun_to_slip_is_held_less(self):
        call = ["pivot", "--case", "exact", "--release", "from=0.45,to=0.39,over=2", "--duration", "2"]
        as_ever, slippery = rows(*call), rows(*call, "--mu-dynamic", "1.5", "--moment-coefficient-dynamic", "0.009")
        # The static limit counts until it slips; then it turns farther.
        first = next(i for i, row in enumerate(as_ever) if row["state"] == "slip")
        self.assertEqual([row["angle"] for row in slippery[:first]], [row["angle"] for row in as_ever[:first]])
        self.assertGreater(slippery[-1]["angle"], as_ever[-1]["angle"] + 0.1)
        self.assert_fails(2, ["mu_dynamic", "0 <= mu_dynamic <= mu"], *call, "--mu-dynamic", "2")

    def test_every_nth_row(self):
        call = ["pivot", "--case", "exact", "--duration", "0.1"]
        lines = run(*call).stdout.splitlines()
        self.assertEqual(run(*call, "--every", "7").stdout.splitlines(), lines[:1] + lines[1::7])

    def test_angles(self):
        call = ["pivot", "--case", "coupled", "--duration", "1", "--operator"]
        expected = rows(*call, "target=0.5235987755982988")
        self.assertEqual([row["load"] for row in rows(*call, "target=0.5235987755982988rad")], [row["load"] for row in expected])
        self.assertEqual([row["load"] for row in rows(*call, "target=30deg")], [row["load"] for row in expected])

    def test_bad_input(self):
        call = ["pivot", "--case", "coupled"]
        self.assert_fails(2, "--case", "pivot")
        self.assert_fails(2, ["--case", "A", "coupled|uncoupled|exact"], "pivot", "--case", "A")
        self.assert_fails(2, ["--material", "butter", "rayon, suede, sandpaper"], *call, "--material", "butter")
        for release in ["", "from=1", "from=1,to=0", "from=1,to=0,over=0", "from=-1,to=0,over=1", "from=1,to=0,over=nan", "from=1,to=0,over=1,",
                        "from=1,from=1,to=0,over=1", "from=1,to=0,until=1", "1,0,2", "from=1;to=0;over=2"]:
            self.assert_fails(2, ["--release", "expected"], *call, "--release", release)
        for operator in ["", "target", "target=", "target=30grad", "target=-30deg", "target=0", "target=nan", "rate=1", "target=30deg,speed=0"]:
            self.assert_fails(2, ["--operator", "expected"], *call, "--operator", operator)
        for text, place in [("time,load\n0,1\n0,2\n", "grip.csv:3:1"), ("time\n0\n", "'load'"), ("time,load\n0,-1\n", "grip.csv:2:3"),
                            ("time,load\n0,1\n1", "grip.csv:3:2"), ("", "grip.csv:1:1")]:
            self.assert_fails(2, [place, "expected"], *call, "--grip", self.file("grip.csv", text))
        self.assert_fails(2, "several", *call, "--release", "from=1,to=0,over=1", "--operator", "target=30deg")
        for option in ["--mass", "--length", "--height", "--stiffness", "--twist-stiffness", "--time-step"]:
            for value in ["0", "-1", "nan", "inf", "x"]:
                self.assert_fails(2, [option, "expected"], *call, option, value)
        self.assert_fails(2, "offset", *call, "--offset", "0.5")
        self.assert_fails(2, ["stiffness = 20 N/m", "half its height"], *call, "--stiffness", "20")
        self.assert_fails(2, ["twist_stiffness = 1e-04", "half a turn"], *call, "--twist-stiffness", "1e-4")


if __name__ == "__main__":
    unittest.main()
