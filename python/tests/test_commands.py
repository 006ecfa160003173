# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""What the commands of the program do, plots, and what makes or changes a simulation in one line."""

import dataclasses
import importlib.util
import inspect
import os
import pickle
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import numpy as np

import hardball
from support import SCENARIOS, gas, lattice, program

CRADLE = SCENARIOS / "newtons_cradle.toml"
SCENARIO = {
    "box": {"packing_fraction": 0.2, "boundary": ["periodic"] * 3},
    "spheres": [{"count": 100, "radius": 0.5, "placement": "random", "temperature": 1.0}],
    "run": {"until": 0.5, "seed": 3},
}


def advanced(simulation):
    """For another process."""
    simulation.run(until=1)
    return simulation


class Program(unittest.TestCase):
    def run_module(self, *arguments, **options):
        command = [sys.executable, "-B", "-m", "hardball", *arguments]
        return subprocess.run(command, capture_output=True, text=True, **options)

    def test_the_module_runs_the_program(self):
        done = self.run_module("--version")
        self.assertEqual((done.returncode, done.stdout), (0, program("--version")))
        done = self.run_module("run", "lost.toml")
        self.assertEqual(done.returncode, 2)
        self.assertIn("lost.toml", done.stderr)

    def test_without_the_program_the_module_says_where_it_is_to_be_had(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(Path(hardball.__file__).parent, Path(folder) / "hardball")
            done = self.run_module("--version", cwd=folder, env={**os.environ, "PYTHONPATH": folder})
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"not installed with the package in {folder}/hardball: install the package with pip", done.stderr)

    def test_the_scenarios_come_with_the_package(self):
        names = {file.name for file in hardball.scenarios().iterdir()}
        self.assertEqual(names, {file.name for file in SCENARIOS.iterdir()})
        self.assertIn("scenario.schema.json", names)
        self.assertEqual(hardball.check(hardball.scenarios() / "newtons_cradle.toml")["spheres"], 6)


class Commands(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)

    def test_check_says_what_the_program_says(self):
        found = hardball.check(CRADLE)

        def stable(text):
            return [line for line in text.splitlines() if "time on one core" not in line]

        self.assertEqual(stable(str(found)), stable(program("check", "--quiet", CRADLE)))
        self.assertEqual(found["until"], hardball.Simulation.from_scenario(CRADLE).until)
        self.assertIsInstance(found["spheres"], int)
        changed = hardball.check(SCENARIO, overrides={"spheres.0.count": 50}, until=3, engine="all-pairs")
        self.assertEqual((changed["spheres"], changed["until"], changed["engine"]), (50, 3, "all-pairs"))
        self.assertEqual(changed.notes, [])
        with self.assertRaisesRegex(hardball.Error, "key 'until' is missing"):
            hardball.check({key: value for key, value in SCENARIO.items() if key != "run"})
        with self.assertRaisesRegex(hardball.Error, "--engine"):
            hardball.check(SCENARIO, engine="none")

    def test_verify_compares_all_engines(self):
        runs = hardball.verify(SCENARIO)
        self.assertTrue(runs)
        hashes = {run.event_log_hash for run in runs if not run.skipped}
        simulation = hardball.Simulation.from_scenario(SCENARIO)
        simulation.run()
        self.assertEqual(hashes, {simulation.event_log_hash})
        self.assertLessEqual({"cells", "paper", "all-pairs"}, {run.name for run in runs})
        self.assertIn("are the same", repr(runs))
        different = hardball.Verification([runs[0], dataclasses.replace(runs[1], is_same=False)])
        self.assertFalse(different)
        self.assertIn("DIFFER", repr(different))

    def test_tune_compares_cells(self):
        found = hardball.tune(SCENARIO, until=5, budget=0.3, unit_costs="standard", out="tuned")
        self.assertTrue(np.all(np.diff(found.cell_edge) > 0))
        self.assertTrue(np.all((found.least <= found.measured) & (found.measured <= found.most)))
        self.assertIn(found.best, found.cell_edge)
        self.assertIn("auto chooses", str(found))
        self.assertTrue(Path("tuned/tune.svg").exists())
        with self.assertRaisesRegex(hardball.Error, "--budget"):
            hardball.tune(SCENARIO, budget=0)

    def test_convert_and_info(self):
        simulation = gas()
        for time in (0, 0.5):
            simulation.run(until=time)
            simulation.write("a.xyz", append=True)
        self.assertEqual(hardball.convert("a.xyz", "a.gsd"), 2)
        np.testing.assert_array_equal(hardball.read("a.gsd")[1].velocities, simulation.velocities)
        self.assertEqual(hardball.convert("a.xyz", "a.csv", frame=0), 1)
        with self.assertRaisesRegex(hardball.Error, "the file exists already"):
            hardball.convert("a.xyz", "a.csv")
        self.assertEqual(hardball.convert("a.xyz", "a.csv", overwrite=True), 1)
        np.testing.assert_array_equal(hardball.read("a.csv")[0].positions, simulation.positions)
        with self.assertRaisesRegex(hardball.Error, "there is no frame 7"):
            hardball.convert("a.xyz", "b.csv", frame=7)
        self.assertFalse(Path("b.csv").exists())
        for name in ("a.xyz", CRADLE):
            self.assertEqual(hardball.info(name), program("info", name).rstrip("\n"))

    def test_an_interruption_ends_what_takes_long(self):
        for call in (lambda: hardball.tune(SCENARIO, until=1e9, budget=300), lambda: hardball.verify(SCENARIO, until=1e9)):
            begin = time.monotonic()
            timer = threading.Timer(1, lambda: os.kill(os.getpid(), signal.SIGINT))
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                call()
            timer.join()
            self.assertLess(time.monotonic() - begin, 60)

    def test_calls_are_described(self):
        for function in (hardball.check, hardball.read, hardball.plot, hardball.Simulation.output, hardball.Simulation.gas):
            self.assertTrue(inspect.signature(function).parameters)
        with self.assertRaisesRegex(hardball.Error, r"unknown argument budgte=; did you mean budget=\?"):
            hardball.tune(SCENARIO, budgte=1)


class Shortcuts(unittest.TestCase):
    def test_a_box_is_made_for_a_gas(self):
        for dimensions, expected in ((3, np.pi / 6), (2, np.pi / 4)):
            dense = hardball.Simulation.gas(200, packing_fraction=0.3, dimensions=dimensions, seed=4)
            self.assertAlmostEqual(dense.packing_fraction, 0.3)
            self.assertEqual(dense.box.dimensions, dimensions)
            given = hardball.Simulation.gas(200, density=0.5, dimensions=dimensions, boundary="wall", temperature=2)
            self.assertAlmostEqual(given.packing_fraction, 0.5 * expected)
            self.assertEqual(given.box.boundary[0], "wall")
        for wrong in ({}, {"density": 0.1, "packing_fraction": 0.1}, {"density": -1}, {"density": 0.1, "dimensions": 4}):
            with self.assertRaises(hardball.Error):
                hardball.Simulation.gas(10, **wrong)

    def test_attributes_are_assigned(self):
        simulation = gas()
        simulation.velocities = 2 * simulation.velocities
        np.testing.assert_array_equal(simulation.velocities, 2 * gas().velocities)
        simulation.velocities = [1, 0, 0]
        np.testing.assert_array_equal(simulation.velocities, np.tile([1.0, 0, 0], (125, 1)))
        with self.assertRaisesRegex(hardball.Error, "velocities: the array has the shape"):
            simulation.velocities = np.zeros((3, 3))
        simulation.thermostat = hardball.Heating(strength=1, every=0.1)
        self.assertEqual(repr(simulation.thermostat), "hardball.Heating(strength=1, every=0.1)")
        simulation.thermostat = None
        self.assertIsNone(simulation.thermostat)
        simulation.response = 0.5
        self.assertIn("Bounce(0.5)", repr(simulation.response))
        custom = lambda contact: contact.before
        simulation.response = custom
        self.assertIs(simulation.response, custom)
        simulation.response = hardball.ResponseTable(0.9, 0.8)
        self.assertIn("Bounce(0.9), hardball.Bounce(0.8)", repr(simulation.response))
        plane = hardball.Surface.plane([0, 0, 1], point=[0, 0, 0.2])
        walled = gas(surfaces=[plane], box=hardball.Box.walls(lattice()[1]))
        self.assertEqual([repr(each) for each in walled.surfaces], [repr(plane)])
        with self.assertRaisesRegex(AttributeError, "box is read-only"):
            simulation.box = hardball.Box.open()

    def test_velocities_are_assigned_in_the_order_of_ids(self):
        simulation = gas()
        simulation.remove([0, 5])
        given = np.random.default_rng(5).normal(size=(123, 3))
        simulation.velocities = given
        np.testing.assert_array_equal(simulation.velocities, given)

    def test_arrays_of_all_kinds_are_velocities(self):
        for velocity in ([1.0, 2.0, 3.0], (1.0, 2.0, 3.0), [1, 2, 3], np.array([1.0, 2, 3]), np.array([1, 2, 3]),
                         np.array([1.0, 0, 2, 0, 3, 0])[::2], np.array([1, 2, 3], dtype=np.float32)):
            simulation = gas()
            simulation.set_velocity(3, velocity)
            np.testing.assert_array_equal(simulation.velocities[3], [1, 2, 3])
        for wrong in ([1.0, 2.0], [1.0, 2.0, 3.0, 4.0], "abc", np.ma.masked_equal([1.0, 2.0, 3.0], 2.0)):
            with self.assertRaises(hardball.Error):
                gas().set_velocity(3, wrong)
        for wrong in (-1, 125, 2**40, True, 0.5):
            with self.subTest(wrong), self.assertRaises(hardball.Error):
                gas().set_velocity(wrong, [1.0, 2.0, 3.0])

    def test_processes_of_a_pool_run_simulations(self):
        with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
            results = list(pool.map(advanced, [gas(seed) for seed in (1, 2)]))
        for seed, result in zip((1, 2), results):
            self.assertEqual(result.event_log_hash, advanced(gas(seed)).event_log_hash)
        self.assertEqual(pickle.loads(pickle.dumps(gas())).time, 0)


@unittest.skipUnless(importlib.util.find_spec("matplotlib"), "matplotlib is not installed")
class Plots(unittest.TestCase):
    def test_all_measures_are_drawn(self):
        simulation = gas()
        simulation.measure("all")
        simulation.run(until=10)
        results = simulation.results()
        figure = hardball.plot(results)
        titles = [axes.get_title() for axes in figure.axes]
        self.assertGreaterEqual(len(figure.axes), 5)
        self.assertTrue(all(axes.get_xlabel() and axes.get_ylabel() for axes in figure.axes), titles)
        with tempfile.TemporaryDirectory() as folder:
            figure.savefig(Path(folder) / "all.png")
            self.assertTrue((Path(folder) / "all.png").read_bytes().startswith(b"\x89PNG"))
        one = hardball.plot(results["radial_distribution"])
        self.assertTrue(any("distance" in axes.get_xlabel() for axes in one.axes))
        with self.assertRaisesRegex(hardball.Error, "no functions to draw"):
            hardball.plot({})


if __name__ == "__main__":
    unittest.main()
