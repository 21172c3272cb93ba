# SPDX-License-Identifier: MIT
"""Laws, tables, fingers, batches and patches: shapes, types of numbers, and values against independent results."""

import functools
import math
import pickle
import warnings

import limitcurve as lc
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from limitcurve import arrays

from conftest import SCENE

TABLE = lc.Table("hertz", tolerance=1e-8)
CORS = st.floats(min_value=0, allow_nan=False) | st.just(math.inf)


@given(hnp.arrays(np.float64, hnp.array_shapes(max_dims=4, max_side=5), elements=CORS))
def test_results_have_the_shape_of_c(c):
    for curve in (lc.Law("uniform"), TABLE):
        f, m = curve.evaluate(c)
        assert f.shape == m.shape == c.shape and f.dtype == m.dtype == np.float64
        assert ((f >= 0) & (f <= 1) & (m >= 0)).all()
        each = [curve.evaluate(one) for one in c.ravel()]
        assert np.array_equal(f.ravel(), [one[0]
                                          for one in each]) and np.array_equal(m.ravel(), [one[1] for one in each])


@pytest.mark.parametrize("make", [lc.ellipse, lc.box])
def test_measured_moments_are_the_limits_of_any_curve(make, tmp_path):
    curve = make(0.9, 0.5)
    (tmp_path / "m.csv").write_text("load,moment\n0.5,0.0015\n1,0.003\n2,0.006\n")
    given = {"mu": 0.6, "radius_law": f"moments:{tmp_path}/m.csv"}
    assert curve.load_to_hold(0, 0.003, **given) == pytest.approx(1)
    finger, batch = lc.SoftFinger(curve, **given, stiffness=1000), lc.Batch(curve, 1, **given, stiffness=1000)
    changed = lc.SoftFinger(curve, stiffness=1000)
    changed.change(**given, stiffness=1000)
    for twist in (0.0, 1.0):
        for one in (finger, changed):
            one.update((0, 0, 0), (0, 0, 1), 0.001, twist)
        batch.update(0.0, 0.0, 0.001, twist)
    assert [-finger.output.moment, -changed.output.moment, -batch.moment[0]] == pytest.approx([0.003] * 3)


def test_single_precision_in_single_precision_out():
    f, m = lc.Law("hertz").evaluate(np.linspace(0, 2, 5, dtype=np.float32))
    assert f.dtype == m.dtype == np.float32
    assert isinstance(lc.Law("hertz").evaluate(np.float32(1))[0], np.float32)
    assert isinstance(lc.Law("hertz").evaluate(1)[0], float) and len(lc.Law("hertz").evaluate(1, error=True)) == 4


def test_strided_reversed_and_read_only_arrays_are_read():
    c = np.linspace(0, 3, 31)
    f = lc.Law("hertz").evaluate(c)[0]
    assert np.array_equal(lc.Law("hertz").evaluate(c[::-2])[0], f[::-2])
    frozen = np.broadcast_to(np.float64(0.5), (3, 4))
    assert (TABLE.evaluate(frozen)[0] == TABLE.evaluate(0.5)[0]).all()
    assert np.array_equal(
        TABLE.evaluate(np.asfortranarray(c[:30].reshape(5, 6)))[0],
        TABLE.evaluate(c[:30].reshape(5, 6))[0])


def test_not_a_number_gives_not_a_number():
    for curve in (lc.Law("hertz"), lc.Law("power:n=2.3"), TABLE, lc.ellipse(1, 0.6), lc.box(1, 0.6)):
        f, m = curve.evaluate([math.nan, 1])
        assert math.isnan(f[0]) and math.isnan(m[0]) and f[1] > 0


def test_wrench_broadcasts():
    slide, spin = np.array([0.0, -0.3, 2e-9, 5]), np.array([1.0, -1e-9, 0.7])[:, None]
    for curve in (TABLE, lc.ellipse(1, 0.6)):
        f, m = curve.wrench(slide, spin)
        assert f.shape == m.shape == (3, 4) and (f[2, 1], m[2, 1]) == curve.wrench(-0.3, 0.7)
        assert isinstance(curve.wrench(1, np.float64(2))[0], float) and isinstance(
            curve.wrench(np.float32(1), np.float32(2))[1], np.float32)


def test_the_tangent_ellipse_of_a_slip_or_a_wrench_broadcasts():
    slide, spin = np.array([0.1, 1, 30.0]), np.array([1.0, -0.7])[:, None]
    p, q = TABLE.tangent_ellipse(slip=(slide, spin))
    f, m = TABLE.wrench(slide, spin)
    for again in (TABLE.tangent_ellipse(f, -m, p, q), TABLE.tangent_ellipse(-f, m)):
        assert np.allclose(again, (p, q), rtol=1e-9)
    for wrong in ({}, {"force": 1}, {"force": 1, "moment": 1, "q": 1}, {"p": 1, "q": 1, "slip": (1, 1)},
                  {"force": 1, "moment": 1, "slip": (1, 1)}, {"slip": (1, 1, 1)}):
        for call in (TABLE.tangent_ellipse, functools.partial(arrays.tangent_ellipse, arrays.cells(TABLE))):
            with pytest.raises(ValueError, match="expected"):
                call(**wrong)


def test_single_numbers_are_arrays_of_one():
    law = lc.Law("hertz")
    calls = {
        law.evaluate: [0.7],
        TABLE.evaluate: [0.7],
        TABLE.wrench: [0.7, -0.3],
        TABLE.gauge: [0.7, 0.3],
        lc.box(1, 0.6).gauge: [0.7, 0.3]
    }
    for call, given in calls.items():
        for kind in (np.float64, np.float32):
            one, many = call(*map(kind, given)), call(*(np.array([x], kind) for x in given))
            for x, xs in zip(np.atleast_1d(one), np.reshape(many, -1)):
                assert x == xs and xs.dtype == kind
        with pytest.raises(ValueError, match="expected real numbers|expected numbers"):
            call(*("one" for _ in given))
    for kind in (float, np.float32):
        assert TABLE.gauge(kind(1), kind(-0.5)) == TABLE.gauge(kind(1), kind(0.5)) and TABLE.gauge(
            kind("inf"), kind(1)) == np.inf


def test_load_to_hold_broadcasts():
    force, moment = np.linspace(0, 2, 5), np.linspace(0, 5e-3, 4)[:, None]
    for call in (lambda f, m: TABLE.load_to_hold(f, m, mu=0.6, radius_law="power:c=0.002,gamma=0.3"),
                 lambda f, m: lc.Patch("rectangle:x=0.02,y=0.01").load_to_hold(0, f, m, mu=0.4)):
        loads = call(force, moment)
        assert loads.shape == (4, 5) and loads[0, 0] == 0 and loads[3, 2] == call(force[2], moment[3, 0])
        assert isinstance(call(1, 0), float) and math.isnan(call(math.nan, 0))


def test_wrenches_and_slips_of_a_patch_broadcast():
    patch = lc.Patch("rectangle:x=0.02,y=0.01,my=0.6")
    twists = np.array([[[0.01, 0.02, 1.0], [-0.3, 0.02, 0.5]], [[0.0, 0.001, -1.0], [0.1, 0.1, 20.0]]])
    wrenches, powers, errors = patch.wrench(twists, 0.7, 3, error=True)
    assert wrenches.shape == (2, 2, 3) and powers.shape == errors.shape == (2, 2)
    slips = patch.slip(*np.moveaxis(wrenches, -1, 0))
    assert np.allclose(slips * powers[..., None], twists, rtol=1e-8, atol=1e-10)
    assert patch.slip(1, 0, 0).shape == (3,) and np.isnan(patch.slip([0, math.nan], 0, 0)).all()


def test_an_inaccurate_slip_warns_unless_its_error_is_asked_for():
    patch = lc.Patch.image([[1, 1, 1], [1, 7, 7]], 0.004)
    with pytest.warns(UserWarning, match="off by up to"):
        patch.slip(0, 1, 0.003)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert patch.slip(0, 1, 0.003, error=True)[1] > 1e-6


def profile_file(path, exponent):
    radius = np.linspace(0, 5, 30)
    path.write_text("radius,pressure\n" + "".join(f"{r},{25 - r**exponent}\n" for r in radius.tolist()))
    return path


def test_a_batch_in_single_precision_has_the_curve_of_its_table(tmp_path, monkeypatch):
    """Also where the table's law is a name that means something else by now."""
    file = profile_file(tmp_path / "p.csv", 2)
    lc.Table(f"samples:{file}").save(tmp_path / "t.csv")
    profile_file(file, 0.5)
    radius = np.linspace(0, 1, 9)
    monkeypatch.chdir(tmp_path)
    file.rename(tmp_path / "elsewhere.csv")
    for table in (lc.Table.load("t.csv"), lc.Table(lc.Law.samples(radius,
                                                                  1 - radius ** 4)), lc.Table("gaussian:sigma=1",
                                                                                              0.1), TABLE):
        both = [lc.Batch(table, 50, dtype=dtype, mu=0.6) for dtype in (np.float64, np.float32)]
        for batch in both:
            batch.update(0, 0, 0.002, 0)
            batch.update(np.linspace(0.002, 0.02, 50), 0, 0.002, np.linspace(2, 0, 50))
        one, other = both
        error = max(5e-7, table.tolerance / 100) + 1e-6  # and the rounding of coordinates
        assert np.allclose(one.fx, other.fx, atol=1.2 * error) and np.allclose(
            one.moment, other.moment, atol=1.2 * 0.005 * error)
        assert (one.state == lc.ContactState.slip).all() and np.abs(one.moment).max() > 1e-3


def test_a_law_is_the_file_as_it_was_read(tmp_path):
    file = profile_file(tmp_path / "p.csv", 2)
    law = lc.Law(f"samples:{file}")
    fitted = lc.fit("ellipse", law=law, quiet=True)["value"]
    radius, pressure = law.arrays
    assert np.array_equal(radius, np.linspace(0, 5, 30)) and np.array_equal(pressure, 25 - radius**2)
    profile_file(file, 0.5)
    assert lc.run("curve", law=law, points=3)["moment"].max() == law.moment_ratio
    assert np.array_equal(lc.fit("ellipse", law=law, quiet=True)["value"], fitted)
    file.unlink()
    assert lc.run("eval", law=law, c=0)["moment"] == law.moment_ratio
    assert set(lc.validate(law)["law"]) == {f"samples:{file}"}
    for array in law.arrays:
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 3
        with pytest.raises(ValueError, match="WRITEABLE"):
            array.flags.writeable = True


def test_a_profile_from_arrays_is_the_profile_in_a_file(tmp_path):
    radius = np.linspace(0, 5, 30)
    mine, file = lc.Law.samples(radius, 25 - radius**2), profile_file(tmp_path / "p.csv", 2)
    assert mine.profile_error > 0
    assert np.array_equal(mine.evaluate([0, 0.3, 2]), lc.Law(f"samples:{file}").evaluate([0, 0.3, 2]))


def test_the_size_and_the_noise_of_a_measured_pressure():
    radius = np.linspace(0, 20, 41)
    pressure = np.sqrt(np.maximum(0, 1 - (radius / 6) ** 2))
    pressure[-2] = 0.004
    with pytest.warns(UserWarning, match="the mean radius of its load is 3.55"):
        assert lc.Law.samples(radius, pressure).rim == 20
    with pytest.warns(UserWarning, match="lie beyond rim=6"):
        named = lc.Law.samples(radius, pressure, rim=6)
        assert named.rim == 6 and named.name == "samples:arrays,rim=6"
        assert pickle.loads(pickle.dumps(named)).moment_ratio == named.moment_ratio
        assert lc.run("eval", law=named, c="0")["moment"] == named.evaluate(0)[1]
    image = np.array([[0.01, 1], [2, 3]])
    with pytest.warns(UserWarning, match="pressures: 1 up to 0.02 count as 0, 0.17 % of the load"):
        patch = lc.Patch.image(image, 1e-3, floor=0.02)
    assert pickle.loads(pickle.dumps(patch)).moment_ratio == patch.moment_ratio != lc.Patch.image(image,
                                                                                                  1e-3).moment_ratio


def test_an_output_is_its_own():
    finger = lc.SoftFinger(TABLE, mu=0.6, radius_law="constant:a=0.006")
    finger.update([0, 0, 0], (0, 0, 1), 0.002, 0.0)
    out = finger.update([0.01, 0, 0], np.array([0.0, 0, 1]), 0.002, 0.0, 0.1)
    assert out.state == lc.ContactState.slip and str(out.state) == "slip" and out.cor == math.inf
    out.force[:] = out.normal[:] = out.proxy[:] = 7  # arrays of a result are copies
    assert np.allclose(out.force, [-1.2, 0, 0]) and out.normal.tolist() == [0, 0, 1] and out.proxy[0] < 0.01
    other = finger.copy()
    finger.reset()
    assert finger.output.state == lc.ContactState.free and other.output.state == lc.ContactState.slip


def test_a_finger_takes_orientations_and_other_materials():
    finger, other = lc.SoftFinger(TABLE, **SCENE), lc.SoftFinger(TABLE, **SCENE)
    touch = {"point": (0, 0, 0), "normal": (0, 0, 1), "depth": 0.002}
    for i in range(200):
        turn = 0.005 * i
        held = (math.cos(turn / 2), 0, 0, math.sin(turn / 2))
        ahead = finger.preview_pose(**touch, orientation=held, dt=1e-3), other.preview(**touch, twist=turn, dt=1e-3)
        out = finger.update_pose(**touch, orientation=held, dt=1e-3)
        assert out.moment == ahead[0].moment and other.update(**touch, twist=turn, dt=1e-3).moment == ahead[1].moment
    assert out.moment == pytest.approx(-7.2e-3 * 3 * math.pi / 16, abs=1e-9) and other.output.moment == pytest.approx(
        out.moment, abs=1e-9)
    assert np.array_equal(out.whole_force, [0, 0, 2]) and np.array_equal(out.moment_vector, [0, 0, out.moment])
    before = finger.output.moment
    with pytest.raises(ValueError, match="mu_dynamic = 0.4"):
        finger.change(**(SCENE | {"mu": 0.3, "mu_dynamic": 0.4}))
    finger.change(**(SCENE | {"mu": 0.3}))
    assert finger.output.moment == before and finger.margin() == 0 and finger.load_to_hold() == pytest.approx(4,
                                                                                                              rel=1e-6)
    other.copy_state(pickle.loads(pickle.dumps(finger)))
    assert other.output.moment == before and other.load_to_hold() == pytest.approx(2, rel=1e-6)
    assert finger.update_pose(**touch, orientation=held).moment == pytest.approx(before / 2, abs=1e-9)
    assert finger.update_under_load_pose((0, 0, 0), (0, 0, 1), 4, held,
                                         1e-3).moment == pytest.approx(before / 2, abs=1e-9)  # it holds


def test_a_finger_under_a_load_is_one_of_that_depth():
    """tests/oracle/ask compares fingers, batches and replay."""
    given = {"mu": 0.6, "radius_law": "power:c=0.00207,gamma=0.259", "stiffness": 1000, "twist_stiffness": 0.036}
    finger, under_load = lc.SoftFinger(TABLE, **given), lc.SoftFinger(TABLE, **given)
    for x, depth, twist, landed in ((0, 0.002, 0, False), (0.0005, 0.002, 0.1, False), (0.01, 0.003, 0.4, False),
                                    (0.02, 0.001, 1.4, True), (0.01, 0, 0.4, False)):
        out = finger.update((x, 0, 0), (0, 0, 1), depth, twist, 0.1, landed=landed)
        other = under_load.update_under_load((x, 0, 0), (0, 0, 1), 1000 * depth, twist, 0.1, landed=landed)
        assert other.state == out.state and np.allclose([other.load, *other.force[:2], other.moment],
                                                        [out.load, *out.force[:2], out.moment], atol=1e-12)
        assert out.force[:2].any() != (landed or x == 0 or depth == 0)  # anew where it lands


def test_a_batch_steps_in_place_and_shows_its_arrays():
    batch = lc.Batch(TABLE, 4, mu=0.6, radius_law="constant:a=0.006")
    views = batch.fx, batch.moment, batch.state
    batch.update(0, 0, 0.002, 0)
    batch.update(np.array([0, 1e-3, 1e-2, 0]), 0, np.array([0.002, 0.002, 0.002, -1]), np.zeros(4), 1e-3)
    assert [str(lc.ContactState(one)) for one in views[2]] == ["stick", "stick", "slip", "free"]
    assert views[0] is not batch.fx and np.shares_memory(views[0], batch.fx) and not views[0].flags.writeable
    assert np.allclose(views[0], [0, -1, -1.2, 0], atol=1e-12) and len(batch) == 4
    batch.update(batch.fx, 0, 0.002, 0)  # its own result as its input
    batch.reset()
    assert (views[2] == 0).all() and (views[0] == 0).all()
    del batch
    assert (views[0] == 0).all()  # a view keeps its batch


def test_patches_from_arrays_are_those_from_files(tmp_path):
    x, y, load = [0, 0.01, 0.0], [0, 0, 0.01], [1, 2, 1.5]
    (tmp_path / "p.csv").write_text("x,y,load\n" + "".join(f"{a},{b},{c}\n" for a, b, c in zip(x, y, load)))
    twists = np.random.default_rng(1).normal(size=(50, 3))
    assert np.array_equal(
        lc.Patch.points(x, y, load).wrench(twists),
        lc.Patch(f"points:{tmp_path / 'p.csv'}").wrench(twists))
    rectangle = lc.Patch.polygon([-0.01, 0.01, 0.01, -0.01], [-0.005, -0.005, 0.005, 0.005])
    finger = lc.SoftFinger(rectangle, mu=0.6)
    assert str(finger.update((0, 0, 0), (0, 0, 1), 0.001, 0).state) == "stick"
    assert finger.update((0.004, 0, 0), (0, 0, 1), 0.001, 0).force[0] == pytest.approx(-0.6) and finger.output.converged


def test_a_late_device_needs_more_damping():
    assert lc.device_damping_needed(1e-3, delay=2, stiffness=1000) == pytest.approx((2.5, 2.5e-3 * 0.025))
    with pytest.raises(ValueError, match="a delay of 2 samples need .* 2.5 N s/m"):
        lc.require_passive(1e-3, 2.49, delay=2, stiffness=1000)


def test_a_batch_says_which_samples_were_not_usable():
    batch = lc.Batch(TABLE, 3, mu=0.6)
    batch.update(np.array([0.01, 0.01, np.nan]), 0.0, np.array([0.002, np.nan, 0.002]), 0.0)
    assert batch.invalid.tolist() == [False, True, True]


def test_a_finger_says_why_a_sample_is_invalid():
    finger = lc.SoftFinger(TABLE, mu=0.6)
    assert finger.update((0, 0, 0), (0, 0, 1), 0.002, 0.0).fault == lc.Fault.none
    for bad, fault in (((math.nan, 0, 0), (0, 0, 1), 0.0), "not_finite"), (((0, 0, 0), (0, 0, 2), 0.0), "normal"), \
            (((0, 0, 0), (0, 0, 1), -1.0), "time_step"), (((2, 0, 0), (0, 0, 1), 0.0), "speed"):
        point, normal, dt = bad
        output = finger.update(point, normal, 0.002, 0.0, dt)
        assert str(output.state) == "invalid" and str(output.fault) == fault and output.fault == lc.Fault[fault]


def test_walls_of_a_groove_are_joined_for_an_update():
    half = math.sqrt(0.5)  # two faces at right angles, 1 mm above the finger; their edge is straight above it
    at = np.array([0.01, 0.02, 0.03], dtype=np.float32)
    walls = [(at + 1e-3 * np.array(normal), normal, 1e-3) for normal in ((half, 0, half), [-half, 0, half])]
    point, normal, depth = lc.join(wall for wall in walls)
    assert depth == pytest.approx(1e-3 / half) and point == pytest.approx(at + [0, 0, depth]) and normal[2] == 1
    assert str(lc.SoftFinger(TABLE, mu=0.6).update(*lc.join(walls), twist=0.0).state) == "stick"
    assert lc.join([])[2] == 0 and lc.join(walls[:1])[2] == 1e-3
    for wrong in ((at, (0, 0, 1)), (at, (0, 1), 1e-3), (at, (0, 0, 1), "deep")):
        with pytest.raises((TypeError, ValueError), match=r"contacts\[1\]"):
            lc.join([walls[0], wrong])


def test_friction_has_a_memory_and_limits_while_it_slides():
    given, memory = {"limit": 1.2, "radius": 0.006, "stiffness_ratio": 25000}, lc.FrictionMemory()
    result = lc.apply_friction(TABLE, 2.4, 0.0, **given, memory=memory)
    assert result.slips and result.force_fraction == pytest.approx(0.5, rel=1e-12) and memory.force_slides
    result = lc.apply_friction(TABLE, 2.4, 0.0, **given, sliding_limit=0.6, sliding_radius=0.012)
    assert result.slips and result.force_fraction == pytest.approx(0.25, rel=1e-12)
    for wrong in ({"sliding_limit": 0.6, "sliding_radius": 0.013}, {"moment_stick_fraction": -0.1}):
        with pytest.raises(ValueError, match=list(wrong)[-1]):
            lc.apply_friction(TABLE, 2.4, 0.0, **given, **wrong)


def test_the_cells_of_a_table_are_its_file(tmp_path):
    TABLE.save(tmp_path / "t.csv")
    rows = [line.split(",") for line in (tmp_path / "t.csv").read_text().splitlines() if not line.startswith("#")]
    places = [rows[0].index(name) for name in ("x", "c0", "c1", "c2", "c3", "c4", "c5", "c6")]
    written = np.array([[row[0] == "outside", *(float(row[i] or 0)
                                                for i in places)]
                        for row in rows[1:]
                        if float(row[1]) < 1])
    assert TABLE.cells.shape == (len(written), 9) and np.array_equal(TABLE.cells, written)
    x, c = TABLE.cells[1, 1], TABLE.cells[1, 2:]  # inside, at the beginning of a cell: D = c0, D' = c1
    assert TABLE.evaluate(x) == pytest.approx((c[1], c[0] - x * c[1]), rel=1e-15)


def test_half_spaces_are_arrays():
    A, V, share = lc.Patch("rectangle:x=0.2,y=0.1").half_spaces(20)
    assert (A.shape, V.shape) == ((14, 3), (18, 3))
    table = lc.run("patch", patch="rectangle:x=0.2,y=0.1", half_spaces=20)
    assert np.array_equal(np.vstack([A, V]), np.column_stack([table[name] for name in ("fx", "fy", "moment")]))
    assert share == table["share"][0]
    for rows in (7, 8.5, float("nan")):
        with pytest.raises(ValueError, match="rows"):
            lc.Patch("rectangle:x=0.2,y=0.1").half_spaces(rows)
