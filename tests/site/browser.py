# SPDX-License-Identifier: MIT
"""Headless Chromium for the tests of pages, and what they ask of every page."""

import time
import unittest

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By

# The contrast of two colours, each red, green and blue up to 255 (WCAG 2).
RATIO = """
const light = (c) => c.map((v) => (v /= 255) <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
  .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
const ratio = (a, b) => { const [x, y] = [light(a), light(b)].sort((p, q) => q - p); return (x + 0.05) / (y + 0.05); };
"""

# Of every element with text of its own, [what, contrast of its colour on what lies behind it].
CONTRASTS = RATIO + """
const parse = (c) => { const [r, g, b, a = 1] = c.match(/[\\d.]+/g).map(Number); return [r, g, b, a]; };
const over = (top, below) => [0, 1, 2].map((i) => top[3] * top[i] + (1 - top[3]) * below[i]);
const behind = (e) => {
  if (!e) return [255, 255, 255];
  const c = parse(getComputedStyle(e).backgroundColor);
  return c[3] === 1 ? c.slice(0, 3) : over(c, behind(e.parentElement));
};
const result = [];
for (const e of document.querySelectorAll("body *")) {
  const own = [...e.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim());
  const typed = e.tagName === "SELECT" || e.matches("input:not([type=range], [type=checkbox], [type=radio])");
  if (!own && !typed || ["SCRIPT", "STYLE", "OPTION"].includes(e.tagName)) continue;
  if (!e.checkVisibility({checkOpacity: true, checkVisibilityCSS: true})) continue;
  const what = e.tagName + "#" + e.id + "." + e.getAttribute("class") + " " + e.textContent.trim().slice(0, 30);
  const ground = behind(e), placed = getComputedStyle(e, "::placeholder").color;
  result.push([what, ratio(over(parse(getComputedStyle(e).color), ground), ground)]);
  if (e.placeholder) result.push([what + " placeholder", ratio(over(parse(placed), ground), ground)]);
}
return result;
"""

CONTROLS = {
    "application", "button", "checkbox", "combobox", "image", "img", "link", "radio", "searchbox", "slider", "textbox"
}


def start():
    options = webdriver.ChromeOptions()
    for argument in ["--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"]:
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    browser = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    browser.set_script_timeout(60)
    return browser


def show(browser, address, width=1200, height=1000, dark=False, touch=False):
    command = browser.execute_cdp_cmd
    command("Emulation.setDeviceMetricsOverride", {
        "width": width,
        "height": height,
        "deviceScaleFactor": 1,
        "mobile": touch
    })
    command("Emulation.setTouchEmulationEnabled", {"enabled": touch})
    command("Emulation.setEmulatedMedia",
            {"features": [{
                "name": "prefers-color-scheme",
                "value": "dark" if dark else "light"
            }]})
    browser.get(address)


def complaints(browser):
    return [line for line in browser.get_log("browser") if line["level"] in ("SEVERE", "WARNING")]


def nameless_controls(browser):
    """What a screen reader finds without a name: by the browser's own tree of accessibility."""
    nodes = browser.execute_cdp_cmd("Accessibility.getFullAXTree", {})["nodes"]
    return [(node["role"]["value"], node.get("backendDOMNodeId")) for node in nodes if not node.get("ignored")
            and node.get("role", {}).get("value") in CONTROLS and not node.get("name", {}).get("value", "").strip()]


class PageTest(unittest.TestCase):
    """Each test begins with a page that has loaded, and ends with a console that has nothing to say."""

    @classmethod
    def setUpClass(cls):
        cls.browser = start()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()

    def setUp(self):
        self.open()

    def tearDown(self):
        self.assertEqual(complaints(self.browser), [], "the console has errors")

    def wait(self, condition, seconds=8.0, message="it did not come to be"):
        end = time.monotonic() + seconds
        while not (result := condition()):
            self.assertLess(time.monotonic(), end, message)
            time.sleep(0.02)
        return result

    def script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def element(self, name):
        return self.browser.find_element(By.ID, name)

    def assert_asks_nobody(self, page):
        """Since the log was last read, and since the page was opened."""
        log = " ".join(line["message"] for line in self.browser.get_log("performance"))
        self.assertIn(page.as_uri(), log)
        for scheme in ('"url":"http:', '"url":"https:', '"url":"ws'):
            self.assertNotIn(scheme, log)
        loaded = "return performance.getEntriesByType('resource').filter((e) => !e.name.startsWith('data:')).length"
        self.assertEqual(self.script(loaded), 0)

    def assert_contrast(self, found, **page):
        for what, contrast in found:
            with self.subTest(what, **page):
                self.assertGreaterEqual(contrast, 4.5)

    def assert_controls_have_names_and_a_phone_is_wide_enough(self):
        self.assertEqual(nameless_controls(self.browser), [])
        for width in (320, 390):
            self.open(width, 844, touch=True)
            self.assertLessEqual(self.script("return document.documentElement.scrollWidth"), width)
