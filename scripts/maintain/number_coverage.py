# SPDX-License-Identifier: MIT
"""Whether every number of the pages is covered: by a sentence that `check_numbers` makes anew, or by a row of docs/claims.csv."""

import csv
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
# A number that says something: with a unit, an exponent or a decimal point.
NUMBER = re.compile(r"(?<![\w.,^/])(?:\d+(?:\.\d+)?\s?(?:%|°)|\d+(?:\.\d+)? (?:ns|µs|ms|s|N|mm|µm|m|Hz|kHz|KiB|B|bytes)\b|"
                    r"\d+\.\d+(?:e[-−]?\d+)?|\d+e[-−]?\d+)(?![\w.]\d)")
# What says nothing about the program: code and examples, formulas, links, what another script writes and compares (work_precision, stability), numbers of
# sections, licences, versions of three numbers, papers of arXiv.
NO_CLAIM = (r"```.*?```", r"<!-- (\w+): written.*?<!-- end of \1 -->", r"^    .*?$", r"^#+ [\d.]+ ", r"\$\$.*?\$\$", r"\$[^$\n]*\$", r"`[^`]*`", r"\]\([^)]*\)",
            r"§[\d.]+", r"\b(?:MPL|Apache|BSL)-\d\.\d", r"\b\d+\.\d+\.\d+\b", r"arXiv [\d.]+")


def pages():
    found = subprocess.run(["git", "ls-files", "*.md"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    return found.splitlines()


def plain(name):
    return re.sub(r"\s+", " ", (ROOT / name).read_text(encoding="utf-8"))


def listed():
    with open(ROOT / "docs" / "claims.csv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def without(text, words):
    """The text without these words, whatever white space stands between them there."""
    return re.sub(r"\s+".join(map(re.escape, words.split())), " ", text)


def uncovered(sentences):
    """Complaints about numbers that neither a sentence, (file, words), nor a listed claim covers."""
    covered = [*sentences, *((row["file"], row["words"]) for row in listed())]
    wrong = []
    for name in pages():
        text = (ROOT / name).read_text(encoding="utf-8")
        for words in (words for file, words in covered if file == name):
            text = without(text, words)
        for pattern in NO_CLAIM:
            text = re.sub(pattern, " ", text, flags=re.M | re.S)
        text = re.sub(r"\s+", " ", text)
        for number in NUMBER.finditer(text):
            around = text[max(0, number.start() - 50):number.end() + 20]
            wrong.append(f"{name}: nothing covers {number[0]}: … {around} …: make it by check_numbers, or list what holds it in docs/claims.csv")
    return wrong


def check_listed():
    """Complaints about docs/claims.csv."""
    tests = "\n".join(path.read_text(encoding="utf-8") for path in sorted((ROOT / "tests").rglob("*.[ch]pp")))
    wrong = []
    for row in listed():
        if row["words"] not in plain(row["file"]):
            wrong.append(f"{row['file']}: a claim is listed that does not stand there: {row['words']}")
        if not row["how"]:
            wrong.append(f"docs/claims.csv: '{row['words']}': nothing says how it is held")
        if row["kind"] == "test":
            suite, name = row["held_by"].split(".")
            body = re.search(rf"TEST(?:_P|_F)?\({suite}, {name}\) \{{.*?^\}}", tests, re.M | re.S)
            if not body or row["how"] not in body[0]:
                wrong.append(f"docs/claims.csv: test {row['held_by']} does not hold '{row['how']}'")
        elif row["kind"] == "code":
            path = ROOT / row["held_by"]
            if not path.exists() or row["how"] not in path.read_text(encoding="utf-8"):
                wrong.append(f"docs/claims.csv: {row['held_by']} does not hold '{row['how']}'")
        elif row["kind"] != "reading":
            wrong.append(f"docs/claims.csv: kind '{row['kind']}': expected test, code or reading")
        elif not re.match(r"\d{4}-\d\d-\d\d, by \w+", row["how"]):
            wrong.append(f"docs/claims.csv: '{row['words']}': expected the day, and how it was looked at: 2026-11-24, by reading: …")
    return wrong
