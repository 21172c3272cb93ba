#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The site as scripts/maintain/site built it: every page in headless Chromium, from disk. (Sphinx checks the links.)

    scripts/maintain/site && tests/site/test_site.py [unittest arguments]
"""

import unittest
from pathlib import Path

import browser

ROOT = Path(__file__).resolve().parents[2]
SITE = ROOT / "build" / "site"


def pages():
    return sorted(SITE.rglob("*.html"))


def name(path):
    return str(path.relative_to(SITE))


class Browsed(browser.PageTest):
    def open(self, path=None, **how):
        browser.show(self.browser, (path or SITE / "index.html").as_uri(), **how)

    def test_every_page_can_be_read_and_asks_nobody(self):
        for path in pages():
            for dark, touch in ((False, False), (True, False), (False, True)):  # a phone has other buttons
                with self.subTest(page=name(path), dark=dark, touch=touch):
                    self.open(path, width=390 if touch else 1200, height=844, dark=dark, touch=touch)
                    log = " ".join(line["message"] for line in self.browser.get_log("performance"))
                    self.assertIn("Network.requestWillBeSent", log)
                    for scheme in ('"url":"http:', '"url":"https:', '"url":"ws', "Network.loadingFailed"):
                        self.assertNotIn(scheme, log)
                    self.assertEqual(browser.complaints(self.browser), [], "the console has errors")
                    self.assertEqual(browser.nameless_controls(self.browser), [])
                    found = self.script(browser.CONTRASTS)
                    self.assertGreater(len(found), 15)
                    self.assertEqual({what: round(contrast, 2) for what, contrast in found if contrast < 4.5}, {})
                    if touch:
                        self.assertLessEqual(self.script("return document.documentElement.scrollWidth"),
                                             390, "it scrolls sideways")

    def test_search_finds(self):
        for word, page in (("diamond", "validate.html"), ("SoftFinger", "reference/godobject.html"),
                           ("limitcurve_finger_update", "reference/c.html")):
            with self.subTest(word):
                browser.show(self.browser, f"{(SITE / 'search.html').as_uri()}?q={word}")
                script = ("return [...document.querySelectorAll('#search-results a')].map((a) => "
                          "a.href.split(/[?#]/)[0])")
                self.wait(lambda script=script, page=page: (SITE / page).as_uri() in self.script(script),
                          message=f"{page} is not found")

    def test_light_and_dark_by_a_button(self):
        ground = "return getComputedStyle(document.body).backgroundColor"
        light = self.script(ground)
        self.script("document.querySelector('.theme-toggle').click()")
        self.assertNotEqual(self.script(ground), light)
        self.script("localStorage.clear()")

    def test_formulas_are_drawn(self):
        self.open(SITE / "theory.html")
        sizes = self.script(
            "return [...document.querySelectorAll('math')].map((e) => [e.textContent, e.getBoundingClientRect().width, "
            "e.getBoundingClientRect().height])"
        )
        self.assertGreater(len(sizes), 40)
        for text, width, height in sizes:
            with self.subTest(text):
                self.assertGreater(min(width, height), 4)
        # A fraction is higher than a line, a root and an integral are MathML's own, and no TeX is left.
        self.assertGreater(
            self.script("return document.querySelector('math mfrac').getBoundingClientRect().height"),
            25)
        self.assertGreater(
            self.script("return document.querySelectorAll('math msqrt, math mfrac').length"), 10)
        text = self.script("return document.querySelector('article').innerText")
        for left in ("$", "\\frac", "\\int", "\\mathrm"):
            self.assertNotIn(left, text)


if __name__ == "__main__":
    unittest.main()
