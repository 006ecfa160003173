# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Packings from Python."""

import json
import tempfile
import unittest
from pathlib import Path

import hardball
import numpy as np
from support import program


class PackingTest(unittest.TestCase):
    def test_density(self):
        packing = hardball.pack(100, phi=0.55, seed=3)
        self.assertEqual(packing.status, "reached")
        self.assertAlmostEqual(packing.phi, 0.55, places=12)
        self.assertEqual(packing.positions.shape, (100, 3))
        self.assertAlmostEqual(2 * packing.radii.mean(), 1, places=12)
        self.assertEqual(len(packing.contacts), 0)
        self.assertEqual(packing.largest_overlap, 0)
        self.assertEqual(list(packing.history), ["collisions", "phi", "pressure", "rate"])
        self.assertIn("100 spheres", repr(packing))

    def test_same_as_program(self):
        packing = hardball.pack(50, sizes=("lognormal", 0.3), box=(3, 4, 5), walls="z", phi=0.5, seed=7)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "a.npy"
            request = "--count 50 --sizes lognormal:0.3 --box 3,4,5 --walls z --phi 0.5 --seed 7"
            summary = json.loads(program("pack", *request.split(), "--json", "--out", file))
            rows = np.load(file)
        self.assertEqual(summary["phi"], packing.phi)
        np.testing.assert_array_equal(np.column_stack([rows[axis] for axis in "xyz"]), packing.positions)
        np.testing.assert_array_equal(rows["radius"], packing.radii)

    def test_jammed(self):
        packing = hardball.pack(60, phi="max")
        self.assertEqual(packing.status, "jammed")
        contacts = packing.contacts
        self.assertEqual(contacts.dtype.names, ("i", "j", "wall", "image", "gap", "separation", "force"))
        apart = np.linalg.norm(contacts["separation"], axis=1)
        np.testing.assert_allclose(apart, 2 * packing.radii[0] + contacts["gap"], rtol=1e-9)
        self.assertAlmostEqual(contacts["force"].mean(), 1, places=12)
        self.assertLess(contacts["gap"].max(), packing.contact_tolerance)
        held = 60 - packing.rattlers.sum()
        self.assertGreater(packing.isostaticity, 0.95)
        self.assertLessEqual(len(contacts), 1.1 * (3 * (held - 1) + 1) + 3 * packing.rattlers.sum())

    def test_goes_on_as_a_gas(self):
        packing = hardball.pack(container="cylinder:3,5", diameter=1, phi=0.3)
        simulation = packing.simulation(temperature=2.0)
        simulation.run(until=1)
        self.assertEqual(len(simulation), len(packing.radii))
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.gsd", "a.xyz"):
                packing.write(str(Path(folder) / name))
                self.assertTrue((Path(folder) / name).exists())

    def test_fills_a_mesh(self):
        mesh = hardball.Mesh.box((4, 3, 5))
        packing = hardball.pack(100, phi=0.4, container=mesh)
        self.assertAlmostEqual(packing.phi, 0.4, places=12)
        self.assertTrue(all(mesh.contains(packing.positions)))
        self.assertTrue(all(mesh.distance(packing.positions) >= packing.radii))
        larger = hardball.pack(100, diameter=1, phi=0.4, container=mesh)
        self.assertAlmostEqual(larger.phi, 0.4, places=12)
        self.assertAlmostEqual(larger.radii[0], 0.5, places=12)
        packing.simulation().run(until=1)
        with self.assertRaisesRegex(hardball.Error, "not closed"):
            hardball.pack(10, phi=0.3, container=hardball.Mesh.plate((1, 0, 0), (0, 1, 0)))
        with self.assertRaisesRegex(hardball.Error, "one of the two"):
            hardball.pack(10, phi=0.3, box=3, container=mesh)

    def test_wall_profile(self):
        packing = hardball.pack(container="cylinder:4,6", diameter=1, phi=0.5)
        distances, fractions = packing.wall_profile()
        self.assertEqual(distances.shape, fractions.shape)
        volume = (fractions * 2 * np.pi * (2 - distances) * 6).sum() * (distances[1] - distances[0])
        self.assertAlmostEqual(volume / (np.pi * 4 * 6), packing.phi, places=2)
        self.assertLess(fractions[0], 0.2)
        self.assertEqual(len(hardball.pack(20, phi=0.3).wall_profile()[0]), 0)

    def test_ase(self):
        packing = hardball.pack(20, phi=0.4)
        atoms = packing.to_ase()
        self.assertTrue(all(atoms.pbc))
        np.testing.assert_array_equal(atoms.arrays["radius"], packing.radii)
        atoms.set_masses(np.ones(20))
        self.assertEqual(len(hardball.Simulation.from_ase(atoms)), 20)

    def test_radii(self):
        packing = hardball.pack(sizes=[1, 2, 3], phi=0.2)
        np.testing.assert_allclose(packing.radii, [1, 2, 3])

    def test_gap(self):
        packing = hardball.pack(50, diameter=2, phi=0.4, gap=0.1)
        self.assertAlmostEqual(packing.phi, 0.4, places=12)
        self.assertAlmostEqual(2 * packing.radii.mean(), 2, places=12)
        self.assertGreaterEqual(packing.smallest_gap, 0.1)

    def test_errors(self):
        with self.assertRaisesRegex(hardball.Error, "no equal spheres"):
            hardball.pack(10, phi=0.9)
        with self.assertRaisesRegex(hardball.Error, "walls"):
            hardball.pack(10, phi=0.2, walls="w")
        with self.assertRaises(hardball.PackingFailed) as caught:
            hardball.pack(64, phi=0.65, rate=0.3)
        self.assertLess(caught.exception.packing.phi, 0.65)
        self.assertIn("try rate=", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
