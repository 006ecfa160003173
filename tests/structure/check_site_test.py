#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Tests of the checks of the documentation site.

usage: check_site_test.py FOLDER

FOLDER is docs/site.
"""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, sys.argv.pop(1))
from address import with_address  # noqa: E402
from checks import faults_of_site, missing_from_reference  # noqa: E402

NAMESPACE = """<doxygen><compounddef><sectiondef>
<memberdef kind="enum" id="n_status" prot="public"><type/><qualifiedname>hard::Status</qualifiedname></memberdef>
<memberdef kind="typedef" id="n_rule" prot="public"><type>std::variant&lt; <ref refid="bounce">Bounce</ref> &gt;</type>
<qualifiedname>hard::Rule</qualifiedname></memberdef>
</sectiondef></compounddef></doxygen>"""
CLASSES = {
    "simulation": '<memberdef prot="public"><type><ref refid="n_status">Status</ref></type><param><type>const '
    '<ref refid="world">World</ref> &amp;</type></param></memberdef>'
    '<memberdef prot="private"><type><ref refid="hidden">Hidden</ref></type></memberdef>',
    "world": '<memberdef prot="public"><type><ref refid="n_rule">Rule</ref></type></memberdef>',
    "bounce": '<memberdef prot="public"><type><ref refid="far">Far</ref></type></memberdef>',
    "hidden": "",
    "far": "",
}
COMPLETE = """
.. doxygenclass:: hard::Simulation
   :members:
.. doxygenstruct:: hard::World
.. doxygenenum:: hard::Status
.. doxygentypedef:: hard::Rule
.. doxygenclass:: hard::Bounce
"""


class Site(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def faults(self, head, body=""):
        (self.folder / "page.html").write_text(f"<html><head>{head}</head><body>{body}</body></html>")
        return faults_of_site(self.folder)

    def test_a_page_may_link_to_the_network_and_need_its_own_files(self):
        style = "@import url(other.css); a { background: url(data:image/png;base64,AA) }"
        (self.folder / "style.css").write_text(style)
        (self.folder / "other.css").write_text("")
        head = '<link rel="stylesheet" href="style.css?digest=1"><link rel="canonical" href="https://a.b/">'
        self.assertEqual(self.faults(head, '<a href="https://a.b/">there</a><img src="style.css">'), [])

    def test_what_comes_from_the_network_is_found(self):
        for head in (
            '<script async src="https://cdn.jsdelivr.net/npm/mathjax@3/es5/tex-mml-chtml.js"></script>',
            '<script src="//a.b/c.js"></script>',
            '<link rel="stylesheet" href="HTTPS://a.b/c.css">',
            "<style>@import url('https://a.b/c.css');</style>",
            '<img srcset="http://a.b/c.png 2x">',
            '<p style="background: url(http://a.b/c.png)"></p>',
        ):
            self.assertEqual(len(self.faults(head)), 1, head)
        (self.folder / "style.css").write_text("@font-face { src: url(https://a.b/c.woff2) }")
        self.assertEqual(self.faults(""), ["style.css fetches https://a.b/c.woff2"])

    def test_what_is_not_there_is_found(self):
        faults = self.faults('<script src="lost.js"></script>')
        self.assertEqual(faults, ["page.html needs lost.js, which is not there"])

    def test_links_within_the_site_lead_somewhere(self):
        (self.folder / "two words.html").write_text("")
        body = '<a href="two%20words.html#top">a</a> <a href="#here">b</a> <a href="mailto:a@b.c">c</a> <a>d</a>'
        self.assertEqual(self.faults("", body), [])
        self.assertEqual(self.faults("", '<a href="lost.html#top">a</a>'), ["page.html leads to lost.html#top, which is not there"])

    def test_prose_that_is_set_as_a_formula_is_found(self):
        def formula(text):
            return f'<annotation encoding="application/x-tex">{text}</annotation>'

        fraction = r"\lim_{t\to\infty} \frac{\sin \alpha}{\text{that is all of it}}"
        for body in (fraction, "a b c", r"\alpha \beta \gamma"):
            self.assertEqual(self.faults("", formula(body)), [], body)
        faults = self.faults("", formula(" cells, as rows are released late, "))
        self.assertEqual(faults, ["page.html sets prose as a formula: cells, as rows"])


class Address(unittest.TestCase):
    def test_pages_name_it_where_it_is_known(self):
        page = "git clone ADDRESS hardball\nADDRESSES"
        self.assertEqual(with_address(page, "a.b/\\1"), "git clone a.b/\\1 hardball\nADDRESSES")
        self.assertEqual(with_address(page, ""), page)


class Reference(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "namespacehard.xml").write_text(NAMESPACE)
        compounds = "".join(
            f'<compound refid="{name}"><name>hard::{name.title()}</name></compound>' for name in CLASSES
        )
        (self.folder / "index.xml").write_text(f"<doxygenindex>{compounds}</doxygenindex>")
        for name, members in CLASSES.items():
            (self.folder / f"{name}.xml").write_text(f"<doxygen>{members}</doxygen>")

    def missing(self, reference):
        return missing_from_reference(self.folder, "hard::Simulation", reference)

    def test_a_complete_one_lists_what_signatures_name_two_steps_deep(self):
        self.assertEqual(self.missing(COMPLETE), [])

    def test_what_it_lacks_is_found(self):
        for name in ("World", "Status", "Rule", "Bounce"):
            reference = COMPLETE.replace(f":: hard::{name}\n", ":: hard::Other\n")
            self.assertEqual(self.missing(reference), [f"hard::{name}"])


if __name__ == "__main__":
    unittest.main()
