# SPDX-License-Identifier: MIT
"""Loads the MuJoCo plugin `limitcurve.finger` (examples/mujoco) into the MuJoCo of Python's package."""

import ctypes
import os
import pathlib

import mujoco  # type: ignore[import-not-found, unused-ignore]


def register(path: "str | os.PathLike[str]") -> None:
    """Registers the plugin that was built as `path`, before a model that has it is read. RuntimeError if it was built
    for another MuJoCo."""
    library = pathlib.Path(path).resolve()
    if not library.is_file():
        raise FileNotFoundError(f"{library}: no such file; examples/mujoco/README.md says how to build it")
    # Python loads libmujoco for itself: the plugin must see its symbols.
    (engine,) = pathlib.Path(mujoco.__file__).parent.glob("libmujoco.*")
    ctypes.CDLL(str(engine), mode=ctypes.RTLD_GLOBAL)
    built_for = ctypes.CDLL(str(library)).limitcurve_mujoco_version()
    if built_for != mujoco.mj_version():
        raise RuntimeError(f"{library} was built for MuJoCo {built_for}, this is {mujoco.mj_version()}: build it again")
