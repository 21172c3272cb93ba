# SPDX-License-Identifier: MIT
"""Wrong usage, bad input, and outputs that fail: the exit status, and one line that names the place."""

import subprocess
import unittest

from command_line import EXECUTABLE, CommandLineTest, run

EVAL = ["eval", "--law", "hertz", "--c", "1"]


class Usage(CommandLineTest):
    def test_help_and_version_succeed(self):
        for arguments in [["--help"], ["--version"], ["eval", "--help"], ["laws", "--help"]]:
            done = run(*arguments)
            self.assertEqual((done.returncode, done.stderr), (0, ""), arguments)
            self.assertTrue(done.stdout)

    def test_every_subcommand_has_an_example(self):
        listed = run("--help").stdout.split("Subcommands:\n")[1].split("\n\n")[0]
        names = [line.split()[0] for line in listed.splitlines() if line.startswith("  ") and line[2] != " "]
        self.assertIn("eval", names)
        for name in names:
            self.assertIn(f"Example:\n  limitcurve {name}", run(name, "--help").stdout)

    def test_wrong_usage(self):
        self.assert_fails(2, ["no subcommand", "eval"])
        self.assert_fails(2, ["--foo", "eval"], "--foo")
        self.assert_fails(2, ["'evil'", "eval"], "evil")
        self.assert_fails(2, ["--law", "eval --help"], "eval", "--c", "1")
        self.assert_fails(2, "--c", "eval", "--law", "hertz")
        self.assert_fails(2, "--c", "eval", "--law", "hertz", "--c")
        self.assert_fails(2, "--sea", *EVAL, "--sea", "1")
        self.assert_fails(2, "extra", *EVAL, "extra")
        self.assert_fails(2, "--c", *EVAL, "--c", "2")
        self.assert_fails(2, ["--format", "xml", "csv"], *EVAL, "--format", "xml")
        self.assert_fails(2, ["--points", "1", "2"], "curve", "--law", "hertz", "--points", "1")
        self.assert_fails(2, ["--points", "2.5"], "curve", "--law", "hertz", "--points", "2.5")

    def test_a_line_break_in_an_argument_stays_on_one_line(self):
        self.assert_fails(2, "--law", "eval", "--law", "he\nrtz", "--c", "1")


class Laws(CommandLineTest):
    def test_unknown_or_malformed(self):
        for law in ["herz", "", "hertz ", "hertz:", "hertz:n=1", "power", "power:", "power:n", "power:n=", "power:k=2", "power:n=2.3x",
                    "power:n=2.3,k=1", "xydas-kao:k=3 ", "mix:", "mix:hertz", "mix:0.5*hertz+", "Hertz"]:
            self.assert_fails(2, ["--law", f"'{law}'", "expected"], "eval", "--law", law, "--c", "1")
        for law in ["samples", "samples:"]:
            self.assert_fails(2, ["--law", f"'{law}'", "expected samples:FILE.csv"], "eval", "--law", law, "--c", "1")
        self.assert_fails(2, ["--law", "'herz'", "expected"], "eval", "--law", "mix:0.5*herz+0.5*hertz", "--c", "1")

    def test_parameters_out_of_range(self):
        for law in ["power:n=-1", "power:n=-2", "power:n=nan", "power:n=inf", "xydas-kao:k=0", "xydas-kao:k=-3", "xydas-kao:k=nan",
                    "gaussian:sigma=0", "gaussian:sigma=-1", "gaussian:sigma=nan", "mix:-1*hertz+2*uniform"]:
            self.assert_fails(2, ["--law", law, "expected"], "eval", "--law", law, "--c", "1")

    def test_radius_laws(self):
        for law in ["", "constant", "constant:a=", "constant:a=0", "constant:a=-1", "constant:a=nan", "constant:r=1", "hertz:R=0.008",
                    "hertz:R=0.008,E=0", "hertz:R=-1,E=1", "power:c=1,gamma=2", "power:c=0,gamma=0.2", "power:c=1,gamma=0.2x",
                    "linear:a=1"]:
            self.assert_fails(2, ["--radius-law", law, "expected"], "p-curves", "--law", "hertz", "--radius-law", law, "--mu", "1", "--loads",
                              "1")

    def test_a_method_the_law_lacks(self):
        self.assert_fails(2, ["xydas-kao:k=3", "closed", "auto, ring"], "eval", "--law", "xydas-kao:k=3", "--c", "1", "--method", "closed")
        self.assert_fails(2, ["flat-punch", "'punch'"], "eval", "--law", "flat-punch", "--c", "1", "--method", "punch")
        self.assert_fails(2, ["--method", "magic"], *EVAL, "--method", "magic")


class Numbers(CommandLineTest):
    def test_distances(self):
        for text, item in [("", 1), (",", 1), ("1,", 2), (",1", 1), ("1,,2", 2), ("1,-1", 2), ("nan", 1), ("-inf", 1), ("1,2,x", 3), ("1;2", 1),
                           ("1 2", 1), ("0x1", 1), ("-1e-300", 1)]:
            self.assert_fails(2, ["--c", f"item {item}", "expected"], "eval", "--law", "hertz", "--c", text)

    def test_scales(self):
        for option in ["--radius", "--load", "--mu"]:
            for value in ["-1", "nan", "-nan", "inf", "", "1x", "one"]:
                self.assert_fails(2, [option, "expected"], *EVAL, option, value)
        self.assert_fails(2, "--radius", *EVAL, "--radius", "0")
        self.assert_fails(2, "too large", *EVAL, "--load", "1e308", "--mu", "100")

    def test_loads_and_centres(self):
        curves = ["--law", "hertz", "--radius-law", "constant:a=0.005", "--mu", "0.5"]
        for value in ["-1", "nan", "inf", "1,,2", ""]:
            self.assert_fails(2, ["--loads", "item"], "p-curves", *curves, "--loads", value)
            self.assert_fails(2, ["--loads", "item"], "c-curves", *curves, "--cors", "1", "--loads", value)
        for value in ["-1", "nan", "1,,2"]:
            self.assert_fails(2, ["--cors", "item"], "c-curves", *curves, "--cors", value, "--loads", "1")
        self.assert_fails(2, "--mu", "p-curves", *curves[:-1], "-0.5", "--loads", "1")
        self.assert_fails(2, ["load = 1e+308 N", "product"], "p-curves", *curves[:-1], "2", "--loads", "1e308")
        self.assert_fails(2, ["load = 1e+308 N", "product"], "c-curves", *curves[:-1], "2", "--cors", "inf", "--loads", "1e308")


class Outputs(CommandLineTest):
    def test_a_full_disk(self):
        for arguments in [["curve", "--law", "hertz", "--points", "20000"], ["laws"], ["laws", "--format", "json"], ["--help"]]:
            with open("/dev/full", "wb") as full:
                done = subprocess.run([EXECUTABLE, *arguments], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, r"\Alimitcurve: error: [^\n]*standard output[^\n]*No space left[^\n]*\n\Z")

    def test_a_closed_pipe(self):
        with subprocess.Popen([EXECUTABLE, "curve", "--law", "hertz", "--points", "200000"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True) as process:
            process.stdout.readline()
            process.stdout.close()
            complaint = process.stderr.read()
        self.assertEqual(process.returncode, 1)
        self.assertRegex(complaint, r"\Alimitcurve: error: [^\n]*standard output[^\n]*\n\Z")


if __name__ == "__main__":
    unittest.main()
