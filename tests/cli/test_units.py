# SPDX-License-Identifier: MIT
"""Metres, newtons and radians: every command asks about numbers that are far outside what a fingertip has, and --units
converts."""

import math
import unittest

from command_line import FINGER, CommandLineTest, rows, run

LAW, SPRINGS = [*FINGER[:3], "constant:a=0.005", *FINGER[4:6]], FINGER[6:]


class Units(CommandLineTest):
    def asked(self, *arguments):
        """Warnings of a call that succeeds."""
        done = self.succeed(*arguments)
        return [line.removeprefix("limitcurve: warning: ") for line in done.stderr.splitlines() if "warning: " in line]

    def test_every_patch_in_millimetres(self):
        twists = self.file("twists.csv", "vx,vy,omega\n0.01,0,0\n")
        pushes = self.file(
            "pushes.csv",
            "force_x,force_y,moment,dx,dy,dtheta\n" + "1,0,0,0.01,0,0\n0,1,0.001,0,0.01,0.1\n1,0,-0.002,0.01,0,-0.2\n")
        commands = [["patch", "--twists", twists], ["validate"], ["choose", "--tolerance", "0.1"],
                    ["translate", "--mu", "0.8"], ["hold", "--mu", "0.5", "--force", "0,-3", "--moment", "6e-3"],
                    ["fit", "friction", "--data", pushes],
                    ["replay", "--trace", self.trace([(0, 0, 0, -0.001, 0)]), "--mu", "0.5", *SPRINGS]]
        for command in commands:
            for patch, across in (("rectangle:x=20,y=10", 20), ("rectangle:x=0.02,y=0.01", 0)):
                self.assertEqual(
                    [f"patch '{patch}': {across} m across: lengths must be in metres"] if across else [],
                    [line for line in self.asked(*command, "--patch", patch) if "metres" in line and "across" in line])
        corners = "0,0,1\n{0},0,1\n{0},{1},1\n".format
        for kind, head, more in (("points", "x,y,load\n", ""), ("polygon", "x,y,n\n", ""), ("image", "", ",pixel=")):
            for scale in (1, 1000):
                text = corners(0.02 * scale, 0.01 * scale) if head else "1,2\n3,4\n"
                patch = f"{kind}:{self.file('p.csv', head + text)}" + (f"{more}{0.001 * scale}" if more else "")
                self.assertEqual(len(self.asked("patch", "--twists", twists, "--patch", patch)), scale > 1, patch)
        self.assertEqual(len(self.asked("patch", "--twists", twists, "--patch", "ellipse:law=hertz,a=0.3,b=0.2")), 1)

    def test_loads_moments_and_turns(self):
        hold, pad, replay = "hold $LAW", "hold --patch rectangle:x=0.02,y=0.01 --mu 0.5", "replay $LAW $FINGER --trace"
        coupled = "pivot --case coupled --duration 0.01 --operator"
        grip = self.file("grip.csv", "time,load\n0,2000\n1,1990\n")
        slips = self.csv("slips.csv", "load,force,moment", [(0.5 + 0.01 * i, (1 + 0.02 * i) * (1 - 0.1 * (i % 7)),
                                                             1e-3 * (i % 7)) for i in range(20)])
        loads = self.file("loads.csv", "force,moment,load\n1,0,0.5\n1,0,0.4\n1,0,3\n")
        load = self.file("load.csv", "force,moment,load\n1,0,0.5\n1,0,3\n1,0,5000\n")
        turned, wraps, deep, stamps = (self.trace(samples, name) for name, samples in (
            ("turned", [(0.1 * i, 0, 0, -0.001, 30.0 * i) for i in range(4)]),
            ("wraps", [(0.1 * i, 0, 0, -0.001, math.remainder(0.5 * i, 2 * math.pi)) for i in range(20)]),
            ("deep", [(0, 0, 0, -2, 0)]),
            ("stamps", [(1764000000000000000 + 1000000 * i, 0, 0, -0.001, 0) for i in range(4)])))
        for command, *questions in (
            (f"{hold} --force 1 --moment 2", "a load of ", "a moment of 2 N m with a force of 1 N"),
            (f"{hold} --force 1 --moment 0.002",), (f"{hold} --force 0.5 --moment 0.15",),
            (f"{hold} --data {loads}", "the friction force exceeds the load in 2 of 3 rows"),
            (f"{hold} --data {load}", "a load of 5000 N"), (f"{pad} --force 0,-1 --moment -2", "a moment of -2"),
            (f"{pad} --force 0,-1000 --moment 0", "a load of "), ("p-curves $LAW --loads 1,1500", "a load of 1500 N"),
            ("c-curves $LAW --loads 1500 --cors 0", "a load of 1500 N"),
            ("translate $LAW --load 400", "a load of 1600 N"),
            ("eval --law hertz --c 1 --load 2000", "a load of"),
            ("choose --law hertz --tolerance 0.5 --scene --loads 500,2000", "a load of"),
            (f"pivot --case exact --duration 0.01 --grip {grip}", "N is unusual for a finger; loads must be"),
            (f"{coupled} target=30", "target = 30 rad is more than a turn"), (f"{coupled} target=30deg",),
            (f"{coupled} target=400deg",), (f"{replay} {turned}", "the twist changes by 30 rad up to time 0.1 s"),
            (f"{replay} {wraps}",), (f"{replay} {deep}", "a load of 2000 N is unusual for a finger; it is --stif"),
            (f"{replay} {stamps}", "the time steps exceed 1 s in 3 of 3 rows"),
            (f"{replay} {stamps} --units time=1e-9",),
            (f"{replay} {wraps} --surface sphere:radius=25", "50 m across: lengths must be", "a load of 24999 N"),
            (f"fit ratio --quiet --data {slips}",), (f"fit ratio --data {slips}", "force exceeds the load in ")):
            words = [one for word in command.split() for one in {"$LAW": LAW, "$FINGER": SPRINGS}.get(word, [word])]
            said = [
                line for line in self.asked(*words)
                if not any(word in line for word in ("inside the curve", "scatter", "grip begins", "contact radius"))
            ]
            self.assertEqual(len(said), len(questions), (command, said))
            for line, question in zip(said, questions):
                self.assertIn(question, line)

    def test_radii_in_millimetres_and_beyond_their_samples(self):
        samples, moments = (f"{kind}s:{self.file(kind + '.csv', text)}"
                            for kind, text in (("sample", "load,radius\n1,0.004\n2,0.005\n4,0.006\n"),
                                               ("moment", "load,moment\n1,0.001\n2,0.002\n4,0.004\n")))
        beyond, metres = "extrapolated: it was measured from 1 to 4 N", "must be in metres"
        for law, loads, told in (("constant:a=5", "1,2", metres), ("constant:a=0.1", "1,2", ""),
                                 ("hertz:R=8000,E=0.2", "1,2", metres), (samples, "1.5,3", ""),
                                 (samples, "1.5,4.5", beyond), (moments, "0.5,3", beyond)):
            common = ["--law", "hertz", "--radius-law", law, "--mu", "0.5"]
            ends = loads.split(",")
            trace = self.trace((i / 1000, 0, 0, -float(load) / 1000, 0) for i, load in enumerate(ends))
            held = self.csv("held.csv", "force,moment,load", [(0.6, 1e-4, float(load)) for load in ends])
            for call in (["p-curves", "--loads", loads], ["c-curves", "--loads", loads, "--cors", "0,0.001,inf"],
                         ["translate", "--load", ends[0], "--loads", loads], ["replay", "--trace", trace, *SPRINGS],
                         ["hold", "--data", held],
                         ["choose", "--tolerance", "0.5", "--scene", "--loads", loads]):
                said = self.asked(*call, *common)
                self.assertEqual(len(said), told != "", (call, law, said))
                self.assertIn(told, "".join(said))
        # A grip that begins at 0, and a finger that never touches.
        grip = ["--release", "from=0,to=3,over=0.01", "--duration", "0.01", "--radius-law", samples]
        self.assertIn(beyond, self.asked("pivot", "--case", "exact", *grip)[-1])
        late = "samples:" + str(self.file("late.csv", "load,radius\n2,0.004\n4,0.005\n"))
        above = ["replay", *SPRINGS, "--trace", self.trace([(0, 0, 0, 0.01, 0)]), "--law", "hertz", "--mu", "0.5"]
        self.assertEqual(self.asked(*above, "--radius-law", late), [])
        # What is fitted, too.
        for scale in (1, 1e-3):
            radii = [(load, scale * 4 * load ** 0.3) for load in [1, 2, 4, 8]]
            slips = [(load, 0.5 * load * f, 0.5 * load * scale * 5 * m) for load in [1, 2, 4]
                     for f, m in [(0, 0.589), (1, 0), (0.86, 0.234)]]
            for model, columns, lines in (("load", "load,radius", radii), ("ratio", "load,force,moment", slips)):
                done = run("fit", model, "--data", self.csv("measured.csv", columns, lines))
                self.assertEqual(done.stderr.count("are the data in millimetres"), scale == 1, model)

    def test_units_never_touch_strings_and_are_refused_by_name(self):
        self.assert_close(
            rows("hold", *LAW, "--force", "1000", "--moment", "0", "--units", "force=mN")[0]["hold_load"],
            1 / 0.6, 1e-12)
        push = self.csv("push.csv", "force_x,force_y,moment,dx,dy,dtheta",
                        [(1, 0.01 * i, 0.0001, 0.01, 1e-4 * i, 0.0001) for i in range(4)])
        fitted = [
            rows("fit", "friction", "--patch", "rectangle:x=0.02,y=0.01", "--data", push, "--quiet", "--load", load,
                 *units)[0]["value"] for load, units in (("2", []), ("2000", ["--units", "force=mN,moment=mNm"]))
        ]
        self.assert_close(fitted[1], fitted[0] / 1000, 1e-12)  # the file's forces, and --load


if __name__ == "__main__":
    unittest.main()
