#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Gives the job of docs/parallel.md to a Slurm of one node, interrupts it, and gives it again: hash and files are those of
one process.

usage, as root: slurm_test.py PROGRAM PROJECT; exits with 77 where Slurm cannot be started
"""

import json
import re
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM, PROJECT = (Path(argument).resolve() for argument in sys.argv[1:3])
sys.path.insert(0, str(PROJECT / "tests/sweep"))

from one_node_slurm import one_node_slurm, why_not  # noqa: E402

PATIENCE = 240
SCENARIO = """
[box]
size = [30.0, 30.0, 30.0]
boundary = ["periodic", "periodic", "periodic"]
[[spheres]]
count = 10000
radius = 0.5
placement = "fcc"
temperature = 1.0
[run]
until = 16.0
[output]
event_log = true
report = false
[measures]
names = []
"""
# The job of the page is for two machines of 32 cores.
ON_ONE_NODE = {"--nodes=2": "--nodes=1", "--ntasks-per-node=8": "--ntasks-per-node=2", "--cpus-per-task=4": "--cpus-per-task=1",
               "--threads 4": "--threads 1"}


def job_of_page():
    page = (PROJECT / "docs/parallel.md").read_text()
    job = re.search(r"^```text\n(#!/bin/sh\n#SBATCH.*?)^```", page, re.DOTALL | re.MULTILINE)[1]
    for there, here in ON_ONE_NODE.items():
        assert there in job, there
        job = job.replace(there, here)
    return job


class Slurm(unittest.TestCase):
    def test_a_job_that_is_interrupted_and_given_again(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "gas.toml").write_text(SCENARIO)
            (folder / "job.sh").write_text(job_of_page())
            (folder / "slurm").mkdir()
            alone = [PROGRAM, "run", folder / "gas.toml", "--out", folder / "alone", "--quiet"]
            subprocess.run(alone, check=True, stdout=subprocess.DEVNULL)
            with one_node_slurm(folder / "slurm") as environment:
                # Two processes and this test share what may be one core.
                environment |= {"PATH": f"{PROGRAM.parent}:{environment['PATH']}", "SCRATCH": name,
                                "OMPI_MCA_mpi_yield_when_idle": "1"}

                def slurm(*command):
                    done = subprocess.run(command, cwd=folder, env=environment, timeout=PATIENCE, capture_output=True, text=True)
                    return done.stdout.strip()

                job = slurm("sbatch", "--parsable", "job.sh")
                log = folder / "gas/events.npy"
                deadline = time.monotonic() + PATIENCE
                while not (log.exists() and log.stat().st_size > 100_000) and time.monotonic() < deadline:
                    time.sleep(0.05)
                # As Slurm does before the time limit: it signals the processes, and not the script.
                slurm("scancel", "--signal=TERM", job)
                while slurm("squeue", "--noheader", "--jobs", job) and time.monotonic() < deadline:
                    time.sleep(0.1)
                self.assertLess(json.loads((folder / "gas/summary.json").read_text())["time"], 16.0)
                slurm("sbatch", "--wait", "job.sh")
            output = "".join(path.read_text() for path in folder.glob("slurm-*.out"))
            self.assertTrue((folder / "gas/summary.json").exists(), output)
            for file in ("events.npy",):
                self.assertEqual((folder / "gas" / file).read_bytes(), (folder / "alone" / file).read_bytes())
            hashes = [json.loads((folder / each / "summary.json").read_text())["event_log_hash"] for each in ("gas", "alone")]
            self.assertEqual(*hashes)


if __name__ == "__main__":
    if why_not():
        print(why_not())
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
