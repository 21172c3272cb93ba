# SPDX-License-Identifier: MIT
"""One call of the command line's own code, with arrays in place of files."""

from __future__ import annotations

import os
import re
import sys
import warnings
from collections.abc import Iterable, Mapping
from types import SimpleNamespace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import Law, Patch, columns_of, numbers_of

class Row(float):
    """The number in the row's column `value`; all its columns are attributes."""

    def __new__(cls, columns: Mapping[str, Any]) -> Row:
        row = super().__new__(cls, columns["value"])
        row.__dict__.update(columns)
        return row

    def __reduce__(self) -> tuple[Any, ...]:
        return Row, (self.__dict__,)

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"no {name!r}, expected {', '.join(self.__dict__)}")


class Columns(dict[str, NDArray[Any]]):
    """A table: its columns by name, arrays of one length. An attribute is the row of that parameter, model, law or
    engine, or that is `chosen`: fit.mu_r.std_error, choice.chosen.model, numbers.mujoco.torsional; of several rows it
    is the table. print() aligns."""

    @property
    def table(self) -> dict[str, NDArray[Any]]:
        """The columns alone; of `choose` the row of the table."""
        return self.__getattr__("table") if "table" in self.get("model", ()) else dict(self)

    def __getattr__(self, name: str) -> Any:
        known: list[str] = []
        for key in ("parameter", "model", "law", "engine", "chosen"):
            if name.startswith("_") or key not in self or self[key].dtype.kind == "f":
                continue
            words = [key * bool(one) if key == "chosen" else re.sub(r"\W", "_", str(one)) for one in self[key]]
            rows = np.array([word == name for word in words])
            if rows.any():
                some = Columns({column: values[rows] for column, values in self.items()})
                if rows.sum() > 1:
                    return some
                row = {column: values[0] for column, values in some.items()}
                return Row(row) if "value" in row else SimpleNamespace(**row)
            known += dict.fromkeys(filter(str.isidentifier, words))
        if name in self:
            raise AttributeError(f"{name!r} is a column: [{name!r}]")
        raise AttributeError(f"no {name!r}, expected {', '.join(known)}")

    def __eq__(self, other: object) -> bool:
        """NaN is as NaN."""
        same = lambda one, two: np.array_equal(one, two, equal_nan=one.dtype.kind == two.dtype.kind == "f")
        return isinstance(other, dict) and list(self) == list(other) and all(map(same, self.values(), other.values()))

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __str__(self) -> str:
        texts = [[name] + [f"{one:.4g}" if isinstance(one, float) else str(one)
                           for one in values.tolist()]
                 for name, values in self.items()
                 if name != "note"]
        columns = [[text.ljust(max(map(len, column))) for text in column] for column in texts]
        return "\n".join(["  ".join(row).rstrip()
                          for row in zip(*columns)] + list(filter(None, dict.fromkeys(map(str, self.get("note", ()))))))


Data: TypeAlias = "str | os.PathLike[str] | Mapping[str, ArrayLike] | Any"
"""A file, or columns by name: a dict of arrays, a pandas DataFrame, a structured array.
Rows with a masked number are left out, with a warning."""


def column_names(data: Any) -> list[Any] | None:
    """None of what has no columns."""
    if isinstance(data, np.ndarray):
        return list(data.dtype.names) if data.dtype.names else None
    return list(data) if isinstance(data, Mapping) else list(data.columns) if hasattr(data, "columns") else None


def named_columns(name: str, data: Any) -> tuple[list[tuple[str, NDArray[np.float64]]], list[str]]:
    """The columns, and of each what is wrong with it: the command refuses what it reads, and ignores the others."""
    if hasattr(data, "collect") and hasattr(data, "columns"):  # lazy frames of polars
        data = data.collect()
    names = column_names(data)
    if names is None:
        raise ValueError(f"{name}: got {type(data).__name__}, expected a file's name, or columns by name")
    columns, refused = columns_of(name, list(map(str, names)), [data[column] for column in names])
    return list(zip(map(str, names), columns)), refused


class Call:
    """A command line under construction, with the columns in memory that it reads."""

    def __init__(self, *words: str) -> None:
        for word in words:
            if not isinstance(word, str):
                raise ValueError(f"arguments: got {word!r}, expected texts")
        self.words = list(words)
        self.memory: list[_core.MemoryColumns | _core.MemoryPatch] = []

    def data(self, name: str, value: Data) -> str:
        """The name of a file with the contents of `value`."""
        if isinstance(value, (str, os.PathLike)):
            return os.fsdecode(value)
        return self._memory(name, *named_columns(name, value))

    def law(self, value: str | Law) -> str:
        if not isinstance(value, Law):
            return str(value)
        if value.arrays is None:
            return value.name
        radius, pressure = value.arrays
        source, *rim = re.split(r"(,rim=[^,]*$)", value.name.removeprefix("samples:"))
        return "samples:" + self._memory(source, [("radius", radius), ("pressure", pressure)], ["", ""]) + "".join(rim)

    def patch(self, value: str | Patch) -> str:
        if isinstance(value, str):
            return value
        self.memory.append(_core.MemoryPatch(value))
        return self.memory[-1].path

    def _memory(self, name: str, columns: list[tuple[str, NDArray[np.float64]]], refused: list[str]) -> str:
        self.memory.append(_core.MemoryColumns(name, columns, refused))
        return self.memory[-1].path

    def option(self, name: str, value: Any) -> None:
        """Adds an option, `name` in Python's spelling; leaves out None and False."""
        if isinstance(value, (np.generic, np.ndarray)) and value.ndim == 0:
            if value.dtype.kind in "mMc" or np.ma.is_masked(value):
                raise ValueError(f"{name}: got {value!r}, expected a number")
            value = value.item()
        if value is None or value is False:
            return
        word = "--" + name.replace("_", "-")
        if value is True:
            self.words.append(word)
        elif name in ("law", "patch"):
            several = list(value) if isinstance(value, Iterable) and not isinstance(value, str) else [value]
            if not several:
                raise ValueError(f"{name}: got an empty list, expected one or more")
            for one in several:
                if not isinstance(one, (str, Law if name == "law" else Patch)):
                    raise ValueError(f"{name}: got {one!r}, expected a str or a {name.capitalize()}")
                self.words += [word, self.law(one) if name == "law" else self.patch(one)]
        elif name in ("columns", "units") and isinstance(value, Mapping):
            # A name with a comma is quoted, as the command wants it.
            texts = {key: f'"{text}"' if "," in str(text) and '"' not in text else text for key, text in value.items()}
            self.words += [word, ",".join(f"{key}={text}" for key, text in texts.items())]
        elif name == "read" and not isinstance(value, str):
            if isinstance(value, Mapping) or not all(isinstance(one, str) for one in value):
                raise ValueError(f"read: got {value!r}, expected 'ENGINE.PARAMETER=VALUE', or a list of such texts")
            for one in value:
                self.words += [word, one]
        elif name in ("data", "trace", "twists") or column_names(value) is not None:
            self.words += [word, self.data(name, value)]
        elif isinstance(value, (str, os.PathLike)):
            self.words += [word, os.fsdecode(value)]
        elif isinstance(value, (int, float)):
            self.words += [word, repr(value)]
        else:
            self.words += [word, ",".join(map(repr, numbers_of(value, name).ravel().tolist()))]

    def run(self, notes: list[str] | None = None) -> Columns:
        """Warnings are Python's; other lines go to `notes`, without it to standard error."""
        said: list[str] = []
        try:
            return Columns(_core.run(self.words, said))
        except ValueError as error:
            raise ValueError(_in_python(str(error))) from None
        finally:
            for line in said:
                text = _in_python(line.removeprefix("limitcurve: "))
                if text.startswith("warning: "):
                    warnings.warn(text.removeprefix("warning: "), stacklevel=_stacklevel())
                elif notes is not None:
                    notes.append(text.removeprefix("note: "))
                else:
                    print(line, file=sys.stderr)


def _in_python(message: str) -> str:
    """A message of the command with the keywords of Python in place of its options."""
    if message.startswith("note: for "):  # options of the command line
        return message
    name = lambda option: option[1].replace("-", "_")
    return re.sub(r"(?<![\w-])--(?!help)([a-z][a-z-]*)", name, re.sub(r" \(see 'limitcurve [^()]*\)", "", message))


def _stacklevel() -> int:
    """For warnings.warn in the function that asks: the first caller outside this package."""
    level = 1
    frame = sys._getframe(1)
    while frame.f_back is not None and frame.f_globals.get("__package__") == __package__:
        frame, level = frame.f_back, level + 1
    return level
