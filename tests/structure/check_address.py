#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Checks that the address of the project is in CMakeLists.txt alone, and that pages with commands that need it say
ADDRESS.

usage: check_address.py PROJECT_FOLDER

An address of the project is one in which its name occurs, on whatever host, or the one that CMakeLists.txt names.
"""

import re
import sys
from pathlib import Path

SOURCE = "CMakeLists.txt"
DECLARATION = re.compile(r'HOMEPAGE_URL "([^"]*)"')
OF_PROJECT = re.compile(r"(?:(?:https?|ssh|git)://|git@)[^\s\"'<>()`]*hardball[^\s\"'<>()`]*", re.IGNORECASE)
CLONE = re.compile(r"(?:git clone|GIT_REPOSITORY) (\S+)")
# What is built, and what this machine has fetched.
SKIPPED = {".git", "build", "node_modules", "__pycache__"}


def files_of(project):
    for path in sorted(project.iterdir()):
        if path.name in SKIPPED or path.is_symlink():
            continue
        if path.is_dir():
            yield from files_of(path)
        elif path.is_file():
            yield path


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


def main():
    faults = list(check(Path(sys.argv[1])))
    print(*faults, sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
