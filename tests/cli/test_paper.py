# SPDX-License-Identifier: MIT
"""The corrections to the paper (godobject/README.md): results of its equations as printed, written out here, compared with those of the command
gives. And its page, docs/paper.md: nothing in it points to what is not there."""

import importlib.util
import math
import os
import re
import shlex
import subprocess
import sys
import unittest
from pathlib import Path

from command_line import DATA, EXECUTABLE, CommandLineTest, rows

ROOT = Path(__file__).resolve().parents[2]
SIXTY_LINES = ROOT / "examples" / "python" / "paper_in_60_lines.py"
MU, MU_R = 1.67, 0.01011  # sandpaper
FINGER = {"law": "hertz", "radius-law": "constant:a=0.006", "mu": "0.6", "stiffness": "1000", "twist-stiffness": "0.036"}
FINGER_OPTIONS = [word for name, value in FINGER.items() for word in (f"--{name}", value)]


def trace(name):
    lines = [line for line in (DATA / "traces" / name).read_text().splitlines() if not line.startswith("#")]
    names = lines[0].split(",")
    return [dict(zip(names, map(float, line.split(",")))) for line in lines[1:]]


def printed_equation_8(samples, mu_static, mu_dynamic):
    """Eqs. (7) to (11) as printed, with the static limit in every step: F/P of every sample in contact."""
    stiffness, proxy, ratios = 1000.0, None, []
    for sample in samples:
        depth = -sample["z"]
        if depth <= 0:
            proxy = None
            continue
        goal = (sample["x"], sample["y"])
        proxy = proxy or goal
        r = math.dist(goal, proxy)
        if r / (mu_static * depth) >= 1:
            proxy = tuple(g + (p - g) / r * mu_dynamic * depth for p, g in zip(proxy, goal))
        ratios.append(stiffness * math.dist(goal, proxy) / (stiffness * depth))
    return ratios


def regripped_block(carried):
    """A model of the block of `pivot`, regripped under 1 N at 30 degrees while it turns at 0.3 rad/s, about the grip alone: how far it has turned after 3 s
    [deg]. `carried` is by how much step e carries the proxy's angle with a velocity: eq. (13) or its correction."""
    mass, offset, time_step = 0.1, 0.005, 1e-3
    inertia = mass * (0.12**2 + 0.04**2) / 12 + mass * offset**2
    twist_stiffness = 1000 * (MU_R / MU) ** 2
    damping = 5 * twist_stiffness / 1000
    angle, velocity, proxy = math.radians(30), 0.3, 0.0  # the proxy's from the finger's
    for _ in range(3000):
        limit = MU_R * 1.0 / twist_stiffness
        proxy = max(-limit, min(limit, proxy))
        moment = mass * 9.81 * offset * math.cos(angle) - 2 * twist_stiffness * proxy - 2 * damping * velocity
        velocity += moment / inertia * time_step
        angle += velocity * time_step
        proxy += carried(velocity) * time_step
    return math.degrees(angle) - 30


class Corrections(CommandLineTest):
    def replay(self, name, *options):
        return [row for row in rows("replay", "--trace", DATA / "traces" / name, *FINGER_OPTIONS, *options) if row["state"] != "free"]

    def test_equation_8_chatters_where_dynamic_friction_is_less(self):
        printed = printed_equation_8(trace("slide_twist_load.csv"), 0.6, 0.3)
        self.assertAlmostEqual(sum(printed) / len(printed), 0.319, delta=5e-4)
        here = [math.hypot(row["fx"], row["fy"]) / row["load"]
                for row in self.replay("slide_twist_load.csv", "--curve", "box", "--mu-dynamic", "0.3") if row["load"] > 0]
        self.assertLess(sum(here) / len(here), 0.23)
        # Where both coefficients are one the two agree.
        printed = printed_equation_8(trace("slide_twist_load.csv"), 0.6, 0.6)
        here = [math.hypot(row["fx"], row["fy"]) / row["load"] for row in self.replay("slide_twist_load.csv", "--curve", "box")]
        self.assertAlmostEqual(max(abs(a - b) for a, b in zip(printed, here)), 0, delta=1e-9)

    def test_angles_at_touch_down_preload_nothing(self):
        samples = [f"{i / 1000},0,0,{-min(i, 20) * 1e-4},0.3" for i in range(-2, 100)]
        found = rows("replay", "--trace", self.file("trace.csv", "time,x,y,z,twist\n" + "\n".join(samples) + "\n"), *FINGER_OPTIONS)
        self.assertEqual({row["moment"] for row in found}, {0})
        self.assertEqual(found[-1]["load"], 2)

    def test_signs_of_equation_17(self):
        here = rows("eval", "--law", "hertz", "--c", "1")[0]  # as printed M is -9 pi/128
        self.assertAlmostEqual(here["force"], 9 * math.pi / 32, delta=1e-14)
        self.assertAlmostEqual(here["moment"], 9 * math.pi / 128, delta=1e-14)

    def test_quotients_that_are_0_by_0(self):
        # A pure twist has r = 0, a pure drag rho = 0: r'/r of eq. (23) is none.
        twist, drag = self.replay("press_twist_release.csv"), self.replay("press_drag_release.csv")
        self.assertIn("slip", {row["state"] for row in twist} & {row["state"] for row in drag})
        self.assertEqual({(row["fx"], row["fy"]) for row in twist}, {(0, 0)})
        self.assertEqual({row["moment"] for row in drag}, {0})
        for row in twist + drag:
            self.assertFalse(any(math.isnan(row[name]) for name in ("px", "py", "angle", "fx", "fy", "moment")))

    def test_the_normal_force_is_felt(self):
        # F = k_l (x_p - x_g) of step c is tangential: pressed straight in, the user would feel none of k_l d.
        pressed = [row for row in self.replay("press_twist_release.csv") if row["depth"] > 0]
        self.assertAlmostEqual(max(row["load"] for row in pressed), 1000 * max(row["depth"] for row in pressed), delta=1e-12)
        self.assertGreater(max(row["load"] for row in pressed), 1)

    def test_the_proxy_goes_where_the_bodys_material_goes(self):
        # A plate turns in place under a finger 5 mm beside its axis that sticks: its centre moves by 0, the place under the finger by 4.75 mm.
        found = rows("replay", "--trace", DATA / "scenes" / "turntable.csv", "--body", "trace", *FINGER_OPTIONS[:4], "--mu", "1000",
                     "--stiffness", "1000", "--twist-stiffness", "0.036")
        touch = next(row for row in found if row["state"] != "free")
        self.assertEqual({row["state"] for row in found[found.index(touch):]}, {"stick"})
        self.assertAlmostEqual(math.hypot(found[-1]["px"], found[-1]["py"]), 0.005, delta=1e-9)
        self.assertAlmostEqual(1e3 * math.dist((found[-1]["px"], found[-1]["py"]), (0.005, 0)), 4.75, delta=0.005)

    def test_the_sign_of_rotation(self):
        self.assertAlmostEqual(regripped_block(lambda velocity: velocity), 3.2, delta=0.1)
        self.assertAlmostEqual(regripped_block(abs) / 360, -21, delta=0.5)
        # The scene itself: regripped at 30 degrees, it stays there.
        found = rows("pivot", "--case", "coupled", "--operator", "target=30deg")
        self.assertLess(max(abs(math.degrees(row["angle"]) - 30) for row in found if row["time"] > 3.2), 3.2)

    def test_the_ratio_of_a_hertzian_contact_grows_with_the_load(self):
        # Eq. (5): mu_r/mu_l = 3 pi/16 a(P), twice as large at 8 N as at 1 N; Table 1 and eq. (2): one number.
        found = rows("p-curves", "--law", "hertz", "--radius-law", "hertz:R=0.008,E=2e5", "--mu", "1", "--loads", "1,8", "--points", "2")
        first, second = (row["moment"] / row["load"] for row in found if row["c"] == 0)
        self.assert_close(second / first, 2, 1e-14)

    def test_c_curves_bend(self):
        call = ["c-curves", "--law", "hertz", "--mu", "0.6", "--cors", "0.005", "--loads", "1,4", "--radius-law"]
        line, curve = ([row["force"] / row["moment"] for row in rows(*call, law)] for law in ("constant:a=0.006", "hertz:R=0.008,E=2e5"))
        self.assert_close(line[0], line[1], 1e-14)
        # N m per N at 1 N over that at 4 N.
        self.assertAlmostEqual(curve[0] / curve[1], 2.91, delta=0.01)

    def test_how_much_the_circle_over_estimates(self):
        found = [row for row in rows("validate") if row["model"] == "ellipse"]
        over = sorted(row["max_over_estimate"] for row in found)
        self.assertEqual((round(100 * over[0], 2), round(100 * over[-1], 2)), (4.25, 8.26))
        self.assertLess(max(row["max_under_estimate"] for row in found), 1e-9)
        peaked = next(row for row in rows("validate", "--law", "xydas-kao:k=0.2") if row["model"] == "ellipse")
        self.assertAlmostEqual(100 * peaked["max_under_estimate"], 1.6, delta=0.05)

    def test_form_closure_by_two_soft_fingers(self):
        call = ["replay", "--trace", DATA / "scenes" / "pinch.csv", *FINGER_OPTIONS, "--fingers", "2", "--surface",
                "box:x=0.12,y=0.04,z=0.04", "--body", "free:mass=0.1", "--damping", "2"]
        soft, point = ([math.degrees(2 * math.atan2(row["bqz"], row["bqw"])) for row in rows(*call, *more)]
                       for more in ([], ["--mu-r", "0"]))
        self.assertAlmostEqual(soft[-1], math.degrees(2 * math.atan(0.2)), delta=0.05)
        self.assertEqual(set(point), {0})


class SixtyLines(CommandLineTest):
    """The paper's equations in examples/python, without the library, and their page."""

    def setUp(self):
        super().setUp()
        spec = importlib.util.spec_from_file_location("paper_in_60_lines", SIXTY_LINES)
        self.paper = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(self.paper)

    def test_step_b_is_that_of_the_library(self):
        done = subprocess.run([sys.executable, "-B", SIXTY_LINES, EXECUTABLE], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        for step_b, curve in ((self.paper.uncoupled, ["box"]), (self.paper.coupled, ["ellipse", "--projection", "radial"])):
            for path, body in ((DATA / "traces" / "slide_twist_load.csv", []), (DATA / "scenes" / "turntable.csv", ["--body", "trace"])):
                here = list(self.paper.god_object(self.paper.read(path), step_b))
                library = rows("replay", "--trace", path, *FINGER_OPTIONS, "--curve", *curve, *body)
                self.assertEqual(len(here), len(library))
                self.assertIn("slip", {row["state"] for row in library})
                for wrench, row in zip(here, library):
                    for value, name in zip(wrench, ("fx", "fy", "moment")):
                        self.assertAlmostEqual(value, row[name], delta=1e-12)

    def test_equation_17_by_midpoints(self):
        radius, mu = self.paper.A, self.paper.MU
        for row in rows("eval", "--law", "hertz", "--c", "0,0.003,0.006,0.009", "--radius", radius, "--mu", mu):
            force, moment = self.paper.wrench(row["c"])
            self.assertAlmostEqual(force, row["force"], delta=1e-4 * mu)
            self.assertAlmostEqual(moment, row["moment"], delta=1e-4 * mu * radius)
        self.assert_close(self.paper.MU_R, self.paper.wrench(0.0)[1], 1e-4)  # eqs. (4), (5)

    def test_the_page_shows_the_file(self):
        source, at = SIXTY_LINES.read_text(encoding="utf-8"), 0
        blocks = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "paper_in_60_lines.md").read_text(encoding="utf-8"), re.DOTALL)
        for block in blocks:
            at = source.index(block, at) + len(block)
        self.assertLessEqual(source.count("\n", source.index(blocks[0]), at), 60)
        self.assertTrue(source[at:].startswith("\n\ndef read("), "the page shows all of it but the comparison")


class Page(CommandLineTest):
    """docs/paper.md."""

    TEXT = (ROOT / "docs" / "paper.md").read_text(encoding="utf-8")

    def table(self):
        return [[cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]] for line in self.TEXT.splitlines() if line.startswith("| ")]

    def test_no_row_is_empty(self):
        found = self.table()
        self.assertGreater(len(found), 50)
        for row in found:
            self.assertEqual(len(row), 5, row)
            self.assertTrue(all(row), row)

    def test_every_equation_figure_and_table_has_its_row(self):
        first = " ".join(row[0] for row in self.table())
        for number in range(1, 24):
            self.assertRegex(first, rf"\({number}\)")
        for number in range(1, 12):
            self.assertRegex(first, rf"\bFig\. {number}\b")
        self.assertIn("Table 1", first)

    def test_every_command_runs(self):
        (self.directory / "data").symlink_to(DATA)
        (self.directory / "out").mkdir()
        calls = sorted({call for row in self.table() for call in re.findall(r"`(limitcurve [^`]+)`", row[2])})
        self.assertGreater(len(calls), 10)
        for call in calls:
            words = shlex.split(call)
            if words[1] == "report":
                continue  # test_report.py
            done = subprocess.run([EXECUTABLE, *words[1:]], cwd=self.directory, capture_output=True, text=True, check=False, env=os.environ)
            self.assertEqual(done.returncode, 0, f"{call}: {done.stderr}")

    def test_every_test_and_file_is_there(self):
        tests = "\n".join(path.read_text(encoding="utf-8") for suffix in ("cpp", "py") for path in (ROOT / "tests").rglob(f"*.{suffix}"))
        for row in self.table():
            if row[0] == "in the paper":
                continue
            names = re.findall(r"`([A-Za-z]+)\.([A-Za-z0-9]+|test_\w+)`", row[3])
            self.assertTrue(names, row)
            for suite, name in names:
                there = (rf"class {suite}\((?:(?!\nclass )[\s\S])*?def {name}\(" if name.startswith("test_") else rf"\({suite}, {name}\)")
                self.assertTrue(re.search(there, tests), f"{suite}.{name}")
        for target in re.findall(r"\]\(([^)#]+)\)", self.TEXT):
            self.assertTrue((ROOT / "docs" / target).exists(), target)


if __name__ == "__main__":
    unittest.main()
