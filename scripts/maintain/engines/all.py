# SPDX-License-Identifier: MIT
"""The points measured in the named engines (modules in_NAME beside this one), as CSV; an engine that is not installed is missing from it."""

import csv
import importlib
import os
import sys

import drag

# Engines print what they like: that goes to standard error.
results = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)
writer = csv.DictWriter(
    results, ["engine", "version", "model", "c", "force", "moment", "exact_force", "exact_moment", "law", "contact"], lineterminator="\n"
)
if "--header" in sys.argv:
    writer.writeheader()
for name in sys.argv[1:]:
    if name == "--header":
        continue
    try:
        module = importlib.import_module("in_" + name)
    except ImportError as error:
        print(f"measure: {name} left out: {error}", file=sys.stderr)
        continue
    rows = list(module.measure())
    writer.writerows(rows)
    for case in dict.fromkeys((row["contact"], row["law"], row["version"], row["model"]) for row in rows):
        found = drag.errors([row for row in rows if (row["contact"], row["law"], row["version"], row["model"]) == case])
        print(name, *case, "max_error %.3f cor_error %.3f" % found, file=sys.stderr)
