# SPDX-License-Identifier: MIT
"""Each chart is one call that returns its axes, with the documented contents."""

import limitcurve as lc
import limitcurve.plot
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest

from conftest import SCENE


@pytest.fixture(autouse=True)
def closed():
    yield
    plt.close("all")


def test_limit_curve_with_points_and_fits():
    slips = {"load": [1.0, 2.0], "force": [0.3, -0.6], "moment": [1e-3, 2e-3]}
    ax = lc.plot.limit_curve("hertz",
                             fits=("ellipse", "ellipse-inner", "box", "diamond"),
                             points=slips,
                             mu=0.6,
                             radius=0.006)
    labels = [line.get_label() for line in ax.lines]
    assert labels[0] == "hertz" and labels[-1] == "measured" and labels[1] == "ellipse, off by up to 6.4 %"
    f, m = ax.lines[0].get_data()
    assert (f[0], m[-1]) == (0, 0) and f[-1] == 1 and np.array_equal(
        lc.Law("hertz").evaluate(np.linspace(0, 1, 129))[0], f[:129])
    assert np.allclose(ax.lines[-1].get_data()[0], 0.5)
    loads = np.array([2.0, 0.5, 2.0])
    slips = {"load": loads, "force": 0.3 * loads, "moment": 0.1 * 0.6 * loads * 2e-3 * loads ** (1 / 3)}
    points = lc.plot.limit_curve("hertz",
                                 fits=["ellipse_inner"],
                                 points=slips,
                                 mu=0.6,
                                 radius_law="power:c=0.002,gamma=0.3333333333333333").lines[-1]
    assert np.allclose(points.get_data(), [[0.5] * 3, [0.1] * 3])
    with pytest.raises(ValueError, match="fits: got 'elipse'"):
        lc.plot.limit_curve("hertz", fits=["elipse"])


def test_curves_draw_on_the_axes_given():
    _, (left, right) = plt.subplots(1, 2)
    assert lc.plot.p_curves("hertz", "hertz:R=0.008,E=2e5", 0.6, [0.5, 1, 2], ax=left) is left and len(left.lines) == 3
    assert lc.plot.c_curves("hertz", "hertz:R=0.008,E=2e5", 0.6, [0.001, np.inf], np.linspace(0.1, 2, 20),
                            ax=right) is right
    assert [line.get_label() for line in right.lines] == ["c = 1 mm", "pure sliding"]
    assert left.lines[2].get_data()[0].max() == pytest.approx(1.2)


def test_errors_of_approximations():
    ax = lc.plot.approximation_errors(["hertz", "uniform"])
    assert len(ax.patches) == 2 * 2 * 6
    assert max(bar.get_height()
               for bar in ax.patches[:6]) == pytest.approx(100 * lc.validate("hertz")["max_over_estimate"].max())


def test_a_replay_stays_within_its_limit(data):
    trace = pd.read_csv(data / "traces/slide_twist_load.csv", comment="#")
    table = lc.replay(trace, "hertz", **SCENE)
    ax = lc.plot.replay(table, law="hertz", **SCENE)
    assert [line.get_label() for line in ax.lines][1:3] == ["stick", "slip"] and len(ax.lines) == 6
    r, rho = (np.asarray(values) for values in ax.lines[2].get_data())
    load, slips = table["load"][table["state"] == "slip"], table["state"] == "slip"
    assert np.allclose(r, 1e3 * np.hypot(trace["x"] - table["px"], trace["y"] - table["py"])[slips], atol=1e-9)
    assert np.allclose(rho, np.degrees(abs(trace["twist"] - table["angle"]))[slips], atol=1e-9)
    gauge = lc.Table("hertz", 1e-8).gauge(r * 1e-3 * 1000 / (0.6 * load),
                                          np.radians(rho) * 0.036 / (0.6 * load * 0.006))
    assert np.allclose(gauge, 1, atol=1e-5)  # what slips is on the limit curve of its load


def test_every_model_is_drawn_as_far_off_as_its_label_says():
    law, errors = lc.Law("hertz"), lc.validate("hertz")
    angle = np.linspace(0, np.pi / 2, 20001)
    s = np.tan(np.linspace(0, np.pi / 2, 20001))
    exact = np.array(law.evaluate(s)) / [[1], [law.moment_ratio]]
    exact_radius = np.interp(angle, np.arctan2(*exact[::-1])[::-1], np.hypot(*exact)[::-1])
    for name, error in zip(errors["model"], errors["max_error"]):
        line = lc.plot.limit_curve(law, fits=[name]).lines[1].get_xydata().T / [[1], [law.moment_ratio]]
        steps = np.linspace(0, len(line[0]) - 1, 200001)
        x, y = (np.interp(steps, np.arange(len(one)), one) for one in line)
        radius = np.interp(np.arctan2(y, x), angle, exact_radius)
        assert np.max(abs(np.hypot(x, y) / radius - 1)) == pytest.approx(error, rel=2e-3), name
