# SPDX-License-Identifier: MIT
"""The tables of the page "Which number do I type?", from data/engines. `{engines}`: the coefficients. `{drags}`: the measurements.

engines.csv (scripts/maintain/measure_engines) has the engines that were measured; read.csv those that were read. Of an engine that was measured the rows that were read are left out.
"""

import csv
from pathlib import Path

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.util.docutils import SphinxDirective

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "data" / "engines"
NAMES = {"bullet": "Bullet", "dart": "DART", "drake": "Drake", "mujoco": "MuJoCo", "newton-xpbd": "Newton (XPBD)", "ode": "ODE", "physx": "PhysX"}


def rows(name):
    path = FOLDER / name
    if not path.exists():
        return []
    with path.open(encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def percent(fraction):
    if not fraction:
        return "–"
    value = 100 * float(fraction)
    return (f"{value:.0f}" if value >= 10 else f"{value:.2g}") + "\N{NO-BREAK SPACE}%"


class Table(SphinxDirective):
    def render(self, head, body):
        """A Markdown table, so that code and links in cells work."""
        lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
        lines += ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in body]
        node = nodes.container(classes=[type(self).__name__.lower()])
        self.state.nested_parse(StringList(lines, self.arguments[0] if self.arguments else ""), 0, node)
        return [node]


class Engines(Table):
    def run(self):
        measured = rows("engines.csv")
        names = {row["engine"].split()[0].lower() for row in measured}
        read = [row for row in rows("read.csv") if row["engine"].split()[0].lower() not in names]
        body = []
        before = None
        for row in sorted(measured + read, key=lambda row: row["engine"].lower()):
            parameters = row["parameter"].split(";")
            units = row["unit"].split(";") + [""] * len(parameters)
            typed = "<br>".join(f"`{name.strip()}` [{unit.strip()}]" if unit.strip() not in ("", "1") else f"`{name.strip()}`"
                                for name, unit in zip(parameters, units))
            how = "measured" if row["how"] == "measured" else f"[read]({row['link']})"
            model = row["model"] + (f" ({row['law']})" if row["law"] not in ("", "hertz") else "")
            ignores = "the same" if before == (row["engine"], row["ignores"]) else row["ignores"]
            before = (row["engine"], row["ignores"])
            body.append([f"**{NAMES.get(row['engine'], row['engine'])}**<br>{row['version']}, {how}", typed, model, percent(row["max_error"]),
                         percent(row["cor_error"]), ignores])
        return self.render(["engine", "what to type", "its model", "radial error", "same COR", "what it ignores"], body)


class Drags(Table):
    def run(self):
        groups = {}
        for row in rows("drag.csv") + rows("drag_pypi.csv"):
            key = (row["engine"], row["version"], row["model"], row.get("law") or "hertz", row.get("contact") or "ball")
            off = max(abs(float(row["force"]) - float(row["exact_force"])), abs(float(row["moment"]) - float(row["exact_moment"])))
            groups.setdefault(key, []).append(off)
        body = [[NAMES.get(key[0], key[0]), *key[1:], str(len(offs)), percent(max(offs)), percent(sum(offs) / len(offs))]
                for key, offs in sorted(groups.items())]
        return self.render(["engine", "version", "model", "law", "contact", "CORs", "largest", "mean"], body)


def setup(app):
    app.add_directive("engines", Engines)
    app.add_directive("drags", Drags)
