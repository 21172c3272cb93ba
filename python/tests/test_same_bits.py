# SPDX-License-Identifier: MIT
"""Python gives the same bits as the C interface, and so as C++ (tests/c/same_bits_test.cpp), on 10^5 random inputs each."""

import ctypes
import os
import pathlib

import limitcurve as lc
import numpy as np
import pytest

N = 100_000


@pytest.fixture(scope="module")
def library():
    path = pathlib.Path(os.environ.get("LIMITCURVE_C", pathlib.Path(__file__).resolve().parents[2] / "build/ci/c/liblimitcurve-c.so"))
    if not path.exists():
        pytest.skip(f"no {path}")
    return ctypes.CDLL(str(path))


def pointer(array):
    return array.ctypes.data_as(ctypes.c_void_p)


def handle(function, *arguments):
    made = ctypes.c_void_p()
    assert function(*arguments, ctypes.byref(made)) == 0
    return made


def cors():
    random = np.random.default_rng(5)
    return np.concatenate([[0, 1, np.inf], 10 ** random.uniform(-20, 20, N // 2), 10 ** random.uniform(-1, 1, N // 2 - 3)])


class Parameters(ctypes.Structure):
    _fields_ = [("mu", ctypes.c_double), ("mu_dynamic", ctypes.c_double), ("radius_law", ctypes.c_char_p)] + [
        (name, ctypes.c_double)
        for name in ("mu_r", "gamma", "mu_r_dynamic", "stiffness", "twist_stiffness", "damping",
                     "twist_damping", "rest_margin", "max_displacement", "fault_decay")
    ]


class Contact(ctypes.Structure):
    _fields_ = [("point", ctypes.c_double * 3), ("normal", ctypes.c_double * 3), ("depth", ctypes.c_double), ("twist", ctypes.c_double),
                ("landed", ctypes.c_int)]


class Output(ctypes.Structure):
    _fields_ = [("proxy", ctypes.c_double * 3), ("angle", ctypes.c_double), ("depth", ctypes.c_double), ("normal", ctypes.c_double * 3),
                ("load", ctypes.c_double), ("force", ctypes.c_double * 3), ("moment", ctypes.c_double), ("cor", ctypes.c_double),
                ("slip_work", ctypes.c_double), ("state", ctypes.c_int), ("converged", ctypes.c_int), ("fault", ctypes.c_int)]


@pytest.mark.parametrize("text", [b"hertz", b"uniform", b"flat-punch"])
def test_evaluate(library, text):
    law = handle(library.limitcurve_law_parse, text)
    c = cors()
    results = [np.empty(N) for _ in range(4)]
    assert library.limitcurve_law_evaluate(law, pointer(c), ctypes.c_size_t(N), *map(pointer, results)) == 0
    mine = lc.Law(text.decode()).evaluate(c, error=True)
    assert np.array_equal(mine[:2], results[:2])
    assert (np.array(mine[2:]) >= results[2:]).all()  # Python's errors are those of `eval`, with the rounding of c
    library.limitcurve_law_free(law)


def test_table(library):
    law = handle(library.limitcurve_law_parse, b"hertz")
    table = handle(library.limitcurve_table_build, law, ctypes.c_double(1e-8))
    c = cors()
    force, moment = np.empty(N), np.empty(N)
    assert library.limitcurve_table_evaluate(table, pointer(c), ctypes.c_size_t(N), pointer(force), pointer(moment)) == 0
    mine = lc.Table("hertz", 1e-8)
    assert np.array_equal(mine.evaluate(c), [force, moment])
    gauge = np.empty(N)
    assert library.limitcurve_table_gauge(table, pointer(force), pointer(moment), ctypes.c_size_t(N), pointer(gauge)) == 0
    assert np.array_equal(mine.gauge(force, moment), gauge)


def test_finger(library):
    law = handle(library.limitcurve_law_parse, b"hertz")
    table = handle(library.limitcurve_table_build, law, ctypes.c_double(1e-6))
    library.limitcurve_finger_defaults.restype = Parameters
    parameters = library.limitcurve_finger_defaults()
    parameters.mu, parameters.mu_dynamic, parameters.radius_law, parameters.damping = 0.6, 0.5, b"power:c=0.00207,gamma=0.259", 1.0
    finger = handle(library.limitcurve_finger_new, table, ctypes.byref(parameters), 2)
    mine = lc.SoftFinger(lc.Table("hertz", 1e-6), mu=0.6, mu_dynamic=0.5, radius_law="power:c=0.00207,gamma=0.259", damping=1)
    random = np.random.default_rng(6)
    x, y = np.cumsum(2e-4 * random.normal(size=(2, N)), axis=1)
    depth = 1e-3 * (1 + random.normal(size=N))
    twist = np.cumsum(0.05 * random.normal(size=N))
    output = Output()
    states = np.zeros(4, int)
    for i in range(N):
        contact = Contact((x[i], y[i], 0), (0, 0, 1), depth[i], twist[i], i % 64 == 63)
        dt, load = ctypes.c_double(1e-3), 1e3 * depth[i]
        if i % 128 < 64:
            assert library.limitcurve_finger_update(finger, ctypes.byref(contact), dt, ctypes.byref(output)) == 0
            out = mine.update((x[i], y[i], 0), (0, 0, 1), depth[i], twist[i], 1e-3, landed=i % 64 == 63)
        else:  # by the load, in place of the depth
            assert library.limitcurve_finger_update_under_load(finger, ctypes.byref(contact), ctypes.c_double(load), dt, ctypes.byref(output)) == 0
            out = mine.update_under_load((x[i], y[i], 0), (0, 0, 1), load, twist[i], 1e-3, landed=i % 64 == 63)
        states[output.state] += 1
        if (int(out.state), out.load, out.moment, out.angle, out.slip_work) != (output.state, output.load, output.moment, output.angle, output.slip_work):
            raise AssertionError(i)
        if i % 10 == 0:
            assert out.force.tolist() == list(output.force) and out.proxy.tolist() == list(output.proxy)
    assert (states[:3] > 1000).all()


def test_batch(library):
    law = handle(library.limitcurve_law_parse, b"hertz")
    table = handle(library.limitcurve_table_build, law, ctypes.c_double(1e-8))
    library.limitcurve_finger_defaults.restype = Parameters
    parameters = library.limitcurve_finger_defaults()
    batch = handle(library.limitcurve_batch_new, table, ctypes.byref(parameters), 2)
    mine = lc.Batch(lc.Table("hertz", 1e-8), N)
    memory = [np.zeros(N, np.uint8 if kind == "u" else np.float64) for kind in "ddduuudd"]
    results = [np.zeros(N) for _ in range(3)]
    random = np.random.default_rng(7)
    for _ in range(10):
        inputs = [scale * (random.normal(size=N) + offset) for scale, offset in ((1e-3, 0), (1e-3, 0), (0.1, 0), (1e-3, 1))]
        arrays = (ctypes.c_void_p * 15)(*[array.ctypes.data for array in inputs + memory + results])
        assert library.limitcurve_batch_step(batch, arrays, ctypes.c_size_t(N)) == 0
        x, y, angle, depth = inputs
        mine.update(x, y, depth, angle)
        for view, other in zip((mine.fx, mine.fy, mine.moment, mine.state, mine.proxy_x), (*results, memory[3], memory[0])):
            assert np.array_equal(view, other)
    assert (mine.state == lc.ContactState.slip).sum() > 1000
