# SPDX-License-Identifier: MIT
"""The site (scripts/maintain/site). Its sources are the repository's Markdown files where they stand, so that every
fact has one place; the pages in docs/ come to lie at the top of the site. Formulas become MathML when the site is
built: a page loads nothing but its own files."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "docs" / "site"))

from repository import FILES  # noqa: E402  (it lies beside this file)

project = "limitcurve"
version = release = re.search(r'version = "(.*)"', (ROOT / "limitcurve" / "version.hpp").read_text(encoding="utf-8"))[1]
root_doc = "index"
include_patterns = [
    *sorted(name for name in FILES if name.endswith(".md") and not name.startswith(".")), "build/reference/*.md"
]
# Sphinx follows links, and in build/wine the z: is the whole machine.
exclude_patterns = ["out", *(f"build/{path.name}" for path in (ROOT / "build").iterdir() if path.name != "reference")]
extensions = [
    "myst_parser", "breathe", "sphinx.ext.autodoc", "sphinx_copybutton", "docstrings", "headers", "repository",
    "formulas"
]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
breathe_projects = {"limitcurve": str(ROOT / "build" / "doxygen" / "xml")}
breathe_default_project = "limitcurve"
breathe_domain_by_extension = {"h": "c", "hpp": "cpp"}
default_role = "code"
autodoc_member_order = "bysource"
# the new one drops a signature that docstrings.py gives where it found none itself
autodoc_use_legacy_class_based = True

html_theme = "furo"
# Styles of Pygments whose every colour has a contrast of 4.5; code stands on a ground of its own.
pygments_style = "xcode"
pygments_dark_style = "github-dark"
html_theme_options = {"light_css_variables": {"color-code-background": "#f6f8fa"}}
html_static_path = ["site/static"]
html_css_files = ["site.css"]
html_title = "limitcurve"
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
html_show_search_summary = False  # it would fetch every page that was found
html_math_renderer = "mathml"
