# SPDX-License-Identifier: MIT
"""What Debian's furo 2022.12 lacks, put into its files in the site: a page must work from disk, and be dark where its reader's system is."""

import re
from pathlib import Path


def part(pattern, text):
    """The one place of the theme's file that is mended: another furo may not need it, and then this file goes."""
    found = re.search(pattern, text, re.DOTALL | re.MULTILINE)
    if not found:
        raise ValueError(f"docs/site/theme.py: furo has no '{pattern}' any more")
    return found


def mend_styles(path):
    """A style sheet that is imported from the root of a server becomes part of it; colours of the dark theme hold on dark systems, too."""
    text = path.read_text(encoding="utf-8")
    imported = part(r"@import url\((/javascript/[^)]*)\);", text)
    text = text.replace(imported[0], Path("/usr/share" + imported[1]).read_text(encoding="utf-8"))
    dark = part(r'^  body\[data-theme="dark"\] (\{.*?\})', text)
    text = text.replace(dark[0], f'{dark[0]}\n  @media (prefers-color-scheme: dark) {{ body:not([data-theme="light"]) {dark[1]} }}')
    path.write_text(text, encoding="utf-8")


def mend_script(path):
    """A script that is imported as a module, which browsers refuse from disk, becomes part of it."""
    text = path.read_text(encoding="utf-8")
    imported = part(r'^import Gumshoe from "\./(.*?)";', text)
    path.write_text(text.replace(imported[0], (path.parent / imported[1]).read_text(encoding="utf-8")), encoding="utf-8")


def mend(app, exception):
    if not exception:
        static = Path(app.outdir) / "_static"
        mend_styles(static / "styles" / "furo.css")
        mend_script(static / "scripts" / "furo.js")


def setup(app):
    app.connect("build-finished", mend)
