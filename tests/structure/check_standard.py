#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Checks that the library and its C API use nothing of the standard library that older ones lack.

usage: check_standard.py PROJECT_FOLDER

The room "standard" has stand-ins under the names that this test refuses elsewhere. The library of Emscripten 3.1, by which
the module of WebAssembly is built, lacks them, as others of 2021 do.
"""

import re

from checking import print_faults

STAND_INS = {
    r"std::ranges::": "ranges:: of standard/ranges.hpp",
    r"<ranges>|std::views": "a loop, or ranges:: of standard/ranges.hpp",
    r"std::bit_cast": "bit_cast of standard/bit_cast.hpp",
    r"std::(from|to)_chars(?=\()": "from_chars or to_chars of standard/number_text.hpp",
    r"std::jthread": "share_work of standard/share_work.hpp",
    r"std::make_unique_for_overwrite": "new",
    r"std::format\b|<format>": "to_text, and + of strings",
}


def check(project):
    """All faults, one line of text each."""
    faults = []
    sources = [file for room in ("hardball", "c") for file in sorted((project / room).rglob("*.[ch]pp"))]
    for file in sources:
        if file.parent.name == "standard":
            continue
        for number, line in enumerate(file.read_text().splitlines(), start=1):
            for pattern, stand_in in STAND_INS.items():
                if found := re.search(pattern, line.partition("//")[0]):
                    faults.append(f"{file}:{number}: {found[0]} is missing from older libraries; use {stand_in}")
    return faults


if __name__ == "__main__":
    print_faults(check)
