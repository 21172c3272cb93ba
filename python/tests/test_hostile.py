# SPDX-License-Identifier: MIT
"""Ten thousand calls of a careless or hostile program: an error or a correct result, never a crash."""

import math
import threading

import limitcurve as lc
import numpy as np
import pytest

EXPECTED = (ValueError, TypeError, RuntimeError, OverflowError, MemoryError)


def odd_values():
    array = np.linspace(0, 1, 12)
    frozen = array.copy()
    frozen.flags.writeable = False
    return [
        None,
        True,
        0,
        -1,
        1,
        0.5,
        math.nan,
        math.inf,
        -math.inf,
        1e308,
        5e-324,
        10 ** 400,
        "",
        "hertz",
        "nan",
        "constant:a=0.005",
        b"hertz",
        "\0",
        "\udcff",
        [],
        [1, 2, 3],
        (0, 0, 1),
        [[1], [2, 3]],
        {},
        {
            "load": [1]
        },
        object(),
        1j,
        lc,
        lc.Law,
        array,
        array[::-1],
        array[::5],
        frozen,
        array.reshape(3, 4).T,
        array.astype(np.float32),
        array.astype(np.float16),
        array.astype(">f8"),
        array.astype(complex),
        array.astype(object),
        np.array([math.nan, 1, 2]),
        np.empty((0, 3)),
        np.empty((2, 0)),
        np.zeros((2, 2, 3)),
        np.array("text"),
        np.array(["a", "b"]),
        np.ma.masked_array([1.0, 2, 3], mask=[0, 1, 0]),
        np.datetime64("2020-01-01"),
        np.float64(2),
        np.longdouble(1),
        range(3),
        slice(3),
        np.lib.stride_tricks.as_strided(array, (1 << 14, ), (0, )),
    ]


def test_odd_arguments_are_errors_or_answers():
    values = odd_values()
    random = np.random.default_rng(8)
    table = lc.Table("hertz", 1e-4)
    law = lc.Law("hertz")
    finger = lc.SoftFinger(table)
    patch = lc.Patch("rectangle:x=0.02,y=0.01")
    batch = lc.Batch(table, 12)
    single = lc.Batch(table, 3, dtype=np.float32)
    calls = [
        (lc.Law, 1),
        (lc.Law.samples, 2),
        (law.evaluate, 1),
        (lc.Table, 2),
        (lc.Table.load, 1),
        (table.evaluate, 1),
        (table.gauge, 2),
        (lambda f, m, mu, text: table.load_to_hold(f, m, mu=mu, radius_law=text), 4),
        (lc.ellipse, 2),
        (lc.box, 2),
        (finger.update, 5),
        (lambda a, b, c: lc.SoftFinger(table, mu=a, radius_law=b, projection=c), 3),
        (lambda a, b: lc.SoftFinger(a, stiffness=b), 2),
        (batch.update, 5),
        (single.update, 4),
        (lambda n, dtype: lc.Batch(table, n if not isinstance(n, int) or n < 100 else 3, dtype=dtype), 2),
        (lc.Patch, 1),
        (lc.Patch.points, 3),
        (lc.Patch.polygon, 2),
        (lc.Patch.image, 2),
        (lambda a, b: lc.Patch.image(a, spacing=b), 2),
        (patch.wrench, 3),
        (lambda x, y, m, mu: patch.load_to_hold(x, y, m, mu=mu), 4),
        (patch.orthotropic, 2),
        (lambda a, b, c, d, e: lc.apply_friction(table, a, b, limit=c, radius=d, stiffness_ratio=e), 5),
        (lambda a: lc.SoftFinger(patch, mu=a), 1),
        (lambda a: lc.run("curve", law=a, points=5), 1),
        (lambda a, b: lc.fit("ratio", a, law=b), 2),
        (lambda a: lc.translate("hertz", a, 0.5, 1), 1),
        (lambda a, b: lc.replay(a, "hertz", mu=b, stiffness=1000, twist_stiffness=0.04, radius_law="constant:a=0.005"),
         2),
        (lc.run, 2),
    ]
    errors = answers = 0
    while errors + answers < 10_000:
        call, count = calls[random.integers(len(calls))]
        arguments = [values[random.integers(len(values))] for _ in range(count)]
        try:
            call(*arguments)
            answers += 1
        except EXPECTED as error:
            told = str(error) or type(error) is MemoryError
            assert told and "incompatible function arguments" not in str(error), arguments
            errors += 1
    assert errors > 5000 and answers > 300
    # All is as it was.
    assert table.evaluate(1.0) == lc.Table("hertz", 1e-4).evaluate(1.0)


def test_arrays_of_a_wrong_length_or_kind_are_named():
    table = lc.Table("hertz", 1e-4)
    batch = lc.Batch(table, 5)
    zero = np.zeros(5)
    for call, told in (
        (lambda: batch.update(zero, np.zeros(4), zero, zero), r"^y: got the shape \(4,\), expected \(5,\)$"),
        (lambda: batch.update(zero, zero, zero.astype(complex), zero),
         "^depth: got an array of complex128, expected real numbers$"),
        (lambda: batch.update(0, 0, 0, 0, math.nan), r"^dt = nan \[?s?"),
        (lambda: lc.Batch(table, 5, damping=1), "a batch has no dampers"),
        *((lambda name=name: lc.Batch(table, 5, **{name: 0.5}),
           f"^{name}: expected none, a batch refuses no jump and fades no output")
          for name in ("max_speed", "fault_decay")),
        (lambda: lc.SoftFinger(lc.box(1, 0.6), projection="radial"), "closest-point only"),
        (lambda: lc.Patch("rectangle:x=0.02,y=0.01").wrench([1, 2, 3, 4]), r"^twists: got the shape \(4,\)"),
        (lambda: batch.fx.__setitem__(0, 1), "read-only")):
        with pytest.raises(ValueError, match=told):
            call()


def test_threads_share_tables_batches_and_commands():
    table = lc.Table("hertz", 1e-6)
    batch = lc.Batch(table, 10_000)
    x = np.linspace(0, 0.01, 10_000)
    zero = np.zeros(10_000)
    c = np.linspace(0, 5, 10_000)
    expected = table.evaluate(c)
    wrong = []

    def work():
        for _ in range(50):
            batch.update(x, zero, 0.001, zero)
            if not np.array_equal(table.evaluate(c), expected):
                wrong.append("evaluate")
            if lc.run("eval", law="hertz", c=1)["c"][0] != 1:
                wrong.append("run")

    threads = [threading.Thread(target=work) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong
    alone = lc.Batch(table, 10_000)
    for _ in range(100):
        alone.update(x, zero, 0.001, zero)
    assert np.array_equal(alone.fx, batch.fx) and np.array_equal(alone.state, batch.state)


class Interrupted:
    """The user presses Ctrl-C while NumPy or Python reads a value."""

    def __array__(self, *arguments, **keywords):
        raise KeyboardInterrupt

    __float__ = __bool__ = __len__ = __iter__ = __array__


def test_an_interruption_stays_one():
    table = lc.Table("hertz", 1e-4)
    finger = lc.SoftFinger(table)
    for call in (table.evaluate, lambda x: lc.SoftFinger(table, mu=x), lambda x: finger.update(x, (0, 0, 1), 0, 0),
                 lambda x: finger.update((x, 0, 0), (0, 0, 1), 0, 0), lambda x: finger.update(
                     (0, 0, 0), (0, 0, 1), 0, 0, landed=x), lambda x: lc.run("eval", law="hertz", c=x),
                 lambda x: lc.fit("ratio", {
                     "load": x,
                     "force": x,
                     "moment": x
                 }), lc.Patch.image):
        with pytest.raises(KeyboardInterrupt):
            call(Interrupted(), 1e-3) if call is lc.Patch.image else call(Interrupted())


def test_a_list_that_changes_while_it_is_read():
    point = [0.0, 0.0, 0.0]

    class Clears:
        def __float__(self):
            point.clear()
            return 0.0

    point[0] = Clears()
    out = lc.SoftFinger(lc.Table("hertz", 1e-4)).update(point, (0, 0, 1), 0.001, 0)
    assert out.state == lc.ContactState.stick and point == []


@pytest.mark.parametrize("point", [{
    0: 1,
    1: 2,
    2: 3
}, {0.0, 1.0, 2.0}, "123", b"123",
                                   iter([0, 0, 0]), (x for x in (0, 0, 0)),
                                   np.zeros((3, 1)),
                                   np.zeros((1, 3)), [0, 0],
                                   np.array([0, 0, 0], "m8[ms]"),
                                   np.ma.masked_array([0.0, 0, 0], [0, 1, 0]), [0, 0, "0"]])
def test_a_point_is_a_sequence_of_three_numbers(point):
    with pytest.raises(ValueError, match="^point: (got|expected)"):
        lc.SoftFinger(lc.Table("hertz", 1e-4)).update(point, (0, 0, 1), 0.001, 0)
