# SPDX-License-Identifier: MIT
"""The reference of the Python package, from its docstrings: plain text with `code` in them."""

import enum
import inspect
import re


def escape(app, what, name, thing, options, lines):
    """Escapes the markup of reStructuredText."""
    lines[:] = [line if line.lstrip().startswith(">>>") else re.sub(r"([|*])", r"\\\1", line) for line in lines]


def signature(app, what, name, thing, options, arguments, result):
    """Of the module's functions, which Sphinx takes for attributes, and constructors; an enumeration is not called."""
    if inspect.isclass(thing) and issubclass(thing, enum.Enum):
        return "", None
    own = getattr(thing.__init__ if inspect.isclass(thing) else thing, "__nb_signature__", None)
    if not own:
        return None
    arguments, result = re.fullmatch(r"def \w+(\(.*\)) -> (.*)", own[0][0], re.DOTALL).groups()
    arguments = re.sub(r"^\(self(, )?", "(", arguments)
    return arguments, None if inspect.isclass(thing) else result


def setup(app):
    app.connect("autodoc-process-docstring", escape)
    app.connect("autodoc-process-signature", signature)
