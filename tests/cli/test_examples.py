# SPDX-License-Identifier: MIT
"""The examples of --help and of the pages of docs/ run as they stand, and the columns of cli/README.md are those of the
command."""

import re
import shlex
import unittest
from pathlib import Path

from command_line import DATA, CommandLineTest, header, run, subcommands

ROOT = Path(__file__).resolve().parents[2]


def example(name):
    """The arguments of the example of a subcommand's help."""
    return shlex.split(run(name, "--help").stdout.split("Example:\n")[1].split("\n\n")[0])


def page_examples(page):
    """The lines of a page's ```sh blocks that run the command, continued lines joined."""
    blocks = re.findall(r"^(?:[^\n]*not run[^\n]*\n)?```sh\n(.*?)^```", page.read_text(encoding="utf-8"), re.M | re.S)
    lines = "".join(blocks).replace("\\\n", " ").splitlines()
    return [re.sub(r"\s+# .*", "", line) for line in lines if line.startswith("limitcurve ")]


class Examples(CommandLineTest):
    def setUp(self):
        super().setUp()
        run("fit", "--help")  # without it skips: pages and contract have it
        (self.directory / "data").symlink_to(DATA)

    def typed(self, line):
        words = shlex.split(line)
        self.assertEqual(words[0], "limitcurve")
        self.assertTrue(self.succeed(*words[1:], cwd=self.directory).stdout)

    def test_help(self):
        for name in subcommands():
            self.assertEqual(example(name)[:2], ["limitcurve", name])
            self.typed(shlex.join(example(name)))

    def test_pages(self):
        examples = [line for page in sorted((ROOT / "docs").glob("*.md")) for line in page_examples(page)]
        self.assertGreater(len(examples), 20)
        for line in examples:
            self.typed(line)

    def test_the_papers_page(self):
        """Commands in its tables; a word in capitals stands for words."""
        text = (ROOT / "docs" / "paper.md").read_text(encoding="utf-8")
        words = dict(re.findall(r'(?m)^([A-Z]+)="([^"]+)"$', text))
        lines = "\n".join(re.findall(r"(?m)^\| .*", text))
        calls = set(re.findall(r"`((?:limitcurve|\$SLIDE) [^`]+)`", lines))
        self.assertGreater(len(calls), 10)
        for call in sorted(calls):
            while "$" in call:
                call = re.sub(r"\$([A-Z]+)", lambda name: words[name[1]], call)
            self.typed(call)

    def test_the_columns_of_the_contract(self):
        contract = dict(
            re.findall(r"^\| `([a-z-]+)` \| `([a-z_,]+)` \|",
                       (ROOT / "cli" / "README.md").read_text(encoding="utf-8"), re.M))
        self.assertEqual(set(contract), set(subcommands()))
        for name, columns in contract.items():
            arguments = [word.replace("data/", f"{DATA}/") for word in example(name)[1:]]
            if name in ("table", "lookup"):
                place = arguments.index("-o" if name == "table" else "--table") + 1
                arguments[place] = str(self.directory / "hertz.csv")
            self.assertEqual(header(*arguments), columns, name)


if __name__ == "__main__":
    unittest.main()
