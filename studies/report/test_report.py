# SPDX-License-Identifier: MIT
"""The report, from the source tree and the executable alone: its data, its page without the figures, which scripts/demo
draws, and what ends it early. The whole page is tested in a browser, by tests/site/test_report.py.

    LIMITCURVE=EXECUTABLE LIMITCURVE_DATA=data PYTHONPATH=tests/cli python3 -B studies/report/test_report.py"""

import os
import resource
import shutil
import subprocess
import unittest

from command_line import DATA, EXECUTABLE, CommandLineTest, run, table

PYTHON = "/usr/bin/python3"  # Debian's own: another that is first on the PATH may lack matplotlib


def called(*arguments, flags=(), program=("-m", "report"), **options):
    return run(*arguments, command=[PYTHON, "-B", *flags, *program],
               env={**os.environ, "PYTHONPATH": str(DATA.parent / "studies")}, **options)


def report(folder, *flags, command=EXECUTABLE, **options):
    return called("--command", command, "-o", folder, flags=flags, **options)


@unittest.skipIf(
    subprocess.run([PYTHON, "-c", "import matplotlib"], capture_output=True, check=False).returncode, "no matplotlib")
class Report(CommandLineTest):
    def read(self, name):
        return table((self.directory / f"{name}.csv").read_text(encoding="utf-8"))

    def test_data_and_words(self):
        undrawn = ("from report import __main__, page; page.picture = lambda data, draw, name: ('<svg />', ()); "
                   "__main__.main()")
        done = report(self.directory, program=("-c", undrawn))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("index.html", done.stdout)
        self.assertEqual({entry.suffix
                          for entry in self.directory.iterdir()}, {".csv", ".html"})  # nothing hidden is left
        self.check_data()
        page = (self.directory / "index.html").read_text(encoding="utf-8")
        self.assertIn("</html>", page)
        # Self-contained: it loads nothing, and is the same wherever it was made.
        self.assertNotRegex(page, r"<(script|link|img)[^>]+(src|href)=(?!\"data:)")
        for text in [page, *(path.read_text(encoding="utf-8") for path in self.directory.glob("*.csv"))]:
            self.assertNotIn(str(DATA), text)
        # Each figure says what to do about it; a number without an error has none on the page.
        self.assertEqual(page.count('<p class="use">'), page.count("<figure "))
        self.assertRegex(page, r"<td>chi_squared_per_n</td><td[^>]*>[\d.]+</td><td>–</td>")
        for name in ("Fig. 1", "Fig. 2", "Fig. 3", "Fig. 4", "Fig. 5", "Figs. 7 to 11"):  # of the paper
            self.assertIn(name, page)

    def check_data(self):
        for path in self.directory.glob("*.csv"):
            for row in table(path.read_text(encoding="utf-8"), lambda cell: cell):  # of another length than the header
                self.assertFalse(None in row or None in row.values(), path)
        for row in self.read("materials"):
            self.assertTrue((self.directory / row["file"]).exists())
        for row in self.read("tables"):
            self.assertLessEqual(row["checked_error"], row["tolerance"])
        for row in self.read("table_error"):
            self.assertLessEqual(max(abs(row["force_error"]), abs(row["moment_error"])), row["tolerance"])
        for row in self.read("steady_twist"):
            if (row["boundary"], row["projection"]) == ("table", "closest-point"):
                self.assertLess(row["error"], 1e-7)

    def assert_ends(self, told, folder, *flags, limit=None, **options):
        bounded = limit and (lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        done = report(folder, *flags, preexec_fn=bounded, **options)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, r"\Areport: error: [^\n]+\n\Z")
        for text in told:
            self.assertIn(text, done.stderr)

    def test_what_it_cannot_do_is_one_line(self):
        out = self.directory / "out"
        self.assert_ends(["matplotlib is missing", "python3-matplotlib"], out, "-S")  # no packages
        self.assertFalse(out.exists())
        self.assert_ends(["taken", "File exists"], self.file("taken", ""))
        self.assert_ends(["below", "Not a directory"], self.directory / "taken" / "below")
        self.assert_ends(["curves.csv", "File too large"], out, limit=4096)  # as a disk that fills
        self.assertEqual([path.name for path in out.iterdir()], ["laws.csv"])
        self.assert_ends(["cannot run '/no-such-command'", "No such file"], out, command="/no-such-command")
        self.assert_ends(["false laws", "exit status 1"], out, command="/bin/false")
        self.assertEqual(called().returncode, 2)

    def test_librsvg_draws_the_figures_of_the_pages(self):
        # It sets the parts of a text on top of each other: a formula is a path.
        docs = DATA.parent / "docs"
        for path in [*docs.glob("*.svg"), *docs.glob("stability/*.svg")]:
            self.assertNotIn("<tspan", path.read_text(encoding="utf-8"), path)
            if shutil.which("rsvg-convert"):
                drawn = subprocess.run(["rsvg-convert", path], capture_output=True, check=True)
                self.assertEqual((drawn.stdout[:4], drawn.stderr), (b"\x89PNG", b""), path)


if __name__ == "__main__":
    unittest.main()
