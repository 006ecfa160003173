# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The documentation site, from the folder that build_site.py has put together."""

project = "Hardball"
copyright = "2026 The Hardball authors"
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.mathjax", "breathe"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
html_theme = "furo"
html_title = "Hardball"
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


def setup(app):
    app.connect("autodoc-process-signature", with_public_names)
