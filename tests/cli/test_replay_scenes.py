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
        for options in [["--surface", "plane"], ["--body", "fixed"], ["--fingers", "1"], ["--damping", "0"], ["--max-displacement", "inf"], ["--fault-decay", "1"]]:
            self.assertEqual(run("replay", "--trace", path, *FINGER, *options).stdout, plain, options)
        self.assertEqual(header("replay", "--trace", path, *FINGER, "--details"), COLUMNS + self.DETAILS)
        for more, less in zip(self.replay_of(path, "--details"), self.replay_of(path)):
            self.assertEqual({name: repr(more[name]) for name in less}, {name: repr(less[name]) for name in less})

    def replay_of(self, path, *options):
        return rows("replay", "--trace", path, *FINGER, *options)

    def test_turned_faces_are_said(self):
        corners = "".join(f"v {x} {y} {z}\n" for x in (-1, 1) for y in (-1, 1) for z in (-1, 1))
        squares = ["1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"]
        outward = "".join(f"f {square}\n" for square in squares)
        room = "".join(f"f {' '.join(reversed(square.split()))}\n" for square in squares)
        for faces, turned in ((outward, 0), (room, 12), (outward.replace("1 2 4 3", "3 4 2 1"), 2)):
            path = self.file("cube.obj", corners + faces)
            done = run("replay", "--trace", self.file("trace.csv", TRACE), *FINGER, "--surface", f"mesh:{path}")
            self.assertEqual(done.returncode, 0, done.stderr)
            note = f"limitcurve: note: {path}: {turned} of 12 faces looked inward and were turned outward; the surface bounds a solid, not a room"
            self.assertEqual([line for line in done.stderr.splitlines() if "faces" in line], [note] if turned else [])

    def test_slivers_are_said(self):
        corners = "".join(f"v {x} {y} {z}\n" for x in (-1, 1) for y in (-1, 1) for z in (-1, 1))
        faces = "".join(f"f {face}\n" for face in ["9 2 4 3 1", "1 2 9", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"])
        path = self.file("cap.obj", corners + "v -1 -1.0000001 0\n" + faces)
        done = run("replay", "--trace", self.file("trace.csv", TRACE), *FINGER, "--surface", f"mesh:{path}")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"limitcurve: note: {path}: slivers taken out, none higher than two spacings of a float: 1\n", done.stderr)

    def test_other_surfaces(self):
        for surface, top in [("capsule:radius=0.01,length=0.04", 0.03), ("cylinder:radius=0.05,length=0.1", 0.05),
                             ("box:x=0.1,y=0.1,z=0.02", 0.01), ("box:z=0.02,y=0.1,x=0.1", 0.01), ("sphere:radius=0.05", 0.05)]:
            trace = f"time,x,y,z,twist\n0,0,0,{top + 0.001},0\n1,0,0,{top - 0.001},0\n2,0.0001,0,{top - 0.001},0.5\n"
            last = rows("replay", "--trace", self.file("trace.csv", trace), *FINGER, "--surface", surface)[-1]
            self.assertAlmostEqual(last["load"], 1, delta=3e-3, msg=surface)
            self.assertAlmostEqual(last["pz"], top, delta=2e-6, msg=surface)
            self.assertAlmostEqual(last["nz"], 1, delta=1e-4, msg=surface)
            self.assertLess(last["moment"], -1e-3, surface)
            self.assertEqual(",".join(last), COLUMNS + self.SPACE)

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
        self.assertIn("no column 'twist2'", run("replay", "--trace", two, *FINGER, "--fingers", "2").stderr)
        half = self.file("half.csv", "time,x,y,z,twist,x2,y2,z2,qy2\n0,0,0,0,0,0,0,0,0\n")
        self.assert_fails(2, ["half.csv:1:1:", "'twist2'", "qw2,qx2,qy2,qz2"], "replay", "--trace", half, *FINGER, "--fingers", "2")
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
        # An 80 mm cube in mm was an 80 m cube, and nothing was said.
        self.assertIn("120 m across: is it in metres?", run(*call, f"mesh:{scaled}").stderr)
        self.assertIn("is it in metres?", run(*call, "sphere:radius=25").stderr)
        self.assertNotIn("metres", run(*call, f"mesh:{scaled},scale=0.001").stderr)
        # Two blocks that overlap: refused with the way on, and the second alone is the block.
        corners = [[float(word) for word in line.split()[1:]] for line in lines if line.startswith("v ")]
        faces = [[int(word) for word in line.split()[1:]] for line in lines if line.startswith("f ")]
        both = self.file("both.obj", "".join(
            f"{kind} {' '.join(map(str, row))}\n" for kind, part in [("v", [[x + 0.01 for x in row] for row in corners]), ("f", faces),
                                                                     ("v", corners), ("f", [[i + 8 for i in row] for row in faces])] for row in part))
        self.assert_fails(2, ["--surface", "overlap: unite them", "body=2 of 2"], *call, f"mesh:{both}")
        self.assert_fails(2, ["--surface", "body = 3", "expected 1 to 2"], *call, f"mesh:{both},body=3")
        self.assert_fails(2, ["--surface", "'body'", "a whole number from 1"], *call, f"mesh:{both},body=1.5")
        for mesh in [f"mesh:{DATA}/meshes/block.obj", f"mesh:{scaled},scale=0.001", f"mesh:{both},body=2,scale=1"]:
            found = self.scene("pinch.csv", "--surface", mesh, *scene)
            for one, other in zip(box, found):
                self.assertEqual(one["state"], other["state"])
                for name in ["px", "py", "pz", "fx", "fy", "fz", "load", "nz", "bx", "by", "bz", "bqz", "load2"]:
                    self.assertAlmostEqual(one[name], other[name], delta=1e-8, msg=name)


if __name__ == "__main__":
    unittest.main()
