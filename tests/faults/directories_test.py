#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Output directories that cannot be written to, that another run writes to, or that hold what is not to be lost."""

import os
import shutil
import signal
import subprocess
import time
import unittest

import faults
from faults import FaultTest, ended, mount, run, start

MAY_MOUNT = faults.become_root_of_a_namespace()


def contents(directory):
    return {path: path.read_bytes() for path in directory.rglob("*") if path.is_file()}


class Directories(FaultTest):
    def copy_of_whole(self, name):
        return shutil.copytree(self.folder / "whole", self.folder / name)

    @unittest.skipUnless(MAY_MOUNT, "file systems cannot be mounted here")
    def test_read_only(self):
        out = self.copy_of_whole("read_only")
        before = contents(out)
        mount("--bind", out, out)
        mount("-o", "remount,bind,ro", out)
        try:
            for arguments in (["run", "gas.toml", "--out", out], ["run", "gas.toml", "--out", out, "--overwrite"],
                              ["run", "gas.toml", "--out", out / "new"], ["resume", out, "--until", 30]):
                with self.subTest(arguments):
                    self.assert_refused(run(arguments, self.folder), "Read-only file system")
            self.assertEqual(contents(out), before)
        finally:
            subprocess.run(["umount", out], check=True)

    def test_that_is_moved_away_during_the_run(self):
        out, moved = self.folder / "gone", self.folder / "moved"
        process = start(["run", "gas.toml", "--unit-costs", "standard", "--until", 1e6, "--out", out, "--quiet"], self.folder)
        wait_for(out / "checkpoint.hbc")
        out.rename(moved)
        self.assert_failed(ended(process), "No such file or directory")
        self.assertFalse(out.exists(), "a directory without the other files")
        # The lock of a process that has ended holds nobody up.
        process = start(["resume", moved, "--quiet"], self.folder)
        wait_for(moved / "checkpoint.hbc", than=os.stat(moved / "checkpoint.hbc").st_mtime_ns)
        process.send_signal(signal.SIGTERM)
        self.assert_failed(ended(process), "interrupted at time")
        self.assert_sound(moved)

    def test_not_permitted(self):
        if os.getuid() != 0:
            self.skipTest("only root can become another user")
        out = self.copy_of_whole("not_permitted")
        before = contents(out)
        self.folder.chmod(0o755)
        somebody = {"prepare": lambda: os.setresuid(65534, 65534, 65534)}
        for arguments in (["run", "gas.toml", "--out", out], ["run", "gas.toml", "--out", out / "new"],
                          ["resume", out, "--until", 30]):
            with self.subTest(arguments):
                self.assert_refused(run(arguments, self.folder, **somebody), "Permission denied")
        self.assertEqual(contents(out), before)

    def test_that_holds_files_of_another_run(self):
        for name in ("trajectory.xyz", "events.npy", "recording.hbr", "checkpoint.hbc", "summary.json", "report.html",
                     "measures/quantities.csv"):
            with self.subTest(name):
                out = self.folder / f"holds_{name.replace('/', '_')}"
                (out / name).parent.mkdir(parents=True)
                shutil.copy(self.folder / "whole" / name, out / name)
                before = contents(out)
                self.assert_refused(run(["run", "gas.toml", "--out", out], self.folder), "of another run")
                self.assertEqual(contents(out), before)
                self.assertEqual(run(["run", "gas.toml", "--out", out, "--overwrite"], self.folder).code, faults.DONE)
                self.assert_undisturbed(out)

    def test_files_of_others_are_kept(self):
        out = self.folder / "others"
        (out / "measures").mkdir(parents=True)
        for name in ("notes.txt", "measures/mine.csv", "checkpoints.txt"):
            (out / name).write_text("mine")
        for arguments in ([], ["--overwrite"]):
            self.assertEqual(run(["run", "gas.toml", "--out", out, *arguments], self.folder).code, faults.DONE)
            for name in ("notes.txt", "measures/mine.csv", "checkpoints.txt"):
                self.assertEqual((out / name).read_text(), "mine")

    def test_two_runs_at_once(self):
        out = self.folder / "two"
        first = start(["run", "gas.toml", "--unit-costs", "standard", "--until", 1e6, "--out", out, "--quiet"], self.folder)
        wait_for(out / "checkpoint.hbc")
        for arguments in (["run", "gas.toml", "--out", out], ["run", "gas.toml", "--out", out, "--overwrite"],
                          ["resume", out]):
            with self.subTest(arguments):
                self.assert_refused(run(arguments, self.folder), "another run is writing")
        first.send_signal(signal.SIGTERM)
        self.assert_failed(ended(first), "interrupted at time")
        self.assert_sound(out)

    def test_many_runs_at_once(self):
        # All at the same moment: one of them wins, and its files are whole.
        for attempt in range(5):
            out = self.folder / f"race_{attempt}"
            ends = [ended(process) for process in
                    [start(["run", "gas.toml", "--out", out, "--quiet"], self.folder) for _ in range(4)]]
            self.assertEqual([end.code for end in ends].count(faults.DONE), 1, ends)
            for end in ends:
                if end.code != faults.DONE:
                    self.assert_refused(end)
            self.assert_undisturbed(out)


def wait_for(path, seconds=30, than=0):
    """Waits until the file is there, written later `than` a time."""
    limit = time.monotonic() + seconds
    while not (path.exists() and path.stat().st_mtime_ns > than):
        if time.monotonic() > limit:
            raise AssertionError(f"there is no {path}")
        time.sleep(0.005)


if __name__ == "__main__":
    unittest.main()
