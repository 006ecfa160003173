# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Arrays that come and go: of every kind that NumPy has, and those that are refused."""

import contextlib
import io
import gc
import pickle
import unittest

import numpy as np

import hardball
from support import gas, lattice


class ArraysOfState(unittest.TestCase):
    def test_shapes_types_and_order(self):
        simulation = gas()
        for name in ("positions", "unwrapped_positions", "velocities", "spins"):
            array = getattr(simulation, name)
            self.assertEqual((array.shape, array.dtype), ((125, 3), np.float64), name)
        for name in ("radii", "masses"):
            array = getattr(simulation, name)
            self.assertEqual((array.shape, array.dtype), ((125,), np.float64), name)
        np.testing.assert_array_equal(simulation.ids, np.arange(125))
        np.testing.assert_array_equal(simulation.positions, lattice()[0])

    def test_they_are_read_only_and_made_once_for_each_state(self):
        simulation = gas()
        positions = simulation.positions
        self.assertIs(simulation.positions, positions)
        with self.assertRaises(ValueError):
            positions[0, 0] = 1
        kept = positions.copy()
        simulation.run(contacts=1)
        self.assertIsNot(simulation.positions, positions)
        np.testing.assert_array_equal(positions, kept, "an array is of the state in which it was made")
        del simulation
        gc.collect()
        np.testing.assert_array_equal(positions, kept, "and outlives its simulation")

    def test_a_listener_sees_the_state_at_its_contact(self):
        simulation = gas()
        seen = []
        simulation.on_contact(lambda contact: seen.append(simulation.positions))
        simulation.run(contacts=3)
        self.assertEqual(len({id(array) for array in seen}), 3)
        self.assertFalse(np.array_equal(seen[0], seen[2]))

    def test_unwrapped_positions_do_not_jump(self):
        simulation = gas()
        before = simulation.unwrapped_positions
        simulation.run(until=20)
        moved = simulation.unwrapped_positions - before
        self.assertGreater(np.abs(moved).max(), simulation.box.size[0])
        wrapped = simulation.unwrapped_positions - simulation.positions
        np.testing.assert_allclose(wrapped / simulation.box.size, np.round(wrapped / simulation.box.size), atol=1e-12)


class ArraysGiven(unittest.TestCase):
    positions, edge = lattice()

    def made(self, positions, **options):
        return hardball.Simulation(hardball.Box.periodic(self.edge), positions=positions, radius=0.5, **options)

    def test_every_kind_of_numbers(self):
        expected = self.made(self.positions, velocities=np.ones((125, 3))).velocities
        columns = np.asfortranarray(np.ones((125, 3)))
        spread = np.ones((250, 6))[::2, ::2]
        frozen = np.ones((125, 3))
        frozen.flags.writeable = False
        swapped = np.ones((125, 3), dtype=">f8")
        for velocities in (
            columns,
            spread,
            frozen,
            swapped,
            np.ones((125, 3), dtype=np.float32),
            np.ones((125, 3), dtype=np.int8),
            np.ones((125, 3), dtype=bool),
            [[1, 1, 1]] * 125,
            (1, 1.0, np.float32(1)),
            np.ones(3),
        ):
            np.testing.assert_array_equal(self.made(self.positions, velocities=velocities).velocities, expected)

    def test_none_at_all(self):
        simulation = hardball.Simulation(hardball.Box.open(), positions=[])
        self.assertEqual((len(simulation), simulation.positions.shape), (0, (0, 3)))
        self.assertEqual(simulation.run(until=1), 0)

    def test_two_columns_in_two_dimensions(self):
        simulation = hardball.Simulation(hardball.Box.flat_periodic(9), positions=[[1, 2], [5, 6]], velocities=[1, 0])
        np.testing.assert_array_equal(simulation.positions, [[1, 2, 0], [5, 6, 0]])

    def test_two_numbers_are_no_vector_in_three_dimensions(self):
        simulation = hardball.Simulation(hardball.Box.periodic(9), positions=[[1, 1, 1], [5, 5, 5]])
        contact = hardball.Simulation(hardball.Box.open(), positions=[[0, 0, 0], [4, 1, 1]], velocities=[[1, 0, 0], [0, 0, 0]])
        for call in (
            lambda: simulation.set_velocity(1, [0, 0]),
            lambda: simulation.set_velocity([0, 1], [[0, 0], [1, 1]]),
            lambda: simulation.add([3, 3]),
            lambda: simulation.add([3, 3, 3], velocity=[1, 0]),
            lambda: simulation.first_contact(0, [1, 0], until=1),
            lambda: simulation.ray([0, 0], [1, 0, 0], most=1),
            lambda: simulation.ray([0, 0, 0], [1, 0], most=1),
            lambda: simulation.clearance([0, 0]),
            lambda: self.made(self.positions, velocities=[1, 0]),
            lambda: self.made(self.positions, velocities=np.ones((125, 2))),
            lambda: self.made(self.positions, gravity=[0, -1]),
            lambda: self.made(self.positions, response=lambda contact: [[0, 0], [0, 0]]).set_velocity(0, [0, 0]),
        ):
            with self.assertRaisesRegex(hardball.Error, "shape.*three dimensions"):
                call()
        contact.respond_with(lambda contact: [[0, 0], [0, 0]])
        with self.assertRaisesRegex(hardball.Error, "shape.*three dimensions"):
            contact.run(until=10)
        np.testing.assert_array_equal(simulation.velocities, 0)
        flat = hardball.Simulation(hardball.Box.flat_periodic(9), positions=[[1, 1], [5, 5, ]], gravity=[0, -1])
        for velocity in ([1, 2], [1, 2, 0]):
            flat.set_velocity(1, velocity)
            np.testing.assert_array_equal(flat.velocities[1], [1, 2, 0])
        flat.respond_with(lambda contact: [[0, 0], [0, 0]])
        flat.set_velocity([0, 1], [[1, 1], [0, 0]])
        self.assertEqual(flat.run(contacts=1), 1)
        with self.assertRaisesRegex(hardball.Error, r"shape \(4,\); give three numbers, or two"):
            flat.ray([1, 2, 3, 4], [1, 0], most=1)

    def test_errors_say_what_to_write(self):
        good = self.positions
        nan, infinite = good.copy(), good.copy()
        nan[3, 1] = np.nan
        infinite[3, 1] = np.inf
        bad = [
            ({"positions": good.ravel()}, r"shape \(375,\).*\(n, 3\)"),
            ({"positions": good[:, :1]}, r"shape \(125, 1\).*\(n, 3\)"),
            ({"positions": good[np.newaxis]}, r"shape \(1, 125, 3\).*\(n, 3\)"),
            ({"positions": 5}, r"shape \(\).*\(n, 3\)"),
            ({"positions": "five"}, "positions.*give real numbers"),
            ({"positions": None}, "positions.*give real numbers"),
            ({"positions": good + 1j}, "positions.*give real numbers"),
            ({"positions": [[1, 2, 3], [1, 2]]}, "positions.*give real numbers"),
            ({"positions": nan}, "sphere 3.*nan"),
            ({"positions": infinite}, "sphere 3.*inf"),
            ({"positions": good, "velocities": good[:5]}, "velocities.*as many rows.*125"),
            ({"positions": good, "velocities": [1, 2, 3, 4]}, "velocities.*shape"),
            ({"positions": good, "velocities": np.full((125, 3), np.nan)}, "sphere 0.*nan"),
            ({"positions": good, "radius": [1, 2]}, "radius.*as many as there are spheres, 125"),
            ({"positions": good, "radius": -1}, "radius"),
            ({"positions": good, "radius": 0.9}, "overlap"),
            ({"positions": good, "mass": 0}, "mass"),
            ({"positions": good, "species": 1.5}, "species.*whole numbers from 0 to 255"),
            ({"positions": good, "species": 256}, "species.*whole numbers from 0 to 255"),
            ({"positions": good, "species": -1}, "species.*whole numbers from 0 to 255"),
            ({"positions": good[:, :2]}, "two coordinates.*three dimensions"),
            ({"positions": np.ma.masked_less(good, 1)}, "masked entries"),
            ({"positions": good, "species": good[:, 0] > 1}, "species.*booleans"),
            ({"positions": good, "seed": 1.5}, "seed.*whole number"),
            ({"positions": good, "response": 1.5}, "restitution.*1.5"),
            ({"positions": good, "response": "soft"}, "give a Bounce, a Merging"),
            ({"positions": good, "thermostat": 5}, "give an Andersen"),
            ({"positions": good, "engine": "fast"}, "choose one of auto"),
            ({"positions": good, "cell_edge": -1}, "cell edge"),
            ({"positions": good, "cell_edge": "x"}, "cell_edge.*give a number"),
            ({"positions": good, "engine": 5}, "engine.*give a name"),
            ({"positions": good, "surfaces": [1]}, "surfaces.*give a list of Surface"),
            ({"positions": good, "surfaces": 1}, "surfaces.*give a list of Surface"),
            ({"positions": good, "passing": [0, 1]}, r"passing.*as in \[\(0, 1\)\]"),
            ({"positions": good, "passing": [(0, 256)]}, "passing.*from 0 to 255"),
        ]
        for options, message in bad:
            with self.subTest(message), self.assertRaisesRegex(hardball.Error, f"(?s){message}"):
                hardball.Simulation(hardball.Box.periodic(self.edge), **{"radius": 0.5, **options})

    def test_boxes(self):
        self.assertEqual(hardball.Box.periodic(5), hardball.Box(["periodic"] * 3, [5, 5, 5]))
        self.assertEqual(hardball.Box.walls([1, 2, 3]).volume, 6)
        self.assertEqual(hardball.Box.flat_walls([2, 3]).dimensions, 2)
        self.assertEqual(eval(repr(hardball.Box.flat_walls([2, 3]))), hardball.Box.flat_walls([2, 3]))
        for make, message in [
            (lambda: hardball.Box.periodic([1, 2]), "three"),
            (lambda: hardball.Box.flat_walls([1, 2, 3]), "two"),
            (lambda: hardball.Box.walls(-1), "-1"),
            (lambda: hardball.Box(["wall", "wall", "soft"], [1, 1, 1]), "soft"),
            (lambda: hardball.Box(5, 5), "boundary: it is 5; give three names"),
            (lambda: hardball.Box("open", 5), "boundary: it is 'open'; give three names"),
            (lambda: hardball.Box(["wall", "wall"], [1, 1]), "give three names"),
            (lambda: hardball.Box([1, 2, 3], [1, 1, 1]), "there is no boundary 1"),
            (lambda: hardball.Box(["wall"] * 3, None), "size.*give real numbers"),
        ]:
            with self.assertRaisesRegex(hardball.Error, message):
                make()

    def test_faces_of_boxes(self):
        faces = {"z_min": {"temperature": 2.0, "velocity": (1.0, 0.0, 0.0), "seed": 3}, "x_max": {"restitution": 0.5}}
        box = hardball.Box.walls(8, faces=faces)
        self.assertEqual(box.faces, faces)
        self.assertEqual(hardball.Box.walls(8).faces, {})
        self.assertNotEqual(box, hardball.Box.walls(8))
        by_boundary = hardball.Box(["wall"] * 3, [8] * 3, faces=faces)
        for copy in (eval(repr(box)), pickle.loads(pickle.dumps(box)), by_boundary):
            self.assertEqual(copy, box)
        for wrong, message in [
            ({"floor": {}}, "z_min"),
            ({"z_min": 2.0}, "z_min: it is not a dict"),
            ({"z_min": {"temprature": 2.0}}, "'temprature'"),
            ({"z_min": {"temperature": "hot"}}, "temperature"),
            ({"z_min": {"velocity": [0, 0, 1]}}, "along z"),
            ([1], "faces"),
        ]:
            with self.subTest(message), self.assertRaisesRegex(hardball.Error, message):
                hardball.Box.walls(8, faces=wrong)
        with self.assertRaisesRegex(hardball.Error, "z_min"):
            hardball.Box(["wall", "wall", "periodic"], [8, 8, 8], faces={"z_min": {"temperature": 1.0}})

    def test_a_thermal_face_heats(self):
        hot = hardball.Box.walls(8.0, faces={"z_min": {"temperature": 100.0}})
        simulation = hardball.Simulation(hot, positions=[[4, 4, 2]], velocities=[[0, 0, -1]], radius=0.5)
        simulation.run(contacts=1)
        self.assertGreater(simulation.velocities[0, 2], 0)
        self.assertNotEqual(simulation.velocities[0, 0], 0)


class Calls(unittest.TestCase):
    def test_names_of_arguments_that_there_are_not(self):
        simulation = gas()
        contact = simulation.contacts_within(1, most=1)[0]
        for call, message in [
            (lambda: gas(radii=0.5), "Simulation: unknown argument radii=; did you mean radius=?"),
            (lambda: gas(masses=1), "Simulation: unknown argument masses=; did you mean mass=?"),
            (lambda: gas(temperature=1), "Simulation: unknown argument temperature=; it takes box, positions, "),
            (lambda: simulation.run(untill=1), "Simulation.run: unknown argument untill=; did you mean until=?"),
            (lambda: simulation.set_velocity(1, velocity=[0, 0, 0]), "did you mean velocities=?"),
            (lambda: simulation.add([1, 1, 1], radii=1), "did you mean radius=?"),
            (lambda: hardball.Box.periodic(sise=1), "Box.periodic: unknown argument sise=; did you mean size=?"),
            (lambda: hardball.Box(boundaries=5, size=5), "did you mean boundary=?"),
            (lambda: hardball.Bounce(restitutions=0.5), "did you mean restitution=?"),
            (lambda: hardball.Surface.plane([0, 0, 1], amplitud=1), "did you mean amplitude=?"),
            (lambda: hardball.Outcome(contact, contact.before, spin=None), "did you mean spins=?"),
        ]:
            with self.assertRaises(hardball.Error) as caught:
                call()
            self.assertIsInstance(caught.exception, TypeError)
            self.assertIn(message, str(caught.exception))

    def test_arguments_that_do_not_fit(self):
        simulation = gas()
        for call, message in [
            (lambda: hardball.Andersen("hot", 1), "it takes (temperature: float, rate: float)"),
            (lambda: hardball.Box.walls(), "Box.walls: these arguments do not fit; it takes (size: ArrayLike, *, faces: "),
            (lambda: simulation.contacts_within("long"), "it takes (duration: float, most: Optional[int] = None)"),
            (lambda: "7" in simulation, "it takes (id: int)"),
            (lambda: simulation.first_contact(0.5, [0, 0, 0], 1), "it takes (id: int, velocity: ArrayLike, until: float)"),
        ]:
            with self.assertRaises(hardball.ArgumentError) as caught:
                call()
            self.assertIn(message, str(caught.exception))
            self.assertNotIn("Invoked with", str(caught.exception))
        with self.assertRaisesRegex(hardball.Error, "until.*give"):
            simulation.until = "late"
        with self.assertRaisesRegex(hardball.Error, "names.*give a list of str"):
            simulation.measure([1])
        with self.assertRaisesRegex(hardball.Error, "every.*give a number"):
            simulation.measure("pressure", every="often")

    def test_errors_of_functions_called_stay_as_they_are(self):
        simulation = gas()

        def listener(contact):
            raise TypeError("mine")

        simulation.on_contact(listener)
        with self.assertRaisesRegex(TypeError, "^mine$"):
            simulation.run(contacts=1)


class Numbers(unittest.TestCase):
    def test_of_contacts_may_be_written_as_floats(self):
        simulation = gas()
        self.assertEqual(simulation.run(contacts=1e2), 100)
        self.assertEqual(simulation.run(contacts=np.int32(5)), 5)
        for limits in ({"collisions": 2.5}, {"collisions": -1}, {"contacts": "many"}, {"until": "5"}, {"until": [1]}):
            with self.assertRaisesRegex(hardball.Error, "give a (whole )?number"):
                simulation.run(**limits)

    def test_of_spheres_may_be_those_of_numpy(self):
        simulation = gas()
        self.assertEqual(simulation.clearance(simulation.ids[3]).distance, simulation.clearance(3).distance)
        with self.assertRaisesRegex(hardball.Error, "whole numbers from 0"):
            simulation.clearance(-1)

    def test_progress_of_a_run_that_is_past_its_end(self):
        simulation = gas()
        simulation.until = 0.5
        simulation.run(until=1)
        with contextlib.redirect_stderr(io.StringIO()):
            self.assertEqual(simulation.run(contacts=100, progress=True), 100)

    def test_file_names_may_be_any_bytes(self):
        for read in (hardball.Simulation.from_file, hardball.Simulation.from_scenario, hardball.Simulation.load):
            with self.assertRaisesRegex(hardball.Error, "cannot be read"):
                read("a\udcff.xyz")

    def test_what_is_no_box_no_dict_or_no_atoms(self):
        with self.assertRaisesRegex(hardball.Error, "box.*hardball.Box.periodic"):
            hardball.Simulation(8.0, positions=[[1, 1, 1]])
        with self.assertRaisesRegex(hardball.Error, "give one such as"):
            hardball.Simulation.from_scenario({}, overrides="run.seed=7")
        with self.assertRaisesRegex(hardball.Error, "give an ASE Atoms"):
            hardball.Simulation.from_ase(np.zeros((3, 3)))

    def test_vectors_are_read_only(self):
        simulation = gas()
        for vector in (simulation.gravity, simulation.momentum, simulation.positions, hardball.Surface.plane([0, 0, 1]).point):
            with self.assertRaises(ValueError):
                vector[0] = 1


if __name__ == "__main__":
    unittest.main()
