# SPDX-License-Identifier: MIT
"""report: one page with its figures."""

import subprocess
import unittest

from command_line import CommandLineTest, run


class ReportPage(CommandLineTest):
    def test_the_page(self):
        if subprocess.run(["/usr/bin/python3", "-c", "import matplotlib"], capture_output=True, check=False).returncode != 0:
            self.skipTest("no matplotlib")
        done = run("report", "-o", self.directory / "out")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("index.html", done.stdout)
        page = (self.directory / "out" / "index.html").read_text()
        self.assertIn("</html>", page)
        # Self-contained: it loads nothing.
        self.assertNotRegex(page, r"<(script|link|img)[^>]+(src|href)=")
        self.assertTrue((self.directory / "out" / "limit_curves.svg").exists())


if __name__ == "__main__":
    unittest.main()
