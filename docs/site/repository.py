# SPDX-License-Identifier: MIT
"""The site's pages are the repository's Markdown files, its first page README.md: this module gives their names, adapts
links to folders, and puts the sidebar (sidebar.txt) under the first page."""

import posixpath
import re
import subprocess
from pathlib import Path

import sphinx.application
from sphinx.project import Project

ROOT = Path(__file__).resolve().parents[2]
FILES = set(
    subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"],
                   cwd=ROOT,
                   capture_output=True,
                   text=True,
                   check=True).stdout.split())
LINK = re.compile(r"(?<!!)\[((?:[^][]|\[[^]]*\])*)\]\(([^)#:\s]+)(#[^)\s]*)?\)")


class PagesAtTheTop(Project):
    """README.md is index.html, docs/drive.md drive.html, fit/README.md fit/README.html, build/reference/c.md
    (headers.py) reference/c.html."""

    def path2doc(self, filename):
        name = super().path2doc(filename)
        return name and ("index" if name == "README" else re.sub(r"^(docs|build)/", "", name))


def resolve_links(app, docname, source):
    """A link to a folder leads to its README.md; a folder without one has no page."""
    folder = posixpath.dirname(posixpath.relpath(app.project.doc2path(docname, True), ROOT))

    def resolved(match):
        text, target, anchor = match[1], match[2], match[3] or ""
        path = posixpath.normpath(posixpath.join(folder, target))
        if not (ROOT / path).is_dir():
            return match[0]
        return f"[{text}]({target}/README.md{anchor})" if f"{path}/README.md" in FILES else text

    if docname == "index":
        source[0] = source[0].replace("[Playground](docs/playground)", '<a href="playground/index.html">Playground</a>')
        source[0] += "\n" + (ROOT / "docs" / "site" / "sidebar.txt").read_text(encoding="utf-8")
    source[0] = LINK.sub(resolved, source[0])


def setup(app):
    sphinx.application.Project = PagesAtTheTop
    app.connect("source-read", resolve_links)
