# SPDX-License-Identifier: MIT
"""limitcurve.arrays against the library's own friction, in every array library that is installed."""

import importlib

import limitcurve as lc
import numpy as np
import pytest
from limitcurve import arrays

N = 100_000


@pytest.fixture(params=["numpy", "jax.numpy", "torch"])
def library(request):
    found = pytest.importorskip(request.param)
    if request.param == "jax.numpy":
        importlib.import_module("jax").config.update("jax_enable_x64", True)
    return found


@pytest.fixture(scope="module")
def trials():
    random = np.random.default_rng(1)
    return [random.uniform(0, 2, N), random.uniform(0, 1.5, N), 10 ** random.uniform(-3, 3, N)]


def friction(table, trials):
    """(force, moment, slips) by the library: with a limit and a radius of 1 a trial is its own unit wrench."""
    numbers = zip(*(part.tolist() for part in trials))
    kept = [lc.apply_friction(table, force, moment, limit=1, radius=1, stiffness_ratio=chi) for force, moment, chi in numbers]
    fractions = np.array([(one.force_fraction, one.moment_fraction) for one in kept]).T
    return fractions[0] * trials[0], fractions[1] * trials[1], np.array([one.slips for one in kept])


@pytest.mark.parametrize("law", ["hertz", "uniform", "gaussian:sigma=0.4"])
def test_wrenches_and_closest_points_are_the_librarys(library, trials, law):
    table = lc.Table(law, 1e-8)
    cells = arrays.cells(table, library)
    c = np.concatenate([[0.0, 1.0], 10 ** np.random.default_rng(2).uniform(-6, 6, N)])
    for mine, exact in zip(arrays.wrench(cells, library.asarray(c), library.asarray(np.ones_like(c))), table.evaluate(c)):
        assert np.abs(np.asarray(mine) - exact).max() < 2e-15
    f, m, slips = (np.asarray(part) for part in arrays.closest_point(cells, *map(library.asarray, trials)))
    own = friction(table, trials)
    assert np.array_equal(slips, own[2])
    assert max(np.abs(f - own[0]).max(), np.abs(m - own[1]).max()) < 2e-13
    assert 0.3 < slips.mean() < 0.9 and np.abs(table.gauge(f[slips], m[slips]) - 1).max() < 1e-13


def same_in_single_precision(table, single, found):
    """Whether results in single precision are the library's in double precision for the same numbers."""
    given = [part.astype(float) for part in single]
    exact, sure = friction(table, given), np.abs(table.gauge(*given[:2]) - 1) > 1e-5
    f, m, slips = map(np.asarray, found)
    assert f.dtype == m.dtype == np.float32
    assert np.array_equal(slips[sure], exact[2][sure])
    worst = max(np.abs(f - exact[0])[sure].max(), np.abs(m - exact[1])[sure].max())
    print(f"{worst:.1e}")
    return worst < 5e-6


def test_single_precision(library, trials):
    table = lc.Table("hertz", 1e-6)
    single = [part.astype(np.float32) for part in trials]
    assert same_in_single_precision(table, single, arrays.closest_point(arrays.cells(table, library, library.float32), *map(library.asarray, single)))


@pytest.mark.parametrize("law", ["hertz", "uniform", "gaussian:sigma=0.4"])
def test_functions_for_warp_are_the_librarys(trials, law):
    wp = pytest.importorskip("warp")
    lw = importlib.import_module("limitcurve.warp")

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

    table, single = lc.Table(law, 1e-6), [part.astype(np.float32) for part in trials]
    out = wp.zeros((5, N), dtype=float, device="cpu")
    wp.launch(step, N, [lw.cells(table, "cpu"), wp.array(np.array(single), dtype=float, device="cpu"), out], device="cpu")
    found = out.numpy()
    assert same_in_single_precision(table, single, [found[0], found[1], found[2] == 1])
    for mine, exact in zip(found[3:], table.wrench(single[0].astype(float), single[1].astype(float))):
        assert np.abs(mine - exact).max() < 1e-6


def test_derivatives_are_those_of_differences(library, trials):
    if library is np:
        pytest.skip("NumPy has no derivatives")
    cells = arrays.cells(lc.Table("hertz", 1e-8), library)
    some = [library.asarray(part[:1000]) for part in trials]

    def kept(*trial):
        force, moment, _ = arrays.closest_point(cells, *trial)
        return force + moment

    if library.__name__ == "torch":
        slopes = library.autograd.grad(kept(*(part.requires_grad_() for part in some)).sum(), some[:2])
        some = [part.detach() for part in some]
    else:
        jax = importlib.import_module("jax")
        kept = jax.jit(kept)
        slopes = jax.jit(jax.grad(lambda *trial: kept(*trial).sum(), argnums=(0, 1)))(*some)
    for i, slope in enumerate(map(np.asarray, slopes)):
        step = [1e-6 if j == i else 0.0 for j in range(3)]
        ends = [np.asarray(kept(*(part + sign * more for part, more in zip(some, step)))) for sign in (1, -1)]
        same = np.isclose(slope, (ends[0] - ends[1]) / 2e-6, rtol=1e-4, atol=1e-5)
        assert np.isfinite(slope).all() and same.mean() > 0.99  # but where the step crosses the curve or a kink of its curvature


def test_a_file_is_as_good_as_its_table(tmp_path):
    table = lc.Table("hertz", 1e-4)
    table.save(tmp_path / "hertz.csv")
    assert all(np.array_equal(a, b) for a, b in zip(arrays.cells(table), arrays.cells(tmp_path / "hertz.csv")))
