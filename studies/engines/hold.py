# SPDX-License-Identifier: MIT
"""data/engines/holds.csv: does it hold? Two fingers grip a body of 0.5 kg by 15 N each, mu = 0.9, beside its centre.
The greatest offset at which it turns by less than 2 degrees in 1 s, and its turn in 1 s at half of what `hold` allows,
with the numbers of `limitcurve translate`."""

import csv
import importlib
import math
import os
import sys

import drag

MU, GRIP, MASS, WEIGHT = 0.9, 15.0, 0.5, 0.5 * 9.81
HALF, BALL, PAD_MASS, SLOWED = (0.15, 0.04, 0.02), 0.01, 0.05, 5.0  # [m], [m], [kg], [N s/m] where pads slide along z
DISC = ("--law", "hertz", "--radius-law", "constant:a=0.01")


def typed(*contact, engine):
    found = drag.limitcurve("translate", *contact, "--mu", MU, "--engine", engine,
                            *(() if "--patch" in contact else ("--load", GRIP)))
    return {row["parameter"]: float(row["value"]) for row in found}


def turned(make, offset, enough=math.inf):
    """Degrees in 1 s, or some more than enough; 90 where the body falls. `make(offset)` is the body between the
    fingers, as a function that goes on by 1 ms under a weight [N] and gives its turn [rad] and height [m]."""
    step = make(offset)
    for i in range(2000):
        angle, height = step(WEIGHT * min(max(i - 300, 0) / 600, 1))
        began = angle if i < 1000 else began
        if not height > -0.03:
            return 90.0
        if abs(angle - began) > math.radians(enough):
            break
    return math.degrees(abs(angle - began))


def greatest(make):
    """The greatest offset [m] that holds, to 0.2 mm."""
    low, high = 0.0, 0.12
    while high - low > 2e-4:
        middle = (low + high) / 2
        low, high = (middle, high) if turned(make, middle, 2) < 2 else (low, middle)
    return low


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
    print("# Measured by studies/engines/hold.py: " + " ".join(__doc__.split(": ", 1)[1].split()), file=results)
    writer.writerow(["engine", "version", "setting", "hold", "greatest_offset", "turned_at_half"])
    for name in sys.argv[1:]:
        for engine, version, setting, contact, make in importlib.import_module("in_" + name).held():
            limit = allowed(*contact)
            writer.writerow(
                [engine, version, setting, f"{limit:.4f}", f"{greatest(make):.4f}", f"{turned(make, limit / 2):.3f}"])
            results.flush()


if __name__ == "__main__":
    main()
