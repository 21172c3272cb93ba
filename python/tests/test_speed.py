# SPDX-License-Identifier: MIT
"""The overhead of Python: ratios in one run, of arrays of 10^6 to the library's own loop, and of a single step to a step in C.

The least of several runs each, because others use the machine too; repeated where a neighbour got in the way.
"""

import ctypes
import os
import pathlib
import subprocess
import time

import limitcurve as lc
import numpy as np
import pytest
from test_same_bits import Parameters, handle, library, pointer  # noqa: F401  (library is a fixture)

N = 1_000_000
ROOT = pathlib.Path(__file__).resolve().parents[2]


def least(work, times=9):
    best = np.inf
    for _ in range(times):
        began = time.perf_counter()
        work()
        best = min(best, time.perf_counter() - began)
    return best


def ratio(mine, other, bound):
    """Of the least times of both, taken in turns; the best of three, if it is not below the bound at once."""
    ratios = []
    mine()  # the first call of a batch only touches down
    other()
    for _ in range(3):
        times = least(mine), least(other)
        ratios.append(times[0] / times[1])
        print(f"{1e3 * times[0]:.2f} ms from Python, {1e3 * times[1]:.2f} ms from C")
        if ratios[-1] <= bound:
            break
    return min(ratios)


@pytest.mark.parametrize("kind", ["law", "table"])
def test_evaluate_costs_what_the_loop_costs(library, kind):  # noqa: F811
    c = np.random.default_rng(1).uniform(0, 3, N)
    law = handle(library.limitcurve_law_parse, b"hertz")
    mine = lc.Law("hertz") if kind == "law" else lc.Table("hertz", 1e-8)
    if kind == "law":
        other, on = library.limitcurve_law_evaluate, law
    else:
        other, on = library.limitcurve_table_evaluate, handle(library.limitcurve_table_build, law, ctypes.c_double(1e-8))

    def loop():  # with results of its own, as the other
        force, moment = np.empty(N), np.empty(N)
        other(on, pointer(c), ctypes.c_size_t(N), pointer(force), pointer(moment), None, None)

    assert ratio(lambda: mine.evaluate(c), loop, 1.1) <= 1.1


@pytest.mark.parametrize("kind", [float, np.float32])
def test_a_number_costs_less_than_a_microsecond(kind):
    table, one = lc.Table("hertz", 1e-8), kind(0.5)
    for call, given in ((table.evaluate, [one]), (table.wrench, [one, one])):
        nanoseconds = min(least(lambda: [call(*given) for _ in range(10_000)]) for _ in range(3)) / 1e-5
        print(f"{nanoseconds:.0f} ns")
        assert nanoseconds < 1000


def test_single_precision_costs_what_double_does():
    table = lc.Table("hertz", 1e-8)
    c = np.random.default_rng(1).uniform(0, 3, N)
    single = c.astype(np.float32)
    assert ratio(lambda: table.evaluate(single), lambda: table.evaluate(c), 1.25) <= 1.25


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_a_batch_costs_what_the_loop_costs(library, dtype):  # noqa: F811
    law = handle(library.limitcurve_law_parse, b"hertz")
    library.limitcurve_finger_defaults.restype = Parameters
    parameters = library.limitcurve_finger_defaults()
    if dtype is np.float64:
        table = handle(library.limitcurve_table_build, law, ctypes.c_double(1e-6))
        batch, step = handle(library.limitcurve_batch_new, table, ctypes.byref(parameters), 2), library.limitcurve_batch_step
    else:
        batch = handle(library.limitcurve_batch_new_float, law, ctypes.c_double(1e-6), ctypes.byref(parameters), 2)
        step = library.limitcurve_batch_step_float
    mine = lc.Batch(lc.Table("hertz", 1e-6), N, dtype=dtype)
    random = np.random.default_rng(2)
    inputs = [[(scale * (random.normal(size=N) + offset)).astype(dtype) for scale, offset in ((1e-3, 0), (1e-3, 0), (0.1, 0), (1e-3, 1))] for _ in range(2)]
    # Arrays whole pages apart share lines of the cache: each begins 320 bytes farther, as ContactArrays has it.
    own = []
    for i, kind in enumerate("ddduuudd" + "ddd"):
        item = np.dtype(np.uint8 if kind == "u" else dtype)
        shift = 320 * i // item.itemsize
        own.append(np.zeros(N + shift, item)[shift:])
    turn = {"mine": 0, "other": 0}

    def python():
        turn["mine"] += 1
        x, y, angle, depth = inputs[turn["mine"] % 2]
        mine.update(x, y, depth, angle)

    def loop():
        turn["other"] += 1
        arrays = (ctypes.c_void_p * 15)(*[array.ctypes.data for array in inputs[turn["other"] % 2] + own])
        step(batch, arrays, ctypes.c_size_t(N))

    assert ratio(python, loop, 1.1) <= 1.1


def test_a_step_costs_at_most_60_steps(tmp_path, library):  # noqa: F811
    path = pathlib.Path(library._name)
    program = tmp_path / "finger_loop"
    here = pathlib.Path(__file__).parent
    subprocess.run(["cc", "-std=c99", "-O2", f"-I{ROOT / 'c'}", here / "finger_loop.c", path, "-o", program], check=True)
    finger = lc.SoftFinger(lc.Table("hertz", 1e-6), mu=0.6, radius_law="constant:a=0.006")
    normal = np.array([0.0, 0, 1])
    place = np.zeros(3)

    def steps(slips):
        def work():
            for i in range(20_000):
                place[0] = slips * 3e-5 * i
                finger.update(place, normal, 0.002, slips * 1e-2 * i, 1e-3)

        return work

    environment = {**os.environ, "LD_LIBRARY_PATH": str(path.parent)}
    plain = [1e-9 * float(line) for line in subprocess.run([program], env=environment, capture_output=True, text=True, check=True).stdout.split()]
    for slips in (0, 1):
        mine = least(steps(slips)) / 20_000
        print(f"{'slip' if slips else 'stick'}: {1e9 * mine:.0f} ns from Python, {1e9 * plain[slips]:.0f} ns from C")
        assert mine <= 60 * plain[slips]
