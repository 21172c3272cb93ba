# SPDX-License-Identifier: MIT
"""hold: the least load that bears a force and a moment."""

import math
import unittest

from command_line import CommandLineTest, rows, run

CONTACT = ["--law", "hertz", "--radius-law", "hertz:R=0.008,E=2e5", "--mu", "0.8"]
PATCH = ["--patch", "rectangle:x=0.02,y=0.01", "--mu", "0.5"]
FINGER = ["--stiffness", "1000", "--twist-stiffness", "0.036"]


class Hold(CommandLineTest):
    def data(self, columns, table):
        return self.file("data.csv", "\n".join([columns, *(",".join(map(repr, line)) for line in table)]) + "\n")

    def test_what_two_fingers_hold_level(self):
        """Each bears half the weight, and half of its moment about the grip."""
        two = rows("hold", *CONTACT, "--fingers", "2", "--mass", "0.2", "--offset", "0.02")
        self.assertEqual(two, rows("hold", *CONTACT, "--mass", "0.2", "--offset", "0.02"))
        self.assert_close(two[0]["force"], 0.2 * 9.81 / 2, 1e-15)
        self.assert_close(two[0]["moment"], 0.2 * 9.81 * 0.02 / 2, 1e-15)
        self.assertEqual(two,
                         rows("hold", *CONTACT, "--force", repr(two[0]["force"]), "--moment", repr(two[0]["moment"])))
        moon, = rows("hold", *CONTACT, "--fingers", "3", "--mass", "0.2", "--offset", "0.02", "--gravity", "1.62")
        self.assert_close(moon["force"], 0.2 * 1.62 / 3, 1e-15)
        # The block of the paper slips where this load is passed.
        sandpaper = [
            "--law", "hertz", "--radius-law", "constant:a=0.008", "--mu", "0.6", "--mass", "0.1", "--offset", "0.005"
        ]
        hold = rows("hold", *sandpaper)[0]["hold_load"]
        run_of = rows("pivot", "--case", "exact", "--law", "hertz", "--radius-law", "constant:a=0.008", "--mu", "0.6",
                      "--mass", "0.1", "--offset", "0.005", "--release", f"from={1.2 * hold},to={0.9 * hold},over=3",
                      "--time-step", "1e-4", "--every", "1")
        slips = next(row["load"] for row in run_of if row["state"] == "slip")
        self.assertAlmostEqual(slips / hold, 1, delta=2e-3)

    def test_a_force_torque_log_as_it_comes(self):
        """The options are those of fit and replay, too."""
        log = self.file(
            "log.csv",
            'Sensor 7\n\n"gain","3"\n"t","Fx","Fy","Fz","Tz"\n0,0.01,0,0.02,0\n1,0.6,-0.8,-5.1,0.002\n2,0.3,0.4,-5,0\n')
        columns = "load=-Fz,force=Fx:Fy,moment=Tz"
        done = run("hold", *CONTACT, "--data", log, "--columns", columns, "--least-load", "0.1")
        self.assertEqual(done.returncode, 0, done.stderr)
        table = [
            dict(zip(done.stdout.splitlines()[0].split(","), map(float, line.split(","))))
            for line in done.stdout.splitlines()[1:]
        ]
        self.assertEqual([row["force"] for row in table], [1.0, 0.5])
        self.assertIn("the header is line 4", done.stderr)
        self.assertIn("1 of 3 rows have a load below 0.1, and are left out", done.stderr)
        self.assertNotIn("Fy", done.stderr)
        done = run("hold", *CONTACT, "--data", log, "--columns", columns.replace(":Fy", ""), "--least-load", "0.1")
        self.assertIn("force=Fx leaves out Fy; force=Fx:Fy is their length", done.stderr)
        plain = self.file("plain.csv", log.read_text()[log.read_text().index('"t"'):])
        for options, told in (([
                "--columns", columns
        ], "expected a finite number >= 0; --least-load 0.1 leaves out rows of less"),
                              (["--columns", columns.replace("Tz",
                                                             "Tx:Tz")], "got 'moment=Tx:Tz', expected one column"),
                              (["--columns",
                                columns.replace("Fy",
                                                "Fq")], "no column 'Fq'"), (["--columns", columns, "--least-load",
                                                                             "9"], "all 3 rows have a load below 9")):
            self.assert_fails(2, told, "hold", *CONTACT, "--data", plain, *options)
        bag = self.file("log.bag", "#ROSBAG V2.0\n")
        self.assert_fails(2, "rostopic echo -b FILE.bag -p /TOPIC", "hold", *CONTACT, "--data", bag)

    def test_the_moment_is_about_the_contact_wherever_the_sensor_sits(self):
        """T = r x F + M n, so F.T/Fz is M: of a pad that only slides 0, and the load that holds is F/mu."""
        random = __import__("random").Random(5)
        rows_of = ["Fx,Fy,Fz,Tx,Ty,Tz,true"]
        for sign in (-1, 1):
            for _ in range(10):
                f = [random.uniform(-2, 2), random.uniform(-2, 2), sign * random.uniform(1, 5)]
                r, moment = [random.uniform(-0.03, 0.03) for _ in range(3)], random.uniform(-4e-3, 4e-3)
                t = [r[1] * f[2] - r[2] * f[1], r[2] * f[0] - r[0] * f[2], r[0] * f[1] - r[1] * f[0] + moment]
                rows_of.append(",".join(map(repr, f + t + [moment])))
        rows_of.append("0,0,0,1e-5,0,1e-5,0")
        log = self.file("six.csv", "\n".join(rows_of))
        table = rows("hold", *CONTACT, "--data", log, "--columns", "force=Fx:Fy,moment=Fx:Fy:Fz:Tx:Ty:Tz", "--quiet")
        true = rows("hold", *CONTACT, "--data", log, "--columns", "force=Fx:Fy,moment=true", "--quiet")
        self.assertEqual(len(table), 20)  # the row with Fz = 0 is left out
        for ours, its in zip(table, true):
            self.assertAlmostEqual(ours["moment"], its["moment"], delta=1e-15)
            self.assertAlmostEqual(ours["hold_load"] / its["hold_load"], 1, delta=1e-10)
        done = run("hold", *CONTACT, "--data", log, "--columns", "force=Fx:Fy,moment=Tz")
        self.assertIn("moment=Tz is about the sensor's axis", done.stderr)
        self.assert_fails(2, "got Fz = 0 and a load of 2 N", "hold", *CONTACT, "--data",
                          self.file("off.csv", "load,Fx,Fy,Fz,Tx,Ty,Tz\n2,1,0,0,0,0,0"), "--columns",
                          "force=Fx:Fy,moment=Fx:Fy:Fz:Tx:Ty:Tz")

    def test_logs_with_blanks_units_and_names_of_all_kinds(self):
        text = 't,"Fz, N",s0:F,M\ns,N,N,Nmm\n0,3,1,2\n1,,1,2\n2,4,1,2\n'
        columns = ("--columns", 'load="Fz, N",force="s0:F",moment=M')
        log = self.file("log.csv", text)
        done = run("hold", *CONTACT, "--data", log, *columns, "--units", "moment=Nmm")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(done.stdout.splitlines()), 3)
        self.assertIn("1 of 3 rows have a blank in a used column", done.stderr)
        self.assertIn("line 2 has units, and is skipped", done.stderr)
        self.assert_fails(2, "log.csv:2:7: a line of units, got 'Nmm' for moment", "hold", *CONTACT, "--data", log,
                          *columns)
        self.assert_fails(2, "no header: put a line", "hold", *CONTACT, "--data", self.file("bare.csv", "1,2,3\n4,5,6"))
        self.assert_fails(2, "--zero: needs --least-load", "hold", *CONTACT, "--data", log, *columns, "--zero")
        self.assert_fails(2, "no pause", "hold", *CONTACT, "--data", log, *columns, "--units", "moment=Nmm", "--zero",
                          "--least-load", "0.5", "--quiet")

    def test_a_measured_pressure_has_its_own_size_and_error(self):
        rows_of = [(0.5e-3 * i, math.sqrt(max(0.0, 1 - (i / 12) ** 2))) for i in range(30)]
        rows_of[25] = (rows_of[25][0], 0.004)
        profile = self.file("q.csv", "radius,pressure\n" + "".join(f"{r!r},{p!r}\n" for r, p in rows_of))
        law = f"samples:{profile}"
        wrench = ["--mu", "0.6", "--force", "1", "--moment", "2e-3"]
        own = run("hold", "--law", law, *wrench)
        self.assertEqual(own.stdout.splitlines()[0], "force,moment,hold_load,hold_error")
        self.assertIn("are the contact's, in metres, at every load", own.stderr)
        named = run("hold", "--law", law + ",rim=0.006", "--radius-law", "constant:a=0.006", *wrench)
        self.assert_close(float(own.stdout.split(",")[-2]), float(named.stdout.split(",")[-2]), 1e-12)
        self.assertIn("lie beyond rim=0.006", named.stderr)
        # What is called the contact radius changes no newton.
        for rim in (0.003, 0.006, 0.012):
            other = run("hold", "--law", f"{law},rim={rim}", *wrench)
            self.assert_close(float(own.stdout.split(",")[-2]), float(other.stdout.split(",")[-2]), 1e-12)
        last = run("hold", "--law", law, "--radius-law", "constant:a=0.006", *wrench)
        self.assertIn("rim=RADIUS names the radius", last.stderr)
        self.assert_fails(2, "rim", "eval", "--law", law + ",rm=1", "--c", "1")

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
        for down in ("0,0", "1", "1,2,3"):
            self.assert_fails(2, "--down", "hold", *PATCH, "--mass", 1, "--offset", 0, "--down", down)
        self.assert_fails(2, "--down", "hold", *CONTACT, "--mass", 1, "--offset", 0, "--down", "0,-1")

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
            for one, other in zip(rows(*command, *common, *sized), rows(*command, *common, *measured), strict=True):
                for name, number in one.items():
                    self.assertEqual(number, other[name]) if isinstance(number, str) else self.assertAlmostEqual(
                        number, other[name], delta=1e-12 * abs(number))

    def test_an_ellipse_or_a_box_with_mu_r_needs_no_law(self):
        contact = ["--mu", "0.6", "--mu-r", "0.002"]
        for curve, load in (("ellipse", math.hypot(1 / 0.6, 0.003 / 0.002)), ("box", 1 / 0.6)):
            for law in ([], ["--law", "cone"]):
                self.assert_close(
                    rows("hold", "--curve", curve, *law, *contact, "--force", "1", "--moment", "0.003")[0]["hold_load"],
                    load, 1e-12)
            trace = self.file("turns.csv", "time,x,y,z,twist\n" + "".join(f"{i},0,0,-0.002,{i}\n" for i in range(4)))
            self.assert_close(
                rows("replay", "--trace", trace, "--curve", curve, *contact, *FINGER)[-1]["moment"], -0.002 * 2, 1e-12)
            self.assertEqual(run("pivot", "--curve", curve, *contact, "--duration", "0.01").returncode, 0)
        one, sized = ["--force", "1", "--moment", "0"], ["--radius-law", "constant:a=0.005"]
        for command in (["hold", *one], ["replay", "--trace", trace, *FINGER], ["pivot", "--case", "exact"],
                        ["p-curves", "--loads", "1"], ["c-curves", "--loads", "1", "--cors",
                                                       "0"], ["translate", "--load",
                                                              "1"], ["choose", "--scene", "--tolerance", "0.1"]):
            self.assert_fails(2, ["--mu-r", "--radius-law"], *command, "--law", "hertz", *contact, *sized)
        for command in (["hold", "--force", "1,0", "--moment", "0"], ["replay", "--trace", trace,
                                                                      *FINGER], ["translate"]):
            self.assert_fails(2, ["--mu-r", "--patch"], *command, "--patch", "rectangle:x=0.02,y=0.01", *contact)
        for command in (["hold", *one], ["replay", "--trace", trace, *FINGER]):
            for curve in ("exact", "table"):
                self.assert_fails(2, "--law", *command, "--curve", curve, *contact)
            self.assert_fails(2, "--law", *command, "--curve", "ellipse", "--mu", "0.6", *sized)

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
