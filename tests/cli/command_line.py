# SPDX-License-Identifier: MIT
"""Calls the limitcurve executable and reads its output."""

import csv
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

EXECUTABLE = os.environ["LIMITCURVE"]
DATA = Path(os.environ["LIMITCURVE_DATA"])

UNIT_QUESTION = re.compile(
    r"(?m)^limitcurve: warning: .*(must be in metres|unusual for a finger|has an arm|mean degrees|in degrees, add).*\n")
# What is said of a job that takes long: how long that is depends on the machine.
PROGRESS = re.compile(r"(?m)^limitcurve: [a-z-]+: (\d+ %, )?\d+ s\n")


def number_or_text(text):
    try:
        return float(text)
    except ValueError:
        return text


# A Hertz finger of 6 mm on its springs, and one that is to get its moment's limit by --mu-r.
FINGER = [
    "--law", "hertz", "--radius-law", "constant:a=0.006", "--mu", "0.6", "--stiffness", "1000", "--twist-stiffness",
    "0.036"
]
MEASURED = FINGER[:2] + FINGER[4:]


def run(*arguments, command=(EXECUTABLE, ), **options):
    """The finished process, with its texts, but for lines of progress. A test that fits is skipped where the executable
    cannot."""
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
    done = subprocess.run([*command, *map(str, arguments)], text=True, timeout=600, check=False, **pipes)
    if "has no 'fit'" in done.stderr:
        raise unittest.SkipTest("without Ceres")
    done.stderr = PROGRESS.sub("", done.stderr)
    return done


def rows(*arguments, remark=""):
    """The table of a successful call. Standard error may only have the remark, or ask for a unit (test_units.py)."""
    done = run(*arguments)
    if done.returncode != 0 or (remark not in done.stderr if remark else UNIT_QUESTION.sub("", done.stderr)):
        raise AssertionError(f"{arguments}: exit {done.returncode}, {done.stderr}")
    return table(done.stdout)


def table(text, convert=number_or_text):
    """The rows of a CSV, as dictionaries with converted cells."""
    lines = (line for line in text.splitlines() if not line.startswith("#"))
    return [{name: convert(value) for name, value in row.items()} for row in csv.DictReader(lines)]


def data(name, convert=number_or_text):
    return table((DATA / name).read_text(encoding="utf-8"), convert)


def header(*arguments):
    return run(*arguments).stdout.split("\n", 1)[0]


def subcommands():
    """The names in the groups of --help."""
    return re.findall(r"(?m)^  ([a-z]\S*)", run("--help").stdout)


def numbers(values):
    """A list for --c and similar options, with exact numbers."""
    return ",".join(repr(float(value)) for value in values)


class CommandLineTest(unittest.TestCase):
    """Tests in a directory of their own; a file left behind is an error."""

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = Path(directory.name)

    def file(self, name, text):
        path = self.directory / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def csv(self, name, columns, lines):
        """A file of columns, with lines of numbers."""
        return self.file(name, columns + "\n" + "".join(",".join(map(repr, line)) + "\n" for line in lines))

    def trace(self, samples, name="trace.csv"):
        return self.csv(name, "time,x,y,z,twist", samples)

    def succeed(self, *arguments, **options):
        done = run(*arguments, **options)
        self.assertEqual(done.returncode, 0, f"{arguments}: {done.stderr}")
        return done

    def assert_fails(self, status, told, *arguments, **options):
        """Expects exit `status`, and one line on standard error with all texts of `told`."""
        done = run(*arguments, **options)
        context = f"{arguments}: {done.stderr!r}"
        self.assertEqual((done.returncode, done.stdout or ""), (status, ""), context)
        self.assertRegex(done.stderr, r"\Alimitcurve: error: [^\n]+\n\Z", context)
        for text in [told] if isinstance(told, str) else told:
            self.assertIn(text, done.stderr, context)

    def assert_close(self, value, expected, relative, context=""):
        self.assertLessEqual(abs(value - expected), relative * abs(expected),
                             f"{value!r}, expected {expected!r} {context}")
