# SPDX-License-Identifier: MIT
"""report: one page with its figures. The report stays in the folder LIMITCURVE_REPORT, if that is named, for tests that need a whole one."""

import csv
import json
import math
import re
import shutil
import subprocess
import unittest

from command_line import REPORT, CommandLineTest, run


class ReportPage(CommandLineTest):
    def test_the_page(self):
        if subprocess.run(["/usr/bin/python3", "-c", "import matplotlib"], capture_output=True, check=False).returncode != 0:
            self.skipTest("no matplotlib")
        out = REPORT or self.directory / "out"
        shutil.rmtree(out, ignore_errors=True)
        done = run("report", "-o", out)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("index.html", done.stdout)
        page = (out / "index.html").read_text()
        self.assertIn("</html>", page)
        # Self-contained: it loads nothing. What its charts answer is tested in a browser, by tests/site/test_report.py.
        self.assertNotRegex(page, r"<(script|link|img)[^>]+(src|href)=(?!\"data:)")
        numbers = json.loads(re.search(r'<script type="application/json" id="numbers">(.*?)</script>', page)[1])
        with open(out / "curves.csv", newline="", encoding="utf-8") as file:
            hertz = [row for row in csv.DictReader(file) if row["law"] == "hertz"]
        self.assertEqual(numbers["laws"]["curves"][0]["moment"], [float(f"{float(row['moment']):.10g}") for row in hertz])
        self.assertTrue((out / "limit_curves.svg").exists())
        self.assert_one_meaning_of_lost(page, out)
        # Each figure says what to do about it; a number without an error has none on the page.
        self.assertEqual(page.count('<p class="use">'), page.count("<figure "))
        self.assertRegex(page, r"<td>chi_squared_per_n</td><td[^>]*>[\d.]+</td><td>–</td>")

    def assert_one_meaning_of_lost(self, page, out):
        """The angles on the page are those at which the block is lost, as in the map."""
        turned = {}
        with open(out / "pivot.csv", newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                if row["grip"] == "release" and float(row["grip_slip"]) >= 0.005:
                    turned.setdefault(row["case"], math.degrees(float(row["angle"])))
        said = re.search(r"by ([\d.]+)° and ([\d.]+)° when it has slid 5 mm past", page)
        # A row is 10 ms after the one before it.
        self.assertAlmostEqual(float(said[1]), turned["coupled"], delta=0.5)
        self.assertAlmostEqual(float(said[2]), turned["exact"], delta=0.5)
        self.assertIn("when it has slid 5 mm past the grip and is lost, over the offset", page)


if __name__ == "__main__":
    unittest.main()
