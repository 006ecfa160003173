#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Tests that the program measured_engine speaks the protocol of bench/grid.py.

usage: measured_engine_test.py PROGRAM
"""

import json
import subprocess
import sys
import unittest

GAS = ["--spheres", "108", "--packing-fraction", "0.1", "--equilibration", "2"]


def converse(arguments, commands):
    """Exit code, lines printed, and error lines."""
    done = subprocess.run([PROGRAM, *arguments], input=commands, text=True, capture_output=True, timeout=60)
    return done.returncode, done.stdout.splitlines(), done.stderr.splitlines()


def history(commands, *options):
    """The hash of all contacts."""
    code, lines, _ = converse([*GAS, *options], commands + "finish\n")
    assert code == 0
    return json.loads(lines[-1])["event_log_hash"]


class MeasuredEngine(unittest.TestCase):
    def test_two_slices(self):
        code, lines, complaints = converse(GAS, "run 100\nrun 150\n")
        self.assertEqual((code, complaints, len(lines)), (0, [], 3))
        word, _, text = lines[0].partition(" ")
        self.assertEqual(word, "ready")
        ready = json.loads(text)
        self.assertEqual(ready["engine"], "cells")
        for key in ("cell_edge", "bytes_per_sphere", "peak_rss_bytes", "setup_seconds"):
            self.assertGreater(ready[key], 0, key)
        for line, contacts in zip(lines[1:], (100, 150)):
            report = json.loads(line)
            self.assertEqual(report["collisions"], contacts)
            self.assertEqual(report["counters"]["collision"], contacts)
            self.assertGreater(report["counters"]["predictions"], contacts)
            self.assertGreater(report["seconds"], 0)
            self.assertGreater(report["simulated_time"], 0)
            self.assertLessEqual({"cycles", "instructions"}, report.keys())

    def test_neither_slices_nor_engines_change_the_history(self):
        expected = history("run 250\n")
        self.assertRegex(expected, "^[0-9a-f]{16}$")
        self.assertEqual(history("run 100\nrun 150\n"), expected)
        for engine in ("cells", "all-pairs", "paper"):
            self.assertEqual(history("run 250\n", "--engine", engine), expected, engine)
        self.assertEqual(history("run 250\n", "--cell-edge", "2.5"), expected)
        self.assertNotEqual(history("run 251\n"), expected)
        self.assertNotEqual(history("run 250\n", "--seed", "8"), expected)

    def test_walls_count_as_contacts(self):
        _, lines, _ = converse([*GAS, "--boundary", "wall", "--placement", "random"], "run 200\n")
        report = json.loads(lines[1])
        self.assertGreater(report["counters"]["wall"], 0)
        self.assertEqual(report["collisions"] + report["counters"]["wall"], 200)

    def test_two_sizes(self):
        code, lines, _ = converse([*GAS, "--radius-ratio", "3"], "run 100\n")
        self.assertEqual((code, json.loads(lines[1])["collisions"]), (0, 100))

    def expect_refusal(self, message, arguments, commands=""):
        code, _, complaints = converse(arguments, commands)
        self.assertEqual((code, len(complaints)), (2, 1), complaints)
        self.assertIn(message, complaints[0])

    def test_bad_arguments(self):
        self.expect_refusal("--spheres is required", [])
        self.expect_refusal("--speed", [*GAS, "--speed", "3"])
        self.expect_refusal("--spheres", ["--spheres", "-5", "--packing-fraction", "0.1"])
        self.expect_refusal("--packing-fraction", ["--spheres", "108", "--packing-fraction", "0"])
        self.expect_refusal("--equilibration", [*GAS[:4], "--equilibration", "-1"])
        self.expect_refusal("auto, cells, neighbors, all-pairs, paper", [*GAS, "--engine", "oracle"])
        self.expect_refusal("random, fcc, hexagonal", [*GAS, "--placement", "anywhere"])
        self.expect_refusal("periodic, wall", [*GAS, "--boundary", "open"])
        self.expect_refusal("cell edge", [*GAS, "--cell-edge", "-1"])

    def test_bad_commands(self):
        self.expect_refusal("'stop'", GAS, "stop\n")
        self.expect_refusal("'0'", GAS, "run 0\n")
        self.expect_refusal("'5 spheres'", GAS, "run 5 spheres\n")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    PROGRAM = sys.argv.pop(1)
    unittest.main()
