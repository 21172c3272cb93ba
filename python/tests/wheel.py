# SPDX-License-Identifier: MIT
"""What a wheel must do where nothing else is installed: `wheel.py WHEEL README`, run by scripts/maintain/package."""

import importlib.metadata
import multiprocessing
import pathlib
import pickle
import re
import signal
import subprocess
import sys
import time

import limitcurve as lc
import numpy as np

LONG = {
    "points": "lc.Law('xydas-kao:k=3').evaluate(np.linspace(0, 3, 10**6))",
    "fit": "lc.fit('law', data)",
}
PREPARED = """
import signal, limitcurve as lc, numpy as np
signal.signal(signal.SIGINT, signal.default_int_handler)  # which a shell's background job ignores
load = np.linspace(0.5, 5, 200_000)
data = dict(load=load, force=0.6 * load, moment=1e-4 * load)
print("ready", flush=True)
"""


def check_licences(readme):
    """The metadata, the texts inside and the page name the same licences and the same libraries."""
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


def work(thing):
    """In another process."""
    return pickle.dumps(thing)


def check_pool():
    table = lc.Table("hertz", tolerance=1e-6)
    finger = lc.SoftFinger(table, mu=0.6, radius_law="constant:a=0.006")
    out = finger.update((0, 0, 0), (0, 0, 1), 0.002, 0.1, 1e-3)
    things = [lc.Law("hertz"), table, lc.Patch("rectangle:x=0.02,y=0.01"), finger, out, lc.Batch(table, 3, mu=0.6)]
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        back = [pickle.loads(text) for text in pool.map(work, things)]
    assert [type(one) for one in back] == [type(one) for one in things]
    assert back[1].evaluate(0.3) == table.evaluate(0.3)


def check_interrupt():
    """Ctrl-C ends long work within a second."""
    for name, code in LONG.items():
        with subprocess.Popen([sys.executable, "-c", PREPARED + code],
                              stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE,
                              text=True) as job:
            job.stdout.readline()
            time.sleep(0.5)
            assert job.poll() is None, f"{name} took less than half a second"
            began = time.monotonic()
            job.send_signal(signal.SIGINT)
            said = job.communicate()[1]
            assert time.monotonic() - began < 1 and "KeyboardInterrupt" in said, (name, said)


def check_fit():
    load = np.linspace(0.5, 5, 10)
    fit = lc.fit("load", dict(load=load, radius=0.006 * load ** (1 / 3)), quiet=True)
    assert abs(fit["value"][list(fit["parameter"]).index("gamma")] - 1 / 3) < 1e-6, fit


if __name__ == "__main__":
    wheel, readme = map(pathlib.Path, sys.argv[1:])
    assert wheel.stat().st_size < 5e6, wheel.stat().st_size
    assert ("abi3" in wheel.name) == (sys.version_info >= (3, 12)), wheel
    check_licences(readme.read_text(encoding="utf-8"))
    check_pool()
    check_interrupt()
    check_fit()
