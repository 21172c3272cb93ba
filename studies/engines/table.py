# SPDX-License-Identifier: MIT
"""data/engines/errors.csv: how far each engine's friction was from the exact curve, from the points in drag.csv and
drag_pypi.csv."""

import csv
import sys

import drag

points = {}
for path in sys.argv[1:]:
    with open(path, encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            # engine_drag's file has no last columns: its finger is the ball of Hertz.
            row["law"], row["contact"] = row.get("law") or "hertz", row.get("contact") or "ball"
            points.setdefault(tuple(row[name] for name in ("engine", "model", "contact", "law")), []).append(row)

writer = csv.writer(sys.stdout, lineterminator="\n")
print(
    "# Made by studies/engines/measure. radial: largest error of the limit curve's radius; same_cor: largest distance "
    "of the wrench at the same centre of "
    "rotation, over the limits; points: centres of rotation.")
writer.writerow(["engine", "version", "model", "contact", "law", "radial", "same_cor", "points"])
for (engine, model, contact, law), rows in sorted(points.items()):
    radial, apart = drag.errors(rows)
    writer.writerow([engine, rows[0]["version"], model, contact, law, f"{radial:.3f}", f"{apart:.3f}", len(rows)])
