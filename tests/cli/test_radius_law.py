# SPDX-License-Identifier: MIT
"""Radius laws that are hardly in metres, or used beyond their samples, are warned of: on standard error, once, exit status 0."""

import unittest

from command_line import CommandLineTest, run


class RadiusLaws(CommandLineTest):
    def uses(self, radius_law, loads):
        """Every use of a radius law, and what it says on standard error."""
        low, high = loads
        trace = self.directory / "trace.csv"
        # 1000 N/m: a millimetre is a newton.
        trace.write_text("time,x,y,z,twist\n" + "".join(f"{i / 1000},0,0,{-load / 1000},0\n" for i, load in enumerate([low, high])))
        common = ["--law", "hertz", "--radius-law", radius_law, "--mu", "0.5"]
        for arguments in [["p-curves", *common, "--loads", f"0,{low},{high}"],
                          ["c-curves", *common, "--loads", f"{low},{high}", "--cors", "0,0.001,inf"],
                          ["translate", *common, "--load", low, "--loads", f"{low},{high}"],
                          ["choose", *common, "--tolerance", "0.5", "--scene", "--loads", f"{low},{high}"],
                          ["replay", *common, "--trace", trace, "--stiffness", "1000", "--twist-stiffness", "0.04"]]:
            done = run(*arguments)
            self.assertEqual(done.returncode, 0, done.stderr)
            yield arguments[0], [line for line in done.stderr.splitlines() if "warning" in line]

    def samples(self, text):
        path = self.directory / "radii.csv"
        path.write_text("load,radius\n" + text)
        return f"samples:{path}"

    def test_millimetres(self):
        # Issue 9, point 12.
        for law in ["constant:a=5", "hertz:R=8000,E=0.2", "power:c=2.07,gamma=0.259", self.samples("0.5,4\n4,6\n")]:
            for name, warnings in self.uses(law, (1, 2)):
                self.assertEqual(len(warnings), 1, name)
                self.assertIn("in metres?", warnings[0], name)

    def test_metres(self):
        for law in ["constant:a=0.005", "constant:a=0.1", "hertz:R=0.008,E=2e5", self.samples("1,0.004\n2,0.005\n")]:
            for name, warnings in self.uses(law, (1, 2)):
                self.assertEqual(warnings, [], name)

    def test_beyond_the_samples(self):
        # Issue 9, point 5.
        law = self.samples("1,0.004\n2,0.005\n4,0.006\n")
        for loads in [(0.5, 3), (1.5, 4.5), (0.1, 9)]:
            for name, warnings in self.uses(law, loads):
                self.assertEqual(len(warnings), 1, name)
                self.assertIn("extrapolated: its samples have loads from 1 to 4 N", warnings[0], name)

    def test_millimetres_in_what_is_fitted(self):
        path = self.directory / "measured.csv"
        for scale, expected in [(1, 1), (1e-3, 0)]:
            path.write_text("load,radius\n" + "".join(f"{load},{scale * 4 * load ** 0.3}\n" for load in [1, 2, 4, 8]))
            for model in ["linear", "power", "best"]:
                self.assertEqual(run("fit", "load", "--data", path, "--load-model", model).stderr.count("in metres?"), expected, model)
            # mu 0.5; moments of a Hertz contact.
            path.write_text("load,force,moment\n" + "".join(
                f"{load},{0.5 * load * f},{0.5 * load * scale * 5 * m}\n" for load in [1, 2, 4] for f, m in [(0, 0.589), (1, 0), (0.86, 0.234)]))
            self.assertEqual(run("fit", "ratio", "--data", path).stderr.count("in metres?"), expected)

    def test_samples_are_named_where_laws_are(self):
        self.assert_fails(2, ["samples:FILE.csv"], "eval", "--law", "herz", "--c", "1")
        self.assert_fails(2, ["samples:FILE.csv"], "p-curves", "--law", "hertz", "--radius-law", "konstant:a=1", "--mu", "1", "--loads", "1")
        for subcommand in ["laws", "eval", "curve", "p-curves", "c-curves", "table", "validate", "choose", "fit", "translate", "replay", "pivot"]:
            self.assertIn("samples:FILE.csv", run(subcommand, "--help").stdout, subcommand)


if __name__ == "__main__":
    unittest.main()
