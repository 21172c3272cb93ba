# SPDX-License-Identifier: MIT
"""Metres, newtons and radians: every command asks about numbers that are far outside what a fingertip has, and --units
converts."""

import math
import unittest

from command_line import CommandLineTest, rows, run

LAW = ["--law", "hertz", "--radius-law", "constant:a=0.005", "--mu", "0.6"]
FINGER = ["--stiffness", "1000", "--twist-stiffness", "0.036"]


class Units(CommandLineTest):
    def asked(self, *arguments):
        """Warnings of a call that succeeds."""
        done = run(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [line.removeprefix("limitcurve: warning: ") for line in done.stderr.splitlines() if "warning: " in line]

    def trace(self, *samples, head="time,x,y,z,twist"):
        return self.file("trace.csv", "\n".join([head, *(",".join(map(repr, sample)) for sample in samples)]) + "\n")

    def test_every_patch_in_millimetres(self):
        twists = self.file("twists.csv", "vx,vy,omega\n0.01,0,0\n")
        pushes = self.file(
            "pushes.csv",
            "force_x,force_y,moment,dx,dy,dtheta\n" + "1,0,0,0.01,0,0\n0,1,0.001,0,0.01,0.1\n1,0,-0.002,0.01,0,-0.2\n")
        commands = [["patch", "--twists", twists], ["validate"], ["choose", "--tolerance", "0.1"],
                    ["translate", "--mu", "0.8"], ["hold", "--mu", "0.5", "--force", "0,-3", "--moment", "6e-3"],
                    ["fit", "friction", "--data", pushes],
                    ["replay", "--trace", self.trace((0, 0, 0, -0.001, 0)), "--mu", "0.5", *FINGER]]
        for command in commands:
            for patch, across in (("rectangle:x=20,y=10", 20), ("rectangle:x=0.02,y=0.01", 0)):
                self.assertEqual(
                    [f"patch '{patch}': {across} m across: is it in metres?"] if across else [],
                    [line for line in self.asked(*command, "--patch", patch) if "metres" in line and "across" in line])
        for kind, head, scale in (("points", "x,y,load", 1), ("polygon", "x,y", 1), ("image", None, 1)):
            corners = [(0, 0, 1), (0.02, 0, 1), (0.02, 0.01, 1), (0, 0.01, 1)]
            for times in (1, 1000):
                text = "1,2\n3,4\n" if head is None else head + "\n" +"".join(",".join(
                    repr(value * (times if i < 2 else 1))
                    for i, value in enumerate(corner[:head.count(",") + 1])) + "\n"
                                                                              for corner in corners)
                patch = f"{kind}:{self.file('p.csv', text)}" + (f",pixel={0.001 * times}" if head is None else "")
                self.assertEqual(len(self.asked("patch", "--twists", twists, "--patch", patch)), times > 1, patch)
        self.assertEqual(len(self.asked("patch", "--twists", twists, "--patch", "ellipse:law=hertz,a=0.3,b=0.2")), 1)

    def test_loads_moments_and_turns(self):
        hold = ["hold", *LAW]
        data = lambda head, *lines: self.file(f"{abs(hash(lines))}.csv", "\n".join([head, *lines]) + "\n")
        grip = self.file("grip.csv", "time,load\n0,2000\n1,1990\n")
        turned = [(0.1 * i, 0, 0, -0.001, 30.0 * i) for i in range(4)]
        wraps = [(0.1 * i, 0, 0, -0.001, math.remainder(0.5 * i, 2 * math.pi)) for i in range(20)]
        replay = lambda *samples: [
            "replay", "--trace",
            data("time,x,y,z,twist", *(",".join(map(repr, sample)) for sample in samples)), *LAW, *FINGER
        ]
        slips = ["load,force,moment"
                 ] + [f"{0.5 + 0.01 * i},{(1 + 0.02 * i) * (1 - 0.1 * (i % 7))},{1e-3 * (i % 7)}" for i in range(20)]
        for command, questions in (([*hold, "--force", "1", "--moment",
                                     "2"], ["a load of ", "a moment of 2 N m beside a force of 1 N"
                                            ]), ([*hold, "--force", "1", "--moment",
                                                  "0.002"], []), ([*hold, "--force", "0.5", "--moment", "0.15"], []),
                                   ([*hold, "--data",
                                     data("force,moment,load", "1,0,0.5", "1,0,0.4",
                                          "1,0,3")], ["the force exceeds the load in 2 of 3 rows"]),
                                   ([*hold, "--data",
                                     data("force,moment,load", "1,0,0.5", "1,0,3",
                                          "1,0,5000")], ["a load of 5000 N"]), ([
                                              "hold", "--patch", "rectangle:x=0.02,y=0.01", "--mu", "0.5", "--force",
                                              "0,-1", "--moment", "-2"
                                          ], ["a moment of -2"]), ([
                                              "hold", "--patch", "rectangle:x=0.02,y=0.01", "--mu", "0.5", "--force",
                                              "0,-1000", "--moment", "0"
                                          ], ["a load of "]), (["p-curves", *LAW, "--loads",
                                                                "1,1500"], ["a load of 1500 N"]),
                                   (["c-curves", *LAW, "--loads", "1500", "--cors",
                                     "0"], ["a load of 1500 N"]), (["translate", *LAW, "--load",
                                                                    "400"], ["a load of 1600 N"]),
                                   (["eval", "--law", "hertz", "--c", "1", "--load", "2000"], ["a load of"]), ([
                                       "choose", "--law", "hertz", "--tolerance", "0.5", "--scene", "--loads",
                                       "500,2000"
                                   ], ["a load of"
                                       ]), (["pivot", "--case", "exact", "--grip", grip, "--duration",
                                             "0.01"], ["a load of 2000 N"]),
                                   (["pivot", "--case", "coupled", "--operator", "target=30", "--duration",
                                     "0.01"], ["target = 30 rad: is it in radians? 30deg"]),
                                   (["pivot", "--case", "coupled", "--operator", "target=30deg", "--duration",
                                     "0.01"], []),
                                   (["pivot", "--case", "coupled", "--operator", "target=400deg", "--duration",
                                     "0.01"], []), (replay(*turned), ["the twist changes by 30 rad up to time 0.1 s"
                                                                      ]), (replay(*wraps), []), (replay(
                                                                          (0, 0, 0, -2, 0)), ["a load of 2000 N"]),
                                   (["fit", "ratio", "--data", data(*slips),
                                     "--quiet"], []), (["fit", "ratio", "--data",
                                                        data(*slips)], ["the force exceeds the load in "])):
            said = [
                line for line in self.asked(*command)
                if not any(word in line for word in ("inside the curve", "scatter", "grip begins", "contact radius"))
            ]
            self.assertEqual(len(said), len(questions), (command, said))
            for line, question in zip(said, questions):
                self.assertIn(question, line)

    def test_units_never_touch_strings_and_are_refused_by_name(self):
        self.assert_close(
            rows("hold", *LAW, "--force", "1000", "--moment", "0", "--units", "force=mN")[0]["hold_load"],
            1 / 0.6, 1e-12)
        for bad in ("moment=mmN", "force=lb", "mass=kg", "time=min", "moment=Nms"):
            self.assert_fails(2, ["--units", f"'{bad}'", "lbfin", "time=s|ms"], "hold", *LAW, "--force", "1",
                              "--moment", "0", "--units", bad)
        self.assert_fails(2, "--units: goes with", "hold", *LAW, "--mass", "1", "--offset", "0.01", "--units",
                          "force=N")
        self.assert_fails(2, "--columns: goes with --data", "hold", *LAW, "--force", "1", "--moment", "0", "--columns",
                          "force=F")
        push = self.file(
            "push.csv", "force_x,force_y,moment,dx,dy,dtheta\n" +
            "".join(f"1,{0.01 * i},0.0001,0.01,{1e-4 * i},0.0001\n" for i in range(4)))
        fitted = [
            rows("fit", "friction", "--patch", "rectangle:x=0.02,y=0.01", "--data", push, "--quiet", "--load", load,
                 *units)[0]["value"] for load, units in (("2", []), ("2000", ["--units", "force=mN,moment=mNm"]))
        ]
        self.assert_close(fitted[1], fitted[0] / 1000, 1e-12)  # the file's forces, and --load


if __name__ == "__main__":
    unittest.main()
