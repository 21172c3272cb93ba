#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The report's page in headless Chromium: what its two charts that answer say, against the command line; a pointer, a finger, keys; print; and that
anybody can read it. `scripts/setup pages` installs what this needs.

    tests/site/test_report.py [--page FILE] [--cli EXECUTABLE] [unittest arguments]     without --page it makes the report, which takes a minute
"""

import argparse
import csv
import io
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

import browser

ROOT = Path(__file__).resolve().parents[2]
PAGE = None
CLI = str(ROOT / "build" / "ci" / "cli" / "limitcurve")
FRICTION = "0.6"  # of the report's p- and c-curves


def run(*arguments):
    """The only row."""
    done = subprocess.run([CLI, *arguments], capture_output=True, text=True, check=True)
    [row] = csv.DictReader(io.StringIO(done.stdout))
    return {name: float(value) for name, value in row.items()}


def rows(name):
    with open(PAGE.with_name(f"{name}.csv"), newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Report(browser.PageTest):
    def open(self, *size, **options):
        browser.show(self.browser, PAGE.as_uri(), *size, **options)
        self.browser.execute_script("document.documentElement.style.scrollBehavior = 'auto'")
        self.wait(lambda: self.browser.execute_script("return document.querySelectorAll('#loads-plot path').length > 5"))

    def script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def place(self, chart, x, y):
        """Where a point of a chart lies in the window, from what its axes say: the two lowest labels of each."""
        return self.script("""
            const svg = document.getElementById(arguments[0]);
            svg.scrollIntoView({block: "center"});
            const frame = svg.getBoundingClientRect(), texts = [...svg.querySelectorAll(":scope > text:not([transform])")].slice(0, -1);
            const along = (end, coordinate) => {
              const [[p, v], [q, w]] = texts.filter((t) => (t.getAttribute("text-anchor") === "end") === end)
                .map((t) => [Number(t.getAttribute(coordinate)) - (end ? 4 : 0), Number(t.textContent)]);
              return (value) => p + (value - v) * (q - p) / (w - v);
            };
            return [frame.left + along(false, "x")(arguments[1]), frame.top + along(true, "y")(arguments[2])];""", chart, x, y)

    def hover(self, chart, x, y):
        left, top = self.place(chart, x, y)
        self.browser.execute_cdp_cmd("Input.dispatchMouseEvent", {"type": "mouseMoved", "x": left, "y": top})

    def laws(self):
        """Force and moment of every law in the table, those that are switched off as nothing; the one pointed at."""
        table = self.script("return [...document.querySelectorAll('#laws-table tbody tr')].map((r) => [...r.cells].map((c) => c.textContent))")
        pointed = self.script("return document.querySelector('#laws-table .pointed')?.cells[0].textContent")
        return {law: (force and float(force), moment and float(moment)) for law, force, moment in table}, pointed

    def cor(self):
        text = self.element("laws-c").text
        return math.inf if "∞" in text else 0.0 if text.startswith("c = 0:") else float(re.fullmatch(r"c = (\S+) a", text)[1])

    def assert_as_evaluated(self):
        shown, c = self.laws()[0], self.cor()
        for law, (force, moment) in shown.items():
            if force == "":
                continue
            exact = run("eval", "--law", law, "--c", repr(c))
            self.assertAlmostEqual(force, exact["force"], delta=2e-5, msg=law)  # five digits of c, five decimals of the wrench
            self.assertAlmostEqual(moment, exact["moment"], delta=2e-5, msg=law)

    # One curve for each law.

    def test_a_point_says_its_centre_force_and_moment(self):
        for law, c in (("hertz", "0.4"), ("flat-punch", "1.5"), ("power:n=2.3", "0.1")):
            exact = run("eval", "--law", law, "--c", c)
            self.hover("laws-plot", exact["force"], exact["moment"])
            self.assertEqual(self.laws()[1], law)
            self.assertAlmostEqual(self.cor() / float(c), 1, delta=0.05)  # the next of its points
            self.assert_as_evaluated()

    def test_the_slider_from_end_to_end(self):
        slider = self.element("laws-place")
        for key, c in ((Keys.HOME, 0), (Keys.END, math.inf)):
            slider.send_keys(key)
            self.assertEqual(self.cor(), c)
            self.assert_as_evaluated()
        slider.send_keys(*[Keys.ARROW_LEFT] * 50)
        self.assert_as_evaluated()
        self.assertEqual(slider.get_attribute("aria-valuetext"), self.element("laws-c").text)

    def test_laws_are_switched(self):
        drawn = lambda: self.script("return document.querySelectorAll('#laws-plot path').length")
        names = [row["law"] for row in rows("laws")]
        self.assertEqual(list(self.laws()[0]), names)
        self.assertEqual(drawn(), len(names))
        exact = run("eval", "--law", "hertz", "--c", "0.4")
        self.element("law-0").click()
        self.assertEqual(drawn(), len(names) - 1)
        self.assertEqual(self.laws()[0]["hertz"], ("", ""))
        self.hover("laws-plot", exact["force"], exact["moment"])
        self.assertNotEqual(self.laws()[1], "hertz")
        self.element("laws-none").click()
        self.assertEqual(drawn(), 0)
        self.element("law-0").send_keys(" ")
        self.hover("laws-plot", exact["force"], exact["moment"])
        self.assertEqual(self.laws()[1], "hertz")
        self.element("laws-all").click()
        self.assertEqual(drawn(), len(names))

    def test_the_axes(self):
        for view in ("own", "lens"):
            self.script("document.querySelector(`input[name=laws-view][value=${arguments[0]}]`).click()", view)
            self.assertEqual(self.script("return document.querySelectorAll('#laws-plot path').length"), len(rows("laws")) + 1)  # and the ellipse
            exact = run("eval", "--law", "uniform", "--c", "0.66")
            self.hover("laws-plot", exact["force"], exact["moment"] * 3 / 2)
            self.assertEqual(self.laws()[1], "uniform")
            self.assert_as_evaluated()

    # Loads and centres of rotation.

    def read(self):
        """Load [N] and the point of the p-curve, [mm], [N], [N mm]."""
        found = re.fullmatch(r"c = (\S+) mm, F = (\S+) N, M = (\S+) N mm", self.element("loads-read").text)
        return float(self.element("loads-load-read").text.split()[0]), *(math.inf if text == "∞" else float(text) for text in found.groups())

    def assert_as_c_curves(self, radius_law):
        def exact(c, load):
            row = run("c-curves", "--law", "hertz", "--radius-law", radius_law, "--mu", FRICTION, "--cors", repr(c * 1e-3), "--loads", repr(load))
            return row["force"], 1e3 * row["moment"]

        load, c, *wrench = self.read()
        for value, other in zip(wrench, exact(c, load)):
            self.assertAlmostEqual(value, other, delta=2e-4)
        table = self.script("return [...document.querySelectorAll('#loads-table tbody tr')].map((r) => [...r.cells].map((c) => c.textContent))")
        self.assertGreaterEqual(len(table), 5)
        for c, *wrench in table:
            for value, other in zip(wrench, exact(math.inf if c == "∞" else float(c), load)):
                self.assertAlmostEqual(float(value), other, delta=6e-5)

    def test_the_load_slides(self):
        radius_laws = list(dict.fromkeys(row["radius_law"] for row in rows("c_curves")))
        for i, radius_law in enumerate(radius_laws):
            self.script("document.querySelector(`input[name=loads-radius][value='${arguments[0]}']`).click()", i)
            for keys in ([Keys.HOME], [Keys.ARROW_RIGHT] * 17, [Keys.END]):
                self.element("loads-load").send_keys(*keys)
                self.assert_as_c_curves(radius_law)
            self.assertEqual(self.read()[0], max(float(row["load"]) for row in rows("c_curves")))
            for keys in ([Keys.HOME], [Keys.ARROW_RIGHT] * 20, [Keys.END]):
                self.element("loads-place").send_keys(*keys)
                self.assert_as_c_curves(radius_law)
            self.assertEqual(self.read()[1], math.inf)
            self.element("loads-load").send_keys(Keys.HOME)

    def test_a_point_of_the_p_curve(self):
        law = rows("c_curves")[0]["radius_law"]
        exact = run("c-curves", "--law", "hertz", "--radius-law", law, "--mu", FRICTION, "--cors", "0.001", "--loads", repr(self.read()[0]))
        self.hover("loads-plot", exact["force"], 1e3 * exact["moment"])
        self.assertAlmostEqual(self.read()[1], 1, delta=0.05)
        self.assert_as_c_curves(law)

    def test_a_finger_points_too(self):
        self.open(390, 844, touch=True)
        exact = run("eval", "--law", "flat-punch", "--c", "0.5")
        x, y = self.place("laws-plot", exact["force"], exact["moment"])
        for kind, points in (("touchStart", [{"x": x, "y": y}]), ("touchEnd", [])):
            self.browser.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        self.wait(lambda: self.laws()[1] == "flat-punch")
        self.assertAlmostEqual(self.cor() / 0.5, 1, delta=0.05)

    # What a page must be.

    def test_every_link_leads_somewhere(self):
        links = self.script("return [...document.querySelectorAll('main a')].map((a) => a.getAttribute('href'))")
        self.assertGreater(len(links), 80)
        for link in links:
            if link.startswith("#"):
                self.assertEqual(self.script("return document.getElementById(arguments[0])?.tagName", link[1:]), "H2", link)
            else:
                self.assertTrue(PAGE.with_name(link).exists(), link)
        # A table of contents that misses nothing, and the data of every figure.
        self.assertEqual(self.script("return document.querySelectorAll('nav a').length"), self.script("return document.querySelectorAll('section > h2').length"))
        for figure in self.script("return [...document.querySelectorAll('figure')].map((f) => [f.id, f.innerHTML])"):
            self.assertIn(f"{figure[0]}.svg", figure[1])
            self.assertRegex(figure[1], r'href="\w+\.csv"', figure[0])

    def test_asks_nobody(self):
        self.browser.get_log("performance")
        self.open()
        self.hover("laws-plot", 0.5, 0.5)
        self.assert_asks_nobody(PAGE)

    def test_keys_alone(self):
        reached = []
        for _ in range(140):
            ActionChains(self.browser).send_keys(Keys.TAB).perform()
            reached.append(self.browser.switch_to.active_element.get_attribute("id"))
        self.assertLessEqual({"laws-place", "law-0", "law-8", "laws-all", "laws-none", "loads-load", "loads-place"}, set(reached))

    def test_prints_figures_and_no_controls(self):
        visible = lambda: self.script("return ['.touch', '#limit_curves .still', '#load_curves .still'].map((s) => document.querySelector(s).checkVisibility())")
        self.assertEqual(visible(), [True, False, False])
        for scheme in "light", "dark":
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print", "features": [{"name": "prefers-color-scheme", "value": scheme}]})
            self.assertEqual(visible(), [False, True, True])
            self.assertEqual(self.script("return [...document.querySelectorAll('input, button')].filter((e) => e.checkVisibility()).length"), 0)
            self.assertEqual(self.script("return getComputedStyle(document.body).backgroundColor"), "rgb(255, 255, 255)")
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})

    def test_contrast(self):
        for dark in (False, True):
            self.open(dark=dark)
            found = self.script(browser.CONTRASTS)
            self.assertGreater(len(found), 100)
            self.assert_contrast(found, dark=dark)

    def test_every_control_has_a_name_and_the_phone_needs_no_sideways_scrolling(self):
        self.assert_controls_have_names_and_a_phone_is_wide_enough()


if __name__ == "__main__":
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--page", type=Path)
    parser.add_argument("--cli", default=CLI)
    known, others = parser.parse_known_args()
    CLI = known.cli
    with tempfile.TemporaryDirectory() as folder:
        if not known.page:
            subprocess.run([ROOT / "scripts" / "demo", folder], env={**os.environ, "LIMITCURVE_PRESET": "ci"}, stdout=subprocess.DEVNULL, check=True)
        PAGE = (known.page or Path(folder) / "index.html").resolve()
        unittest.main(argv=[sys.argv[0], *others])
