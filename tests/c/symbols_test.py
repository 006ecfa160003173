#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Checks that the shared library of the C API shows the functions of its header and nothing else, and that a test in C
calls each of them.

usage: symbols_test.py NM LIBRARY PROJECT_FOLDER
"""

import re
import subprocess
import sys
from pathlib import Path


def main():
    nm, library, project = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    declared = set(re.findall(r"^HB_API\b[^;(]*\b(hb_\w+)\(", (project / "c/hardball.h").read_text(), re.MULTILINE))
    lines = subprocess.run([nm, "--dynamic", "--defined-only", library], capture_output=True, text=True, check=True)
    shown = {line.split()[-1] for line in lines.stdout.splitlines()}
    tests = "".join(file.read_text() for file in (project / "tests/c").glob("*_test.c"))
    faults = [f"{name} is shown, and is no function of the header" for name in sorted(shown - declared)]
    faults += [f"{name} is missing from the library" for name in sorted(declared - shown)]
    faults += [f"no test calls {name}" for name in sorted(declared) if not re.search(rf"\b{name}\(", tests)]
    print(*faults, sep="\n")
    return 1 if faults or len(declared) < 40 else 0


if __name__ == "__main__":
    sys.exit(main())
