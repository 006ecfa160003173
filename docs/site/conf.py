# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The documentation site, from the folder that build_site.py has put together."""

import json
import shutil
import subprocess
from pathlib import Path

from docutils import nodes
from sphinx.errors import ExtensionError

# Of Debian's libjs-katex.
KATEX = Path("/usr/share/javascript/katex")

project = "Hardball"
copyright = "2026 The Hardball authors"
extensions = ["myst_parser", "sphinx.ext.autodoc", "breathe"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
html_theme = "furo"
html_title = "Hardball"
html_static_path = ["_static"]
# Pages that are complete as they are: replays, and the playground.
html_extra_path = ["extra"]
exclude_patterns = ["extra"]
html_css_files = ["katex/katex.min.css", "site.css"]
html_math_renderer = "katex"
breathe_projects = {"hardball": "doxygen/xml"}
breathe_default_project = "hardball"
autodoc_member_order = "bysource"
autodoc_typehints = "none"
autoclass_content = "both"
default_role = "code"


def with_public_names(app, what, name, entity, options, signature, returned):
    """Signatures as users write them: classes by their public names, and without self."""

    def public(text):
        return text and text.replace("hardball._hardball.", "hardball.").replace("(self: hardball.Simulation, ", "(")

    return public(signature), public(returned)


class Katex:
    """Sets formulas while the site is built, so that its pages need no script for them."""

    def __init__(self):
        node = shutil.which("node") or shutil.which("nodejs")
        command = [node, Path(__file__).parent / "katex.js", KATEX / "katex.min.js"]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def markup(self, formula, is_displayed):
        self.process.stdin.write(json.dumps([formula, is_displayed]) + "\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        if "error" in answer:
            raise ExtensionError(f"{formula}: {answer['error']}")
        return answer["html"]


def setup(app):
    app.connect("autodoc-process-signature", with_public_names)
    katex = Katex()

    def visit_math(self, node):
        self.body.append(katex.markup(node.astext(), False))
        raise nodes.SkipNode

    def visit_math_block(self, node):
        self.body.append(f"<div>{katex.markup(node.astext(), True)}</div>")
        raise nodes.SkipNode

    app.add_html_math_renderer("katex", (visit_math, None), (visit_math_block, None))
