#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Tests bench/grid.py with engines that invent their numbers."""

import contextlib
import io
import json
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "bench"))

import grid  # noqa: E402

FAKE = [sys.executable, str(Path(__file__).with_name("fake_engine.py"))]
POINT = grid.Point(spheres=108, packing_fraction=0.25, equilibration=2, seed=7)


def fake(name, nanoseconds, *options):
    return grid.Engine(name, [*FAKE, str(nanoseconds), *options])


def measure(*engines, rounds=3, patience=30.0):
    # At 1000 ns per collision the first calibration slice, of 100 contacts, is already long enough.
    settings = grid.Settings(rounds=rounds, slice_seconds=2e-4, patience=patience)
    return grid.measure_point(POINT, engines, settings)


class MeasuredPoint(unittest.TestCase):
    def test_slices_last_as_long_as_asked_for(self):
        fast, slow = measure(fake("fast", 10), fake("slow", 1000))
        self.assertEqual(fast.contacts_per_slice, 20_000)
        self.assertEqual(slow.contacts_per_slice, 200)
        self.assertEqual([each["collisions"] for each in slow.slices], [200] * 3)

    def test_arguments_of_the_point_are_appended(self):
        (one,) = measure(fake("one", 1000))
        expected = "--spheres 108 --packing-fraction 0.25 --equilibration 2 --seed 7"
        self.assertEqual(" ".join(one.command[-8:]), expected)

    def test_median_and_spread(self):
        # The calibration takes the first slice; the rounds take two, three and four times 1000 ns.
        (one,) = measure(fake("one", 1000, "--uneven"))
        times = grid.nanoseconds(one)
        self.assertAlmostEqual(grid.median(times), 3000)
        self.assertAlmostEqual(grid.spread(times), 2 / 3)

    def test_mean_is_of_all_rounds(self):
        one = grid.Measurement("one", [])
        one.slices = [{"collisions": n, "seconds": s} for n, s in ((100, 1e-7), (100, 1e-7), (300, 13e-7))]
        self.assertAlmostEqual(grid.median(grid.nanoseconds(one)), 1)
        self.assertAlmostEqual(grid.mean_nanoseconds(one), 3)

    def test_ratio_is_that_of_the_same_rounds(self):
        first, second = measure(fake("first", 1000, "--uneven"), fake("second", 1500))
        # 1500 over 2000, 3000 and 4000.
        self.assertAlmostEqual(grid.ratio(second, first), 0.5)

    def test_events_per_collision(self):
        (one,) = measure(fake("one", 1000))
        self.assertEqual(grid.count_per_collision(one, "enter"), 2)
        self.assertEqual(grid.count_per_collision(one, "predictions"), 64)
        # One rebuild in three slices of 200 collisions.
        self.assertAlmostEqual(grid.count_per_collision(one, "rebuilds"), 1 / 600)
        self.assertIsNone(grid.count_per_collision(one, "queue_operations"))
        self.assertEqual(grid.median_per_collision(one, "cycles"), 3)
        self.assertIsNone(grid.median_per_collision(one, "instructions"))


class FailingEngine(unittest.TestCase):
    def expect(self, message, fault):
        failing, other = measure(fake("failing", 1000, "--fault", fault), fake("other", 1000))
        self.assertIn(message, failing.failure)
        self.assertFalse(grid.is_complete(failing))
        self.assertTrue(grid.is_complete(other))
        report = grid.point_report(POINT, [failing, other])
        self.assertIn("failing failed: ", report)
        self.assertIn("over other", report)

    def test_at_the_start(self):
        self.expect("ended with exit code 1: there is no such density", "start")

    def test_not_ready(self):
        self.expect("said 'hello' instead of being ready", "ready")

    def test_in_a_round(self):
        self.expect("ended with exit code 1: inelastic collapse", "run")

    def test_no_json(self):
        self.expect("said 'done' instead of a JSON object", "text")

    def test_no_collisions(self):
        self.expect("reported collisions: 0 of 100 contacts", "nothing")

    def test_no_answer(self):
        # Alone: on a busy machine another might be as late.
        (failing,) = measure(fake("failing", 1000, "--fault", "silence"), patience=1)
        self.assertIn("gave no answer for 1 s", failing.failure)
        self.assertFalse(grid.is_complete(failing))

    def test_no_such_program(self):
        missing, other = measure(grid.Engine("missing", ["/no/such/engine"]), fake("other", 1000))
        self.assertIn("cannot be started", missing.failure)
        self.assertTrue(grid.is_complete(other))


class Table(unittest.TestCase):
    def test_cells(self):
        rows = grid.table(POINT, measure(fake("full", 1000), fake("bare", 2500, "--bare")))
        self.assertEqual(
            rows[0],
            ["engine", "nanoseconds", "spread", "mean", "enter", "stale", "predictions", "rebuilds"]
            + ["bytes per sphere", "cycles", "instructions", "over full"],
        )
        self.assertEqual(rows[1], "full 1000.0 0.0% 1000.0 2 0 64 0.00167 48.0 3 - 1.000".split())
        self.assertEqual(rows[2], "bare 2500.0 0.0% 2500.0 - - - - - - - 2.500".split())

    def test_markdown(self):
        lines = list(grid.markdown_table([["engine", "nanoseconds"], ["one", "12.5"]]))
        self.assertEqual(lines, ["| engine | nanoseconds |", "|---|---:|", "| one | 12.5 |"])

    def test_columns_are_aligned(self):
        lines = list(grid.plain_table([["engine", "ns"], ["a longer name", "12.5"]]))
        self.assertEqual(lines, ["engine           ns", "a longer name  12.5"])


class CommandLine(unittest.TestCase):
    def run_main(self, folder, out, nanoseconds, *options):
        """The exit code, the output, and the stored results; our own engine is a missing program."""
        printed = io.StringIO()
        command = f"fake={' '.join(FAKE)} {nanoseconds}"
        with contextlib.redirect_stdout(printed):
            code = grid.main(
                ["--program", "/no/such/engine", "--against", command, "--out", str(folder / out)]
                + ["--spheres", "108", "--packing-fractions", "0.1,0.2", "--rounds", "2", "--slice", "0.0002", *options]
            )
        return code, printed.getvalue(), json.loads((folder / out).read_text())

    def test_compare_with_stored_results(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            code, printed, stored = self.run_main(folder, "old.json", 1000)
            self.assertEqual(code, 0)
            self.assertNotIn("stored", printed)
            self.assertEqual([entry["point"]["packing_fraction"] for entry in stored["points"]], [0.1, 0.2])
            ours, other = stored["points"][0]["measurements"]
            self.assertIn("cannot be started", ours["failure"])
            self.assertEqual(len(other["slices"]), 2)
            self.assertLessEqual({"commit", "dirty", "date", "processor", "command", "settings"}, stored.keys())

            _, printed, _ = self.run_main(folder, "new.json", 750, "--compare", str(folder / "old.json"))
            self.assertIn("not interleaved", printed)
            ratios = [line.split()[-1] for line in printed.splitlines() if line.startswith("fake ")]
            self.assertEqual(ratios, ["0.750"] * 2)

    def test_a_point_without_any_measurement_is_a_failure(self):
        with tempfile.TemporaryDirectory() as name:
            code, printed, _ = self.run_main(Path(name), "out.json", "1000 --fault start")
            self.assertEqual(code, 1)
            self.assertIn("fake failed: ended with exit code 1", printed)

    def expect_refusal(self, message, *options):
        messages = io.StringIO()
        with contextlib.redirect_stderr(messages), self.assertRaises(SystemExit) as raised:
            grid.parse_arguments(options)
        self.assertEqual(raised.exception.code, 2)
        self.assertIn(message, messages.getvalue())

    def test_bad_arguments(self):
        self.expect_refusal("not of the form name=command line", "--against", "program")
        self.expect_refusal("two engines have the same name", "--against", "auto=program")
        self.expect_refusal("give at least 1", "--rounds", "0")
        self.expect_refusal("give a positive time", "--slice", "0")
        self.expect_refusal("cannot read", "--compare", "/no/such/file")
        self.expect_refusal("holds no results", "--compare", str(PROJECT / "CMakePresets.json"))


if __name__ == "__main__":
    unittest.main()
