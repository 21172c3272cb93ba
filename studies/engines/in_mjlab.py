# SPDX-License-Identifier: MIT
"""mjlab on a processor: what two fingers hold. Its MujocoCfg sets the options, whatever the MJCF says."""

import importlib.metadata

import mujoco
import numpy as np
import torch
from mjlab.sim import MujocoCfg, Simulation, SimulationCfg

import in_mujoco


def held():
    for row in in_mujoco.held_in_worlds("mjlab", importlib.metadata.version("mjlab"), step_of):
        if "noslip" not in row[2]:  # its MuJoCo Warp refuses it
            yield row


def step_of(model, qpos, grip):
    cone = "elliptic" if model.opt.cone == mujoco.mjtCone.mjCONE_ELLIPTIC else "pyramidal"
    options = MujocoCfg(timestep=model.opt.timestep, gravity=(0.0, 0.0, 0.0), cone=cone, impratio=model.opt.impratio)
    options.apply(model)
    simulation = Simulation(len(qpos), SimulationCfg(mujoco=options), model, "cpu")
    simulation.data.qpos[:] = torch.as_tensor(qpos)
    simulation.data.qfrc_applied[:] = torch.as_tensor(grip)

    def step(force):
        simulation.data.xfrc_applied[:] = torch.as_tensor(force)
        simulation.step()
        return np.asarray(simulation.data.qpos[:], float)

    return step
