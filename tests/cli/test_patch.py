# SPDX-License-Identifier: MIT
"""Contacts that are not round: `patch`. References are made here, by sums and quadrature."""

import csv
import io
import math
import os
import re
import subprocess
import unittest

from command_line import DATA, EXECUTABLE, header, rows, run
from patch_case import PatchCase, by_points



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
                            ("columns=31,frame=1", "a row of 384 pixels"), ("columns=384,frame=1", "of several rows"),
                            ("columns=1.5", "whole number"), ("frame=1", "only with columns=N")):
            self.refused(f"image:{log},pixel=0.002,{wrong}", told)

    def test_tables(self):
        """The door: a file of either form gives the wrenches of its table, everywhere where a patch is taken."""
        pad = "ellipse:law=cone,a=0.004,b=0.003"
        twists = (1.0, 0.0, 0.0), (0.0, 0.0, 2.0), (1e-3, 2e-3, 1.0), (-1e-3, 0.0, 0.3)
        found = []
        for form in ("csv", "json"):
            file = self.folder / f"pad.{form}"
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
        self.refused(f"table:{self.file('cut.csv', (self.folder / 'pad.csv').read_bytes()[:-9])}", "cut.csv:")

    def test_half_spaces(self):
        """The door's columns; the round contact of `curve` is the ellipse of `patch`. What they keep is asserted in
        half_spaces_test.cpp."""
        call = ["patch", "--patch", "rectangle:x=0.2,y=0.1", "--half-spaces"]
        self.assertEqual(header(*call, "14"), "kind,fx,fy,moment,share")
        found = rows(*call, "20")
        self.assertEqual([sum(row["kind"] == kind for row in found) for kind in ("row", "vertex")], [14, 18])
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
                                  cwd=self.folder,
                                  env={**os.environ, "PATH": path},
                                  capture_output=True,
                                  text=True,
                                  check=True)
            row, = csv.DictReader(io.StringIO(done.stdout))
            formula, number = answer.split(" = ")
            for found in (row[column.strip("`")], value_of(formula, problem)):
                self.assertAlmostEqual(float(found) / float(number), 1, delta=5e-4, msg=problem)

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
        self.refused(f"image:{self.file('bad.asf', header + 'Frame 1' + chr(10) + '1,x,3' + chr(10))}", "bad.asf:9",
                     "'x'")
        self.refused(
            f"image:{self.file('ragged.asf', header + 'Frame 1' + chr(10) + '1,2,3' + chr(10) + '1,2' + chr(10))}",
            "ragged.asf:10", "expected 3")
        self.refused(f"image:{self.file('inch.asf', header.replace('4.0 mm', '4.0 in') + frames)},frame=1",
                     "inch.asf:5", "in mm")

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
                        b'\xef\xbb\xbf# corners\r\n"y",note,x\r\n0,a,0\r\n\r\n0,"b, c",2\r\n1,c,0\r\n0,a,0\r\n')
        self.assertEqual(self.wrenches(f"polygon:{plain}", (1.0, 0.2, 0.3)),
                         self.wrenches(f"polygon:{odd}", (1.0, 0.2, 0.3)))
        image = self.file("image.csv", b"\xef\xbb\xbf1, 2\r\n\r\n3,4\r\n")
        plain = self.file("plain_image.csv", "1,2\n3,4\n")
        self.assertEqual(self.wrenches(f"image:{plain},pixel=1", (1.0, 0.2, 0.3)),
                         self.wrenches(f"image:{image},pixel=1", (1.0, 0.2, 0.3)))


class Slip(PatchCase):
    def slips(self, contact, columns, wrenches):
        data = self.file("wrenches.csv",
                         columns + "\n" +"".join(",".join(map(repr, wrench)) + "\n" for wrench in wrenches))
        return rows("patch", *contact, "--wrenches", data)

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
        point = f"points:{self.file('one.csv', 'x,y,load' + chr(10) + '0.1,0.2,3' + chr(10))}"
        zero, turned, held = self.of(point, (0.0, 0.0, 0.0), (0.0, 0.0, -1e-3), (0.3, 0.7, 0.01))
        self.assertEqual((zero["hold_load"], turned["hold_load"]), (0, math.inf))
        for row in (zero, turned, *self.slips(
            ("--law", "hertz", "--radius-law", "constant:a=1"), "force,moment", [(0.0, 0.0)])):
            self.assertTrue(
                all(
                    math.isnan(value)
                    for name, value in row.items()
                    if name in ("vx", "vy", "omega", "slide", "spin", "error")), row)
        self.assertAlmostEqual(0.3 * held["vx"] + 0.7 * held["vy"], 1, delta=1e-14)


if __name__ == "__main__":
    unittest.main()
