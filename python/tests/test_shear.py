# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Sheared boxes."""

import pickle
import unittest

import numpy as np

import hardball


def make_fluid(rate, restitution=1.0):
    box = hardball.Box.periodic(8.0, shear_rate=rate)
    random = np.random.default_rng(1)
    grid = np.stack(np.meshgrid(*[np.arange(6) * 8 / 6] * 3), axis=-1).reshape(-1, 3)
    velocities = random.normal(size=grid.shape)
    velocities -= velocities.mean(axis=0)
    velocities[:, 0] += rate * (grid[:, 1] - 4)
    return hardball.Simulation(
        box, positions=grid, velocities=velocities, radius=0.4, response=hardball.Bounce(restitution)
    )


class Shear(unittest.TestCase):
    def test_box(self):
        box = hardball.Box.periodic(8.0, shear_rate=0.5, shear_offset=2.0)
        self.assertEqual((box.shear_rate, box.shear_offset), (0.5, 2.0))
        self.assertEqual(pickle.loads(pickle.dumps(box)), box)
        self.assertIn("shear_rate=0.5, shear_offset=2", repr(box))
        self.assertNotEqual(box, hardball.Box.periodic(8.0))
        self.assertEqual(hardball.Box.flat_periodic(8.0, shear_rate=0.5).dimensions, 2)
        with self.assertRaisesRegex(hardball.Error, "not periodic along x and y"):
            hardball.Box(("wall", "periodic", "periodic"), (1, 1, 1), shear_rate=1)

    def test_positions_and_velocities_are_those_in_the_box(self):
        simulation = make_fluid(1.0)
        simulation.run(until=3)
        self.assertTrue(np.all((simulation.positions >= 0) & (simulation.positions <= 8)))
        flow = simulation.positions[:, 1] - 4
        slope = np.polyfit(flow, simulation.velocities[:, 0], 1)[0]
        self.assertAlmostEqual(slope, 1, delta=0.3)

    def test_shear_heats_elastic_spheres(self):
        simulation = make_fluid(1.0)
        before = simulation.kinetic_energy
        simulation.run(until=5)
        self.assertGreater(simulation.kinetic_energy, 1.2 * before)

    def test_viscosity(self):
        simulation = make_fluid(0.5)
        simulation.set_thermostat(hardball.Rescale(1.0, 0.1, slabs=4))
        simulation.run(until=5)
        simulation.measure(["pressure", "flow_profiles"])
        simulation.run(until=30)
        viscosity = simulation.results()["pressure"]["viscosity"]
        self.assertGreater(viscosity.value, 3 * viscosity.error)
        profile = simulation.results()["flow_profiles"].columns
        slope = np.polyfit(profile["y"], profile["flow_velocity_x_at_y"], 1)[0]
        self.assertAlmostEqual(slope, 0.5, delta=0.05)

    def test_slabs(self):
        thermostat = hardball.Rescale(1.0, 0.5, slabs=8)
        self.assertEqual(thermostat.slabs, 8)
        self.assertEqual(hardball.Rescale(1.0, 0.5).slabs, 0)
        self.assertIn("slabs=8", repr(thermostat))


if __name__ == "__main__":
    unittest.main()
