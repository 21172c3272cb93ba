# SPDX-License-Identifier: MIT
"""The examples of README.md and of --help run as they stand."""

import os
import re
import shlex
import subprocess
import unittest
from pathlib import Path

from command_line import DATA, EXECUTABLE, CommandLineTest, header, run

README = Path(__file__).resolve().parents[2] / "cli" / "README.md"


def subcommands():
    listed = run("--help").stdout.split("Subcommands:\n")[1].split("\n\n")[0]
    return [line.split()[0] for line in listed.splitlines() if re.match(r"  \w", line)]


def readme_examples():
    return re.findall(r"^(limitcurve [a-z-]+(?: .+)?)$", README.read_text(encoding="utf-8"), re.M)


class Examples(CommandLineTest):
    def setUp(self):
        super().setUp()
        (self.directory / "data").symlink_to(DATA)

    def succeed(self, line):
        words = shlex.split(line)
        self.assertEqual(words[0], "limitcurve")
        if words[1] == "report":
            return  # test_report.py
        done = subprocess.run([EXECUTABLE, *words[1:]], cwd=self.directory, capture_output=True, text=True, check=False, env=os.environ)
        self.assertEqual(done.returncode, 0, f"{line}: {done.stderr}")
        self.assertTrue(done.stdout)

    def test_help(self):
        for name in subcommands():
            help_text = run(name, "--help").stdout
            example = " ".join(help_text.split("Example:\n")[1].split())
            self.assertTrue(example.startswith(f"limitcurve {name}"), example)
            self.succeed(example)

    def test_readme(self):
        examples = readme_examples()
        for line in examples:
            self.succeed(line)
        self.assertEqual({shlex.split(line)[1] for line in examples}, set(subcommands()), "one example a subcommand")

    def test_the_columns_of_the_contract(self):
        for name, columns in re.findall(r"^\| `([a-z-]+)` \|[^|]+\| `([a-z_,]+)` \|$", README.read_text(encoding="utf-8"), re.M):
            example = next(line for line in readme_examples() if line.split()[1] == name and "json" not in line)
            arguments = [word.replace("data/", f"{DATA}/") for word in shlex.split(example)[1:]]
            if name == "table":
                arguments[-1] = str(self.directory / "hertz.csv")
            if name == "lookup":
                arguments[2] = str(self.directory / "hertz.csv")
            self.assertEqual(header(*arguments), columns, name)


if __name__ == "__main__":
    unittest.main()
