# SPDX-License-Identifier: MIT
"""What a wheel must do where nothing else is installed: `wheel.py WHEEL README`, run by scripts/maintain/package."""

import importlib.metadata
import pathlib
import pickle
import re
import sys

import limitcurve as lc
import numpy as np


def check_licences(readme):
    metadata = importlib.metadata.metadata("limitcurve")
    said = readme.partition("## Licences\n")[2]
    libraries = {
        name.lower(): set(licences.split(", "))
        for name, licences in re.findall(r"([\w.-]+) \(([^)]*)\)", said)
    }
    assert set(metadata["License-Expression"].split(" AND ")) == set.union(
        {"MIT"}, *libraries.values()), (metadata["License-Expression"], libraries)
    files = set(metadata.get_all("License-File"))
    assert files == {"LICENSE", *(f"LICENSE.{name}" for name in libraries)}, (files, libraries)
    inside = [file for file in importlib.metadata.files("limitcurve") if "licenses" in file.parts]
    assert {file.name for file in inside} == files and not any("GPL" in file.read_text() for file in inside)


def check_copies():
    table = lc.Table("hertz", tolerance=1e-6)
    finger = lc.SoftFinger(table, mu=0.6, radius_law="constant:a=0.006")
    out = finger.update((0, 0, 0), (0, 0, 1), 0.002, 0.1, 1e-3)
    things = [lc.Law("hertz"), table, lc.Patch("rectangle:x=0.02,y=0.01"), finger, out, lc.Batch(table, 3, mu=0.6)]
    again = [pickle.loads(pickle.dumps(one)) for one in things]
    assert list(map(type, again)) == list(map(type, things)) and again[1].evaluate(0.3) == table.evaluate(0.3)


def check_fit():
    load = np.linspace(0.5, 5, 10)
    fit = lc.fit("load", dict(load=load, radius=0.006 * load ** (1 / 3)), quiet=True)
    assert abs(fit["value"][list(fit["parameter"]).index("gamma")] - 1 / 3) < 1e-6, fit


if __name__ == "__main__":
    wheel, readme = map(pathlib.Path, sys.argv[1:])
    assert wheel.stat().st_size < 5e6, wheel.stat().st_size
    assert ("abi3" in wheel.name) == (sys.version_info >= (3, 12)), wheel
    check_licences(readme.read_text(encoding="utf-8"))
    check_copies()
    check_fit()
