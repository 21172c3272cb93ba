# SPDX-License-Identifier: MIT
"""data/engines/holds.csv: does it hold? Two fingers grip a body of 0.5 kg by 15 N each, mu = 0.9, beside its centre.
The greatest offset at which it turns by less than 2 degrees in 1 s, its turn in 1 s at half of what `hold` allows, and
how far it sinks in 1 s at no offset, with the numbers of `limitcurve translate`."""

import csv
import importlib
import math
import os
import sys

import numpy as np

import drag

MU, GRIP, MASS, WEIGHT = 0.9, 15.0, 0.5, 0.5 * 9.81
HALF, BALL, PAD_MASS, SLOWED = (0.15, 0.04, 0.02), 0.01, 0.05, 5.0  # [m], [m], [kg], [N s/m] where pads slide along z
DISC = ("--law", "hertz", "--radius-law", "constant:a=0.01")


def typed(*contact, engine):
    found = drag.limitcurve("translate", *contact, "--mu", MU, "--engine", engine,
                            *(() if "--patch" in contact else ("--load", GRIP)))
    return {row["parameter"]: float(row["value"]) for row in found}


def turns(make, worlds, offsets, enough=math.inf):
    """A row for each offset [m]: the turn [degrees] in 1 s, at least `enough` or 90 if the body falls, and how far the
    body sinks [m]. `make(offset)`, or `make(offsets)` if there are several worlds, puts the body between the fingers
    and returns a function that steps 1 ms under a weight [N] and returns the turn [rad] and the height [m]."""
    if len(offsets) > worlds:
        return np.vstack([turns(make, worlds, offsets[i:i + worlds], enough) for i in range(0, len(offsets), worlds)])
    step, least = make(offsets if worlds > 1 else offsets[0]), 0.0
    for i in range(2000):
        angle, height = (np.array(one, float, ndmin=1) for one in step(WEIGHT * min(max(i - 300, 0) / 600, 1)))
        start = (angle, height) if i < 1000 else start
        turned, least = np.degrees(abs(angle - start[0])), np.minimum(least, height)
        if np.all((turned > enough) | (least <= -0.03)):
            break
    return np.column_stack([np.where(least > -0.03, turned, 90.0), start[1] - height])


def measured(make, worlds, limit):
    """The greatest offset [m] that holds, to 0.2 mm; the turn at half the limit; the creep [m] at no offset."""
    low, high, known = 0.0, 0.12, None
    while high - low > 2e-4:
        count = max(1, worlds - 2 if known is None else worlds)
        places = np.linspace(low, high, count + 2)[1:-1]
        if known is None:
            first = turns(make, worlds, [0.0, limit / 2, *places])
            known, found = (first[1, 0], first[0, 1]), first[2:]
        else:
            found = turns(make, worlds, places, 2)
        holding = np.cumprod(found[:, 0] < 2).sum()
        low, high = [low, *places][holding], [*places, high][holding]
    return low, *known


def allowed(*contact):
    """The offset [m] that the grip just holds."""
    low, high = 0.0, 0.3
    while high - low > 1e-6:
        middle = (low + high) / 2
        load = float(drag.limitcurve("hold", *contact, "--mu", MU, "--mass", MASS, "--offset", middle)[0]["hold_load"])
        low, high = (middle, high) if load < GRIP else (low, middle)
    return low


def main():
    results = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # engines print what they like
    writer = csv.writer(results, lineterminator="\n")
    names = sys.argv[1:]
    if names[0] == "--header":
        print("# Measured by studies/engines/hold.py: " + " ".join(__doc__.split(": ", 1)[1].split()), file=results)
        writer.writerow(["engine", "version", "setting", "hold", "greatest_offset", "turned_at_half", "creep"])
    for name in names[names[0] == "--header":]:
        for engine, version, setting, contact, make, worlds in importlib.import_module("in_" + name).held():
            limit = allowed(*contact)
            greatest, turned, creep = measured(make, worlds, limit)
            writer.writerow([engine, version, setting, f"{limit:.4f}", f"{greatest:.4f}", f"{turned:.3f}",
                             f"{creep:.5f}"])
            results.flush()


if __name__ == "__main__":
    main()
