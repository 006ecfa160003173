#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Checks that the C++ shown on a page is taken from the examples, indentation aside.

usage: check_snippets.py PAGE EXAMPLES_FOLDER
"""

import re
import sys
from pathlib import Path


def normal(code):
    return "\n".join(line.strip() for line in code.strip().splitlines())


def main():
    page, folder = Path(sys.argv[1]), Path(sys.argv[2])
    examples = [normal(file.read_text()) for file in sorted(folder.glob("*.cpp"))]
    snippets = re.findall(r"^```cpp\n(.*?)^```", page.read_text(), re.DOTALL | re.MULTILINE)
    strange = [snippet for snippet in snippets if not any(normal(snippet) in example for example in examples)]
    for snippet in strange:
        print(f"{page}: not in the examples:\n{snippet}")
    return 1 if strange or not snippets else 0


if __name__ == "__main__":
    sys.exit(main())
