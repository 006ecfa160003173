#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Compares the binary interface that the header of the C API describes with hardball-1.abi, that of HB_ABI 1.

usage: abi_test.py COMPILER PROJECT_FOLDER [--update]

The functions of the header are compiled without their contents, as the types of C++ are no part of the interface.
Needs abidw and abidiff of the Debian package abigail-tools. A difference that breaks programs takes a new HB_ABI, and
a file of its own; one that does not, such as a new function or a struct that grows at its end, takes --update, which
writes the file anew.
"""

import platform
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
PLAIN = ["--no-corpus-path", "--no-comp-dir-path", "--no-show-locs", "--no-elf-needed", "--type-id-style", "hash"]


def compile_functions(compiler, header, folder):
    """A shared library with the functions of the header, and with debug information."""
    functions = re.findall(r"^HB_API (.*?\));", header.read_text(), re.MULTILINE | re.DOTALL)
    source = Path(folder) / "functions.c"
    source.write_text(f'#include "{header.name}"\n' + "\n".join(f"{function} {{ for (;;) {{ }} }}" for function in functions))
    command = [compiler, "-std=c99", "-g", "-O0", "-fPIC", "-shared", "-I", header.parent, source.name, "-o", "functions.so"]
    subprocess.run(command, check=True, cwd=folder)
    return Path(folder) / "functions.so"


def main():
    compiler, project = sys.argv[1], Path(sys.argv[2])
    if not shutil.which("abidiff") or platform.machine() != "x86_64":
        print("skipped: there is no abidiff (package abigail-tools), or this machine is not that of the file")
        return SKIPPED
    header = project / "c/hardball.h"
    abi = re.search(r"^#define HB_ABI (\d+)", header.read_text(), re.MULTILINE)[1]
    expected = project / f"tests/c/hardball-{abi}.abi"
    with tempfile.TemporaryDirectory() as folder:
        library = compile_functions(compiler, header, folder)
        if sys.argv[3:] == ["--update"]:
            return subprocess.run(["abidw", *PLAIN, "--out-file", expected, library], check=False).returncode
        return subprocess.run(["abidiff", expected, library], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
