# SPDX-License-Identifier: MIT
"""replay with other surfaces, moved or pushed bodies, and several fingers."""

import unittest

from command_line import DATA, CommandLineTest, header, rows, run
from recorded_finger import COLUMNS, FINGER, TRACE


class Scenes(CommandLineTest):
    """Surfaces other than the plane, bodies that are moved or pushed, and several fingers."""

    SPACE = ",pz,fz,nx,ny,nz"
    DETAILS = ",margin,hold_load,corx,cory,corz,dissipated"

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
