# SPDX-License-Identifier: MIT
"""The site's pages are the repository's Markdown files: this module gives their names and adapts their links."""

import posixpath
import re
import subprocess
from pathlib import Path

import sphinx.application
from sphinx.project import Project

ROOT = Path(__file__).resolve().parents[2]
FILES = set(subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split())
LINK = re.compile(r"(?<!!)\[((?:[^][]|\[[^]]*\])*)\]\(([^)#:\s]+)(#[^)\s]*)?\)")


class PagesAtTheTop(Project):
    """docs/drive.md is the page drive.html, fit/README.md is fit/README.html."""

    def path2doc(self, filename):
        name = super().path2doc(filename)
        return name and name.removeprefix("docs/")

    def doc2path(self, docname, basedir=True):
        below = f"docs/{docname}"
        return super().doc2path(below if f"{below}.md" in FILES else docname, basedir)


def page_of(path):
    """The page name of a file or folder of the repository, or None."""
    for name in (path, posixpath.join(path, "README.md")):
        if name in FILES and name.endswith(".md"):
            return name.removeprefix("docs/").removesuffix(".md")
    return None


def resolve_links(app, docname, source):
    """Adapts links: a link to a file or folder with a page becomes a link to the page; a link to another folder is removed."""
    folder = posixpath.dirname(posixpath.relpath(app.project.doc2path(docname), ROOT))

    def resolved(match):
        text, target, anchor = match[1], match[2], match[3] or ""
        path = posixpath.normpath(posixpath.join(folder, target))
        page = page_of(path)
        if page:  # a heading is known by its file, a page by its name
            name = (path if path.endswith(".md") else posixpath.join(path, "README.md")) if anchor else f"{page}.md"
            return f"[{text}]({posixpath.relpath(name, posixpath.dirname(docname) or '.')}{anchor})"
        return text if (ROOT / path).is_dir() else match[0]  # a file is offered as it is

    source[0] = LINK.sub(resolved, source[0])


def setup(app):
    sphinx.application.Project = PagesAtTheTop
    app.connect("source-read", resolve_links)
