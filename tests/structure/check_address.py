#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Checks that the address of the project is in CMakeLists.txt alone, and that pages with commands that need it say
ADDRESS.

usage: check_address.py PROJECT_FOLDER

An address of the project is one in which its name occurs, on whatever host, or the one that CMakeLists.txt names.
"""

import re

from checking import files_of, print_faults

SOURCE = "CMakeLists.txt"
DECLARATION = re.compile(r'HOMEPAGE_URL "([^"]*)"')
OF_PROJECT = re.compile(r"(?:(?:https?|ssh|git)://|git@)[^\s\"'<>()`]*hardball[^\s\"'<>()`]*", re.IGNORECASE)
CLONE = re.compile(r"(?:git clone|GIT_REPOSITORY) (\S+)")


def check(project):
    """All faults, one line of text each."""
    declared = DECLARATION.findall((project / SOURCE).read_text())
    if len(declared) != 1:
        yield f"{SOURCE}: declares the address {len(declared)} times"
        return
    for file in files_of(project):
        name = file.relative_to(project)
        text = file.read_text(errors="ignore")
        if str(name) != SOURCE:
            found = set(OF_PROJECT.findall(text))
            if declared[0] and declared[0] in text:
                found.add(declared[0])
            for address in sorted(found):
                yield f"{name}: names {address}, which belongs in {SOURCE} alone; pages write ADDRESS"
        if file.suffix == ".md":
            for address in CLONE.findall(text):
                if address != "ADDRESS":
                    yield f"{name}: clones {address}; write ADDRESS, which the site replaces"


if __name__ == "__main__":
    print_faults(check)
