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


@pytest.mark.parametrize("law", ["hertz", "uniform", "gaussian:sigma=0.4"])
def test_wrenches_and_closest_points_are_the_librarys(library, trials, law):
    table = lc.Table(law, 1e-8)
    cells = arrays.cells(table, library)
    c = np.concatenate([[0.0, 1.0], 10 ** np.random.default_rng(2).uniform(-6, 6, N)])
    for mine, exact in zip(arrays.wrench(cells, library.asarray(c), library.asarray(np.ones_like(c))), table.evaluate(c)):
        assert np.abs(np.asarray(mine) - exact).max() < 2e-15
    f, m, slips = (np.asarray(part) for part in arrays.closest_point(cells, *map(library.asarray, trials)))
    worst = 0.0
    for i in range(N):  # a limit and a radius of 1: the trial is its own unit wrench
        force, moment, chi = (float(part[i]) for part in trials)
        own = lc.apply_friction(table, force, moment, limit=1, radius=1, stiffness_ratio=chi)
        assert own.slips == slips[i]
        worst = max(worst, abs(f[i] - own.force_fraction * force), abs(m[i] - own.moment_fraction * moment))
    assert worst < 2e-13
    assert 0.3 < slips.mean() < 0.9 and np.abs(table.gauge(f[slips], m[slips]) - 1).max() < 1e-13


def test_single_precision(library, trials):
    table = lc.Table("hertz", 1e-6)
    cells = arrays.cells(table, library, library.float32)
    single = [library.asarray(part, dtype=library.float32) for part in trials]
    f, m, slips = arrays.closest_point(cells, *single)
    assert f.dtype == m.dtype == library.float32
    exact = arrays.closest_point(arrays.cells(table), *trials)
    sure = np.abs(table.gauge(*trials[:2]) - 1) > 1e-5
    assert np.array_equal(np.asarray(slips)[sure], exact[2][sure])
    assert np.abs(np.asarray(f) - exact[0])[sure].max() < 2e-4 and np.abs(np.asarray(m) - exact[1])[sure].max() < 2e-4


def test_derivatives_are_those_of_differences(trials):
    jax = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", True)
    cells = arrays.cells(lc.Table("hertz", 1e-8), jax.numpy)
    kept = jax.jit(lambda f, m, chi: sum(map(jax.numpy.sum, arrays.closest_point(cells, f, m, chi)[:2])))
    some = [jax.numpy.asarray(part[:1000]) for part in trials]
    slopes = jax.jit(jax.grad(kept, argnums=(0, 1)))(*some)
    each = jax.vmap(lambda f, m, chi: kept(f, m, chi))
    for i, slope in enumerate(slopes):
        step = [1e-6 if j == i else 0.0 for j in range(3)]
        difference = (each(*(a + b for a, b in zip(some, step))) - each(*(a - b for a, b in zip(some, step)))) / 2e-6
        same = np.isclose(slope, difference, rtol=1e-4, atol=1e-5)
        assert np.isfinite(slope).all() and same.mean() > 0.99  # but where the step crosses the curve or a kink of its curvature


def test_a_file_is_as_good_as_its_table(tmp_path):
    table = lc.Table("hertz", 1e-4)
    table.save(tmp_path / "hertz.csv")
    assert all(np.array_equal(a, b) for a, b in zip(arrays.cells(table), arrays.cells(tmp_path / "hertz.csv")))
