#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""What happens around a run: signals, streams that are closed, memory that is refused, clocks that jump."""

import json
import os
import random
import resource
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

JUMPING_CLOCK = Path(sys.argv.pop(2)).resolve()

import faults  # noqa: E402
from faults import BAD_INPUT, DONE, FAILED, FaultTest, ended, hash_of, limited, run, start  # noqa: E402


class Signals(FaultTest):
    # Long enough for several of them.
    scenario = faults.SCENARIO.replace("until = 20.0", "until = 1000.0").replace("every = 0.25\nevent", "every = 5\nevent")

    def test_signals_at_random_moments(self):
        source = random.Random(1)
        interrupted = 0
        for case in range(4):
            out = self.folder / f"signals_{case}"
            process = start(["run", "gas.toml", "--out", out, "--quiet"], self.folder)
            while True:
                time.sleep(source.uniform(0, 0.3))
                process.send_signal(source.choice([signal.SIGINT, signal.SIGTERM]))
                end = ended(process)
                # A signal that comes when all is written ends the program, too.
                if end.code == DONE:
                    break
                self.assertNotEqual(end.code, BAD_INPUT, end)
                # Before it listens, a signal ends it at once, and during the set-up in order: it has not begun to
                # write.
                if end.code < 0:
                    self.assertFalse((out / "run.lock").exists())
                elif end.code == FAILED and "during the set-up" in end.messages:
                    self.assert_failed(end, "interrupted")
                    self.assertFalse((out / "run.lock").exists())
                elif end.code == FAILED:
                    self.assert_failed(end, "interrupted at time")
                    self.assert_sound(out)
                    interrupted += 1
                command = ["resume", out] if (out / "checkpoint.hbc").exists() else ["run", "gas.toml", "--out", out]
                process = start([*command, "--quiet"], self.folder)
            self.assert_undisturbed(out)
        self.assertGreater(interrupted, 3)


class Outside(FaultTest):
    def test_second_signal_ends_at_once(self):
        process = start(["run", "gas.toml", "--unit-costs", "standard", "--until", "1e6", "--quiet"], self.folder, stdout=subprocess.DEVNULL)
        time.sleep(0.2)
        for _ in range(2):
            process.send_signal(signal.SIGINT)
        self.assertIn(ended(process).code, (FAILED, -signal.SIGINT))

    def test_closed_streams(self):
        for closed in ([1], [2], [0], [0, 1, 2]):
            with self.subTest(closed):
                out = self.folder / f"closed_{''.join(map(str, closed))}"

                def close(closed=closed):
                    for descriptor in closed:
                        os.close(descriptor)

                end = run(["run", "gas.toml", "--out", out], self.folder, prepare=close)
                # No file may take the place of the stream, and be written into.
                self.assert_undisturbed(out)
                self.assertEqual(end.code, FAILED if 1 in closed else DONE, end)
                if closed == [1]:
                    self.assertTrue(end.messages.rstrip().endswith("cannot write to the standard output: Bad file descriptor"), end)

    def test_pipe_that_closes_early(self):
        out = self.folder / "pipe"
        reader, writer = os.pipe()
        process = start(["run", "gas.toml", "--out", out, "--quiet"], self.folder, stdout=writer)
        os.close(reader)
        os.close(writer)
        self.assert_failed(ended(process), "standard output: Broken pipe")
        self.assert_undisturbed(out)

    def test_memory_refused(self):
        refused = 0
        # With less the program cannot be loaded.
        for megabytes in (*range(40, 80, 2), 128):
            with self.subTest(megabytes):
                out = self.folder / f"memory_{megabytes}"
                end = run(["run", "gas.toml", "--set", "spheres.0.count=30000", "--set", "spheres.0.radius=0.02",
                           "--until", 0.05, "--out", out, "--quiet"], self.folder,
                          prepare=limited(resource.RLIMIT_AS, megabytes << 20))
                if end.code == DONE:
                    self.assert_sound(out)
                else:
                    self.assert_failed(end, "not enough memory")
                    refused += 1
                    if out.exists():
                        self.assert_sound(out)
        self.assertGreater(refused, 0)

    def test_memory_refused_to_what_asks_for_all(self):
        # A small file that asks for more than any machine has.
        end = run(["run", "gas.toml", "--set", "spheres.0.count=4000000000", "--set", "spheres.0.radius=1e-6",
                   "--quiet"], self.folder, prepare=limited(resource.RLIMIT_AS, 1 << 30))
        self.assertIn(end.code, (FAILED, BAD_INPUT), end)
        self.assert_one_line(end)

    def test_clock_that_jumps(self):
        # Whoever asks for the time of day gets times years apart, in both directions.
        out = self.folder / "clock"
        calls = self.folder / "clock_calls"
        end = run(["run", "gas.toml", "--out", out, "--quiet"], self.folder,
                  environment={"LD_PRELOAD": str(JUMPING_CLOCK), "JUMPING_CLOCK_CALLS": str(calls)})
        self.assertEqual(end.code, DONE, end)
        self.assert_undisturbed(out)
        self.assertGreater(len(calls.read_text()), 0, "the clock was not replaced")
        seconds = json.loads((out / "summary.json").read_text())["seconds"]
        self.assertTrue(0 <= seconds["setup"] < 60 and 0 <= seconds["run"] < 60, seconds)
        self.assertTrue((out / "checkpoint.hbc").exists())


if __name__ == "__main__":
    unittest.main()
