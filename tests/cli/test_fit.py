# SPDX-License-Identifier: MIT
"""fit: fits find the parameters of synthetic data; bad and insufficient data are refused."""

import math
import random
import runpy
import shlex
import unittest
from pathlib import Path

from command_line import DATA, CommandLineTest, rows, run, table


class Fit(CommandLineTest):
    def slips(self, law, mu=0.7, radius=0.005, noise=0.0):
        """Points of the exact curves at three loads, from a sensor with this relative noise."""
        generator = random.Random(1997)
        points = rows("p-curves", "--law", law, "--radius-law", f"constant:a={radius}", "--mu", mu, "--loads", "1,2,5",
                      "--points", "15")
        noisy = lambda value: value * (1 + noise * generator.gauss(0, 1))
        return self.csv("slips.csv", "load,force,moment",
                        [(row["load"], noisy(row["force"]), noisy(row["moment"])) for row in points])

    def fitted(self, *arguments):
        done = self.succeed("fit", *arguments)
        self.assertEqual(done.stdout.splitlines()[0], "parameter,value,std_error,unit,note")
        return {row["parameter"]: row["value"] for row in table(done.stdout)}, done.stderr

    # Table 1's claim that mu_r/mu_l does not depend on the material: its deviations are of single measurements, and it
    # does not say how many.
    def test_what_a_standard_deviation_can_tell(self):
        table = [(7.39, 0.91), (6.37, 0.88), (6.20, 1.54)]
        weights = [1 / sd**2 for _, sd in table]
        mean = sum(weight * ratio for weight, (ratio, _) in zip(weights, table)) / sum(weights)
        chi_squared = sum(((ratio - mean) / sd) ** 2 for ratio, sd in table)
        self.assertEqual((round(mean, 2), round(chi_squared, 2)), (6.77, 0.81))
        found = {row["parameter"]: row for row in rows("fit", "ratio", "--quiet", "--data", DATA / "materials.csv")}
        self.assertEqual(list(found), ["ratio", "radius", "chi_squared_per_n", "degrees_of_freedom", "n_for_p_0.05"])
        self.assert_close(found["ratio"]["value"], 1e-3 * mean, 1e-14)
        self.assert_close(found["radius"]["value"], 1e-3 * mean * 16 / (3 * math.pi), 1e-14)
        self.assertEqual((found["ratio"]["std_error"], found["radius"]["std_error"]), ("", ""))
        self.assert_close(found["chi_squared_per_n"]["value"], chi_squared, 1e-12)
        # Of two degrees of freedom chi squared is exponential: p = exp(-n chi_squared/2).
        self.assert_close(found["n_for_p_0.05"]["value"], -2 * math.log(0.05) / chi_squared, 1e-12)
        for n, p in [(1, 0.67), (8, 0.04), (10, 0.02)]:
            data = self.csv("n.csv", "ratio,ratio_sd,n", [(1e-3 * ratio, 1e-3 * sd, n) for ratio, sd in table])
            told, _ = self.fitted("ratio", "--quiet", "--data", data)
            self.assertEqual(list(told), ["ratio", "radius", "chi_squared", "degrees_of_freedom", "p_value"])
            self.assertEqual(round(told["p_value"], 2), p)
        # Through a pipe; two that no one ratio explains.
        text = (DATA / "materials.csv").read_text()
        call = ["fit", "ratio", "--quiet", "--law", "uniform", "--data"]
        self.assertEqual(run(*call, "-", input=text).stdout, run(*call, DATA / "materials.csv").stdout)
        two = self.csv("two.csv", "n,ratio_sd,ratio", [(1, 0.001, 0.006), (1, 0.001, 0.012)])
        done = self.succeed("fit", "ratio", "--data", two)
        self.assertRegex(done.stderr, r"warning: the ratios differ by more than their standard errors explain")

    def test_rows_that_stick_are_warned_of(self):
        # Huber's loss said mu = 0.6635 +- 0.0050 for 0.75, without a word.
        for loss in ("squared", "huber", "cauchy"):
            said = self.fitted("ratio", "--loss", loss, "--data", DATA / "fit" / "sensor_log.csv")[1]
            self.assertIn("of 2000 rows lie inside the curve", said)
        self.assertNotIn("inside", self.fitted("ratio", "--loss", "huber", "--data", DATA / "fit" / "slips.csv")[1])

    def renamed(self, source, names, factors):
        """A copy of a file with other names of columns, and numbers in other units."""
        found = table(Path(source).read_text())
        text = [",".join(names.get(name, name) for name in found[0])]
        text += [",".join(repr(cell * factors[name]) if name in factors else str(cell) for name, cell in row.items())
                 for row in found]
        return self.file("renamed.csv", "\n".join(text) + "\n")

    def test_columns_and_units_of_the_file(self):
        every = dict.fromkeys(("load", "force", "moment", "sigma_force", "sigma_moment"), 1e3)
        pushes = {"moment": 100, "dx": 1e3, "dy": 1e3, "dtheta": 180 / math.pi}
        for model, source, factors, units in ((["ratio"], "fit/slips.csv", every, "force=mN,moment=Nmm"),
                                              (["load"], "fit/radii.csv", dict.fromkeys(
                                                  ("radius", "sigma_radius"), 1e3), "length=mm"),
                                              (["ratio"], "materials.csv", dict.fromkeys(("ratio", "ratio_sd"), 100),
                                               "length=cm"),
                                              (["friction", "--patch",
                                                f"points:{DATA}/measured/tripod_hardboard_a_points.csv"],
                                               "measured/tripod_hardboard_a.csv", pushes,
                                               "length=mm,moment=Ncm,angle=deg")):
            own = rows("fit", *model, "--quiet", "--data", DATA / source)
            names = {name: "Raw " + name.upper() for name in factors}
            other = self.renamed(DATA / source, names, factors)
            listed = ",".join(f"{name}={to}" for name, to in names.items())
            found = rows("fit", *model, "--quiet", "--data", other, "--columns", listed, "--units", units)
            for one, same in zip(own, found, strict=True):
                self.assertEqual(one["parameter"], same["parameter"])
                self.assert_close(same["value"], one["value"], 1e-6)
                if isinstance(one["std_error"], float):
                    self.assert_close(same["std_error"], one["std_error"], 1e-5)

    def test_a_fit_to_a_curve_has_no_standard_errors(self):
        for criterion in ["least-squares", "minimax", "inner"]:
            for row in rows("fit", "ellipse", "--law", "hertz", "--criterion", criterion, "--quiet"):
                self.assertEqual(row["std_error"], "", row)

    def growing(self, law):
        points = rows("c-curves", "--law", law, "--radius-law", "power:c=0.00435,gamma=0.257", "--mu", "0.7", "--cors",
                      "0.0005,0.001,0.002,0.003,0.005,0.007,0.01,0.02", "--loads", "0.5,1,1.5,2,3,4,5,6,8,10")
        return self.csv("growing.csv", "load,force,moment", [(r["load"], r["force"], r["moment"]) for r in points])

    def test_a_log_as_a_sensor_gives_it_needs_no_marks(self):
        maker = runpy.run_path(str(DATA / "fit" / "make_sensor_log.py"))
        data = DATA / "fit" / "wrench_log.csv"
        names = ["field.wrench." + name for name in maker["AXES"]]
        columns = ("--columns", f"load=-{names[2]},force={':'.join(names[:2])},moment={':'.join(names)}")
        log = ("--law", "hertz", "--data", data, "--least-load", "0.5", "--zero", *columns)
        for model in ("ratio", "law"):
            done = run("fit", model, *log, "--loss", "edge")
            found = {row["parameter"]: row for row in table(done.stdout)}
            for name, true in (("mu", 0.6), ("mu_r", 0.00141395)):
                self.assertAlmostEqual(found[name]["value"], true, delta=2 * found[name]["std_error"])
                self.assertLess(found[name]["std_error"], 0.03 * true)
            self.assertIn("pauses, field.wrench.force.z", done.stderr)
            self.assertIn("rows have a blank in a used column, and are left out", done.stderr)
            self.assertNotIn("extrapolated", done.stderr)
            self.assertNotIn("assumes", done.stderr)
            self.assertNotIn("warning", done.stderr)
        turned = run("fit", "law", *log[:-1], columns[1].replace("-", ""), "--loss", "edge")
        self.assertIn("Is the load's sign right", turned.stderr)
        # Of a sensor 3 degrees off the normal each way to slide has another edge.
        cosine, sine = math.cos(math.radians(3)), math.sin(math.radians(3))
        head, *body = [line.split(",") for line in data.read_text().splitlines() if not line.startswith("#")]
        for row in body:
            for x, z in ((0, 2), (3, 5)):
                i, j = head.index(names[x]), head.index(names[z])
                if row[i] and row[j]:
                    a, b = float(row[i]), float(row[j])
                    row[i], row[j] = str(a * cosine + b * sine), str(b * cosine - a * sine)
        tilted = self.file("tilted.csv", "\n".join(map(",".join, [head, *body])))
        said = run("fit", "ratio", *log[:2], "--data", tilted, *log[4:], "--loss", "edge").stderr
        self.assertIn("the edge is blurred", said)
        self.assertNotIn("limitcurve hold", said)
        self.assert_fails(2, "needs standard deviations: --zero", "fit", "ratio", *log[:6], *columns, "--loss", "edge",
                          "--quiet")

    def test_gross_outliers_are_named_by_row_under_every_loss(self):
        lines = self.slips("hertz", noise=0.01).read_text().splitlines()
        for row, factor in ((4, 10), (17, 0.3), (30, 2)):
            load, force, moment = map(float, lines[row].split(","))
            lines[row] = f"{load},{force * factor},{moment * factor}"
        data = self.file("outliers.csv", "\n".join(lines))
        for model in ("ellipse", "law", "ratio"):
            _, said = self.fitted(model, "--data", data)
            self.assertIn("warning: rows 5, 18, 31 (by line of the file) lie far off the curve", said)

    def test_every_row_notes_the_model_and_what_was_assumed(self):
        data = self.growing("uniform")
        pushes = self.file(
            "pushes.csv",
            "force_x,force_y,moment,dx,dy,dtheta\n" + "0.5,0,0,0.01,0,0\n0.6,0,0,0.01,0,0\n0.55,0,0,0.01,0,0\n")
        square = ["friction", "--patch", "rectangle:x=0.1,y=0.1", "--data", pushes]
        laws = len(rows("laws")) - 2  # neither a mixture nor uniform-wear, whose pressure is like 1/rho
        for call, noted in [
            (["ellipse", "--law", "hertz"], "least-squares to the exact curve of hertz"),
            (square, "rectangle:x=0.1,y=0.1; few rows: a 95 % interval is +- 4.3 std_error"),
            (["ratio", "--data", data, "--gamma",
              "0.257"], "hertz; gamma = 0.257 assumed; squared loss; errors proportional to the load assumed"),
            (["law", "--data", data, "--fit-gamma", "--loss", "huber"],
             f"uniform (best of {laws} laws by AIC; the errors include the choice, but for n and k); gamma fitted; "
             "huber loss; errors proportional to the load assumed"
             )
        ]:
            self.assertEqual({row["note"] for row in rows("fit", *call, "--quiet")}, {noted})

    def test_what_is_said_to_be_typed_can_be_typed(self):
        """The largest moment of a replay with the options given is that of the data: mu m0 P a(P) under 4 N."""
        data = self.growing("uniform")
        trace = self.trace((i, 0, 0, -0.004, i) for i in range(7))
        said = self.fitted("law", "--fit-gamma", "--data", data)[1]
        self.assertRegex(said.splitlines()[-1], r"\.mu = 0\.\d+, \.mu_r = 0\.\d+, \.gamma = 0\.2")
        typed = said.splitlines()[-1].split("for replay: ")[1].split(";")[0].split()
        end = rows("replay", "--trace", trace, *typed, "--stiffness", "1000", "--twist-stiffness", "0.04")[-1]
        self.assert_close(end["moment"], -0.7 * 2 / 3 * 4 * 0.00435 * 4 ** 0.257, 5e-6)
        own = self.csv("my law.csv", "radius,pressure", [(i / 20, 1) for i in range(21)])
        # The whole line: each row is a slip, so that it holds up to the scatter.
        renamed = self.renamed(data, {"load": "F'z"}, {})
        quoted = self.file("it's a $file.csv", data.read_text())
        # hold knows no standard deviations.
        noisy = self.file("noisy.csv", (DATA / "fit" / "slips.csv").read_text().replace("sigma_", "own_"))
        sigmas = ["--columns", "sigma_force=own_force,sigma_moment=own_moment"]
        for call, slips in ((["ellipse", "--fit-gamma", "--loss", "cauchy", *sigmas], noisy),
                            (["law", "--law", "uniform", "--fit-gamma", "--columns", "load=F'z", "--units", "force=N"],
                             renamed), (["law", "--law", f"samples:{own}", "--gamma", "0.257"], quoted)):
            line, = (line for line in self.fitted(*call, "--data", slips)[1].splitlines()
                     if "for the load that" in line)
            command, *typed = shlex.split(line[line.index("limitcurve hold"):])
            margins = [row["margin"] for row in rows(*typed)]
            self.assertEqual(command, "limitcurve")
            self.assertLess(sum(margins) / len(margins), 0.1, call)
        for call, slips, instead in ((["law", "--law", "uniform"], data, "--fit-gamma"),
                                     (["ratio", "--law", "uniform"], data, "--fit-gamma"),
                                     (["ellipse"], data, "--fit-gamma"),
                                     (["load", "--load-model", "linear"], DATA / "fit" / "radii.csv",
                                      "--load-model power --loss cauchy")):
            self.assertIn(f"the data reject this model, so no parameters are suggested; try again with {instead}\n",
                          self.fitted(*call, "--data", slips)[1])
        self.assertIn("--largest-radius has no effect on a radius that grows with the load",
                      self.fitted("law", "--law", "uniform", "--gamma", "0.257", "--largest-radius", "0.001", "--data",
                                  data)[1])

    def test_residuals_are_distances_in_standard_deviations(self):
        """Slips on the curve, but for one that is 7 standard deviations outside and one that is 4 inside."""
        text = self.slips("hertz").read_text().splitlines()
        slips = [f"{line},0.002,1e-5" for line in text[1:]
                 ] + ["2,1.414,0,0.002,1e-5", f"2,0,{1.4 * 0.005 * 3 * math.pi / 16 - 4e-5!r},0.002,1e-5"]
        data = self.file("slips.csv", "\n".join([text[0] + ",sigma_force,sigma_moment", *slips]) + "\n")
        for model in (["law", "--law", "hertz"], ["law"]):
            found = [
                row["residual"]
                for row in rows("fit", *model, "--data", data, "--loss", "cauchy", "--quiet", "--residuals")
            ]
            self.assertEqual(len(found), len(slips))
            for residual, expected in zip(found, [0] * (len(slips) - 2) + [7, -4]):
                self.assertAlmostEqual(residual, expected, delta=0.25)


if __name__ == "__main__":
    unittest.main()
