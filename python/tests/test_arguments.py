# SPDX-License-Identifier: MIT
"""What arguments may be: times, units, masks, truths and names of columns; and that Ctrl-C ends long work."""

import signal
import time

import limitcurve as lc
import limitcurve.plot
import numpy as np
import pytest

TABLE = lc.Table("hertz", tolerance=1e-8)


def test_times_that_are_nan():
    """Ticks of any unit once counted as seconds."""
    time = np.arange(3) * np.timedelta64(1, "ms")
    trace = {"time": time, "x": np.zeros(3), "y": np.zeros(3), "z": np.zeros(3), "twist": np.zeros(3)}
    scene = {"radius_law": "constant:a=0.006", "mu": 0.6, "stiffness": 1000, "twist_stiffness": 0.036}
    for column in (time, time + np.datetime64("2024-01-01"), time.astype(object), np.array(list(time), object)):
        with pytest.raises(ValueError, match=r"^trace\['time'\]: got (times of|an array of object)"):
            lc.replay({**trace, "time": column}, "hertz", **scene)
    trace["time"] = (time - time[0]) / np.timedelta64(1, "s")  # what the message says
    assert lc.replay(trace, "hertz", **scene)["time"].tolist() == [0, 0.001, 0.002]
    with pytest.raises(ValueError, match="^c: got times of timedelta64"):
        lc.run("eval", law="hertz", c=time)


def test_numbers_with_a_unit_are_refused():
    class Quantity(np.ndarray):
        unit = "mm"

    length = np.array([0.0, 4.5]).view(Quantity)
    for call in (lambda: TABLE.evaluate(length), lambda: lc.Patch.points(length, length, [1, 1]), lambda: lc.SoftFinger(TABLE).update(length, length, 0, 0)):
        with pytest.raises(ValueError, match="got numbers in mm, expected plain numbers in SI units$"):
            call()


def test_masked_pixels_have_no_sensor_and_masked_rows_are_none():
    image = np.ma.masked_array(np.ones((4, 6)), mask=np.zeros((4, 6)))
    image[:, 4:] = np.ma.masked
    image.data[:, 4:] = 1e3  # what a dead sensor says
    with pytest.warns(UserWarning, match="^pressures: 8 of 24 pixels have no sensor"):
        assert lc.Patch.image(image, 1e-3).moment_ratio == lc.Patch.image(np.ones((4, 4)), 1e-3).moment_ratio
    mask = [0, 0, 0, 1]
    with pytest.warns(UserWarning, match="^x: rows with a masked number are left out, 1 of 4$"):
        patch = lc.Patch.points([0, 1, 0, 9], [0, 0, 1, 9], np.ma.masked_array([1, 1, 1, 5], mask))
    assert patch.moment_ratio == lc.Patch.points([0, 1, 0], [0, 0, 1], [1, 1, 1]).moment_ratio
    radius = np.linspace(0, 1, 12)
    pressure = np.ma.masked_array(1 - radius**2, radius == radius[5])
    pressure.data[5] = 50
    with pytest.warns(UserWarning, match="^radius: rows"):
        law = lc.Law.samples(radius, pressure)
    assert law.arrays[1].tolist() == pressure.compressed().tolist()
    load = np.linspace(1, 3, 9)
    data = {"load": load, "force": np.ma.masked_array(0.6 * load, load == 2), "moment": 0.6 * load * 0.006 * np.pi / 8}
    data["force"].data[4] = 7
    data = {name: np.ma.concatenate([column * (i == 0) if name == "force" else column * (i == 1) if name == "moment" else column for i in (0, 1)])
            for name, column in data.items()}
    rows = ~np.ma.getmaskarray(data["force"])
    with pytest.warns(UserWarning, match="^data: rows with a masked number are left out, 2 of 18$"):
        fitted = lc.fit("ratio", data, law="hertz", quiet=True)["value"]
    assert np.array_equal(fitted, lc.fit("ratio", {name: np.asarray(column)[rows] for name, column in data.items()}, law="hertz", quiet=True)["value"])
    with pytest.raises(ValueError, match="^c: got masked numbers"):
        TABLE.evaluate(np.ma.masked_array([1.0, 2], [0, 1]))
    assert TABLE.evaluate(np.ma.masked_array([1.0, 2]))[0].shape == (2,)  # a mask that leaves nothing out


def test_numpy_truths_and_numbers_are_options():
    words = {"law": "hertz", "mu": np.array(0.6), "radius_law": np.str_("constant:a=0.006"), "load": np.float32(2)}
    assert set(lc.run("translate", **words, explain=np.bool_(False))) == set(lc.run("translate", **words))
    plain = lc.run("translate", **{**words, "mu": 0.6, "load": 2, "explain": True})
    assert plain["value"].tolist() == lc.run("translate", **words, explain=np.True_)["value"].tolist()
    assert len(lc.Law("hertz").evaluate(1, error=np.True_)) == 4
    finger = lc.SoftFinger(TABLE, mu=np.array(0.6))
    assert finger.update((0, 0, 0), (0, 0, 1), np.array(0.001), 0, landed=np.array([True, False])[0]).load == 1


def test_an_empty_list_is_not_all_laws():
    for call in (lc.validate, lambda laws: lc.validate(patch=laws), lambda laws: lc.run("eval", law=laws, c=1), lambda laws: lc.plot.limit_curve(laws, ax=0)):
        with pytest.raises(ValueError, match="got an empty list"):
            call([])


def test_projections_have_either_spelling_and_a_guess():
    for word in ("closest-point", "closest_point", "c_curve"):
        lc.SoftFinger(TABLE, projection=word)
    with pytest.raises(ValueError, match="did you mean 'closest-point'"):
        lc.SoftFinger(TABLE, projection="closest_pont")


def test_a_sensors_own_columns_and_units():
    load, force, moment = np.array([1.0, 1, 2, 2]), np.array([0.6, 0.02, 1.21, 0.03]), np.array([0, 2.1e-3, 0, 4.3e-3])
    own = {"Fz": 1000 * load, "Fxy": 1000 * force, "Tz": 1000 * moment}
    named = lc.fit("ratio", own, law="hertz", columns={"load": "Fz", "force": "Fxy", "moment": "Tz"}, units={"force": "mN", "moment": "Nmm"}, quiet=True)
    assert named["value"] == pytest.approx(lc.fit("ratio", {"load": load, "force": force, "moment": moment}, law="hertz", quiet=True)["value"], rel=1e-12)


def slips_of(n):
    """Load, force and moment of slips with an error of 1 %."""
    random = np.random.default_rng(2)
    f, m = TABLE.evaluate(np.tan(random.uniform(0, 1.5, n)))
    load = random.uniform(1, 3, n)
    return {"load": load, "force": 0.6 * load * f * (1 + 0.01 * random.normal(size=n)), "moment": 0.0036 * load * m * (1 + 0.01 * random.normal(size=n))}


def trace_of(n):
    t = np.arange(n) * 1e-3
    return {"time": t, "x": 0.02 * t, "y": 0 * t, "z": 0 * t - 0.002, "twist": 0 * t}


@pytest.mark.parametrize("work", [
    lambda law: lc.Table(law, tolerance=1e-13), lambda law: lc.choose(law, tolerance=1e-10), lambda law: law.evaluate(np.linspace(0, 3, 10**6)),
    lambda _: lc.Patch.image(np.ones((64, 64)), 1e-3).wrench(np.ones((10**6, 3))), lambda _: lc.fit("law", slips_of(200_000), quiet=True),
    lambda _: lc.replay(trace_of(10**7), "hertz", radius_law="constant:a=0.006", mu=0.6, stiffness=1000, twist_stiffness=0.036),
], ids=["table", "choice", "law", "patch", "fit", "replay"])
def test_ctrl_c_ends_long_work(work):
    radius = np.linspace(0, 1, 2000)
    law = lc.Law.samples(radius, np.sqrt(1 - radius**2) * (1 + 0.5 * np.random.default_rng(1).random(2000)))

    def interrupt(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    began = time.process_time()
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    try:
        with pytest.raises(KeyboardInterrupt):
            work(law)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert time.process_time() - began < 2
