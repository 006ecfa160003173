# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Sweeps by several executors, with the tables of the program."""

import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from concurrent.futures import Future, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import numpy as np

import hardball
from support import program

SCENARIO = {
    "box": {"size": [6.0] * 3, "boundary": ["periodic"] * 3},
    "spheres": [{"count": 60, "radius": 0.5, "placement": "random", "temperature": 1.0}],
    "run": {"until": 10.0},
}
SWEEP = {"replicas": 3, "product": {"spheres.0.radius": [0.4, 0.5]}, "zip": {"run.until": [8, 10]}}
STUDY = {"scenario": SCENARIO, "seed": 7, "quantities": ["pressure.compressibility"], "sweep": SWEEP}


def pressure(simulation):
    """For another process: numbers with and without an error."""
    simulation.measure("pressure")
    simulation.run(until=5)
    return {"z": simulation.results()["pressure"]["compressibility"], "contacts": simulation.collisions}


def fails_at_large_radii(simulation):
    if simulation.radii[0] > 0.45:
        raise ValueError("too large")
    return {"one": 1.0, "two": (2.0, 0.5)}


class LastFirst:
    """An executor that has nothing but submit, and calls functions in the opposite order."""

    def __init__(self):
        self.tasks = []

    def submit(self, function, *arguments):
        future = Future()
        self.tasks.append((future, function, arguments))
        executor = self

        class Result:
            def result(self):
                while executor.tasks:
                    its_future, its_function, its_arguments = executor.tasks.pop()
                    its_future.set_result(its_function(*its_arguments))
                return future.result()

        return Result()


class Sweeps(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)

    def tables(self, folder):
        return [Path(folder, name).read_text() for name in ("runs.csv", "points.csv")]

    def test_all_executors_give_the_tables_of_the_program(self):
        Path("gas.toml").write_text(
            '[box]\nsize = [6.0, 6.0, 6.0]\nboundary = ["periodic", "periodic", "periodic"]\n[[spheres]]\ncount = 60\n'
            'radius = 0.5\nplacement = "random"\ntemperature = 1.0\n[run]\nuntil = 10.0\n'
        )
        Path("study.toml").write_text(
            'scenario = "gas.toml"\nseed = 7\nquantities = ["pressure.compressibility"]\n[sweep]\nreplicas = 3\n'
            '[sweep.product]\n"spheres.0.radius" = [0.4, 0.5]\n[sweep.zip]\n"run.until" = [8, 10]\n'
        )
        program("sweep", "study.toml", "--out", "program", "--quiet")
        with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool, ThreadPoolExecutor(3) as threads:
            for name, executor in {"own": None, "pool": pool, "threads": threads, "reverse": LastFirst()}.items():
                with self.subTest(name):
                    found = hardball.sweep("study.toml", executor=executor, out=name)
                    self.assertEqual(self.tables(name), self.tables("program"))
                    self.assertEqual(list(found.points["runs"]), [3] * 4)
        # A dict gives the same numbers.
        found = hardball.sweep(STUDY, out="dict", workers=1)
        self.assertEqual(self.tables("dict"), self.tables("program"))
        rows = [row.split(",") for row in Path("program/points.csv").read_text().splitlines()]
        for number, name in enumerate(rows[0]):
            np.testing.assert_array_equal(found.points[name], [float(row[number]) for row in rows[1:]], name)
        self.assertEqual(repr(found), f"<hardball.Sweep {Path('dict').resolve()}: 12 of 12 members finished>")
        self.assertEqual((found.runs["status"] == "finished").sum(), 12)
        self.assertEqual(found.failed, {})
        self.assertEqual(found.points.dtype.names[:3], ("spheres.0.radius", "run.until", "runs"))

    def test_a_function_takes_the_place_of_the_run(self):
        study = {"scenario": SCENARIO, "sweep": SWEEP}
        with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
            found = hardball.sweep(study, out="out", executor=pool, function=pressure)
        self.assertEqual(found.points.dtype.names[3:], tuple(
            name + ending for name in ("z", "contacts") for ending in ("", "_error_between", "_error_within", "_error_ratio")
        ))
        run = found.runs[4]
        simulation = hardball.Simulation.from_scenario(
            SCENARIO,
            overrides={"spheres.0.radius": float(run["spheres.0.radius"]), "run.until": int(run["run.until"]), "run.seed": int(run["seed"])},
        )
        expected = pressure(simulation)
        self.assertEqual((run["z"], run["z_error"]), (expected["z"].value, expected["z"].error))
        self.assertEqual(run["contacts"], expected["contacts"])
        self.assertTrue(np.isnan(run["contacts_error"]))
        again = hardball.sweep(study, out="out", function=fails_at_large_radii)
        self.assertEqual(again.points.tobytes(), found.points.tobytes())

    def test_members_that_fail_are_named_and_repeated_if_wanted(self):
        study = {"scenario": SCENARIO, "sweep": {"product": {"spheres.0.radius": [0.4, 0.5]}}}
        found = hardball.sweep(study, out="out", function=fails_at_large_radii)
        self.assertEqual(list(found.failed), ["0002"])
        self.assertIn("ValueError: too large", found.failed["0002"])
        self.assertEqual(list(found.points["two"])[:1], [2.0])
        self.assertTrue(np.isnan(found.points["two"][1]))
        self.assertEqual(list(hardball.sweep(study, out="out", function=pressure).failed), ["0002"])
        self.assertEqual(hardball.sweep(study, out="out", function=pressure, retry=True).failed, {})

    def test_ctrl_c_writes_checkpoints(self):
        study = {
            "scenario": {**SCENARIO, "run": {"until": 1000.0}},
            "quantities": ["pressure.compressibility"],
            "sweep": {"replicas": 2},
        }
        script = f"import hardball\nhardball.sweep({study!r}, out='out')"
        process = subprocess.Popen([sys.executable, "-c", script], stderr=subprocess.PIPE, text=True)
        for _ in range(20000):
            if len(list(Path().glob("out/*/checkpoint.hbc"))) == 2:
                break
            time.sleep(0.001)
        time.sleep(0.1)
        process.send_signal(signal.SIGINT)
        self.assertIn("KeyboardInterrupt", process.communicate(timeout=60)[1])
        summaries = [json.loads(path.read_text()) for path in Path().glob("out/*/summary.json")]
        self.assertEqual(len(summaries), 2)
        self.assertTrue(all(0 < summary["time"] < 1000 for summary in summaries))
        hardball.sweep(study, out="out")
        hardball.sweep(study, out="undisturbed")
        self.assertEqual(self.tables("out"), self.tables("undisturbed"))

    def test_plot_draws_the_quantities(self):
        try:
            from matplotlib.figure import Figure
        except ImportError:
            self.skipTest("matplotlib is not installed")
        found = hardball.sweep(STUDY, out="out")
        figure = hardball.plot(found)
        self.assertIsInstance(figure, Figure)
        (axes,) = figure.axes
        self.assertEqual((axes.get_xlabel(), axes.get_title()), ("spheres.0.radius", "pressure.compressibility"))
        self.assertEqual([text.get_text() for text in axes.get_legend().get_texts()], ["run.until = 8", "run.until = 10"])
        single = hardball.sweep({"scenario": SCENARIO, "sweep": {}}, out="single")
        with self.assertRaisesRegex(hardball.Error, "several numbers for a key"):
            hardball.plot(single)

    def test_what_is_no_study_is_refused(self):
        for study, options, message in (
            (STUDY, {}, "out: it is missing"),
            (STUDY, {"out": "out", "workers": 0}, "workers: it is 0"),
            (STUDY, {"out": "out", "workers": 2, "executor": LastFirst()}, "or an executor instead"),
            (STUDY, {"out": "out", "function": 3}, "function: it is 3"),
            ({"scenario": SCENARIO}, {"out": "out"}, "table \\[sweep\\] is missing"),
            ({**STUDY, "sweep": {"product": {"spheres.0.radius": [90]}}}, {"out": "out"}, "member 0001, spheres.0.radius = 90"),
            ("nowhere.toml", {}, "nowhere.toml"),
        ):
            with self.subTest(message), self.assertRaisesRegex(hardball.Error, message):
                hardball.sweep(study, **options)
        self.assertFalse(Path("out").exists())


if __name__ == "__main__":
    unittest.main()
