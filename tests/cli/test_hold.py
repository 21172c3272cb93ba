# SPDX-License-Identifier: MIT
"""hold: the least load that bears a force and a moment."""

import math
import random
import unittest

from command_line import FINGER, CommandLineTest, rows, run, table

CONTACT = ["--law", "hertz", "--radius-law", "hertz:R=0.008,E=2e5", "--mu", "0.8"]
PATCH = ["--patch", "rectangle:x=0.02,y=0.01", "--mu", "0.5"]


class Hold(CommandLineTest):
    def data(self, columns, lines):
        return self.csv("data.csv", columns, lines)

    def test_what_two_fingers_hold_level(self):
        """Each bears half the weight, and half of its moment about the grip."""
        two = rows("hold", *CONTACT, "--fingers", "2", "--mass", "0.2", "--offset", "0.02")
        self.assertEqual(two, rows("hold", *CONTACT, "--mass", "0.2", "--offset", "0.02"))
        self.assert_close(two[0]["moment"], 0.2 * 9.81 * 0.02 / 2, 1e-15)
        self.assertEqual(two,
                         rows("hold", *CONTACT, "--force", repr(two[0]["force"]), "--moment", repr(two[0]["moment"])))
        moon, = rows("hold", *CONTACT, "--fingers", "3", "--mass", "0.2", "--offset", "0.02", "--gravity", "1.62")
        self.assert_close(moon["force"], 0.2 * 1.62 / 3, 1e-15)

    def test_a_force_torque_log_as_it_comes(self):
        """The options are those of fit and replay, too."""
        log = self.file(
            "log.csv",
            'Sensor 7\n\n"gain","3"\n"t","Fx","Fy","Fz","Tz"\n0,0.01,0,0.02,0\n1,0.6,-0.8,-5.1,0.002\n2,0.3,0.4,-5,0\n')
        columns = "load=-Fz,force=Fx:Fy,moment=Tz"
        done = self.succeed("hold", *CONTACT, "--data", log, "--columns", columns, "--least-load", "0.1")
        self.assertEqual([row["force"] for row in table(done.stdout)], [1.0, 0.5])
        self.assertIn("the header is line 4", done.stderr)
        self.assertIn("1 of 3 rows have a load below 0.1, and are left out", done.stderr)
        self.assertNotIn("Fy", done.stderr)
        done = run("hold", *CONTACT, "--data", log, "--columns", columns.replace(":Fy", ""), "--least-load", "0.1")
        self.assertIn("force=Fx leaves out Fy; force=Fx:Fy is their length", done.stderr)

    def test_the_moment_is_about_the_contact_wherever_the_sensor_sits(self):
        """tests/oracle/ask has the numbers; a row with Fz = 0 is left out."""
        log = self.file("six.csv", "Fx,Fy,Fz,Tx,Ty,Tz\n1,0,-2,0,0.002,0.003\n0,0,0,1e-5,0,1e-5\n")
        found, = rows("hold", *CONTACT, "--data", log, "--columns", "force=Fx:Fy,moment=Fx:Fy:Fz:Tx:Ty:Tz", "--quiet")
        self.assert_close(abs(found["moment"]), 0.003, 1e-15)
        for columns, six in (("force=Fx:Fy,moment=Tz", "Fx:Fy:Fz:Tx:Ty:Tz"),
                             ("load=-Fz,force=Fy:Fx,moment=Ty", "Fy:Fx:Fz:Ty:Tx:Tz"), ("force=Fy:Fz,moment=Tx",
                                                                                      "Fy:Fz:Fx:Ty:Tz:Tx")):
            done = run("hold", *CONTACT, "--data", log, "--columns", columns)
            self.assertRegex(done.stderr, f"{columns[-9:]} is about the sensor's axis.* name all six: moment={six}\n")

    def test_a_zero_that_may_be_wrong_is_warned_of(self):
        generator = random.Random(8)
        ramp = [0.12 * i for i in range(26)]
        for rest, drift, sign, noise, warned in (
            (15, 0.05, 1, 0.005, ""), (0, 0, 1, 0.005, "the load changes within"),
            (5, 0, 1, 0.005, "the load changes within 5 of 6 pauses"), (300, 0, 1, 0.005, ""),
            (15, 1.5, 1, 0.005, "drifts by .*: --least-load 1.69 finds 13"),
            (15, 0.05, -1, 0.005, r"Is the load's sign right \(or load=-load\)"),
            (15, 0.05, 1, 0.25, r"scatters by 0\.2.*: add --least-load 1\.")):
            loads = ([0] * rest + ramp[1:] + [3] * 50 + ramp[:0:-1]) * 12 + [0] * rest
            if rest == 5:  # pauses so short that light grips pass for them
                loads = ([0] * 5 + [1] * 600 + [0] * 5 + [4] * 600) * 5 + [0] * 5
            if rest == 300:  # a skin that sticks pulls at each release
                loads = ([0] * 300 + [3] * 1200 + [-0.6, -0.75, -0.9, -1.05, -0.9, -0.75, -0.6]) * 6 + [0] * 300
            log = [(round(sign * load + drift * i / len(loads) + generator.gauss(0, noise), 3), 0.01, 0.001)
                   for i, load in enumerate(loads)]
            data = self.data("load,force,moment", log)
            said = self.succeed("hold", *CONTACT, "--data", data, "--zero", "--least-load", "0.5").stderr
            self.assertRegex(said, f"warning: .*{warned}") if warned else self.assertNotIn("warning", said)

    def test_advice_is_about_the_options_that_were_given(self):
        for given, advice in ((["--mass", "200", "--offset", "0.02"], "--mass is in kg"),
                              (["--mass", "1", "--offset", "20"], "--offset in m"),
                              (["--force", "2000", "--moment", "0"], "--units force=mN")):
            said = self.succeed("hold", *CONTACT, *given).stderr
            self.assertIn(advice, said)
            self.assertEqual("--units" in advice, "--units" in said)
        done = self.succeed("hold", *CONTACT[:2], *CONTACT[4:], "--mu-r", "1.4", "--force", "1", "--moment", "0.01")
        self.assertIn("--mu-r must be in metres", done.stderr)

    def test_logs_with_blanks_units_and_names_of_all_kinds(self):
        text = 't,"Fz, N",s0:F,M\ns,N,N,Nmm\n0,3,1,2\n1,,1,2\n2,4,1,2\n'
        columns = ("--columns", 'load="Fz, N",force="s0:F",moment=M')
        log = self.file("log.csv", text)
        done = self.succeed("hold", *CONTACT, "--data", log, *columns, "--units", "moment=Nmm")
        self.assertEqual(len(done.stdout.splitlines()), 3)
        self.assertIn("1 of 3 rows have a blank in a used column", done.stderr)
        self.assertIn("line 2 has units, and is skipped", done.stderr)

    def test_a_measured_pressure_has_its_own_size_and_error(self):
        rows_of = [(0.5e-3 * i, math.sqrt(max(0.0, 1 - (i / 12) ** 2))) for i in range(30)]
        rows_of[25] = (rows_of[25][0], 0.004)
        law = f"samples:{self.data('radius,pressure', rows_of)}"
        self.assertIn("without --radius a is 1 m", run("eval", "--law", law, "--c", "0.002", "--load", "2").stderr)
        wrench = ["--mu", "0.6", "--force", "1", "--moment", "2e-3"]
        own = run("hold", "--law", law, *wrench)
        self.assertEqual(own.stdout.splitlines()[0], "force,moment,hold_load,hold_error")
        self.assertIn("are the contact's, in metres, at every load", own.stderr)
        named = run("hold", "--law", law + ",rim=0.006", "--radius-law", "constant:a=0.006", *wrench)
        self.assert_close(float(own.stdout.split(",")[-2]), float(named.stdout.split(",")[-2]), 1e-12)
        self.assertIn("lie beyond rim=0.006", named.stderr)
        last = run("hold", "--law", law, "--radius-law", "constant:a=0.006", *wrench)
        self.assertIn("rim=RADIUS names the radius", last.stderr)

    def test_the_weight_on_a_pad(self):
        data = [(4.905, 0.0, -0.0981), (0.0, -4.905, -0.0981), (2.943, -3.924, 0.0981)]
        expected = [row["hold_load"] for row in rows("hold", *PATCH, "--data", self.data("fx,fy,moment", data))]
        for given, load in zip(
            (("--down", "2,0", "--offset", 0.02), ("--offset", 0.02), ("--down", "3,-4", "--offset", -0.02)), expected):
            row, = rows("hold", *PATCH, "--mass", 1, *given)
            self.assert_close(row["hold_load"], load, 1e-12)
        row, = rows("hold", *PATCH, "--mass", 1, "--offset", 0.02)
        self.assertEqual([row[name] for name in ("fx", "fy")], [0, -4.905])
        self.assert_close(row["moment"], -0.0981, 1e-12)  # x times fy
        self.assertEqual(rows("hold", *PATCH, "--force", "0,-4.905", "--moment", repr(row["moment"])), [row])

    def test_mu_r_as_measured_is_the_radius_law_it_implies(self):
        """In every command that takes one: mu_r = mu m0 a, with gamma the exponent of the radius."""
        m0 = 3 * math.pi / 16
        common = ["--law", "hertz", "--mu", "0.6"]
        sized, measured = ["--radius-law",
                           "power:c=0.005,gamma=0.3"], ["--mu-r", repr(0.6 * m0 * 0.005), "--gamma", "0.3"]
        for command in (["hold", "--data", self.data("force,moment,load",
                                                     [(1, 0.003, 2.5)])], ["p-curves", "--loads", "0,0.5,3"],
                        ["c-curves", "--loads", "0,1,2", "--cors",
                         "0,0.002,inf"], ["translate", "--load", "2", "--loads",
                                          "1,4"], ["hold", "--curve", "box", "--force", "1", "--moment", "0.003"]):
            both = (rows(*command, *common, *contact, "--quiet") for contact in (sized, measured))
            for one, other in zip(*both, strict=True):
                for name, number in one.items():
                    self.assertEqual(number, other[name]) if isinstance(number, str) else self.assertAlmostEqual(
                        number, other[name], delta=1e-12 * abs(number))

    def test_an_ellipse_or_a_box_with_mu_r_needs_no_law(self):
        contact = ["--mu", "0.6", "--mu-r", "0.002"]
        trace = self.data("time,x,y,z,twist", [(i, 0, 0, -0.002, i) for i in range(4)])
        for curve, load in (("ellipse", math.hypot(1 / 0.6, 0.003 / 0.002)), ("box", 1 / 0.6)):
            for law in ([], ["--law", "cone"]):
                need = ["--quiet", "--force", "1", "--moment", "0.003"]
                self.assert_close(
                    rows("hold", "--curve", curve, *law, *contact, *need)[0]["hold_load"], load, 1e-12)
            end = rows("replay", "--trace", trace, "--curve", curve, *contact, *FINGER[6:])[-1]
            self.assert_close(end["moment"], -0.002 * 2, 1e-12)
            self.assertEqual(run("pivot", "--curve", curve, *contact, "--duration", "0.01").returncode, 0)

    def test_margin_at_the_ends(self):
        for contact, columns, zero, some in ((CONTACT, "force,moment,load", (0, 0), (1, 0)),
                                             (PATCH, "fx,fy,moment,load", (0, 0, 0), (1, 0, 0))):
            found = rows("hold", *contact, "--data",
                         self.data(columns, [(*zero, 0), (*zero, 2), (*some, 0), (*some, 1), (*some, 4)]))
            self.assertEqual(",".join(found[0]), columns.replace("load", "hold_load,margin"))
            margins = [row["margin"] for row in found]
            self.assertEqual(margins[:4], [1, 1, 0, 0])
            self.assert_close(margins[4], 1 - 1 / 4 / float(contact[-1]), 1e-12)


if __name__ == "__main__":
    unittest.main()
