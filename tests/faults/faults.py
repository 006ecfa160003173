# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""What the tests of faults share: runs of the real program, what they must leave behind, places to break things."""

import json
import os
import resource
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

# The first argument of every script; the rest are unittest's.
PROGRAM = Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else None

# Walls, gravity, spins and a thermostat; every kind of file.
SCENARIO = """
[box]
size = [8.0, 8.0, 8.0]
boundary = ["wall", "periodic", "wall"]
gravity = [0.0, 0.0, -0.5]

[[spheres]]
count = 30
radius = 0.5
placement = "random"
mean_speed = 1.0

[response]
restitution = 0.95
tangential_restitution = 0.3
elastic_below = 0.01

[thermostat]
kind = "heating"
strength = 0.05
every = 0.25

[run]
until = 20.0
seed = 7

[output]
snapshots_every = 0.25
event_log = true
recording = true
checkpoint_every = 0.02

[measures]
names = ["pressure", "temperature", "mean_square_displacement"]
"""

DONE, FAILED, BAD_INPUT = 0, 1, 2


class Ended:
    """How a program has ended."""

    def __init__(self, code, output, messages):
        self.code, self.output, self.messages = code, output, messages

    def __repr__(self):
        return f"exit code {self.code}: {self.messages!r}"


def start(arguments, folder, prepare=None, environment=None, **streams):
    """Starts the program in a folder; `prepare` is called in its process first."""
    return subprocess.Popen(
        [PROGRAM, *map(str, arguments)], cwd=folder, preexec_fn=prepare,
        env={**os.environ, **(environment or {})},
        **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "stdin": subprocess.DEVNULL, **streams})


def ended(process, seconds=60):
    """Waits for the end; a program that hangs fails the test."""
    try:
        output, messages = process.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        raise
    return Ended(process.returncode, output or b"", (messages or b"").decode(errors="replace"))


def run(arguments, folder, **how):
    return ended(start(arguments, folder, **how))


def limited(kind, most):
    """For `prepare`: a limit of the process."""
    return lambda: resource.setrlimit(kind, (most, most))


def become_root_of_a_namespace():
    """Starts the script again where it may mount file systems; returns whether it may."""
    if os.environ.get("HARDBALL_MAY_MOUNT"):
        return os.environ["HARDBALL_MAY_MOUNT"] == "yes"
    for options in (["-m"], ["-Urm"]):
        command = ["unshare", *options]
        if subprocess.run([*command, "mount", "-t", "tmpfs", "tmpfs", "/mnt"], capture_output=True,
                          check=False).returncode == 0:
            os.environ["HARDBALL_MAY_MOUNT"] = "yes"
            os.execvp("unshare", [*command, sys.executable, sys.argv[0], str(PROGRAM), *sys.argv[1:]])
    os.environ["HARDBALL_MAY_MOUNT"] = "no"
    return False


def mount(*arguments):
    subprocess.run(["mount", *map(str, arguments)], check=True, capture_output=True)


class FaultTest(unittest.TestCase):
    """A test with a folder, which holds the scenario gas.toml and the files of its undisturbed run in whole/."""

    scenario = SCENARIO

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="hardball-faults-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        (cls.folder / "gas.toml").write_text(cls.scenario)
        whole = run(["run", "gas.toml", "--out", "whole", "--quiet"], cls.folder)
        if whole.code != DONE:
            raise RuntimeError(f"the undisturbed run: {whole}")
        cls.hash = hash_of(cls.folder / "whole")

    def assert_refused(self, end, part=""):
        """Exit code 2 and one clear line."""
        self.assertEqual(end.code, BAD_INPUT, end)
        self.assert_one_line(end, part)

    def assert_failed(self, end, part=""):
        """Exit code 1 and one clear line."""
        self.assertEqual(end.code, FAILED, end)
        self.assert_one_line(end, part)

    def assert_one_line(self, end, part=""):
        self.assertTrue(end.messages.startswith("hardball: "), end)
        self.assertEqual(end.messages.count("\n"), 1, end)
        self.assertIn(part, end.messages)

    def assert_sound(self, directory):
        """Every file there is complete, and only files that a run leaves are there."""
        for path in directory.rglob("*"):
            if path.is_file():
                self.assertNotEqual(path.suffix, ".part", path)
                self.assertNotEqual(path.name, "run.lock", path)
        if (trajectory := directory / "trajectory.xyz").exists():
            assert_whole_frames(trajectory.read_bytes())
        if (events := directory / "events.npy").exists():
            assert_whole_log(events.read_bytes())
        if (recording := directory / "recording.hbr").exists():
            assert_whole_recording(recording.read_bytes())
        if (summary := directory / "summary.json").exists():
            json.loads(summary.read_text())
        if (report := directory / "report.html").exists():
            self.assertTrue(report.read_text().rstrip().endswith("</html>"))
        if (directory / "measures").exists():
            for table in (directory / "measures").iterdir():
                rows = table.read_text().splitlines()
                self.assertGreater(len(rows), 0, table)
                self.assertEqual(table.read_bytes()[-1:], b"\n", table)

    def assert_undisturbed(self, directory):
        """The run in the directory has come to the end of the undisturbed one: bits, frames, events, measures."""
        self.assert_sound(directory)
        whole = self.folder / "whole"
        self.assertEqual(hash_of(directory), self.hash)
        names = ["trajectory.xyz", "events.npy", *(f"measures/{t.name}" for t in (whole / "measures").iterdir())]
        for name in names:
            self.assertEqual((directory / name).read_bytes(), (whole / name).read_bytes(), name)
        self.assertEqual(contacts_of((directory / "recording.hbr").read_bytes()),
                         contacts_of((whole / "recording.hbr").read_bytes()))

    def assert_resumes(self, directory):
        """A run that a fault has ended resumes as if nothing had happened."""
        end = run(["resume", directory, "--quiet"], self.folder)
        self.assertEqual(end.code, DONE, end)
        self.assert_undisturbed(directory)


def hash_of(directory):
    return json.loads((directory / "summary.json").read_text())["event_log_hash"]


def assert_whole_frames(text):
    """An extended XYZ file ends with a frame."""
    lines = text.split(b"\n")
    if lines.pop() != b"":
        raise AssertionError("the last line of the trajectory is cut off")
    at = 0
    while at < len(lines):
        at += int(lines[at]) + 2
    if at != len(lines):
        raise AssertionError("the last frame of the trajectory is cut off")


def assert_whole_log(log):
    """The header of an event log counts the records that follow."""
    header, record = 256, 49
    if len(log) == 0:
        raise AssertionError("the event log has no header")
    count = int(log[:header].split(b"'shape': (")[1].split(b",")[0])
    if len(log) != header + count * record:
        raise AssertionError(f"{len(log)} bytes of event log for {count} records")


def chunks_of(recording):
    """The chunks of a recording: how many contacts each has. See docs/recording.md."""
    if recording[:8] != b"HBREC003":
        raise AssertionError("not a recording")
    text_bytes = struct.unpack_from("<I", recording, 8)[0]
    spheres = json.loads(recording[12:12 + text_bytes])["spheres"]
    at = 12 + text_bytes + 16 * spheres + 8
    while at < len(recording):
        _, contacts, length = struct.unpack_from("<IIQ", recording, at)
        if length == 0 or at + length > len(recording):
            raise AssertionError("the last chunk of the recording is cut off")
        yield contacts
        at += length


def assert_whole_recording(recording):
    list(chunks_of(recording))


def contacts_of(recording):
    return sum(chunks_of(recording))
