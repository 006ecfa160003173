# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Runs, what they give, and what may be done between them."""

import copy
import json
import math
import pickle
import tempfile
import unittest
import warnings
from pathlib import Path

import numpy as np

import hardball
from support import SCENARIOS, gas, lattice, program


class Runs(unittest.TestCase):
    def test_a_collision_of_two_is_exact(self):
        simulation = hardball.Simulation(
            hardball.Box.open(), positions=[[0, 0, 0], [4, 0, 0]], velocities=[[1, 0, 0], [0, 0, 0]], mass=[1, 2]
        )
        coming = simulation.next_event()
        self.assertEqual((coming.time, coming.kind, coming.first, coming.second), (2.0, "collision", 0, 1))
        self.assertEqual(simulation.run(until=10), 1)
        np.testing.assert_allclose(simulation.velocities, [[-1 / 3, 0, 0], [2 / 3, 0, 0]], rtol=1e-15)
        self.assertEqual(simulation.time, 10)
        self.assertIsNone(simulation.next_event(until=100))

    def test_limits(self):
        simulation = gas()
        self.assertEqual(simulation.run(contacts=7), 7)
        self.assertEqual(simulation.collisions, 7)
        simulation.run(collisions=10)
        self.assertEqual(simulation.collisions, 17)
        self.assertEqual(simulation.run(contacts=0), 0)
        simulation.run(until=1.0, collisions=10**9)
        self.assertEqual(simulation.time, 1.0)

    def test_collisions_are_counted_apart_from_contacts_with_walls(self):
        simulation = gas(box=hardball.Box.walls(lattice()[1]))
        contacts = simulation.run(collisions=50)
        self.assertEqual(simulation.collisions, 50)
        self.assertEqual(contacts, 50 + simulation.wall_contacts)
        self.assertGreater(simulation.wall_contacts, 0)

    def test_a_run_without_a_limit_is_refused(self):
        with self.assertRaisesRegex(hardball.Error, "give until, collisions or contacts"):
            gas().run()

    def test_events_are_those_of_a_run(self):
        whole = gas().run(until=1, record=True)
        simulation = gas()
        times = []
        for contact in simulation.events(until=1):
            self.assertEqual(simulation.time, contact.time)
            times.append((contact.time, contact.first, contact.second, contact.normal_speed))
        self.assertEqual(simulation.time, 1)
        self.assertEqual(times, [(e["time"], e["first"], e["second"], e["normal_speed"]) for e in whole])

    def test_an_edit_between_events_changes_what_follows(self):
        simulation = gas()
        for contact in simulation.events(until=0.5):
            simulation.set_velocity(contact.first, [0, 0, 0])
            np.testing.assert_array_equal(simulation.velocities[contact.first], 0)
        self.assertNotEqual(simulation.event_log_hash, self.hash_after(gas(), 0.5))

    def test_threads_change_no_event(self):
        simulation = gas()
        self.assertEqual(simulation.threads, 1)
        simulation.run(until=0.3)
        simulation.threads = 2
        self.assertEqual(simulation.threads, 2)
        self.assertEqual(self.hash_after(simulation, 1), self.hash_after(gas(), 1))
        np.testing.assert_array_equal(simulation.positions, self.run_until(gas(), 1).positions)
        with self.assertRaisesRegex(hardball.Error, "threads cannot share a response that is a function"):
            simulation.respond_with(lambda contact: contact.elastic())

    def run_until(self, simulation, until):
        simulation.run(until=until)
        return simulation

    def hash_after(self, simulation, until):
        simulation.run(until=until)
        return simulation.event_log_hash

    def test_recorded_events_are_those_of_the_event_log(self):
        with tempfile.TemporaryDirectory() as folder:
            options = ["--set", "output.event_log=true", "--until", "2", "--quiet"]
            program("run", SCENARIOS / "paper.toml", *options, "--out", Path(folder) / "out")
            logged = np.load(Path(folder) / "out" / "events.npy")
        recorded = hardball.Simulation.from_scenario(SCENARIOS / "paper.toml").run(until=2, record=True)
        self.assertGreater(len(logged), 1000)
        self.assertTrue(np.any(logged["kind"] == 1))
        self.assertEqual(sorted(recorded.dtype.names), sorted(logged.dtype.names))
        for name in recorded.dtype.names:
            np.testing.assert_array_equal(recorded[name], logged[name], name)

    def test_recording_changes_nothing(self):
        simulation = gas()
        simulation.run(until=1, record=True)
        self.assertEqual(simulation.event_log_hash, self.hash_after(gas(), 1))
        self.assertEqual(len(simulation.run(until=simulation.time, record=True)), 0)

    def test_progress_is_shown(self):
        times = []
        gas()._run(2.0, None, None, False, times.append)
        self.assertEqual(times[-1], 2.0)
        self.assertEqual(gas().run(until=0.1, progress=True), gas().run(until=0.1))

    def test_what_is_ahead_is_what_happens(self):
        simulation = gas()
        ahead = simulation.contacts_within(0.3)
        self.assertEqual([c.time for c in simulation.contacts_within(0.3, most=3)], [c.time for c in ahead[:3]])
        self.assertEqual([c.time for c in simulation.events(until=0.3)], [c.time for c in ahead])

    def test_the_next_event_is_found_on_every_scale(self):
        for scale in (1e-20, 1.0, 1e20):
            box = hardball.Box.periodic(10 * scale)
            positions = scale * np.array([[1, 1, 1], [5, 1, 1]])
            simulation = hardball.Simulation(box, positions=positions, velocities=[[1, 0, 0], [0, 0, 0]], radius=scale)
            self.assertAlmostEqual(simulation.next_event().time / scale, 2)
            self.assertIsNone(simulation.next_event(until=scale))
            simulation.run(contacts=1)
            self.assertAlmostEqual(simulation.next_event().time / scale, 8)
        self.assertIsNone(hardball.Simulation(hardball.Box.open(), positions=[]).next_event())

    def test_positions_between_events(self):
        simulation = gas()
        time = simulation.next_event().time / 2
        expected = simulation.positions + time * simulation.velocities
        ahead = simulation.positions_at(time)
        np.testing.assert_allclose(np.mod(ahead, simulation.box.size), np.mod(expected, simulation.box.size), atol=1e-14)
        with self.assertRaisesRegex(hardball.Error, "there is a contact"):
            simulation.positions_at(5.0)

    def test_queries(self):
        simulation = hardball.Simulation(hardball.Box.open(), positions=[[0, 0, 0], [4, 0, 0]])
        self.assertEqual(simulation.first_contact(0, [1, 0, 0], until=10).time, 2)
        self.assertIsNone(simulation.first_contact(0, [-1, 0, 0], until=10))
        hit = simulation.ray([-5, 0, 0], [1, 0, 0], most=100)
        self.assertEqual((hit.kind, hit.body, hit.distance), ("collision", 0, 4.0))
        self.assertEqual(simulation.clearance(0).distance, 2)
        self.assertEqual(simulation.clearance([2, 0, 3]).body, 0)

    def test_a_ray_enters_all_that_lies_on_it(self):
        simulation = hardball.Simulation(hardball.Box.walls(10), positions=[[2, 5, 5], [6, 5, 5]], radius=0.5)
        hits = [(hit.kind, hit.body, hit.distance) for hit in simulation.ray_hits([0, 5, 5], [2, 0, 0], most=100)]
        self.assertEqual(hits, [("collision", 0, 1.5), ("collision", 1, 5.5), ("wall", 1, 10.0)])
        self.assertEqual(len(simulation.ray_hits([0, 5, 5], [2, 0, 0], most=3)), 1)
        # Images are hits of their own, also beyond the length at which a search looks up.
        lone = hardball.Simulation(hardball.Box.periodic(10), positions=[[5, 5, 5]], radius=0.5)
        far = lone.ray_hits([0, 5, 5], [1, 0, 0], most=5000)
        np.testing.assert_array_equal([hit.distance for hit in far], 4.5 + 10 * np.arange(500))

    def test_many_rays_hit_what_each_of_them_hits(self):
        random = np.random.default_rng(2)
        dense = gas()
        sparse = hardball.Simulation(hardball.Box.periodic(2000), positions=[[100, 100, 100], [1500, 100, 100]], radius=0.5)
        sparse_ways = np.concatenate([np.eye(3), random.normal(size=(7, 3))])
        for simulation, origins, ways, most in (
            (dense, random.uniform(0, 8, (50, 3)), random.normal(size=(50, 3)), 5),
            (sparse, np.tile([200.0, 100, 100], (10, 1)), sparse_ways, 1e4),
        ):
            hits = simulation.rays(origins, ways, most)
            self.assertEqual(hits.shape, (len(ways),))
            self.assertEqual(hits.tobytes(), simulation.rays(origins, ways, most, threads=3).tobytes())
            kinds = set()
            for origin, way, found in zip(origins, ways, hits):
                hit = simulation.ray(origin, way, most)
                kinds.add(int(found["kind"]))
                if hit is None:
                    self.assertEqual((found["kind"], found["body"], found["distance"]), (2, 2**32 - 1, np.inf))
                    self.assertTrue(np.isnan([found["point"], found["normal"]]).all())
                    continue
                self.assertEqual((found["kind"], found["body"], found["distance"]), (0, hit.body, hit.distance))
                np.testing.assert_array_equal([found["point"], found["normal"]], [hit.point, hit.normal])
            self.assertEqual(kinds, {0, 2})

    def test_one_vector_stands_for_all_rays(self):
        simulation = hardball.Simulation(hardball.Box.walls(10), positions=[[5, 5, 5]], radius=0.5)
        ways = np.concatenate([np.eye(3), -np.eye(3)])
        around = simulation.rays([2.0, 2, 2], ways, most=100)
        np.testing.assert_array_equal(around["kind"], 1)
        np.testing.assert_array_equal(around["body"], [1, 3, 5, 0, 2, 4])
        np.testing.assert_array_equal(around["distance"], [8, 8, 8, 2, 2, 2])
        np.testing.assert_array_equal(simulation.rays([[1.0, 5, 5], [1, 6, 5]], [1, 0, 0], 100)["distance"], [3.5, 9])
        self.assertEqual(simulation.rays([1, 5, 5], [1, 0, 0], 100).shape, (1,))
        self.assertEqual(simulation.rays(np.empty((0, 3)), [1, 0, 0], 100).shape, (0,))
        flat = hardball.Simulation(hardball.Box.flat_walls(10), positions=[[5, 5]], radius=0.5)
        np.testing.assert_array_equal(flat.rays([1, 5], [[1, 0], [0, 1]], 100)["distance"], [3.5, 5])
        for arguments, problem in (
            (([[1, 1, 1]] * 2, [[1, 1, 1]] * 3, 5), "2 origins and 3 directions"),
            (([1, 1, 1], [1, 0, 0], 5, 0), "there are no threads"),
            (([1, 1, 1], [0, 0, 0], 5), "direction"),
            (([1, 1, 1], [[1, 0]], 5), "directions: .*three dimensions"),
            (([[[1, 1, 1]]], [1, 0, 0], 5), "origins: .*shape"),
        ):
            with self.assertRaisesRegex(hardball.Error, problem):
                simulation.rays(*arguments)

    def test_spheres_in_a_ball_or_a_box(self):
        simulation = hardball.Simulation(hardball.Box.walls(10), positions=[[2, 5, 5], [6, 5, 5]], radius=0.5)
        found = simulation.overlap([4, 5, 5], 1.75)
        self.assertEqual((found.dtype, found.tolist()), (np.uint32, [0, 1]))
        self.assertEqual(simulation.overlap([4, 5, 5], radius=1.5).tolist(), [])  # touches both
        self.assertEqual(simulation.overlap(low=[2.25, 0, 0], high=[5.5, 10, 10]).tolist(), [0])
        flat = hardball.Simulation(hardball.Box.flat_walls(10), positions=[[2, 5], [6, 5]], radius=0.5)
        self.assertEqual(flat.overlap(low=[2.25, 0], high=[5.5, 10]).tolist(), [0])
        self.assertEqual(flat.overlap([6, 4], 1).tolist(), [1])
        for arguments, options in (((), {}), (([1, 1, 1],), {}), ((), {"radius": 1}), ((), {"low": [1, 1, 1]})):
            with self.assertRaisesRegex(hardball.Error, "give either center and radius, or low and high"):
                simulation.overlap(*arguments, **options)
        for options in ({"center": [1, 1, 1]}, {"radius": 1}):
            with self.assertRaisesRegex(hardball.Error, "give either center and radius, or low and high"):
                simulation.overlap(low=[0, 0, 0], high=[1, 1, 1], **options)
        for options in ({"center": [1, 1, 1], "radius": -1}, {"low": [3, 3, 3], "high": [2, 4, 4]}):
            with self.assertRaises(hardball.Error):
                simulation.overlap(**options)

    def test_queries_look_for_some_bodies(self):
        simulation = hardball.Simulation(
            hardball.Box.walls(10), positions=[[2, 5, 5], [6, 5, 5]], radius=0.5, species=[0, 3]
        )
        simulation.set_user_data([0, 1], [1, 2**63])
        line = ([0, 5, 5], [1, 0, 0], 100)
        for mask in ({"species": 3}, {"species": [3, 7]}, {"groups": 2**63 + 2}, {"species": np.array([3, 0]), "groups": 2**63}):
            self.assertEqual(simulation.ray(*line, **mask).body, 1)
            self.assertEqual(simulation.rays(*line, **mask)["body"].tolist(), [1])
            self.assertEqual([hit.body for hit in simulation.ray_hits(*line, **mask, walls=False)], [1])
            self.assertEqual(simulation.clearance([5, 5, 9], **mask, walls=False).body, 1)
            self.assertEqual(simulation.clearance(0, **mask, walls=False).body, 1)
            self.assertEqual(simulation.overlap([4, 5, 5], 3, **mask).tolist(), [1])
            self.assertEqual(simulation.overlap(low=[1, 4, 4], high=[7, 6, 6], **mask).tolist(), [1])
        self.assertEqual(simulation.ray(*line, species=3, groups=1).kind, "wall")
        self.assertIsNone(simulation.ray(*line, species=3, groups=1, walls=False))
        self.assertEqual(simulation.clearance([5, 5, 9]).kind, "wall")
        self.assertEqual(simulation.overlap([4, 5, 5], 3, groups=0).tolist(), [])
        self.assertEqual(simulation.overlap([4, 5, 5], 3, groups=None, species=None).tolist(), [0, 1])
        for mask, problem in (
            ({"species": []}, "species: there are none"),
            ({"species": 256}, "species: .*from 0 to 255"),
            ({"species": "red"}, "species: "),
            ({"groups": -1}, "it takes .*groups"),
            ({"walls": "no"}, "it takes .*walls"),
            ({"group": 1}, "did you mean groups="),
        ):
            with self.assertRaisesRegex(hardball.Error, problem):
                simulation.ray(*line, **mask)

    def test_user_data_stays_with_a_sphere(self):
        simulation = gas()
        np.testing.assert_array_equal(simulation.user_data, np.zeros(125, np.uint64))
        simulation.set_user_data(3, 2**64 - 1)
        simulation.set_user_data([5, 4], np.array([7, 8], np.uint16))
        simulation.set_user_data([1, 2], 9)
        before = [0, 9, 9, 2**64 - 1, 8, 7, 0]
        self.assertEqual(simulation.user_data[:7].tolist(), before)
        simulation.run(until=1)
        self.assertEqual(hardball.Simulation.load(simulation.save()).user_data[:7].tolist(), before)
        simulation.remove(0)
        self.assertEqual(simulation.user_data[:6].tolist(), before[1:])
        for ids, data in (([1, 0], 5), (1, -1), (1, 2**64), (1, 0.5), (1, True), ([1, 2], [1]), (1, "a"), ([1, 2], [[1, 2]])):
            with self.assertRaises(hardball.Error):
                simulation.set_user_data(ids, data)
        self.assertEqual(simulation.user_data[:6].tolist(), before[1:])


class Scenarios(unittest.TestCase):
    def test_hashes_are_those_of_the_command_line(self):
        for path in sorted(SCENARIOS.glob("*.toml")):
            with self.subTest(path.stem):
                simulation = hardball.Simulation.from_scenario(path)
                simulation.run(until=min(simulation.until, 0.5))
                with tempfile.TemporaryDirectory() as folder:
                    options = ["--until", simulation.time, "--quiet", "--json", "--out", Path(folder) / "out"]
                    summary = json.loads(program("run", path, *options))
                self.assertEqual(simulation.event_log_hash, summary["event_log_hash"])
                self.assertEqual(simulation.collisions, summary["events"]["collision"])

    def test_a_dict_says_what_a_file_says(self):
        scenario = {
            "box": {"size": [8, 8.0, 8], "boundary": ["periodic", "wall", "periodic"]},
            "spheres": [{"count": np.int64(50), "radius": 0.4, "temperature": 1.0, "placement": "random"}],
            "response": {"restitution": 0.9},
            "run": {"until": 2.0, "seed": 3},
        }
        text = """
            box = {size = [8, 8, 8], boundary = ["periodic", "wall", "periodic"]}
            run = {until = 2.0, seed = 3}
            response = {restitution = 0.9}
            [[spheres]]
            count = 50
            radius = 0.4
            temperature = 1
            placement = "random"
        """
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "same.toml"
            path.write_text(text)
            from_file = hardball.Simulation.from_scenario(path)
        from_dict = hardball.Simulation.from_scenario(scenario)
        self.assertEqual(from_dict.until, 2.0)
        from_dict.run()
        from_file.run()
        self.assertEqual(from_dict.time, 2.0)
        self.assertGreater(from_dict.collisions, 0)
        self.assertEqual(from_dict.event_log_hash, from_file.event_log_hash)

    def test_overrides(self):
        first = hardball.Simulation.from_scenario(SCENARIOS / "paper.toml", overrides={"spheres.0.count": 100})
        self.assertEqual(len(first), 100)

    def test_errors_say_where(self):
        with self.assertRaisesRegex(hardball.Error, "scenario:1:.*unknown key 'sise'"):
            hardball.Simulation.from_scenario({"box": {"sise": [1, 1, 1]}})
        with self.assertRaisesRegex(hardball.Error, "no_such.toml"):
            hardball.Simulation.from_scenario("no_such.toml")
        with self.assertRaisesRegex(hardball.Error, "no value such as None"):
            hardball.Simulation.from_scenario({"box": None})

    def test_text_needs_no_care(self):
        name = 'a "quoted"\n\\ name\x7f'
        with self.assertRaises(hardball.Error) as caught:
            hardball.Simulation.from_scenario({"box": {"size": [9] * 3, "boundary": ["open"] * 3}, "start": {"file": name}})
        self.assertIn("quoted", str(caught.exception))


class Files(unittest.TestCase):
    def test_warns_where_the_start_file_has_another_box(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "start.xyz"
            path.write_text(
                '1\nLattice="9 0 0 0 9 0 0 0 9" Properties=pos:R:3:velo:R:3:radius:R:1\n5 5 5 1 0 0 0.5\n'
            )
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                hardball.Simulation.from_file(path)
            with self.assertWarnsRegex(UserWarning, "is not that of"):
                hardball.Simulation.from_file(path, overrides={"box.size": [10.0, 10.0, 10.0]})

    def test_from_a_data_file_of_lammps_whose_spheres_overlap(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "start.data"
            path.write_text(
                "title\n\n2 atoms\n1 atom types\n\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nAtoms # sphere\n\n"
                "1 1 1 2 1 1 1\n2 1 1 2 1.999999 1 1\n\nVelocities\n\n1 1 0 0 0 0 0\n2 0 0 0 0 0 0\n"
            )
            with self.assertRaisesRegex(hardball.Error, "shrink = true"):
                hardball.Simulation.from_file(path)
            with self.assertWarnsRegex(UserWarning, "multiplied by 0.99999"):
                simulation = hardball.Simulation.from_file(path, overrides={"start.shrink": True})
        np.testing.assert_allclose(simulation.radii, 0.999999 / 2, rtol=1e-15)
        np.testing.assert_allclose(simulation.masses, 2 * np.pi / 6, rtol=1e-15)
        self.assertEqual(simulation.velocities[0, 0], 1)

    def test_from_extended_xyz_and_ase(self):
        import ase.io

        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out"
            options = ["--set", "output.snapshots_every=1", "--until", "2", "--quiet", "--out", out]
            program("run", SCENARIOS / "dilute_gas.toml", *options)
            path = out / "trajectory.xyz"
            from_file = hardball.Simulation.from_file(path)
            atoms = ase.io.read(path)
        from_atoms = hardball.Simulation.from_ase(atoms)
        for name in ("positions", "masses", "radii"):
            np.testing.assert_array_equal(getattr(from_atoms, name), getattr(from_file, name))
        np.testing.assert_allclose(from_atoms.velocities, from_file.velocities, rtol=1e-15)
        self.assertEqual(from_atoms.run(until=1), from_file.run(until=1))

    def test_kinematic_spheres_come_back_from_ase(self):
        import ase.io

        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "start.csv").write_text("x,y,z,vx,vy,vz,radius,mass\n1,2,3,0.5,0,0,0.5,inf\n4,5,6,0,-1,0,0.5,2\n")
            program("convert", Path(folder) / "start.csv", Path(folder) / "start.xyz")
            simulation = hardball.Simulation.from_ase(ase.io.read(Path(folder) / "start.xyz"))
        self.assertEqual(list(simulation.masses), [math.inf, 2])
        np.testing.assert_array_equal(simulation.velocities, [[0.5, 0, 0], [0, -1, 0]])

    def test_atoms_without_radii_or_right_angles_are_refused(self):
        import ase

        with self.assertRaisesRegex(hardball.Error, "no radii"):
            hardball.Simulation.from_ase(ase.Atoms("Ar", cell=[9, 9, 9], pbc=True))
        with self.assertRaisesRegex(hardball.Error, "not rectangular"):
            hardball.Simulation.from_ase(ase.Atoms("Ar", cell=[9, 9, 9, 90, 80, 90], pbc=True), radius=1)
        # The angles of a cell that is not repeated do not matter; nor do rounding errors.
        for cell, pbc in (([9, 9, 9, 90, 80, 90], False), ([[9, 1e-16, 0], [0, 9, 0], [0, 1e-15, 9]], True)):
            simulation = hardball.Simulation.from_ase(ase.Atoms("Ar", cell=cell, pbc=pbc), radius=1)
            self.assertEqual(simulation.box.boundary[0], "periodic" if pbc else "open")
        walls = hardball.Box.walls(9.0)
        simulation = hardball.Simulation.from_ase(ase.Atoms("Ar", positions=[[4, 4, 4]]), radius=1, box=walls, mass=2.0)
        self.assertEqual((simulation.box, list(simulation.masses)), (walls, [2.0]))


class State(unittest.TestCase):
    def assert_same_future(self, simulation, other):
        self.assertIsInstance(other, hardball.Simulation)
        self.assertEqual(other.event_log_hash, simulation.event_log_hash)
        until = simulation.time + 1
        for each in (simulation, other):
            each.run(until=until)
        self.assertEqual(other.event_log_hash, simulation.event_log_hash)
        np.testing.assert_array_equal(other.positions, simulation.positions)

    def test_copies_and_what_was_saved_go_on_to_the_same(self):
        simulation = gas()
        simulation.measure("pressure")
        simulation.run(until=1)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "saved.hbc"
            simulation.save(path)
            from_file = hardball.Simulation.load(path)
        others = [
            copy.copy(simulation),
            copy.deepcopy(simulation),
            pickle.loads(pickle.dumps(simulation)),
            hardball.Simulation.load(simulation.save()),
            from_file,
        ]
        for other in others:
            self.assert_same_future(copy.copy(simulation), other)
        self.assertEqual(simulation.time, 1, "copies are independent")
        simulation.run(until=2)
        for other in others:
            measured = other.results()["pressure"]["compressibility"].value
            self.assertEqual(measured, simulation.results()["pressure"]["compressibility"].value)

    def test_a_checkpoint_of_the_command_line_can_be_loaded(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out"
            program("run", SCENARIOS / "dilute_gas.toml", "--until", "1", "--quiet", "--out", out)
            simulation = hardball.Simulation.load(out / "checkpoint.hbc")
        expected = hardball.Simulation.from_scenario(SCENARIOS / "dilute_gas.toml")
        expected.run(until=1)
        self.assert_same_future(expected, simulation)

    def test_a_response_in_python_is_pickled_with_its_simulation(self):
        simulation = gas(response=stop_at_contact)
        other = pickle.loads(pickle.dumps(simulation))
        self.assert_same_future(simulation, other)
        self.assertLess(simulation.kinetic_energy, gas().kinetic_energy)

    def test_damaged_bytes_are_refused(self):
        saved = gas().save()
        changed = [saved[:k] + bytes([saved[k] ^ 1]) + saved[k + 1 :] for k in range(0, len(saved), 97)]
        for bad in (b"", saved[:100], b"\xff" * 200, *changed):
            with self.assertRaises(hardball.Error):
                hardball.Simulation.load(bad)

    def test_what_goes_with_simulations_can_be_pickled(self):
        simulation = gas()
        simulation.measure(["pressure", "radial_distribution"])
        simulation.run(until=2)
        results = simulation.results()
        again = pickle.loads(pickle.dumps(results))
        self.assertEqual(repr(again["pressure"]["compressibility"]), repr(results["pressure"]["compressibility"]))
        for name, column in results["radial_distribution"].columns.items():
            np.testing.assert_array_equal(again["radial_distribution"][name], column)
        self.assertEqual(f"{again['pressure']['compressibility']:.3f}", f"{float(results['pressure']['compressibility']):.3f}")
        box = hardball.Box(("wall", "periodic", "open"), [3, 4, 0])
        self.assertEqual(copy.copy(box), box)
        table = hardball.ResponseTable(hardball.Merging())
        table.set(0, 1, hardball.Bounce(hardball.ViscoelasticRestitution(0.7, speed=1.0), tangential_restitution=0.5))
        species = np.arange(125) % 2
        runs = [gas(species=species, response=each) for each in (table, pickle.loads(pickle.dumps(table)))]
        for run in runs:
            run.run(until=1)
        self.assertEqual(runs[0].event_log_hash, runs[1].event_log_hash)
        self.assertLess(len(runs[0]), 125)

    def test_bytes_and_files_are_alike(self):
        simulation = gas()
        simulation.until = 7.0
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "saved.hbc"
            simulation.save(path)
            path.with_suffix(".bytes").write_bytes(simulation.save())
            self.assertEqual(path.read_bytes(), simulation.save())
            for saved in (path, path.with_suffix(".bytes"), path.read_bytes(), bytearray(path.read_bytes())):
                self.assertEqual(hardball.Simulation.load(saved).until, 7.0)

    def test_attributes_of_ones_own_are_copied_and_pickled(self):
        simulation = Labeled(hardball.Box.periodic(9.0), positions=[[1, 1, 1]])
        for other in (copy.copy(simulation), copy.deepcopy(simulation), pickle.loads(pickle.dumps(simulation))):
            self.assertIs(type(other), Labeled)
            self.assertEqual(other.label, ["a"])
        self.assertIs(copy.copy(simulation).label, simulation.label)
        self.assertIsNot(copy.deepcopy(simulation).label, simulation.label)

    def test_who_has_not_been_made_says_so(self):
        class Hasty(hardball.Simulation):
            def __init__(self):
                self.until = 5.0

        message = r"call super\(\).__init__"
        with self.assertRaisesRegex(hardball.Error, message):
            Hasty()
        bare = hardball.Simulation.__new__(hardball.Simulation)
        for use in (lambda: repr(bare), lambda: bare.respond_with(None), lambda: bare.positions, lambda: bare.run(1), lambda: bare.until):
            with self.assertRaisesRegex(hardball.Error, message):
                use()
        moved = gas()
        hardball.Simulation._of(moved)
        with self.assertRaisesRegex(hardball.Error, message):
            len(moved)


class Labeled(hardball.Simulation):
    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)
        self.label = ["a"]


def stop_at_contact(contact):
    """A perfectly inelastic response: both move on together."""
    first, second = contact.masses
    together = (first * contact.before[0] + second * contact.before[1]) / (first + second)
    normal = contact.normal
    slide = [v - np.dot(v - together, normal) * normal for v in contact.before]
    return slide


class Edits(unittest.TestCase):
    def test_that_are_wrong_change_nothing(self):
        simulation = gas()
        mask = np.arange(125) < 2
        for bad, message in (
            (mask, r"give numbers, such as ids\[mask\]"),
            ([1, 2, 1], "sphere 1 is given twice"),
            ([1, 500], "500"),
            (-1, "whole numbers from 0"),
        ):
            with self.assertRaisesRegex(hardball.Error, message):
                simulation.remove(bad)
        with self.assertRaisesRegex(hardball.Error, "ids"):
            simulation.set_velocity(mask, [0, 0, 0])
        simulation.measure("pressure")
        for edit in (lambda: simulation.remove(1), lambda: simulation.add([0.1, 0.1, 0.1], radius=0.01)):
            with self.assertRaisesRegex(hardball.Error, r"measure\(\[\]\)"):
                edit()
        self.assertEqual(len(simulation), 125)
        simulation.measure([])
        simulation.remove(simulation.ids[mask])
        self.assertEqual(len(simulation), 123)

    def test_arrays_are_those_after_an_edit_whose_arguments_look_at_them(self):
        simulation = gas()

        class Curious:
            def __array__(self, dtype=None, copy=None):
                simulation.positions
                return np.array([0.1, 0.1, 0.1])

        simulation.add(Curious(), radius=0.01)
        self.assertEqual(len(simulation.positions), 126)

    def test_in_bulk(self):
        simulation = gas()
        simulation.set_velocity(simulation.ids, np.zeros((len(simulation), 3)))
        self.assertEqual(simulation.kinetic_energy, 0)
        simulation.set_velocity([3, 1], [[1, 0, 0], [0, 2, 0]])
        np.testing.assert_array_equal(simulation.velocities[[1, 3]], [[0, 2, 0], [1, 0, 0]])
        places = simulation.positions[[0, 2, 4]]
        simulation.remove([0, 2, 4])
        self.assertEqual(len(simulation), 122)
        self.assertNotIn(0, simulation)
        self.assertIn(1, simulation)
        ids = simulation.add(places[:2], radius=[0.3, 0.4], mass=math.inf)
        np.testing.assert_array_equal(ids, [125, 126])
        np.testing.assert_array_equal(simulation.radii[-2:], [0.3, 0.4])
        self.assertIsInstance(simulation.add(places[2], radius=1e-3), int)

    def test_rows_of_arrays_are_found_by_ids(self):
        simulation = gas()
        self.assertEqual(simulation.index_of(7), 7)
        simulation.remove([0, 5])
        simulation.set_velocity(1, [1, 2, 3])
        self.assertEqual(simulation.index_of(1), 0)
        self.assertIsInstance(simulation.index_of(1), int)
        np.testing.assert_array_equal(simulation.velocities[simulation.index_of(1)], [1, 2, 3])
        np.testing.assert_array_equal(simulation.index_of(simulation.ids), np.arange(123))
        np.testing.assert_array_equal(simulation.index_of([124, 4, 6]), [122, 3, 4])
        np.testing.assert_array_equal(simulation.ids[simulation.index_of([124, 4, 6])], [124, 4, 6])
        self.assertEqual(len(simulation.index_of([])), 0)
        for unknown in (0, 5, 125, [1, 5], [1, 10**6]):
            with self.assertRaisesRegex(hardball.Error, "there is no sphere"):
                simulation.index_of(unknown)
        for bad in (-1, 1.5, [True, False], "one"):
            with self.assertRaisesRegex(hardball.Error, "ids"):
                simulation.index_of(bad)

    def test_under_measures_warn_once_and_are_taken_into_account(self):
        def measured():
            simulation = gas()
            simulation.measure(["pressure"])
            return simulation

        def double(simulation):
            simulation.set_velocity(simulation.ids, 2 * simulation.velocities)

        simulation = measured()
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            simulation.set_velocity(0, [0, 0, 0])  # before the measures begin
        simulation.run(until=1)
        for edit in (
            double,
            lambda each: each.respond_with(0.9),
            lambda each: each.set_thermostat(hardball.Rescale(1.0, 0.1)),
        ):
            other = copy.copy(simulation)
            with self.assertWarnsRegex(UserWarning, r"while measures are on.*measure\(...\) starts them again") as caught:
                edit(other)
            self.assertEqual(caught.filename, __file__)
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                edit(other)
        # Copying, saving and looking ahead edit nothing.
        simulation = gas(response=stop_at_contact)
        simulation.measure("pressure")
        simulation.run(until=1)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            copy.copy(simulation)
            pickle.loads(pickle.dumps(simulation))
            simulation.contacts_within(0.1)
        # The kinetic part, which is followed from contact to contact, is that of the new velocities.
        simulation = measured()
        simulation.run(until=1)
        kinetic = simulation.kinetic_energy
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            simulation.set_velocity(simulation.ids, np.zeros((125, 3)))
        simulation.run(until=4)
        pressure = simulation.results()["pressure"]["pressure"]
        self.assertTrue(math.isnan(pressure.theory))
        self.assertLess(pressure.value, 2 * kinetic / (3 * simulation.box.volume))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            simulation.measure("pressure")
            double(simulation)

    def test_of_what_is_not_there(self):
        simulation = gas()
        for call in (lambda: simulation.set_velocity(125, [0, 0, 0]), lambda: simulation.remove(125)):
            with self.assertRaisesRegex(hardball.Error, "125"):
                call()
        with self.assertRaisesRegex(hardball.Error, "overlap"):
            simulation.add(simulation.positions[7])

    def test_thermostats(self):
        for thermostat in (hardball.Andersen(2.0, 1.0), hardball.Rescale(2.0, 0.1), hardball.Heating(1.0, 0.1)):
            simulation, again = (gas(thermostat=thermostat, seed=5) for _ in range(2))
            for each in (simulation, again):
                each.run(until=3)
            self.assertGreater(simulation.kinetic_energy, 1.2 * gas().kinetic_energy)
            self.assertEqual(simulation.event_log_hash, again.event_log_hash)

    def test_what_follows_from_the_state(self):
        simulation = gas()
        volume = 125 * math.pi / 6
        self.assertAlmostEqual(simulation.packing_fraction, volume / simulation.box.volume, places=14)
        self.assertTrue(math.isnan(hardball.Simulation(hardball.Box.open(), positions=[[0, 0, 0]]).packing_fraction))
        # In a periodic box the drift does not count, nor its degrees of freedom.
        relative = simulation.velocities - simulation.velocities.mean(axis=0)
        self.assertAlmostEqual(simulation.temperature, np.sum(relative**2) / (3 * 124), places=13)
        np.testing.assert_array_equal(simulation.moments, 0.4)
        self.assertIsNone(simulation.thermostat)
        simulation.set_thermostat(hardball.Heating(0.5, 0.25))
        self.assertEqual((simulation.thermostat.strength, simulation.thermostat.every), (0.5, 0.25))

    def test_growth(self):
        simulation = gas()
        self.assertIsNone(simulation.growth)
        before = simulation.packing_fraction
        radii = simulation.radii.copy()
        simulation.grow(0.1, packing_fraction=1.5 * before)
        self.assertEqual(simulation.growth, "growing")
        while simulation.growth == "growing":
            simulation.run(collisions=100)
        self.assertEqual(simulation.growth, "reached")
        self.assertAlmostEqual(simulation.packing_fraction, 1.5 * before, places=12)
        np.testing.assert_allclose(simulation.radii, radii * 1.5 ** (1 / 3), rtol=1e-12)
        simulation.stop_growing()
        self.assertIsNone(simulation.growth)
        with self.assertRaisesRegex(hardball.Error, "packing_fraction"):
            simulation.grow(-0.1)
        with self.assertRaisesRegex(hardball.Error, "rate"):
            simulation.grow(0.0)

    def test_measures(self):
        simulation = gas()
        simulation.measure(["temperature", "radial_distribution"], every=0.1)
        simulation.run(until=5)
        results = simulation.results()
        self.assertEqual(sorted(results), ["radial_distribution", "temperature"])
        temperature = results["temperature"]["temperature"]
        # In a box at rest, 3 degrees of freedom less.
        drift = simulation.momentum @ simulation.momentum / (2 * len(simulation))
        expected = 2 * (simulation.kinetic_energy - drift) / (3 * len(simulation) - 3)
        self.assertAlmostEqual(float(temperature), expected, places=10)
        frame = results["radial_distribution"].to_frame()
        self.assertEqual(list(frame.columns), list(results["radial_distribution"].columns))
        self.assertGreater(frame["g"].max(), 1)
        with self.assertRaises(KeyError):
            results["temperature"]["no_such"]
        with self.assertRaisesRegex(hardball.Error, "no_such"):
            simulation.measure("no_such")
        self.assertIn("pressure", hardball.measure_names())


if __name__ == "__main__":
    unittest.main()
