# SPDX-License-Identifier: MIT
"""Shared by the tests. They test the installed package; scripts/maintain/python sets the environment."""

import csv
import io
import os
import pathlib
import subprocess

import matplotlib
import numpy as np
import pytest

matplotlib.use("Agg")

SCENE = {"radius_law": "constant:a=0.006", "mu": 0.6, "stiffness": 1000, "twist_stiffness": 0.036}
ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def data():
    return ROOT / "data"


@pytest.fixture(scope="session")
def command_line():
    """The executable of the same tree: `command_line("eval", "--law", …)` gives its rows as lists of texts by
    column."""
    executable = os.environ.get("LIMITCURVE", ROOT / "build/ci/cli/limitcurve")
    if not pathlib.Path(executable).exists():
        pytest.skip(f"no {executable}")

    def run(*arguments):
        done = subprocess.run([executable, *map(str, arguments)], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(done.stderr)
        rows = list(csv.reader(io.StringIO(done.stdout)))
        return {name: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}

    return run


def same(table, texts):
    """Whether arrays equal the command line's output, to the last bit."""
    assert list(table) == list(texts)
    for name, column in texts.items():
        array = table[name]
        assert len(array) == len(column), name
        if array.dtype.kind == "U":
            assert array.tolist() == column, name
        elif array.dtype.kind == "b":
            assert array.tolist() == [text == "true" for text in column], name
        else:
            expected = np.array([np.nan if text == "" else float(text) for text in column])
            assert np.array_equal(array.astype(float), expected, equal_nan=True), name


def warp_step(wp, lw):
    """A kernel: closest points of trials (force, moment, chi); their first two are a slip and an engine's wrench,
    too."""

    @wp.kernel
    def step(cells: lw.Cells, trials: wp.array2d(dtype=float), out: wp.array2d(dtype=float)):
        i = wp.tid()
        force, moment, slips = lw.closest_point(cells, trials[0, i], trials[1, i], trials[2, i])
        slide_force, slide_moment = lw.wrench(cells, trials[0, i], trials[1, i])
        out[0, i] = force
        out[1, i] = moment
        out[2, i] = wp.where(slips, 1.0, 0.0)
        out[3, i] = slide_force
        out[4, i] = slide_moment
        p, q = lw.tangent_ellipse(cells, trials[0, i], trials[1, i], 1.0, 0.6)
        out[5, i] = p
        out[6, i] = q

    return step
