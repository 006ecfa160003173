#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Checks that code for wider machines stays in its own object files.

usage: check_instructions.py NM OBJECT_FILE...

A function that is compiled in several files, and not inlined, is one function in the program: the linker keeps any one
of its copies. If that is the copy from a file compiled for AVX-512, other machines stop at its first instruction. So
kernels_avx2 and kernels_avx512 may define nothing for others but their table of kernels. Nor may they have objects that
are initialized when a program starts, on any machine.
"""

import re
import subprocess
import sys
from pathlib import Path

WIDE = re.compile(r"kernels_(avx\w+)\.cpp")
TABLE = re.compile(r"hardball::k(Avx\w+)Kernels")


def defined_for_others(nm, file):
    """The names that a file defines and other files may use."""
    lines = subprocess.run([nm, "--defined-only", "--extern-only", "--demangle", file], capture_output=True, text=True,
                           check=True).stdout.splitlines()
    return [line.split(maxsplit=2)[2] for line in lines if line.strip()]


def has_initializers(nm, file):
    lines = subprocess.run([nm, "--defined-only", file], capture_output=True, text=True, check=True).stdout
    return "_GLOBAL__sub_I" in lines


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    nm, *objects = sys.argv[1:]
    wide = [file for file in objects if WIDE.search(Path(file).name)]
    if not wide:
        sys.exit("there is no object file of kernels for wider machines among those given")
    faults = []
    for file in wide:
        names = defined_for_others(nm, file)
        faults += [f"{file} defines {name}" for name in names if not TABLE.fullmatch(name)]
        if not any(TABLE.fullmatch(name) for name in names):
            faults.append(f"{file} has no table of kernels")
        if has_initializers(nm, file):
            faults.append(f"{file} initializes objects when a program starts")
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
