# SPDX-License-Identifier: MIT
"""MJX (JAX) on a processor: what two fingers hold."""

import functools
import importlib.metadata

import jax
import jax.numpy as jnp
import numpy as np
from mujoco import mjx

import in_mujoco


def held():
    yield from in_mujoco.held_in_worlds("mjx", importlib.metadata.version("mujoco-mjx"), step_of)


@jax.jit
@functools.partial(jax.vmap, in_axes=(None, None, 0))
def go_on(model, force, data):
    return mjx.step(model, data.replace(xfrc_applied=force))


def step_of(model, qpos, grip):
    there = mjx.put_model(model, impl="jax")
    data = jax.vmap(lambda q: mjx.make_data(model, impl="jax").replace(qpos=q, qfrc_applied=jnp.asarray(grip)))(qpos)

    def step(force):
        nonlocal data
        data = go_on(there, force, data)
        return np.asarray(data.qpos, float)

    return step
