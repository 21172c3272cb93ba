# SPDX-License-Identifier: MIT
"""The reference of the Python package, from its docstrings: plain text with `code` in them."""

import importlib.util
import re


def escape(app, what, name, thing, options, lines):
    """Escapes the markup of reStructuredText."""
    lines[:] = [line if line.lstrip().startswith(">>>") else re.sub(r"([|*])", r"\\\1", line) for line in lines]


def without_package(app, docname, source):
    if docname != "reference/python":
        return
    found = importlib.util.find_spec("limitcurve")  # the folder of this name in the repository is no package, and has no origin
    if found is None or found.origin is None:
        source[0] = "# Python\n\nThis copy of the site was built where the Python package was not: its reference is missing. `scripts/maintain/site` says why.\n"


def setup(app):
    app.connect("autodoc-process-docstring", escape)
    app.connect("source-read", without_package)
