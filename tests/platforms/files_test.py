#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Files written on one machine are those of every other, byte for byte, and each reads those of the others.

usage: files_test.py FOLDER NAME=COMMAND...

The first command is the program on this machine; the others run it as on another, such as "qemu-s390x-static hardball".
FOLDER is emptied.
"""

import filecmp
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

SCENARIO = Path(__file__).with_name("files.toml")
CHECKPOINT = "checkpoints/3.hbc"
INTERRUPTED = 1
PATIENCE = 600
# These hold how long the run took, or what functions of the C library return, such as its logarithm. Those that can be
# read are read.
UNLIKE = re.compile(r"summary\.json|report\.html|checkpoint\.hbc|checkpoints/.*|measures/.*")


def files_of(folder):
    names = {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}
    return {name for name in names if not UNLIKE.fullmatch(name)}


def differences(folder, expected):
    """The names of files that are in one folder alone, or differ."""
    names, all_names = files_of(folder), files_of(expected)
    return sorted((names ^ all_names) |
                  {name for name in names & all_names if not filecmp.cmp(folder / name, expected / name, shallow=False)})


class Platforms:
    def __init__(self, folder, commands):
        self.folder = folder
        self.commands = dict(command.split("=", 1) for command in commands)
        self.native = next(iter(self.commands))
        self.passed = self.failed = 0

    def run(self, name, *arguments):
        """What the program prints there; an Error of it ends the test."""
        ended = subprocess.run([*self.commands[name].split(), *map(str, arguments)], cwd=self.folder,
                               stdout=subprocess.PIPE, check=True)
        return ended.stdout

    def expect(self, is_met, what):
        self.passed += bool(is_met)
        self.failed += not is_met
        print("ok  " if is_met else "FAIL", what, flush=True)

    def expect_alike(self, folder, what):
        found = differences(self.folder / folder, self.folder / self.native)
        self.expect(not found, what + (": " + " ".join(found) if found else ""))

    def write(self):
        for name in self.commands:
            self.run(name, "run", SCENARIO, "--out", name, "--quiet")
            self.expect_alike(name, f"{name} writes the files of {self.native}")

    def resume(self, writer, reader):
        """From the middle of the run, with all its files."""
        copy = f"{writer}_read_by_{reader}"
        shutil.copytree(self.folder / writer, self.folder / copy)
        self.run(reader, "resume", copy, "--from", CHECKPOINT, "--quiet")
        self.expect_alike(copy, f"{reader} resumes the run of {writer}")

    def interrupt(self, name):
        """A run that keeps others out of its directory until it is asked to end, and ends with a checkpoint."""
        folder = self.folder / f"{name}_interrupted"
        arguments = ["run", SCENARIO, "--out", folder.name, "--until", "1e6", "--quiet"]
        command = [*self.commands[name].split(), *map(str, arguments)]
        with subprocess.Popen(command, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as running:
            log = folder / "events.npy"
            deadline = time.monotonic() + PATIENCE
            while not (log.exists() and log.stat().st_size > 10000) and running.poll() is None:
                time.sleep(0.1)
                if time.monotonic() > deadline:
                    break
            second = subprocess.run([*command, "--overwrite"], cwd=self.folder, capture_output=True)
            self.expect(second.returncode == 2 and b"another run is writing to it" in second.stderr,
                        f"{name} keeps a second run out of a directory")
            running.send_signal(signal.SIGINT)
            self.expect(running.wait(PATIENCE) == INTERRUPTED and (folder / "checkpoint.hbc").exists(),
                        f"{name} ends with a checkpoint when it is interrupted")
        self.expect(not (folder / "run.lock").exists(), f"{name} removes its lock")

    def read(self):
        names = list(self.commands)
        for writer in names:
            for reader in names:
                if writer != reader and self.native in (writer, reader):
                    self.resume(writer, reader)
        files = ["trajectory.gsd", "events.npy", "recording.hbr", "checkpoint.hbc"]
        told = {name: self.run(name, "info", *(f"{self.native}/{file}" for file in files)) for name in names}
        for name in names[1:]:
            self.expect(told[name] == told[self.native], f"{name} tells of files what {self.native} tells")
            for ending in ("npy", "csv", "gsd", "lammpstrj"):
                self.run(name, "convert", f"{self.native}/trajectory.gsd", f"{name}.{ending}", "--quiet")
        for ending in ("npy", "csv", "gsd", "lammpstrj"):
            self.run(self.native, "convert", f"{self.native}/trajectory.gsd", f"{self.native}.{ending}", "--quiet")
            expected = (self.folder / f"{self.native}.{ending}").read_bytes()
            for name in names[1:]:
                self.expect((self.folder / f"{name}.{ending}").read_bytes() == expected,
                            f"{name} converts trajectories to {ending} as {self.native}")


def main():
    folder = Path(sys.argv[1]).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    platforms = Platforms(folder, sys.argv[2:])
    platforms.write()
    platforms.read()
    for name in platforms.commands:
        platforms.interrupt(name)
    print(f"{platforms.passed} passed, {platforms.failed} failed")
    return platforms.failed > 0


if __name__ == "__main__":
    sys.exit(main())
