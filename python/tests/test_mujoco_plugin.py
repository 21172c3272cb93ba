# SPDX-License-Identifier: MIT
"""The plugin of examples/mujoco, built as LIMITCURVE_MUJOCO_PLUGIN (scripts/maintain/nightly engines)."""

import concurrent.futures
import copy
import importlib
import os
import runpy
import types

import limitcurve as lc
import numpy as np
import pytest

from conftest import ROOT

mujoco = pytest.importorskip("mujoco")
LIBRARY = os.environ.get("LIMITCURVE_MUJOCO_PLUGIN")
pytestmark = pytest.mark.skipif(not LIBRARY, reason="no plugin")


@pytest.fixture(scope="module")
def demo():
    importlib.import_module("limitcurve.mujoco").register(LIBRARY)
    return types.SimpleNamespace(**runpy.run_path(ROOT / "examples/mujoco/demo.py"))


@pytest.mark.parametrize("law", ["hertz", "uniform", "xydas-kao:k=0.3"])
def test_it_holds_as_load_to_hold_says_and_does_not_creep(demo, law):
    least = lc.Table(law, 1e-8).load_to_hold(demo.FORCE,
                                             demo.FORCE * demo.OFFSET,
                                             mu=demo.MU,
                                             radius_law=f"constant:a={demo.RADIUS}")
    turn, way = demo.moved(demo.scene(law), 1.001 * least, 10)
    assert turn < 1e-8 and way < 1e-9
    assert demo.moved(demo.scene(law), 0.999 * least)[0] > 0.02


@pytest.mark.parametrize("lever", [0.05, 0.3, 1, 2])
def test_a_pushed_disc_turns_about_the_exact_centre(demo, lever):
    """Lever of the push over the disc's radius. Viscous friction takes what is too much."""
    law, mu, radius, drag = lc.Law("uniform"), 0.8, 0.02, 100.0
    keys = "".join(f'<config key="{key}" value="{value}"/>' for key, value in (("law", "uniform"), ("mu", mu),
                                                                               ("radius_law", f"constant:a={radius}")))
    model = mujoco.MjModel.from_xml_string(
        f"""<mujoco><option timestep=".001" gravity="0 0 -10"/><extension><plugin plugin="limitcurve.finger">
      <instance name="skin">{keys}</instance></plugin></extension><worldbody>
      <geom type="plane" size="0 0 1"/><body pos="0 0 .005">
      <joint type="slide" axis="0 0 1"/><joint type="slide" axis="1 0 0" damping="{drag}"/>
      <joint type="hinge" axis="0 0 1" damping="{drag * radius**2}"/>
      <geom type="cylinder" size="{radius} .005" mass=".3" condim="1" priority="1"/><plugin instance="skin"/></body>
      </worldbody></mujoco>"""
    )
    data, push = mujoco.MjData(model), np.array([1, lever * radius])
    data.qfrc_applied[1:] = 1.1 * mu * 3 / lc.Table(law, 1e-8).gauge(1.0, lever) * push
    mujoco.mj_step(model, data, 1000)
    force, moment = data.qfrc_applied[1:] - drag * data.qvel[1:] * (1, radius**2)
    cor = data.qvel[1] / data.qvel[2] / radius
    (most, least) = (m / f for f, m in (law.evaluate(cor * 0.9999), law.evaluate(cor * 1.0001)))
    assert least < moment / radius / force < most


def test_copies_and_threads_go_on_with_the_same_bits(demo):
    model, data = demo.gripped(demo.scene(), 1.2)  # it slips
    spec = mujoco.mjtState.mjSTATE_INTEGRATION
    state = np.zeros(mujoco.mj_stateSize(model, spec))
    mujoco.mj_getState(model, data, state, spec)
    other = mujoco.MjData(model)
    mujoco.mj_setState(model, other, state, spec)
    alike = [data, copy.copy(data), other]
    mujoco.mj_forward(model, alike[1])  # looks ahead, and remembers nothing
    with concurrent.futures.ThreadPoolExecutor(2) as threads:
        list(threads.map(lambda one: mujoco.mj_step(model, one, 500), alike))
    assert all(
        np.array_equal(one.qpos, data.qpos) and np.array_equal(one.plugin_state, data.plugin_state) for one in alike)


def test_friction_is_equal_and_opposite(demo):
    free = demo.scene().replace('<joint type="slide" axis="0 0 -1"/>',
                                "<freejoint/>").replace('<joint type="slide" axis="0 0 1"/>', "<freejoint/>")
    model = mujoco.MjModel.from_xml_string(free.replace('gravity="0 -9.81 0"', 'gravity="0 0 0"'))
    data = mujoco.MjData(model)
    for body, push in ((2, -3.0), (3, 3.0)):
        data.xfrc_applied[body, 2] = push
    mujoco.mj_step(model, data, 300)
    data.qvel[:2], data.qvel[5] = (0.1, 0.05), 2.0
    mass, before, friction = model.body_mass[1:], data.qvel.reshape(3, 6)[:, :3].copy(), 0.0
    for _ in range(50):
        mujoco.mj_step(model, data)
        friction = max(friction, np.abs(data.qfrc_passive[:2]).max())
    change = mass @ (data.qvel.reshape(3, 6)[:, :3] - before)
    assert friction > 0.3 and np.abs(change[:2]).max() < 1e-14


@pytest.mark.parametrize(("keys", "told"), [('<config key="stiffness" value="stiff"/>', "stiffness"),
                                            ('<config key="patch" value="disc"/>', "rectangle"),
                                            ('<config key="patch" value="rectangle:x=.02,y=.01,mx=2"/>', "rectangle"),
                                            ('<config key="mu_dynamic" value="-1"/>', "mu")])
def test_bad_keys_are_refused_by_name(demo, keys, told):
    with pytest.raises(ValueError, match=told):
        mujoco.MjModel.from_xml_string(demo.scene(keys=keys))


def test_another_version_is_refused(demo, monkeypatch):
    monkeypatch.setattr(mujoco, "mj_version", lambda: 1)
    with pytest.raises(RuntimeError, match="build it again"):
        importlib.import_module("limitcurve.mujoco").register(LIBRARY)
