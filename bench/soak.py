#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Runs a dense gas for a billion collisions, ended by signals at random moments and resumed, and prints what became of
energy, momentum, overlaps and memory.

Usage: soak.py PROGRAM DIRECTORY [COLLISIONS]
"""
import json
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

SCENARIO = """
[box]
size = [17.45, 17.45, 17.45]
boundary = ["periodic", "periodic", "periodic"]

[[spheres]]
count = 4000
radius = 0.5
placement = "fcc"
temperature = 1.0

[run]
until = 100.0
seed = 1

[output]
checkpoint_every = 10

[measures]
names = ["pressure", "temperature", "collision_rate"]
"""


def main():
    program, directory = sys.argv[1], Path(sys.argv[2])
    wanted = float(sys.argv[3]) if len(sys.argv) > 3 else 1e9
    directory.mkdir(parents=True, exist_ok=True)
    scenario = directory / "soak.toml"
    scenario.write_text(SCENARIO)
    out = directory / "out"
    moments = random.Random(1)
    print("collisions time energy_drift momentum overlap memory_bytes interruptions", flush=True)

    def go_on(arguments):
        """Runs to the end, with signals in between; returns how many there were."""
        signals = 0
        while True:
            process = subprocess.Popen([program, *arguments, "--quiet"], stdout=subprocess.DEVNULL)
            try:
                process.wait(moments.expovariate(1 / 40))
            except subprocess.TimeoutExpired:
                process.send_signal(moments.choice((signal.SIGKILL, signal.SIGTERM)))
                process.wait()
                signals += 1
                # A run that was asked to end has written a summary of where it was.
                (out / "summary.json").unlink(missing_ok=True)
            if process.returncode == 0:
                return signals
            while not (out / "checkpoint.hbc").exists():
                return go_on(["run", str(scenario), "--out", str(out), "--overwrite"])
            arguments = ["resume", str(out)] + (arguments[arguments.index("--until"):] if "--until" in arguments else [])

    begin = time.monotonic()
    interruptions = go_on(["run", str(scenario), "--out", str(out), "--overwrite"])
    while True:
        summary = json.loads((out / "summary.json").read_text())
        collisions = summary["events"]["collision"]
        energy = summary["energy"]
        print(collisions, summary["time"], energy["final"] / energy["initial"] - 1,
              max(abs(p) for p in summary["momentum"]), summary["max_overlap"], summary["peak_rss_bytes"],
              interruptions, flush=True)
        if collisions >= wanted:
            break
        rate = collisions / summary["time"]
        until = summary["time"] + min(0.1 * wanted, 1.001 * (wanted - collisions)) / rate
        interruptions += go_on(["resume", str(out), "--until", repr(until)])
    print(f"{time.monotonic() - begin:.0f} s, event log {summary['event_log_hash']}")


if __name__ == "__main__":
    main()
