# SPDX-License-Identifier: MIT
"""The fingers inside MuJoCo (examples/python/8_mujoco_pivot.py), against `pivot`, whose integrator is another."""

import importlib.util

import limitcurve as lc
import numpy as np
import pytest

from conftest import ROOT

pytest.importorskip("mujoco")


@pytest.fixture(scope="module")
def example():
    spec = importlib.util.spec_from_file_location("mujoco_pivot", ROOT / "examples/python/8_mujoco_pivot.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(("case", "curve", "projection"), [("exact", "table", "closest-point"), ("coupled", "ellipse", "radial")])
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
        # Kinetic, gravity's and the friction springs' energy never grows; nothing leaves the plane; what is held does not creep.
        assert (run["energy"] - np.minimum.accumulate(run["energy"])).max() < 1e-9
        assert run["off_plane"].max() < 1e-7
        assert abs(run["angle"][round(1 / step)]) < 1e-6
        assert np.degrees(run["angle"][-1]) > 40
    assert apart[0] < 0.2
    assert apart[1] < 0.6 * apart[0]
