#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Checks that the C++, C and CMake shown on the pages is taken from programs that are built: the examples, the tests of
the C API and the projects of tests/structure, indentation and the names of targets and folders aside.

usage: check_snippets.py PROJECT_FOLDER
"""

import re
import sys
from pathlib import Path


LANGUAGES = {
    "cpp": ["examples/*.cpp"],
    "c": ["examples/*.c", "tests/c/*.c"],
    "cmake": ["tests/structure/*/CMakeLists.txt", "examples/*/CMakeLists.txt"],
}


def normal(code):
    code = re.sub(r"find_package\(hardball [\d.]+ ", "find_package(hardball ", code)
    code = re.sub(r"(\$\{CMAKE_CURRENT_SOURCE_DIR\}/)?(third_party/hardball|\.\./\.\.)|\$\{HARDBALL_SOURCE\}( hardball)?", "SOURCE", code)
    code = code.replace("GIT_REPOSITORY ADDRESS GIT_TAG main", "SOURCE_DIR SOURCE")
    code = re.sub(r"target_link_libraries\(\w+", "target_link_libraries(program", code)
    return [line.strip() for line in code.splitlines() if line.strip()]


def contains(program, snippet):
    """Whether the lines of the snippet follow each other in the program; CMake's may have others in between."""
    if any(line.startswith("target_link_libraries") for line in snippet):
        return all(line in program for line in snippet)
    return any(program[k : k + len(snippet)] == snippet for k in range(len(program)))


def main():
    project = Path(sys.argv[1])
    pages = [project / "README.md", *sorted(project.glob("docs/*.md"))]
    count = faults = 0
    for language, sources in LANGUAGES.items():
        programs = [normal(file.read_text()) for pattern in sources for file in sorted(project.glob(pattern))]
        for page in pages:
            for snippet in re.findall(rf"^```{language}\n(.*?)^```", page.read_text(), re.DOTALL | re.MULTILINE):
                count += 1
                if not any(contains(program, normal(snippet)) for program in programs):
                    faults += 1
                    print(f"{page}: in no program that is built:\n{snippet}")
    return 1 if faults or count < 10 else 0


if __name__ == "__main__":
    sys.exit(main())
