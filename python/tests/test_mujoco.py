# SPDX-License-Identifier: MIT
"""The fingers inside MuJoCo (examples/python/8_mujoco_pivot.py), against `pivot`, whose integrator is another."""

import importlib.util
import runpy

import limitcurve as lc
import numpy as np
import pytest

from conftest import ROOT

mujoco = pytest.importorskip("mujoco")


@pytest.fixture(scope="module")
def example():
    spec = importlib.util.spec_from_file_location("mujoco_pivot", ROOT / "examples/python/8_mujoco_pivot.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(("case", "curve", "projection"), [("exact", "table", "closest-point"),
                                                           ("coupled", "ellipse", "radial")])
def test_the_block_turns_as_in_pivot_and_nearer_with_smaller_steps(example, monkeypatch, case, curve, projection):
    law = lc.Law("hertz")
    on = lc.Table(law, 1e-8) if curve == "table" else lc.ellipse(1.0, law.moment_ratio)
    apart = []
    for step in (1e-3, 0.5e-3):
        monkeypatch.setattr(example, "DT", step)
        grip = {"time": example.GRIP_TIME, "load": example.GRIP_LOAD}
        planar = lc.run("pivot", case=case, material="sandpaper", grip=grip, duration=example.DURATION, time_step=step)
        run = example.simulate(example.scene('condim="1"'), example.Fingers(on, projection))
        apart.append(np.degrees(np.abs(run["angle"] - planar["angle"][: len(run["angle"])])).max())
        # Kinetic, gravity's and the friction springs' energy never grows; nothing leaves the plane; what is held does
        # not creep.
        assert (run["energy"] - np.minimum.accumulate(run["energy"])).max() < 1e-9
        assert run["off_plane"].max() < 1e-7
        assert abs(run["angle"][round(1 / step)]) < 1e-6
        assert np.degrees(run["angle"][-1]) > 40
    assert apart[0] < 0.2
    assert apart[1] < 0.6 * apart[0]


def spinning(plane, body, height):
    """Mean of the friction moment [N m] and of the normal force [N] of a body of 0.3 kg that spins on a plane."""
    model = mujoco.MjModel.from_xml_string(
        f"""<mujoco><option timestep="0.0005" gravity="0 0 -10" cone="elliptic" impratio="10"/><worldbody>
      <geom type="plane" size="0 0 1" {plane}/><body pos="0 0 {height}"><joint type="slide" axis="0 0 1"/>
      <joint type="hinge" axis="0 0 1" armature="1e3"/><geom mass="0.3" {body}/></body></worldbody></mujoco>""")
    data = mujoco.MjData(model)
    mean, contact, steps = np.zeros(2), np.zeros(6), 1000
    for i in range(2 * steps):
        data.qpos[1], data.qvel[1] = 0, 0.2
        mujoco.mj_forward(model, data)
        for k in range(data.ncon if i >= steps else 0):
            mujoco.mj_contactForce(model, data, k, contact)
            frame = data.contact.frame[k].reshape(3, 3)
            force, place = frame.T @ contact[:3], data.contact.pos[k]
            mean += (place[0] * force[1] - place[1] * force[0] + frame[0, 2] * contact[3], contact[0])
        mujoco.mj_step(model, data)
    return abs(mean) / steps


def test_the_traps_of_the_page_which_number_do_i_type():
    table = lc.translate("hertz", "constant:a=0.005", mu=0.8, load=3, engine="mujoco")
    mu_r = float(table["value"][table["formula"] == "mu_r"][0])
    typed = f'condim="4" friction="0.8 {mu_r} 0"'
    ball = f'type="sphere" size="0.02" {typed}'
    # The plane's default of 0.005 is larger, unless both have the number or the finger has priority.
    for plane, finger, moment in (("", ball, 3 * 0.005), (typed, ball, 3 * mu_r), ("", ball + ' priority="1"',
                                                                                   3 * mu_r)):
        found, normal = spinning(plane, finger, 0.02)
        assert normal == pytest.approx(3, rel=1e-3) and found == pytest.approx(moment, rel=1e-3)
    # Without torsion: three balls on a circle of radius m0 a have the moment of the contact.
    lever = mu_r / 0.8
    places = [(lever * np.cos(turn), lever * np.sin(turn)) for turn in (0, 2 * np.pi / 3, 4 * np.pi / 3)]
    balls = '/><geom mass="0" '.join(
        f'type="sphere" size="0.02" pos="{x} {y} 0" condim="3" friction="0.8 0 0"' for x, y in places)
    found, normal = spinning('condim="3" friction="0.8 0 0"', balls, 0.02)
    assert found / normal == pytest.approx(mu_r, rel=1e-3)


@pytest.mark.parametrize("law", ["hertz", "uniform", "power:n=-0.9"])
def test_with_numbers_that_follow_the_slip_the_cone_is_the_exact_curve(law):
    table, pushed = lc.Table(law, 1e-8), runpy.run_path(ROOT / "studies/engines/push.py")["pushed"]
    for lever in (0.05, 0.2, 0.5, 1, 2):
        assert np.abs(pushed(table, lever, True)[:2]).max() < 1e-4, lever
    assert pushed(table, 0.2, False)[1] > 0.3 and pushed(table, 2, False)[1] < -0.1  # of the usual ellipse
