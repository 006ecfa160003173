# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
import tempfile
import unittest
from pathlib import Path

import hardball
import numpy as np

TETRAHEDRON = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]


class Meshes(unittest.TestCase):
    def test_have_volume_area_and_an_inside(self):
        box = hardball.Mesh.box([2, 3, 4])
        self.assertEqual(box.volume, 24)
        self.assertEqual(box.area, 52)
        self.assertTrue(box.is_closed)
        self.assertEqual(box.vertices.shape, (8, 3))
        self.assertEqual(box.triangles.shape, (12, 3))
        points = np.array([[0, 0, 0], [0.9, 1.4, -1.9], [1.1, 0, 0]])
        np.testing.assert_array_equal(box.contains(points), [True, True, False])
        np.testing.assert_allclose(box.distance(points), [1, 0.1, 0.1], atol=1e-15)
        np.testing.assert_allclose(box.winding_number(points), [1, 1, 0], atol=1e-14)
        self.assertEqual(repr(box), "<Mesh of 12 triangles and 8 vertices>")

    def test_are_made_of_arrays_and_repaired(self):
        vertices, triangles = TETRAHEDRON
        corners = np.array(vertices)[np.array(triangles).ravel()]
        mesh = hardball.Mesh(corners, np.arange(12).reshape(4, 3))
        self.assertEqual(mesh.report["welded_vertices"], 8)
        self.assertEqual(mesh.report["boundary_edges"], 0)
        self.assertAlmostEqual(mesh.volume, 8 / 3, 14)
        opened = hardball.Mesh(vertices, triangles[:3])
        self.assertFalse(opened.is_closed)
        with self.assertRaisesRegex(hardball.Error, "has no inside"):
            opened.contains([[0, 0, 0]])

    def test_are_read_from_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "roof.obj"
            path.write_text("v 0 0 1\nv 0 4 1\nv -2 2 0\nv 2 2 0\ng roof\nf 1 2 3\nf 1 4 2\n")
            roof = hardball.Mesh.read(path, scale=2, rotation=[90, 0, 0])
            np.testing.assert_array_equal(roof.vertices[1], [0, -2, 8])
            with self.assertRaisesRegex(hardball.Error, "ends in '.step'"):
                hardball.Mesh.read("roof.step")

    def test_hold_spheres_that_bounce_in_them(self):
        vertices, triangles = TETRAHEDRON
        wall = hardball.Surface.mesh(hardball.Mesh(vertices, triangles), spheres="inside")
        self.assertEqual(wall.name, "mesh")
        simulation = hardball.Simulation(
            hardball.Box.open(),
            positions=[[0, 0, 0], [0.3, 0, 0]],
            velocities=[[1, 0.3, 0.2], [0, -0.5, 0.1]],
            radius=0.1,
            surfaces=[wall],
        )
        features = []
        simulation.on_contact(lambda contact: features.append((contact.feature, contact.second)))
        energy = np.sum(simulation.velocities**2)
        simulation.run(contacts=300)
        self.assertAlmostEqual(np.sum(simulation.velocities**2), energy, 12)
        self.assertTrue(all(feature < 4 for feature, _ in features))
        self.assertTrue(np.all(wall_distances(vertices, triangles, simulation.positions) > 0.1 - 1e-12))

    def test_have_groups_with_materials(self):
        floor = hardball.Mesh(
            [[-5, -5, 0], [0, -5, 0], [0, 5, 0], [-5, 5, 0], [5, -5, 0], [5, 5, 0]],
            [[0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 2]],
            groups=[0, 0, 1, 1],
            group_names=["hard", "soft"],
        )
        wall = hardball.Surface.mesh(floor, groups={"soft": {"restitution": 0.5}})
        simulation = hardball.Simulation(
            hardball.Box.open(),
            positions=[[-2, 0, 2], [2, 1, 2]],
            velocities=[[0, 0, -1], [0, 0, -1]],
            radius=0.5,
            surfaces=[wall],
        )
        simulation.run(until=5)
        np.testing.assert_allclose(simulation.velocities[:, 2], [1, 0.5])
        with self.assertRaisesRegex(hardball.Error, "no group 'belt'"):
            hardball.Surface.mesh(floor, groups={"belt": {}})

    def test_feel_forces(self):
        floor = hardball.Mesh([[-9, -9, 0], [9, -9, 0], [0, 9, 0]], [[0, 1, 2]])
        simulation = hardball.Simulation(
            hardball.Box.open(),
            positions=[[1, 2, 2]],
            velocities=[[0, 0, -1]],
            radius=0.5,
            surfaces=[hardball.Surface.mesh(floor)],
        )
        simulation.measure("wall_forces", face_forces=True, torque_about={0: [0, 1, 0]})
        simulation.run(until=4)
        forces = simulation.results()["wall_forces"]
        self.assertEqual(forces["mesh_0_force_z"].value, -0.5)
        self.assertEqual([forces[f"mesh_0_torque_{axis}"].value for axis in "xy"], [-0.5, 0.5])
        self.assertNotIn("mesh_0_torque_z", forces)
        faces = simulation.face_forces()["mesh_0"]
        np.testing.assert_array_equal(faces.forces, [[0, 0, -0.5]])
        np.testing.assert_array_equal(faces.contacts, [1])
        np.testing.assert_allclose(faces.pressures, [0.5 / floor.area])
        self.assertIn(b'Name="force"', faces.to_vtp())
        with self.assertRaisesRegex(hardball.Error, "surface 1, and there are 1"):
            simulation.measure("wall_forces", torque_about={1: [0, 0, 0]})
            simulation.run(until=5)
        simulation.measure("wall_forces")
        simulation.run(until=5)
        self.assertEqual(simulation.face_forces(), {})


def wall_distances(vertices, triangles, points):
    return hardball.Mesh(vertices, triangles).distance(points)


if __name__ == "__main__":
    unittest.main()
