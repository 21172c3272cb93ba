# SPDX-License-Identifier: MIT
"""Contacts that are not round: `patch`, and what else takes --patch. References are made here, by sums and quadrature."""

import math
import tempfile
import unittest
from pathlib import Path

from command_line import DATA, header, rows, run

COLUMNS = "vx,vy,omega,fx,fy,moment,power,error"


class PatchCase(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = Path(self._folder.name)
        self.addCleanup(self._folder.cleanup)

    def file(self, name, text):
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def twists(self, *twists):
        return self.file("twists.csv", "vx,vy,omega\n" + "".join(f"{x!r},{y!r},{w!r}\n" for x, y, w in twists))

    def wrenches(self, patch, *twists, **options):
        arguments = [text for name, value in options.items() for text in (f"--{name}", value)]
        return rows("patch", "--patch", patch, "--twists", self.twists(*twists), *arguments)

    def refused(self, patch, *parts):
        done = run("patch", "--patch", patch, "--twists", self.twists((1.0, 0.0, 0.0)))
        self.assertEqual(done.returncode, 2, patch)
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, r"\Alimitcurve: error: [^\n]*\n\Z")
        for part in parts:
            self.assertIn(part, done.stderr)


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
        self.refused(f"image:{self.file('i.csv', '1,2' + chr(10) + '3,nan' + chr(10))},pixel=1", "i.csv:2:3")
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


class FitFriction(PatchCase):
    def fit(self, patch, data, *options):
        return {row["parameter"]: row for row in rows("fit", "friction", "--patch", patch, "--data", data, *options)}

    def test_measured_pushes_are_explained_by_the_points_and_not_by_the_ellipsoid(self):
        figures = {"hardboard": ((4.467, 0.045), (-0.034, 0.046), (-0.361, 0.064)), "plywood": ((5.326, 0.060), (-0.030, 0.036), (-0.288, 0.038))}
        for name, (mu, drift, drift_ellipsoid) in figures.items():
            found = self.fit(f"points:{DATA}/measured/tripod_{name}_a_points.csv", DATA / "measured" / f"tripod_{name}_a.csv")
            for parameter, (value, error) in (("mu", mu), ("drift", drift), ("drift_ellipsoid", drift_ellipsoid)):
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

    def test_exact_pushes_give_their_coefficient_without_drift(self):
        moved = [(0.01, 0.0, 0.1), (0.0, 0.01, -0.05), (0.001, 0.002, 0.3), (0.02, -0.01, 0.0), (0.0, 0.0, 0.2)]
        found = self.fit(*self.pushes(moved), "--load", 10)
        self.assertAlmostEqual(found["mu"]["value"], 0.4, delta=1e-14)
        self.assertAlmostEqual(found["drift"]["value"], 0.0, delta=1e-13)
        self.assertEqual(found["mu"]["unit"], 1.0)
        self.assertLess(found["drift_ellipsoid"]["value"], -0.01)

    def test_pushes_that_all_turn_alike_have_no_drift_to_tell(self):
        found = self.fit(*self.pushes([(0.01, 0.0, 0.0), (0.0, 0.01, 0.0), (-0.02, 0.01, 0.0)]))
        self.assertAlmostEqual(found["mu"]["value"], 4.0, delta=1e-14)
        self.assertTrue(math.isnan(found["drift"]["value"]))

    def test_bad_data_are_named(self):
        patch, data = self.pushes([(0.01, 0.0, 0.1), (0.0, 0.0, 0.0), (0.0, 0.01, 0.2)])
        few = self.file("few.csv", self.pushes([(0.01, 0.0, 0.1), (0.0, 0.01, 0.0)])[1].read_text())
        still = self.file("still.csv", self.pushes([(0.01, 0.0, 0.1), (0.0, 0.0, 0.0)])[1].read_text())
        torn = self.file("torn.csv", "force_x,force_y,moment,dx,dy,dtheta\n1,2,3,4,5\n")
        for arguments, part in ((("--patch", patch, "--data", still), "still.csv:3"),
                                (("--patch", patch, "--data", few), "expected at least 3"),
                                (("--patch", patch, "--data", torn), "torn.csv:2"), (("--patch", patch), "--data"), (("--data", data), "--patch"),
                                (("--patch", patch, "--data", patch[7:]), "no column 'force_x'")):
            done = run("fit", "friction", *arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn(part, done.stderr)
        self.assertIn("--patch", run("fit", "ellipse", "--law", "hertz", "--patch", patch).stderr)


class HowWrongIsRound(PatchCase):
    COLUMNS = "law,model,parameter,max_error,rms_error,max_over_estimate,max_under_estimate,max_cor_error"

    def models(self, patch):
        found = {row["model"].split(":")[0]: row for row in rows("validate", "--patch", patch)}
        for row in found.values():
            self.assertEqual(row["law"], patch)
            self.assertEqual(row["max_error"], max(row["max_over_estimate"], row["max_under_estimate"]))
            self.assertLessEqual(row["rms_error"], row["max_error"] * (1 + 1e-9) + 1e-12)
        return found

    def test_columns(self):
        self.assertEqual(header("validate", "--patch", "rectangle:x=1,y=1"), self.COLUMNS)
        self.assertEqual(header("choose", "--patch", "rectangle:x=1,y=1", "--tolerance", 0.1), "model,parameter,error,nanoseconds,chosen")

    def test_the_ellipsoid_on_elliptic_hertz_contacts(self):
        for aspect, over in ((1, 0.0638), (2, 0.1009), (5, 0.1217)):
            found = self.models(f"ellipse:law=hertz,a={0.004 * aspect},b=0.004")
            self.assertAlmostEqual(found["ellipsoid"]["max_over_estimate"], over, delta=6e-5)

    def test_a_disc_is_the_disc(self):
        for law in ("hertz", "uniform", "cone"):
            found = self.models(f"ellipse:law={law},a=0.004,b=0.004")
            self.assertEqual(found["disc"]["model"], f"disc:{law}")
            self.assertAlmostEqual(found["disc"]["parameter"] / 0.004, 1.0, delta=1e-9)
            self.assertLess(found["disc"]["max_error"], 1e-9)
            self.assertLess(found["disc"]["max_cor_error"], 1e-6)
            for model in ("disc-equal-area", "disc-sqrt-ab"):
                self.assertAlmostEqual(found[model]["parameter"] / 0.004, 1.0, delta=1e-9)
                self.assertLess(found[model]["max_error"], 1e-9)
            # The ellipsoid is then the ellipse through the intercepts; its over-estimate of power is that of the radius.
            (ellipse,) = (row for row in rows("validate", "--law", law) if row["model"] == "ellipse")
            self.assertAlmostEqual(found["ellipsoid"]["max_over_estimate"], ellipse["max_over_estimate"], delta=1e-6)
            self.assertAlmostEqual(found["ellipsoid"]["max_cor_error"], ellipse["max_cor_error"], delta=1e-4)

    def test_the_best_disc_is_better_than_the_others_and_balanced(self):
        for patch in ("rectangle:x=0.02,y=0.01", "ellipse:law=hertz,a=0.02,b=0.004", "rectangle:x=1,y=1"):
            found = self.models(patch)
            self.assertLess(found["disc"]["max_error"], found["disc-equal-area"]["max_error"])
            self.assertLess(found["disc"]["max_error"], found["disc-sqrt-ab"]["max_error"])
            self.assertAlmostEqual(found["disc"]["max_over_estimate"] / found["disc"]["max_under_estimate"], 1.0, delta=1e-3)

    def test_radii(self):
        found = self.models("rectangle:x=0.02,y=0.01")
        self.assertAlmostEqual(found["disc-equal-area"]["parameter"], math.sqrt(2e-4 / math.pi), delta=1e-15)
        # The ellipse of a rectangle's second moments has the semi-axes side/sqrt(3).
        self.assertAlmostEqual(found["disc-sqrt-ab"]["parameter"], math.sqrt(2e-4 / 3), delta=1e-12)
        found = self.models("ellipse:law=power:n=2.3,a=0.02,b=0.005,mx=2,my=0.5")
        self.assertAlmostEqual(found["disc-sqrt-ab"]["parameter"], 0.01, delta=1e-9)

    def test_a_lopsided_patch_has_no_bound_of_its_cor(self):
        patch = self.file("points.csv", "x,y,load\n-0.04,-0.04,1\n0.04,-0.02,2\n-0.04,0.08,1\n")
        found = self.models(f"points:{patch}")
        self.assertNotIn("disc-equal-area", found)
        self.assertEqual(found["ellipsoid"]["max_cor_error"], math.inf)

    def test_orthotropic_friction_is_the_ellipsoids_own(self):
        # A disc under diag(1, 2) is an ellipse 2 : 1 to the ellipsoid.
        found = self.models("ellipse:law=hertz,a=0.004,b=0.004,my=2")
        self.assertAlmostEqual(found["ellipsoid"]["max_over_estimate"], 0.1009, delta=6e-5)
        self.assertGreater(found["disc"]["max_error"], 0.3)

    def test_choose_takes_the_disc_where_it_will_do(self):
        def chosen(patch, tolerance):
            (row,) = (row for row in rows("choose", "--patch", patch, "--tolerance", tolerance) if row["chosen"] == "true")
            return row["model"].split(":")[0]

        self.assertEqual(chosen("ellipse:law=uniform,a=0.004,b=0.004", 1e-6), "disc")
        self.assertEqual(chosen("rectangle:x=1,y=1", 0.01), "disc")
        self.assertEqual(chosen("rectangle:x=0.02,y=0.01", 0.1), "disc")
        self.assertEqual(chosen("rectangle:x=0.02,y=0.01", 0.01), "patch")
        self.assertEqual(chosen("rectangle:x=0.02,y=0.01,mx=2", 0.1), "ellipsoid")

    def test_bad_usage(self):
        one = self.file("one.csv", "x,y,load\n1,2,3\n")
        for arguments, part in ((("validate", "--patch", f"points:{one}"), "on one point"),
                                (("validate", "--patch", "rectangle:x=1,y=1", "--law", "hertz"), "--law"),
                                (("choose", "--patch", "rectangle:x=1,y=1", "--law", "hertz", "--tolerance", 0.1), "--law and --patch"),
                                (("choose", "--tolerance", 0.1), "--law"), (("choose", "--patch", "rectangle:x=1,y=1"), "--tolerance"),
                                (("choose", "--patch", "rectangle:x=1,y=1", "--tolerance", 0.1, "--scene"), "--scene"),
                                (("choose", "--patch", "rectangle:x=1,y=1", "--tolerance", 7), "tolerance")):
            done = run(*arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertIn(part, done.stderr)


class ReplayPatch(PatchCase):
    SPRINGS = ("--mu", 0.6, "--mu-dynamic", 0.5, "--stiffness", 1000, "--twist-stiffness", 0.036, "--details")
    TRACE = ("replay", "--trace", DATA / "traces" / "slide_twist_load.csv")

    def test_a_disc_is_the_finger_of_its_law(self):
        law = rows(*self.TRACE, "--law", "hertz", "--radius-law", "constant:a=0.006", "--tolerance", "1e-12", *self.SPRINGS)
        patch = rows(*self.TRACE, "--patch", "ellipse:law=hertz,a=0.006,b=0.006", *self.SPRINGS)
        self.assertEqual(len(law), len(patch))
        for one, other in zip(law, patch):
            self.assertEqual(one["state"], other["state"])
            for name in ("px", "py", "angle", "depth", "load", "fx", "fy"):
                self.assertAlmostEqual(one[name], other[name], delta=1e-9)
            self.assertAlmostEqual(one["moment"] / 0.006, other["moment"] / 0.006, delta=1e-8)
            self.assertAlmostEqual(one["dissipated"], other["dissipated"], delta=1e-11)
            self.assertAlmostEqual(one["margin"], other["margin"], delta=1e-6)
            for name in ("corx", "cory"):
                self.assertTrue(one[name] == other[name] or math.isnan(one[name]) or abs(one[name] - other[name]) < 1e-5 * one["cor"])

    def test_columns_are_those_of_replay(self):
        springs = self.SPRINGS[:-1]
        as_law = header(*self.TRACE, "--law", "hertz", "--radius-law", "constant:a=0.006", *springs)
        self.assertEqual(header(*self.TRACE, "--patch", "rectangle:x=0.02,y=0.01", *springs), as_law)

    def test_dissipates_and_slips_on_its_limit(self):
        points = self.file("points.csv", "x,y,load\n-0.004,-0.004,1\n0.004,-0.002,2\n-0.004,0.008,1\n")
        image = self.file("image.csv", "1,2,3\n4,0,1\n2,2,2\n")
        for patch in (f"points:{points}", f"image:{image},pixel=0.002", "rectangle:x=0.02,y=0.01,mx=0.5", "ellipse:law=cone,a=0.01,b=0.002"):
            last = 0.0
            states = set()
            for row in rows(*self.TRACE, "--patch", patch, *self.SPRINGS):
                states.add(row["state"])
                self.assertGreaterEqual(row["dissipated"], last)
                last = row["dissipated"]
                self.assertTrue(math.isfinite(row["fx"]) and math.isfinite(row["moment"]))
                self.assertLessEqual(math.hypot(row["fx"], row["fy"]), 0.6 * row["load"] * (1 + 1e-9))
                if row["state"] == "slip":
                    self.assertAlmostEqual(row["hold_load"] / row["load"], 0.5 / 0.6, delta=1e-6)
            self.assertEqual(states, {"free", "stick", "slip"} & states | {"stick", "slip"})

    def test_on_a_body_that_the_trace_moves(self):
        turning = DATA / "scenes" / "turntable.csv"
        found = rows("replay", "--trace", turning, "--body", "trace", "--patch", "rectangle:x=0.02,y=0.01", *self.SPRINGS)
        self.assertIn("slip", {row["state"] for row in found})

    def test_bad_usage(self):
        rectangle = ("--patch", "rectangle:x=0.02,y=0.01")
        for more, part in (((), "--law and --patch"), ((*rectangle, "--law", "hertz"), "--law and --patch"),
                           ((*rectangle, "--radius-law", "constant:a=1"), "--radius-law"), ((*rectangle, "--moment-coefficient", 1), "--moment-coefficient"),
                           ((*rectangle, "--projection", "radial"), "--projection"), ((*rectangle, "--boundary", "box"), "--boundary"),
                           ((*rectangle, "--surface", "box:x=1,y=1,z=1", "--body", "free:mass=1"), "fixed or trace"),
                           ((*rectangle, "--point-radius", 1e-9), "point_radius"),
                           (("--law", "hertz", "--radius-law", "constant:a=1", "--point-radius", 1), "--point-radius")):
            done = run(*self.TRACE, *self.SPRINGS, *more)
            self.assertEqual(done.returncode, 2, more)
            self.assertIn(part, done.stderr)


if __name__ == "__main__":
    unittest.main()
