# SPDX-License-Identifier: MIT
"""What docs/paper.md says of the paper's claims: of people, of its experiment, and of what it assumes."""

import math
import unittest

from command_line import DATA, FINGER, CommandLineTest, data, rows, run, table

QUIET = ["--damping", "86", "--operator", "target=30deg,speed=0.1,rate=0.1", "--duration", "20"]


def reversals(found, least=0.1):
    """How often the block of `pivot` turns back by more than `least` [deg]."""
    extreme, sense, count = 0.0, 1, 0
    for row in found:
        ahead = sense * (math.degrees(row["angle"]) - extreme)
        if ahead > 0 or ahead < -least:
            extreme = math.degrees(row["angle"])
        if ahead < -least:
            sense, count = -sense, count + 1
    return count


class Claims(CommandLineTest):
    def pivot(self, case, *options):
        """Angle [deg], slip [mm] and reversals at the end, and the rows."""
        found = [row for row in rows("pivot", "--case", case, *options) if row["state"] != "free"]
        return math.degrees(found[-1]["angle"]), 1e3 * found[-1]["grip_slip"], reversals(found), found

    def test_what_a_soft_finger_costs(self):
        done = run("choose", "--law", "hertz", "--tolerance", "0.01", "--scene", "--mu", "0.6", "--loads", "0.5,2",
                   "--stiffness", "1000", "--twist-stiffness", "0.036", "--twist-rate", "2")
        cost = {row["model"]: row["nanoseconds"] for row in table(done.stdout)}
        self.assertEqual(round(cost["ellipse/radial"] / cost["no torsion"]), 2)
        self.assertEqual(round(cost["table/closest-point"] / cost["no torsion"]), 4)

    def test_friction_does_not_know_the_speed(self):
        motion = (DATA / "traces" / "slide_twist_load.csv").read_text().splitlines()
        slow = [
            line if line[0] in "#t" else f"{7 * float(line.split(',')[0])}," + line.split(",", 1)[1] for line in motion
        ]
        for curve in (["ellipse", "--projection", "radial"], ["table"], ["box", "--mu-dynamic", "0.5"]):
            ever, slower = (rows("replay", "--trace", self.file("trace.csv", "\n".join(lines) + "\n"), *FINGER,
                                 "--curve", *curve) for lines in (motion, slow))
            self.assertIn("slip", {row["state"] for row in ever})
            for name in ("px", "py", "angle", "fx", "fy", "moment"):
                self.assertEqual([row[name] for row in ever], [row[name] for row in slower])

    def test_curves_in_the_plane_of_r_and_rho(self):
        for call in (["p-curves", "--loads", "0,0.5,1", "--points",
                      "9"], ["c-curves", "--cors", "0,0.006,inf", "--loads", "0.5,1"]):
            plain, found = rows(*call, *FINGER[:6]), rows(*call, *FINGER)
            self.assertEqual(list(found[0]), [*plain[0], "r", "rho"])
            for row in found:
                self.assert_close(row["r"], row["force"] / 1000, 1e-15)
                self.assert_close(row["rho"], row["moment"] / 0.036, 1e-15)
            self.assertEqual([{name: row[name] for name in plain[0]} for row in found], plain)

    def test_smooth_in_a_not_in_b(self):
        for case, slip in (("coupled", 4.5), ("exact", 4.1)):
            angle, slid, back, _ = self.pivot(case, *QUIET)
            self.assertAlmostEqual(angle, 30.1, delta=0.15)
            self.assertAlmostEqual(slid, slip, delta=0.05)
            self.assertLessEqual(back, 1 if case == "exact" else 0)
        # The default dampers let the block oscillate.
        *_, found = self.pivot("coupled", "--operator", "target=30deg")
        self.assertEqual(reversals([row for row in found if row["time"] < 3.148]), 10)
        for options, turned, slid in ((["--operator", "target=30deg"], 2.0, 3.5), (QUIET, 25.6, 9.7)):
            found = self.pivot("uncoupled", "--offset", "0.0065", *options)
            self.assertAlmostEqual(found[0], turned, delta=0.1)
            self.assertAlmostEqual(found[1], slid, delta=0.06)

    def test_the_offset_decides_what_b_can_do(self):
        for offset in ("0.001", "0.003", "0.005", "0.006"):
            angle, *_ = self.pivot("uncoupled", "--offset", offset, *QUIET)
            self.assertAlmostEqual(angle, 0, delta=0.05)
        angle, slid, *_ = self.pivot("uncoupled", "--offset", "0.009", *QUIET)
        self.assertAlmostEqual(angle, 30, delta=0.1)
        self.assertEqual(slid, 0)
        angle, slid, *_ = self.pivot("coupled", "--offset", "0.009", *QUIET)
        self.assertAlmostEqual(angle, 30.1, delta=0.1)
        self.assertAlmostEqual(slid, 2.34, delta=0.02)

    def test_the_centre_of_rotation_moves_as_the_load_falls(self):
        # At one load from the end of the release on; the force is the weight, so only the weight's moment falls.
        still = [row for row in self.pivot("coupled", "--damping", "0", "--release", "from=0.385,to=0.375,over=1")[3]
                 if row["state"] == "slip" and 1 < row["time"] < 2]
        self.assertGreater(math.degrees(still[-1]["angle"] - still[0]["angle"]), 15)
        self.assertEqual({row["load"] for row in still}, {0.375})
        self.assertAlmostEqual(1e3 * still[0]["cor"], 7.60, delta=0.01)
        self.assertAlmostEqual(1e3 * still[-1]["cor"], 7.70, delta=0.01)
        released = [
            row for row in self.pivot("coupled", "--damping", "0", "--release", "from=0.5,to=0.25,over=10")[3]
            if row["state"] == "slip"
        ]
        held = [row for row in released if row["load"] > 0.285]
        self.assertAlmostEqual(1e3 * released[0]["cor"], 7.3, delta=0.05)
        self.assertGreater(held[-1]["cor"], 1)
        self.assertLess(max(row["r"] for row in held) / min(row["r"] for row in held), 1.05)

    def test_steps_beyond_the_p_curve(self):
        found = rows("pivot", "--case", "coupled", "--damping", "0", "--release", "from=0.45,to=0.25,over=2", "--every",
                     "10")
        steps = sorted(row["trial_r"] - row["r"] for row in found if row["state"] == "slip")
        self.assertEqual([round(1e6 * step) for step in (steps[len(steps) // 2], steps[-1])], [19, 127])

    def test_a_torque_costs_less_the_larger_the_force(self):
        """What the abstract of the paper's reference [6] says of people's fingers, by eq. (17), Table 1."""
        forces, moments = ([most * i / 4 for i in range(5)] for most in (3.4, 0.05))

        def first_cost(grid):
            return [line[1] - line[0] for line in grid]

        for material in data("materials.csv"):
            mu, mu_r = material["mu"], material["mu_r"]
            grid = self.csv("grid.csv", "force,moment", [(force, moment) for force in forces for moment in moments])
            loads = [
                row["hold_load"]
                for row in rows("hold", "--law", "hertz", "--radius-law",
                                f"constant:a={mu_r / mu * 16 / (3 * math.pi)!r}", "--mu", mu, "--data", grid)
            ]
            exact = [loads[5 * i:5 * i + 5] for i in range(5)]
            ellipse, box, diamond = ([[bear(force / mu, moment / mu_r) for moment in moments] for force in forces]
                                     for bear in (math.hypot, max, lambda x, y: x + y))
            for less, more in zip(first_cost(exact)[1:], first_cost(exact)):
                self.assertLess(less, more)
            self.assertLess(
                max(1 - less / more for line, other in zip(ellipse, exact) for less, more in zip(line[1:], other[1:])),
                0.06)
            if material["material"] == "rayon":
                self.assertEqual([round(first_cost(grid)[0], 1) for grid in (exact, ellipse, box, diamond)], [4.1] * 4)
                self.assertEqual([round(first_cost(grid)[-1], 2) for grid in (exact, ellipse, box, diamond)],
                                 [1.43, 0.98, 0, 4.1])
                self.assertAlmostEqual(mu * moments[1] / mu_r, 1.72,
                                       delta=0.005)  # from this force on the box sees no moment

    def lost(self, case, *options):
        """The angle [deg] when the block has slid 5 mm past the grip, without dampers."""
        found = self.pivot(case, "--damping", "0", *options)[3]
        before, row = next(pair for pair in zip(found, found[1:]) if pair[1]["grip_slip"] >= 0.005)
        part = (0.005 - before["grip_slip"]) / (row["grip_slip"] - before["grip_slip"])
        return math.degrees(before["angle"] + part * (row["angle"] - before["angle"]))

    def test_the_ellipse_is_good_enough_for_the_experiment(self):
        for case, angle in (("coupled", 33.07), ("exact", 35.5)):
            self.assertAlmostEqual(self.lost(case, "--release", "from=0.5,to=0.25,over=10"), angle, delta=0.02)

    def test_the_rate_of_release_decides_a_too(self):
        for offset, over, angles in ((3, 2.5, (10, 15, 0)), (5, 10, (32, 35, 0)), (5, 0.5, (8, 11, -1)), (7, 2.5,
                                                                                                         (37, 38, 17))):
            found = (self.lost(case, "--offset", f"{1e-3 * offset}", "--release", f"from=0.5,to=0,over={over}")
                     for case in ("coupled", "exact", "uncoupled"))
            self.assertEqual(tuple(map(round, found)), angles)


if __name__ == "__main__":
    unittest.main()
