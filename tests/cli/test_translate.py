# SPDX-License-Identifier: MIT
"""translate: the numbers for physics engines, and what a number in an engine means."""

import subprocess
import sys
import unittest

from command_line import DATA, EXECUTABLE, CommandLineTest, data, header, rows, run


class Translate(CommandLineTest):
    CONTACT = [
        "translate", "--law", "uniform", "--radius-law", "power:c=0.002,gamma=0.25", "--mu", "0.8", "--load", "16"
    ]

    def test_every_engine_gets_both_limits(self):
        found = rows(*self.CONTACT)
        self.assertEqual({(row["engine"], row["model"]) for row in found},
                         {(row["engine"], row["model"]) for row in self.facts("engines") if row["model"] != "field"})
        coefficients = {(row["engine"], row["parameter"]): row["value"] for row in found}
        self.assertEqual(coefficients["mujoco", "geom.friction[0]"], 0.8)
        self.assert_close(coefficients["mujoco", "geom.friction[1]"], 0.8 * 2 / 3 * 0.004, 1e-14)

    def test_the_cone_is_a_row(self):
        cones = {(row["model"], row["value"], row["unit"], row["note"])
                 for row in rows(*self.CONTACT)
                 if row["parameter"] == "option.cone"}
        self.assertEqual(cones, {("ellipse", 1, 1, "elliptic"), ("diamond", 0, 1, "pyramidal")})

    @staticmethod
    def facts(name):
        return data(f"engines/{name}.csv")

    def test_every_row_says_its_formula_and_what_two_bodies_make(self):
        self.assertNotIn('"', run(*self.CONTACT).stdout)  # for readers that split at commas
        for row in rows(*self.CONTACT):
            self.assertIsInstance(row["value"], float)
            self.assertTrue(row["formula"] != "", row)
            if str(row["formula"]).startswith("mu"):
                self.assertTrue(row["two_bodies"], row)
        notes = {(row["engine"], row["parameter"]): row["note"] for row in rows(*self.CONTACT)}
        self.assertIn("value * dynamic_friction * load", notes["physx", "PxShape.minTorsionalPatchRadius"])
        self.assertIn("moment limit = value * f * load", notes["bullet", "setSpinningFriction"])
        self.assertNotIn("force", notes["gazebo", "surface/friction/torsional/coefficient"])

    def test_the_files_of_facts_agree(self):
        shapes = {(row["engine"], row["model"]) for row in self.facts("engines")}
        self.assertEqual(len(shapes), len(self.facts("engines")))
        names = [name for row in self.facts("engines") for name in row["also"].split()]
        self.assertEqual(len(names), len(set(names) - {row["engine"] for row in self.facts("engines")}))
        for row in self.facts("engines"):
            self.assertRegex(row["checked"], r"^20\d\d-\d\d-\d\d$")
            self.assertIn(row["how"], ("measured", "source", "manual"))
        known = {}
        for row in self.facts("coefficients"):
            for engine in row["engine"].split():
                self.assertIn((engine, row["model"]) if row["model"] else engine, shapes | {name for name, _ in shapes})
                for word in [*row["word"].split(), row["parameter"]]:
                    self.assertEqual(known.setdefault((engine, word), row["parameter"]), row["parameter"])
        for row in self.facts("errors"):
            self.assertTrue(row["model"] == "points" or (row["engine"], row["model"]) in shapes, row)

    @unittest.skipUnless((DATA.parent / "python").exists(), "the page has a table of lint.py")
    def test_the_page_has_what_the_files_and_the_program_say(self):
        pages = DATA.parent / "scripts" / "maintain" / "pages"
        done = subprocess.run([sys.executable, "-B", pages, EXECUTABLE, "--check", "docs/which_number.md"],
                              capture_output=True,
                              text=True,
                              check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_one_engine(self):
        every = rows(*self.CONTACT)
        for name in {row["engine"] for row in every}:
            found, errors = rows(*self.CONTACT, "--engine", name), ("max_error", "cor_error", "loads_error")
            own = [row for row in every if row["engine"] == name]
            for column in ("parameter", "value", "unit", "model", "formula"):
                self.assertEqual([row[column] for row in found if row["parameter"] not in errors],
                                 [row[column] for row in own])
            self.assertEqual({(row["model"], row["parameter"], row["value"])
                              for row in found if row["parameter"] in errors},
                             {(row["model"], error, row[error])
                              for row in own for error in errors})
            combined = [row["note"] for row in found if "two bodies: " in str(row["note"])]
            self.assertEqual(len(combined), sum(row["two_bodies"] != "" for row in own))
        self.assertEqual(rows(*self.CONTACT, "--engine", "isaac-lab"), rows(*self.CONTACT, "--engine", "isaac"))

    def test_one_engine_has_eight_columns_and_a_table_120(self):
        for more in ((), ("--loads", "4,64"), ("--mu", "0.4,0.8"), ("--loads", "4,64", "--mu", "0.4,0.8")):
            contact = [*self.CONTACT[:5], *self.CONTACT[7:], *((*more, "--mu", "0.8") if "--mu" not in more else more)]
            self.assertLessEqual(header(*contact, "--engine", "gazebo").count(","), 7)
            for engine in ((), *(("--engine", row["engine"]) for row in self.facts("engines"))):
                table = run(*contact, *engine, "--format", "table").stdout
                self.assertLessEqual(max(map(len, table.splitlines())), 120, (more, engine))

    def test_range_of_loads(self):
        """For randomisation: mu_r over the loads, which goes as the radius."""
        self.assertTrue(header(*self.CONTACT, "--loads", "4,64").endswith(",formula,two_bodies,low,high"))
        for row in rows(*self.CONTACT, "--loads", "4,64"):
            times = 2**0.5 if row["formula"] in ("mu_r", "m0 a", "16 m0 a/(3 pi)", "mu_r/f") else 1
            if "a/pi" not in str(row["formula"]) and "1000" not in str(row["formula"]):
                self.assert_close(row["low"], row["value"] / times, 1e-12)
                self.assert_close(row["high"], row["value"] * times, 1e-12)

    def test_what_a_number_means(self):
        reading = ["translate", "--law", "uniform", "--mu", "0.5", "--read"]
        self.assertEqual(header(*reading, "mujoco.torsional=0.005"),
                         "engine,parameter,value,moment_per_load,radius,note")
        row, = rows("translate", "--law", "hertz", "--mu", "1", "--read", "mujoco.torsional=0.005")
        self.assertAlmostEqual(1e3 * row["radius"], 8.5, delta=0.05)
        both = rows(*reading, "dart.friction=0.5", "--read", "ode.torsional=0.002")
        self.assertEqual([(row["engine"], row["radius"]) for row in both], [("dart", ""), ("ode", 0.006)])

    def test_names_and_attributes_as_they_stand_in_files(self):
        call = ["translate", "--law", "uniform", "--read", "mujoco.friction=1.5 0.006 0.0002"]  # friction and all
        found = rows(*call)
        self.assertIn("--mu has no effect", run(*call, "--mu", "0.5").stderr)
        self.assertEqual(run(*call[:4], "isaac.min_patch_radius=1", "--mu", "1").stderr, "")  # it counts: no warning
        self.assertEqual([(row["value"], row["moment_per_load"]) for row in found], [(1.5, ""), (0.006, 0.006),
                                                                                     (0.0002, "")])

    def test_several_frictions(self):
        call = [*self.CONTACT[:5], *self.CONTACT[7:], "--mu"]
        both = [(row.pop("mu"), row) for row in rows(*call, "0.4,1.2")]
        for mu in (0.4, 1.2):
            self.assertEqual([row for its, row in both if its == mu], rows(*call, mu))

    def test_a_measured_moment_needs_no_law(self):
        call = ["translate", "--mu", "0.5", "--mu-r", "0.002", "--load", "3"]
        self.assertIn("Hertz", run(*call).stderr)
        for found, known in zip(rows(*call, "--quiet"), rows(*call, "--law", "uniform"), strict=True):
            self.assertEqual(found["parameter"], known["parameter"])
            self.assert_close(found["value"], known["value"], 1e-14)

    def test_the_error_of_a_pressure_is_not_that_of_a_measured_moment(self):
        profile = self.csv("profile.csv", "radius,pressure", [(0, 1), (1, 0.7), (2, 0.3), (3, 0)])
        moments = self.csv("moments.csv", "load,moment", [(1, 0.001), (2, 0.0022)])
        call = ["translate", "--law", f"samples:{profile},rim=3", "--mu", "0.6", "--load", "2"]
        for moment in (["--mu-r", "0.002"], ["--radius-law", f"moments:{moments}"]):
            self.assertNotIn("its largest moment may be off", run(*call, *moment).stderr)
        self.assertIn("its largest moment may be off", run(*call, "--radius-law", "constant:a=0.005").stderr)

    def test_explained_on_standard_error(self):
        done = self.succeed(*self.CONTACT, "--explain")
        self.assertEqual(done.stdout, run(*self.CONTACT).stdout)
        self.assertTrue(all(line.startswith("limitcurve: note: ") for line in done.stderr.splitlines()))
        self.assertIn("mujoco", done.stderr)


if __name__ == "__main__":
    unittest.main()
