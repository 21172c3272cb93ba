# SPDX-License-Identifier: MIT
"""Wrong usage, bad input, and outputs that fail: the exit status, and one line that names the place."""

import subprocess
import unittest

from command_line import EXECUTABLE, CommandLineTest, run, subcommands



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

    def test_every_subcommand_has_an_example(self):
        names = subcommands()
        self.assertIn("eval", names)
        for name in names:
            self.assertIn(f"Example:\n  limitcurve {name}", run(name, "--help").stdout)

    def test_a_line_break_in_an_argument_stays_on_one_line(self):
        self.assert_fails(2, "--law", "eval", "--law", "he\nrtz", "--c", "1")


class Outputs(CommandLineTest):
    def test_a_full_disk(self):
        for arguments in [["curve", "--law", "hertz", "--points", "20000"], ["laws"], ["laws", "--format", "json"],
                          ["--help"]]:
            with open("/dev/full", "wb") as full:
                done = subprocess.run([EXECUTABLE, *arguments],
                                      stdout=full,
                                      stderr=subprocess.PIPE,
                                      text=True,
                                      check=False)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, r"\Alimitcurve: error: [^\n]*standard output[^\n]*No space left[^\n]*\n\Z")


if __name__ == "__main__":
    unittest.main()
