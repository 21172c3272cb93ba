#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes the tables of docs/which_number.md, between their marks, from data/engines and what `limitcurve translate` makes of it.

    page.py EXECUTABLE [--check]

With --check nothing is written: exit 1 if a table is not what the files and the program say.
"""

import csv
import io
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
PAGE = ROOT / "docs" / "which_number.md"
EXAMPLE = ["--law", "hertz", "--radius-law", "constant:a=0.005", "--mu", "0.8", "--load", "3"]
SHAPES = {
    "ellipse": ("x² + y² = 1", "wrong centre of rotation"),
    "diamond": ("x + y = 1", "a slip is pure sliding or pure spin"),
    "box": ("x ≤ 1 and y ≤ 1, each alone", "a finger that spins keeps its whole force limit"),
    "point": ("y = 0: a force at a point", "an object held by two turns about their line without friction"),
    "points": ("several points", "collision detection places them"),
    "field": ("pressure on a mesh", "right up to its mesh and its own law"),
}


def facts(name):
    with (ROOT / "data" / "engines" / f"{name}.csv").open(encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def translated(executable):
    done = subprocess.run([executable, "translate", *EXAMPLE], check=True, capture_output=True, text=True)
    return list(csv.DictReader(io.StringIO(done.stdout)))


def percent(text):
    value = 100 * float(text)
    return f"{value:.2g} %" if value < 99.5 else f"{value:.0f} %"


def table(head, rows):
    lines = ["| " + " | ".join(cells) + " |" for cells in [head, *rows]]
    return "\n".join([lines[0], "|" + "---|" * len(head), *lines[1:]])


def readable(formula):
    for word, symbol in (("mu_r", "μ_r"), ("mu", "μ"), ("m0", "m₀"), ("pi", "π")):
        formula = re.sub(rf"\b{word}\b", symbol, formula)
    return formula


def typed(row):
    """What to type, with its formula and its value in the example."""
    value = f"{float(row['value']):.4g}" + (" m" if row["unit"] == "m" and float(row["value"]) else "")
    if re.fullmatch(r"\d+", row["formula"]):
        # The note of a word is the word, or begins with it.
        return f"`{row['parameter']}` = {row['formula']}" + (f" ({row['note']})" if row["value"] in ("0", "1") and row["unit"] == "1" else "")
    return f"`{row['parameter']}` = {readable(row['formula'])} = {value}"


def finger(executable):
    of = {row["formula"]: float(row["value"]) for row in translated(executable)}
    return table(["", "", "a fingertip: Hertz, a = 5 mm, μ = 0.8, 3 N"],
                 [["μ", "friction coefficient", f"{of['mu']:.4g}"], ["μ_r = μ m₀ a", "largest friction moment over the load", f"{of['mu_r']:.4g} m"],
                  ["m₀ a", "the same without μ: the lever", f"{of['m0 a']:.4g} m"]])


def engines(executable):
    rows = []
    numbers = translated(executable)
    for fact in facts("engines"):
        own = [row for row in numbers if (row["engine"], row["model"]) == (fact["engine"], fact["model"])]
        own = own or [row for row in numbers if row["engine"] == fact["engine"]]  # a field has the friction of its engine
        rules = [(kind, next((row["two_bodies"] for row in own if row["formula"] in formulas), "")) for kind, formulas in
                 (("friction", ("mu", "mu/f")), ("moment", ("mu_r", "mu_r/f", "m0 a", "16 m0 a/(3 pi)", "sqrt(m0 a/pi)")))]
        rules = [rule for _, rule in rules[:1]] if rules[1][1] in ("", rules[0][1]) else [": ".join(rule) for rule in rules]
        rows.append([f"[**{fact['name']}**]({fact['link']})<br>{fact['model']}; {fact['how']}, {fact['version']}", "<br>".join(map(typed, own)),
                     "<br>".join([f"*two bodies: {', '.join(rules)}*", readable(fact["needs"]).replace("; ", "<br>")])])
    return table(["engine, its model", "type", "mind"], rows)


def measured(model):
    """The errors found in the engines, those of equal ones together: "physx, disc: 50 %, 57 %"."""
    found = {}
    for row in facts("errors"):
        if row["model"] == model:
            of = "" if (row["contact"], row["law"]) == ("ball", "hertz") else f" ({row['law'] if model == 'field' else row['contact']})"
            found.setdefault((percent(row["radial"]), percent(row["same_cor"])), []).append(row["engine"] + of)
    return "<br>".join(f"{', '.join(names)}: {radial}, {same_cor}" for (radial, same_cor), names in found.items()) or "–"


def models(executable):
    of = {row["model"]: row for row in translated(executable)}
    return table(["model", "limits", "worst: radial, at one COR", "measured at 17 CORs", "what goes wrong"],
                 [[name, limits, f"{percent(of[name]['max_error'])}, {percent(of[name]['cor_error'])}" if name in of else "–", measured(name), wrong]
                  for name, (limits, wrong) in SHAPES.items()])


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    text = page = PAGE.read_text(encoding="utf-8")
    for block in (finger, engines, models):
        mark = f"<!-- {block.__name__}: written by scripts/maintain/engines/page.py -->"
        end = f"<!-- end of {block.__name__} -->"
        if page.count(mark) != 1 or page.count(end) != 1:
            sys.exit(f"{PAGE}: expected one '{mark}' and one '{end}'")
        page = re.sub(re.escape(mark) + ".*?" + re.escape(end), lambda _, body=f"{mark}\n{block(sys.argv[1])}\n{end}": body, page, flags=re.DOTALL)
    if sys.argv[2:]:
        sys.exit(f"{PAGE}: not what data/engines and the program say: run scripts/maintain/engines/page.py {sys.argv[1]}" if page != text else 0)
    PAGE.write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
