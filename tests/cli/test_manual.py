# SPDX-License-Identifier: MIT
"""The man page and the completions have every subcommand and every option of --help."""

import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from command_line import EXECUTABLE, CommandLineTest, run, subcommands

MANUAL = Path(__file__).resolve().parents[2] / "cli" / "manual.py"


def options(*subcommand):
    """Every word with a dash that begins a line of --help-all, and those after its commas."""
    return [name for line in re.findall(r"(?m)^  (-\S+)", run(*subcommand, "--help-all").stdout) for name in line.split(",")]


def models():
    return re.search(r"MODEL (\S+)", run("fit", "--help").stdout)[1].split("|")


class Made(CommandLineTest):
    def setUp(self):
        super().setUp()
        subprocess.run([sys.executable, "-B", MANUAL, EXECUTABLE, self.directory], check=True)


class ManPage(Made):
    def setUp(self):
        super().setUp()
        if not shutil.which("groff"):
            self.skipTest("without groff")
        for width in 80, 200:  # neither has anything to complain of; a wide page is what the tests read
            done = subprocess.run(["groff", "-man", "-ww", "-Kutf8", "-Tutf8", "-P-cbou", f"-rLL={width}n", self.directory / "limitcurve.1"],
                                  capture_output=True, encoding="utf-8", check=True)
            self.assertEqual(done.stderr, "")
        self.page = done.stdout

    def test_every_subcommand_has_its_options(self):
        sections = {}
        for line in self.page.split("\nSUBCOMMANDS\n")[1].splitlines():
            if match := re.fullmatch(r"   (\S+)", line):
                name = match[1]
                sections[name] = []
            elif line.strip():
                sections[name].append(line.strip())
        self.assertEqual(list(sections), subcommands())
        for name, lines in sections.items():
            stand = [word.rstrip(",") for line in lines if line.startswith("-") for word in line.split() if word.startswith("-")]
            self.assertTrue(set(options(name)) <= set(stand), f"{name}: {set(options(name)) - set(stand)}")

    def test_every_word_of_help_stands_in_it(self):
        """Text, notes and examples: only the line breaks differ."""
        def words(text):
            return set(re.findall(r"\w[\w.]*\w", text)) - {"Usage", "OPTIONS", "Options", "Positionals", "Required", "Rare"}

        for name in subcommands():
            self.assertEqual(words(run(name, "--help-all").stdout) - words(self.page), set(), name)


class Bash(Made):
    def setUp(self):
        super().setUp()
        if not shutil.which("bash"):
            self.skipTest("without bash")

    def offered(self, *words):
        """The completions of bash for the last word."""
        script = '. ./limitcurve.bash; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _limitcurve 2>&1; printf "%s\\n" "${COMPREPLY[@]}"'
        done = subprocess.run(["bash", "-uc", script, "bash", "limitcurve", *words], cwd=self.directory, capture_output=True, text=True, check=True)
        self.assertEqual(done.stderr, "")
        return done.stdout.split()

    def test_every_subcommand_and_option(self):
        self.assertEqual(set(self.offered("")), set(subcommands()) | set(options()))
        for name in subcommands():
            self.assertEqual(set(self.offered(name, "-")), set(options(name)), name)

    def test_what_an_option_takes(self):
        for call, expected in [("replay --curve", "exact table ellipse box"), ("replay --projection", "radial c-curve closest-point"),
                               ("pivot --material", "rayon suede sandpaper"), ("laws --format", "table csv json")]:
            self.assertEqual(self.offered(*call.split(), ""), expected.split())
        if "translate" in subcommands():
            self.assertLessEqual({"mujoco", "isaac-lab", "dex-net"}, set(self.offered("translate", "--engine", "")))
        self.assertEqual(self.offered("replay", "--details", "--pro"), ["--projection"])
        self.assertEqual(self.offered("fit", "el"), ["ellipse"])
        self.assertEqual(set(self.offered("fit", "")), set(models()) | set(options("fit")))
        self.assertEqual(self.offered("eval", "--law", "he") + self.offered("validate", "--law", "he"), ["hertz"] * 2)
        self.assertEqual(self.offered("eval", "--law", "pow"), ["power:"])
        self.assertEqual(self.offered("eval", "--c", ""), [])  # numbers; bash itself offers files
        self.assertEqual(self.offered("nonsense", ""), [])

    def test_every_law_is_offered(self):
        laws = [row.split(",")[0].strip('"').split(":")[0] for row in run("laws").stdout.splitlines()[1:]]
        self.assertLessEqual(set(laws), {law.rstrip(":") for law in self.offered("curve", "--law", "")})


class Zsh(Made):
    """The arguments of _arguments and _describe, from a zsh with functions that print in place of its completion system."""

    def setUp(self):
        super().setUp()
        if not shutil.which("zsh"):
            self.skipTest("without zsh")

    def called(self, *words):
        script = '_arguments() { print -rl -- "$@" }; _describe() { print -rl -- "${(@P)2}" }; words=("$@"); CURRENT=$#; . ./_limitcurve'
        done = subprocess.run(["zsh", "-fc", script, "zsh", "limitcurve", *words], cwd=self.directory, capture_output=True, encoding="utf-8", check=True)
        self.assertEqual(done.stderr, "")
        return done.stdout

    def test_every_subcommand_and_option(self):
        self.assertEqual(re.findall(r"(?m)^([a-z-]+):", self.called("")), subcommands())
        for name in subcommands():
            self.assertEqual(set(re.findall(r"(?m)^\*(-[^\[]+)\[", self.called(name, ""))), set(options(name)), name)
        self.assertIn(":(table csv json)", self.called("laws", ""))


if __name__ == "__main__":
    unittest.main()
