# SPDX-License-Identifier: MIT
"""The doors: the command, Python, and C from its header. Each answers in plain numbers, or raises Refused."""
import csv
import io
import os
import re
import subprocess
import tempfile
import warnings
from pathlib import Path

import cffi
import limitcurve as lc
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("LIMITCURVE_BUILD", ROOT / "build/ci"))
SOURCE = ROOT if BUILD.is_relative_to(ROOT) else BUILD / "../.."
HEADER = "".join((SOURCE / "c" / name).read_text() for name in ("limitcurve.h", "limitcurve_fit.h"))
FOLDER = tempfile.TemporaryDirectory()
FFI = cffi.FFI()
_declared = re.sub(r"#include.*|(#define LIMITCURVE_API).*", r"\1", HEADER)
FFI.cdef(subprocess.run(["cc", "-E", "-P", "-"], input=_declared, text=True, check=True, capture_output=True).stdout)
C = FFI.dlopen(str(BUILD / "c/liblimitcurve-c-fit.so"))  # which loads liblimitcurve-c.so


class Refused(Exception):
    pass


def command(*words, **files):
    """(columns, messages) of a command; NAME=text writes the file NAME.csv into its folder."""
    for name, text in files.items():
        Path(FOLDER.name, name + ".csv").write_text(text, newline="")
    done = subprocess.run([BUILD / "cli/limitcurve", *map(str, words)], capture_output=True, text=True, cwd=FOLDER.name,
                          timeout=120, check=False)
    if done.returncode != 0:
        raise Refused(done.stderr.strip() or f"exit {done.returncode}, no message")
    rows = list(csv.reader(io.StringIO(done.stdout)))
    def column(cells):
        try:
            return np.array([float(cell or "nan") for cell in cells])
        except ValueError:
            return list(cells)
    return {name: column(cells) for name, cells in zip(rows[0], zip(*rows[1:]))}, done.stderr


def python(call, *arguments, **options):
    """(result, messages) of a call."""
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        try:
            return call(*arguments, **options), "\n".join(str(one.message) for one in said)
        except (ValueError, RuntimeError, TypeError) as error:
            raise Refused(str(error)) from None


def refuses(call, *arguments, **options):
    try:
        call(*arguments, **options)
        return False
    except Refused:
        return True


def plain(value):
    if isinstance(value, np.ndarray):
        return FFI.from_buffer("double[]", value)
    return FFI.NULL if value is None else value.encode() if isinstance(value, str) else value


def c(name, *arguments):
    """limitcurve_NAME(arguments): text, numbers and arrays of doubles as they are."""
    if getattr(C, "limitcurve_" + name)(*map(plain, arguments)) != 0:
        raise Refused(FFI.string(C.limitcurve_error()).decode())


def made(kind, name, *arguments):
    """The object that limitcurve_NAME makes, freed with the last reference to it."""
    pointer = FFI.new(f"limitcurve_{kind}**")
    c(name, *arguments, pointer)
    return FFI.gc(pointer[0], getattr(C, f"limitcurve_{kind}_free"))


def new(kind, **values):
    """A struct; `finger_parameters` begin with their defaults. Keep what it returns second as long as the struct."""
    begin = [C.limitcurve_finger_defaults()] if kind == "finger_parameters" else []
    struct, keep = FFI.new(f"limitcurve_{kind}*", *begin), []
    for name, value in values.items():
        keep.append(FFI.new("char[]", value.encode()) if isinstance(value, str) else value)
        setattr(struct, name, list(value) if isinstance(value, (tuple, np.ndarray)) else keep[-1])
    return struct, keep


def c_law(text):
    return made("law", "law_parse", text)


def c_table(text, tolerance=1e-12):
    return made("table", "table_build", c_law(text), tolerance)


def estimates(fit):
    """Values and standard errors of a fit in C."""
    found = np.zeros((C.limitcurve_fit_count(fit), 2))
    for index, row in enumerate(found):
        c("fit_estimate", fit, index, None, row[:1], row[1:], None)
    return found


def names():
    """What can be asked: options of every help page, arguments of the Python module's stubs, functions in C."""
    helped = lambda *words: subprocess.run([BUILD / "cli/limitcurve", *words, "--help"], capture_output=True, text=True,
                                           check=False).stdout
    options = {option for name in re.findall(r"^  ([a-z][a-z-]*)  ", helped(), re.M)
               for line in helped(name).splitlines() if line.startswith("  -")
               for option in re.findall(r"--[a-z][a-z-]*", line.split("  ")[1])}
    stubs = (Path(lc.__file__).parent / "_core.pyi").read_text()
    arguments = {argument for given in re.findall(r"def (?!_)\w+\(([^)]*)\)", stubs)
                 for argument in re.findall(r"(?:^|, )\*?(\w+):", given)} - {"self", "arg"}
    return {"option": options, "argument": arguments, "function": set(re.findall(r"\blimitcurve_(\w+)\(", HEADER))}
