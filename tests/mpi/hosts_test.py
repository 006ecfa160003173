#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Runs a system on two hosts with a network between them, and compares hash and files with those of one process.

usage, as root: hosts_test.py PROGRAM; exits with 77 where a machine has no namespaces or tunnels
"""

import json
import sys
import tempfile
import unittest
from pathlib import Path

from two_hosts import TwoHosts, are_possible

PROGRAM = str(Path(sys.argv[1]).resolve())
SCENARIO = """
[box]
size = [20.0, 16.0, 16.0]
boundary = ["periodic", "wall", "periodic"]
[[spheres]]
count = 2000
radius = 0.5
placement = "fcc"
temperature = 1.0
[run]
until = 1.0
[output]
snapshots_every = 0.5
event_log = true
"""
FILES = ("events.npy", "trajectory.xyz", "measures/quantities.csv")


class Hosts(unittest.TestCase):
    def test_two_hosts_give_what_one_process_gives(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "gas.toml").write_text(SCENARIO)
            found = {}
            for delay in (None, 1e-4, 1e-3):
                out = folder / str(delay)
                command = [PROGRAM, "run", folder / "gas.toml", "--out", out, "--quiet", "--json"]
                with TwoHosts(delay or 0) as hosts:
                    start = hosts.mpirun if delay else lambda command, **options: hosts.on("one", command, **options)
                    done = start(command, capture_output=True, text=True, timeout=240)
                self.assertEqual(done.returncode, 0, done.stderr)
                summary = json.loads(done.stdout)
                files = [(out / file).read_bytes() for file in FILES]
                found[delay] = (summary["event_log_hash"], summary["events"]["collision"], files)
            self.assertEqual(found[1e-4], found[None])
            self.assertEqual(found[1e-3], found[None])

    def test_hosts_are_two(self):
        with TwoHosts(0) as hosts:
            done = hosts.mpirun(["sh", "-c", "hostname; ls /sys/class/net"], capture_output=True, text=True)
        self.assertEqual(sorted(done.stdout.split()), ["hardball1", "hardball2", "lo", "lo", "one", "two"])


if __name__ == "__main__":
    if not are_possible():
        print("no namespaces and tunnels can be made here")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
