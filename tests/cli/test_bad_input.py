# SPDX-License-Identifier: MIT
"""Wrong usage, bad input, and outputs that fail: the exit status, and one line that names the place."""

import subprocess
import unittest

from command_line import EXECUTABLE, CommandLineTest, run, subcommands

EVAL = ["eval", "--law", "hertz", "--c", "1"]


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

    def test_wrong_usage(self):
        self.assert_fails(2, ["--foo", "eval"], "--foo")
        self.assert_fails(2, ["'evil'", "eval"], "evil")
        self.assert_fails(2, ["--law", "eval --help"], "eval", "--c", "1")
        self.assert_fails(2, "--c is required", "eval", "--law", "hertz")
        self.assert_fails(2, "--trace, --mu, --stiffness, --twist-stiffness are required", "replay", "--law", "hertz")
        self.assert_fails(2, "--c", "eval", "--law", "hertz", "--c")
        self.assert_fails(2, "--sea", *EVAL, "--sea", "1")
        self.assert_fails(2, "extra", *EVAL, "extra")
        self.assert_fails(2, "--c", *EVAL, "--c", "2")
        self.assert_fails(2, ["--format", "xml", "csv"], *EVAL, "--format", "xml")
        self.assert_fails(2, ["--points", "1", "2"], "curve", "--law", "hertz", "--points", "1")
        self.assert_fails(2, ["--points", "2.5"], "curve", "--law", "hertz", "--points", "2.5")

    def test_unknown_options_stand_in_the_order_typed(self):
        self.assert_fails(2, "not expected: --zeta 1 --alpha 2 rest (", *EVAL, "--zeta", "1", "--alpha", "2", "rest")

    def test_keys_that_were_meant(self):
        for option, text, meant in (("--law", "gaussian:sgima=2", "sigma"), ("--law", "power:N=2", "n"),
                                    ("--radius-law", "power:c=1,gama=.2", "gamma"),
                                    ("--radius-law", "hertz:r=1,E=1", "R"), ("--radius-law", "constant:A=1", "a")):
            law = [] if option == "--law" else ["--law", "hertz"]
            self.assert_fails(2, f"did you mean '{meant}'?", "p-curves", *law,
                              *([] if law else ["--radius-law", "constant:a=1"]), "--mu", "1", "--loads", "1", option,
                              text)
        self.assert_fails(2, "did you mean 'x'?", "patch", "--patch", "rectangle:X=1,y=1", "--twists", "none.csv")
        self.assert_fails(2, "did you mean 'radius'?", "replay", "--trace", "none.csv", "--surface", "sphere:radus=1")

    def test_a_line_break_in_an_argument_stays_on_one_line(self):
        self.assert_fails(2, "--law", "eval", "--law", "he\nrtz", "--c", "1")


class Laws(CommandLineTest):
    def test_malformed_or_out_of_range(self):
        for law in ["", "herz", "power:n=2.3x", "power:n=-1"]:
            self.assert_fails(2, ["--law", f"'{law}'", "expected"], "eval", "--law", law, "--c", "1")
        for law in ["samples", "samples:"]:
            self.assert_fails(2, ["--law", f"'{law}'", "expected samples:FILE.csv"], "eval", "--law", law, "--c", "1")
        self.assert_fails(2, ["--law", "'herz'", "expected"], "eval", "--law", "mix:0.5*herz+0.5*hertz", "--c", "1")
        for law in ["", "constant:a=0", "power:c=1,gamma=0.2x"]:
            self.assert_fails(2, ["--radius-law", law, "expected"], "p-curves", "--law", "hertz", "--radius-law", law,
                              "--mu", "1", "--loads", "1")

    def test_a_method_the_law_lacks(self):
        self.assert_fails(2, ["xydas-kao:k=3", "closed", "auto, ring"], "eval", "--law", "xydas-kao:k=3", "--c", "1",
                          "--method", "closed")
        self.assert_fails(2, ["flat-punch", "'punch'"], "eval", "--law", "flat-punch", "--c", "1", "--method", "punch")
        self.assert_fails(2, ["--method", "magic"], *EVAL, "--method", "magic")


class Numbers(CommandLineTest):
    def test_distances(self):
        for text, item in [("", 1), (",", 1), ("1,", 2), (",1", 1), ("1,,2", 2), ("nan", 1), ("1,2,x", 3), ("1;2", 1),
                           ("1 2", 1), ("0x1", 1)]:
            self.assert_fails(2, ["--c", f"item {item}", "expected"], "eval", "--law", "hertz", "--c", text)

    def test_scales(self):
        for option in ["--radius", "--load", "--mu"]:
            for value in ["-1", "nan", "-nan", "inf", "", "1x", "one"]:
                self.assert_fails(2, [option, "expected"], *EVAL, option, value)
        self.assert_fails(2, "--radius", *EVAL, "--radius", "0")
        self.assert_fails(2, "too large", *EVAL, "--load", "1e308", "--mu", "100")

    def test_a_sample_that_the_library_refuses_has_its_line(self):
        profile = self.file("my sample 9.csv", "# c\nradius,pressure\n0,1\n\n2,0.5\n1,0.4\n3,0.2\n4,0\n")
        self.assert_fails(2, ["my sample 9.csv:6:1: ", "sample 3"], "eval", "--law", f"samples:{profile}", "--c", "1")
        patch = ["hold", "--mu", "1", "--force", "1,0", "--moment", "0", "--patch"]
        self.assert_fails(2, ["bow.csv:2:1: ", "vertex 1"], *patch,
                          f"polygon:{self.file('bow.csv', chr(10).join(('x,y', '0,0', '1,1', '1,0', '0,1')))}")
        self.assert_fails(2, ["far.csv:3:1: ", "point 2"], *patch,
                          f"points:{self.file('far.csv', chr(10).join(('x,y,load', '0,0,1', '0,1e101,1')))}")

    def test_loads_and_centres(self):
        curves = ["--law", "hertz", "--radius-law", "constant:a=0.005", "--mu", "0.5"]
        for value in ["-1", "nan", "inf", "1,,2", ""]:
            self.assert_fails(2, ["--loads", "item"], "p-curves", *curves, "--loads", value)
            self.assert_fails(2, ["--loads", "item"], "c-curves", *curves, "--cors", "1", "--loads", value)
        for value in ["-1", "nan", "1,,2"]:
            self.assert_fails(2, ["--cors", "item"], "c-curves", *curves, "--cors", value, "--loads", "1")
        self.assert_fails(2, "--mu", "p-curves", *curves[:-1], "-0.5", "--loads", "1")
        self.assert_fails(2, ["load = 1e+308 N", "product"], "p-curves", *curves[:-1], "2", "--loads", "1e308")
        self.assert_fails(2, ["load = 1e+308 N", "product"], "c-curves", *curves[:-1], "2", "--cors", "inf", "--loads",
                          "1e308")


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


class OtherFiles(CommandLineTest):
    """A file that is not CSV text with commas is called what it is, by every command that reads columns."""

    COLUMNS = {
        "ratio": "load,force,moment",
        "law": "load,force,moment",
        "load": "load,radius",
        "trace": "time,x,y,z,twist",
        "twists": "vx,vy,omega",
        "profile": "radius,pressure",
        "radii": "load,radius",
        "points": "x,y,load",
        "image": None
    }

    def setUp(self):
        super().setUp()
        if run("fit", "--help").returncode != 0:
            self.skipTest("a build without fits, which read most of these files")

    def command(self, kind, path):
        return {
            "ratio": ["fit", "ratio", "--law", "hertz", "--data", path],
            "law": ["fit", "law", "--data", path],
            "load": ["fit", "load", "--data", path],
            "trace": [
                "replay", "--trace", path, "--law", "hertz", "--radius-law", "constant:a=0.005", "--mu", "0.5",
                "--stiffness", "1", "--twist-stiffness", "1"
            ],
            "twists": ["patch", "--patch", "rectangle:x=0.1,y=0.1", "--twists", path],
            "profile": ["eval", "--law", f"samples:{path}", "--c", "1"],
            "radii": ["p-curves", "--law", "hertz", "--radius-law", f"samples:{path}", "--mu", "1", "--loads", "1"],
            "points": ["validate", "--patch", f"points:{path}"],
            "image": ["validate", "--patch", f"image:{path},pixel=0.001"]
        }[kind]

    def test_other_separators(self):
        for kind, columns in self.COLUMNS.items():
            for separator, said in ((";", "semicolons"), ("\t", "tabs"), (" ", "spaces")):
                row = "1,2,3,4,5" if columns is None else columns
                path = self.file("data.csv", f"{row}\n1,2,3,4,5\n".replace(",", separator))
                with self.subTest(kind=kind, separator=separator):
                    self.assert_fails(2, [":1:1: ", f"separated by {said}, expected commas"], *self.command(kind, path))

    def test_decimal_commas(self):
        for kind, columns in self.COLUMNS.items():
            if columns is None:
                continue
            fields = columns.count(",") + 1
            for row, said in ((",".join(["1,5"] * fields), "decimal commas"),
                              (",".join(['"1,5"'] * fields), "decimal comma,"), (";".join(["1,5"] * fields),
                                                                                 "expected")):
                with self.subTest(kind=kind, row=row):
                    self.assert_fails(2, [":2:", said], *self.command(kind,
                                                                      self.file("data.csv", f"{columns}\n{row}\n")))

    def test_files_that_are_no_text(self):
        for kind, columns in self.COLUMNS.items():
            text = f"{columns or '1,2'}\n1,2,3\n"
            for content, said in ((b"\x93NUMPY\x01\x00v\x00{'descr'", "NumPy"), (text.encode("utf-16"), "UTF-16"),
                                  (text.encode("utf-16-be"), "UTF-8"), (b"PK\x03\x04\x14\x00", "spreadsheet")):
                path = self.file("data.csv", "")
                path.write_bytes(content)
                with self.subTest(kind=kind, said=said):
                    self.assert_fails(2, [":1:1: ", said], *self.command(kind, path))

    def test_the_header_that_is_expected_is_said(self):
        for text in ("", "a,b\n1,2\n"):
            self.assert_fails(2, "expected a header line with load,force,moment or ratio",
                              *self.command("ratio", self.file("data.csv", text)))

    def test_a_damaged_column_of_a_table(self):
        table = self.file("table.json", "")
        run("table", "--law", "hertz", "--tolerance", "1e-3", "-o", table)
        text = table.read_text()
        for damaged in (text.replace('"moment"', '"momend"', 1), text.replace('"columns"', '"colums"',
                                                                              1), text.replace('"c0", ', "", 1)):
            self.assertNotEqual(damaged, text)
            table.write_text(damaged)
            self.assert_fails(2, [f"{table}: ", "columns"], "lookup", "--table", table, "--c", "1")


if __name__ == "__main__":
    unittest.main()
