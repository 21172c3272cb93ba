# SPDX-License-Identifier: MIT
"""replay: the wrench along a trace, and that it settles at the right value."""

import math
import unittest

from command_line import CommandLineTest, header, rows, run
from recorded_finger import COLUMNS, FINGER, M0, MEASURED, TRACE


class Replays(CommandLineTest):
    def replay(self, text, *options, remark=""):
        return rows("replay",
                    "--trace",
                    self.file("trace.csv", text),
                    *(MEASURED if "--mu-r" in options else FINGER),
                    *options,
                    remark=remark)

    def test_press_and_drag(self):
        free, touch, stick, slip = self.replay(TRACE)
        self.assertEqual(header("replay", "--trace", self.directory / "trace.csv", *FINGER), COLUMNS)
        self.assertEqual([row["state"] for row in (free, touch, stick, slip)], ["free", "stick", "stick", "slip"])
        self.assertEqual((free["load"], free["fx"]), (0, 0))
        self.assertAlmostEqual(stick["load"], 1, delta=1e-12)
        self.assertAlmostEqual(stick["fx"], -0.1, delta=1e-12)
        self.assertEqual((stick["px"], stick["moment"]), (0, 0))
        self.assertTrue(math.isnan(stick["cor"]))
        self.assertAlmostEqual(slip["fx"], -0.6, delta=1e-9)
        self.assertAlmostEqual(slip["px"], 0.0044, delta=1e-9)
        self.assertEqual(slip["cor"], math.inf)

    def test_the_exact_curve_of_a_measured_profile_has_the_error_of_its_samples(self):
        profile = self.file(
            "profile.csv",
            "radius,pressure\n" +"".join(f"{i / 20},{math.sqrt(1 - (i / 20) ** 2)}\n" for i in range(21)))
        law = f"samples:{profile}"
        expected = rows("table", "--law", law, "--tolerance", 1e-9, "-o",
                        self.directory / "table.csv")[0]["profile_error"]
        call = ["replay", "--trace", self.file("trace.csv", TRACE), *FINGER, "--curve", "exact"]
        call[call.index("--law") + 1] = law
        said = run(*call).stderr
        total, profile_error = (float(said.split(before)[1].split()[0]) for before in ("at most ", "of which "))
        self.assert_close(profile_error, expected, 1e-2)
        self.assertGreaterEqual(total, profile_error)
        self.assertLess(total, 1.01 * expected)
        call[call.index("--law") + 1] = "hertz"
        self.assertNotIn("of which", run(*call).stderr)

    def test_coefficients(self):
        twist = "time,x,y,z,twist\n" + "".join(f"{i},0,0,-0.001,{i}\n" for i in range(7))
        self.assertAlmostEqual(self.replay(twist, "--mu-r", "0.004")[-1]["moment"], -0.004, delta=1e-12)
        falling = self.replay(twist.replace("-0.001", "-0.003"), "--mu-r", "0.004", "--gamma", -0.4)
        self.assert_close(falling[-1]["moment"], -0.004 * 3 ** 0.6, 1e-9)
        self.assertAlmostEqual(self.replay(TRACE, "--mu-dynamic", "0.3")[-1]["fx"], -0.3, delta=1e-9)
        slower = self.replay(twist, "--mu-r", "0.004", "--mu-r-dynamic", "0.003")
        self.assertAlmostEqual(slower[-1]["moment"], -0.003, delta=1e-12)

    def test_an_orientation_in_place_of_the_twist(self):
        samples = [(i / 1000, 1e-5 * i, -0.001, 0.02 * i) for i in range(700)]  # more than two turns
        plain = "time,x,y,z,twist\n" + "".join(f"{t},{x!r},0,{z},{twist!r}\n" for t, x, z, twist in samples)
        turned = "time,x,y,z,qw,qx,qy,qz\n" + "".join(
            f"{t},{x!r},0,{z},{math.cos(twist / 2)!r},0,0,{math.sin(twist / 2)!r}\n" for t, x, z, twist in samples)
        for one, other in zip(self.replay(plain), self.replay(turned)):
            self.assertEqual(one["state"], other["state"])
            for name in ["px", "angle", "fx", "moment"]:
                self.assertAlmostEqual(one[name], other[name], delta=1e-11)

    def test_a_trace_without_twist_does_not_twist(self):
        still = "time,x,y,z\n" + "".join(f"{i / 1000},{1e-5 * i!r},{2e-6 * i!r},-0.001\n" for i in range(200))
        told = still.replace("z\n", "z,twist\n").replace("-0.001\n", "-0.001,0\n")
        plain = run("replay", "--trace", self.file("told.csv", told), *FINGER)
        done = run("replay", "--trace", self.file("still.csv", still), *FINGER)
        self.assertEqual((done.returncode, done.stdout), (0, plain.stdout))
        self.assertEqual(done.stderr.count("limitcurve: note: the trace has no column 'twist'"), 1, done.stderr)
        self.assertNotIn("no column", plain.stderr)
        self.assertEqual(run("replay", "--trace", "-", *FINGER, input=still).stdout, plain.stdout)
        patch = [
            "--patch", "rectangle:x=0.01,y=0.005", "--mu", "0.6", "--stiffness", "1000", "--twist-stiffness", "0.036"
        ]
        done = run("replay", "--trace", self.directory / "still.csv", *patch)
        self.assertEqual(done.stdout, run("replay", "--trace", self.directory / "told.csv", *patch).stdout)
        self.assertIn("no column 'twist'", done.stderr)

    def settled(self, mu_r, *options):
        """Force after 100 mm and 20 rad about a centre of rotation at 5 mm, at 1 N, and standard error."""
        text = "time,x,y,z,twist\n" + "".join(f"{i / 1000},{1e-4 * i!r},0,-0.001,{0.02 * i!r}\n" for i in range(1000))
        done = run("replay", "--trace", self.file("trace.csv", text), "--law", "hertz", "--mu-r", mu_r, "--mu", "0.6",
                   "--stiffness", "1000", "--twist-stiffness", "0.036", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return -float(done.stdout.splitlines()[-1].split(",")[7]), done.stderr

    def test_a_small_contact_is_frictionless_under_eq_23_and_a_note_says_so(self):
        # mu P = 0.6 N.
        for mu_r, expected, is_far in [("0.01", 0.551, False), ("0.001", 0.135, True), ("0.0001", 0.0139, True),
                                       ("0.000001", 0.00014, True), ("0", 0.6, False)]:
            force, told = self.settled(mu_r, "--curve", "ellipse", "--projection", "radial")
            self.assert_close(force, expected, 0.01, mu_r)
            self.assertEqual(told.count("limitcurve: note: with --projection radial a finger"), is_far, told)
            self.assertEqual("almost no friction force" in told, is_far, told)
            self.assertEqual("with --projection c-curve a finger" in self.settled(mu_r, "--projection", "c-curve")[1],
                             is_far, mu_r)
            self.assertEqual(self.settled(mu_r)[1], "")
        self.assert_close(self.settled("0.0001", "--curve", "ellipse")[0], 0.5997, 1e-4)
        # A contact too large for its twist stiffness: the moment is what is lost.
        self.assertIn("almost no friction moment",
                      self.settled("0.02", "--projection", "radial", "--curve", "table")[1])

    def test_the_note_is_about_the_largest_load(self):
        # a^2 grows by 100^(2/3) = 22 from 0.02 to 2 N: right at 2 N, wrong at 0.02 N.
        grows = ["--radius-law", "power:c=0.005,gamma=0.3333333333333333"]
        radial = [*grows, "--curve", "ellipse", "--projection", "radial"]
        common = ["--law", "hertz", "--mu", "0.6", "--stiffness", "1000"]
        path = self.file("trace.csv", "time,x,y,z,twist\n0,0,0,-2e-5,0\n0.1,0,0,-2e-3,0.5\n")
        for share, notes in [(1, 0), (9.9, 0), (10.1, 1), (1 / 10.1, 1)]:
            stiffness = share * 1000 * (M0 * 0.005 * 2 ** (1 / 3)) ** 2
            done = run("replay", "--trace", path, *common, *radial, "--twist-stiffness", stiffness)
            self.assertEqual(done.stderr.count("times (mu_r/mu_l)^2 (at 2 N,"), notes, done.stderr)
        # choose knows both loads.
        chosen = run("choose", *common, *grows, "--loads", "0.02,2", "--tolerance", "0.1", "--scene",
                     "--twist-stiffness", 1000 * (M0 * 0.005 * 2 ** (1 / 3)) ** 2)
        self.assertIn("note: with the radial projection a finger", chosen.stderr)
        self.assertIn("at 0.02 N", chosen.stderr)

    def test_each_reason_of_invalid_rows_is_named_once(self):
        bad = TRACE + "0.004,1.006,0,-0.001,0\n0.005,0.0051,0,-0.001,0\n" \
            "0.001,0,0,-0.001,0\n0.002,0,0,-0.001,0\n0.006,2e6,0,-0.001,0\n"
        done = run("replay", "--trace", self.file("trace.csv", bad), *FINGER)
        self.assertEqual(done.stderr.splitlines(), [
            "limitcurve: note: 1 sample is invalid, the first at 0.006 s: a coordinate, the depth or the twist is "
            "beyond 1e6",
            "limitcurve: note: 1 sample is invalid, the first at 0.001 s: the time goes back or is not finite, after "
            "0.005 s",
            "limitcurve: note: 2 samples are invalid, the first at 0.004 s: the finger moved faster than the maximum "
            "speed"
        ])
        self.assertEqual(run("replay", "--quiet", "--trace", self.directory / "trace.csv", *FINGER).stderr, "")

    def test_a_leap_beyond_the_maximum_speed_is_told(self):
        metre = TRACE + "0.004,1.006,0,-0.001,0\n0.005,0.0051,0,-0.001,0\n"
        self.assertEqual([row["state"] for row in self.replay(metre, remark="maximum speed")][3:],
                         ["slip", "invalid", "slip"])
        self.assertEqual([row["state"] for row in self.replay(metre, "--max-speed", "inf")][3:],
                         ["slip", "slip", "slip"])


if __name__ == "__main__":
    unittest.main()
