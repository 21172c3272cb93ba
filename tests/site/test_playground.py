#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The playground in headless Chromium: its numbers against `limitcurve replay` and `limitcurve pivot`, every way to
move it, every switch, its speed, and that anybody can read it. `scripts/setup pages` installs the browser.

    scripts/maintain/playground && tests/site/test_playground.py [unittest arguments]
"""

import csv
import io
import itertools
import math
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
from selenium.webdriver.support.ui import Select

import browser

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "build" / "site" / "playground" / "index.html"
CLI = str(ROOT / "build" / "ci" / "cli" / "limitcurve")

COLUMNS = ("px", "py", "angle", "depth", "load", "fx", "fy", "moment", "cor")
# What the canvases write with, on what they are cleared to.
CANVAS_CONTRASTS = browser.RATIO + """
const style = getComputedStyle(document.documentElement);
const hex = (name) => style.getPropertyValue("--" + name).trim().match(/[0-9a-f]{2}/g).map((v) => parseInt(v, 16));
return ["text", "muted", "slip"].map((name) => ["canvas " + name, ratio(hex(name), hex("card"))]);
"""


def run(*arguments, text=None):
    result = subprocess.run([CLI, *arguments], input=text, capture_output=True, text=True, check=True)
    return list(csv.DictReader(io.StringIO(result.stdout)))


def trace():
    """Presses, slides, turns, reverses, spins past half a turn (the twist wraps), changes its load, lifts and touches
    down again."""
    rows = []
    for i in range(2000):
        t = i * 1e-3
        depth = 0.003 + 0.0015 * math.sin(3.1 * t) if not 1400 <= i < 1430 else -0.001
        twist = 2.5 * math.sin(1.7 * t) + 1.1 * t
        rows.append({"time": t, "x": 0.012 * math.sin(2.3 * t), "y": 0.007 * math.cos(1.9 * t) - 0.002 * t, "z": -depth,
                     "twist": math.remainder(twist, 2 * math.pi)})
    return rows


class Playground(browser.PageTest):
    def open(self, width=1200, height=1000, dark=False, touch=False):
        browser.show(self.browser, PAGE.as_uri(), width, height, dark, touch)
        self.wait(lambda: self.script(
            "return window.limitcurve !== undefined && limitcurve.frames.count > 3"))

    def actions(self):
        return ActionChains(self.browser)

    def number(self, name):
        return float(self.element(name).text)

    def suggest(self, name):
        self.script(f"document.querySelector('[data-try={name}]').click()")

    def show_block(self):
        self.script("document.querySelector('input[value=block]').click()")

    def call(self, function, first, options):
        script = (f"const done = arguments[arguments.length - 1]; limitcurve.{function}(arguments[0], "
                  "arguments[1]).then(done, (e) => done(String(e)))")
        result = self.browser.execute_async_script(script, first, options)
        self.assertIsInstance(result, list, result)
        return result

    # Numbers.

    def test_replays_as_the_command_line_does(self):
        rows = trace()
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "trace.csv"
            path.write_text("time,x,y,z,twist\n" + "".join(",".join(map(repr, row.values())) + "\n" for row in rows))
            for law, (curve, projection), exponent, (twist_stiffness, damping) in itertools.product(
                ("hertz", "uniform", "parabolic", "flat-punch", "cone", "xydas-kao:k=3", "gaussian:sigma=0.4"),
                (("exact", "closest-point"), ("exact", "radial"), ("exact", "c-curve"), ("ellipse", "closest-point"),
                 ("ellipse", "radial"), ("ellipse", "c-curve"), ("box", "closest-point")), (0, 1 / 3),
                ((0.004, 0), (0.04, 2))):
                with self.subTest(law=law, curve=curve, projection=projection, exponent=exponent, damping=damping):
                    self.compare(rows, path, law, curve, projection, exponent, twist_stiffness, damping)

    def compare(self, rows, path, law, curve, projection, exponent, twist_stiffness, damping):
        twist_damping = 1e-5 * damping
        of_curve = ["--curve", "table", "--tolerance", "1e-9"] if curve == "exact" else ["--curve", curve]
        expected = run("replay", "--trace", str(path), "--law", law, "--radius-law", f"power:c=0.006,gamma={exponent}",
                       "--mu", "0.6", "--stiffness", "300", "--twist-stiffness", str(twist_stiffness), "--damping",
                       str(damping), "--twist-damping", str(twist_damping), "--projection", projection, *of_curve)
        got = self.call(
            "replay", rows, {
                "law": law,
                "curve": curve,
                "projection": projection,
                "mu": 0.6,
                "radius": 0.006,
                "exponent": exponent,
                "stiffness": 300,
                "twistStiffness": twist_stiffness,
                "damping": damping,
                "twistDamping": twist_damping
            })
        self.assertGreater(sum(row["state"] == "slip" for row in expected), 500)
        # Every bit, unless the radius is a power of the load: the C library of either side rounds that in its own way.
        self.assert_same(expected, got, {name: name for name in COLUMNS}, *((1e-12, 1e-14) if exponent else (0, 0)))

    def assert_same(self, expected, got, columns, relative, absolute):
        self.assertEqual(len(got), len(expected))
        for want, have in zip(expected, got):
            self.assertEqual(have["state"], want["state"], want["time"])
            for column, name in columns.items():
                wanted = float(want[column])
                if have[name] is None:  # the browser's word for what is not finite
                    self.assertFalse(math.isfinite(wanted), f"{column} at {want['time']}")
                elif not math.isclose(have[name], wanted, rel_tol=relative, abs_tol=absolute):
                    self.fail(f"{column} at {want['time']}: {have[name]!r}, the command line has {wanted!r}")

    def test_the_block_moves_as_the_command_line_says(self):
        for case, curve, projection in (("coupled", "ellipse", "radial"), ("exact", "exact", "closest-point"),
                                        ("uncoupled", "box", "closest-point")):
            with self.subTest(case=case):
                extra = ["--tolerance", "1e-9"] if case == "exact" else []
                expected = run("pivot", "--case", case, "--release", "from=0.5,to=0.2,over=3", "--duration", "3",
                               *extra)
                moment_ratio = 3 * math.pi / 16
                stiffness = 1000 * (0.01011 / 1.67) ** 2
                got = self.call(
                    "pivot", [float(row["load"]) for row in expected], {
                        "law": "hertz",
                        "curve": curve,
                        "projection": projection,
                        "mu": 1.67,
                        "radius": 0.01011 / (1.67 * moment_ratio),
                        "stiffness": 1000,
                        "twistStiffness": stiffness,
                        "damping": 5,
                        "twistDamping": 5 * stiffness / 1000
                    })
                self.assertGreater(max(abs(float(row["angle"])) + abs(float(row["y"])) for row in expected), 0.05)
                columns = {"x": "x", "y": "y", "angle": "angle", "friction_force": "force", "friction_moment": "moment"}
                self.assert_same(expected[1:], got, columns, 0, 1e-12)

    def test_a_row_with_a_nan_is_named(self):
        script = (
            "const done = arguments[arguments.length - 1]; limitcurve.replay([{time: 0, x: NaN, y: 0, z: 0, twist: 0}])"
            ".then(() => done('none'), (e) => done(e.message))")
        self.assertIn("row 0: x = NaN", self.browser.execute_async_script(script))

    def test_says_what_it_shows(self):
        for name, shown, low, high in (
            ("radial", "error", 11, 15), ("stiff", "error", 90, 97), ("closest", "error", 0, 0.5),
            ("slide", "force", 0.598, 0.602), ("spin", "force", 0.28, 0.32), ("box", "force", 0.598, 0.602)):
            with self.subTest(name):
                self.suggest(name)
                time.sleep(1.5)
                self.assertTrue(low <= self.number(shown) <= high, self.number(shown))
        self.assertAlmostEqual(abs(self.number("moment")), 0.6 * 6 * 3 * math.pi / 16, delta=0.01)

    # Ways to move it.

    def test_mouse_drags(self):
        self.actions().move_to_element(self.element("scene")).click_and_hold().move_by_offset(
            120, -40).perform()
        self.wait(lambda: self.number("force") > 0.55, message="no friction while dragged")
        self.actions().release().perform()

    def test_wheel_turns(self):
        origin = ScrollOrigin.from_element(self.element("scene"))
        for _ in range(6):
            self.actions().scroll_from_origin(origin, 0, 100).perform()
        self.wait(lambda: abs(self.number("moment")) > 1.5, message="no moment while turned")
        self.assertLess(self.number("force"), 0.05)

    def test_a_wheel_with_ctrl_is_the_page_s(self):
        script = """return [false, true].map((ctrlKey) => {
          const event = new WheelEvent("wheel", {deltaY: 100, ctrlKey, cancelable: true});
          document.getElementById("scene").dispatchEvent(event);
          return event.defaultPrevented; })"""
        self.assertEqual(self.script(script), [True, False])

    def test_two_fingers_turn_and_one_drags(self):
        self.open(390, 844, touch=True)
        self.script("document.getElementById('scene').scrollIntoView({block: 'center'})")
        box = self.script(
            "const b = document.getElementById('scene').getBoundingClientRect(); return [b.x, b.y, b.width, b.height]")
        x, y = box[0] + box[2] / 2, box[1] + box[3] / 2

        def touch(kind, *points):
            self.browser.execute_cdp_cmd("Input.dispatchTouchEvent", {
                "type": kind, "touchPoints": [{"x": px, "y": py, "id": i} for i, (px, py) in enumerate(points)]})
        touch("touchStart", (x, y))
        for i in range(10):
            touch("touchMove", (x + 6 * i, y))
        self.wait(lambda: self.number("force") > 0.5, message="no friction while dragged")
        touch("touchEnd")
        self.script("document.getElementById('restart').click()")
        touch("touchStart", (x - 60, y), (x + 60, y))
        for i in range(1, 16):
            angle = 0.1 * i
            touch("touchMove", (x - 60 * math.cos(angle), y - 60 * math.sin(angle)),
                  (x + 60 * math.cos(angle), y + 60 * math.sin(angle)))
        # Clockwise on the screen, and friction against it.
        self.wait(lambda: self.number("moment") > 1.5, message="no moment while turned")
        self.assertLess(self.number("force"), 0.1)
        touch("touchEnd")

    def hold(self, key, condition, message):
        self.actions().key_down(key).perform()
        try:
            self.wait(condition, message=message)
        finally:
            self.actions().key_up(key).perform()

    def test_keys_alone(self):
        for _ in range(20):
            self.actions().send_keys(Keys.TAB).perform()
            if self.browser.switch_to.active_element.get_attribute("id") == "scene":
                break
        self.assertEqual(self.browser.switch_to.active_element.get_attribute("id"), "scene")
        self.hold(Keys.ARROW_RIGHT, lambda: self.number("force") > 0.59, "no friction")
        self.hold("q", lambda: self.number("moment") < -1, "no moment")
        self.hold("e", lambda: self.number("moment") > 1, "no moment")
        for minus, load in (("-", 0.9), ("−", 0.8)):
            self.hold(minus, lambda load=load: self.number("grip") < load, "no less load")
            left = self.number("grip")
            time.sleep(0.3)
            self.assertGreater(self.number("grip"), left - 0.1, "the key sticks")
        self.hold("+", lambda: self.number("grip") > 1.5,
                  "no load")  # last: a busy machine may hold a key until nothing is left to lift
        self.actions().send_keys(" ").perform()
        self.wait(lambda: self.element("state").text == "free")
        self.assertEqual((self.number("force"), self.number("grip")), (0, 0))
        self.actions().send_keys(" ").perform()
        self.wait(lambda: self.element("state").text == "stick")
        # Every control can be reached.
        reached = set()
        for _ in range(40):
            self.actions().send_keys(Keys.TAB).perform()
            reached.add(self.browser.switch_to.active_element.get_attribute("id"))
        self.assertLessEqual(
            {"load", "coupled", "law", "curve", "projection", "ratio", "radius", "drive", "about", "restart"}, reached)

    def test_the_block_turns_by_loosening_the_grip(self):
        self.show_block()
        self.wait(lambda: self.element("state").text == "stick")
        self.suggest("loosen")
        self.wait(lambda: self.number("turned") > 5, 20, "it does not turn")
        # Tightened, it holds.
        self.element("scene").click()
        self.hold(Keys.ARROW_UP, lambda: self.number("grip") > 0.8, "no more grip")
        self.wait(lambda: self.element("state").text == "stick", message="it does not hold")
        self.suggest("operate")
        self.wait(lambda: self.number("turned") > 28 and self.element("state").text == "stick", 20,
                  "the operator does not turn it")
        self.assertLess(self.number("turned"), 40)

    def test_time_that_the_page_did_not_see_does_not_pass(self):
        # Four seconds in another tab took 0.4 N off the grip.
        self.show_block()
        self.suggest("exactly")
        grip = self.number("grip")
        self.script("const began = performance.now(); while (performance.now() < began + 3000);")
        self.assertGreater(self.number("grip"), grip - 0.1)

    def test_the_uncoupled_block_slides_out_level(self):
        self.show_block()
        self.suggest("drop")
        self.wait(lambda: self.number("slid") > 4, 20, "it does not slide")
        self.assertLess(abs(self.number("turned")), 4)

    # Switches.

    def test_every_switch_acts(self):
        script = "const o = limitcurve.options(); return [o.law, o.curve, o.projection, o.twistStiffness, o.exponent]"
        read = lambda: self.script(script)
        first = read()
        self.assertEqual(first[:3], ["hertz", "exact", "closest-point"])
        for name, position in (("law", 0), ("curve", 1), ("projection", 2)):
            select = Select(self.element(name))
            for option in select.options:
                value = option.get_attribute("value")
                select.select_by_value(value)
                self.assertEqual(read()[position], value)
            select.select_by_index(0)
        Select(self.element("radius")).select_by_index(1)
        self.assertAlmostEqual(read()[4], 1 / 3)
        self.element("ratio").send_keys(*[Keys.ARROW_RIGHT] * 20)
        self.assertAlmostEqual(read()[3] / first[3], 10, delta=1e-9)
        self.element("coupled").click()
        self.assertEqual(read()[1:3], ["box", "closest-point"])
        self.assertFalse(self.element("curve").is_enabled() or self.element("projection").is_enabled())
        self.element("drive").click()
        self.wait(lambda: self.number("force") > 0.55)
        self.element("load").send_keys(Keys.END)
        self.wait(lambda: abs(self.number("grip") - 3) < 1e-9)
        self.element("about").send_keys(Keys.HOME)
        self.wait(lambda: "0.00 a" in self.element("about-value").text)

    def test_a_switch_does_not_drop_the_block(self):
        self.show_block()
        for law in ("uniform", "hertz"):
            Select(self.element("law")).select_by_value(law)
            for curve, projection in (("ellipse", "radial"), ("exact", "closest-point")):
                Select(self.element("curve")).select_by_value(curve)
                Select(self.element("projection")).select_by_value(projection)
                time.sleep(0.1)
                self.assertEqual((self.element("state").text, self.number("turned"), self.number("slid")),
                                 ("stick", 0, 0))
                self.assertAlmostEqual(self.number("force"), 0.4905, delta=6e-4)  # half the weight of 100 g

    # What a page must be.

    def test_is_small_and_asks_nobody(self):
        self.assertLessEqual(PAGE.stat().st_size, 400_000)
        self.browser.get_log("performance")
        self.open()
        self.suggest("radial")
        time.sleep(0.5)
        self.assert_asks_nobody(PAGE)

    def test_contrast(self):
        for dark in (False, True):
            self.open(dark=dark)
            for scene in ("plate", "block"):
                if scene == "block":
                    self.show_block()
                self.suggest("loosen" if scene == "block" else "radial")
                found = self.script(browser.CONTRASTS) + self.script(CANVAS_CONTRASTS)
                self.assertGreater(len(found), 30)
                self.assert_contrast(found, dark=dark)

    def test_every_control_has_a_name_and_the_phone_needs_no_sideways_scrolling(self):
        self.assert_controls_have_names_and_a_phone_is_wide_enough()


if __name__ == "__main__":
    unittest.main()
