# SPDX-License-Identifier: MIT
"""The friction of a soft finger, exactly: limit curves, tables of them, and a soft-finger god-object.

>>> import limitcurve as lc
>>> f, m = lc.Law("hertz").evaluate([0, 1, float("inf")])  # F/(mu P), M/(mu P a) at COR distances of c radii
>>> table = lc.Table("hertz", tolerance=1e-8)
>>> finger = lc.SoftFinger(table, mu=0.6, radius_law="constant:a=0.006", stiffness=1000, twist_stiffness=0.036)

Functions that return tables (`validate`, `choose`, `fit`, `hold`, `translate`, `replay`, `run`) give a dict of arrays
with the command line's columns, which prints as a table and has its rows as attributes: fit.mu, fit.mu_r.std_error.
Wrong input raises a ValueError with the command line's message, a failed job a RuntimeError. SI units throughout.
`limitcurve.plot` draws with matplotlib; `limitcurve.arrays` and `limitcurve.warp` are friction for JAX, torch and
kernels of Warp.
"""

from ._core import (
    Batch,
    ContactState,
    Curve,
    Fault,
    FingerOutput,
    FrictionMemory,
    FrictionResult,
    Law,
    Patch,
    PatchTable,
    SoftFinger,
    Table,
    apply_friction,
    box,
    device_damping_needed,
    ellipse,
    join,
    require_passive,
    version as __version__,
)
from ._radius_law import RadiusLaw
from ._tables import Fit, choose, fit, hold, replay, run, translate, validate


def _word(state: ContactState | Fault) -> str:
    return state.name


for _kind in (ContactState, Fault):
    setattr(_kind, "__str__", _word)  # the command line's word, not a number

__all__ = [
    "Batch",
    "ContactState",
    "Curve",
    "Fault",
    "Fit",
    "FingerOutput",
    "FrictionMemory",
    "FrictionResult",
    "Law",
    "Patch",
    "PatchTable",
    "RadiusLaw",
    "SoftFinger",
    "Table",
    "__version__",
    "apply_friction",
    "box",
    "choose",
    "device_damping_needed",
    "ellipse",
    "fit",
    "hold",
    "join",
    "replay",
    "require_passive",
    "run",
    "translate",
    "validate",
]
