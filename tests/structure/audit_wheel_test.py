#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Tests that packaging/audit_wheel.py finds each kind of fault, and tags what has none.

usage: audit_wheel_test.py PROJECT_FOLDER COMPILER
"""

import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

COMPILER = sys.argv.pop()
PROJECT = Path(sys.argv.pop()).resolve()
sys.path.insert(0, str(PROJECT / "packaging"))

import audit_wheel

NAME = "hardball-0.2.0-cp311-cp311-linux_x86_64.whl"
CONTAINED = ["-static-libstdc++", "-static-libgcc", "-s"]
SOURCE = "#include <stdexcept>\nint main(int count, char**) { try { if (count > 9) throw std::runtime_error(\"many\"); } catch (...) {} }\n"


def compiled(folder, *options, source=SOURCE):
    """The bytes of a program."""
    (folder / "main.cpp").write_text(source)
    subprocess.run([COMPILER, folder / "main.cpp", "-o", folder / "main", *options], check=True)
    return (folder / "main").read_bytes()


class Audit(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def audited(self, program, mode=0o755, change=None):
        """The exit status of the audit of a wheel with this program, and what it prints."""
        files = {name.replace("*", "x"): b"text" for name in audit_wheel.PARTS}
        information = "hardball-x.dist-info/"
        files["hardball-x.data/scripts/hardball"] = program
        files[information + "WHEEL"] = b"Wheel-Version: 1.0\nTag: cp311-cp311-linux_x86_64\n"
        record = "".join(f"{name},{audit_wheel.digest(content)},{len(content)}\n" for name, content in files.items())
        files[information + "RECORD"] = (record + information + "RECORD,,\n").encode()
        files.update(change or {})
        with zipfile.ZipFile(self.folder / NAME, "w") as archive:
            for name, content in files.items():
                entry = zipfile.ZipInfo(name, (2026, 1, 1, 0, 0, 0))
                entry.external_attr = (0o100000 | mode) << 16
                archive.writestr(entry, content)
        command = [sys.executable, "-B", PROJECT / "packaging/audit_wheel.py", self.folder / NAME, self.folder / "audited"]
        done = subprocess.run(command, capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def test_a_wheel_without_faults_has_the_tag_of_its_c_library(self):
        status, printed = self.audited(compiled(self.folder, *CONTAINED))
        self.assertEqual(status, 0, printed)
        wheel = Path(printed.strip())
        self.assertRegex(wheel.name, r"hardball-0\.2\.0-cp311-cp311-manylinux_2_\d+_x86_64\.whl")
        files = audit_wheel.read(wheel)
        self.assertIn(wheel.stem.split("-")[-1].encode(), files["hardball-x.dist-info/WHEEL"][1])
        self.assertEqual(list(audit_wheel.faults_of_files(files)), [])

    def test_foreign_libraries_and_run_paths(self):
        status, printed = self.audited(compiled(self.folder, "-Wl,-rpath,/opt/lib"))
        self.assertEqual(status, 1)
        for fault in ("needs libstdc++.so.6", "has a run path", "needs GLIBCXX_3.4", "is not stripped"):
            self.assertIn(f"hardball-x.data/scripts/hardball {fault}", printed)

    def test_names_of_sources(self):
        source = SOURCE + 'extern const char* const made = "/tmp/somewhere/main.cpp";\n'
        status, printed = self.audited(compiled(self.folder, *CONTAINED, source=source))
        self.assertEqual(status, 1)
        self.assertIn("names the source /tmp/somewhere/main.cpp", printed)

    def test_what_is_missing_changed_or_cannot_be_executed(self):
        program = compiled(self.folder, *CONTAINED)
        self.assertIn("hardball cannot be executed", self.audited(program, mode=0o644)[1])
        self.assertIn("is not the file that RECORD describes", self.audited(program, change={"hardball/py.typed": b"new"})[1])
        self.assertIn("new.py is not both in the wheel and in its RECORD", self.audited(program, change={"new.py": b""})[1])


if __name__ == "__main__":
    unittest.main()
