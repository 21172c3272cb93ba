# SPDX-License-Identifier: MIT
"""fit and translate: parameters come back from the curves they made; bad and silent data are refused."""

import random
import unittest

from command_line import CommandLineTest, header, rows, run


class Fit(CommandLineTest):
    def slips(self, law, mu=0.7, radius=0.005, noise=0.0):
        """Points of the exact curves at three loads, as a sensor with this relative noise would see them."""
        generator = random.Random(1997)
        points = rows("p-curves", "--law", law, "--radius-law", f"constant:a={radius}", "--mu", mu, "--loads", "1,2,5", "--points", "15")
        lines = ["load,force,moment"]
        for row in points:
            force, moment = (row[name] * (1 + noise * generator.gauss(0, 1)) for name in ("force", "moment"))
            lines.append(f"{row['load']!r},{force!r},{moment!r}")
        return self.file("slips.csv", "\n".join(lines) + "\n")

    def fitted(self, *arguments):
        done = run("fit", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = [line.split(",") for line in done.stdout.splitlines()]
        self.assertEqual(lines[0], ["parameter", "value", "std_error", "unit"])
        return {name: float(value) for name, value, _, _ in lines[1:]}, done.stderr

    def test_columns(self):
        self.assertEqual(header("fit", "ellipse", "--law", "hertz"), "parameter,value,std_error,unit")

    def test_the_exact_curve(self):
        ellipse, _ = self.fitted("ellipse", "--law", "hertz")
        self.assertTrue(0.95 < ellipse["force_max"] < 1)
        for law, exponent, kappa in [("hertz", 1.725, 3.142), ("uniform", 1.702, 3.261)]:
            self.assertAlmostEqual(self.fitted("superellipse", "--law", law, "--criterion", "minimax")[0]["exponent"], exponent, delta=5e-4)
            self.assertAlmostEqual(self.fitted("quartic", "--law", law, "--criterion", "minimax")[0]["kappa"], kappa, delta=5e-4)
        through = self.fitted("ellipse", "--law", "uniform", "--criterion", "intercepts")[0]
        self.assertEqual(through, {"force_max": 1, "moment_max": 2 / 3})

    def test_the_ellipse_of_validate_is_that_of_fit(self):
        validated = next(row for row in rows("validate", "--law", "cone") if row["model"] == "ellipse-least-squares")
        self.assertEqual(self.fitted("ellipse", "--law", "cone")[0]["force_max"], validated["parameter"])

    def test_ratio_and_radius_come_back(self):
        found, _ = self.fitted("ratio", "--law", "uniform", "--data", self.slips("uniform"))
        self.assert_close(found["mu"], 0.7, 1e-8)
        self.assert_close(found["radius"], 0.005, 1e-8)
        self.assert_close(found["ratio"], 0.005 * 2 / 3, 1e-8)
        self.assert_close(found["mu_r"], 0.7 * 0.005 * 2 / 3, 1e-8)

    def test_the_law_is_told(self):
        for law in ["flat-punch", "uniform", "parabolic"]:
            found, said = self.fitted("law", "--data", self.slips(law, noise=1e-3))
            self.assertIn(f"note: the model is {law}\n", said)
            self.assert_close(found["radius"], 0.005, 2e-3)

    def test_how_a_radius_grows(self):
        lines = ["load,radius"] + [f"{load},{0.00207 * load ** 0.259!r}" for load in (0.5, 1, 2, 3, 5, 8)]
        found, _ = self.fitted("load", "--data", self.file("radii.csv", "\n".join(lines)))
        self.assert_close(found["c"], 0.00207, 1e-8)
        self.assert_close(found["gamma"], 0.259, 1e-8)
        fixed, _ = self.fitted("load", "--load-model", "hertz", "--data", self.directory / "radii.csv")
        self.assertEqual(fixed["gamma"], 1 / 3)
        moments = self.file("moments.csv", "load,moment\n1,0.002\n2,0.005\n4,0.0125\n8,0.03125\n16,0.08\n")
        self.assertIn("mu_r", self.fitted("load", "--data", moments)[0])

    def test_wrong_usage(self):
        data = self.slips("hertz")
        self.assert_fails(2, "MODEL", "fit")
        self.assert_fails(2, ["MODEL", "circle", "ellipse|"], "fit", "circle", "--law", "hertz")
        self.assert_fails(2, "--data", "fit", "ratio", "--law", "hertz")
        self.assert_fails(2, "--law", "fit", "ellipse")
        self.assert_fails(2, ["inner", "minimax"], "fit", "quartic", "--law", "hertz", "--criterion", "inner")
        self.assert_fails(2, ["--loss"], "fit", "ellipse", "--data", data, "--loss", "fair")
        self.assert_fails(2, ["absent.csv"], "fit", "ellipse", "--data", self.directory / "absent.csv")

    def test_bad_data(self):
        for text, told in [
            ("load,force\n1,1\n", "'moment'"),
            ("load,force,moment\n", "no rows"),
            ("load,force,moment\n1,1,1\n2,2", "bad.csv:3:4: a line of 2 fields"),
            ("load,force,moment\n1,nan,1\n", "bad.csv:2:3: column 'force'"),
            ("load,force,moment\n0,1,1\n", "bad.csv:2:1: column 'load'"),
            ("load,force,moment,sigma_force\n1,1,1,1\n", "sigma_moment"),
            ("load,force,moment,sigma_force,sigma_moment\n1,1,1,0.1,0\n", "bad.csv:2:11: column 'sigma_moment'"),
        ]:
            self.assert_fails(2, told, "fit", "ellipse", "--data", self.file("bad.csv", text))
        self.assert_fails(2, "radius and moment", "fit", "load", "--data", self.file("bad.csv", "load,radius,moment\n1,1,1\n"))
        self.assert_fails(2, "radius and moment", "fit", "load", "--data", self.file("bad.csv", "load,force\n1,1\n"))

    def test_what_the_data_cannot_tell(self):
        for text in ["load,force,moment\n1,0.5,0.001\n", "load,force,moment\n1,0.5,0\n2,1,0\n3,1.5,0\n",
                     "load,force,moment\n1,0,0.001\n2,0,0.002\n3,0,0.003\n"]:
            done = run("fit", "ellipse", "--data", self.file("silent.csv", text))
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("limitcurve: error: ", done.stderr)


class Translate(CommandLineTest):
    CONTACT = ["translate", "--law", "uniform", "--radius-law", "power:c=0.002,gamma=0.25", "--mu", "0.8", "--load", "16"]

    def test_every_engine_gets_both_limits(self):
        self.assertEqual(header(*self.CONTACT), "engine,parameter,value,unit,model,max_error")
        found = rows(*self.CONTACT)
        self.assertEqual({row["engine"] for row in found}, {"mujoco", "chrono", "gazebo", "physx", "bullet", "ode"})
        coefficients = {(row["engine"], row["parameter"]): row["value"] for row in found}
        self.assertEqual(coefficients["mujoco", "geom.friction[0]"], 0.8)
        # mu m0 a(P), a = 4 mm
        self.assert_close(coefficients["mujoco", "geom.friction[1]"], 0.8 * 2 / 3 * 0.004, 1e-14)
        errors = {row["model"]: row["max_error"] for row in found}
        self.assertAlmostEqual(errors["ellipse"], 0.0704, delta=5e-5)
        self.assertAlmostEqual(errors["box"], 0.512, delta=1e-3)

    def test_explained_on_standard_error(self):
        done = run(*self.CONTACT, "--explain")
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stdout, run(*self.CONTACT).stdout)
        self.assertTrue(all(line.startswith("limitcurve: note: ") for line in done.stderr.splitlines()))
        self.assertIn("mujoco", done.stderr)

    def test_bad_input(self):
        for option, value in [("--mu", "0"), ("--load", "0"), ("--load", "-1"), ("--mu", "nan")]:
            call = list(self.CONTACT)
            call[call.index(option) + 1] = value
            self.assert_fails(2, option, *call)
        for loads in ["1", "2,1", "0,1", "1,2,3", "1,,2"]:
            self.assert_fails(2, "--loads", *self.CONTACT, "--loads", loads)


if __name__ == "__main__":
    unittest.main()
