# SPDX-License-Identifier: MIT
"""Converts formulas to MathML when the site is built: no script, no font to load."""

from docutils import nodes
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.util import logging

logger = logging.getLogger(__name__)


def formula(translator, node, inline):
    """A formula that docutils cannot read is an error with its place."""
    try:
        translator.body.append(tex2mathml(node.astext(), as_block=not inline))
    except SyntaxError as error:
        logger.warning("formula '%s': %s", node.astext(), error, location=node)
    raise nodes.SkipNode


def setup(app):
    app.add_html_math_renderer("mathml", (lambda self, node: formula(self, node, True), None),
                               (lambda self, node: formula(self, node, False), None))
