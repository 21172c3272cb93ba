# SPDX-License-Identifier: MIT
"""replay: settles where physics says, refuses a spoilt trace by place, reads any order of columns, streams."""

import math
import os
import subprocess
import unittest

from command_line import DATA, EXECUTABLE, CommandLineTest, header, numbers, rows, run

COLUMNS = "time,state,px,py,angle,depth,load,fx,fy,moment,cor"
STIFFNESS = 1000.0
M0 = 3 * math.pi / 16  # Hertz
FINGER = ["--law", "hertz", "--radius-law", "constant:a=0.006", "--mu", "0.6", "--stiffness", "1000", "--twist-stiffness", "0.036"]
TRACE = "time,x,y,z,twist\n0,0,0,0.001,0\n0.001,0,0,-0.001,0\n0.002,0.0001,0,-0.001,0\n0.003,0.005,0,-0.001,0\n"


class Replays(CommandLineTest):
    def replay(self, text, *options):
        return rows("replay", "--trace", self.file("trace.csv", text), *FINGER, *options)

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

    def test_every_trace_of_the_repository_on_every_boundary_and_projection(self):
        for trace in sorted((DATA / "traces").glob("*.csv")):
            for boundary in ["exact", "table", "ellipse", "superellipse", "quartic", "box"]:
                for projection in ["radial", "c-curve", "closest-point"]:
                    found = rows("replay", "--trace", trace, *FINGER, "--boundary", boundary, "--projection", projection)
                    states = {row["state"] for row in found}
                    self.assertEqual(states, {"free", "stick", "slip"}, f"{trace.name} {boundary} {projection}")
                    for row in found:
                        self.assertLessEqual(math.hypot(row["fx"], row["fy"]), 0.6 * row["load"] * (1 + 1e-12))
                        self.assertLessEqual(abs(row["moment"]), 0.6 * 0.006 * M0 * row["load"] * (1 + 1e-9))

    def test_the_paper_s_uncoupled_algorithm_clamps_each_on_its_own(self):
        last = rows("replay", "--trace", DATA / "traces" / "constant_twist.csv", *FINGER, "--boundary", "box", "--projection",
                    "closest-point")[-1]
        self.assertAlmostEqual(last["fx"], -1.2, delta=1e-9)
        self.assertAlmostEqual(last["moment"], -1.2 * 0.006 * M0, delta=1e-12)

    def test_coefficients(self):
        twist = "time,x,y,z,twist\n0,0,0,-0.001,0\n1,0,0,-0.001,3\n2,0,0,-0.001,6\n"
        self.assertAlmostEqual(self.replay(twist)[-1]["moment"], -0.6 * 0.006 * M0, delta=1e-12)
        self.assertAlmostEqual(self.replay(twist, "--moment-coefficient", "0.004")[-1]["moment"], -0.004, delta=1e-12)
        self.assertAlmostEqual(self.replay(TRACE, "--mu-dynamic", "0.3")[-1]["fx"], -0.3, delta=1e-9)
        without_radius = [word for word in FINGER if word not in ("--radius-law", "constant:a=0.006")]
        path = self.directory / "trace.csv"
        self.assertEqual(run("replay", "--trace", path, *without_radius, "--moment-coefficient", "0.004").returncode, 0)
        self.assert_fails(2, ["--radius-law", "--moment-coefficient"], "replay", "--trace", path, *without_radius)

    def test_an_orientation_in_place_of_the_twist(self):
        samples = [(i / 1000, 1e-5 * i, -0.001, 0.02 * i) for i in range(700)]  # more than two turns
        plain = "time,x,y,z,twist\n" + "".join(f"{t},{x!r},0,{z},{twist!r}\n" for t, x, z, twist in samples)
        turned = "time,x,y,z,qw,qx,qy,qz\n" + "".join(
            f"{t},{x!r},0,{z},{math.cos(twist / 2)!r},0,0,{math.sin(twist / 2)!r}\n" for t, x, z, twist in samples)
        for one, other in zip(self.replay(plain), self.replay(turned)):
            self.assertEqual(one["state"], other["state"])
            for name in ["px", "angle", "fx", "moment"]:
                self.assertAlmostEqual(one[name], other[name], delta=1e-11)
        # A tilted finger: its twist about the normal is what counts.
        half = math.sqrt(0.5)
        tilted = "time,x,y,z,qw,qx,qy,qz\n0,0,0,-0.001,1,0,0,0\n1,0,0,-0.001,%r,%r,0,0\n" % (half, half)
        self.assertEqual(self.replay(tilted)[-1]["angle"], 0)
        long = self.file("bad.csv", "time,x,y,z,qw,qx,qy,qz\n0,0,0,-0.001,1,1,0,0\n")
        self.assert_fails(2, ["bad.csv:2:14", "expected 1"], "replay", "--trace", long, *FINGER)
        part = self.file("bad.csv", "time,x,y,z,qw,qx,qy\n0,0,0,-0.001,1,0,0\n")
        self.assert_fails(2, ["bad.csv:1:1", "'twist'", "qw,qx,qy,qz"], "replay", "--trace", part, *FINGER)

    def test_a_time_that_goes_back_is_an_invalid_row(self):
        found = self.replay(TRACE + "0.001,0.007,0,-0.001,0\n0.005,0.0051,0,-0.001,0\n")
        self.assertEqual(found[4]["state"], "invalid")
        self.assertEqual(found[4]["fx"], found[3]["fx"])
        self.assertEqual(found[5]["state"], "slip")

    def test_a_leap_is_refused_once_and_believed_if_it_stays(self):
        away = TRACE + "0.004,0.3,0,-0.001,0\n"
        back = away + "0.005,0.0051,0,-0.001,0\n0.006,0.0052,0,-0.001,0\n"
        self.assertEqual([row["state"] for row in self.replay(back)], ["free", "stick", "stick", "slip", "slip", "slip", "stick"])
        for options in [[], ["--details"], ["--surface", "box:x=10,y=10,z=2e-12"]]:
            held = self.replay(back, "--jump-limit", "0.01", *options)
            self.assertEqual([held[i]["state"] for i in (3, 4, 6)], ["slip", "invalid", "slip"], options)
            for name in ["px", "load", "fx", "moment"]:
                self.assertEqual(held[4][name], held[3][name])
            faded = self.replay(back, "--jump-limit", "0.01", "--hold-share", "0.25", *options)
            for name in ["load", "fx"]:
                self.assertEqual(faded[4][name], 0.25 * held[3][name])
            self.assertEqual(faded[4]["px"], held[3]["px"])
            self.assertEqual(str(faded[6]), str(held[6]))
            self.assertAlmostEqual(held[6]["fx"], -0.6, delta=1e-9)
        stays = self.replay(away + "0.005,0.3,0,-0.001,0\n", "--jump-limit", "0.01")
        self.assertEqual([row["state"] for row in stays[4:]], ["invalid", "slip"])
        self.assertAlmostEqual(stays[5]["px"], 0.3 - 0.0006, delta=1e-9)
        # A time that goes back is no leap, and fades all the same.
        faded = self.replay(TRACE + "0.001,0.007,0,-0.001,0\n", "--hold-share", "0")
        self.assertEqual((faded[4]["state"], faded[4]["load"], faded[4]["fx"]), ("invalid", 0, 0))


class SteadyTwist(CommandLineTest):
    """A finger that moves at a constant twist with COR c for long ends at eq. (17)'s wrench, if projected rightly."""

    def settled(self, cor, ratio, *options, radius=0.005, load=2.0, mu=0.5):
        """Unit wrench at the end of a trace that turns about `cor` [m]; ratio = k_r/k_l/(m0 a)^2."""
        give = mu * load / STIFFNESS
        step = 0.5 * give if cor > 0 else 0.0
        lines = ["time,x,y,z,twist", "0,0,0,0.001,0"]
        for i in range(600):
            twist = i * (step / cor) if cor < math.inf else 0.0
            lines.append(f"{(i + 1) / 1000!r},{i * step!r},0,{-load / STIFFNESS!r},{twist!r}")
        trace = self.file("trace.csv", "\n".join(lines) + "\n")
        twist_stiffness = ratio * STIFFNESS * (M0 * radius) ** 2
        last = rows("replay", "--trace", trace, "--law", "hertz", "--radius-law", f"constant:a={radius}", "--mu", mu, "--stiffness",
                    STIFFNESS, "--twist-stiffness", repr(twist_stiffness), *options)[-1]
        self.assertEqual(last["state"], "slip")
        return math.hypot(last["fx"], last["fy"]) / (mu * load), abs(last["moment"]) / (mu * load * radius)

    def error(self, found, cor, radius=0.005):
        exact = rows("eval", "--law", "hertz", "--c", numbers([cor / radius]))[0]
        return math.hypot(found[0] - exact["force"], (found[1] - exact["moment"]) / M0)

    def test_closest_point_settles_at_the_exact_wrench(self):
        for ratio in [0.1, 0.3, 1, 2, 10]:
            for cor in [0.002, 0.005, 0.02]:
                found = self.settled(cor, ratio, "--boundary", "table", "--tolerance", "1e-8", "--projection", "closest-point")
                self.assertLess(self.error(found, cor), 1e-6, f"ratio {ratio}, c {cor}")

    def test_radial_settles_where_the_stiffness_says(self):
        for ratio, expected in [(0.1, 0.34), (1, 0.125), (2, 0.44), (10, 0.94)]:
            found = self.settled(0.005, ratio, "--boundary", "table", "--tolerance", "1e-8", "--projection", "radial")
            self.assertAlmostEqual(self.error(found, 0.005), expected, delta=0.005)
            # F/M = (k_l/k_r) c, whatever the curve.
            self.assert_close(found[0] / found[1], 1 / (ratio * M0**2), 1e-6)

    def test_radial_on_the_ellipse(self):
        for ratio, expected in [(1, 0.134), (2, 0.45)]:
            found = self.settled(0.005, ratio, "--boundary", "ellipse", "--projection", "radial")
            self.assertAlmostEqual(self.error(found, 0.005), expected, delta=0.005)

    def test_the_repository_s_own_trace(self):
        last = rows("replay", "--trace", DATA / "traces" / "constant_twist.csv", *FINGER, "--boundary", "table", "--tolerance", "1e-8",
                    "--projection", "closest-point")[-1]
        exact = rows("eval", "--law", "hertz", "--c", "0.005", "--radius", "0.006", "--mu", "0.6", "--load", repr(last["load"]))[0]
        self.assert_close(math.hypot(last["fx"], last["fy"]), exact["force"], 1e-6)
        self.assert_close(abs(last["moment"]), exact["moment"], 1e-6)
        self.assert_close(last["cor"], 0.005, 1e-6)


class Scenes(CommandLineTest):
    """Surfaces other than the plane, bodies that are moved or pushed, and several fingers."""

    SPACE = ",pz,fz,nx,ny,nz"
    DETAILS = ",margin,hold_load,corx,cory,corz,dissipated"

    def scene(self, name, *options):
        return rows("replay", "--trace", DATA / "scenes" / name, *FINGER, *options)

    def test_the_plane_is_as_ever(self):
        path = self.file("trace.csv", TRACE)
        plain = run("replay", "--trace", path, *FINGER).stdout
        self.assertEqual(plain.split("\n", 1)[0], COLUMNS)
        for options in [["--surface", "plane"], ["--body", "fixed"], ["--fingers", "1"], ["--damping", "0"], ["--jump-limit", "inf"], ["--hold-share", "1"]]:
            self.assertEqual(run("replay", "--trace", path, *FINGER, *options).stdout, plain, options)
        self.assertEqual(header("replay", "--trace", path, *FINGER, "--details"), COLUMNS + self.DETAILS)
        for more, less in zip(self.replay_of(path, "--details"), self.replay_of(path)):
            self.assertEqual({name: repr(more[name]) for name in less}, {name: repr(less[name]) for name in less})

    def replay_of(self, path, *options):
        return rows("replay", "--trace", path, *FINGER, *options)

    def test_a_ball(self):
        found = self.scene("around_a_ball.csv", "--surface", "sphere:radius=0.05")
        self.assertEqual(header("replay", "--trace", DATA / "scenes" / "around_a_ball.csv", *FINGER, "--surface", "sphere:radius=0.05"),
                         COLUMNS + self.SPACE)
        self.assertEqual({row["state"] for row in found}, {"free", "stick", "slip"})
        for row in found:
            force = (row["fx"], row["fy"], row["fz"])
            normal = (row["nx"], row["ny"], row["nz"])
            self.assertLessEqual(abs(sum(f * n for f, n in zip(force, normal))), 1e-12)
            self.assertLessEqual(math.hypot(*force), 0.6 * row["load"] * (1 + 1e-12))
            if row["state"] == "slip":
                # The finger's axis stays upright on the ball: it hardly twists.
                self.assertLess(abs(row["moment"]), 1e-6)
                self.assertAlmostEqual(math.hypot(row["px"], row["py"], row["pz"]), 0.05, delta=2e-5)

    def test_other_surfaces(self):
        for surface, top in [("capsule:radius=0.01,length=0.04", 0.03), ("cylinder:radius=0.05,length=0.1", 0.05),
                             ("box:x=0.1,y=0.1,z=0.02", 0.01), ("box:z=0.02,y=0.1,x=0.1", 0.01), ("sphere:radius=0.05", 0.05)]:
            trace = f"time,x,y,z,twist\n0,0,0,{top + 0.001},0\n1,0,0,{top - 0.001},0\n2,0.0001,0,{top - 0.001},0.5\n"
            last = rows("replay", "--trace", self.file("trace.csv", trace), *FINGER, "--surface", surface)[-1]
            self.assertAlmostEqual(last["load"], 1, delta=3e-3, msg=surface)
            self.assertAlmostEqual(last["pz"], top, delta=2e-6, msg=surface)
            self.assertAlmostEqual(last["nz"], 1, delta=1e-4, msg=surface)
            self.assertLess(last["moment"], -1e-3, surface)

    def test_a_turntable_rubs_about_its_axis(self):
        # 20 N at 0.1 mm less give: the springs trail by a hundredth of the way to the axis, 5 mm.
        stiff = ["--law", "hertz", "--radius-law", "constant:a=0.006", "--mu", "0.03", "--stiffness", "10000", "--twist-stiffness", "0.36"]
        last = rows("replay", "--trace", DATA / "scenes" / "turntable.csv", *stiff, "--body", "trace", "--details")[-1]
        exact = rows("eval", "--law", "hertz", "--c", "0.005", "--radius", "0.006", "--mu", "0.03", "--load", repr(last["load"]))[0]
        self.assertEqual((last["state"], last["margin"]), ("slip", 0))
        self.assert_close(math.hypot(last["fx"], last["fy"]), exact["force"], 0.02)
        self.assert_close(last["moment"], exact["moment"], 0.03)
        self.assertLess(math.hypot(last["corx"], last["cory"]), 2e-4)
        self.assertGreater(last["dissipated"], 0)

    def test_a_free_block_is_carried(self):
        options = ["--surface", "box:x=0.12,y=0.04,z=0.04", "--fingers", "2", "--body", "free:mass=0.1", "--damping", "2", "--details"]
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

    def test_a_planar_body_is_pushed(self):
        # The finger presses on the plate's middle and moves off along y: the plate follows, and nowhere else.
        lines = ["time,x,y,z,twist"] + [f"{i / 1000},0,{2e-5 * max(i - 100, 0)},0.008,0" for i in range(1500)]
        last = rows("replay", "--trace", self.file("trace.csv", "\n".join(lines) + "\n"), *FINGER, "--surface", "box:x=0.1,y=0.06,z=0.02",
                    "--body", "planar:mass=0.2", "--damping", "5")[-1]
        self.assertEqual(last["state"], "stick")
        self.assertAlmostEqual(last["by"], 2e-5 * 1399, delta=1e-4)
        self.assertEqual((last["bx"], last["bz"], last["bqx"]), (0, 0, 0))

    def test_what_is_wrong_is_told_by_place(self):
        path = self.file("trace.csv", TRACE)
        for surface, told in [("ball", "'ball', expected plane"), ("sphere", "expected radius=NUMBER"), ("sphere:radius=0", "'radius'"),
                              ("sphere:radius=1,radius=2", "twice"), ("box:x=1,y=1", "z=NUMBER"), ("box:x=1,y=1,z=nan", "'z'"),
                              ("capsule:radius=1,length=-1", "'length'"), ("cylinder:radius=1e9,length=1", "radius"),
                              ("plane:z=0", "expected plane"), ("", "expected")]:
            self.assert_fails(2, ["--surface", told], "replay", "--trace", path, *FINGER, "--surface", surface)
        for body, told in [("loose", "expected fixed"), ("free", "mass"), ("free:mass=0", "'mass'"), ("free:mass=1", "inertia"),
                           ("planar:mass=1,inertia=1,gravity=1", "gravity"), ("free:mass=1,inertia=-1", "'inertia'")]:
            self.assert_fails(2, ["--body", told], "replay", "--trace", path, *FINGER, "--body", body)
        self.assert_fails(2, ["trace.csv:1:1:", "'bx'"], "replay", "--trace", path, *FINGER, "--body", "trace")
        self.assert_fails(2, ["trace.csv:1:1:", "'x2'"], "replay", "--trace", path, *FINGER, "--fingers", "2")
        for fingers in ["0", "17", "1.5", "x"]:
            self.assert_fails(2, ["--fingers", "from 1 to 16"], "replay", "--trace", path, *FINGER, "--fingers", fingers)
        two = self.file("two.csv", "time,x,y,z,twist,x2,y2,z2\n0,0,0,0,0,0,0,0\n")
        self.assert_fails(2, ["two.csv:1:1:", "'twist2'"], "replay", "--trace", two, *FINGER, "--fingers", "2")
        body = self.file("body.csv", "time,x,y,z,twist,bx,by,bz,bqw\n0,0,0,0,0,0,0,0,1\n")
        self.assert_fails(2, ["body.csv:1:1:", "bqw,bqx,bqy,bqz"], "replay", "--trace", body, *FINGER, "--body", "trace")
        body = self.file("body.csv", "time,x,y,z,twist,bx,by,bz,bqw,bqx,bqy,bqz\n0,0,0,0,0,0,0,0,1,0,0,1\n")
        self.assert_fails(2, ["body.csv:2:17:", "length 1.41"], "replay", "--trace", body, *FINGER, "--body", "trace")
        gap = self.file("gap.csv", "time,x,y,z,twist\n0,0,0,0,0\n3,0,0,0,0\n")
        self.assert_fails(2, ["gap.csv:3:1:", "gap of 3 s", "expected at most 1 s"], "replay", "--trace", gap, *FINGER, "--surface",
                          "sphere:radius=1", "--body", "free:mass=1")

    def test_a_mesh(self):
        path = self.file("trace.csv", TRACE)
        call = ["replay", "--trace", path, *FINGER, "--surface"]
        if "built without meshes" in run(*call, "mesh:x.obj").stderr:
            self.assert_fails(2, ["--surface", "mesh:x.obj"], *call, "mesh:x.obj")
            self.skipTest("built without meshes")
        self.assert_fails(2, ["--surface", "absent.obj"], *call, f"mesh:{self.directory}/absent.obj")
        self.assert_fails(2, ["--surface", "expected mesh:FILE"], *call, "mesh:")
        self.assert_fails(2, ["--surface", "'x'"], *call, f"mesh:{DATA}/meshes/block.obj,scale=x")
        torn = self.file("torn.obj", "v 0 0 0\nv 1 0\n")
        self.assert_fails(2, ["--surface", "torn.obj:2:"], *call, f"mesh:{torn}")
        # A block is a block, whether given by its edges or its corners, in metres or millimetres.
        scene = ["--fingers", "2", "--damping", "2", "--body", "free:mass=0.1,inertia=1e-4"]
        box = self.scene("pinch.csv", "--surface", "box:x=0.12,y=0.04,z=0.04", *scene)
        lines = (DATA / "meshes" / "block.obj").read_text().splitlines()
        millimetres = [" ".join(["v", *(repr(float(word) * 1000) for word in line.split()[1:])]) if line.startswith("v ") else line for line in lines]
        scaled = self.file("block.obj", "\n".join(millimetres) + "\n")
        for mesh in [f"mesh:{DATA}/meshes/block.obj", f"mesh:{scaled},scale=0.001"]:
            found = self.scene("pinch.csv", "--surface", mesh, *scene)
            for one, other in zip(box, found):
                self.assertEqual(one["state"], other["state"])
                for name in ["px", "py", "pz", "fx", "fy", "fz", "load", "nz", "bx", "by", "bz", "bqz", "load2"]:
                    self.assertAlmostEqual(one[name], other[name], delta=1e-8, msg=name)


class Files(CommandLineTest):
    def replayed(self, text, name="trace.csv"):
        path = self.directory / name
        path.write_bytes(text.encode())
        return run("replay", "--trace", path, *FINGER)

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

    def test_standard_input(self):
        piped = run("replay", "--trace", "-", *FINGER, input=TRACE)
        self.assertEqual(piped.stdout, self.replayed(TRACE).stdout)

    def test_what_is_wrong_is_told_by_place(self):
        cases = [
            ("", "bad.csv:1:1:", "empty"),
            ("# nothing\n", "bad.csv:1:1:", "empty"),
            ("time,x,y,z,twist\n", "bad.csv:2:1:", "no rows"),
            ("time,x,y,twist\n0,0,0,0\n", "bad.csv:1:1:", "'z'"),
            ("0,0,0,0,0\n", "bad.csv:1:1:", "'time'"),
            ("time,x,y,z\n0,0,0,0\n", "bad.csv:1:1:", "'twist'"),
            ("time,x,y,z,twist,x\n0,0,0,0,0,0\n", "bad.csv:1:18:", "'x' twice"),
            (TRACE + "0.004,0.01,0,-0.0", "bad.csv:6:18:", "4 fields"),
            (TRACE + "0.004", "bad.csv:6:6:", "1 field,"),
            (TRACE + "0.004,0,0,0,0,0\n", "bad.csv:6:16:", "6 fields"),
            (TRACE + "0.004,nan,0,0,0\n", "bad.csv:6:7:", "'nan'"),
            (TRACE + "0.004,0,inf,0,0\n", "bad.csv:6:9:", "'inf'"),
            (TRACE + "0.004,0,,0,0\n", "bad.csv:6:9:", "''"),
            (TRACE + "0.004,0,0,0.1.2,0\n", "bad.csv:6:11:", "'0.1.2'"),
            (TRACE + "0.004,0,0,0x1,0\n", "bad.csv:6:11:", "'0x1'"),
            (TRACE.replace("0.002", '"0.002'), "bad.csv:4:1:", "quote"),
            ("\0\1\2\3", "bad.csv:1:1:", "'time'"),
        ]
        for text, place, what in cases:
            self.replayed(text, "bad.csv")
            self.assert_fails(2, [place, what, "expected"] if what != "quote" else [place, what], "replay", "--trace",
                              self.directory / "bad.csv", *FINGER)

    def test_files_that_are_none(self):
        self.assert_fails(2, ["absent.csv", "No such file"], "replay", "--trace", self.directory / "absent.csv", *FINGER)
        self.assert_fails(2, "directory", "replay", "--trace", self.directory, *FINGER)
        endless = self.directory / "endless.csv"
        endless.write_bytes(b"x" * 3_000_000)
        self.assert_fails(2, ["endless.csv:1:", "million"], "replay", "--trace", endless, *FINGER)

    def test_options_out_of_range(self):
        path = self.file("trace.csv", TRACE)
        for option in ["--mu", "--stiffness", "--twist-stiffness", "--mu-dynamic", "--moment-coefficient", "--tolerance"]:
            call = ["replay", "--trace", path, *FINGER]
            if option in call:
                del call[call.index(option):call.index(option) + 2]
            for value in ["-1", "nan", "inf", "x"]:
                self.assert_fails(2, [option, "expected"], *call, option, value)
        for option in ["--stiffness", "--twist-stiffness", "--mu", "--law"]:
            call = list(FINGER)
            del call[call.index(option):call.index(option) + 2]
            self.assert_fails(2, option, "replay", "--trace", path, *call)
        for option, values, told in [("--jump-limit", ["0", "-0.01", "nan", "x", ""], "expected a number > 0, or inf"),
                                     ("--hold-share", ["-0.1", "1.1", "nan", "inf", "x"], "expected a number from 0 to 1")]:
            for value in values:
                self.assert_fails(2, [option, told], "replay", "--trace", path, *FINGER, option, value)
        self.assert_fails(2, ["--boundary", "triangle", "ellipse"], "replay", "--trace", path, *FINGER, "--boundary", "triangle")
        self.assert_fails(2, ["--projection", "c-curve"], "replay", "--trace", path, *FINGER, "--projection", "oblique")
        self.assert_fails(2, ["mu_dynamic"], "replay", "--trace", path, *FINGER, "--mu-dynamic", "0.7")
        self.assert_fails(2, ["tolerance"], "replay", "--trace", path, *FINGER, "--tolerance", "0")

    def test_gains_that_are_not_passive_are_refused(self):
        call = ["replay", "--trace", self.file("trace.csv", TRACE), *FINGER]
        plain = run(*call).stdout
        # 1000 N/m at 1 ms need 0.5 N s/m, and 0.036 N m/rad need 1.8e-5 N m s/rad.
        for device in ["b=0.51", "b=0.51,b_r=1.9e-5", "b=0.051,T=1e-4"]:
            self.assertEqual(run(*call, "--check-gains", device).stdout, plain, device)
        self.assert_fails(2, ["not passive", "0.5 N s/m", "got 0.49"], *call, "--check-gains", "b=0.49")
        self.assert_fails(2, ["not passive", "twist"], *call, "--check-gains", "b=1,b_r=1.7e-5")
        self.assert_fails(2, ["not passive", "0.9 N s/m"], *call, "--check-gains", "b=0.8", "--damping", "0.4")
        self.assert_fails(2, ["--check-gains", "expected b=NUMBER"], *call, "--check-gains", "0.5")
        self.assert_fails(2, ["--check-gains", "'T'"], *call, "--check-gains", "b=0.5,T=0")

    def test_a_long_trace_is_streamed(self):
        def peak(samples):
            path = self.directory / "long.csv"
            with open(path, "w", encoding="ascii") as file:
                file.write("time,x,y,z,twist\n")
                for i in range(samples):
                    file.write(f"{i / 1000},{1e-6 * i},0,-0.0012345678901234,{1e-5 * i}\n")
            # In a build with the address sanitizer, freed memory is not to be kept.
            environment = {**os.environ, "ASAN_OPTIONS": "quarantine_size_mb=1:thread_local_quarantine_size_kb=64"}
            with open(os.devnull, "wb") as sink, subprocess.Popen([EXECUTABLE, "replay", "--trace", path, *FINGER], stdout=sink,
                                                                  env=environment) as process:
                _, status, usage = os.wait4(process.pid, 0)
                process.returncode = os.waitstatus_to_exitcode(status)
            self.assertEqual(process.returncode, 0)
            return usage.ru_maxrss  # KiB

        # Of a file of some 20 MB.
        self.assertLess(peak(400_000), peak(100) + 8192)


if __name__ == "__main__":
    unittest.main()
