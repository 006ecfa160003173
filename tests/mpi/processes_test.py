#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

"""Runs scenarios in several processes, and compares hashes and files with those of one, bit by bit.

usage: processes_test.py PROGRAM
"""

import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from mpirun import ENVIRONMENT, MPIRUN, can_start_processes

PROGRAM = str(Path(sys.argv[1]).resolve())

GAS = """
[box]
size = [30.0, 25.0, 30.0]
boundary = ["periodic", "wall", "periodic"]
[[spheres]]
count = 4000
radius = 0.5
placement = "fcc"
temperature = 1.0
[run]
until = 3.0
[output]
snapshots_every = 0.5
event_log = true
"""
PERIODIC = 'box.boundary=["periodic", "periodic", "periodic"]'
# Species of several sizes, spins, walls, gravity: what domains must hand on.
MIXTURE = """
[box]
size = [20.0, 20.0, 30.0]
boundary = ["periodic", "periodic", "wall"]
gravity = [0.0, 0.0, -0.5]
[[species]]
name = "large"
[[species]]
name = "small"
[[spheres]]
species = "large"
count = 200
radius = 0.8
placement = "random"
mean_speed = 1.0
[[spheres]]
species = "small"
count = 2000
radius = 0.3
placement = "random"
mean_speed = 1.0
[response]
restitution = 0.9
tangential_restitution = 0.3
[run]
until = 2.0
[output]
snapshots_every = 1.0
trajectory = ["lammps", "xyz.zst"]
event_log = true
"""

HEAP = """
[box]
size = [12.0, 12.0, 12.0]
boundary = ["periodic", "periodic", "wall"]
gravity = [0.0, 0.0, -1.0]
[[spheres]]
count = 200
radius = 0.5
placement = "random"
temperature = 0.5
[response]
restitution = 0.5
[run]
until = 40.0
[output]
snapshots_every = 10.0
event_log = true
[measures]
names = []
"""


def run(arguments, processes=None, succeeds=True):
    command = (MPIRUN + ["-n", str(processes)] if processes else []) + [PROGRAM] + arguments
    done = subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, timeout=240)
    if succeeds and done.returncode != 0:
        raise AssertionError(f"{command}: {done.stderr}")
    return done


class FolderTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def expect_one_message(self, done, *parts):
        """However many processes there are."""
        self.assertNotEqual(done.returncode, 0)
        messages = [line for line in done.stderr.splitlines() if line.startswith("hardball: ")]
        self.assertEqual(len(messages), 1, done.stderr)
        for part in parts:
            self.assertIn(part, messages[0])


class Processes(FolderTest):
    def scenario(self, text):
        path = self.folder / "scenario.toml"
        path.write_text(text)
        return str(path)

    def run_alone(self, scenario, *options):
        run(["run", scenario, "--out", str(self.folder / "alone"), "--quiet", "--overwrite", *options])
        return self.folder / "alone"

    def run_in(self, scenario, way):
        """Runs and resumes a scenario: (number of processes, options) for each stretch; None is one without mpirun."""
        directory = self.folder / "several"
        start = ["run", scenario, "--out", str(directory), "--overwrite", "--quiet"]
        for processes, *options in way:
            run([*start, *options], processes)
            start = ["resume", str(directory)]
        return directory

    def expect_same(self, directory, expected):
        self.assertEqual(*(sorted(path.name for path in each.glob("measures/*")) for each in (directory, expected)))
        for path in expected.rglob("*"):
            if path.suffix in (".npy", ".xyz", ".lammpstrj", ".zst", ".gsd", ".vtp", ".pvd", ".hbr", ".csv"):
                name = path.relative_to(expected)
                self.assertEqual((directory / name).read_bytes(), path.read_bytes(), name)
        self.assertTrue((directory / "report.html").exists())
        own, alone = (json.loads((each / "summary.json").read_text()) for each in (directory, expected))
        for key in ("spheres", "time", "event_log_hash", "energy", "momentum", "packing_fraction", "walls",
                    "compressibility", "wall_pressure", "max_overlap", "species", "thermostat", "at_rest_since"):
            self.assertEqual(own.get(key), alone.get(key), key)
        for key in ("collision", "wall"):
            self.assertEqual(own["events"][key], alone["events"][key])

    def expect_as_alone(self, text, *ways):
        """The files and the summary are those of one process, whichever way the scenario is run; returns them."""
        scenario = self.scenario(text)
        expected = self.run_alone(scenario)
        for way in ways:
            with self.subTest(way=way):
                self.expect_same(self.run_in(scenario, way), expected)
        return expected

    def test_files_and_hash_are_those_of_one_process(self):
        for text in (GAS, MIXTURE):
            self.expect_as_alone(text, [(2, "--threads", "1")], [(3, "--threads", "2")], [(5, "--threads", "1")])

    def test_a_heap_comes_to_rest_as_in_one_process(self):
        expected = self.expect_as_alone(HEAP, [(3,)])
        self.assertLess(json.loads((expected / "summary.json").read_text())["at_rest_since"], 30)

    def test_measures_are_those_of_one_process(self):
        of_gas = '["pressure", "collision_rate", "radial_distribution", "mean_square_displacement"]'
        of_mixture = '["all", "diffusion"]'
        half = ("--until", "1", "--set", "run.until=1")
        for text, names, end in ((GAS, of_gas, "3"), (MIXTURE, of_mixture, "2")):
            # The first process holds all spheres again, or for the first time.
            halves = ([(first, *half), (second, "--until", end)] for first, second in ((3, 2), (None, 2), (2, None)))
            expected = self.expect_as_alone(text + f"[measures]\nnames = {names}\nevery = 0.07\nfrom = 0.1\n",
                                            [(3, "--threads", "2")], *halves)
            self.assertGreater(len(list((expected / "measures").iterdir())), 1)

    def test_any_number_of_processes_resumes(self):
        """With the measures by default, too."""
        self.expect_as_alone(
            GAS, *([(first, "--until", "1"), (second, "--until", "3")]
                   for first, second in ((None, 3), (3, None), (2, 3))),
            [(3, "--until", "1", "--set", "run.until=1"), (2, "--until", "1.5"), (None, "--until", "2"),
             (4, "--until", "3", "--threads", "2")])

    def test_spheres_grow_and_thermostats_act_as_in_one_process(self):
        for more in ("[growth]\nrate = 0.02\npacking_fraction = 0.2\n",
                     *(f"[thermostat]\nkind = {kind}\ntemperature = 2.0\n"
                       '[measures]\nnames = ["pressure", "temperature"]\n'
                       for kind in ('"rescale"\nevery = 0.3', '"andersen"\nrate = 0.05'))):
            self.expect_as_alone(GAS + more, [(3,)],
                                 [(2, "--until", "1"), (None, "--until", "2"), (3, "--until", "3")])

    def test_files_that_need_all_spheres_are_those_of_one_process(self):
        files = 'trajectory = ["vtp", "lammps", "gsd"]\nrecording = true\n'
        thermostat = '[thermostat]\nkind = "andersen"\nrate = 0.05\ntemperature = 2.0\n'
        for text in (GAS + files + thermostat, MIXTURE.replace('trajectory = ["lammps", "xyz.zst"]\n', files)):
            scenario = self.scenario(text)
            expected = self.run_alone(scenario, "--until", "1.2")
            run(["resume", str(expected), "--until", "2"])
            self.expect_same(self.run_in(scenario, [(3, "--until", "1.2"), (2, "--until", "2")]), expected)

    def test_a_killed_process_ends_the_run_which_others_resume(self):
        scenario = self.scenario(GAS)
        longer = ["--until", "60", "--set", "output.checkpoint_every=0.2"]
        expected = self.run_alone(scenario, *longer)
        directory = self.folder / "killed"
        started = subprocess.Popen(MPIRUN + ["-n", "3", PROGRAM, "run", scenario, "--out", str(directory), *longer,
                                             "--quiet"], env=ENVIRONMENT, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        checkpoint = directory / "checkpoint.hbc"
        while not checkpoint.exists() and started.poll() is None:
            time.sleep(0.01)
        first = checkpoint.stat().st_mtime_ns
        while started.poll() is None and checkpoint.stat().st_mtime_ns == first:
            time.sleep(0.01)
        self.assertIsNone(started.poll(), "the run ended before it could be killed")
        children = Path(f"/proc/{started.pid}/task/{started.pid}/children").read_text().split()
        os.kill(int(children[1]), signal.SIGKILL)
        self.assertNotEqual(started.wait(timeout=60), 0)
        self.assertFalse((directory / "summary.json").exists())
        run(["resume", str(directory)], 2)
        self.expect_same(directory, expected)

    def test_what_processes_cannot_share_is_refused(self):
        scenario = self.scenario(GAS)
        for change, name in (("response.kind=\"merge\"", "spheres that merge"), ("box.shear_rate=0.1", "sheared")):
            done = run(["run", scenario, "--out", str(self.folder / "refused"), "--set", change, "--set", PERIODIC],
                       2, succeeds=False)
            self.expect_one_message(done, name)
            self.assertFalse((self.folder / "refused").exists())
        done = run(["check", scenario], 2, succeeds=False)
        self.assertIn("several processes", done.stderr)

    def test_one_process_is_as_without_mpirun(self):
        scenario = self.scenario(GAS)
        directory = self.folder / "one"
        run(["run", scenario, "--out", str(directory), "--until", "0.2", "--set", "box.shear_rate=0.1",
             "--set", PERIODIC], 1)
        self.assertTrue((directory / "report.html").exists())

    def test_what_is_not_there_cannot_be_resumed(self):
        done = run(["resume", str(self.folder / "nothing")], 2, succeeds=False)
        self.assertIn("there is no checkpoint", done.stderr)
        scenario = self.scenario(GAS)
        directory = self.folder / "robbed"
        run(["run", scenario, "--out", str(directory), "--until", "0.2"], 2)
        (directory / "events.npy").unlink()
        done = run(["resume", str(directory), "--until", "0.3"], 2, succeeds=False)
        self.assertIn("events.npy: the file that the run continues is gone", done.stderr)

    def test_a_file_that_cannot_be_written_ends_all(self):
        scenario = self.scenario(GAS)
        directory = self.folder / "full"
        directory.mkdir()
        (directory / "events.npy").symlink_to("/dev/full")
        done = run(["run", scenario, "--out", str(directory), "--quiet", "--until", "20"], 2, succeeds=False)
        self.expect_one_message(done, "cannot write")

    def test_overlaps_at_the_start_are_refused_once(self):
        scenario = self.scenario(GAS.replace('count = 4000\n', "").replace('placement = "fcc"\n', "").replace(
            "temperature = 1.0", "positions = [[1.0, 1.0, 1.0], [1.5, 1.0, 1.0]]\n"
            "velocities = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]"))
        done = run(["run", scenario], 2, succeeds=False)
        self.expect_one_message(done, "overlap")


class Machines(FolderTest):
    """Processes that do not share their files, or their command lines."""

    def setUp(self):
        super().setUp()
        # Each process runs in a directory of its own.
        self.wrapper = self.folder / "on_its_machine"
        self.wrapper.write_text('#!/bin/sh\ncd "$(dirname "$0")/machine_$OMPI_COMM_WORLD_RANK" && exec "$@"\n')
        self.wrapper.chmod(0o755)
        for process in range(3):
            (self.folder / f"machine_{process}").mkdir()
            (self.folder / f"machine_{process}" / "gas.toml").write_text(GAS)

    def start(self, *arguments):
        return subprocess.run(MPIRUN + ["-n", "3", str(self.wrapper), PROGRAM, *arguments], env=ENVIRONMENT,
                              capture_output=True, text=True, timeout=120)

    def expect_refused(self, *parts, arguments=("run", "gas.toml", "--quiet")):
        done = self.start(*arguments)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.expect_one_message(done, *parts)

    def test_the_same_files_on_all_are_run(self):
        self.assertEqual(self.start("run", "gas.toml", "--quiet").returncode, 0)

    def test_another_scenario_is_refused(self):
        path = self.folder / "machine_2" / "gas.toml"
        for old, new in (("count = 4000", "count = 4001"), ("temperature = 1.0", "temperature = 1.000001"),
                         ("until = 3.0", "until = 2.0")):
            path.write_text(GAS.replace(old, new))
            self.expect_refused("process 2 has another scenario than process 0", "common file system")

    def test_a_missing_scenario_is_refused(self):
        for process in (0, 1, 2):
            path = self.folder / f"machine_{process}" / "gas.toml"
            path.rename(path.with_suffix(".away"))
            self.expect_refused("gas.toml: the file cannot be read")
            path.with_suffix(".away").rename(path)

    def test_another_command_line_is_refused(self):
        self.wrapper.write_text('#!/bin/sh\ncd "$(dirname "$0")/machine_0" && exec "$@" --until 1.$OMPI_COMM_WORLD_RANK\n')
        self.expect_refused("process 1 has another command line than process 0")

    def test_another_start_file_is_refused(self):
        scenario = GAS[:GAS.index("[[spheres]]")] + '[start]\nfile = "start.xyz"\n' + GAS[GAS.index("[run]"):]
        for process in range(3):
            folder = self.folder / f"machine_{process}"
            (folder / "gas.toml").write_text(scenario)
            (folder / "start.xyz").write_text("2\nProperties=pos:R:3:velo:R:3:radius:R:1\n5 5 5 1 0 0 0.5\n"
                                              f"9 5 5 0 0.{process // 2} 0 0.5\n")
        self.expect_refused("process 2 has another start file")

    def test_another_checkpoint_is_refused(self):
        for process, until in ((0, "1"), (1, "1"), (2, "2")):
            folder = self.folder / f"machine_{process}"
            run(["run", str(folder / "gas.toml"), "--out", str(folder / "out"), "--until", until, "--quiet"])
        resume = ("resume", "out", "--until", "3", "--quiet")
        self.expect_refused("has another checkpoint than process 0", arguments=resume)
        (self.folder / "machine_1" / "out" / "checkpoint.hbc").unlink()
        self.expect_refused("there is no checkpoint", arguments=resume)

    def test_an_unknown_option_is_refused_once(self):
        self.expect_refused("--nonsense", arguments=("run", "gas.toml", "--nonsense"))


if __name__ == "__main__":
    if not can_start_processes():
        print("mpirun cannot start processes on this machine")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
