# SPDX-License-Identifier: MIT
"""The pages of declarations, build/reference/: of the headers that docs/reference.md lists, from Doxygen's XML, and of
the Python package.

`{header} limitcurve/law.hpp` is what a public header declares: first its words on the whole, then its declarations.
"""

import importlib.util
import re
from pathlib import Path

from breathe.directives.file import DoxygenFileDirective
from breathe.renderer.sphinxrenderer import SphinxRenderer
from docutils import nodes
from docutils.parsers.rst.directives import flag
from docutils.statemachine import StringList

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "build" / "reference"
WORDS = re.compile(r"((?:^///.*\n)+)^namespace ", re.MULTILINE)
MODULES = {"limitcurve": ("C++: limitcurve", "limitcurve"), "godobject": ("C++: godobject", "godobject"),
           "fit": ("C++: fit", "fit"), "c": ("C", "c")}
PYTHON = """# Python

In words: [limitcurve for Python](../../python/README.md). All units are SI.

```{eval-rst}
.. automodule:: limitcurve
   :members:
   :imported-members:

.. automodule:: limitcurve.plot
   :members:
```
"""
NO_PYTHON = ("# Python\n\nThis copy of the site was built where the Python package was not: its reference is missing. "
             "`scripts/maintain/site` says why.\n")


class Header(DoxygenFileDirective):
    option_spec = {**DoxygenFileDirective.option_spec, "content-only": flag}

    def run(self):
        self.options["content-only"] = None
        words = WORDS.search((ROOT / self.arguments[0]).read_text(encoding="utf-8"))
        about = nodes.container()
        if words:
            text = re.sub(r"^/// ?", "", words[1], flags=re.MULTILINE)
            self.state.nested_parse(StringList(text.splitlines(), self.arguments[0]), 0, about)
        self.arguments[0] = Path(self.arguments[0]).name  # Doxygen's index has names without folders
        return [about, *super().run()]


def declarations_of_a_namespace(renderer, node):
    """The members of a namespace without its own description: Doxygen joins those of all headers, and Breathe repeats
    them in each."""
    data = renderer.parse_compound(node.refid)
    definition = data.compounddef[0]
    definition.briefdescription = definition.detaileddescription = None
    return renderer.render(definition, renderer.context.create_child_context(data).create_child_context(definition))


def write_pages():
    listed = re.findall(r"^\| \[`([\w/]+\.h(?:pp)?)`\]", (ROOT / "docs" / "reference.md").read_text(encoding="utf-8"),
                        re.MULTILINE)
    FOLDER.mkdir(parents=True, exist_ok=True)
    for name, (title, folder) in MODULES.items():
        mine = [
            header for header in listed
            if max((path for _, path in MODULES.values() if header.startswith(f"{path}/")), key=len) == folder
        ]
        parts = [
            f"# {title}",
            f"In words: [{folder}](../../{folder}/README.md). All headers: [reference](../../docs/reference.md)."
        ]
        parts += [f"## `{header}`\n\n```{{header}} {header}\n```" for header in mine]
        (FOLDER / f"{name}.md").write_text("\n\n".join(parts) + "\n", encoding="utf-8")
    found = importlib.util.find_spec(
        "limitcurve")  # the folder of this name in the repository is no package, and has no origin
    (FOLDER / "python.md").write_text(PYTHON if found and found.origin else NO_PYTHON, encoding="utf-8")


def setup(app):
    write_pages()
    SphinxRenderer.visit_namespace = declarations_of_a_namespace
    app.add_directive("header", Header)
