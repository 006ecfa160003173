#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The source distribution of the Python package has what git has, so that everything can be built and tested from it, and
nothing else; and it knows its commit.

usage: sdist_test.py PROJECT_FOLDER
"""

import re
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

PROJECT = Path(sys.argv[1]).resolve()
# Large pictures, which only the pages show; settings of git and CI.
LEFT_OUT = re.compile(r"docs/figures/|\.ci/|\.git[a-z]+$")
ADDED = re.compile(r"PKG-INFO|setup\.cfg|hardball\.egg-info/.*")
SKIPPED = 77


def names_in_git():
    """The files that git has or would add; nothing without git."""
    command = ["git", "-C", PROJECT, "ls-files", "--cached", "--others", "--exclude-standard"]
    done = subprocess.run(command, capture_output=True, text=True)
    return {name for name in done.stdout.splitlines() if (PROJECT / name).is_file()} if (PROJECT / ".git").exists() else set()


def main():
    expected = {name for name in names_in_git() if not LEFT_OUT.match(name)}
    if not expected:
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-B", "setup.py", "-q", "egg_info", "--egg-base", folder, "sdist", "--dist-dir", folder]
        subprocess.run(command, cwd=PROJECT, check=True, stderr=subprocess.PIPE)
        with tarfile.open(next(Path(folder).glob("*.tar.gz"))) as archive:
            root = archive.getnames()[0].split("/")[0]
            packed = {member.name[len(root) + 1 :]: member for member in archive.getmembers() if member.isfile()}
            commit = archive.extractfile(packed["cmake/commit.cmake"]).read().decode()
    faults = [f"{name} is missing: add it to MANIFEST.in" for name in sorted(expected - packed.keys())]
    faults += [f"{name} is packed, and not in git" for name in sorted(packed.keys() - expected) if not ADDED.fullmatch(name)]
    if not re.search(r"^set\(commit [0-9a-f]{12}(-dirty)?\)$", commit, re.MULTILINE):
        faults.append("the commit is unknown")
    print(*faults, sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
