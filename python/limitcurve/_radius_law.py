# SPDX-License-Identifier: MIT
"""Radius laws from numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from numpy.typing import ArrayLike

from ._call import named_columns
from ._core import MemoryColumns
from ._tables import _check_keywords


class RadiusLaw(str):
    """The contact radius a(P) from numbers: the text that a user would type, which every `radius_law` takes. No unit is
    asked of numbers.

    >>> import limitcurve as lc
    >>> finger = lc.SoftFinger(lc.Table("hertz"), radius_law=lc.RadiusLaw.constant(0.006))
    """

    _memory: Any = None  # the columns that the text names
    _columns: Any = None

    def __reduce__(self) -> tuple[Any, ...]:
        return (RadiusLaw, (str(self),)) if self._columns is None else (_of_columns, self._columns)

    @_check_keywords
    def __new__(cls, text: str) -> RadiusLaw:
        if not isinstance(text, str):
            raise ValueError(f"text: got {text!r}, expected a str, such as 'constant:a=0.005'")
        return super().__new__(cls, text)

    @staticmethod
    @_check_keywords
    def constant(a: float) -> RadiusLaw:
        """a [m] at every load."""
        return _of_numbers("constant", a=a)

    @staticmethod
    @_check_keywords
    def hertz(R: float, E: float) -> RadiusLaw:
        """An elastic ball: radius R [m], effective modulus E [Pa]."""
        return _of_numbers("hertz", R=R, E=E)

    @staticmethod
    @_check_keywords
    def power(c: float, gamma: float) -> RadiusLaw:
        """a = c P^gamma [m]."""
        return _of_numbers("power", c=c, gamma=gamma)

    @staticmethod
    @_check_keywords
    def samples(load: ArrayLike, radius: ArrayLike) -> RadiusLaw:
        """Radii [m] measured at loads [N]."""
        return _of_columns("samples", {"load": load, "radius": radius})

    @staticmethod
    @_check_keywords
    def moments(load: ArrayLike, moment: ArrayLike) -> RadiusLaw:
        """Moments of pure twists [N m] measured at loads [N]."""
        return _of_columns("moments", {"load": load, "moment": moment})


def _of_numbers(kind: str, **numbers: float) -> RadiusLaw:
    for name, number in numbers.items():
        try:
            numbers[name] = math.nan if isinstance(number, (bool, bytes, str)) else float(number)
        except (TypeError, ValueError, OverflowError):
            numbers[name] = math.nan
        if math.isnan(numbers[name]):
            raise ValueError(f"{name}: got {number!r}, expected a number") from None
    return RadiusLaw(f"{kind}:" + ",".join(f"{name}={number!r}" for name, number in numbers.items()))


def _of_columns(kind: str, columns: Mapping[str, ArrayLike]) -> RadiusLaw:
    arrays, refused = named_columns(kind, columns)
    memory = MemoryColumns(kind, arrays, refused)
    law = RadiusLaw(f"{kind}:{memory.path}")
    law._memory, law._columns = memory, (kind, dict(arrays))
    return law
