#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The site as scripts/maintain/site built it: its links, and every page in headless Chromium, from disk.

    scripts/maintain/site && tests/site/test_site.py [--site FOLDER] [unittest arguments]
"""

import argparse
import sys
import unittest
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urldefrag, urlsplit

import browser

ROOT = Path(__file__).resolve().parents[2]
SITE = ROOT / "build" / "site"


class Page(HTMLParser):
    """Where a page leads and what leads to it: `links` to elsewhere, `files` that it loads, `anchors` that it has."""

    def __init__(self, path):
        super().__init__()
        self.links, self.files, self.anchors = [], [], {"", "#"}
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.anchors |= {attributes[name] for name in ("id", "name") if attributes.get(name)}
        if tag == "a" and attributes.get("href"):
            self.links.append(attributes["href"])
        elif tag == "link" and attributes.get("rel") == "stylesheet":
            self.files.append(attributes["href"])
        elif attributes.get("src"):
            self.files.append(attributes["src"])


def pages():
    return sorted(SITE.rglob("*.html"))


def name(path):
    return str(path.relative_to(SITE))


class Links(unittest.TestCase):
    def test_links_lead_to_a_page_and_a_place_on_it(self):
        self.assertGreater(len(pages()), 30)
        parsed = {path: Page(path) for path in pages()}
        checked = 0
        for path, page in parsed.items():
            for address in page.links:
                if urlsplit(address).scheme in ("http", "https", "mailto"):
                    continue
                target, anchor = urldefrag(address)
                target = (path.parent / unquote(target)).resolve() if target else path
                with self.subTest(page=name(path), link=address):
                    self.assertTrue(target.is_file() and target.is_relative_to(SITE), "no such page")
                    if target in parsed:
                        self.assertIn(unquote(anchor), parsed[target].anchors)
                checked += 1
        print(f"{checked} links on {len(parsed)} pages", file=sys.stderr)
        self.assertGreater(checked, 1000)

    def test_pages_load_files_of_the_site_only(self):
        for path in pages():
            for address in Page(path).files:
                with self.subTest(page=name(path), file=address):
                    if not address.startswith("data:"):
                        self.assertTrue((path.parent / unquote(urlsplit(address).path)).is_file(), "no such file")

    def test_every_job_is_reached_from_the_front_page(self):
        links = {urldefrag(link)[0] for link in Page(SITE / "index.html").links}
        self.assertLessEqual(
            {
                "generate.html", "validate.html", "drive.html", "measure_and_fit.html", "which_number.html",
                "choosing.html", "theory.html", "paper.html", "not_round.html", "stability.html", "glossary.html",
                "accuracy.html", "speed.html", "CONTRIBUTING.html", "cli/README.html", "reference/limitcurve.html",
                "reference/c.html", "reference/python.html", "playground/index.html"
            }, links)


class Browsed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = browser.start()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()

    def show(self, path, **how):
        browser.show(self.browser, path.as_uri(), **how)

    def test_every_page_can_be_read_and_asks_nobody(self):
        for path in pages():
            for dark, touch in ((False, False), (True, False), (False, True)):  # a phone has other buttons
                with self.subTest(page=name(path), dark=dark, touch=touch):
                    self.show(path, width=390 if touch else 1200, height=844, dark=dark, touch=touch)
                    log = " ".join(line["message"] for line in self.browser.get_log("performance"))
                    self.assertIn("Network.requestWillBeSent", log)
                    for scheme in ('"url":"http:', '"url":"https:', '"url":"ws', "Network.loadingFailed"):
                        self.assertNotIn(scheme, log)
                    self.assertEqual(browser.complaints(self.browser), [], "the console has errors")
                    self.assertEqual(browser.nameless_controls(self.browser), [])
                    found = self.browser.execute_script(browser.CONTRASTS)
                    self.assertGreater(len(found), 15)
                    self.assertEqual({what: round(contrast, 2) for what, contrast in found if contrast < 4.5}, {})
                    if touch:
                        self.assertLessEqual(self.browser.execute_script("return document.documentElement.scrollWidth"),
                                             390, "it scrolls sideways")

    def test_search_finds(self):
        for word, page in (("diamond", "validate.html"), ("SoftFinger", "reference/godobject.html"),
                           ("limitcurve_finger_update", "reference/c.html")):
            with self.subTest(word):
                browser.show(self.browser, f"{(SITE / 'search.html').as_uri()}?q={word}")
                script = ("return [...document.querySelectorAll('#search-results a')].map((a) => "
                          "a.href.split(/[?#]/)[0])")
                browser.wait(self,
                             lambda script=script, page=page:
                             (SITE / page).as_uri() in self.browser.execute_script(script),
                             message=f"{page} is not found")
                self.assertEqual(browser.complaints(self.browser), [])

    def test_light_and_dark_by_a_button(self):
        self.show(SITE / "index.html")
        ground = "return getComputedStyle(document.body).backgroundColor"
        light = self.browser.execute_script(ground)
        self.browser.execute_script("document.querySelector('.theme-toggle').click()")
        self.assertNotEqual(self.browser.execute_script(ground), light)
        self.browser.execute_script("localStorage.clear()")

    def test_formulas_are_drawn(self):
        browser.show(self.browser, (SITE / "theory.html").as_uri())
        sizes = self.browser.execute_script(
            "return [...document.querySelectorAll('math')].map((e) => [e.textContent, e.getBoundingClientRect().width, "
            "e.getBoundingClientRect().height])"
        )
        self.assertGreater(len(sizes), 40)
        for text, width, height in sizes:
            with self.subTest(text):
                self.assertGreater(min(width, height), 4)
        # A fraction is higher than a line, a root and an integral are MathML's own, and no TeX is left.
        self.assertGreater(
            self.browser.execute_script("return document.querySelector('math mfrac').getBoundingClientRect().height"),
            25)
        self.assertGreater(
            self.browser.execute_script("return document.querySelectorAll('math msqrt, math mfrac').length"), 10)
        text = self.browser.execute_script("return document.querySelector('article').innerText")
        for left in ("$", "\\frac", "\\int", "\\mathrm"):
            self.assertNotIn(left, text)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--site", type=Path, default=SITE)
    known, others = parser.parse_known_args()
    SITE = known.site.resolve()
    unittest.main(argv=[sys.argv[0], *others])
