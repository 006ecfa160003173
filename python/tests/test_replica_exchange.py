# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Replica exchange: two spheres in a well, for which everything is known."""

import math
import pickle
import unittest
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np

import hardball

TEMPERATURES = [0.2, 0.3, 0.5, 1.0]
EDGE, RATIO = 4.0, 1.5


def exchange(seed=1, every=2.0, **options):
    simulation = hardball.Simulation(
        hardball.Box.periodic(EDGE),
        positions=[[0, 0, 0], [2, 2, 2]],
        velocities=[[0.5, 0, 0], [-0.5, 0, 0]],
        radius=0.5,
        steps=hardball.StepPotential([(RATIO, -1.0)]),
    )
    return hardball.ReplicaExchange(simulation, TEMPERATURES, every=every, seed=seed, **options)


def fraction_inside(temperature):
    """Which fraction of the time two spheres are within the well, in the canonical ensemble."""
    ball = 4 / 3 * math.pi
    inside = ball * (RATIO**3 - 1) * math.exp(1 / temperature)
    return inside / (inside + EDGE**3 - ball * RATIO**3)


def state(run):
    return run.energies.tolist(), run.places.tolist(), [simulation.event_log_hash for simulation in run.simulations]


class Exchange(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.long = exchange(every=4.0)
        cls.long.run(until=20000)

    def test_energies_are_canonical(self):
        for level, temperature in enumerate(TEMPERATURES):
            blocks = -self.long.energies[100:, level].reshape(-1, 70).mean(axis=1)
            error = blocks.std(ddof=1) / math.sqrt(len(blocks))
            expected = fraction_inside(temperature)
            self.assertLess(abs(blocks.mean() - expected), 4.5 * error, temperature)
            self.assertLess(error, 0.02)

    def test_swaps_are_made_as_often_as_they_should_be(self):
        for level, measured in enumerate(self.long.acceptance):
            low, high = TEMPERATURES[level : level + 2]
            inside = fraction_inside(low), fraction_inside(high)
            # Only where the colder pair is inside, and the warmer is not, a swap may be refused.
            refused = inside[0] * (1 - inside[1]) * (1 - math.exp(1 / high - 1 / low))
            tried = len(self.long.times) // 2
            error = math.sqrt(refused * (1 - refused) / tried)
            self.assertLess(abs(measured - (1 - refused)), 6 * error, level)

    def test_replicas_visit_all_temperatures(self):
        places = self.long.places
        self.assertTrue(all(sorted(row) == [0, 1, 2, 3] for row in places.tolist()))
        for replica in range(4):
            self.assertTrue(all((places[:, level] == replica).mean() > 0.1 for level in range(4)))

    def test_velocities_have_the_temperature(self):
        def kinetic(simulation):
            return simulation.kinetic_energy / 3

        # So seldom that velocities outlast several swaps.
        run = exchange(every=1.0, rate=0.2)
        run.run(until=10000, observe=kinetic)
        independent = 0.2 * 10000 / 2
        for temperature, seen in zip(TEMPERATURES, run.observed.T):
            self.assertLess(abs(seen.mean() / temperature - 1), 4.5 * math.sqrt(2 / 6 / independent))

    def test_the_history_is_the_same_however_it_is_run(self):
        whole = exchange()
        whole.run(until=100)
        self.assertEqual(len(whole.times), 50)
        parts = exchange()
        for until in (0.5, 4.0, 33.3):
            parts.run(until=until)
        parts = pickle.loads(pickle.dumps(parts))
        with ThreadPoolExecutor(1) as one:
            parts.run(until=70, executor=one)
        with ProcessPoolExecutor(2) as processes:
            parts.run(until=100, executor=processes)
        self.assertEqual(state(parts), state(whole))
        self.assertEqual(parts.time, 100)
        other = exchange(seed=2)
        other.run(until=100)
        self.assertNotEqual(state(other), state(whole))

    def test_unsuitable_arguments_are_explained(self):
        with self.assertRaisesRegex(hardball.ArgumentError, "ascending"):
            hardball.ReplicaExchange(exchange().simulations[0], [1.0, 0.5], every=1.0)
        with self.assertRaisesRegex(hardball.ArgumentError, "give a positive time"):
            exchange(every=0)
        with self.assertRaisesRegex(hardball.ArgumentError, "already"):
            self.long.run(until=1)


if __name__ == "__main__":
    unittest.main()
