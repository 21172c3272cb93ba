# SPDX-License-Identifier: MIT
"""Contacts that are not round: `fit friction`, `validate`, `choose` and `replay` with --patch."""

import csv
import math
import unittest

from command_line import DATA, header, rows, run
from patch_case import PatchCase, by_points


class FitFriction(PatchCase):
    def fit(self, patch, data, *options):
        return {row["parameter"]: row for row in rows("fit", "friction", "--patch", patch, "--data", data, *options)}

    def test_measured_pushes_are_explained_by_the_points_and_not_by_the_ellipsoid(self):
        found = self.fit(f"points:{DATA}/measured/tripod_hardboard_a_points.csv",
                         DATA / "measured" / "tripod_hardboard_a.csv")
        for parameter, (value, error) in (("mu", (4.467, 0.045)), ("drift", (-0.034, 0.046)),
                                          ("drift_ellipsoid", (-0.361, 0.064))):
            self.assertAlmostEqual(found[parameter]["value"], value, delta=6e-4)
            self.assertAlmostEqual(found[parameter]["std_error"], error, delta=6e-4)
        self.assertEqual(found["mu"]["unit"], "N")

    def pushes(self, moved, mu=0.4, load=10.0):
        """Pushes of a two-point patch away from its origin, whose wrench is exact."""
        points = [(0.1, 0.2, 1.0), (0.4, 0.3, 3.0)]
        lines = ["dx,dy,dtheta,force_x,force_y,moment"]
        for twist in moved:
            fx, fy, moment, _ = by_points(points, twist)
            lines.append(",".join(repr(value) for value in (*twist, *(mu * load * one for one in (fx, fy, moment)))))
        patch = self.file("two.csv", "x,y,load\n" + "".join(f"{x},{y},{w}\n" for x, y, w in points))
        return f"points:{patch}", self.file("pushes.csv", "\n".join(lines) + "\n")

    MOVED = [(0.01, 0.0, 0.1), (0.0, 0.01, -0.05), (0.001, 0.002, 0.3), (0.02, -0.01, 0.0), (0.0, 0.0, 0.2)]

    def changed(self, data, change, name="changed"):
        """The pushes with each row changed: a dict of columns."""
        header, *lines = data.read_text().splitlines()
        names = header.split(",")
        rows = [change(i, dict(zip(names, map(float, line.split(","))))) for i, line in enumerate(lines)]
        return self.file(f"{name}.csv",
                         "\n".join([header, *(",".join(repr(row[name]) for name in names) for row in rows)]) + "\n")

    @staticmethod
    def reacting(row):
        return {name: value if name.startswith("d") else -value for name, value in row.items()}

    def test_reactions_are_refused_and_single_pushes_against_the_motion_left_out(self):
        patch, data = self.pushes(self.MOVED)
        for against in (range(5), range(1, 5)):
            done = run("fit", "friction", "--patch", patch, "--data",
                       self.changed(data, lambda i, row: self.reacting(row) if i in against else row))
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(f"push {against[0] + 2}: negative power, as in {len(against)} of 5 pushes", done.stderr)
            self.assertIn("reaction", done.stderr)
        done = run("fit", "friction", "--patch", patch, "--data",
                   self.changed(data, lambda i, row: self.reacting(row) if i == 2 else row))
        self.assertIn("push 4 (lines of the file): negative power, left out", done.stderr)
        self.assertTrue(done.stdout.splitlines()[1].startswith("mu,4"), done.stdout)

    def test_other_units_are_warned_of(self):
        patch, data = self.pushes(self.MOVED)
        def scaled(**factors):
            return self.changed(data, lambda _, row: {
                name: value * factors.get(name, 1)
                for name, value in row.items()
            }, "_".join(factors))

        for changed, part in ((scaled(dx=1000, dy=1000), "in metres?"), (scaled(dtheta=57.3), "in radians?"),
                              (scaled(moment=1000), "in N m"), (data, "")):
            done = run("fit", "friction", "--patch", patch, "--data", changed)
            self.assertIn(part, done.stderr)
            self.assertEqual("warning" in done.stderr, part != "", done.stderr)


class HowWrongIsRound(PatchCase):
    def test_columns(self):
        for call in (("validate", ), ("choose", "--tolerance", 0.1)):
            self.assertEqual(header(*call, "--patch", "rectangle:x=1,y=1"), header(*call, "--law", "hertz"))

    def test_a_friction_factor_of_all_directions_is_one_of_mu(self):
        disc = "ellipse:law=hertz,a=0.004,b=0.004,mx=2,my=2"
        self.assertIn("a disc has 2 times mu", run("choose", "--patch", disc, "--tolerance", "0.1").stderr)

    def test_engines_with_two_coefficients_of_friction_get_both(self):
        patch = "rectangle:x=0.02,y=0.01,mx=2,my=0.5"
        spin = rows("patch", "--patch", patch, "--twists", self.twists((0, 0, 1)))[0]["moment"]
        done = run("translate", "--patch", patch, "--mu", "0.4")
        found = {
            (row["engine"], row["parameter"]): float(row["value"])
            for row in csv.DictReader(done.stdout.splitlines())
        }
        self.assertEqual({engine for engine, _ in found},
                         {"mujoco", "mjx", "mujoco-warp", "mjlab", "gazebo", "gz-sim", "ode"})
        for engine, along, across, moment in (("mujoco", "pair.friction[0]", "pair.friction[1]",
                                               found["mujoco", "pair.friction[2]"]),
                                              ("ode", "surface.mu", "surface.mu2", found["ode", "surface.rhoN"]),
                                              ("gazebo", "surface/friction/ode/mu", "surface/friction/ode/mu2",
                                               found["gazebo", "surface/friction/torsional/coefficient"] * 3 * math.pi /
                                               16 * found["gazebo", "surface/friction/torsional/patch_radius"])):
            self.assertAlmostEqual(found[engine, along], 0.8, delta=1e-12)
            self.assertAlmostEqual(found[engine, across], 0.2, delta=1e-12)
            self.assertAlmostEqual(moment, 0.4 * spin, delta=1e-14)
        self.assertIn("physx", done.stderr)

    def test_choose_takes_the_disc_where_it_will_do(self):
        def chosen(patch, tolerance):
            (row, ) = (row for row in rows("choose", "--quiet", "--patch", patch, "--tolerance", tolerance)
                       if row["chosen"] == "true")
            return row["model"].split(":")[0]

        self.assertEqual(chosen("ellipse:law=uniform,a=0.004,b=0.004", 1e-6), "disc")
        self.assertEqual(chosen("rectangle:x=0.02,y=0.01", 0.01), "patch")
        self.assertEqual(chosen("rectangle:x=0.02,y=0.01,mx=2", 0.1), "ellipsoid")


class ReplayPatch(PatchCase):
    SPRINGS = ("--mu", 0.6, "--mu-dynamic", 0.5, "--stiffness", 1000, "--twist-stiffness", 0.036, "--details")
    TRACE = ("replay", "--trace", DATA / "traces" / "slide_twist_load.csv")

    def test_columns_are_those_of_replay(self):
        springs = self.SPRINGS[:-1]
        as_law = header(*self.TRACE, "--law", "hertz", "--radius-law", "constant:a=0.006", *springs)
        self.assertEqual(header(*self.TRACE, "--patch", "rectangle:x=0.02,y=0.01", *springs), as_law)

    def test_on_a_body_that_the_trace_moves(self):
        turning = DATA / "scenes" / "turntable.csv"
        found = rows("replay", "--trace", turning, "--body", "trace", "--patch", "rectangle:x=0.02,y=0.01",
                     *self.SPRINGS)
        self.assertIn("slip", {row["state"] for row in found})


if __name__ == "__main__":
    unittest.main()
