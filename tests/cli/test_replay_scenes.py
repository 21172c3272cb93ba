# SPDX-License-Identifier: MIT
"""replay with other surfaces, moved or pushed bodies, and several fingers."""

import unittest

from command_line import DATA, CommandLineTest, header, rows, run
from recorded_finger import COLUMNS, FINGER, TRACE


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
        for options in [["--surface", "plane"], ["--body", "fixed"], ["--fingers", "1"], ["--damping", "0"],
                        ["--max-speed", "inf"], ["--fault-decay", "1"]]:
            self.assertEqual(run("replay", "--trace", path, *FINGER, *options).stdout, plain, options)
        self.assertEqual(header("replay", "--trace", path, *FINGER, "--details"), COLUMNS + self.DETAILS)
        for more, less in zip(self.replay_of(path, "--details"), self.replay_of(path)):
            self.assertEqual({name: repr(more[name]) for name in less}, {name: repr(less[name]) for name in less})

    def replay_of(self, path, *options):
        return rows("replay", "--trace", path, *FINGER, *options)

    def test_other_surfaces(self):
        for surface, top in [("capsule:radius=0.01,length=0.04", 0.03), ("cylinder:radius=0.05,length=0.1", 0.05),
                             ("box:x=0.1,y=0.1,z=0.02", 0.01), ("box:z=0.02,y=0.1,x=0.1", 0.01),
                             ("sphere:radius=0.05", 0.05)]:
            trace = f"time,x,y,z,twist\n0,0,0,{top + 0.001},0\n1,0,0,{top - 0.001},0\n2,0.0001,0,{top - 0.001},0.5\n"
            last = rows("replay", "--trace", self.file("trace.csv", trace), *FINGER, "--surface", surface)[-1]
            self.assertAlmostEqual(last["load"], 1, delta=3e-3, msg=surface)
            self.assertAlmostEqual(last["pz"], top, delta=2e-6, msg=surface)
            self.assertAlmostEqual(last["nz"], 1, delta=1e-4, msg=surface)
            self.assertLess(last["moment"], -1e-3, surface)
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

    def test_what_is_wrong_is_told_by_place(self):
        path = self.file("trace.csv", TRACE)
        for surface, told in [("ball", "'ball', expected plane"), ("sphere", "expected radius=NUMBER"),
                              ("sphere:radius=0", "'radius'"), ("sphere:radius=1,radius=2", "twice"),
                              ("box:x=1,y=1", "z=NUMBER"), ("box:x=1,y=1,z=nan", "'z'"),
                              ("capsule:radius=1,length=-1", "'length'"), ("cylinder:radius=1e9,length=1", "radius"),
                              ("plane:z=0", "expected plane"), ("", "expected"),
                              ("mesh:a.obj", "give it to a SoftFinger as a Contact")]:
            self.assert_fails(2, ["--surface", told], "replay", "--trace", path, *FINGER, "--surface", surface)
        for body, told in [("loose", "expected fixed"), ("free", "mass"), ("free:mass=0", "'mass'"),
                           ("free:mass=1", "inertia"), ("planar:mass=1,inertia=1,gravity=1", "gravity"),
                           ("free:mass=1,inertia=-1", "'inertia'")]:
            self.assert_fails(2, ["--body", told], "replay", "--trace", path, *FINGER, "--body", body)
        self.assert_fails(2, ["trace.csv:1:1:", "'bx'"], "replay", "--trace", path, *FINGER, "--body", "trace")
        self.assert_fails(2, ["trace.csv:1:1:", "'x2'"], "replay", "--trace", path, *FINGER, "--fingers", "2")
        for fingers in ["0", "17", "1.5", "x"]:
            self.assert_fails(2, ["--fingers", "from 1 to 16"], "replay", "--trace", path, *FINGER, "--fingers",
                              fingers)
        two = self.file("two.csv", "time,x,y,z,twist,x2,y2,z2\n0,0,0,0,0,0,0,0\n")
        self.assertIn("no column 'twist2'", run("replay", "--trace", two, *FINGER, "--fingers", "2").stderr)
        half = self.file("half.csv", "time,x,y,z,twist,x2,y2,z2,qy2\n0,0,0,0,0,0,0,0,0\n")
        self.assert_fails(2, ["half.csv:1:1:", "'twist2'", "qw2,qx2,qy2,qz2"], "replay", "--trace", half, *FINGER,
                          "--fingers", "2")
        body = self.file("body.csv", "time,x,y,z,twist,bx,by,bz,bqw\n0,0,0,0,0,0,0,0,1\n")
        self.assert_fails(2, ["body.csv:1:1:", "bqw,bqx,bqy,bqz"], "replay", "--trace", body, *FINGER, "--body",
                          "trace")
        body = self.file("body.csv", "time,x,y,z,twist,bx,by,bz,bqw,bqx,bqy,bqz\n0,0,0,0,0,0,0,0,1,0,0,1\n")
        self.assert_fails(2, ["body.csv:2:17:", "length 1.41"], "replay", "--trace", body, *FINGER, "--body", "trace")
        gap = self.file("gap.csv", "time,x,y,z,twist\n0,0,0,0,0\n3,0,0,0,0\n")
        self.assert_fails(2, ["gap.csv:3:1:", "gap of 3 s", "expected at most 1 s"], "replay", "--trace", gap, *FINGER,
                          "--surface", "sphere:radius=1", "--body", "free:mass=1")

    def test_a_size_that_is_none_in_metres(self):
        done = run("replay", "--trace", self.file("trace.csv", TRACE), *FINGER, "--surface", "sphere:radius=25")
        self.assertIn("50 m across: is it in metres?", done.stderr)


if __name__ == "__main__":
    unittest.main()
