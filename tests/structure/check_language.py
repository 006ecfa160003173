#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Checks that an older language than C++20 is the first thing that a compiler complains of.

usage: check_language.py COMPILER PROJECT_FOLDER

Each public header is compiled as C++17.
"""

import subprocess
import sys
from pathlib import Path

def first_error(compiler, project, header):
    command = [compiler, "-std=c++17", "-fsyntax-only", "-I", project, "-x", "c++", "-"]
    done = subprocess.run(command, input=f'#include "{header}"\n', capture_output=True, text=True)
    return next((line for line in done.stderr.splitlines() if "error:" in line), "none")


def main():
    compiler, project = sys.argv[1], Path(sys.argv[2])
    headers = [f"hardball/{header.name}" for header in sorted(project.glob("hardball/*.hpp"))]
    faults = 0
    for header in headers:
        error = first_error(compiler, project, header)
        if "C++20" not in error:
            faults += 1
            print(f"{header}: the first error is {error}")
    return 1 if faults or len(headers) < 10 else 0


if __name__ == "__main__":
    sys.exit(main())
