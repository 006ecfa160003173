#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""What ./dev says before it works: a copy of it in an empty folder, with tools that only say that they were called.

usage: dev_test.py PROJECT_FOLDER
"""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT = Path(sys.argv.pop())
TOOLS = {
    "dpkg-query": "printf installed",
    "npm": ":",
    "cmake": 'echo "called: cmake $*"',
    "ctest": 'echo "called: ctest $*"',
    "clang-format-14": ":",
    "setarch": "exit 1",
}


def run(*arguments, **files):
    """The lines that ./dev prints in a folder with these test files, where `unit__a` stands for tests/unit/a_test.cpp."""
    with tempfile.TemporaryDirectory() as folder:
        tools = Path(folder) / "tools"
        tools.mkdir()
        for name, script in TOOLS.items():
            tool = tools / name
            tool.write_text(f"#!/bin/sh\n{script}\n")
            tool.chmod(0o755)
        for name, text in files.items():
            path = Path(folder) / "tests" / f"{name.replace('__', '/')}_test.cpp"
            path.parent.mkdir(parents=True)
            path.write_text(text)
        dev = shutil.copy(PROJECT / "dev", folder)
        environment = {**os.environ, "PATH": f"{tools}:{os.environ['PATH']}"}
        done = subprocess.run([dev, *arguments], env=environment, capture_output=True, text=True)
    return done.stdout.splitlines()


class Dev(unittest.TestCase):
    def test_says_what_it_does_and_how_long_that_takes_before_it_begins(self):
        for command, what in (("build", "program"), ("demo", "program"), ("mpi", "program"), ("python", "Python package"), ("wheel", "wheel"),
                              ("test", "library")):
            first = run(command)[0]
            self.assertRegex(first, f"^dev: .*{what}.* minutes on two cores when nothing is built yet", command)

    def test_python_says_where_the_package_is_before_it_tests_it_and_not_the_site(self):
        lines = run("python")
        tests = [line for line in lines if line.startswith("called: ctest")]
        self.assertEqual(len(tests), 1, lines)
        self.assertIn("-L ^python$", tests[0])
        place = next(line for line in lines if "the Python package is in build/python" in line)
        self.assertRegex(place, r"PYTHONPATH=/\S+/build/python /\S+python3$")
        built = max(index for index, line in enumerate(lines) if line.startswith("called: cmake --build"))
        self.assertLess(built, lines.index(place))
        self.assertLess(lines.index(place), lines.index(tests[0]))
        listed = (PROJECT / "python/CMakeLists.txt").read_text()
        self.assertIn("set_tests_properties(site PROPERTIES LABELS site ", listed)

    def test_one_file_builds_the_tests_of_its_kind_and_runs_its_suites(self):
        lines = run("test", "unit/world", unit__world="TEST(Faces, Are) {}\nTEST_F(Walls, Stand) {}\n#include <a>\nTEST(Faces, Do)")
        self.assertIn("called: cmake --build --preset checked --target unit_tests", lines)
        self.assertIn(r"--tests-regex ^unit\.(.*/)?(Faces|Walls)(/.*)?\.", lines[-1])
        self.assertEqual(run("test", "unit/lost"), [])


if __name__ == "__main__":
    unittest.main()
