# SPDX-License-Identifier: MIT
"""Points measured now against those kept: the same engine's curve to 1e-3, whatever its version."""

import csv
import sys

FIELDS = ("engine", "model", "contact", "c")
with open(sys.argv[2], encoding="utf-8") as file:
    kept = {
        tuple(row[name] for name in FIELDS): row
        for row in csv.DictReader(line for line in file if not line.startswith("#"))
    }
with open(sys.argv[1], encoding="utf-8") as file:
    now = list(
        csv.DictReader(
            file,
            ["engine", "version", "model", "c", "force", "moment", "exact_force", "exact_moment", "law", "contact"]))
assert len(now) >= 68, f"{len(now)} points, expected 51 of MuJoCo and 17 of Bullet"
for row in now:
    old = kept[tuple(row[name] for name in FIELDS)]
    for name in ("force", "moment"):
        if not abs(float(row[name]) - float(old[name])) < 1e-3:
            sys.exit(
                f"{row['engine']} {row['version']} {row['model']} c = {row['c']}: {name} = {row[name]}, kept: "
                f"{old[name]} ({old['version']})"
            )
print(f"{len(now)} points as kept")
