#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Checks the public headers, hardball/*.hpp, and that what users see includes no others.

usage: check_face.py PROJECT_FOLDER

Each public header says in a comment what it is for, and hardball.hpp includes them all. By each but version.hpp the
source that includes it has the library check how it was compiled. Examples, pages and the
projects in tests/structure include no headers of rooms.
"""

import re

from checking import print_faults

INCLUDE = re.compile(r'^#include [<"](hardball/[^>"]+)[>"]', re.MULTILINE)
OF_USERS = ["README.md", "docs/*.md", "examples/*.cpp", "examples/fetch_content/*.cpp", "tests/structure/*/*.cpp"]


CHECK = "hardball/errors/compilation.hpp"


def reached(project, header):
    """The headers of the library that one includes, directly or not, with itself."""
    found, left = set(), [header]
    while left:
        if (header := left.pop()) not in found:
            found.add(header)
            left += INCLUDE.findall((project / header).read_text())
    return found


def check(project):
    """All faults, one line of text each."""
    public = {f"hardball/{file.name}": file.read_text() for file in (project / "hardball").glob("*.hpp")}
    umbrella = "hardball/hardball.hpp"
    for header, text in public.items():
        if "\n/// " not in text:
            yield f"{header}: no comment says what it is for"
        if header != umbrella and header not in INCLUDE.findall(public[umbrella]):
            yield f"{umbrella}: does not include {header}"
        if header != "hardball/version.hpp" and CHECK not in reached(project, header):
            yield f"{header}: does not include {CHECK}"
    for file in sorted(file for pattern in OF_USERS for file in project.glob(pattern)):
        for header in INCLUDE.findall(file.read_text()):
            if header not in public:
                yield f"{file}: includes {header}, which is no public header"


if __name__ == "__main__":
    print_faults(check)
