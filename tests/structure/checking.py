# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""What the checks of the sources share."""

import sys
from pathlib import Path

# What is built, and what this machine has fetched.
SKIPPED = {".git", "build", "node_modules", "__pycache__"}


def files_of(folder):
    """All files of the project below a folder."""
    for path in sorted(folder.iterdir()):
        if path.name in SKIPPED or path.is_symlink():
            continue
        if path.is_dir():
            yield from files_of(path)
        elif path.is_file():
            yield path


def print_faults(check):
    """Prints the faults that `check` finds in the project folder, the only argument; fails if there are any."""
    faults = list(check(Path(sys.argv[1])))
    print(*faults, sep="\n")
    sys.exit(1 if faults else 0)
