# SPDX-License-Identifier: MIT
"""Objects pickle and copy, with their state and without their files; also to the processes of a pool."""

import concurrent.futures
import copy
import multiprocessing
import pickle

import limitcurve as lc
import numpy as np
import pytest

C = np.linspace(0, 3, 50)
TWISTS = np.random.default_rng(1).normal(size=(20, 3)) * [0.1, 0.1, 10]
PROFILE = "radius,pressure\n0,2\n0.001,1.5\n0.002,0.5\n0.003,0\n"


def again(thing):
    return pickle.loads(pickle.dumps(thing))


WAYS = [again, copy.copy, copy.deepcopy]


def same(one, other):
    return all(np.array_equal(a, b, equal_nan=True) for a, b in zip(one, other, strict=True))


@pytest.mark.parametrize("way", WAYS)
def test_laws_and_curves(way, tmp_path):
    path = tmp_path / "profile.csv"
    path.write_text(PROFILE)
    measured = lc.Law(f"samples:{path}")
    path.unlink()
    things = [
        lc.Law("power:n=2.3"), measured,
        lc.Law.samples([0, 1, 2, 3], [3, 2, 1, 0]),
        lc.Table("hertz", 1e-8),
        lc.Table(measured, 1e-3),
        lc.ellipse(1, 0.6),
        lc.box(1, 0.5)
    ]
    for thing in things:
        other = way(thing)
        assert same(other.evaluate(C), thing.evaluate(C)) and repr(other) == repr(thing)
    table, other = things[4], way(things[4])
    for fact in ("checked_error", "profile_error", "tolerance", "law_name", "moment_ratio", "nbytes"):
        assert getattr(other, fact) == getattr(table, fact)
    assert np.array_equal(other.cells, table.cells)
    radius_law = way(lc.RadiusLaw.samples([1, 2], [0.004, 0.005]))
    assert table.load_to_hold(1, 0.01, mu=0.5, radius_law=radius_law) == table.load_to_hold(1,
                                                                                            0.01,
                                                                                            mu=0.5,
                                                                                            radius_law=way(radius_law))


@pytest.mark.parametrize("way", WAYS)
def test_patches(way, tmp_path):
    for name, text in (("points", "x,y,load\n0,0,1\n0.01,0,2\n0,0.02,1\n"), ("polygon", "x,y\n0,0\n0.01,0\n0,0.02\n"),
                       ("image", "1,2\n3,B\n"), ("profile", PROFILE)):
        (tmp_path / f"{name}.csv").write_text(text)
    with pytest.warns(UserWarning, match="1 of 4 pixels have no sensor"):
        image = lc.Patch(f"image:{tmp_path}/image.csv,pixel=0.004x0.005")
    patches = [
        lc.Patch(f"points:{tmp_path}/points.csv,mx=2"),
        lc.Patch(f"polygon:{tmp_path}/polygon.csv"), image,
        lc.Patch("rectangle:x=0.02,y=0.01"),
        lc.PatchTable("rectangle:x=0.02,y=0.01,mx=0.5", 1e-2),
        lc.Patch(f"ellipse:law=samples:{tmp_path}/profile.csv,a=0.004,b=0.002"),
        lc.Patch.points([0, 1], [0, 0], [1, 2]),
        lc.Patch.polygon([0, 1, 0], [0, 0, 1]),
        lc.Patch.image([[1.0, 2], [3, 4]], 0.001).orthotropic(1.5, 1).orthotropic(1, 2)
    ]
    patches[4].save(tmp_path / "table.csv")
    patches.append(lc.Patch(f"table:{tmp_path}/table.csv"))
    for file in tmp_path.iterdir():
        file.unlink()
    for patch in patches:
        other = way(patch)
        assert same(other.wrench(TWISTS, error=True), patch.wrench(TWISTS, error=True)) and other.centre == patch.centre


@pytest.mark.parametrize("way", [*WAYS, lambda finger: finger.copy()])
@pytest.mark.parametrize("contact", ["table", "patch"])
def test_a_finger_goes_on_where_it_was(way, contact):
    given = {"mu": 0.6, "mu_dynamic": 0.5, "damping": 2.0, "stiffness": 900}
    if contact == "patch":
        finger = lc.SoftFinger(lc.Patch.points([0, 0.01, 0], [0, 0, 0.01], [1, 1, 2]), point_radius=1e-4, **given)
    else:
        finger = lc.SoftFinger(lc.Table("hertz"), projection="radial", radius_law="hertz:R=0.008,E=2e5", **given)
    steps = [((1e-4 * i, 0, 0), (0, 0, 1), 0.002, 0.01 * i, 1e-3) for i in range(40)]
    for step in steps[:20]:
        finger.update(*step)
    other = way(finger)
    for step in steps[20:]:
        mine, its = finger.update(*step), other.update(*step)
        assert repr(mine) == repr(its) and (mine.cor, mine.slip_work, mine.angle) == (its.cor, its.slip_work, its.angle)
    assert str(mine.state) == "slip"


@pytest.mark.parametrize("rows", ["load,radius\n1,0.004\n2,0.006\n", "load,moment\n1,0.001\n2,0.003\n"])
def test_a_measured_radius_law_needs_its_file_once(rows, tmp_path):
    path = tmp_path / "radii.csv"
    path.write_text(rows)
    given = {"mu": 0.6, "radius_law": f"{'moments' if 'moment' in rows else 'samples'}:{path}"}
    finger, batch = lc.SoftFinger(lc.Table("hertz"), **given), lc.Batch(lc.Table("hertz"), 1, **given)
    path.unlink()
    other, other_batch = again(finger), again(batch)
    for one in (finger, other):
        for twist in (0.0, 0.5):
            one.update((0, 0, 0), (0, 0, 1), 0.0013, twist)
    for one in (batch, other_batch):
        for twist in (0.0, 0.5):
            one.update(0.0, 0.0, 0.0013, twist)
    assert finger.output.moment == other.output.moment < 0 and batch.moment[0] == other_batch.moment[0] < 0


@pytest.mark.parametrize("way", [again, copy.copy, copy.deepcopy])
@pytest.mark.parametrize("dtype", ["float64", "float32"])
def test_a_batch_goes_on_where_it_was(way, dtype):
    batch = lc.Batch(lc.Table("hertz"), 5, dtype=dtype, mu=0.6, mu_dynamic=0.5, projection="c_curve")
    for i in range(20):
        batch.update(1e-4 * i * np.arange(5), np.zeros(5), 0.002, 0.01 * i)
    other = way(batch)
    assert len(other) == 5 and np.array_equal(batch.fx, other.fx)
    for all_of in (batch, other):
        all_of.update(3e-3 * np.arange(5), np.zeros(5), 0.001, 0.1)
    for name in ("fx", "fy", "moment", "state", "proxy_x", "proxy_y", "proxy_angle"):
        assert np.array_equal(getattr(batch, name), getattr(other, name)) and getattr(other, name).dtype == getattr(
            batch, name).dtype
    other.reset()
    assert batch.fx.any() and not other.fx.any()


@pytest.mark.parametrize("way", WAYS)
def test_results(way):
    table = lc.Table("hertz")
    memory = lc.FrictionMemory()
    result = lc.apply_friction(table, 2.4, 0.0, limit=1.2, radius=0.006, stiffness_ratio=25000, memory=memory)
    out = lc.SoftFinger(table).update((0, 0, 0), (0, 0, 1), 0.002, 0.0)
    other = way(out)
    assert repr(other) == repr(out) and other.state is out.state and other.fault is out.fault and np.array_equal(
        other.normal, out.normal)
    assert way(result).force_fraction == result.force_fraction and way(result).cor == np.inf
    assert way(memory).force_slides and not way(lc.FrictionMemory()).force_slides
    fitted = way(lc.fit("ellipse", law="hertz", quiet=True))
    assert fitted.note == fitted["note"][0] and fitted.covariance is None


def test_numbers_of_another_version_are_refused():
    out = lc.SoftFinger(lc.Table("hertz", 1e-4)).output
    version, numbers = out.__getstate__()
    for state in (("0.0.1", numbers), (version, numbers[:-8])):
        with pytest.raises(ValueError, match="^pickled by limitcurve"):
            lc.FingerOutput.__new__(lc.FingerOutput).__setstate__(state)


def force_at(table, c):
    return table.evaluate(c)[0]


def test_a_pool_of_processes():
    table = lc.Table("hertz", 1e-6)
    with concurrent.futures.ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) as pool:
        assert list(pool.map(force_at, [table] * 4,
                             [0.1, 0.5, 1.0, 2.0])) == [table.evaluate(c)[0] for c in (0.1, 0.5, 1.0, 2.0)]
