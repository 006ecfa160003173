#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The disk is full, at any write: what is there is complete, and with more space the run resumes."""

import re
import resource
import subprocess
import unittest

import faults
from faults import FaultTest, limited, mount, run

MAY_MOUNT = faults.become_root_of_a_namespace()


def file_of(end):
    """The file that a message names, if it does."""
    name = re.search(r"cannot (?:write|create) \S*?out/([a-z_.]+)|^hardball: \S*?out/([a-z_.]+)", end.messages)
    return name and (name.group(1) or name.group(2))


class DiskFull(FaultTest):
    # Checkpoints at fixed times make the order of writes that of every run.
    scenario = faults.SCENARIO.replace("checkpoint_every = 0.02",
                                       "checkpoint_every = 1000\ncheckpoint_at = [3, 6, 9, 12, 15, 18]")

    def setUp(self):
        self.disk = self.folder / "disk"
        self.disk.mkdir(exist_ok=True)

    def try_on(self, size):
        """A run on a small disk, which becomes larger; returns what could not be written, or None."""
        mount("-t", "tmpfs", "-o", size, "tmpfs", self.disk)
        try:
            out = self.disk / "out"
            end = run(["run", "gas.toml", "--quiet", "--out", out], self.folder)
            if end.code == faults.DONE:
                self.assert_undisturbed(out)
                return None
            self.assert_one_line(end, "No space left on device")
            if out.exists():
                self.assert_sound(out)
                self.assertFalse((out / "summary.json").exists(), "which says that the run has ended")
            mount("-o", "remount,size=10m,nr_inodes=1000", self.disk)
            if (out / "checkpoint.hbc").exists():
                self.assert_failed(end)
                self.assert_resumes(out)
            else:
                again = run(["run", "gas.toml", "--quiet", "--overwrite", "--out", out], self.folder)
                self.assertEqual(again.code, faults.DONE, again)
                self.assert_undisturbed(out)
            return file_of(end)
        finally:
            subprocess.run(["umount", self.disk], check=True)

    @unittest.skipUnless(MAY_MOUNT, "file systems cannot be mounted here")
    def test_of_any_size(self):
        need = sum(path.stat().st_size for path in (self.folder / "whole").rglob("*") if path.is_file()) >> 10
        # Blocks of the file system are larger than what is in them.
        found = {self.try_on(f"size={kilobytes}k") for kilobytes in range(4, need + need // 4 + 200, 44)}
        self.assertLessEqual({"trajectory.xyz", "recording.hbr", "checkpoint.hbc", None}, found)

    @unittest.skipUnless(MAY_MOUNT, "file systems cannot be mounted here")
    def test_of_any_number_of_files(self):
        found = {self.try_on(f"size=10m,nr_inodes={most}") for most in range(2, 26)}
        self.assertLessEqual({"trajectory.xyz", "events.npy", "recording.hbr", "checkpoints", "measures",
                              "report.html", "summary.json", None}, found)

    def test_while_one_file_is_written(self):
        for name in ("checkpoint.hbc", "checkpoints/9.hbc", "measures/quantities.csv", "measures/temperature.csv",
                     "report.html", "summary.json"):
            with self.subTest(name):
                out = self.folder / f"full_{name.replace('/', '_')}"
                full = out / f"{name}.part"
                full.parent.mkdir(parents=True)
                full.symlink_to("/dev/full")
                end = run(["run", "gas.toml", "--quiet", "--out", out], self.folder)
                self.assert_failed(end, f"cannot write {out / name}: No space left on device; it is unchanged")
                self.assert_sound(out)
                self.assertFalse((out / "summary.json").exists(), "which says that the run has ended")
                if (out / "checkpoint.hbc").exists():
                    self.assert_resumes(out)

    def test_of_files_that_may_not_grow(self):
        for kilobytes in (1, 16, 20, 100, 300, 450):
            with self.subTest(kilobytes):
                out = self.folder / f"limited_{kilobytes}"
                end = run(["run", "gas.toml", "--quiet", "--out", out], self.folder,
                          prepare=limited(resource.RLIMIT_FSIZE, kilobytes << 10))
                self.assert_failed(end, "File too large")
                self.assert_sound(out)
                if (out / "checkpoint.hbc").exists():
                    self.assert_resumes(out)


class DiskFullAtOnce(FaultTest):
    """Before a checkpoint is due: a run writes one when it starts."""

    scenario = faults.SCENARIO.replace("checkpoint_every = 0.02", "")

    def test_of_files_that_may_not_grow(self):
        for kilobytes in (20, 100, 300):
            with self.subTest(kilobytes):
                out = self.folder / f"limited_{kilobytes}"
                end = run(["run", "gas.toml", "--quiet", "--out", out], self.folder,
                          prepare=limited(resource.RLIMIT_FSIZE, kilobytes << 10))
                self.assert_failed(end, "File too large")
                self.assert_sound(out)
                self.assert_resumes(out)


if __name__ == "__main__":
    unittest.main()
