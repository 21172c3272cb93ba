# SPDX-License-Identifier: MIT
"""Contacts that are not round: `patch`, and `fit friction`, `validate`, `choose`, `translate` and `replay` with
--patch. References are made here, by sums and quadrature."""

import math
import os
import re
import subprocess
import unittest

from command_line import DATA, EXECUTABLE, FINGER, CommandLineTest, header, rows, run, table


class PatchCase(CommandLineTest):
    def twists(self, *twists):
        return self.csv("twists.csv", "vx,vy,omega", twists)

    def wrenches(self, patch, *twists):
        return rows("patch", "--quiet", "--patch", patch, "--twists", self.twists(*twists))

    def refused(self, patch, *parts):
        self.assert_fails(2, parts, "patch", "--patch", patch, "--twists", self.twists((1.0, 0.0, 0.0)))


def by_points(points, twist, mx=1.0, my=1.0):
    """Power and wrench of weighted points about the origin."""
    vx, vy, omega = twist
    total = math.fsum(load for _, _, load in points)
    sums = [[], [], [], []]
    for x, y, load in points:
        ux, uy = mx * (vx - omega * y), my * (vy + omega * x)
        speed = math.hypot(ux, uy)
        if speed > 0:
            share = load / total
            fx, fy = share * mx * ux / speed, share * my * uy / speed
            for terms, value in zip(sums, (fx, fy, x * fy - y * fx, share * speed)):
                terms.append(value)
    return [math.fsum(terms) for terms in sums]


def value_of(formula, problem):
    """A formula as it is printed, with the symbols that the problem gives as 'd = 0.1'."""
    given = {name: float(number) for name, number in re.findall(r"(\w) = ([\d.]+)", problem)}
    tokens = re.findall(r"asinh|\d+|\w|\S", formula.replace("²", "^2").translate(str.maketrans("[]", "()")))
    text = ""
    for before, token in zip(["+", *tokens], tokens):
        times = (before.isalnum() and before != "asinh" or before == ")") and (token.isalnum() or token in "(√")
        text += "*" * times + {"^": "**", "√": "sqrt"}.get(token, token)
    return eval(text, {"asinh": math.asinh, "sqrt": math.sqrt, "π": math.pi, **given})


class Patch(PatchCase):
    def test_tactile_logs_with_a_frame_a_row(self):
        frame = [[max(0, 50 - ((x - 16) ** 2 + 2 * (y - 6) ** 2)) for x in range(32)] for y in range(12)]
        text = lambda lines: "".join(",".join(map(str, line)) + "\n" for line in lines)
        one = self.file("one.csv", text(frame))
        log = self.file("log.csv", text([sum(frame[::-1], []), sum(frame, [])]))
        expected = self.wrenches(f"image:{one},pixel=0.002", (0.0, 0.0, 1.0), (1.0, 0.3, 9.0))
        self.assertEqual(self.wrenches(f"image:{log},pixel=0.002,columns=32,frame=2", (0.0, 0.0, 1.0), (1.0, 0.3, 9.0)),
                         expected)
        twists = self.twists((0.0, 0.0, 1.0))
        blocks = self.file("blocks.csv", text(frame) + "\n" + text(frame))
        for image in (f"{log},pixel=0.0002", f"{blocks},pixel=0.002"):  # 2 x 384, and two frames in one picture
            self.assertRegex(
                run("patch", "--patch", f"image:{image}", "--twists", twists).stderr,
                r"warning: .* is it one frame\? columns=N")
        for image in (f"{one},pixel=0.002", f"{log},pixel=0.002,columns=32,frame=1"):
            self.assertEqual(run("patch", "--patch", f"image:{image}", "--twists", twists).stderr, "")
        for wrong, told in (("columns=32", "a second frame, expected frame=N"), ("columns=32,frame=3",
                                                                                 "no frame 3 of 2"),
                            ("columns=32,frame=0", "no frame 0 of 2, counted from 1"),
                            ("columns=31,frame=1", "a row of 384 pixels"), ("columns=384,frame=1", "of several rows"),
                            ("columns=1.5", "whole number"), ("frame=1", "only with columns=N")):
            self.refused(f"image:{log},pixel=0.002,{wrong}", told)

    def test_tables(self):
        """The door: a file of either form gives the wrenches of its table, everywhere where a patch is taken."""
        pad = "ellipse:law=cone,a=0.004,b=0.003"
        twists = (1.0, 0.0, 0.0), (0.0, 0.0, 2.0), (1e-3, 2e-3, 1.0), (-1e-3, 0.0, 0.3)
        found = []
        for form in ("csv", "json"):
            file = self.directory / f"pad.{form}"
            made, = rows("table", "--patch", pad, "--tolerance", "1e-2", "-o", file)
            self.assertEqual(list(made), ["patch", "tolerance", "checked_error", "bytes"])
            self.assertEqual(made["patch"], pad)
            found.append(self.wrenches(f"table:{file}", *twists))
            hold = [rows("hold", "--patch", patch, "--mu", 0.5, "--force", "1,0.5", "--moment", 1e-3)[0]["hold_load"]
                    for patch in (pad, f"table:{file}")]
            self.assertAlmostEqual(hold[0], hold[1], delta=2e-2 * hold[0])
        self.assertEqual(*found)
        for one, other in zip(self.wrenches(pad, *twists), found[0], strict=True):
            self.assertAlmostEqual(one["fx"], other["fx"], delta=made["checked_error"])
        self.refused(f"table:{file},mx=1.2", "make a table of a patch that has them")
        self.refused(f"table:{self.file('cut.csv', (self.directory / 'pad.csv').read_bytes()[:-9])}", "cut.csv:")

    def test_half_spaces(self):
        """The door's columns; the round contact of `curve` is the ellipse of `patch`. What they keep is asserted in
        half_spaces_test.cpp."""
        call = ["patch", "--patch", "rectangle:x=0.2,y=0.1", "--half-spaces"]
        self.assertEqual(header(*call, "14"), "kind,fx,fy,moment,share")
        found = rows(*call, "20")
        self.assertEqual([sum(row["kind"] == kind for row in found) for kind in ("row", "vertex")], [14, 18])
        self.assertIn("--points has no effect",
                      run("curve", "--law", "hertz", "--half-spaces", "14", "--points", "5").stderr)
        self.assertEqual(rows("curve", "--law", "hertz", "--half-spaces", "14"),
                         rows("patch", "--patch", "ellipse:law=hertz,a=1,b=1", "--half-spaces", "14"))

    def test_bolts_tyres_and_pucks(self):
        """On docs/not_robots.md, each command and each formula, with the numbers of its problem, give the answer."""
        page = (DATA.parent / "docs" / "not_robots.md").read_text(encoding="utf-8")
        lines = [line.strip("| ").split(" | ") for line in page.splitlines() if re.match(r"\|.*limitcurve", line)]
        self.assertEqual(len(lines), 6)
        for problem, command, column, answer in lines:
            path = os.path.dirname(EXECUTABLE) + os.pathsep + os.environ["PATH"]
            done = subprocess.run(["sh", "-c", command.strip("`")],
                                  cwd=self.directory,
                                  env={**os.environ, "PATH": path},
                                  capture_output=True,
                                  text=True,
                                  check=True)
            row, = table(done.stdout)
            formula, number = answer.split(" = ")
            for found in (row[column.strip("`")], value_of(formula, problem)):
                self.assertAlmostEqual(found / float(number), 1, delta=5e-4, msg=problem)

    def test_a_file_of_tekscan_has_its_spacing_and_frames(self):
        header = ("DATA_TYPE MOVIE\r\nROWS 2\r\nCOLS 3\r\nROW_SPACING 5.0 mm\r\nCOL_SPACING 4.0 mm\r\nUNITS "
                  "RAW\r\nASCII_DATA @@\r\n")
        frames = "\r\nFrame 1\r\n1,0,3\r\n0,2,0\r\n\r\nFrame 2\r\n5,0,1\r\n1,1,1\r\n@@\r\n"
        movie, plain = self.file("映画.asf", header + frames), self.file("plain.csv", "5,0,1\n1,1,1\n")
        twist = (1.0, 0.2, 30.0)
        self.assertEqual(self.wrenches(f"image:{movie},frame=2", twist),
                         self.wrenches(f"image:{plain},pixel=0.004x0.005", twist))
        self.assertEqual(self.wrenches(f"image:{movie},frame=2,pixel=0.1", twist),
                         self.wrenches(f"image:{plain},pixel=0.1", twist))
        self.refused(f"image:{movie}", "映画.asf:13", "frame=N")
        self.refused(f"image:{movie},frame=3", "no frame 3")
        for text, line, part in ((header + "Frame 1\n1,x,3\n", 9, "'x'"),
                                 (header + "Frame 1\n1,2,3\n1,2\n", 10, "expected 3"),
                                 (header.replace("4.0 mm", "4.0 in") + frames, 5, "in mm")):
            self.refused(f"image:{self.file('bad.asf', text)}", f"bad.asf:{line}", part)

    def test_a_pixel_without_sensor_is_said(self):
        image = self.file("image.csv", "1,B, 3\n,2,nan\n")
        full = self.file("full.csv", "1,0,3\n0,2,0\n")
        twists = self.file("twists.csv", "vx,vy,omega\n1,0.2,0.3\n")
        done = run("patch", "--patch", f"image:{image},pixel=0.1", "--twists", twists)
        self.assertEqual(done.stdout, run("patch", "--patch", f"image:{full},pixel=0.1", "--twists", twists).stdout)
        self.assertIn("image.csv: 3 of 6 pixels have no sensor, and count as without pressure", done.stderr)

    def test_orthotropic_friction_of_every_kind(self):
        points = self.file("points.csv", "x,y,load\n1,2,1\n-2,0,2\n0,-1,1\n")
        (row,) = self.wrenches(f"points:{points},mx=0.5,my=2", (0.3, 0.1, 0.7))
        fx, fy, moment, power = by_points([(1, 2, 1), (-2, 0, 2), (0, -1, 1)], (0.3, 0.1, 0.7), 0.5, 2.0)
        for name, value in (("fx", fx), ("fy", fy), ("moment", moment), ("power", power)):
            self.assertAlmostEqual(row[name], value, delta=1e-14)
        image = self.file("image.csv", "1,1\n1,1\n")
        for patch in ("rectangle:x=2,y=2", "ellipse:law=uniform,a=1,b=2", f"image:{image},pixel=1"):
            (slide,) = self.wrenches(patch + ",my=0.7,mx=1.3", (1.0, 1.0, 0.0))
            self.assertAlmostEqual(slide["power"], math.hypot(1.3, 0.7), delta=1e-13)

    def test_files_with_bom_crlf_comments_quotes_and_other_columns(self):
        plain = self.file("plain.csv", "x,y\n0,0\n2,0\n0,1\n")
        odd = self.file("odd, name.csv",
                        b'\xef\xbb\xbf# corners\r\n"y",note,x\r\n\r\n0,a,0\r\n0,"b, c",2\r\n1,c,0\r\n0,a,0\r\n\r\n')
        self.assertEqual(self.wrenches(f"polygon:{plain}", (1.0, 0.2, 0.3)),
                         self.wrenches(f"polygon:{odd}", (1.0, 0.2, 0.3)))
        image = self.file("image.csv", b"\xef\xbb\xbf1, 2\r\n\r\n3,4\r\n")
        plain = self.file("plain_image.csv", "1,2\n3,4\n")
        self.assertEqual(self.wrenches(f"image:{plain},pixel=1", (1.0, 0.2, 0.3)),
                         self.wrenches(f"image:{image},pixel=1", (1.0, 0.2, 0.3)))


class Slip(PatchCase):
    def slips(self, contact, columns, wrenches):
        return rows("patch", *contact, "--wrenches", self.csv("wrenches.csv", columns, wrenches))

    def of(self, patch, *wrenches, mu=0.5):
        return self.slips(("--patch", patch, "--mu", mu), "fx,fy,moment", wrenches)

    def test_round_contacts(self):
        contact = ("--law", "hertz", "--radius-law", "power:c=0.004,gamma=0.3", "--mu", 0.6)
        slip = rows("p-curves", *contact, "--loads", "0.5,3", "--points", 7)
        found = self.slips(contact, "force,moment", [(-row["force"], row["moment"]) for row in slip])
        self.assertEqual(list(found[0]), ["force", "moment", "hold_load", "slide", "spin", "error"])
        for row, point in zip(found, slip, strict=True):
            self.assertAlmostEqual(row["hold_load"] / point["load"], 1, delta=1e-9)
            self.assertAlmostEqual(row["force"] * row["slide"] + row["moment"] * row["spin"], 1, delta=1e-12)
            self.assertLess(row["error"], 1e-9)

    def test_where_nothing_slips(self):
        one = self.file("one.csv", "x,y,load\n0.1,0.2,3\n")
        point = f"points:{one}"
        zero, turned, held = self.of(point, (0.0, 0.0, 0.0), (0.0, 0.0, -1e-3), (0.3, 0.7, 0.01))
        self.assertEqual((zero["hold_load"], turned["hold_load"]), (0, math.inf))
        for row in (zero, turned, *self.slips(
            ("--law", "hertz", "--radius-law", "constant:a=1"), "force,moment", [(0.0, 0.0)])):
            for name in {"vx", "vy", "omega", "slide", "spin", "error"} & row.keys():
                self.assertTrue(math.isnan(row[name]), row)
        self.assertAlmostEqual(0.3 * held["vx"] + 0.7 * held["vy"], 1, delta=1e-14)


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
        made = [(*twist, *(mu * load * one for one in by_points(points, twist)[:3])) for twist in moved]
        patch = self.csv("two.csv", "x,y,load", points)
        return f"points:{patch}", self.csv("pushes.csv", "dx,dy,dtheta,force_x,force_y,moment", made)

    MOVED = [(0.01, 0.0, 0.1), (0.0, 0.01, -0.05), (0.001, 0.002, 0.3), (0.02, -0.01, 0.0), (0.0, 0.0, 0.2)]

    def changed(self, data, change, name="changed"):
        """The pushes with each row changed: a dict of columns."""
        found = [change(i, row) for i, row in enumerate(table(data.read_text()))]
        return self.csv(f"{name}.csv", ",".join(found[0]), [row.values() for row in found])

    @staticmethod
    def reacting(row):
        return {name: value if name.startswith("d") else -value for name, value in row.items()}

    def test_reactions_are_refused_and_single_pushes_against_the_motion_left_out(self):
        patch, data = self.pushes(self.MOVED)
        for against in (range(5), range(1, 5)):
            told = f"push {against[0] + 2}: negative power, as in {len(against)} of 5 pushes", "reaction"
            self.assert_fails(2, told, "fit", "friction", "--patch", patch, "--data",
                              self.changed(data, lambda i, row: self.reacting(row) if i in against else row))
        done = run("fit", "friction", "--patch", patch, "--data",
                   self.changed(data, lambda i, row: self.reacting(row) if i == 2 else row))
        self.assertIn("push 4 (by line of the file): negative power, left out", done.stderr)
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
        found = {(row["engine"], row["parameter"]): row["value"] for row in table(done.stdout)}
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
    def test_columns_are_those_of_replay_and_a_body_may_move(self):
        trace = ("replay", "--trace", DATA / "traces" / "slide_twist_load.csv")
        patch = ("--patch", "rectangle:x=0.02,y=0.01", *FINGER[4:])
        self.assertEqual(header(*trace, *patch), header(*trace, *FINGER))
        found = rows("replay", "--trace", DATA / "scenes" / "turntable.csv", "--body", "trace", *patch)
        self.assertIn("slip", {row["state"] for row in found})


if __name__ == "__main__":
    unittest.main()
