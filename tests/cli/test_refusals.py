# SPDX-License-Identifier: MIT
"""Help, outputs that fail, and refusals.txt: wrong command lines, each with exit 2 and one line that has what stands
behind its `->`.

An indented line completes the last line that begins at the margin; {a b} stands for either word, $NAME for the words of
`NAME = …`, @FILE for a file of the text behind `<<`.
"""

import re
import shlex
import unittest
from pathlib import Path

from command_line import DATA, CommandLineTest, run


def each(text):
    """The texts with one word of every {}."""
    part = re.search(r"\{([^{}]*)\}", text)
    if not part:
        return [text]
    return [one for word in part[1].split(" ") for one in each(text[:part.start()] + word + text[part.end():])]


def refusals():
    """Words, content of a file, and texts of the error."""
    names, begin = {"DATA": shlex.quote(str(DATA))}, ""
    for line in Path(__file__).with_name("refusals.txt").read_text(encoding="utf-8").splitlines():
        line = re.sub(r"\$([A-Z]+)", lambda name: names[name[1]], line)
        if name := re.fullmatch(r"([A-Z]+) = (.*)", line):
            names[name[1]] = name[2]
        elif line.startswith("  "):
            call, told = line.split(" -> ")
            call, _, content = call.partition(" <<")
            for words in each(begin + call):
                yield words, content, told.split(" & ")
        elif not line.startswith("#"):
            begin = line


class Refusals(CommandLineTest):
    def test_each_is_one_line_that_says_why(self):
        for words, content, told in refusals():
            with self.subTest(words=words, content=content):
                for name in re.findall(r"@([^,]*?\.[a-z]+)", words):
                    self.file(name, content.lstrip(" ").encode().decode("unicode_escape").encode("latin-1"))
                    words = words.replace("@" + name, name)
                self.assert_fails(2, told, *shlex.split(words), cwd=self.directory)


class Usage(CommandLineTest):
    def test_help_and_version_succeed(self):
        for arguments in [["--help"], ["--version"], ["-V"], ["help"], ["eval", "--help"], ["help", "eval"],
                          ["laws", "--help"]]:
            done = run(*arguments)
            self.assertEqual((done.returncode, done.stderr), (0, ""), arguments)
            self.assertTrue(done.stdout)
        bare = run()
        self.assertEqual((bare.returncode, bare.stdout, bare.stderr), (2, "", run("--help").stdout))

    def test_rare_options_are_shown_on_request(self):
        usual, whole = (run("replay", way).stdout for way in ("--help", "--help-all"))
        self.assertTrue("--rest-margin" in whole and "--rest-margin" not in usual)
        self.assertLessEqual(usual.count("\n"), 45)

    def test_a_line_break_in_an_argument_stays_on_one_line(self):
        self.assert_fails(2, "--law", "eval", "--law", "he\nrtz", "--c", "1")


class Outputs(CommandLineTest):
    def test_a_full_disk(self):
        for arguments in [["curve", "--law", "hertz", "--points", "20000"], ["laws"], ["laws", "--format", "json"],
                          ["--help"]]:
            with open("/dev/full", "wb") as full:
                self.assert_fails(1, ["standard output", "No space left"], *arguments, stdout=full)


if __name__ == "__main__":
    unittest.main()
