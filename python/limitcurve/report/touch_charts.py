# SPDX-License-Identifier: MIT
"""The report's two charts that answer a pointer, a finger and the keyboard: their HTML, and the numbers of the CSVs for touch.js."""

import html
import json
import math
from pathlib import Path

from .chart_style import law_style

DIGITS = 10


def rounded(values):
    """To so many digits that no reading tells the difference; infinity, which JSON lacks, as null."""
    return [None if math.isinf(value) else float(f"{value:.{DIGITS}g}") for value in values]


def numbers(data):
    """What touch.js draws, as JSON: curves.csv; c_curves.csv, and of p_curves.csv the largest load."""
    curves = data["curves"].groups("law")
    centres = {tuple(rows.column("c")) for rows in curves.values()}
    if len(centres) != 1:
        raise ValueError("curves.csv: the laws have different centres of rotation")
    laws = [{"law": law, "colour": law_style(law)["color"], "dashes": " ".join(str(2 * length) for length in law_style(law).get("dashes", ())),
             "force": rounded(rows.column("force")), "moment": rounded(rows.column("moment"))} for law, rows in curves.items()]
    loads = []
    for radius_law, rows in data["c_curves"].groups("radius_law").items():
        cors = {c: [row for row in part if row["load"] > 0] for c, part in rows.groups("c").items()}
        largest = max(row["load"] for row in data["p_curves"].where(radius_law=radius_law))
        p_curve = data["p_curves"].where(radius_law=radius_law, load=largest)
        loads.append({
            "loads": rounded(row["load"] for row in cors[0]),
            "cors": [{"force": rounded(row["force"] for row in part), "moment": rounded(row["moment"] for row in part)} for part in cors.values()],
            "p_curve": {"load": largest, **{name: rounded(p_curve.column(name)) for name in ("c", "force", "moment")}},
        })
    text = json.dumps({"laws": {"c": rounded(centres.pop()), "curves": laws}, "loads": loads}, separators=(",", ":"))
    return text.replace("<", "\\u003c")


def radios(name, legend, choices):
    buttons = "".join(f'<label><input type="radio" name="{name}" value="{value}"{"" if i else " checked"}><span>{text}</span></label>'
                      for i, (value, text) in enumerate(choices))
    return f"<fieldset><legend>{legend}</legend>{buttons}</fieldset>"


def slider(name, label, value, output):
    return (f'<div class="slide"><label for="{name}">{label}</label><input type="range" id="{name}" min="0" max="{value}" value="{value}">'
            f'<output for="{name}" id="{output}"></output></div>')


def plot(name, label):
    return f'<svg id="{name}" class="plot" role="img" aria-label="{html.escape(label, quote=True)}"></svg>'


def limit_curves(data):
    """Every law: point at one, switch it off, read force and moment of all at one centre of rotation."""
    rows = []
    for number, law in enumerate(data["curves"].groups("law")):
        style = law_style(law)
        dashes = " ".join(str(2 * length) for length in style.get("dashes", ()))
        swatch = (f'<svg class="swatch" width="34" height="10" style="width:34px" aria-hidden="true"><path d="M0 5H34" stroke="{style["color"]}" '
                  f'stroke-width="2" stroke-dasharray="{dashes}"/></svg>')
        rows.append(f'<tr><td><label><input type="checkbox" id="law-{number}" checked>{swatch}<span>{html.escape(law).replace("+", "+<wbr>")}</span></label></td>'
                    '<td class="number force"></td><td class="number moment"></td></tr>')
    middle = len(next(iter(data["curves"].groups("law").values()))) // 2
    return f"""<div class="touch" id="laws-chart">
<p>Point at a curve, or move the slider: the table has force and moment of every law at that centre of rotation.</p>
{radios("laws-view", "Axes:", [("units", "in units of μP and μPa"), ("own", "divided by each law’s own limits"), ("lens", "magnified")])}
<div class="parts"><div>{plot("laws-plot", "Limit curves of the laws that are switched on")}
{slider("laws-place", "Centre of rotation", middle, "laws-c")}</div>
<div class="wide"><table id="laws-table"><thead><tr><th>law</th><th class="number">F/(μP)</th><th class="number">M/(μPa)</th></tr></thead>
<tbody>{"".join(rows)}</tbody></table>
<button type="button" id="laws-all">all laws</button><button type="button" id="laws-none">no law</button></div></div></div>"""


def radius(text):
    """A radius law in words."""
    kind, _, parameters = text.partition(":")
    values = dict(item.split("=") for item in parameters.split(","))
    if kind == "constant":
        return f"constant, {1e3 * float(values['a']):.3g} mm"
    return f"growing, {1e3 * float(values['c']):.3g} mm × (P/N)<sup>{values['gamma']}</sup>"


def load_curves(data):
    """p-curve and c-curves: slide the load, point at the p-curve."""
    titles = map(radius, data["c_curves"].groups("radius_law"))
    first = next(iter(data["c_curves"].groups("radius_law").values()))
    centres = list(first.groups("c"))
    count = len([row for row in first.where(c=centres[0]) if row["load"] > 0])
    rows = "".join(f"<tr><td>{'∞' if math.isinf(c) else f'{1e3 * c:g}'}</td><td class='number force'></td><td class='number moment'></td></tr>" for c in centres)
    points = len(data["p_curves"].where(radius_law=first[0]["radius_law"], load=data["p_curves"][0]["load"]))
    return f"""<div class="touch" id="loads-chart">
<p>Slide the load: the p-curve grows with it. The table has force and moment where it meets the c-curves. Point at the p-curve to read it.</p>
{radios("loads-radius", "Contact radius:", list(enumerate(titles)))}
<div class="parts"><div>{plot("loads-plot", "The p-curve of a load, and c-curves")}
{slider("loads-load", "Load", (count - 1) // 2, "loads-load-read")}
{slider("loads-place", "Place on the p-curve", points // 2, "loads-read")}</div>
<div class="wide"><table id="loads-table"><thead><tr><th>c [mm]</th><th class="number">F [N]</th><th class="number">M [N mm]</th></tr></thead>
<tbody>{rows}</tbody></table></div></div></div>"""


def script(data):
    """What goes to the end of the page."""
    text = Path(__file__).with_name("touch.js").read_text(encoding="utf-8")
    return f'<script type="application/json" id="numbers">{numbers(data)}</script>\n<script>\n{text}</script>'
