# SPDX-License-Identifier: MIT
"""Contacts that are not round: `patch`. References are made here, by sums and quadrature."""

import math
import unittest

from command_line import header, rows, run
from patch_case import PatchCase, by_points

COLUMNS = "vx,vy,omega,fx,fy,moment,power,error"


def gauss(count):
    """Gauss-Legendre's rule on [0, 1]."""
    rule = []
    for i in range(count):
        x = math.cos(math.pi * (i + 0.75) / (count + 0.5))
        for _ in range(50):
            p0, p1 = 1.0, x
            for k in range(2, count + 1):
                p0, p1 = p1, ((2 * k - 1) * x * p1 - (k - 1) * p0) / k
            slope = count * (x * p1 - p0) / (x * x - 1)
            x -= p1 / slope
        rule.append(((1 + x) / 2, 1 / ((1 - x * x) * slope * slope)))
    return rule


GAUSS = gauss(24)


def triangle_points(a, b, c):
    """Weighted points of a triangle (signed), dense towards the vertex a."""
    cross = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    for s, ws in GAUSS:
        for t, wt in GAUSS:
            yield (a[0] + s * (b[0] - a[0] + t * (c[0] - b[0])), a[1] + s * (b[1] - a[1] + t * (c[1] - b[1])), ws * wt * s * cross)


def polygon_points(vertices, corner):
    """A polygon as signed triangles from `corner`, the centre of rotation, where the integrand is not smooth."""
    for first, second in zip(vertices, vertices[1:] + vertices[:1]):
        yield from triangle_points(corner, first, second)


class Patch(PatchCase):
    def expect(self, row, reference, moment_ratio, bound):
        fx, fy, moment, power = reference
        self.assertLessEqual(abs(row["power"] / power - 1), bound)
        self.assertLessEqual(math.hypot(row["fx"] - fx, row["fy"] - fy), bound)
        self.assertLessEqual(abs(row["moment"] - moment) / moment_ratio, bound)
        self.assertLessEqual(row["error"], bound)

    def test_columns(self):
        self.assertEqual(header("patch", "--patch", "rectangle:x=1,y=2", "--twists", self.twists((1.0, 0.0, 0.0))), COLUMNS)

    def test_points_are_the_exact_sum_near_and_far(self):
        points = [(-0.04, -0.04, 1.0), (0.04, -0.02, 2.0), (-0.04, 0.08, 1.0), (0.1, 0.1, 0.0)]
        patch = self.file("points.csv", "x,y,load\n" + "".join(f"{x},{y},{w}\n" for x, y, w in points))
        twists = [(0.01, 0.02, 1.0), (1.0, -2.0, 1e-6), (-0.03, 0.01, -0.5), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (1e5, 3e4, 1.0)]
        for twist, row in zip(twists, self.wrenches(f"points:{patch}", *twists)):
            self.expect(row, by_points(points, twist), 0.05, 1e-13)

    def test_a_point_under_the_cor_bears_no_force(self):
        patch = self.file("points.csv", "x,y,load\n0.1,0.2,1\n0.4,0.2,1\n0.1,0.7,2\n")
        for omega in (1.0, 3.0, -0.1):
            (row,) = self.wrenches(f"points:{patch}", (omega * 0.2, -omega * 0.1, omega))
            sense = math.copysign(1.0, omega)
            self.assertAlmostEqual(row["fx"], -0.5 * sense, delta=1e-14)
            self.assertAlmostEqual(row["fy"], 0.25 * sense, delta=1e-14)

    def test_tactile_logs_with_a_frame_a_row(self):
        frame = [[max(0, 50 - ((x - 16) ** 2 + 2 * (y - 6) ** 2)) for x in range(32)] for y in range(12)]
        text = lambda lines: "".join(",".join(map(str, line)) + "\n" for line in lines)
        one = self.file("one.csv", text(frame))
        log = self.file("log.csv", text([sum(frame[::-1], []), sum(frame, [])]))
        expected = self.wrenches(f"image:{one},pixel=0.002", (0.0, 0.0, 1.0), (1.0, 0.3, 9.0))
        self.assertEqual(self.wrenches(f"image:{log},pixel=0.002,columns=32,frame=2", (0.0, 0.0, 1.0), (1.0, 0.3, 9.0)), expected)
        twists = self.twists((0.0, 0.0, 1.0))
        blocks = self.file("blocks.csv", text(frame) + "\n" + text(frame))
        for image in (f"{log},pixel=0.0002", f"{blocks},pixel=0.002"):  # 2 x 384, and two frames in one picture
            self.assertRegex(run("patch", "--patch", f"image:{image}", "--twists", twists).stderr, r"warning: .* is it one frame\? columns=N")
        for image in (f"{one},pixel=0.002", f"{log},pixel=0.002,columns=32,frame=1"):
            self.assertEqual(run("patch", "--patch", f"image:{image}", "--twists", twists).stderr, "")
        for wrong, told in (("columns=32", "a second frame, expected frame=N"), ("columns=32,frame=3", "no frame 3 of 2"), ("columns=31,frame=1", "a row of 384 pixels"),
                            ("columns=384,frame=1", "of several rows"), ("columns=1.5", "whole number"), ("frame=1", "only with columns=N")):
            self.refused(f"image:{log},pixel=0.002,{wrong}", told)

    def test_polygons_with_the_cor_inside_outside_on_edge_and_vertex(self):
        vertices = [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0)]
        patch = self.file("ell.csv", "x,y\n" + "".join(f"{x},{y}\n" for x, y in vertices))
        # On a line through edges the triangles do not see the other edges' kinks; elsewhere Gauss points of a triangle do.
        for corner in ((0.0, 0.0), (1.0, 1.0), (4.0, 1.0), (1.0, 2.0), (0.5, 1.5), (3.0, 2.0), (-2.0, -3.0), (30.0, 10.0)):
            reference = by_points(list(polygon_points(vertices, corner)), (corner[1], -corner[0], 1.0))
            (row,) = self.wrenches(f"polygon:{patch}", (corner[1], -corner[0], 1.0))
            # 24 points do not resolve the edge next to the COR to more than this.
            self.assertAlmostEqual(row["power"] / reference[3], 1.0, delta=1e-9)
            self.assertAlmostEqual(row["fx"], reference[0], delta=1e-8)
            self.assertAlmostEqual(row["fy"], reference[1], delta=1e-8)
            self.assertAlmostEqual(row["moment"], reference[2], delta=3e-8)
            self.assertLessEqual(row["error"], 1e-12)

    def test_a_square_spins_as_it_must(self):
        (row,) = self.wrenches("rectangle:x=2,y=2", (0.0, 0.0, -2.0), mu=0.5, load=3)
        self.assertAlmostEqual(row["moment"] / (-1.5 * (math.sqrt(2) + math.asinh(1)) / 3), 1.0, delta=1e-14)
        self.assertAlmostEqual(row["power"] / (3.0 * (math.sqrt(2) + math.asinh(1)) / 3), 1.0, delta=1e-14)

    def test_an_ellipse_of_equal_axes_is_the_disc(self):
        for law in ("hertz", "uniform", "power:n=2.3", "xydas-kao:k=3"):
            for s in (0.0, 0.3, 1.0, 2.0, 1e6):
                (exact,) = rows("eval", "--law", law, "--c", s)
                (row,) = self.wrenches(f"ellipse:law={law},a=0.004,b=0.004", (0.0, -0.004 * s, 1.0))
                self.assertAlmostEqual(-row["fy"], exact["force"], delta=1e-12)
                self.assertAlmostEqual(row["moment"] / 0.004, exact["moment"], delta=1e-12)

    def test_samples_on_an_ellipse(self):
        profile = self.file("profile.csv", "radius,pressure\n" + "".join(f"{i / 20},{1.5 * math.sqrt(1 - (i / 20) ** 2)}\n" for i in range(21)))
        (hertz,) = self.wrenches("ellipse:law=hertz,a=0.004,b=0.002", (0.003, 0.001, 1.5))
        (row,) = self.wrenches(f"ellipse:law=samples:{profile},a=0.004,b=0.002", (0.003, 0.001, 1.5))
        self.assertAlmostEqual(row["fx"], hertz["fx"], delta=row["error"])
        self.assertLess(row["error"], 0.1)
        self.assertAlmostEqual(row["power"] / hertz["power"], 1.0, delta=0.02)

    def test_an_image_of_two_pixels_is_a_rectangle(self):
        image = self.file("image.csv", "1,1\n")
        for twist in ((0.0, 0.0, 1.0), (0.1, 0.3, 1.0), (0.0, 5.0, 1.0), (1.0, 1.0, 0.0)):
            (row,) = self.wrenches(f"image:{image},pixel=0.5", twist)
            (exact,) = self.wrenches("rectangle:x=1,y=0.5", twist)
            self.assertLessEqual(abs(row["power"] / exact["power"] - 1), row["error"])
            self.assertLessEqual(abs(row["fx"] - exact["fx"]), row["error"])

    def test_pixels_need_not_be_square(self):
        image = self.file("image.csv", "1,1\n1,1\n")
        for twist in ((1.0, 0.2, 0.3), (0.0, 0.0, 1.0), (0.1, -0.3, 5.0)):
            (row,) = self.wrenches(f"image:{image},pixel=0.5x0.25", twist)
            (exact,) = self.wrenches("rectangle:x=1,y=0.5", twist)
            for name in ("fx", "fy", "moment"):
                self.assertAlmostEqual(float(row[name]), float(exact[name]), delta=float(row["error"]) + 1e-12)
        self.refused(f"image:{image},pixel=0.5x", "pixel")
        self.refused(f"image:{image},pixel=0.5x-1", "pixel", "-1")

    def test_a_file_of_tekscan_has_its_spacing_and_frames(self):
        header = "DATA_TYPE MOVIE\r\nROWS 2\r\nCOLS 3\r\nROW_SPACING 5.0 mm\r\nCOL_SPACING 4.0 mm\r\nUNITS RAW\r\nASCII_DATA @@\r\n"
        frames = "\r\nFrame 1\r\n1,0,3\r\n0,2,0\r\n\r\nFrame 2\r\n5,0,1\r\n1,1,1\r\n@@\r\n"
        movie, plain = self.file("movie.asf", header + frames), self.file("plain.csv", "5,0,1\n1,1,1\n")
        twist = (1.0, 0.2, 30.0)
        self.assertEqual(self.wrenches(f"image:{movie},frame=2", twist), self.wrenches(f"image:{plain},pixel=0.004x0.005", twist))
        self.assertEqual(self.wrenches(f"image:{movie},frame=2,pixel=0.1", twist), self.wrenches(f"image:{plain},pixel=0.1", twist))
        self.refused(f"image:{movie}", "movie.asf:13", "frame=N")
        self.refused(f"image:{movie},frame=3", "no frame 3")
        self.refused(f"image:{plain},frame=1,pixel=1", "frame: only")
        self.refused(f"image:{self.file('bad.asf', header + 'Frame 1' + chr(10) + '1,x,3' + chr(10))}", "bad.asf:9", "'x'")
        self.refused(f"image:{self.file('ragged.asf', header + 'Frame 1' + chr(10) + '1,2,3' + chr(10) + '1,2' + chr(10))}", "ragged.asf:10", "expected 3")
        self.refused(f"image:{self.file('inch.asf', header.replace('4.0 mm', '4.0 in') + frames)},frame=1", "inch.asf:5", "in mm")

    def test_a_pixel_without_sensor_is_said(self):
        image = self.file("image.csv", "1,B, 3\n,2,nan\n")
        full = self.file("full.csv", "1,0,3\n0,2,0\n")
        twists = self.file("twists.csv", "vx,vy,omega\n1,0.2,0.3\n")
        done = run("patch", "--patch", f"image:{image},pixel=0.1", "--twists", twists)
        self.assertEqual(done.stdout, run("patch", "--patch", f"image:{full},pixel=0.1", "--twists", twists).stdout)
        self.assertIn("image.csv: 3 of 6 pixels have no sensor, and count as without pressure", done.stderr)

    def test_first_row_of_an_image_has_the_largest_y(self):
        image = self.file("image.csv", "# tactile\n0,0,9\n1,0,0\n")
        # Loads 0.9 and 0.1: their centre of pressure is the origin; the heavy pixel stands right and up of it.
        points = [(0.2 * 0.1, 0.1 * 0.1, 0.9), (-0.2 * 0.9, -0.1 * 0.9, 0.1)]
        twist = (3.0, -1.0, 2.0)
        (row,) = self.wrenches(f"image:{image},pixel=0.1", twist)
        fx, fy, moment, _ = by_points(points, twist)
        # A pixel 1.5 away has a force off that of a point by its second moment, 0.1^2 / (24 * 1.5^2).
        self.assertAlmostEqual(row["fx"], fx, delta=2e-4)
        self.assertAlmostEqual(row["fy"], fy, delta=2e-4)
        self.assertAlmostEqual(row["moment"], moment, delta=1e-3)

    def test_orthotropic_friction_of_every_kind(self):
        points = self.file("points.csv", "x,y,load\n1,2,1\n-2,0,2\n0,-1,1\n")
        (row,) = self.wrenches(f"points:{points},mx=0.5,my=2", (0.3, 0.1, 0.7))
        fx, fy, moment, power = by_points([(1, 2, 1), (-2, 0, 2), (0, -1, 1)], (0.3, 0.1, 0.7), 0.5, 2.0)
        for name, value in (("fx", fx), ("fy", fy), ("moment", moment), ("power", power)):
            self.assertAlmostEqual(row[name], value, delta=1e-14)
        image = self.file("image.csv", "1,2\n3,4\n")
        for patch in ("rectangle:x=2,y=1", "ellipse:law=uniform,a=1,b=2", f"image:{image},pixel=1"):
            (slide,) = self.wrenches(patch + ",my=0.7,mx=1.3", (1.0, 1.0, 0.0))
            self.assertAlmostEqual(slide["power"], math.hypot(1.3, 0.7), delta=1e-13)
            self.assertAlmostEqual(slide["fx"], 1.3**2 / math.hypot(1.3, 0.7), delta=1e-13)

    def test_files_with_bom_crlf_comments_quotes_and_other_columns(self):
        plain = self.file("plain.csv", "x,y\n0,0\n2,0\n0,1\n")
        odd = self.file("odd, name.csv", b'\xef\xbb\xbf# corners\r\n"y",note,x\r\n0,a,0\r\n\r\n0,"b, c",2\r\n1,c,0\r\n0,a,0\r\n')
        self.assertEqual(self.wrenches(f"polygon:{plain}", (1.0, 0.2, 0.3)), self.wrenches(f"polygon:{odd}", (1.0, 0.2, 0.3)))
        image = self.file("image.csv", b"\xef\xbb\xbf1, 2\r\n\r\n3,4\r\n")
        plain = self.file("plain_image.csv", "1,2\n3,4\n")
        self.assertEqual(self.wrenches(f"image:{plain},pixel=1", (1.0, 0.2, 0.3)), self.wrenches(f"image:{image},pixel=1", (1.0, 0.2, 0.3)))

    def test_a_patch_at_rest_needs_no_wrench(self):
        (row,) = self.wrenches("rectangle:x=2,y=1", (0.0, 0.0, 0.0))
        self.assertEqual([row[name] for name in ("fx", "fy", "moment", "power")], [0.0] * 4)

    def test_extreme_twists_stay_numbers(self):
        image = self.file("image.csv", "1,2\n3,4\n")
        for patch in ("rectangle:x=0.02,y=0.01", "ellipse:law=cone,a=0.01,b=0.0005", f"image:{image},pixel=0.001"):
            for row in self.wrenches(patch, (1e300, 0.0, 1e-300), (1e-300, 1e-300, 1e-300), (0.0, 5e-324, 0.0), (1.0, 1.0, 1e-12)):
                self.assertTrue(math.isfinite(row["fx"]) and math.isfinite(row["moment"]) and row["power"] >= 0)
                self.assertLessEqual(math.hypot(row["fx"], row["fy"]), 1 + 1e-12)

    def test_bad_patches_name_the_place(self):
        points = "x,y,load\n0,0,1\n"
        self.refused("circle:r=1", "expected points:FILE.csv")
        self.refused("rectangle", "expected points:FILE.csv")
        self.refused("rectangle:x=1", "no 'y'")
        self.refused("rectangle:x=1,y=0", "'y'", "> 0")
        self.refused("rectangle:x=1,y=nan", "'y'", "nan")
        self.refused("rectangle:x=1,y=1,z=2", "z=2")
        self.refused("ellipse:law=hertz,a=1", "no 'b'")
        self.refused("ellipse:law=foo,a=1,b=1", "law 'foo'")
        self.refused("ellipse:law=hertz,a=1,b=inf", "'b'")
        self.refused("points:", "no file name")
        self.refused("points:/no/such/file.csv", "/no/such/file.csv")
        self.refused(f"points:{self.file('p.csv', points)},mx=0", "'mx'")
        self.refused(f"points:{self.file('p.csv', '')}", "p.csv:1:1", "empty")
        self.refused(f"points:{self.file('p.csv', 'x,y,load' + chr(10))}", "p.csv:2:1", "no rows")
        self.refused(f"points:{self.file('p.csv', points + '1,2,-1' + chr(10))}", "p.csv:3:5", "'load'", "-1")
        self.refused(f"points:{self.file('p.csv', points + '1,nan,1' + chr(10))}", "p.csv:3:3", "'y'")
        self.refused(f"points:{self.file('p.csv', 'x,y,load' + chr(10) + '0,0,0' + chr(10))}", "load 0")
        self.refused(f"points:{self.file('p.csv', 'x,y' + chr(10) + '0,0' + chr(10))}", "no column 'load'")
        self.refused(f"image:{self.file('i.csv', '1,2')}", "pixel")
        self.refused(f"image:{self.file('i.csv', '')},pixel=1", "i.csv:1:1", "empty")
        self.refused(f"image:{self.file('i.csv', '1,2' + chr(10) + '3' + chr(10))},pixel=1", "i.csv:2:2", "expected 2")
        self.refused(f"image:{self.file('i.csv', '1,2' + chr(10) + '3,x' + chr(10))},pixel=1", "i.csv:2:3")
        self.refused(f"image:{self.file('i.csv', '1,2' + chr(10) + '3,-4' + chr(10))},pixel=1", "i.csv:2:3", "-4")
        self.refused(f"image:{self.file('i.csv', '0,0' + chr(10))},pixel=1", "pressure 0")

    def test_bad_polygons_name_the_vertex(self):
        def polygon(*vertices):
            return f"polygon:{self.file('v.csv', 'x,y' + chr(10) + ''.join(f'{x},{y}' + chr(10) for x, y in vertices))}"

        self.refused(polygon((0, 0), (1, 0)), "2 vertices")
        self.refused(polygon((0, 0), (1, 1), (1, 0), (0, 1)), "vertex 1 to 2", "vertex 3 to 4")
        self.refused(polygon((0, 0), (1, 0), (2, 0)), "no area")
        self.refused(polygon((0, 0), (0, 0), (0, 0)), "vertex 2")
        self.refused(polygon((0, 0), (2, 0), (2, 2), (1, 0), (0, 2)), "meets")
        self.refused(polygon((0, 0), (1, 0), (1, 0), (0, 1)), "vertex 3")
        self.refused(polygon((0, 0), (1, "inf"), (1, 1)), "v.csv:3:3")
        self.refused(polygon((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (1, 1), (0, 1)), "vertex")

    def test_bad_twists_name_the_place(self):
        for text, part in (("", "twists.csv:1:1"), ("vx,vy\n1,2\n", "omega"), ("vx,vy,omega\n1,2\n", "twists.csv:2:4"),
                           ("vx,vy,omega\n1,nan,2\n", "twists.csv:2:3"), ("vx,vy,omega\n1,2,inf\n", "twists.csv:2:5")):
            done = run("patch", "--patch", "rectangle:x=1,y=1", "--twists", self.file("twists.csv", text))
            self.assertEqual(done.returncode, 2)
            self.assertIn(part, done.stderr)


class Slip(PatchCase):
    def slips(self, contact, columns, wrenches):
        data = self.file("wrenches.csv", columns + "\n" + "".join(",".join(map(repr, wrench)) + "\n" for wrench in wrenches))
        return rows("patch", *contact, "--wrenches", data)

    def of(self, patch, *wrenches, mu=0.5):
        return self.slips(("--patch", patch, "--mu", mu), "fx,fy,moment", wrenches)

    def test_the_twist_whose_wrench_this_is(self):
        """Sums and quadrature give the wrench of a twist; the command must find the twist again."""
        ell = [(0.05, 0.01), (0.09, 0.01), (0.09, 0.02), (0.06, 0.02), (0.06, 0.04), (0.05, 0.04)]
        pad = [(-0.01, -0.005), (0.01, -0.005), (0.01, 0.005), (-0.01, 0.005)]
        loads = [(-0.04, -0.04, 1.0), (0.04, -0.02, 2.0), (-0.04, 0.08, 1.0), (0.3, 0.1, 0.5)]
        polygon = "polygon:" + str(self.file("ell.csv", "x,y\n" + "".join(f"{x},{y}\n" for x, y in ell)))
        points = "points:" + str(self.file("points.csv", "x,y,load\n" + "".join(f"{x},{y},{w}\n" for x, y, w in loads)))
        twists = [(0.01, 0.02, 1.0), (-0.03, 0.05, -2.0), (0.02, 0.01, -1.0), (0.03, 0.01, 0.5), (0.0, 0.4, 7.0), (-0.011, 0.052, 1.0)]
        for patch, points_about in ((polygon, lambda c: polygon_points(ell, c)), ("rectangle:x=0.02,y=0.01", lambda c: polygon_points(pad, c)),
                                    (points, lambda c: loads)):
            for mx, my in ((1.0, 1.0), (0.3, 2.0)):
                exact = [by_points(list(points_about((-vy / w, vx / w))), (vx, vy, w), mx, my) for vx, vy, w in twists]
                for (vx, vy, w), wrench, row in zip(twists, exact, self.of(f"{patch},mx={mx},my={my}", *([0.5 * one for one in of[:3]] for of in exact))):
                    self.assertAlmostEqual(row["hold_load"], 1, delta=1e-9)
                    scale = 0.5 * wrench[3]
                    for found, expected, arm in ((row["vx"], vx, 1), (row["vy"], vy, 1), (row["omega"], w, 0.05)):
                        self.assertLess(abs(found * scale - expected) * arm, 1e-8 * (abs(vx) + abs(vy) + 0.05 * abs(w)), (patch, mx, row))
                    self.assertLess(row["error"], 1e-8)

    def test_about_a_point_of_support_it_is_exact(self):
        loads = [(0.01, 0.02, 2.0), (0.04, 0.02, 1.0), (0.01, 0.07, 1.0), (0.03, 0.06, 4.0)]
        patch = f"points:{self.file('four.csv', 'x,y,load' + chr(10) + ''.join(f'{x},{y},{w}' + chr(10) for x, y, w in loads))}"
        for i, (x, y, load) in enumerate(loads):
            fx, fy, moment, power = by_points(loads[:i] + loads[i + 1:], (3 * y, -3 * x, 3.0))
            share = load / 8
            for part, angle in ((0.0, 0.0), (0.5, 1.0), (0.999, 2.0), (-0.7, 0.1)):
                px, py = part * share * math.cos(angle), part * share * math.sin(angle)
                wrench = ((1 - share) * fx + px, (1 - share) * fy + py, (1 - share) * moment + x * py - y * px)
                (row,) = self.of(patch, wrench, mu=1)
                self.assertAlmostEqual(row["hold_load"], 1, delta=1e-12)
                self.assertAlmostEqual(row["omega"] * (1 - share) * power, 3, delta=1e-11)
                self.assertEqual((row["vx"], row["vy"]), (row["omega"] * y, -row["omega"] * x))
                self.assertLess(row["error"], 1e-11)

    def test_round_contacts(self):
        contact = ("--law", "hertz", "--radius-law", "power:c=0.004,gamma=0.3", "--mu", 0.6)
        slip = rows("p-curves", *contact, "--loads", "0.5,3", "--points", 7)
        found = self.slips(contact, "force,moment", [(-row["force"], row["moment"]) for row in slip])
        self.assertEqual(list(found[0]), ["force", "moment", "hold_load", "slide", "spin", "error"])
        for row, point in zip(found, slip, strict=True):
            self.assertAlmostEqual(row["hold_load"] / point["load"], 1, delta=1e-9)
            self.assertAlmostEqual(row["force"] * row["slide"] + row["moment"] * row["spin"], 1, delta=1e-12)
            self.assertAlmostEqual(-row["slide"], -1 / row["force"] if math.isinf(point["c"]) else point["c"] * row["spin"], delta=1e-6 * abs(row["slide"]))
            self.assertLess(row["error"], 1e-9)
        disc = self.of("ellipse:law=hertz,a=0.005,b=0.005", (0.3, 0.4, 1e-3), (-0.8, 0.1, 2e-3))
        for row, other in zip(disc, self.slips(("--law", "hertz", "--radius-law", "constant:a=0.005", "--mu", 0.5), "force,moment",
                                               [(math.hypot(row["fx"], row["fy"]), row["moment"]) for row in disc])):
            for one, same in (("hold_load", "hold_load"), ("omega", "spin")):
                self.assertAlmostEqual(row[one] / other[same], 1, delta=1e-8)
            self.assertAlmostEqual(math.hypot(row["vx"], row["vy"]) / other["slide"], 1, delta=1e-8)

    def test_where_nothing_slips(self):
        point = f"points:{self.file('one.csv', 'x,y,load' + chr(10) + '0.1,0.2,3' + chr(10))}"
        zero, turned, held = self.of(point, (0.0, 0.0, 0.0), (0.0, 0.0, -1e-3), (0.3, 0.7, 0.01))
        self.assertEqual((zero["hold_load"], turned["hold_load"]), (0, math.inf))
        for row in (zero, turned, *self.slips(("--law", "hertz", "--radius-law", "constant:a=1"), "force,moment", [(0.0, 0.0)])):
            self.assertTrue(all(math.isnan(value) for name, value in row.items() if name in ("vx", "vy", "omega", "slide", "spin", "error")), row)
        self.assertAlmostEqual(0.3 * held["vx"] + 0.7 * held["vy"], 1, delta=1e-14)
        data = self.file("w.csv", "fx,fy,moment\n1,2,3\n")
        pad = ("--patch", "rectangle:x=1,y=1")
        for arguments, part in ((pad, "--wrenches"), ((*pad, "--wrenches", data, "--load", 1), "--load"), ((*pad, "--law", "hertz", "--wrenches", data), "--law"),
                                (("--law", "hertz", "--wrenches", data), "--radius-law"), ((*pad, "--radius-law", "constant:a=1", "--wrenches", data), "--radius-law"),
                                (("--law", "hertz", "--twists", data), "--wrenches"), ((*pad, "--wrenches", self.twists((1.0, 0.0, 0.0))), "no column 'fx'")):
            done = run("patch", *arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn(part, done.stderr)


if __name__ == "__main__":
    unittest.main()
