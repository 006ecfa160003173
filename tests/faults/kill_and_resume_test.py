#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Kills runs with SIGKILL at random moments, and resumes them until they end: the hash, the measures and all files
must be those of the undisturbed run.

Usage: kill_and_resume_test.py PROGRAM [CYCLES], the number of kills, shared among three scenarios.
"""
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

# Contacts of many kinds with files of every kind; how many units of time take about a second differs.
EVERYTHING = """
[box]
size = [24.0, 24.0, 30.0]
boundary = ["periodic", "periodic", "wall"]

[[species]]
name = "rough"
[[species]]
name = "ghost"

[[spheres]]
count = 1500
radius = 0.5
species = "rough"
placement = "random"
temperature = 1.0

[[spheres]]
count = 300
radius = 0.8
species = "ghost"
placement = "random"
temperature = 1.0

[[walls]]
shape = "plane"
point = [0.0, 0.0, 1.0]
normal = [0.0, 0.0, 1.0]
temperature = 1.5

[response]
restitution = 0.9
tangential_restitution = 0.4
contact_duration = 1e-6

[[response.pairs]]
between = ["ghost", "ghost"]
kind = "pass"

[thermostat]
kind = "andersen"
temperature = 1.0
rate = 0.05

[run]
until = 60.0
seed = 3
"""

FLUID = """
[box]
size = [12.0, 12.0, 12.0]
boundary = ["periodic", "periodic", "periodic"]

[[spheres]]
count = 1000
radius = 0.5
placement = "random"
temperature = 1.0

[run]
until = 40.0
seed = 5
"""

MERGING = """
[box]
size = [60.0, 60.0, 60.0]
boundary = ["wall", "wall", "wall"]
gravity = [0.0, 0.0, -0.1]

[[spheres]]
count = 1500
radius = 0.4
placement = "random"
temperature = 1.0

[response]
kind = "merge"

[run]
until = 60.0
seed = 7

[measures]
names = []
"""

OUTPUT = """
[output]
snapshots_every = 1.3
trajectory = ["vtp", "gsd", "lammps", "xyz.zst", "xyz"]
event_log = true
recording = true
checkpoint_every = 0.02
"""


class Failure(Exception):
    pass


def results_of(directory):
    """All that must be the same after kills, by name."""
    summary = json.loads((directory / "summary.json").read_text())
    results = {name: summary[name] for name in
               ("spheres", "time", "event_log_hash", "energy", "momentum", "max_overlap", "compressibility",
                "wall_pressure")}
    results["contacts"] = [summary["events"][kind] for kind in ("collision", "wall")]
    for path in [*(directory / name for name in
                   ("trajectory.xyz", "trajectory.xyz.zst", "trajectory.gsd", "trajectory.lammpstrj",
                    "trajectory.pvd", "events.npy", "recording.hbr")),
                 *directory.glob("trajectory/*"), *directory.glob("measures/*")]:
        results[path.name] = path.read_bytes()
    return results


def compare(expected, found):
    for name, value in expected.items():
        if found.get(name) != value:
            raise Failure(f"{name} differs from that of the undisturbed run")
    if len(found) != len(expected):
        raise Failure("there are other files than of the undisturbed run")


def killed_after(arguments, directory, seconds):
    """Whether the run was killed before its end, which it is after so many seconds unless it ends before."""
    process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    try:
        process.wait(seconds)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGKILL)
    _, messages = process.communicate()
    if process.returncode not in (0, -signal.SIGKILL):
        raise Failure(f"exit code {process.returncode}: {messages}")
    return process.returncode != 0 and not (directory / "summary.json").exists()


def main():
    program = os.path.abspath(sys.argv[1])
    cycles = int(sys.argv[2]) if len(sys.argv) > 2 else 30
    moments = random.Random(1)
    kills = {}
    resumed = 0
    with tempfile.TemporaryDirectory() as scratch:
        for name, text in (("everything", EVERYTHING), ("fluid", FLUID), ("merging", MERGING)):
            scenario = Path(scratch) / f"{name}.toml"
            scenario.write_text(text + OUTPUT)
            undisturbed = Path(scratch) / name
            begin = time.monotonic()
            killed_after([program, "run", scenario, "--out", undisturbed, "--quiet"], undisturbed, 600)
            seconds = time.monotonic() - begin
            expected = results_of(undisturbed)
            kills[name] = 0
            while kills[name] < cycles / 3:
                directory = Path(scratch) / "killed"
                shutil.rmtree(directory, ignore_errors=True)
                start = [program, "run", scenario, "--out", directory, "--quiet", "--overwrite"]
                resume = [program, "resume", directory, "--quiet"]
                # Kills hit the start, the end and checkpoints, too; ever later ones let slow machines get on.
                latest = 0.3 * seconds
                while killed_after(resume if (directory / "checkpoint.hbc").exists() else start, directory,
                                   moments.uniform(0, latest)):
                    latest *= 1.1
                    kills[name] += 1
                    resumed += (directory / "checkpoint.hbc").exists()
                compare(expected, results_of(directory))
    if resumed < cycles / 3:
        raise Failure(f"only {resumed} of the kills left a checkpoint")
    print(", ".join(f"{name}: {count} kills" for name, count in kills.items()) + f"; {resumed} resumed")


if __name__ == "__main__":
    try:
        main()
    except Failure as failure:
        sys.exit(f"FAILED: {failure}")
