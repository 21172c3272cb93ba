# SPDX-License-Identifier: MIT
"""pivot: the paper's experiment with its options, and errors for bad options."""

import math
import unittest

from command_line import CommandLineTest, data, rows, run, table

CASES = ["coupled", "uncoupled", "exact"]


class Pivot(CommandLineTest):
    def test_grip_from_a_file_is_the_release(self):
        grip = self.file("grip.csv", "# eased\ntime,load\n0,1.5\n1,0.5\n")
        call = ["pivot", "--case", "exact", "--duration", "1"]
        self.assertEqual(
            rows(*call, "--grip", grip)[-1]["angle"],
            rows(*call, "--release", "over=1,from=1.5,to=0.5")[-1]["angle"])

    def test_every_nth_row(self):
        call = ["pivot", "--case", "exact", "--duration", "0.1"]
        lines = run(*call).stdout.splitlines()
        self.assertEqual(run(*call, "--every", "7").stdout.splitlines(), lines[:1] + lines[1::7])

    def test_angles(self):
        radians, marked, degrees = (
            run("pivot", "--case", "coupled", "--duration", "1", "--operator", f"target={angle}").stdout
            for angle in ("0.5235987755982988", "0.5235987755982988rad", "30deg"))
        self.assertEqual(radians, marked)
        self.assertEqual(radians, degrees)

    # Eq. (7): distance and angle between the god-object of one finger and its goal, before and after step b. Geometry,
    # whatever the dampers.
    def test_the_god_object_in_the_plane_of_r_and_rho(self):
        mu, mu_r, stiffness = 1.67, 0.01011, 1000
        twist_stiffness = stiffness * (mu_r / mu) ** 2
        for case in CASES:
            release = ["pivot", "--case", case, "--release", "from=0.45,to=0.2,over=2", "--duration", "2"]
            found = rows(*release, "--damping", "0")
            self.assertTrue({row["state"] for row in found} >= {"stick", "slip"})
            for row in found:
                self.assertAlmostEqual(2 * stiffness * row["r"], row["friction_force"], delta=1e-9)
                self.assertAlmostEqual(2 * twist_stiffness * row["rho"], row["friction_moment"], delta=1e-11)
                if row["state"] == "stick":
                    self.assertEqual((row["trial_r"], row["trial_rho"]), (row["r"], row["rho"]))
                if row["state"] == "slip" and case == "coupled":
                    on_curve = math.hypot(stiffness * row["r"] / (mu * row["load"]),
                                          twist_stiffness * row["rho"] / (mu_r * row["load"]))
                    self.assertAlmostEqual(on_curve, 1, delta=1e-9)
                    self.assertAlmostEqual(row["trial_rho"] * row["r"], row["trial_r"] * row["rho"],
                                           delta=1e-12)  # radially
                if row["state"] == "free":
                    self.assertEqual([row[name] for name in ("r", "rho", "trial_r", "trial_rho")], [0, 0, 0, 0])

    def test_a_material_is_the_row_of_its_table(self):
        call = ["pivot", "--case", "coupled", "--duration", "0.02"]
        materials = data("materials.csv")
        self.assertGreater(len(materials), 2)
        for row in materials:
            self.assertEqual(run(*call, "--material", row["material"]).stdout,
                             run(*call, "--mu", row["mu"], "--mu-r", row["mu_r"]).stdout)

    # By hand: eq. (19) with half the weight for each finger, F/mu and 5 mm F/mu_r.
    def test_a_grip_that_cannot_hold_is_warned_of(self):
        needed = math.hypot(0.4905 / 0.42, 0.4905 * 5 / 3.05)
        call = ["pivot", "--case", "coupled", "--material", "rayon", "--duration", "0.1"]
        for grip in [["--release", "from=0.9,to=0,over=1"], ["--operator", "target=30deg,load=0.9"],
                     ["--grip", self.file("grip.csv", "time,load\n0,0.9\n1,2\n")]]:
            done = self.succeed(*call, *grip)
            self.assertRegex(
                done.stderr,
                r"\Alimitcurve: warning: the grip starts at 0.9 N per finger, which does not hold the block; it needs "
                r"\S+ N\n\Z"
            )
            self.assert_close(float(done.stderr.split()[-2]), needed, 5e-3)  # of three digits
        self.assertEqual(run(*call, "--release", f"from={needed * (1 + 1e-9)},to=0,over=10").stderr, "")
        done = run("pivot", "--case", "exact", "--mu", "0", "--mu-r", "0", "--twist-stiffness", "0.03", "--duration",
                   "0.1")
        self.assertIn("no load does", done.stderr)

    def test_the_operator_regrips_out_of_a_slide(self):
        call = ["pivot", "--material", "rayon", "--operator"]
        for case, states in (("uncoupled", ["free", "stick"]), ("coupled", ["stick", "stick"])):
            ends = [rows(*call, "target=30deg" + more, "--case", case)[-1] for more in (",on-slide=keep", "")]
            self.assertEqual([end["state"] for end in ends], states)
            # Runs to 30 degrees stay as they are.
            self.assertEqual(ends[0]["angle"] == ends[1]["angle"], case == "coupled")

    # Before the block leaves the fingers it turns by so much. The scan's stiffnesses are so many times k_l
    # (mu_r/mu_l)^2.
    def test_the_twist_stiffness_decides_what_the_radial_projection_does(self):
        usual = 1000 * (0.01011 / 1.67) ** 2
        for case, expected in [("coupled", [86, 50, 13, 1.5]), ("exact", [46, 53, 54, 54])]:
            for times, angle in zip([0.1, 1, 10, 100], expected):
                found = rows("pivot", "--case", case, "--twist-stiffness", times * usual)
                held = [row["angle"] for row in found if row["state"] != "free"]
                self.assertAlmostEqual(math.degrees(max(held)),
                                       angle,
                                       delta=0.5 if angle > 2 else 0.05,
                                       msg=f"{case} {times}")

    def test_curve_projection_and_radius_law_of_ones_own(self):
        release = ["--release", "from=0.45,to=0.3,over=2", "--duration", "2"]
        text = {case: run("pivot", "--case", case, *release).stdout for case in CASES}
        self.assertEqual(len(set(text.values())), 3)
        for case, curve, projection in (("coupled", "ellipse", "radial"), ("uncoupled", "box", "closest-point"),
                                        ("exact", "table", "closest-point")):
            own = ["--curve", curve, "--projection", projection]
            self.assertEqual(run("pivot", *own, *release).stdout, text[case])
        # What is left out is the case's, and without a case the exact one's.
        self.assertEqual(run("pivot", "--projection", "closest-point", *release).stdout, text["exact"])
        own = ["--curve", "ellipse", "--projection", "radial"]
        self.assertEqual(run("pivot", *own, "--case", "exact", *release).stdout, text["coupled"])
        # On a circle all projections are one, but dampers may make it an ellipse.
        for damper, is_idle in ([], True), (["--twist-damping", "0"], False):
            radial, closest = (run("pivot", "--case", "coupled", "--projection", projection, *release, *damper)
                               for projection in ("radial", "closest-point"))
            slips = [table(done.stdout)[-1]["grip_slip"] for done in (radial, closest)]
            self.assertEqual(["--projection has no effect" in radial.stderr, abs(slips[0] - slips[1]) < 1e-9],
                             [is_idle] * 2)
        done = run("pivot", "--curve", "exact", *release)
        self.assertRegex(done.stderr, r"\Alimitcurve: exact: a table with an error of at most \S+ in unit wrenches\n\Z")
        self.assertNotEqual(done.stdout, text["exact"])

    def test_a_radius_law_gives_the_moments_limit(self):
        # m0 a = mu_r/mu, and measured moments, Gamma = mu_r P: the same finger in other words, stiffnesses too.
        moments = self.csv("moments.csv", "load,moment", [(load, 0.01011 * load) for load in (0.1, 0.5, 2)])
        ends = [
            rows("pivot", "--case", "exact", *more, "--release", "from=0.45,to=0.3,over=2", "--duration", "2")[-1]
            for more in ([], ["--radius-law", f"constant:a={0.01011 / 1.67 / (3 * math.pi / 16)!r}"],
                         ["--radius-law", f"moments:{moments}"])
        ]
        for end in ends[1:]:
            for name in ("angle", "grip_slip", "r", "rho", "trial_rho"):
                self.assertAlmostEqual(ends[0][name], end[name], delta=1e-8, msg=name)


if __name__ == "__main__":
    unittest.main()
