#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Tests that check_address.py finds each kind of fault."""

import tempfile
import unittest
from pathlib import Path

from check_address import check

# In parts, as this file must not name an address either.
ADDRESS = "https://" + "forge.org/hardball"


class CheckAddress(unittest.TestCase):
    def faults(self, address="", **files):
        """The faults of a project with this address, where `docs__page` stands for docs/page.md."""
        with tempfile.TemporaryDirectory() as folder:
            project = Path(folder)
            (project / "CMakeLists.txt").write_text(f'project(hardball HOMEPAGE_URL "{address}")\n')
            for name, text in files.items():
                path = project / f"{name.replace('__', '/')}.md"
                path.parent.mkdir(exist_ok=True)
                path.write_text(text)
            return list(check(project))

    def test_pages_may_say_address_and_name_others(self):
        text = "git clone ADDRESS hardball\nGIT_REPOSITORY ADDRESS\n[EDMD](https://forge.org/someone/EDMD)"
        for address in ("", ADDRESS):
            self.assertEqual(self.faults(address, README=text, docs__page=text), [])

    def test_an_address_of_the_project_is_found_whatever_its_host(self):
        for text in (ADDRESS, "ssh://" + "forge.org/hardball.git", "git@" + "forge.org:hardball/hardball.git",
                     "https://" + "hardball.forge.org/docs", "HTTPS://" + "forge.org/Hardball"):
            self.assertEqual(len(self.faults(docs__page=f"[here]({text})")), 1, text)

    def test_the_address_that_is_declared_is_found_elsewhere(self):
        self.assertEqual(len(self.faults("https://" + "spheres.org", README="at https://" + "spheres.org")), 1)

    def test_commands_that_clone_another_address_are_found(self):
        for text in ("git clone https://forge.org/spheres", "  GIT_REPOSITORY https://forge.org/spheres"):
            self.assertEqual(len(self.faults(README=text)), 1, text)

    def test_the_address_is_declared_once(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "CMakeLists.txt").write_text("project(hardball)\n")
            self.assertEqual(len(list(check(Path(folder)))), 1)


if __name__ == "__main__":
    unittest.main()
