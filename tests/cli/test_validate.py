# SPDX-License-Identifier: MIT
"""validate and choose: the errors of the models, and the cheapest one that is good enough."""

import math
import random
import re
import unittest
from pathlib import Path

from command_line import FINGER, CommandLineTest, rows, run
from test_patch import by_points


class Validate(CommandLineTest):
    def test_without_a_law_all_that_are_listed(self):
        laws = [row["law"] for row in rows("laws")]
        found = rows("validate")
        self.assertEqual(list(dict.fromkeys(row["law"] for row in found)), laws)
        self.assertGreaterEqual({row["model"]
                                 for row in found},
                                {"ellipse", "ellipse-least-squares", "ellipse-inner", "box", "diamond", "pade"})
        self.assertEqual({(row["model"], row["parameter"])
                          for row in found
                          if row["model"] in ("ellipse", "box")}, {("ellipse", 1), ("box", math.inf)})

    def test_laws_may_be_repeated(self):
        self.assertEqual(
            [row["law"] for row in rows("validate", "--law", "hertz", "--law", "cone") if row["model"] == "box"],
            ["hertz", "cone"])
        self.assert_fails(2, "'herz'", "validate", "--law", "hertz", "--law", "herz")

    def test_common_laws_lie_within_4_per_cent_of_each_other(self):
        # By the support function of the normalised plane, H(u) = x cos u + y sin u: two curves differ nowhere by more
        # than their support functions do.
        angles = [math.pi / 2 * i / 200 for i in range(201)]
        supports = []
        for law in ["flat-punch", "uniform", "hertz", "parabolic", "cone", "gaussian:sigma=1"]:
            ratio = rows("eval", "--law", law, "--c", "0")[0]["moment"]
            cors = ",".join(repr(ratio / math.tan(angle)) if angle else "inf" for angle in angles)
            supports.append([row["force"] * math.cos(angle) + row["moment"] / ratio * math.sin(angle)
                             for row, angle in zip(rows("eval", "--law", law, "--c", cors), angles)])
        farthest = max(max(at) / min(at) - 1 for at in zip(*supports))
        self.assertTrue(0.03 < farthest < 0.04, farthest)

    def test_json(self):
        self.assertIn('"max_cor_error":"inf"', run("validate", "--law", "hertz", "--format", "json").stdout)


class Points(CommandLineTest):
    def judged(self, contact, columns, points):
        (row, ) = rows("validate", *contact, "--points", self.csv("points.csv", columns, points))
        self.assertEqual((row["model"], row["parameter"]), (str(self.directory / "points.csv"), len(points)))
        return row

    def test_points_of_the_exact_curve_and_scaled_ones(self):
        exact = [(row["force"], row["moment"], row["c"]) for row in rows("eval", "--law", "hertz", "--c", "0,1,5,inf")]
        row = self.judged(("--law", "hertz"), "force,moment,c", exact)
        self.assertLess(max(row["max_error"], row["max_cor_error"]), 1e-13)
        scales = -1.2 * 3, 1.2 * 3 * 0.005, 0.005
        changed = [[value * scale * change
                    for value, scale, change in zip(point, scales, (1.1, 1.1, 1) if i == 2 else (1, 1, 1))]
                   for i, point in enumerate(exact)]
        row = self.judged(("--law", "hertz", "--mu", 1.2, "--load", 3, "--radius", 0.005), "force,moment,c", changed)
        for column, expected in (("max_error", 0.1), ("max_over_estimate", 0.1), ("max_under_estimate", 0),
                                 ("max_cor_error", 0), ("rms_error", 0.05)):
            self.assertAlmostEqual(row[column], expected, delta=1e-12, msg=column)
        self.assertEqual(
            self.judged(("--law", "hertz"), "force,moment", [point[:2] for point in exact])["max_cor_error"], "")

    def test_a_centre_of_rotation_counts_as_far_as_the_point_tells_it(self):
        moment = 3 * math.pi / 16
        told = [(1, 1e-12, math.inf), (1, 0, -1e9), (1e-12, moment, 0), (1e-17, -moment, 1e-17),
                (-0.8835729338, 0.2208932335, -1)]
        self.assertEqual(self.judged(("--law", "hertz"), "force,moment,c", told)["max_cor_error"], 0)
        for point, error in (((1, 0, 100), 1), ((0.99, 0.0628, math.inf), math.inf), ((0.8835729338, 0.2208932335,
                                                                                       -1.01), 0.01)):
            self.assertAlmostEqual(self.judged(("--law", "hertz"), "force,moment,c", [point])["max_cor_error"],
                                   error,
                                   delta=1e-6)

    def test_methods_of_the_page(self):
        square, pad = ("--patch", "rectangle:x=0.1,y=0.1"), ("--patch", "rectangle:x=0.082,y=0.0625")
        d = math.hypot(0.082, 0.0625)
        closed = (d + 0.082 ** 2 / 0.125 * math.asinh(0.0625 / 0.082) +
                  0.0625 ** 2 / 0.164 * math.asinh(0.082 / 0.0625)) / 6
        spin = {
            "closed form": (pad, closed),
            "quadrature with two points per axis": (pad, d / 2 / math.sqrt(3)),
            "disc around it": (square, 0.1 * math.sqrt(2) / 3),
            "√(ab) as radius": (("--patch", "ellipse:law=parabolic,a=0.05,b=0.01"), 0.08 / 15 * math.sqrt(5))
        }
        errors = {
            method: self.judged(contact, "fx,fy,moment", [(0.0, 0.0, moment)])["max_error"]
            for method, (contact, moment) in spin.items()
        }
        chance = random.Random(1)
        means = [sum(math.sqrt(1 - chance.random() ** (2 / 3)) for _ in range(10000)) / 10000 for _ in range(20)]
        errors["10 000 random points"] = self.judged(("--law", "hertz"), "force,moment",
                                                     [(0.0, mean) for mean in means])["rms_error"]
        cells = [((i - 10) / 210, (j - 10) / 210, 1.0) for i in range(21) for j in range(21)]
        cors = [(i / 800, j / 800) for i in range(60) for j in range(i + 1)]
        errors["21 × 21 cells"] = self.judged(square, "fx,fy,moment",
                                              [by_points(cells, (y, -x, 1.0))[:3] for x, y in cors])["max_error"]
        page = (Path(__file__).parents[2] / "docs" / "validate.md").read_text(encoding="utf-8")
        for method, error in errors.items():
            self.assertRegex(page, rf"\[{re.escape(method)}\]\([^)]*\) \| {100 * error:.1f} %", method)


class Choose(CommandLineTest):
    def test_explains_itself_on_standard_error(self):
        done = run("choose", "--law", "hertz", "--tolerance", "0.01", "--explain")
        self.assertEqual(done.stdout.splitlines()[0], "model,parameter,error,nanoseconds,chosen")
        self.assertIn("ellipse: 6.4 % > 1 %", done.stderr)
        self.assertIn(": chosen", done.stderr)
        self.assertRegex(done.stderr, "(?m)^error: of the radius on a ray, .*--scene$")
        self.assertEqual(run("choose", "--law", "hertz", "--tolerance", "0.01").stderr, "")
        # Digits tell an error from the tolerance.
        self.assertIn("ellipse: 6.38 % > 6.36 %",
                      run("choose", "--law", "hertz", "--tolerance", "0.0636", "--explain").stderr)

    def test_a_scene(self):
        scene = ["choose", "--law", "hertz", "--tolerance", "0.01", "--scene", "--mu", "0.6", "--sample-time", "0.01"]
        coupled = run(*scene)
        self.assertEqual(coupled.stdout.splitlines()[0], "model,parameter,error,nanoseconds,chosen")
        self.assertTrue(coupled.stderr.startswith("limitcurve: coupling is needed"), coupled.stderr)
        self.assertTrue(
            all(line.startswith("limitcurve: ") and len(line) < 180 for line in coupled.stderr.splitlines()),
            coupled.stderr)
        best = [line for line in coupled.stdout.splitlines() if line.endswith(",true")]
        self.assertEqual([line.split(",")[0] for line in best], ["table/closest-point"])
        self.assertTrue(run(*scene, "--slide-speed", "0").stderr.startswith("limitcurve: uncoupled will do"))
        self.assertTrue(run(*scene, "--twist-rate", "0").stderr.startswith("limitcurve: no torsion is needed"))

    def test_a_scene_says_what_to_type_into_replay(self):
        """What was given and what the scene says, together, make a replay."""
        trace = self.file("trace.csv", "time,x,y,z,twist\n0,0,0,-0.001,0\n0.1,0.002,0,-0.001,0\n")
        loads = "load,radius\n0.5,0.005\n1,{}\n2,{}\n".format
        plateau = f"samples:{self.file('plateau.csv', loads(0.006, 0.006))}"
        ends = f"samples:{self.file('ends.csv', loads(0.0052, 0.005))}"

        def said(given, tolerance, *more):
            done = run("choose", "--scene", "--law", "hertz", *given, "--tolerance", tolerance, *more)
            line = next(line for line in done.stderr.splitlines() if line.startswith("limitcurve: replay it with "))
            options = line.removeprefix("limitcurve: replay it with ").removesuffix(" instead of --radius-law").split()
            kept = [*given]
            if "--radius-law" in given and {"--mu-r", "--radius-law"} & {*options}:
                del kept[given.index("--radius-law"):given.index("--radius-law") + 2]
            self.assertEqual(len(rows("replay", "--trace", trace, "--law", "hertz", *kept, *options, "--quiet")), 2)
            return done, options

        # The last two are equal at the most load and at the mean one, or at both ends.
        for radius, tolerance, more in (("constant:a=0.006", 0.3, ["--twist-rate", "0"]),
                                        ("power:c=0.005,gamma=0.3", 0.02, []), ("power:c=0.005,gamma=0.3", 1e-4, []),
                                        (plateau, 0.3, []), (ends, 0.02, []), (ends, 0.3, [])):
            done, options = said(["--radius-law", radius, *FINGER[4:]], tolerance, "--sample-time", "0.02", *more)
            best = next(row for row in done.stdout.splitlines() if row.endswith(",true")).split(",")[0]
            follows = best.endswith("/a(P)") or best == "no torsion" or radius.startswith("constant")
            self.assertEqual("--radius-law" not in options, follows, (best, options))
            if best != "no torsion":
                self.assertEqual(best.split("/")[:2], [options[1], options[3]])
        for given in [[], ["--mu", "0.6"], ["--mu-r", "0.002"],
                      ["--stiffness", "500", "--radius-law", "constant:a=0.004"]]:
            told = said(given, "0.2")[0].stderr
            self.assertEqual("a = 5 mm" in told, "--mu-r" not in given and "--radius-law" not in given, told)


if __name__ == "__main__":
    unittest.main()
