# SPDX-License-Identifier: MIT
"""Questions that every interface answers alike (data/conformance.csv): here Python's objects, arrays and kernels of
Warp."""

import csv
import functools
import importlib
import math
import sys

import numpy as np
import limitcurve as lc
import pytest

from conftest import warp_step
from limitcurve import arrays


def questions(data):
    with open(data / "conformance.csv", encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            words = row["arguments"].split()
            radius = next((word for word in words if ":" in word), "")
            yield row["quantity"], row["law"], radius, [float(word)
                                                        for word in words
                                                        if word != radius], [float(x) for x in row["answer"].split()]


table_of = functools.cache(functools.partial(lc.Table, tolerance=1e-9))


def objects(table):
    def answer(quantity, radius, of):
        if quantity == "wrench":
            return table.wrench(*of)
        if quantity == "gauge":
            return table.gauge(*of), np.float64(table.gauge(*of))
        if quantity == "hold":
            return (table.load_to_hold(*of[1:], mu=of[0], radius_law=radius),)
        if quantity == "closest" and all(map(math.isfinite, of)):
            result = lc.apply_friction(table, *of[:2], limit=1, radius=1, stiffness_ratio=of[2])
            return result.force_fraction * of[0], result.moment_fraction * of[1]
        return None  # margins of files are the command's; apply_friction refuses what is not finite

    return answer


def elements(wrench, closest_point, least=0.0, most=math.inf):
    """A list with numbers, of which one element is asked; nothing where the door's numbers have no room for those of
    the question."""
    functions = {"wrench": wrench, "closest": closest_point}

    def answer(quantity, _, of):
        if quantity not in functions or any(0 < abs(x) < least or most <= abs(x) < math.inf for x in of):
            return None
        return [part[1] for part in functions[quantity]([0.3, of[0], 0.1], *of[1:])[:2]]

    return answer


SINGLE = {"least": 2.0**-149, "most": 2.0**128}


def of_arrays(cells, made=lambda function: function, **limits):
    return elements(*(made(functools.partial(function, cells)) for function in (arrays.wrench, arrays.closest_point)),
                    **limits)


def of_jax(table):
    jax = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", True)

    def compiled(function):
        return jax.jit(lambda first, *rest: jax.vmap(lambda one: function(one, *rest))(jax.numpy.asarray(first)))

    return of_arrays(arrays.cells(table, jax.numpy), compiled, least=sys.float_info.min)  # XLA has 0 for what is less


def of_warp(table):
    wp, lw = pytest.importorskip("warp"), importlib.import_module("limitcurve.warp")
    kernel, cells = warp_step(wp, lw), lw.cells(table, "cpu")

    def answers(first, second, third=1.0):
        given = np.stack(np.broadcast_arrays(first, second, third)).astype(np.float32)
        out = wp.zeros((7, given.shape[1]), dtype=float, device="cpu")
        wp.launch(kernel, given.shape[1], [cells, wp.array(given, dtype=float, device="cpu"), out], device="cpu")
        return out.numpy()

    return elements(lambda *slip: answers(*slip)[3:5], answers, **SINGLE)


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("door, tolerance", [
    (objects, 2e-9),
    (lambda table: of_arrays(arrays.cells(table)), 2e-9),
    (lambda table: of_arrays(arrays.cells(table, np, np.float32), **SINGLE), 1e-6),
    (of_jax, 2e-9),
    (of_warp, 1e-6),
],
                         ids=["objects", "numpy", "numpy in float32", "jax", "warp"])
def test_every_interface_answers_alike(data, door, tolerance):
    tables, asked = {}, 0
    for quantity, law, radius, of, expected in questions(data):
        if law not in tables:
            tables[law] = door(table_of(law))
        table = table_of(law)
        unit = max(table.moment_ratio,
                   1 / table.moment_ratio)  # errors of a table are in units of the larger of 1 and m0
        got = tables[law](quantity, radius, of)
        if got is not None:
            asked += 1
            np.testing.assert_allclose(got[:len(expected)],
                                       expected,
                                       rtol=tolerance * unit,
                                       atol=tolerance * unit,
                                       err_msg=f"{quantity} {law} {radius} {of}")
    assert asked > 150
