# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Potentials of steps, and bonds."""

import pickle
import unittest

import numpy as np

import hardball


def pair(**arguments):
    return hardball.Simulation(
        hardball.Box.open(), positions=[[0, 0, 0], [3, 0, 0]], velocities=[[0.5, 0, 0], [-0.5, 0, 0]], radius=0.5, **arguments
    )


class Steps(unittest.TestCase):
    def test_two_spheres_in_a_well(self):
        simulation = pair(steps=hardball.StepPotential([(2.0, -0.375)]))
        seen = []
        simulation.on_contact(lambda contact: seen.append((contact.time, contact.step)))
        simulation.run(until=100)
        inside = np.sqrt(2.5)
        np.testing.assert_allclose([time for time, _ in seen], [1, 1 + 1 / inside, 1 + 2 / inside])
        self.assertIsNone(seen[1][1])
        self.assertFalse(seen[0][1].is_outward)
        self.assertTrue(seen[2][1].is_outward and seen[2][1].passes)
        self.assertEqual(seen[2][1].rise, 0.375)
        self.assertEqual(simulation.step_energy, 0)
        self.assertEqual(simulation.certificate["steps_passed"], 2)

    def test_tables_and_bonds(self):
        table = hardball.StepTable()
        table.set(0, 1, hardball.StepPotential([(1.5, -1.0)]))
        bond = table.add_bond(hardball.StepPotential([(3.5, 0.0)], core=0.9, tether=True))
        self.assertEqual((len(table), bond, table[bond].tether), (2, 1, True))
        simulation = pair(steps=table, species=[0, 1], bonds=[(0, 1, bond)])
        self.assertEqual(simulation.bonds, [(0, 1, bond)])
        simulation.run(until=50)
        copy = pickle.loads(pickle.dumps(simulation))
        self.assertEqual(copy.bonds, simulation.bonds)
        apart = np.linalg.norm(np.diff(simulation.positions, axis=0))
        self.assertTrue(0.9 - 1e-9 <= apart <= 3.5 + 1e-9)

    def test_sensors(self):
        steps = hardball.StepTable()
        steps.set(0, 1, hardball.StepPotential.sensor())
        simulation = pair(steps=steps, species=[0, 1])
        seen = []
        simulation.on_contact(lambda contact: seen.append((contact.time, contact.step.is_outward)))
        simulation.run(until=3)
        self.assertEqual((list(simulation.partners(0)), list(simulation.partners(1))), ([1], [0]))
        simulation.run(until=10)
        self.assertEqual(seen, [(2.0, False), (4.0, True)])
        self.assertEqual(list(simulation.partners(0)), [])
        np.testing.assert_array_equal(simulation.velocities, [[0.5, 0, 0], [-0.5, 0, 0]])
        with self.assertRaises(hardball.Error):
            simulation.partners(5)

    def test_potentials_are_values(self):
        potential = hardball.StepPotential([(1.2, -2.0), (1.5, -1.0)], core=0.5)
        self.assertEqual(repr(potential), "hardball.StepPotential([(1.2, -2), (1.5, -1)], core=0.5)")
        self.assertEqual(pickle.loads(pickle.dumps(potential)).steps, [(1.2, -2.0), (1.5, -1.0)])
        self.assertEqual(len(pickle.loads(pickle.dumps(hardball.StepTable()))), 0)

    def test_refusals(self):
        for make, message in [
            (lambda: hardball.StepPotential([]), "no steps"),
            (lambda: pair(steps=1.0), "neither a StepTable nor a StepPotential"),
            (lambda: pair(bonds=[(0, 1)]), "two ids and the number"),
            (lambda: pair(bonds=[(0, 1, 0)]), "not a tether"),
            (lambda: pair(steps=hardball.StepPotential([(1.5, -1)]), gravity=[0, 0, -1]), "gravity"),
        ]:
            with self.assertRaisesRegex(hardball.Error, message):
                make()


if __name__ == "__main__":
    unittest.main()
