#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The report's page in headless Chromium: its links, print, and that anybody can read it. `scripts/setup pages`
installs what this needs.

    tests/site/test_report.py [--page FILE] [unittest arguments]     without --page it makes the report, which takes a
    minute
"""

import argparse
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import browser

ROOT = Path(__file__).resolve().parents[2]
PAGE = None


class Report(browser.PageTest):
    def open(self, *size, **options):
        browser.show(self.browser, PAGE.as_uri(), *size, **options)

    def test_every_link_leads_somewhere(self):
        links = self.script("return [...document.querySelectorAll('main a')].map((a) => a.getAttribute('href'))")
        self.assertGreater(len(links), 80)
        for link in links:
            if link.startswith("#"):
                self.assertEqual(self.script("return document.getElementById(arguments[0])?.tagName", link[1:]), "H2",
                                 link)
            else:
                self.assertTrue(PAGE.with_name(link).exists(), link)
        # A table of contents that misses nothing, and the data of every figure.
        self.assertEqual(self.script("return document.querySelectorAll('nav a').length"),
                         self.script("return document.querySelectorAll('section > h2').length"))
        for figure in self.script("return [...document.querySelectorAll('figure')].map((f) => [f.id, f.innerHTML])"):
            self.assertIn(f"{figure[0]}.svg", figure[1])
            self.assertRegex(figure[1], r'href="\w+\.csv"', figure[0])

    def test_asks_nobody(self):
        self.browser.get_log("performance")
        self.open()
        self.assert_asks_nobody(PAGE)

    def test_prints_figures_as_they_were_drawn(self):
        for scheme in "light", "dark":
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
                "media": "print",
                "features": [{
                    "name": "prefers-color-scheme",
                    "value": scheme
                }]
            })
            self.assertEqual(self.script("return getComputedStyle(document.body).backgroundColor"),
                             "rgb(255, 255, 255)")
            self.assertEqual(self.script("return getComputedStyle(document.querySelector('figure svg')).filter"),
                             "none")
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
    known, others = parser.parse_known_args()
    with tempfile.TemporaryDirectory() as folder:
        if not known.page:
            subprocess.run([ROOT / "scripts" / "demo", folder],
                           env={
                               **os.environ, "LIMITCURVE_PRESET": "ci"
                           },
                           stdout=subprocess.DEVNULL,
                           check=True)
        PAGE = (known.page or Path(folder) / "index.html").resolve()
        unittest.main(argv=[sys.argv[0], *others])
