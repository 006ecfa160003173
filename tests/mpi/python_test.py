#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

"""Shares simulations of the Python package among several processes, and compares them with those of one, bit by bit.

usage: python_test.py PROGRAM
"""

import importlib.util
import json
import shutil
import subprocess
import sys
import tempfile
import textwrap
import time
import unittest
from pathlib import Path

from mpirun import ENVIRONMENT, MPIRUN, can_start_processes

PROGRAM = str(Path(sys.argv[1]).resolve())

# Each process writes what `shown` is.
SETTING = """
import copy, hashlib, json, os, pickle, signal, sys, threading
import numpy as np
import hardball

processes = hardball.mpi_processes()
shown = {}

def gas(**options):
    places = np.stack(np.meshgrid(*[np.arange(9) * 1.5 + 0.75] * 3), axis=-1).reshape(-1, 3)
    arguments = {"positions": places, "velocities": np.random.default_rng(1).normal(size=places.shape), "radius": 0.5,
                 "processes": processes, **options}
    box = arguments.pop("box", hardball.Box(("periodic", "wall", "periodic"), [13.5] * 3))
    return hardball.Simulation(box, **arguments)

def state_of(simulation):
    return [simulation.event_log_hash, simulation.time, simulation.positions.tolist(), simulation.velocities.tolist()]

def hash_of(name):
    with open(name, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()

def error_of(call, kind=hardball.Error):
    try:
        call()
    except kind as error:
        return str(error)
"""
SHOW = "\nwith open(f'shown_{processes.rank}.json', 'w') as file:\n    json.dump(shown, file)\n"


class Processes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def start(self, script, processes):
        path = self.folder / "script.py"
        path.write_text(SETTING + textwrap.dedent(script) + SHOW)
        command = [*(MPIRUN + ["-n", str(processes)] if processes else []), sys.executable, "-B", str(path)]
        return subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, timeout=240, cwd=self.folder)

    def shown(self, script, processes):
        """What each of so many processes shows, by rank."""
        done = self.start(script, processes)
        self.assertEqual(done.returncode, 0, done.stderr)
        files = [self.folder / f"shown_{rank}.json" for rank in range(processes or 1)]
        shown = [json.loads(file.read_text()) for file in files]
        for file in files:
            file.unlink()
        return shown

    def expect_the_same(self, script, of_first=()):
        """In any number of processes, but for what only the first one shows."""
        alone = self.shown(script, None)[0]
        self.assertTrue(alone)
        of_others = {name: value for name, value in alone.items() if name not in of_first}
        for processes in (1, 2, 3):
            first, *others = self.shown(script, processes)
            self.assertEqual(first, alone)
            for each in others:
                self.assertEqual(each, of_others)

    def expect_the_end_of_all(self, script, message):
        begin = time.monotonic()
        done = self.start(script, 3)
        self.assertLess(time.monotonic() - begin, 30)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(message, done.stderr)

    def test_have_ranks(self):
        script = 'shown["own"] = [processes.rank, processes.size, repr(processes), hardball.mpi_processes() is processes]'
        for count in (None, 1, 2, 3):
            size = count or 1
            expected = [{"own": [rank, size, f"<hardball.Processes: this is {rank} of {size}>", True]} for rank in range(size)]
            self.assertEqual(self.shown(script, count), expected)

    def test_are_refused_without_a_plugin(self):
        package = self.folder / "alone" / "hardball"
        built = Path(importlib.util.find_spec("hardball").origin).parent
        shutil.copytree(built, package, ignore=shutil.ignore_patterns("hardball_mpi*", "__pycache__"))
        environment = {**ENVIRONMENT, "PYTHONPATH": str(package.parent), "OMPI_COMM_WORLD_SIZE": "2"}
        done = subprocess.run([sys.executable, "-B", "-c", "import hardball; hardball.mpi_processes()"], env=environment,
                              capture_output=True, text=True, cwd=self.folder)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("hardball.Error: OMPI_COMM_WORLD_SIZE: mpirun has started 2 copies", done.stderr)
        self.assertIn("run ./dev python, which installs Open MPI", done.stderr)

    def test_share_a_simulation(self):
        self.expect_the_same("""
            simulation = gas(thermostat=hardball.Andersen(1.2, rate=0.5), seed=3)
            contacts = []
            def listen(contact):
                contacts.append([contact.time, contact.first, contact.second])
                if len(contacts) == 50:
                    simulation.set_velocity(7, [0.5, 0.25, 0.125])
                if len(contacts) % 100 == 0:
                    contacts.append(simulation.positions[contact.first].tolist())
            simulation.on_contact(listen)
            simulation.run(until=0.5)
            simulation.on_contact(None)
            simulation.measure()
            shown["count"] = simulation.run(until=2)
            shown["results"] = {name: {key: [repr(quantity.value), repr(quantity.error)]
                                       for key, quantity in measurement.quantities.items()}
                                for name, measurement in simulation.results().items()}
            simulation.measure([])
            simulation.remove(3)
            simulation.threads = 2
            simulation.run(contacts=200)
            simulation.threads = 1
            shown["next"] = repr(simulation.next_event())
            shown["never"] = repr(simulation.next_event(simulation.time + 1e-9))
            shown["soon"] = [contact.time for contact in simulation.contacts_within(0.1)]
            shown["later"] = simulation.positions_at(simulation.next_event().time).tolist()
            recorded = simulation.run(contacts=300, record=True)
            shown["recorded"] = {name: recorded[name].tolist() for name in recorded.dtype.names}
            shown["steps"] = [contact.time for _, contact in zip(range(5), simulation.events())]
            shown["contacts"] = contacts
            shown["certificate"] = {key: repr(value) for key, value in simulation.certificate.items()}
            shown["state"] = state_of(simulation)
        """)

    def test_share_scenarios_and_saved_simulations(self):
        self.expect_the_same("""
            scenario = {"box": {"packing_fraction": 0.2, "boundary": ["periodic"] * 3},
                        "spheres": [{"count": 500, "radius": 0.5, "placement": "random", "temperature": 1.0}],
                        "thermostat": {"kind": "rescale", "temperature": 2.0, "every": 0.3}, "run": {"until": 1.0}}
            simulation = hardball.Simulation.from_scenario(scenario, processes=processes)
            simulation.measure("pressure")
            simulation.run()
            shown["start"] = state_of(simulation)
            copies = [copy.copy(simulation), pickle.loads(pickle.dumps(simulation)),
                      hardball.Simulation.load(simulation.save(), processes=processes)]
            simulation.save("saved")
            copies.append(hardball.Simulation.load("saved", processes=processes))
            shown["are_shared"] = [each.processes is processes for each in copies] if processes.size > 1 else [True, False, True, True]
            for each in (simulation, *copies):
                each.run(until=2)
            assert all(state_of(each) == state_of(simulation) for each in copies)
            shown["end"] = state_of(simulation)
            shown["pressure"] = [repr(each.results()["pressure"]["pressure"].value) for each in (simulation, *copies)]
        """)

    def test_load_checkpoints_of_any_number_of_processes(self):
        scenario = self.folder / "gas.toml"
        scenario.write_text('[box]\nsize = [12.0, 12.0, 12.0]\nboundary = ["periodic", "periodic", "periodic"]\n[[spheres]]\n'
                            'count = 256\nradius = 0.5\nplacement = "fcc"\ntemperature = 1.0\n[run]\nuntil = 1.0\n')
        hashes = set()
        for count in (1, 2):
            subprocess.run([*MPIRUN, "-n", str(count), PROGRAM, "run", str(scenario), "--out", str(self.folder / f"of_{count}")],
                           env=ENVIRONMENT, check=True, capture_output=True, timeout=240)
            for loaders in (None, 2):
                for each in self.shown(f"""
                    simulation = hardball.Simulation.load("of_{count}/checkpoint.hbc", processes=processes)
                    simulation.run(until=2)
                    shown["end"] = state_of(simulation)
                """, loaders):
                    hashes.add(json.dumps(each))
        self.assertEqual(len(hashes), 1)

    def test_write_files_together(self):
        self.expect_the_same("""
            import shutil
            simulation = gas()
            simulation.measure("pressure")
            simulation.write("now.gsd")
            with simulation.output("out", snapshots_every=0.25, trajectory=["xyz", "gsd"], event_log=True, recording=True,
                                   checkpoint_at=[0.5], overwrite=True):
                simulation.run(until=0.6)
                simulation.run(until=1)
            resumed = hardball.Simulation.resume("out", checkpoint="checkpoints/0.5.hbc", processes=processes)
            shown["time"] = resumed.time
            resumed.run(until=1)
            resumed.close()
            simulation.report("report.html")
            shown["hashes"] = [simulation.event_log_hash, resumed.event_log_hash, simulation.summary()["event_log_hash"]]
            if processes.rank == 0:
                shown["files"] = sorted(os.listdir("out"))
                shown["bytes"] = [hash_of("out/" + name) for name in ("trajectory.xyz", "trajectory.gsd", "events.npy")]
                shown["frames"] = [frame.time for frame in hardball.read("out/recording.hbr", every=0.25)]
                shown["written"] = hash_of("now.gsd")
            shown = {name: shown[name] for name in ("time", "hashes")} if processes.rank else shown
        """, of_first=("files", "bytes", "frames", "written"))

    def test_a_file_that_cannot_be_written_ends_all(self):
        self.expect_the_end_of_all("""
            simulation = gas()
            simulation.output("script.py")
        """, "hardball.Error: ")

    def test_some_things_may_be_asked_of_one_process(self):
        for each in self.shown("""
            simulation = gas()
            simulation.run(until=0.5)
            if processes.rank == 1:
                text = [repr(simulation), len(simulation), simulation.time, simulation.event_log_hash, simulation.collisions,
                        simulation.wall_contacts, simulation.box, simulation.gravity, simulation.compressibility]
            simulation.run(until=1)
            shown["hash"] = simulation.event_log_hash
        """, 2):
            self.assertEqual(each, self.shown('simulation = gas(); simulation.run(until=1)\n'
                                              'shown["hash"] = simulation.event_log_hash', None)[0])

    def test_refuse_what_they_cannot_share(self):
        for each in self.shown("""
            shown["merging"] = error_of(lambda: gas(response=hardball.Merging()))
            shown["function"] = error_of(lambda: gas(response=lambda contact: ([0, 0, 0], [0, 0, 0])))
            shown["steps"] = error_of(lambda: gas(steps=hardball.StepPotential([(1.4, -1.0)])))
            shown["shear"] = error_of(lambda: gas(box=hardball.Box.periodic(13.5, shear_rate=0.1)))
            shown["engine"] = error_of(lambda: gas(engine="paper"))
            simulation = gas()
            shown["later"] = error_of(lambda: simulation.respond_with(lambda contact: None))
            shown["table"] = error_of(lambda: simulation.respond_with(hardball.Merging()))
            shown["type"] = error_of(lambda: gas(processes=2))
            shown["seed"] = error_of(lambda: gas(velocities=[processes.rank, 0, 0]))
            thread = threading.Thread(target=lambda: shown.update(thread=error_of(lambda: simulation.run(until=0.5))))
            thread.start()
            thread.join()
            simulation.run(until=1)
            shown["hash"] = simulation.event_log_hash
        """, 2):
            self.assertEqual(each["merging"], "processes: processes cannot share spheres that merge; leave it out, or run "
                                              "it in one process")
            self.assertIn("a response that is a function", each["function"])
            self.assertIn("cannot share spheres with potentials of steps", each["steps"])
            self.assertIn("cannot share a sheared box", each["shear"])
            self.assertEqual(each["later"], each["function"])
            self.assertEqual(each["table"], each["merging"])
            self.assertIn("engine: the engine paper has one process", each["engine"])
            self.assertEqual(each["type"], "processes: it is 2; give hardball.mpi_processes()")
            self.assertEqual(each["seed"], "several processes: process 1 has another simulation than process 0; give all "
                                           "processes the same arguments, and random numbers the same seed")
            self.assertIn("use it in the thread that joined them", each["thread"])

    def test_are_interrupted_together(self):
        of_first, of_second = self.shown("""
            simulation = gas()
            if processes.rank == 0:
                threading.Timer(1, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
            shown["interruption"] = error_of(lambda: simulation.run(until=1e9),
                                             (KeyboardInterrupt, hardball.RunFailure))
            shown["time"] = simulation.time
            simulation.run(contacts=100)
            shown["hash"] = simulation.event_log_hash
        """, 2)
        self.assertEqual(of_first["interruption"], "")
        self.assertEqual(of_second["interruption"], "process 0 has been interrupted, which ends the run in all")
        self.assertEqual([of_first[key] for key in ("time", "hash")], [of_second[key] for key in ("time", "hash")])

    def test_an_exception_in_one_ends_all(self):
        for rank in (0, 2):
            self.expect_the_end_of_all(f"""
                simulation = gas()
                def listen(contact):
                    if processes.rank == {rank} and contact.time > 0.1:
                        raise ValueError("only here")
                simulation.on_contact(listen)
                simulation.run(until=100)
            """, "ValueError: only here")

    def test_an_exit_of_one_ends_all(self):
        self.expect_the_end_of_all("""
            simulation = gas()
            if processes.rank == 1:
                sys.exit("this one leaves")
            simulation.run(until=100)
        """, "this one leaves")

    def test_an_exception_in_all_ends_all(self):
        self.expect_the_end_of_all("gas(radius=1)", "hardball.Error")

    @unittest.skipUnless(importlib.util.find_spec("mpi4py"), "needs mpi4py")
    def test_others_use_mpi_too(self):
        lines = self.shown("""
            from mpi4py import MPI
            sent = MPI.COMM_WORLD.isend("for another", dest=1 - processes.rank, tag=0)
            simulation = gas()
            simulation.run(until=0.5)
            shown["received"] = MPI.COMM_WORLD.recv(source=1 - processes.rank, tag=0)
            sent.wait()
            shown["sum"] = MPI.COMM_WORLD.allreduce(processes.rank)
        """, 2)
        self.assertEqual(lines, 2 * [{"received": "for another", "sum": 1}])
        self.expect_the_end_of_all("""
            from mpi4py import MPI
            if processes.rank == 1:
                raise ValueError("only here")
            gas().run(until=100)
        """, "ValueError: only here")
        begin = "import mpi4py.MPI\n"
        done = subprocess.run([*MPIRUN, "-n", "2", sys.executable, "-B", "-c", begin + SETTING], env=ENVIRONMENT,
                              capture_output=True, text=True, timeout=240)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("MPI failed to start: it runs already", done.stderr)

    def test_those_that_have_ended_wait_for_others(self):
        self.shown("""
            import time
            gas().run(until=0.5)
            if processes.rank == 0:
                time.sleep(7)
        """, 2)


if __name__ == "__main__":
    if not can_start_processes():
        print("mpirun cannot start processes on this machine")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
