#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Programs that are compiled by hand, with options under which results differ or with headers of another version, are
told so when they make a world.

usage: compilation_test.py COMPILER PROJECT_FOLDER LIBRARY
"""

import platform
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

LIBRARY, PROJECT, COMPILER = Path(sys.argv.pop()).resolve(), Path(sys.argv.pop()).resolve(), sys.argv.pop()
IS_X86 = platform.machine() in ("x86_64", "AMD64")
IS_CLANG = "clang" in subprocess.run([COMPILER, "--version"], capture_output=True, text=True, check=True).stdout

MAIN = """
#include <cstdio>
#include "hardball/error.hpp"
#include "hardball/world.hpp"
int main() {
  try {
    hardball::World world;
    hardball::World within_walls(hardball::Box::walls({1, 1, 1}), {0, 0, -1});
  } catch (const hardball::Error& error) {
    std::puts(error.what());
    return 2;
  }
}
"""
# It makes no world, but computes with vectors.
OTHER = """
#include "hardball/contact.hpp"
double squared(const hardball::Vec3& v) { return dot(v, v); }
"""


def machine_fuses():
    if IS_X86:
        flags = re.search(r"^flags\s*:(.*)$", Path("/proc/cpuinfo").read_text(), re.MULTILINE)
        return flags is not None and "fma" in flags[1].split()
    return platform.machine() == "aarch64"


class Compilations(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def compiled(self, name, text, options, headers=PROJECT):
        (self.folder / name).write_text(text)
        subprocess.run([COMPILER, "-std=c++20", "-I", headers, *options, "-c", name, "-o", f"{name}.o"], cwd=self.folder,
                       check=True)
        return f"{name}.o"

    def run_objects(self, *objects):
        subprocess.run([COMPILER, *objects, LIBRARY, "-lzstd", "-pthread", "-o", "program"], cwd=self.folder, check=True)
        return subprocess.run(["./program"], cwd=self.folder, capture_output=True, text=True)

    def run_with(self, *options):
        return self.run_objects(self.compiled("main.cpp", MAIN, options))

    def expect_refusal(self, done, *parts):
        self.assertEqual(done.returncode, 2, done)
        for part in parts:
            self.assertIn(part, done.stdout)

    def test_those_that_change_nothing_run(self):
        accepted = [["-O0"], ["-O2"], ["-O3", "-fno-math-errno"], ["-O2", "-ffp-contract=off"]]
        if machine_fuses():
            accepted.append(["-O3", "-ffp-contract=off", *(["-mfma"] if IS_X86 else [])])
        for options in accepted:
            with self.subTest(options):
                if not IS_X86 and "-ffp-contract=off" not in options:
                    options = [*options, "-ffp-contract=off"]
                done = self.run_with(*options)
                self.assertEqual(done.returncode, 0, done)

    @unittest.skipUnless(machine_fuses(), "this machine has no fused instructions")
    def test_contraction_is_refused(self):
        # It is the default of GCC, and of Clang within an expression.
        for options in ([], ["-ffp-contract=fast"]):
            with self.subTest(options):
                done = self.run_with("-O2", *(["-mfma"] if IS_X86 else []), *options)
                self.expect_refusal(done, "main.cpp: the compiler rounds a product and a sum in one",
                                    "compile it with -ffp-contract=off")

    def test_fast_math_is_refused_by_name(self):
        for options in (["-O0", "-ffast-math"], ["-Ofast"]):
            with self.subTest(options):
                self.expect_refusal(self.run_with(*options), "main.cpp: this source is compiled with -ffast-math")
        self.expect_refusal(self.run_with("-O2", "-ffinite-math-only"), "compiled with -ffinite-math-only")

    def test_parts_of_fast_math_are_refused(self):
        for options, names in (
            (["-funsafe-math-optimizations"], ["-fassociative-math", "changes the order of sums"]),
            (["-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"],
             ["-fassociative-math", "changes the order of sums"]),
            (["-freciprocal-math"], ["-freciprocal-math", "multiplies by reciprocals"]),
            (["-fno-signed-zeros"], ["-fno-signed-zeros", "ignores the sign of zero"]),
        ):
            with self.subTest(options):
                done = self.run_with("-O2", *options)
                self.expect_refusal(done, "main.cpp: ")
                self.assertTrue(any(name in done.stdout for name in names), done.stdout)

    @unittest.skipIf(IS_CLANG, "Clang does not have this option")
    def test_constants_in_single_precision_are_refused(self):
        self.expect_refusal(self.run_with("-O2", "-fsingle-precision-constant"), "reads constants in single precision")

    @unittest.skipUnless(IS_X86 and not IS_CLANG, "only GCC for x86 has this option")
    def test_extended_precision_is_refused(self):
        self.expect_refusal(self.run_with("-O2", "-mfpmath=387"), "more than double precision", "-mfpmath=sse")

    def test_objects_of_other_sizes_are_refused(self):
        # Functions that are given vectors do not link then.
        main = MAIN.replace("hardball::World within_walls(hardball::Box::walls({1, 1, 1}), {0, 0, -1});", "")
        done = self.run_objects(self.compiled("main.cpp", main, ["-O1", "-D_GLIBCXX_DEBUG"]))
        self.expect_refusal(done, "another standard library", "_GLIBCXX_DEBUG")

    def test_each_source_is_compared(self):
        done = self.run_objects(self.compiled("main.cpp", MAIN, ["-O1"]),
                                self.compiled("other.cpp", OTHER, ["-O1", "-ffast-math"]))
        self.expect_refusal(done, "other.cpp: this source is compiled with -ffast-math")

    def test_headers_of_another_version_are_refused(self):
        headers = self.folder / "include"
        shutil.copytree(PROJECT / "hardball", headers / "hardball", ignore=shutil.ignore_patterns("*.cpp"))
        version = headers / "hardball/errors/version.hpp"
        text = version.read_text()
        own = {part: int(number) for part, number in re.findall(r"HARDBALL_VERSION_(\w+) (\d+)", text)}
        for part, is_refused in (("MAJOR", True), ("MINOR", True), ("PATCH", False)):
            other = {**own, part: own[part] + 1}
            version.write_text(re.sub(rf"(VERSION_{part}) \d+", rf"\1 {other[part]}", text))
            done = self.run_objects(self.compiled("main.cpp", MAIN, ["-O1"], headers))
            if is_refused:
                self.expect_refusal(done, f"main.cpp: this source is compiled with headers of Hardball "
                                          f"{other['MAJOR']}.{other['MINOR']}, and the library is version "
                                          f"{own['MAJOR']}.{own['MINOR']}")
            else:
                self.assertEqual(done.returncode, 0, done)


if __name__ == "__main__":
    unittest.main()
