# SPDX-License-Identifier: MIT
"""The points measured in the named engines (modules in_NAME beside this one), as CSV; an engine that is not installed
is missing from it."""

import csv
import importlib
import os
import sys

# Engines print what they like: that goes to standard error.
results = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)
writer = csv.DictWriter(
    results, ["engine", "version", "model", "c", "force", "moment", "exact_force", "exact_moment", "law", "contact"],
    lineterminator="\n")
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
    writer.writerows(module.measure())
