#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Tests that check_floors.py finds each kind of fault."""

import tempfile
import unittest
from pathlib import Path

from check_floors import check

TABLE = """
# room floor hot uses
cellar  0
hall    1 hot cellar
parlour 1
attic   2  cellar hall
"""

HOUSE = {
    "floors.txt": TABLE,
    "hardball.hpp": '#include "hardball/view.hpp"\n',
    "view.hpp": '#include "hardball/attic/attic.hpp"\n',
    "cellar/cellar.hpp": "#include <vector>\n",
    "cellar/cellar.cpp": '#include "hardball/cellar/cellar.hpp"\n#include <toml++/toml.h>\n',
    "hall/hall.hpp": '#include "hardball/cellar/cellar.hpp"\n',
    "parlour/parlour.hpp": "#include <cmath>\n",
    "attic/attic.hpp": '#include "hardball/hall/hall.hpp"\n#include "hardball/cellar/cellar.hpp"\n',
}


class CheckFloors(unittest.TestCase):
    def faults(self, **changes):
        """The faults of the sample rooms with some files replaced, where `room__file` stands for room/file.hpp, and
        `file_cpp` for file.cpp."""
        files = dict(HOUSE)
        for name, text in changes.items():
            file = name.replace("__", "/")
            file = file[:-4] + ".cpp" if file.endswith("_cpp") else file + ".hpp"
            files["floors.txt" if name == "table" else file] = text
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = Path(folder, "hardball", name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return check(Path(folder))

    def expect(self, message, **changes):
        faults = self.faults(**changes)
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(message, faults[0])

    def test_a_sound_house_has_no_faults(self):
        self.assertEqual(self.faults(), [])

    def test_higher_floor(self):
        self.expect("parlour.hpp:2: 'parlour' on floor 1 includes 'attic' on floor 2",
                    parlour__parlour='\n#include "hardball/attic/attic.hpp"\n')

    def test_same_floor(self):
        self.expect("'parlour' on floor 1 includes 'hall' on floor 1",
                    parlour__parlour='#  include "hardball/hall/hall.hpp"')

    def test_undeclared_room(self):
        self.expect("'parlour' includes 'cellar' without declaring it",
                    parlour__parlour='#include "hardball/cellar/cellar.hpp"')

    def test_room_declared_in_vain(self):
        self.expect("'hall' declares 'cellar' but includes nothing of it",
                    hall__hall='/* #include "hardball/cellar/cellar.hpp"\n*/ // #include "hardball/attic/attic.hpp"')

    def test_relative_path(self):
        self.expect("is not the full path", hall__stairs='#include "hall.hpp"')

    def test_missing_file(self):
        self.expect("is not the full path", hall__stairs='#include "hardball/hall/lift.hpp"')

    def test_header_for_users(self):
        self.expect("is for users", hall__stairs='#include "hardball/view.hpp"')

    def test_package_in_a_header(self):
        self.expect("would be needed by every user", hall__stairs="#include <toml++/toml.h>")

    def test_unknown_room(self):
        self.expect("room 'shed' is missing", shed__shed="")

    def test_file_outside_the_rooms(self):
        self.expect("outside the rooms", doormat_cpp="")

    def test_table_with_a_leak(self):
        self.expect("'garden' on floor 1 uses 'hall' on floor 1", table=TABLE + "garden 1 hall")

    def test_table_with_an_unknown_room(self):
        self.expect("uses 'moat', which is not listed above it", table=TABLE + "garden 1 moat")

    def test_table_with_a_room_twice(self):
        self.expect("'parlour' is listed twice", table=TABLE + "parlour 1")

    def test_table_without_a_floor(self):
        self.expect("expected: room, floor", table=TABLE + "garden")


if __name__ == "__main__":
    unittest.main()
