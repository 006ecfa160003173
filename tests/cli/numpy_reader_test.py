#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Runs the readers shown in docs/recording.md and docs/scenarios.md on the files of a run, and compares them.

Usage: numpy_reader_test.py PROGRAM DOCS
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

SCENARIO = """
[box]
size = [10.0, 10.0, 10.0]
boundary = ["wall", "periodic", "wall"]
[[spheres]]
count = 300
radius = 0.5
placement = "random"
temperature = 1.0
[run]
until = 12.0
[output]
snapshots_every = 1.5
event_log = true
recording = true
report = false
[measures]
names = []
"""


def check_that_damage_is_told(chunks, name):
    """A damaged byte in any part is reported, and what comes before is read; a chunk that is cut off is not damage."""
    whole = name.read_bytes()
    count = len(list(chunks(name)))
    damaged = name.with_name("damaged.hbr")
    for part in range(40):
        changed = bytearray(whole)
        changed[part * len(whole) // 40] ^= 4
        damaged.write_bytes(changed)
        found = 0
        try:
            for _ in chunks(damaged):
                found += 1
        except ValueError:
            assert found <= part * count // 30, (part, found)
        else:
            raise AssertionError(f"byte {part * len(whole) // 40} is damaged")
    damaged.write_bytes(whole[:-1])
    assert len(list(chunks(damaged))) == count - 1


def main():
    program, docs = map(os.path.abspath, sys.argv[1:])
    text = (Path(docs) / "recording.md").read_text()
    reader = {}
    exec(re.search(r"```python\n(.*?)```", text, re.S).group(1), reader)
    with tempfile.TemporaryDirectory() as folder:
        scenario, out = Path(folder) / "gas.toml", Path(folder) / "out"
        scenario.write_text(SCENARIO)
        subprocess.run([program, "run", scenario, "--out", out, "--quiet"], check=True, stdout=subprocess.DEVNULL)
        name = out / "recording.hbr"
        chunks = list(reader["chunks"](name))
        assert len(chunks) > 2, "one chunk would prove little"
        check_that_damage_is_told(reader["chunks"], name)
        contacts = np.concatenate([chunk[3] for chunk in chunks])
        events = np.load(out / "events.npy")
        walls = events["kind"] == 1
        assert walls.any() and not walls.all()
        assert (contacts["t"] == events["time"]).all() and (contacts["i"] == events["first"]).all()
        assert (np.where(walls, -1 - contacts["j"], contacts["j"]) == events["second"]).all()
        shown = re.findall(r"```python\n(.*?)```", (Path(docs) / "scenarios.md").read_text(), re.S)
        found = {}
        os.chdir(folder)
        exec("".join(block for block in shown if "events" in block), found)
        within = (events["time"] >= 2.5) & (events["time"] <= 3.5)
        assert within.any() and (events[within] == found["events"][found["first"]:found["end"]]).all()
        frames = 0
        lines = (out / "trajectory.xyz").read_text().splitlines()
        while lines:
            time = float(re.search(r"Time=(\S+)", lines[1]).group(1))
            count = int(lines[0])
            frame = np.array([line.split()[1:4] for line in lines[2:2 + count]], dtype=float)
            apart = reader["positions"](name, time) - frame
            apart[:, 1] -= 10 * np.round(apart[:, 1] / 10)
            assert abs(apart).max() < 1e-12, (time, abs(apart).max())
            lines = lines[2 + count:]
            frames += 1
        assert frames == 9
    print(f"{len(contacts)} contacts in {len(chunks)} chunks, {frames} frames")


if __name__ == "__main__":
    main()
