# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Responses and listeners in Python, signals, and threads."""

import copy
import gc
import os
import pickle
import resource
import signal
import threading
import time
import unittest
import weakref

import numpy as np

import hardball
from support import gas


def elastic(contact):
    first, second = contact.masses
    normal = contact.normal
    closing = np.dot(contact.before[1] - contact.before[0], normal)
    exchange = 2 * closing / (first + second)
    return contact.before[0] + exchange * second * normal, contact.before[1] - exchange * first * normal


class Responses(unittest.TestCase):
    def test_a_response_in_python_does_what_a_built_in_one_does(self):
        own, built_in = gas(response=elastic), gas()
        for simulation in (own, built_in):
            simulation.run(contacts=20)
        np.testing.assert_allclose(own.positions, built_in.positions, atol=1e-9)

    def test_built_in_ones(self):
        energy = gas().kinetic_energy
        tabulated = hardball.TabulatedRestitution([0, 1], [1, 0.5])
        for response in (
            0.8,
            hardball.Bounce(0.8),
            hardball.Bounce(hardball.ViscoelasticRestitution(0.8, speed=1.0)),
            hardball.Bounce(tabulated, elastic_below=1e-6),
            hardball.Bounce(0.9, contact_duration=1e-4),
            hardball.ResponseTable(hardball.Bounce(0.7)),
            tabulated,
            hardball.ResponseTable(hardball.ViscoelasticRestitution(0.7, speed=1.0), walls=0.5),
        ):
            simulation = gas(response=response)
            simulation.run(until=2)
            self.assertLess(simulation.kinetic_energy, 0.9 * energy)
            later = gas()
            later.respond_with(response)
            later.run(until=2)
            self.assertEqual(later.event_log_hash, simulation.event_log_hash)
        self.assertEqual(gas(response=0.8).run(until=2), gas(response=hardball.Bounce(0.8)).run(until=2))
        self.assertEqual(tabulated.at(0.5), 0.75)
        numbers, bounces = hardball.ResponseTable(0.8, walls=0.5), hardball.ResponseTable(hardball.Bounce(0.8), hardball.Bounce(0.5))
        numbers.set_wall(1, 0.25)
        bounces.set_wall(1, hardball.Bounce(0.25))
        box = hardball.Box.walls(8.0)
        of_numbers, of_bounces = (gas(box=box, species=np.arange(125) % 2, response=table) for table in (numbers, bounces))
        for simulation in (of_numbers, of_bounces):
            simulation.run(until=2)
        self.assertEqual(of_numbers.event_log_hash, of_bounces.event_log_hash)
        with self.assertRaisesRegex(hardball.Error, "give one of these or a coefficient"):
            numbers.set(0, 1, "soft")
        with self.assertRaisesRegex(hardball.Error, "give a Bounce or a coefficient"):
            numbers.set_wall(0, hardball.Merging())

    def test_built_in_ones_are_saved_whenever_they_are_set(self):
        for response in (0.5, hardball.Bounce(0.9), hardball.ResponseTable(0.8, walls=0.5), hardball.Merging()):
            simulation = gas()
            simulation.run(collisions=10)
            simulation.respond_with(response)
            others = [
                hardball.Simulation.load(simulation.save()),
                pickle.loads(pickle.dumps(simulation)),
                copy.copy(simulation),
            ]
            for each in (simulation, *others):
                each.run(collisions=50)
                self.assertEqual(each.event_log_hash, simulation.event_log_hash)
                self.assertEqual(each.kinetic_energy, simulation.kinetic_energy)
        simulation = gas(response=elastic)
        simulation.respond_with(0.5)
        simulation.respond_with(elastic)
        simulation.respond_with(None)
        energy = simulation.kinetic_energy
        simulation.run(collisions=10)
        self.assertLess(simulation.kinetic_energy, energy)

    def test_drops_that_merge_merge_with_whom_they_overlap_then(self):
        drops = {
            "positions": [[0, 0, 0], [2.2, 0, 0], [1.1, 1.05, 0], [1.1, -1.05, 0]],
            "velocities": [[1, 0, 0], [-1, 0, 0], [0, 0, 0], [0, 0, 0]],
            "radius": 0.5,
        }
        from_the_start = hardball.Simulation(hardball.Box.open(), **drops, response=hardball.Merging())
        later = hardball.Simulation(hardball.Box.open(), **drops)
        later.respond_with(hardball.Merging())
        for simulation in (from_the_start, later):
            simulation.run(until=5)
            self.assertEqual(len(simulation), 2)
            self.assertTrue(simulation.certificate["is_sound"])

    def test_who_is_no_function_is_refused_at_once(self):
        simulation = gas()
        for thing in (hardball.Bounce, hardball.Merging, "soft", [0.5, 0.6]):
            with self.assertRaises(hardball.Error):
                simulation.respond_with(thing)
        with self.assertRaisesRegex(hardball.Error, "give a function"):
            simulation.on_contact(5)
        simulation.run(collisions=10)

    def test_runs_within_a_run_are_refused_and_harm_nothing(self):
        def interfering(action):
            def listener(contact):
                with self.assertRaises(hardball.Error):
                    action()

            return listener

        for action in (
            lambda simulation: simulation.run(contacts=1),
            lambda simulation: simulation.run(contacts=1, record=True),
            lambda simulation: next(simulation.events()),
        ):
            simulation = gas()
            simulation.on_contact(interfering(lambda: action(simulation)))
            self.assertEqual(len(simulation.run(contacts=100, record=True)), 100)
            self.assertEqual(sum(1 for _, __ in zip(simulation.events(), range(10))), 10)

            def response(contact):
                with self.assertRaises(hardball.Error):
                    action(simulation)
                return elastic(contact)

            simulation.respond_with(response)
            self.assertEqual(len(simulation.run(contacts=100, record=True)), 100)

    def test_rough_spheres_spin_and_drops_merge(self):
        rough = gas(response=hardball.Bounce(tangential_restitution=0.5))
        rough.run(until=1)
        self.assertGreater(np.abs(rough.spins).max(), 0)
        drops = gas(response=hardball.Merging())
        drops.run(until=1)
        self.assertLess(len(drops), 125)
        self.assertEqual(len(drops.ids), len(drops))
        merging = gas(response=lambda contact: hardball.Outcome(contact, contact.before, merges=True))
        merging.run(contacts=3)
        self.assertEqual(len(merging), 122)

    def test_species_and_passing(self):
        species = np.arange(125) % 2
        table = hardball.ResponseTable(hardball.Bounce(1.0))
        table.set(0, 1, hardball.Bounce(0.0))
        simulation = gas(species=species, response=table)
        fates = {c.species: c for c in simulation.events(until=1)}
        self.assertIn((0, 1), {tuple(sorted(pair)) for pair in fates})
        for contact in fates.values():
            parting = np.dot(contact.after[1] - contact.after[0], contact.normal)
            if sorted(contact.species) == [0, 1]:
                self.assertAlmostEqual(parting, 0)
            else:
                self.assertAlmostEqual(parting, contact.normal_speed)
        through = gas(species=species, passing=[(0, 1)])
        self.assertIn("pass", {c.outcome for c in through.events(until=1)})

    def test_surfaces(self):
        surfaces = [
            hardball.Surface.plane([0, 0, 2], amplitude=0.05, frequency=1.0),
            hardball.Surface.obstacle(0.2, [4, 4, 0.9]),
            hardball.Surface.sphere(40, [4, 4, 4], temperature=1.0),
            hardball.Surface.cylinder([0, 0, 1], 20, [4, 4, 0], restitution=0.5),
        ]
        simulation = hardball.Simulation(
            hardball.Box.open(), positions=[4, 4, 2] + np.zeros((1, 3)), radius=0.5, gravity=[0, 0, -1], surfaces=surfaces
        )
        self.assertEqual([s.name for s in surfaces], ["oscillating plane", "obstacle", "sphere", "cylinder"])
        walls = {c.second for c in simulation.events(until=20)}
        self.assertIn(7, walls, "the obstacle")

    def test_what_is_no_answer_is_refused(self):
        for answer, message in [
            (None, "two vectors"),
            ([1, 2, 3], "two vectors"),
            (([1, 2, 3], [1]), "three numbers"),
            (([1, 2, 3], [np.nan, 0, 0]), "nan"),
            (([1e99, 2, 3], [0, 0, 0]), "1e"),
        ]:
            simulation = gas(response=lambda contact: answer)
            with self.subTest(message), self.assertRaisesRegex((hardball.Error, hardball.RunFailure), message):
                simulation.run(until=1)
            self.assertEqual(simulation.collisions, 0, "the contact has not happened")

    def test_exceptions_come_back_and_leave_a_simulation_that_runs(self):
        class Mine(Exception):
            pass

        def fail(contact):
            raise Mine(contact.time)

        simulation = gas(response=fail)
        with self.assertRaises(Mine):
            simulation.run(until=1)
        simulation.respond_with(None)
        simulation.on_contact(fail)
        with self.assertRaises(Mine) as caught:
            simulation.run(until=1)
        self.assertEqual(simulation.collisions, 1)
        self.assertEqual(caught.exception.args[0], simulation.time)
        simulation.on_contact(None)
        simulation.run(until=1)
        expected = gas()
        expected.run(until=1)
        self.assertEqual(simulation.event_log_hash, expected.event_log_hash)


class Listeners(unittest.TestCase):
    def test_it_may_edit_and_replace_itself(self):
        simulation = gas()
        calls = []

        def second(contact):
            calls.append("second")

        def first(contact):
            calls.append("first")
            simulation.set_velocity(contact.first, [0, 0, 0])
            simulation.on_contact(second)

        simulation.on_contact(first)
        simulation.run(contacts=3)
        self.assertEqual(calls, ["first", "second", "second"])

    def test_it_must_not_run_its_simulation(self):
        simulation = gas()
        simulation.on_contact(lambda contact: simulation.run(until=9))
        with self.assertRaisesRegex(hardball.Error, "run"):
            simulation.run(until=1)

    def test_it_must_not_replace_the_measures_of_its_run(self):
        simulation = gas()
        simulation.measure("pressure")
        simulation.on_contact(lambda contact: simulation.measure("temperature"))
        with self.assertRaisesRegex(hardball.Error, "between runs"):
            simulation.run(until=1)
        simulation.on_contact(None)
        simulation.run(until=1)
        self.assertEqual(list(simulation.results()), ["pressure"])


class Signals(unittest.TestCase):
    def test_control_c_ends_a_run(self):
        for options in ({}, {"engine": "all-pairs"}, {"response": elastic}):
            simulation = gas(**options)
            threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
            with self.assertRaises(KeyboardInterrupt):
                simulation.run(until=1e9)
            stopped = simulation.time
            self.assertGreater(simulation.collisions, 0)
            simulation.run(contacts=5)
            self.assertGreater(simulation.time, stopped)

    def test_control_c_ends_a_run_in_which_nothing_ever_meets(self):
        for engine in ("cells", "neighbors", "paper"):
            lone = hardball.Simulation(hardball.Box.periodic(10), positions=[[5, 5, 5]], velocities=[1, 0, 0], engine=engine)
            threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
            with self.assertRaises(KeyboardInterrupt):
                lone.run(until=1e12)
            self.assertGreater(lone.time, 0)

    def test_control_c_ends_the_search_for_an_event_that_never_comes(self):
        box = hardball.Box.periodic(10)
        simulation = hardball.Simulation(box, positions=[[1, 1, 1], [5, 5, 5]], velocities=[1, 0, 0])
        threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            simulation.next_event()
        self.assertEqual(simulation.run(until=1), 0)

    def test_a_run_that_was_ended_is_that_of_an_undisturbed_one(self):
        simulation = gas()
        threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            simulation.run(until=1e9, record=True)
        undisturbed = gas()
        undisturbed.run(contacts=simulation.collisions)
        self.assertEqual(simulation.event_log_hash, undisturbed.event_log_hash)


class Threads(unittest.TestCase):
    def test_two_simulations_run_at_once(self):
        simulations = [gas(seed=seed) for seed in (1, 2)]
        # Each listener waits until the other simulation has come to a contact, too.
        barrier = threading.Barrier(2, timeout=60)

        def run(simulation):
            simulation.on_contact(lambda contact: barrier.wait())
            simulation.run(contacts=100)

        threads = [threading.Thread(target=run, args=(simulation,)) for simulation in simulations]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for seed, simulation in enumerate(simulations, 1):
            alone = gas(seed=seed)
            alone.run(contacts=100)
            self.assertEqual(simulation.event_log_hash, alone.event_log_hash)

    def test_the_interpreter_goes_on_while_one_runs_and_that_one_is_refused_to_others(self):
        simulation = gas()
        is_running, refusals = threading.Event(), []
        stop = threading.Event()

        def listen(contact):
            is_running.set()
            if stop.is_set():
                raise StopIteration

        def run():
            try:
                simulation.on_contact(listen)
                simulation.run(until=1e9)
            except StopIteration:
                pass

        thread = threading.Thread(target=run)
        thread.start()
        self.assertTrue(is_running.wait(60))
        for use in (lambda: simulation.positions, lambda: simulation.run(until=1), lambda: simulation.save()):
            try:
                use()
            except hardball.RunFailure as failure:
                refusals.append(str(failure))
        stop.set()
        thread.join()
        self.assertEqual(len(refusals), 3)
        self.assertIn("another thread", refusals[0])
        self.assertEqual(simulation.positions.shape, (125, 3))


    def test_nobody_comes_in_between_while_the_run_calls_functions_of_its_own(self):
        simulation, outcomes = gas(), []

        def intrude():
            for use in (lambda: simulation.run(until=1e9), lambda: next(simulation.events()), lambda: len(simulation)):
                try:
                    use()
                except hardball.RunFailure:
                    outcomes.append("refused")

        def on_progress(time):
            if not outcomes:
                thread = threading.Thread(target=intrude)
                thread.start()
                thread.join()

        self.assertEqual(len(simulation._run(None, None, 50_000, True, on_progress)), 50_000)
        self.assertEqual(outcomes, ["refused"] * 3)

    def test_many_rays_release_the_gil(self):
        simulation = gas()
        ways = np.random.default_rng(1).normal(size=(500, 3))
        stop = threading.Event()

        def cast():
            while not stop.is_set():
                simulation.rays([4.0, 4, 4], ways, 1e3, species=9)

        thread = threading.Thread(target=cast)
        thread.start()
        try:
            # With the GIL, the other thread would be seen only between two casts.
            with self.assertRaisesRegex(hardball.RunFailure, "running in another thread"):
                end = time.monotonic() + 60
                while time.monotonic() < end:
                    simulation.collisions
        finally:
            stop.set()
            thread.join()

    def test_queries_end_at_control_c(self):
        lone = hardball.Simulation(
            hardball.Box.periodic(10), positions=[[5, 5, 5], [5, 7, 5]], velocities=[[1, 0, 0], [1.3, 0, 0]], radius=0.5
        )
        queries = (
            lambda: lone.contacts_within(1e12),
            lambda: lone.positions_at(1e12),
            lambda: lone.ray([5, 6, 5], [1, 0, 0], 1e9),
            lambda: lone.ray_hits([5, 6, 5], [1, 0, 0], 1e9),
            lambda: lone.rays([[5, 5, 5], [5, 6, 5]], [1, 0, 0], 1e9),
            lambda: lone.first_contact(0, [2, 0, 0], 1e9),
            lambda: gas().contacts_within(1e12),
        )
        for query in queries:
            timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                query()
            timer.join()
        lone.run(until=1)


class Memory(unittest.TestCase):
    def test_a_simulation_that_its_own_functions_refer_to_is_collected(self):
        def started():
            simulation = gas()
            simulation.on_contact(lambda contact: simulation.time)
            simulation.respond_with(lambda contact: (simulation.velocities[contact.first] * 0, [0, 0, 0]))
            other = copy.copy(simulation)
            other.run(contacts=1)
            simulation.run(contacts=1)
            return weakref.ref(simulation), weakref.ref(other), simulation

        first, second, simulation = started()
        gc.collect()
        self.assertIs(first(), simulation)
        self.assertIsNone(second())
        simulation.run(contacts=1)
        del simulation
        gc.collect()
        self.assertIsNone(first())

    def test_nothing_leaks(self):
        def work(times):
            for _ in range(times):
                simulation = gas(response=elastic)
                simulation.on_contact(lambda contact: simulation.time)
                simulation.measure("temperature")
                record = simulation.run(contacts=3, record=True)
                self.assertEqual(len(record), 3)
                simulation.positions, simulation.results(), simulation.save()
                simulation.on_contact(None)
            gc.collect()
            return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

        few = work(500)
        kilobytes = work(2000) - few
        # Each would leave tens of kilobytes.
        self.assertLess(kilobytes, 2000)


if __name__ == "__main__":
    unittest.main()
