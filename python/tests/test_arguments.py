# SPDX-License-Identifier: MIT
"""What arguments may be: times, units, masks, truths and names of columns; and that Ctrl-C ends long work."""

import re
import signal
import time

import limitcurve as lc
import limitcurve.arrays
import limitcurve.plot
import numpy as np
import pytest

from conftest import SCENE

TABLE = lc.Table("hertz", tolerance=1e-8)


def test_times_that_are_nan():
    """Ticks of any unit once counted as seconds."""
    time = np.arange(3) * np.timedelta64(1, "ms")
    trace = {"time": time, "x": np.zeros(3), "y": np.zeros(3), "z": np.zeros(3), "twist": np.zeros(3)}
    for column in (time, time + np.datetime64("2024-01-01"), time.astype(object), np.array(list(time), object)):
        with pytest.raises(ValueError, match=r"^trace\['time'\]: got (times of|an array of object)"):
            lc.replay({**trace, "time": column}, "hertz", **SCENE)
    trace["time"] = (time - time[0]) / np.timedelta64(1, "s")  # what the message says
    assert lc.replay(trace, "hertz", **SCENE)["time"].tolist() == [0, 0.001, 0.002]
    with pytest.raises(ValueError, match="^c: got times of timedelta64"):
        lc.run("eval", law="hertz", c=time)


def test_numbers_with_a_unit_are_refused():
    class Quantity(np.ndarray):
        unit = "mm"

    length = np.array([0.0, 4.5]).view(Quantity)
    for call in (lambda: TABLE.evaluate(length), lambda: lc.Patch.points(length, length, [1, 1]),
                 lambda: lc.SoftFinger(TABLE).update(length, length, 0, 0)):
        with pytest.raises(ValueError, match="got numbers in mm, expected plain numbers in SI units$"):
            call()


def test_masked_pixels_have_no_sensor_and_masked_rows_are_none():
    image = np.ma.masked_array(np.ones((4, 6)), mask=np.zeros((4, 6)))
    image[:, 4:] = np.ma.masked
    image.data[:, 4:] = 1e3  # what a dead sensor says
    with pytest.warns(UserWarning, match="^pressures: 8 of 24 pixels have no sensor"):
        assert lc.Patch.image(image, 1e-3).moment_ratio == lc.Patch.image(np.ones((4, 4)), 1e-3).moment_ratio
    mask = [0, 0, 0, 1]
    with pytest.warns(UserWarning, match="^load: rows with a masked number are left out, 1 of 4$"):
        patch = lc.Patch.points([0, 1, 0, 9], [0, 0, 1, 9], np.ma.masked_array([1, 1, 1, 5], mask))
    assert patch.moment_ratio == lc.Patch.points([0, 1, 0], [0, 0, 1], [1, 1, 1]).moment_ratio
    load = np.linspace(1, 3, 9)
    data = {"load": load, "radius": np.ma.masked_array(0.002 * load**0.3, load == 2)}
    data["radius"].data[4] = 7
    with pytest.warns(UserWarning, match="^data: rows with a masked number are left out, 1 of 9$"):
        fitted = lc.fit("load", data, quiet=True)["value"]
    kept = {name: np.asarray(column)[load != 2] for name, column in data.items()}
    assert np.array_equal(fitted, lc.fit("load", kept, quiet=True)["value"])
    with pytest.raises(ValueError, match="^c: got masked numbers"):
        TABLE.evaluate(np.ma.masked_array([1.0, 2], [0, 1]))
    for call in (lc.arrays.wrench, lc.arrays.tangent_ellipse):
        with pytest.raises(ValueError, match="got masked numbers"):
            call(lc.arrays.cells(TABLE), np.ma.masked_array([1.0, 2], [0, 1]), 1)
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
    for call in (lc.validate, lambda laws: lc.validate(patch=laws), lambda laws: lc.run("eval", law=laws, c=1),
                 lambda laws: lc.plot.limit_curve(laws, ax=0)):
        with pytest.raises(ValueError, match="got an empty list"):
            call([])


def test_projections_have_either_spelling_and_a_guess():
    for word in ("closest-point", "closest_point", "c_curve"):
        lc.SoftFinger(TABLE, projection=word)
    with pytest.raises(ValueError, match="did you mean 'closest-point'"):
        lc.SoftFinger(TABLE, projection="closest_pont")


PATCH = lc.Patch("rectangle:x=0.02,y=0.01")
SLIPS = {"load": [1.0, 1, 2, 2], "force": [0.6, 0.02, 1.21, 0.03], "moment": [0, 2.1e-3, 0, 4.3e-3]}


@pytest.mark.parametrize("call, told", [
    (lambda: lc.Table("hertz", tolerance="1e-8"), "tolerance: got '1e-8', expected a number"),
    (lambda: lc.Table(3), "law: got 3, expected a str"),
    (lambda: lc.Table(), "no 'law', expected law, tolerance, preferred_bytes"),
    (lambda: TABLE.load_to_hold(1, 2e-3, mu=0.6), "radius_law, mu_r: got none"),
    (lambda: TABLE.load_to_hold(1, 2e-3, mu=0.6, mu_r=0.002, radius_law="constant:a=0.005"),
     "radius_law, mu_r: got both"),
    (lambda: TABLE.load_to_hold(1, 2e-3, mu=[0.6, -1], mu_r=0.002), r"mu\[1\]: got -1"),
    (lambda: TABLE.load_to_hold(1, 2e-3, mu=0.6, radius_law=5), "radius_law: got 5"),
    (lambda: TABLE.gauge(1, moment=2, force=3), "'force' twice"),
    (lambda: lc.Patch.image([[1]], spacing=3), "spacing: got 3"),
    (lambda: PATCH.orthotropic(mx="a", my=1), "mx: got 'a'"),
    (lambda: TABLE.tangent_ellipse(slip=3), "slip: got 3"),
    (lambda: lc.arrays.wrench(TABLE, 1, 1), "cells: got Table"),
    (lambda: lc.Table.gauge(1, 2), "gauge: called on no object"),
    (lambda: lc.SoftFinger(), "no 'curve'"),
    (lambda: lc.SoftFinger(TABLE, mu=np.ma.masked), "mu: got masked, expected a number"),
    (lambda: lc.run("eval", law="hertz", c=np.ma.masked), "c: got masked, expected a number"),
    (lambda: lc.SoftFinger(PATCH, radius_law="constant:a=0.005"), "radius_law.*not with a Patch"),
    (lambda: lc.SoftFinger(TABLE, mu_r=0.002, radius_law="constant:a=0.005"), "mu_r: not with radius_law"),
    (lambda: lc.SoftFinger(TABLE).update((0, 0, 0), (0, 0, 1), "deep", 0), "depth: got 'deep'"),
    (lambda: lc.apply_friction(TABLE, 1, 0, limit=1, radius=1), "no 'stiffness_ratio'"),
    (lambda: lc.Batch(TABLE, -1), "n: got -1"),
    (lambda: lc.fit("law", SLIPS, units="moment=Nmm"), "units: got 'moment=Nmm', expected a dict"),
    (lambda: lc.fit("law", SLIPS, columns="a"), "columns: got 'a'"),
    (lambda: lc.fit("lwa", SLIPS), "did you mean 'law'"),
    (lambda: lc.translate("hertz", mu=1, read={"mujoco.torsional": 5}),
     "read: got {'mujoco.torsional': 5}, expected 'ENGINE.PARAMETER=VALUE'"),
    (lambda: lc.translate("hertz", mu=1, read="mujoco.torsional"), "^read: got 'mujoco.torsional'"),
    (lambda: lc.translate("hertz", mu=-1, load=1), "^mu: item 1 of '-1'"),
    (lambda: lc.replay(trace_of(9), "hertz"), "^mu, stiffness, twist_stiffness are required"),
    (lambda: lc.run("eval", law="hertz", cc=1), "did you mean 'c'|not expected: cc"),
    (lambda: lc.fit("law", {
        **SLIPS, "force": list("abcd")
    }), r"^data\['force'\]: got an array of <U1"),
])
def test_wrong_calls_are_told_by_name(call, told):
    with pytest.raises((ValueError, TypeError), match=told) as error:
        call()
    assert "--" not in str(error.value) and "\n" not in str(error.value)


def wrong_call(function, *values, **keywords):
    with pytest.raises((ValueError, TypeError)) as error:
        function(*values, **keywords)
    assert "incompatible function arguments" not in str(error.value) and "\n" not in str(error.value)
    return str(error.value)


def public_callables():
    for thing in (getattr(lc, name) for name in lc.__all__):
        if callable(thing) and thing not in (lc.Fit, lc.ContactState, lc.Fault):
            yield thing
        if isinstance(thing, type) and thing.__module__.startswith("limitcurve"):
            yield from (getattr(thing, name)
                        for name in vars(thing)
                        if name[0] != "_" and callable(getattr(thing, name)))


@pytest.mark.parametrize("function", list(public_callables()), ids=lambda function: function.__qualname__)
def test_every_wrong_call_is_told_in_our_words(function):
    wrong_call(function, *[object()] * 40)
    told = wrong_call(function, unheard_of=1)
    if "no constructor defined" in told or function is lc.run:
        return
    expected = re.search("unknown parameter 'unheard_of', expected (.*)", told)[1].split(", ")
    longest = max(expected, key=len)
    if longest != "none" and len(longest) > 2:
        assert f"did you mean '{longest}'" in wrong_call(function, **{longest + "x": 1})


def test_other_columns_are_ignored_and_every_number_broadcasts():
    class Frame:  # as polars has it: columns is a list, and there are no keys
        columns = ["note", *SLIPS, "day", "empty", "wide"]

        def __getitem__(self, name):
            odd = {
                "note": list("abcd"),
                "day": np.arange(4).astype("datetime64[D]"),
                "empty": [None] * 4,
                "wide": np.zeros((4, 2))
            }
            return odd[name] if name in odd else np.array(SLIPS[name])

    plain = lc.fit("ratio", SLIPS, law="hertz", quiet=True)["value"]
    for frame in (Frame(), {name: Frame()[name] for name in Frame.columns}):
        assert np.array_equal(lc.fit("ratio", frame, law="hertz", quiet=True)["value"], plain)
    force, mu, mu_r = np.array([[1.0], [-2]]), np.array([0.4, 0.6, 0.8]), 0.002
    measured = TABLE.load_to_hold(force, 1e-3, mu=mu, mu_r=mu_r, gamma=0.2)
    assert measured.shape == (2, 3) and measured[1, 2] == TABLE.load_to_hold(2, -1e-3, mu=0.8, mu_r=mu_r, gamma=0.2)
    assert PATCH.load_to_hold(0, 1, 0, mu=mu).tolist() == pytest.approx((1 / mu).tolist())


def test_units_of_texts_traces_and_patches_are_asked_about_and_of_other_numbers_not(recwarn):
    for call, asked in ((lambda: lc.Patch("rectangle:x=20,y=10"), "20 m across: lengths must be in metres"),
                        (lambda: lc.Patch.polygon([0, 20, 20], [0, 0, 10]), "patch: 20 m across"),
                        (lambda: TABLE.load_to_hold(1, 1e-3, mu=0.6, radius_law="constant:a=5"),
                         "must be in metres"), (lambda: lc.SoftFinger(TABLE, radius_law="constant:a=5"),
                                                   "in metres"),
                        (lambda: lc.SoftFinger(TABLE, radius_law=lc.RadiusLaw.constant(5)), "in metres"),
                        (lambda: lc.replay({
                            **trace_of(4), "twist": 30.0 * np.arange(4)
                        },
                                           "hertz",
                                           mu=0.6,
                                           mu_r=0.002,
                                           stiffness=1000,
                                           twist_stiffness=0.036), "if it is in degrees")):
        with pytest.warns(UserWarning, match=asked):
            call()
    for number in (1.2, 300, 4000):
        lc.Patch.points([0, 0.4], [0, 0.1], [1, 1]).load_to_hold(number, 0, number, mu=0.6)
        TABLE.load_to_hold(number, number, mu=0.6, mu_r=0.003)
    assert not recwarn.list
    trace = trace_of(50)
    other = {**{name: column * 1000 for name, column in trace.items()}, "twist": trace["twist"]}
    assert lc.replay(other, "hertz", units={
        "length": "mm",
        "time": "ms"
    }, **SCENE)["fx"] == pytest.approx(lc.replay(trace, "hertz", **SCENE)["fx"], abs=1e-12)


def test_values_say_what_they_are():
    assert repr(PATCH).startswith("<Patch rectangle:x=0.02,y=0.01, m0 0.0059") and "points of 2 rows" in repr(
        lc.Patch.points([0, 0.01], [0, 0], [1, 1]))
    assert repr(lc.SoftFinger(TABLE, mu=0.25)) == f"<SoftFinger on {TABLE!r}, mu 0.25>"
    assert repr(lc.Batch(TABLE, 3, dtype=np.float32)) == f"<Batch of 3 contacts on {TABLE!r}, float32>"
    with pytest.warns(UserWarning, match=r"^SoftFinger without mu, .* and radius_law \(or mu_r\), so a = 0.005 m"):
        finger = lc.SoftFinger(TABLE)
    with pytest.warns(UserWarning, match="^SoftFinger without mu, stiffness, twist_stiffness: it has mu 0.5"):
        lc.SoftFinger(PATCH)
    with pytest.warns(UserWarning, match="^Batch without mu"):
        lc.Batch(TABLE, 3)
    assert "not finite" in repr(finger.update((0, 0, np.nan), (0, 0, 1), 0.001, 0))
    assert TABLE == lc.Table("hertz", tolerance=1e-8) and TABLE != lc.Table(
        "hertz", tolerance=1e-6) and TABLE != 3 and len({TABLE, lc.Table("hertz", 1e-8)}) == 1


def slips_of(n):
    """Load, force and moment of slips with an error of 1 %."""
    random = np.random.default_rng(2)
    f, m = TABLE.evaluate(np.tan(random.uniform(0, 1.5, n)))
    load = random.uniform(1, 3, n)
    return {
        "load": load,
        "force": 0.6 * load * f * (1 + 0.01 * random.normal(size=n)),
        "moment": 0.0036 * load * m * (1 + 0.01 * random.normal(size=n))
    }


def trace_of(n):
    t = np.arange(n) * 1e-3
    return {"time": t, "x": 0.02 * t, "y": 0 * t, "z": 0 * t - 0.002, "twist": 0 * t}


@pytest.mark.parametrize("work", [
    lambda law: lc.Table(law, tolerance=1e-13),
    lambda law: lc.choose(law, tolerance=1e-10),
    lambda law: law.evaluate(np.linspace(0, 3, 10 ** 6)),
    lambda _: lc.Patch.image(np.ones((64, 64)), 1e-3).wrench(np.ones((10 ** 6, 3))),
    lambda _: lc.fit("law", slips_of(200_000), quiet=True),
    lambda _: lc.replay(trace_of(10 ** 7), "hertz", **SCENE),
],
                         ids=["table", "choice", "law", "patch", "fit", "replay"])
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
