# SPDX-License-Identifier: MIT
"""`{header} limitcurve/law.hpp`: what a public header declares. First its words on the whole, then its declarations from Doxygen's XML."""

import re
from pathlib import Path

from breathe.directives.file import DoxygenFileDirective
from breathe.renderer.sphinxrenderer import SphinxRenderer
from docutils import nodes
from docutils.parsers.rst.directives import flag
from docutils.statemachine import StringList

ROOT = Path(__file__).resolve().parents[2]
WORDS = re.compile(r"((?:^///.*\n)+)^namespace ", re.MULTILINE)


class Header(DoxygenFileDirective):
    option_spec = {**DoxygenFileDirective.option_spec, "content-only": flag}

    def run(self):
        self.options["content-only"] = None
        words = WORDS.search((ROOT / self.arguments[0]).read_text(encoding="utf-8"))
        about = nodes.container()
        if words:
            text = re.sub(r"^/// ?", "", words[1], flags=re.MULTILINE)
            self.state.nested_parse(StringList(text.splitlines(), self.arguments[0]), 0, about)
        return [about, *super().run()]


def declarations_of_a_namespace(renderer, node):
    """Removes the namespace descriptions: Doxygen joins those of all headers, and Breathe repeats them in each."""
    file_data = renderer.compound_parser.parse(node.refid)
    file_data.compounddef.briefdescription = file_data.compounddef.detaileddescription = None
    return renderer.render(file_data, renderer.context.create_child_context(file_data))


def setup(app):
    SphinxRenderer.visit_namespace = declarations_of_a_namespace
    app.add_directive("header", Header)
