# SPDX-License-Identifier: MIT
"""replay: the wrench along a trace, other surfaces, bodies and fingers, and files of any form."""

import math
import re
import unittest

from command_line import DATA, FINGER, MEASURED, CommandLineTest, header, rows, run

COLUMNS = "time,state,px,py,angle,depth,load,fx,fy,moment,cor"
M0 = 3 * math.pi / 16  # Hertz
# The shortest in which a finger is free, sticks and slips.
TRACE = "time,x,y,z,twist\n0,0,0,0.001,0\n0.001,0,0,-0.001,0\n0.002,0.0001,0,-0.001,0\n0.003,0.005,0,-0.001,0\n"


class Replays(CommandLineTest):
    def replay(self, text, *options, remark=""):
        return rows("replay", "--trace", self.file("trace.csv", text), *(MEASURED if "--mu-r" in options else FINGER),
                    *options, remark=remark)

    def test_the_exact_curve_of_a_measured_profile_has_the_error_of_its_samples(self):
        rim = [(i / 20, math.sqrt(1 - (i / 20) ** 2)) for i in range(21)]
        profile = self.csv("profile.csv", "radius,pressure", rim)
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
        samples = [(i / 1000, 1e-5 * i, 0, -0.001, 0.02 * i) for i in range(700)]  # more than two turns
        poses = [(*sample[:4], math.cos(sample[4] / 2), 0, 0, math.sin(sample[4] / 2)) for sample in samples]
        plain, turned = (rows("replay", "--trace", trace, *FINGER) for trace in (
            self.trace(samples), self.csv("poses.csv", "time,x,y,z,qw,qx,qy,qz", poses)))
        for one, other in zip(plain, turned, strict=True):
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
        patch = ["--patch", "rectangle:x=0.01,y=0.005", *FINGER[4:]]
        done = run("replay", "--trace", self.directory / "still.csv", *patch)
        self.assertEqual(done.stdout, run("replay", "--trace", self.directory / "told.csv", *patch).stdout)
        self.assertIn("no column 'twist'", done.stderr)

    def test_columns_that_are_not_read_are_named_once(self):
        names, numbers = ",qw,qx,qy,qz,bx,by,bz,x2,y2,z2,x3,y3\n", ",1,0,0,0,0,0,0,0,0,0,0,0\n"
        text = TRACE.replace("twist\n", "twist" + names).replace(",0\n", ",0" + numbers)
        done = run("replay", "--trace", self.file("more.csv", text), *FINGER)
        self.assertEqual(done.stdout, run("replay", "--trace", self.file("trace.csv", TRACE), *FINGER).stdout)
        self.assertEqual(
            done.stderr, "limitcurve: note: columns of the trace that are not read: qw,qx,qy,qz (twist is read "
            "instead); x2,y2,z2 (without --fingers 2); bx,by,bz (without --body trace)\n")

    def settled(self, mu_r, *options):
        """Force after 100 mm and 20 rad about a centre of rotation at 5 mm, at 1 N, and standard error."""
        trace = self.trace((i / 1000, 1e-4 * i, 0, -0.001, 0.02 * i) for i in range(1000))
        done = self.succeed("replay", "--trace", trace, *MEASURED, "--mu-r", mu_r, *options)
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
        # Dampers count with the springs: (F/mu P)^2 + (M/Gamma)^2 = 1 on the ray F/M = c k_l'/k_r', k' = k + b/dt.
        for b, b_r, is_far in (3.6, 0, True), (3.6, 1e-3, False), (0, 4e-3, True):
            slope = 0.005 * (1000 + b / 1e-3) / (0.036 + b_r / 1e-3)
            force, told = self.settled("0.01", "--curve", "ellipse", "--projection", "radial", "--damping", b,
                                       "--twist-damping", b_r)
            self.assert_close(force, 1 / math.hypot(1 / 0.6, 1 / (slope * 0.01)), 1e-3, b)
            self.assertEqual("dt = 0.001 s). Use --projection closest-point, or --twist-stiffness 0.28 --twist-damping "
                             f"{b / 3600:.2g}" in told, is_far, told)
            self.assertEqual(f"almost no friction {'moment' if b else 'force'}" in told, is_far, told)

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
            "speed past the body"
        ])
        self.assertEqual(run("replay", "--quiet", "--trace", self.directory / "trace.csv", *FINGER).stderr, "")
        # A fault of a finger names it, but one of the time does not.
        two = bad.replace("x,y,z,twist", "x2,y2,z2,twist2,x,y,z,twist").replace(",0\n", ",0,0,0,-0.001,0\n")
        said = run("replay", "--fingers", 2, "--trace", self.file("two.csv", two), *FINGER).stderr
        self.assertEqual(said, re.sub("note: (?!.*time goes)", "note: finger 2: ", done.stderr))

    def test_a_leap_may_be_allowed(self):
        leap = TRACE + "0.004,1.006,0,-0.001,0\n0.005,0.0051,0,-0.001,0\n"
        for allowed, remark, state in ((), "maximum speed", "invalid"), (("--max-speed", "inf"), "", "slip"):
            found = self.replay(leap, *allowed, remark=remark)
            self.assertEqual([row["state"] for row in found], ["free", "stick", "stick", "slip", state, "slip"])


class Files(CommandLineTest):
    def replayed(self, text):
        return run("replay", "--trace", self.file("trace.csv", text), *FINGER)

    def test_forms_that_mean_the_same(self):
        plain = self.replayed(TRACE)
        self.assertEqual(plain.returncode, 0, plain.stderr)
        table = [line.split(",") for line in TRACE.splitlines()]
        forms = {
            "comments": "# made by hand\n" + TRACE.replace("\n0.002", "\n  # a remark, with a comma\n\n0.002"),
            "carriage returns": TRACE.replace("\n", "\r\n"),
            "byte order mark": "\ufeff" + TRACE,
            "no last line end": TRACE[:-1],
            "blanks": TRACE.replace(",", " , "),
            "quotes": "\n".join(",".join(f'"{field}"' for field in row) for row in table) + "\n",
            "another order": "\n".join(",".join(reversed(row)) for row in table) + "\n",
            "more columns": "\n".join(",".join(["note", *row, "z2"] if i == 0 else ['"a, b ""c"""', *row, "nan"])
                                      for i, row in enumerate(table)) + "\n",
        }
        for form, text in forms.items():
            done = self.replayed(text)
            self.assertEqual((done.returncode, done.stdout), (0, plain.stdout), f"{form}: {done.stderr}")

    def test_files_of_another_kind(self):
        for name, told in (("absent.csv", ["absent.csv", "No such file"]), ("", "directory")):
            self.assert_fails(2, told, "replay", "--trace", self.directory / name, *FINGER)

    def test_gains_are_checked_as_replay_reads_the_trace(self):
        call = ["replay", "--trace", self.file("trace.csv", TRACE), *FINGER]
        plain = run(*call).stdout
        for device in ["b=0.51", "b=0.51,b_r=1.9e-5", "b=0.051,T=1e-4", "b=1.51,b_r=5.5e-5,delay=1"]:
            done = run(*call, "--check-gains", device)
            self.assertEqual((done.stdout, "the twist is not checked" in done.stderr), (plain, "b_r" not in device))
            self.assertIn("--check-gains: passed; the gains need b = ", done.stderr)
        # In units, with a header further down, through a pipe.
        text = "logged by a jig\ntime,x,y,z,twist\n" + "".join(f"{t},0,0,-1,0\n" for t in [0, 0.1, 10.1, 10.2])
        jitter = ["replay", *FINGER, "--units", "time=ms,length=mm", "--damping", "2", "--trace", "-", "--check-gains"]
        for device, status in (("b=15.2", 0), ("b=15", 2), ("b=2.6,T=0.001", 0)):
            self.assertEqual(run(*jitter, device, input=text).returncode, status)
        # A stamp that goes back is refused, and the step counts from the last good one.
        for times, told in (([0, 1e-3, 2e-4, 3e-3], "1 sample is invalid"),
                            ([0, 1e-3, 1e-3 + 1e-10, 2e-3], "the gains need b = 0.9 N s/m"),
                            ([0, 2, 4, 4.001], "--check-gains: 2 steps of more than 1 s are not checked")):
            trace = self.trace((time, 0, 0, -0.001, 0) for time in times)
            self.assertIn(told, self.succeed("replay", "--trace", trace, *FINGER, "--damping", "0.4", "--check-gains",
                                             "b=1.41").stderr)


class Scenes(CommandLineTest):
    SPACE = ",pz,fz,nx,ny,nz"
    DETAILS = ",margin,hold_load,corx,cory,corz,dissipated"

    def test_the_plane_is_as_ever(self):
        call = ["replay", "--trace", self.file("trace.csv", TRACE), *FINGER]
        plain = run(*call).stdout
        self.assertEqual(plain.split("\n", 1)[0], COLUMNS)
        for options in [["--surface", "plane"], ["--body", "fixed"], ["--fingers", "1"], ["--damping", "0"],
                        ["--max-speed", "inf"], ["--fault-decay", "1"]]:
            self.assertEqual(run(*call, *options).stdout, plain, options)
        details = run(*call, "--details").stdout
        self.assertEqual(details.split("\n", 1)[0], COLUMNS + self.DETAILS)
        for more, less in zip(details.splitlines(), plain.splitlines(), strict=True):
            self.assertTrue(more.startswith(less), more)

    def test_other_surfaces(self):
        for surface, top in [("capsule:radius=0.01,length=0.04", 0.03), ("cylinder:radius=0.05,length=0.1", 0.05),
                             ("box:z=0.02,y=0.1,x=0.1", 0.01), ("sphere:radius=0.05", 0.05)]:
            trace = f"time,x,y,z,twist\n0,0,0,{top + 0.001},0\n1,0,0,{top - 0.001},0\n2,0.0001,0,{top - 0.001},0.5\n"
            last = rows("replay", "--trace", self.file("trace.csv", trace), *FINGER, "--surface", surface)[-1]
            self.assertAlmostEqual(last["load"], 1, delta=3e-3, msg=surface)
            self.assertAlmostEqual(last["pz"], top, delta=2e-6, msg=surface)
            self.assertEqual(",".join(last), COLUMNS + self.SPACE)

    def test_a_free_block_is_carried(self):
        options = [
            "--surface", "box:x=0.12,y=0.04,z=0.04", "--fingers", "2", "--body", "free:mass=0.1", "--damping", "2",
            "--details"
        ]
        call = ["replay", "--trace", DATA / "scenes" / "pinch.csv", *FINGER, *options]
        self.assertEqual(header(*call).split(",")[-7:], ["bx", "by", "bz", "bqw", "bqx", "bqy", "bqz"])
        last = rows(*call)[-1]
        self.assertAlmostEqual(last["bx"], 0.03, delta=1e-5)
        self.assertAlmostEqual(last["bz"], -0.1 * 9.81 / 2000, delta=1e-5)
        # tan of half its angle, as the fingers turned.
        self.assertAlmostEqual(last["bqz"] / last["bqw"], 0.2, delta=2e-3)
        self.assertEqual((last["state"], last["state2"]), ("stick", "stick"))
        self.assertAlmostEqual(last["load"] + last["load2"], 6, delta=1e-6)
        self.assertAlmostEqual(last["nz2"], -1, delta=1e-6)
        without_gravity = rows(*call[:-4], "free:mass=0.1,inertia=1e-4,gravity=0", "--damping", "2", "--details")[-1]
        self.assertAlmostEqual(without_gravity["bz"], 0, delta=1e-8)


if __name__ == "__main__":
    unittest.main()
