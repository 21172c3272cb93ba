# SPDX-License-Identifier: MIT
"""Questions that every interface answers alike (data/questions.csv): here Python's objects and arrays."""

import csv
import math

import numpy as np
import limitcurve as lc
import pytest

from limitcurve import arrays


def questions(data):
    with open(data / "questions.csv", encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            words = row["arguments"].split()
            radius = next((word for word in words if ":" in word), "")
            yield row["quantity"], row["law"], radius, [float(word) for word in words if word != radius], [float(x) for x in row["answer"].split()]


def of_table(table, quantity, radius, of):
    if quantity == "wrench":
        return table.wrench(*of)
    if quantity == "gauge":
        return table.gauge(*of), np.float64(table.gauge(*of))
    if quantity == "hold":
        return (table.load_to_hold(*of[1:], mu=of[0], radius_law=radius),)
    if quantity == "closest" and all(map(math.isfinite, of)):
        result = lc.apply_friction(table, *of[:2], limit=1, radius=1, stiffness_ratio=of[2])
        return result.force_fraction * of[0], result.moment_fraction * of[1]
    return None


def of_arrays(cells, quantity, of):
    # A whole array, of which one element is asked.
    one = [np.array([0.3, value, 0.1]) for value in of]
    if quantity == "wrench":
        return [component[1] for component in arrays.wrench(cells, *one)]
    if quantity == "closest":
        return [component[1] for component in arrays.closest_point(cells, *one)[:2]]
    return None


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_every_interface_answers_alike(data):
    tables = {}
    asked = 0
    for quantity, law, radius, of, expected in questions(data):
        if law not in tables:
            table = lc.Table(law, tolerance=1e-9)
            tables[law] = table, arrays.cells(table)
        table, cells = tables[law]
        unit = max(table.moment_ratio, 1 / table.moment_ratio)  # errors of a table are in units of the larger of 1 and m0
        for got in (of_table(table, quantity, radius, of), of_arrays(cells, quantity, of)):
            if got is not None:
                asked += 1
                np.testing.assert_allclose(got[: len(expected)], expected, rtol=2e-9 * unit, atol=2e-9 * unit, err_msg=f"{quantity} {law} {radius} {of}")
    assert asked > 350
