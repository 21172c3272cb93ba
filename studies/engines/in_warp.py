# SPDX-License-Identifier: MIT
"""MuJoCo Warp on a processor: what two fingers hold."""

import importlib.metadata

import mujoco
import mujoco_warp
import numpy as np
import warp

import in_mujoco

warp.config.quiet = True


def held():
    yield from in_mujoco.held_in_worlds("mujoco-warp", importlib.metadata.version("mujoco-warp"), step_of)


def step_of(model, qpos, grip):
    there = mujoco_warp.put_model(model)
    data = mujoco_warp.put_data(model, mujoco.MjData(model), nworld=len(qpos))
    data.qpos.assign(qpos)
    data.qfrc_applied.assign(np.tile(grip, (len(qpos), 1)))

    def step(force):
        data.xfrc_applied.assign(np.tile(force, (len(qpos), 1, 1)))
        mujoco_warp.step(there, data)
        return data.qpos.numpy().astype(float)

    return step
