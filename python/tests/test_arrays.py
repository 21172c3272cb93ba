# SPDX-License-Identifier: MIT
"""limitcurve.arrays against the library's own friction, in every array library that is installed."""

import functools
import importlib

import limitcurve as lc
import numpy as np
import pytest
from limitcurve import arrays

from conftest import warp_step

N = 100_000


@pytest.fixture(params=["numpy", "jax.numpy", "torch"])
def library(request):
    found = pytest.importorskip(request.param)
    if request.param == "jax.numpy":
        importlib.import_module("jax").config.update("jax_enable_x64", True)
    return found


@pytest.fixture(scope="module")
def trials():
    """Of all signs; the first hundred only spin, the next only slide, some on the tie force = moment and at 0."""
    random = np.random.default_rng(1)
    force, moment = random.uniform(-2, 2, N), random.uniform(-1.5, 1.5, N)
    force[:100], moment[100:200], force[200:300], force[300], moment[300] = 0, 0, moment[200:300], 0, 0
    return [force, moment, 10 ** random.uniform(-3, 3, N)]


def friction(table, trials):
    """(force, moment, slips) by the library: with a limit and a radius of 1 a trial is its own unit wrench."""
    numbers = zip(*(part.tolist() for part in trials))
    kept = [lc.apply_friction(table, abs(f), abs(m), limit=1, radius=1, stiffness_ratio=chi) for f, m, chi in numbers]
    fractions = np.array([(one.force_fraction, one.moment_fraction) for one in kept]).T
    return fractions[0] * trials[0], fractions[1] * trials[1], np.array([one.slips for one in kept])


laws = pytest.mark.parametrize(
    "law", ["hertz", "uniform", "gaussian:sigma=0.4", "power:n=-0.9", "mix:0.5*hertz+0.5*power:n=-0.99"])


@laws
def test_wrenches_and_closest_points_are_the_librarys(library, trials, law):
    table = lc.Table(law, 1e-8)
    cells = arrays.cells(table, library)
    c = np.concatenate([[0.0, 1.0], 10 ** np.random.default_rng(2).uniform(-6, 6, N)])
    for mine, exact in zip(arrays.wrench(cells, -c, 1.0), table.evaluate(c)):
        assert np.abs(np.asarray(mine) - exact).max() < 2e-15
    f, m, slips = (np.asarray(part) for part in arrays.closest_point(cells, *map(library.asarray, trials)))
    own = friction(table, trials)
    assert np.array_equal(slips, own[2])
    assert max(np.abs(f - own[0]).max(), np.abs(m - own[1]).max()) < 2e-13
    assert 0.3 < slips.mean() < 0.9 and np.abs(table.gauge(abs(f[slips]), abs(m[slips])) - 1).max() < 1e-13


@laws
def test_tangent_ellipses_are_the_tables(library, trials, law):
    table = lc.Table(law, 1e-8)
    cells, random = arrays.cells(table, library), np.random.default_rng(3)
    force, moment = trials[0][:1000], trials[1][:1000]
    p, q = random.uniform(0.3, 3, 1000), random.uniform(0.1, 1, 1000)
    with np.errstate(invalid="raise"):
        split = arrays.tangent_ellipse(cells, force, moment, p, q)
    for mine, own in ((split, table.tangent_ellipse(force, moment, p,
                                                    q)), (arrays.tangent_ellipse(cells, force, moment),
                                                          table.tangent_ellipse(force, moment)),
                      (arrays.tangent_ellipse(cells,
                                              slip=(force, moment)), table.tangent_ellipse(slip=(force, moment)))):
        assert all(np.abs(np.asarray(a) / b - 1).max() < 1e-9 for a, b in zip(mine, own))


def same_in_single_precision(table, single, found):
    """Whether results in single precision are the library's in double precision for the same numbers."""
    given = [part.astype(float) for part in single]
    exact, sure = friction(table, given), np.abs(table.gauge(*map(np.abs, given[:2])) - 1) > 1e-5
    f, m, slips = map(np.asarray, found)
    assert f.dtype == m.dtype == np.float32
    assert np.array_equal(slips[sure], exact[2][sure])
    worst = max(np.abs(f - exact[0])[sure].max(), np.abs(m - exact[1])[sure].max())
    print(f"{worst:.1e}")
    return worst < 5e-6


def test_single_precision(library, trials):
    table = lc.Table("hertz", 1e-6)
    single = [part.astype(np.float32) for part in trials]
    assert same_in_single_precision(
        table, single, arrays.closest_point(arrays.cells(table, library, library.float32),
                                            *map(library.asarray, single)))


@laws
def test_functions_for_warp_are_the_librarys(trials, law):
    wp, lw = pytest.importorskip("warp"), importlib.import_module("limitcurve.warp")
    table, single = lc.Table(law, 1e-6), [part.astype(np.float32) for part in trials]
    out = wp.zeros((7, N), dtype=float, device="cpu")
    wp.launch(
        warp_step(wp, lw),
        N, [lw.cells(table, "cpu"), wp.array(np.array(single), dtype=float, device="cpu"), out],
        device="cpu")
    found = out.numpy()
    assert same_in_single_precision(table, single, [found[0], found[1], found[2] == 1])
    for mine, exact in zip(
            found[5:],
            table.tangent_ellipse(single[0].astype(float), single[1].astype(float), 1.0, float(np.float32(0.6)))):
        assert np.abs(mine / exact - 1).max() < 1e-4
    for mine, exact in zip(found[3:5], table.wrench(single[0].astype(float), single[1].astype(float))):
        assert np.abs(mine - exact).max() < 1e-6


def weighed(function, *given):
    """One number of two components of a wrench."""
    force, moment = function(*given)[:2]
    return force + 2 * moment


def same_as_differences(slopes, function, given, tolerance):
    """Of the first 200, on the axes, all; of the others some: the step crosses the curve or a kink of its curvature."""
    for i, slope in enumerate(map(np.asarray, slopes)):
        high, low = (weighed(function, *(part + (j == i) * step
                                         for j, part in enumerate(given)))
                     for step in (1e-6, -1e-6))
        same = np.isclose(slope, (high - low) / 2e-6, rtol=tolerance, atol=tolerance / 10)
        assert np.isfinite(slope).all() and same[:200].all() and same.mean() > 0.99


@laws
def test_derivatives_are_those_of_differences(library, trials, law):
    if library is np:
        pytest.skip("NumPy has no derivatives")
    table, some = lc.Table(law, 1e-8), [part[:5000] for part in trials]
    cells, own = arrays.cells(table, library), arrays.cells(table)

    def slopes(function, given):
        given = [library.asarray(part) for part in given]
        if library.__name__ == "torch":
            given = [part.requires_grad_() for part in given]
            return library.autograd.grad(weighed(function, cells, *given).sum(), given[:2])
        jax = importlib.import_module("jax")
        return jax.jit(jax.grad(lambda *given: weighed(function, cells, *given).sum(), argnums=(0, 1)))(*given)

    same_as_differences(slopes(arrays.closest_point, some), functools.partial(arrays.closest_point, own), some, 1e-4)
    slips = [part[200 if law == "hertz" else 300:500]
             for part in some[:2]]  # not on an axis; on the tie where a law has a slope there
    same_as_differences(slopes(arrays.wrench, slips), table.wrench, slips, 1e-4)


@laws
def test_derivatives_under_warps_tape(trials, law):
    wp, lw = pytest.importorskip("warp"), importlib.import_module("limitcurve.warp")
    table, some = lc.Table(law, 1e-6), np.array([part[:5000] for part in trials], np.float32)
    given, out = (wp.array(x, dtype=float, device="cpu", requires_grad=True)
                  for x in (some, np.zeros((7, 5000), np.float32)))
    with wp.Tape() as tape:
        wp.launch(warp_step(wp, lw), 5000, [lw.cells(table, "cpu"), given, out], device="cpu")
    out.grad.assign(np.outer([1, 2, 0, 0, 0, 0, 0], np.ones(5000)).astype(np.float32))
    tape.backward()
    same_as_differences(given.grad.numpy()[:2], functools.partial(arrays.closest_point, arrays.cells(table)),
                        list(some.astype(float)), 1e-3)


def test_a_file_is_as_good_as_its_table(tmp_path):
    table = lc.Table("hertz", 1e-4)
    table.save(tmp_path / "hertz.csv")
    assert all(np.array_equal(a, b) for a, b in zip(arrays.cells(table), arrays.cells(tmp_path / "hertz.csv")))
