# SPDX-License-Identifier: MIT
"""docs/paper.md: nothing in it points to what is not there, and its quotations are the paper’s."""

import re
import unittest
from pathlib import Path


ROOT = Path(__file__).resolve().parents[2]

# The paper's own words that docs/paper.md quotes, by section, compared word for word with the paper.
QUOTATIONS = {
    "1": ["no real additional computational cost"],
    "2": ["almost independent of the material"],
    "3": ["do not influence each other in any way"],
    "4": ["the friction is independent of sliding speed"],
    "4.1": ["do not present particular differences", "approximated by circles with unitary radius"],
    "4.2": ["the characteristics of the instantaneous sliding motion are preserved"],
    "6": [
        "a smooth rotation of the block with a small amount of translation",
        "a movement with constant pressure and a reconfiguration of the instantaneous center of rotation",
        "not as much smooth", "unable to simulate a realistic manipulation"
    ],
    "7": [
        "easily implemented in real-time",
        "can predict the frictional behavior of a planar object between two soft finger contacts"
    ],
}
# The one text of three words and more that other pages have in quotation marks: the title of a work.
TITLES = {"Tangential torque effects on the control of grip forces when holding objects with a precision grip"}


class Page(unittest.TestCase):
    TEXT = (ROOT / "docs" / "paper.md").read_text(encoding="utf-8")

    def table(self):
        return [[cell.strip()
                 for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
                for table in self.TEXT.split("\n\n")
                if table.startswith("| in the paper")
                for line in table.splitlines()
                if line.startswith("| ")]

    def test_no_row_is_empty(self):
        found = self.table()
        self.assertGreater(len(found), 50)
        for row in found:
            self.assertEqual(len(row), 4, row)
            self.assertTrue(all(row), row)
            self.assertRegex(row[2], r"`[A-Za-z]+\.\w+`|^test$", row)

    def test_quotations_are_the_papers_words_and_stand_here_once(self):
        found = {}
        for section in re.split(r"(?m)^## ", self.TEXT)[1:]:
            first = [re.split(r"(?<!\\)\|", line)[1] for line in section.splitlines() if line.startswith("| ")]
            quoted = [text for cell in first for text in re.findall(r'"([^"]+)"', cell)]
            if quoted:
                found[section.split()[0]] = quoted
        self.assertEqual(found, QUOTATIONS)
        every = [text for quoted in QUOTATIONS.values() for text in quoted]
        for text in every:
            self.assertEqual(self.TEXT.count(text), 1, text)
        modules = [
            module for module in ROOT.iterdir()
            if module.is_dir() and module.name not in ("build", "out", ".git", "tests")
        ]
        pages = [
            *ROOT.glob("*.md"),
            *(page for module in modules for kind in ("*.md", "*.rst", "*_figures.py") for page in module.rglob(kind))
        ]
        pages.remove(ROOT / "docs" / "paper.md")
        self.assertGreater(len(pages), 20)
        for path in pages:
            text = path.read_text(encoding="utf-8")
            for quoted in every:
                self.assertNotIn(quoted.lower(), re.sub(r"\s+", " ", text).lower(), path)
            straight = [] if path.suffix == ".py" else re.findall(
                r'"([^"\n]+)"', re.sub(r"```.*?```|`[^`\n]*`", "", text, flags=re.DOTALL))
            for quoted in straight + re.findall(r"“([^”]+)”", text):
                self.assertTrue(len(quoted.split()) < 3 or quoted in TITLES, f"{path}: is this a quotation? {quoted}")

    def test_every_equation_figure_and_table_has_its_row(self):
        first = " ".join(row[0] for row in self.table())
        for number in range(1, 24):
            self.assertRegex(first, rf"\({number}\)")
        for number in range(1, 12):
            self.assertRegex(first, rf"\bFig\. {number}\b")
        self.assertIn("Table 1", first)



if __name__ == "__main__":
    unittest.main()
