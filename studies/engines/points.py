# SPDX-License-Identifier: MIT
"""Points of wrenches in engines, as CSV (see `measure`):

points.py measure [--header] NAME …    of the engines of the modules in_NAME; one that is not installed is missing
points.py compare NEW KEPT             the same engine's curve to 1e-3, whatever its version
points.py table FILE …                 data/engines/errors.csv: how far each engine's friction is from the exact curve
"""

import csv
import importlib
import os
import sys

FIELDS = ("engine", "version", "model", "c", "force", "moment", "exact_force", "exact_moment", "law", "contact")


def read(path, fields=None):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader((line for line in file if not line.startswith("#")), fields))


def key(row, *names):
    return tuple(row[name] for name in names)


def measure(*names):
    # Engines print what they like: that goes to standard error.
    results = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    writer = csv.DictWriter(results, FIELDS, lineterminator="\n")
    if "--header" in names:
        writer.writeheader()
    for name in names[names[0] == "--header":]:
        try:
            module = importlib.import_module("in_" + name)
        except ImportError as error:
            print(f"measure: {name} left out: {error}", file=sys.stderr)
            continue
        writer.writerows(module.measure())


def compare(new, old):
    place = ("engine", "model", "contact", "c")
    kept, now = {key(row, *place): row for row in read(old)}, read(new, FIELDS)
    assert len(now) >= 68, f"{len(now)} points, expected 51 of MuJoCo and 17 of Bullet"
    for row in now:
        before = kept[key(row, *place)]
        for name in ("force", "moment"):
            if not abs(float(row[name]) - float(before[name])) < 1e-3:
                sys.exit(f"{row['engine']} {row['version']} {row['model']} c = {row['c']}: {name} = {row[name]}, kept: "
                         f"{before[name]} ({before['version']})")
    print(f"{len(now)} points as kept")


def table(*paths):
    import drag  # which asks the command
    points = {}
    for row in (row for path in paths for row in read(path)):
        # engine_drag's file has no last columns: its finger is the ball of Hertz.
        row["law"], row["contact"] = row.get("law") or "hertz", row.get("contact") or "ball"
        points.setdefault(key(row, "engine", "model", "contact", "law"), []).append(row)
    print("# Made by studies/engines/measure. radial: largest error of the limit curve's radius; same_cor: largest "
          "distance of the wrench at the same centre of rotation, over the limits; points: centres of rotation.")
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(["engine", "version", "model", "contact", "law", "radial", "same_cor", "points"])
    for (engine, model, contact, law), rows in sorted(points.items()):
        radial, apart = drag.errors(rows)
        writer.writerow([engine, rows[0]["version"], model, contact, law, f"{radial:.3f}", f"{apart:.3f}", len(rows)])


{"measure": measure, "compare": compare, "table": table}[sys.argv[1]](*sys.argv[2:])
