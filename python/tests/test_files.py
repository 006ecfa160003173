# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Files that simulations write, and files that are read frame by frame."""

import builtins
import importlib.util
import os
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

import hardball
from support import gas, lattice, program

SCENARIO = {
    "box": {"packing_fraction": 0.2, "boundary": ["periodic"] * 3},
    "spheres": [{"count": 100, "radius": 0.5, "placement": "random", "temperature": 1.0}],
    "run": {"until": 2.0, "seed": 3},
}
SEQUENCES = ["a.xyz", "a.xyz.zst", "a.gsd", "a.lammpstrj", "a.sph"]
SINGLES = ["a.csv", "a.npy", "a.data"]


def is_installed(package):
    return importlib.util.find_spec(package) is not None


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)


class Writing(InFolder):
    def test_frames_are_appended_and_read_back(self):
        for name in SEQUENCES:
            with self.subTest(name):
                simulation = gas()
                for time in (0.0, 0.5, 1.0):
                    simulation.run(until=time)
                    simulation.write(name, append=True)
                    self.assertEqual(len(hardball.read(name)), round(2 * time) + 1)
                last = hardball.read(name)[-1]
                np.testing.assert_allclose(last.positions, simulation.positions, rtol=1e-14, atol=1e-14)
                np.testing.assert_array_equal(last.radii, simulation.radii)
                np.testing.assert_array_equal(last.ids, simulation.ids)

    def test_files_of_another_simulation_are_continued(self):
        for name in SEQUENCES:
            with self.subTest(name):
                gas().write(name)
                before = Path(name).read_bytes()
                gas(seed=2).write(name, append=True)
                self.assertEqual(len(hardball.read(name)), 2)
                if not name.endswith(".gsd"):
                    self.assertTrue(Path(name).read_bytes().startswith(before))

    def test_a_file_is_replaced_unless_it_is_continued(self):
        simulation = gas()
        for name in SEQUENCES + SINGLES:
            with self.subTest(name):
                simulation.write(name)
                simulation.write(name)
                self.assertEqual(len(hardball.read(name)), 1)
        simulation.write("a.xyz", append=True)
        os.remove("a.xyz")
        simulation.write("a.xyz", append=True)
        self.assertEqual(len(hardball.read("a.xyz")), 1)

    def test_formats_with_a_single_frame_are_not_continued(self):
        for name in SINGLES:
            with self.subTest(name), self.assertRaisesRegex(hardball.Error, "single frame"):
                gas().write(name, append=True)
            self.assertFalse(os.path.exists(name))
        with self.assertRaisesRegex(hardball.Error, "unknown file extension"):
            gas().write("a.pdb")

    def test_a_damaged_file_is_not_continued(self):
        gas().write("a.xyz")
        with open("a.xyz", "a") as file:
            file.write("125\nwords\n")
        with self.assertRaises(hardball.Error):
            gas().write("a.xyz", append=True)

    def test_writing_changes_no_event(self):
        simulation, other = gas(), gas()
        for time in (0.3, 0.7, 1.0):
            simulation.run(until=time)
            simulation.write("a.gsd", append=True)
        other.run(until=1.0)
        self.assertEqual(simulation.event_log_hash, other.event_log_hash)

    def test_a_report_and_a_summary(self):
        simulation = gas()
        simulation.measure("pressure")
        simulation.run(until=5)
        simulation.report("report.html")
        page = Path("report.html").read_text()
        self.assertIn("<svg", page)
        self.assertIn(simulation.event_log_hash, page)
        summary = simulation.summary()
        self.assertEqual(summary["event_log_hash"], simulation.event_log_hash)
        self.assertEqual(summary["events"]["collision"], simulation.collisions)
        self.assertEqual(summary["time"], 5)


class Output(InFolder):
    def test_files_are_those_of_the_program(self):
        keys = {"snapshots_every": 0.5, "event_log": True, "recording": True}
        simulation = hardball.Simulation.from_scenario(SCENARIO)
        with simulation.output("python", **keys, trajectory=["xyz", "gsd"]):
            simulation.run(until=0.7)
            for _ in simulation.events(until=1.2):
                pass
            simulation.run(collisions=50)
            simulation.run()
        text = "".join(f"{key} = {_toml(value)}\n" for key, value in SCENARIO.items())
        Path("gas.toml").write_text(text)
        settings = [f"--set=output.{key}={_toml(value)}" for key, value in keys.items()]
        program("run", "gas.toml", "--out", "program", "--quiet", "--set", 'output.trajectory=["xyz", "gsd"]', *settings)
        for name in ("trajectory.xyz", "trajectory.gsd", "events.npy"):
            self.assertEqual(Path("python", name).read_bytes(), Path("program", name).read_bytes(), name)
        python, other = hardball.read("python/recording.hbr"), hardball.read("program/recording.hbr")
        np.testing.assert_array_equal(python.contacts(), other.contacts())
        self.assertTrue(Path("python/report.html").exists())

    def test_snapshots_come_at_times_and_after_contacts(self):
        simulation = gas()
        with simulation.output("times", first_snapshot=0.1, snapshots_per_decade=2, trajectory="gsd"):
            simulation.run(until=1)
        times = [frame.time for frame in hardball.read("times/trajectory.gsd")]
        np.testing.assert_allclose(times, [0, 0.1, 0.1 * 10**0.5, 1], rtol=1e-12)
        simulation = gas()
        with simulation.output("contacts", snapshots_every_contacts=20):
            simulation.run(contacts=50)
            for _ in zip(range(15), simulation.events()):
                pass
        self.assertEqual(len(hardball.read("contacts/trajectory.xyz")), 4)
        # From the middle of a run on, those that are left.
        with simulation.output("rest", snapshots_every=0.5, trajectory="gsd"):
            begin = simulation.time
            simulation.run(until=2)
        times = [frame.time for frame in hardball.read("rest/trajectory.gsd")]
        self.assertEqual(times, [time for time in (0.0, 0.5, 1.0, 1.5, 2.0) if time >= begin])

    def test_runs_are_resumed_by_python_and_by_the_program(self):
        whole = hardball.Simulation.from_scenario(SCENARIO)
        with whole.output("whole", snapshots_every=0.5, event_log=True):
            whole.run()
        for resume in (self.resume_here, lambda name: program("resume", name, "--quiet")):
            name = f"part_{resume.__name__}"
            part = hardball.Simulation.from_scenario(SCENARIO)
            with part.output(name, snapshots_every=0.5, event_log=True):
                part.run(until=1.2)
            resume(name)
            for file in ("trajectory.xyz", "events.npy"):
                self.assertEqual(Path(name, file).read_bytes(), Path("whole", file).read_bytes(), file)

    def resume_here(self, name):
        simulation = hardball.Simulation.resume(name)
        self.assertEqual(simulation.time, 1.2)
        simulation.run()
        simulation.close()

    def test_a_simulation_that_no_scenario_describes_is_resumed(self):
        simulation = gas()
        with simulation.output("out", snapshots_every=0.5, recording=True, checkpoint_at=[0.75]):
            simulation.run(until=1)
        again = hardball.Simulation.resume("out", checkpoint="checkpoints/0.75.hbc")
        self.assertEqual(again.time, 0.75)
        again.run(until=1)
        again.close()
        self.assertEqual(again.event_log_hash, simulation.event_log_hash)
        self.assertEqual(hardball.read("out/recording.hbr").end, 1)
        loaded = hardball.Simulation.load("out/checkpoint.hbc")
        self.assertEqual(loaded.event_log_hash, simulation.event_log_hash)

    def test_checkpoints_are_written_while_it_runs(self):
        simulation = gas()
        seen = []
        with simulation.output("out", checkpoint_every=1e-3):
            first = Path("out/checkpoint.hbc").stat().st_mtime_ns
            simulation.run(until=60)
            seen.append(hardball.Simulation.load("out/checkpoint.hbc").time)
            self.assertGreater(Path("out/checkpoint.hbc").stat().st_mtime_ns, first)
        self.assertGreater(seen[0], 0)

    def test_measures_and_results_are_written_at_the_end(self):
        simulation = gas()
        simulation.measure(["pressure", "radial_distribution"])
        output = simulation.output("out")
        simulation.run(until=5)
        self.assertTrue(output.is_open)
        self.assertFalse(Path("out/summary.json").exists())
        output.close()
        output.close()
        self.assertFalse(output.is_open)
        self.assertEqual(output.directory, Path("out"))
        self.assertTrue(Path("out/summary.json").exists())
        self.assertTrue(Path("out/measures/radial_distribution.csv").exists())
        self.assertIn("Pressure", Path("out/report.html").read_text())

    def test_an_exception_completes_the_files(self):
        simulation = gas()
        with self.assertRaises(ZeroDivisionError):
            with simulation.output("out", snapshots_every=0.5):
                simulation.run(until=1)
                1 / 0
        self.assertEqual(len(hardball.read("out/trajectory.xyz")), 3)
        self.assertTrue(Path("out/summary.json").exists())

    def test_what_is_wrong_is_refused(self):
        simulation = gas()
        with self.assertRaisesRegex(hardball.Error, "no directory is given"):
            simulation.output()
        with self.assertRaisesRegex(hardball.Error, "trajectory is \"pdb\""):
            simulation.output("out", snapshots_every=1, trajectory="pdb")
        with self.assertRaisesRegex(hardball.Error, "no snapshots are taken"):
            simulation.output("out", trajectory="gsd")
        self.assertFalse(Path("out").exists())
        with simulation.output("out", recording=True):
            with self.assertRaisesRegex(hardball.Error, "files are being written to out"):
                simulation.output("other")
            for edit in (lambda: simulation.remove(0), lambda: simulation.respond_with(0.9), lambda: simulation.grow()):
                with self.assertRaisesRegex(hardball.Error, "a recording is being written"):
                    edit()
            simulation.set_velocity(0, [0, 0, 0])
        with self.assertRaisesRegex(hardball.Error, "holds recording.hbr of another run"):
            simulation.output("out")
        simulation.output("out", overwrite=True).close()
        with self.assertRaisesRegex(hardball.Error, "there is no checkpoint"):
            hardball.Simulation.resume("nowhere")

    def test_the_output_of_a_scenario_is_that_of_its_simulation(self):
        scenario = {**SCENARIO, "output": {"directory": "out", "snapshots_every": 1.0, "trajectory": "gsd"}}
        simulation = hardball.Simulation.from_scenario(scenario)
        with simulation.output():
            simulation.run()
        self.assertEqual(len(hardball.read("out/trajectory.gsd")), 3)
        simulation = hardball.Simulation.from_scenario(scenario)
        with simulation.output("other", trajectory="xyz", event_log=True):
            simulation.run()
        self.assertEqual(len(hardball.read("other/trajectory.xyz")), 3)
        self.assertEqual(len(np.load("other/events.npy")), simulation.collisions)

    def test_copies_write_no_files(self):
        simulation = gas()
        with simulation.output("out", snapshots_every=0.5):
            other = simulation.__copy__()
            other.run(until=2)
            other.close()
            simulation.run(until=1)
        self.assertEqual(len(hardball.read("out/trajectory.xyz")), 3)


class Reading(InFolder):
    def setUp(self):
        super().setUp()
        self.simulation = gas()
        with self.simulation.output("out", snapshots_every=0.25, trajectory=["xyz", "gsd"], recording=True):
            self.simulation.run(until=1.0)

    def test_a_trajectory_is_a_sequence(self):
        frames = hardball.read("out/trajectory.gsd")
        self.assertEqual(len(frames), 5)
        self.assertEqual([frame.time for frame in frames], [0, 0.25, 0.5, 0.75, 1])
        self.assertEqual(frames[-1].time, 1)
        self.assertEqual([frame.time for frame in frames[1::2]], [0.25, 0.75])
        self.assertEqual([frame.time for frame in frames[::-1][:2]], [1, 0.75])
        self.assertEqual([frame.time for frame in reversed(frames)], [1, 0.75, 0.5, 0.25, 0])
        self.assertIsInstance(frames[:2], hardball.Trajectory)
        self.assertIsInstance(frames[0], hardball.Frame)
        for wrong in (5, -6):
            with self.assertRaisesRegex(IndexError, f"there is no frame {wrong}"):
                frames[wrong]
        self.assertIn("5 frames", repr(frames))

    def test_a_frame_has_what_a_simulation_has(self):
        frame = hardball.read("out/trajectory.xyz")[-1]
        for name in ("positions", "velocities", "radii", "masses", "species", "spins", "moments", "ids"):
            np.testing.assert_array_equal(getattr(frame, name), getattr(self.simulation, name), err_msg=name)
            self.assertFalse(getattr(frame, name).flags.writeable)
        self.assertEqual(frame.box, self.simulation.box)
        np.testing.assert_array_equal(frame.edges, self.simulation.box.size)
        self.assertEqual(len(frame), len(self.simulation))
        now = self.simulation.frame()
        np.testing.assert_array_equal(now.positions, frame.positions)
        self.assertEqual(now.time, 1)

    def test_a_recording_has_frames_at_any_time(self):
        recording = hardball.read("out/recording.hbr")
        self.assertEqual((recording.begin, recording.end), (0, 1))
        self.assertEqual([frame.time for frame in recording], [0, 1])
        simulation = gas()
        for time in (0.0, 0.1, 0.6, 1.0):
            simulation.run(until=time)
            frame = recording.at(time)
            np.testing.assert_allclose(frame.positions, simulation.positions, rtol=0, atol=1e-13)
            np.testing.assert_array_equal(frame.velocities, simulation.velocities)
        self.assertEqual([frame.time for frame in hardball.read("out/recording.hbr", every=0.25)], [0, 0.25, 0.5, 0.75, 1])
        self.assertEqual(len(hardball.read("out/recording.hbr", every=0.1)), 11)
        self.assertEqual(len(recording.contacts()), self.simulation.collisions)
        program("replay", "out", "--out", "program.html", "--quiet")
        recording.view().save("python.html")
        self.assertEqual(Path("python.html").read_bytes(), Path("program.html").read_bytes())
        for time in (-1, 1.5, np.nan):
            with self.assertRaises(hardball.Error):
                recording.at(time)
        for every in (0, -1, np.inf):
            with self.assertRaisesRegex(hardball.Error, "give a positive time"):
                hardball.read("out/recording.hbr", every=every)
        with self.assertRaisesRegex(hardball.Error, "only recordings"):
            hardball.read("out/trajectory.xyz", every=0.5)

    def test_a_recording_of_many_parts(self):
        simulation = gas()
        with simulation.output("long", recording=True):
            simulation.run(contacts=3500)
        recording = hardball.read("long/recording.hbr")
        self.assertGreater(len(recording), 3)
        again = gas()
        for frame in recording:
            again.run(until=frame.time)
            np.testing.assert_allclose(frame.positions, again.positions, rtol=0, atol=1e-12)
            np.testing.assert_array_equal(frame.velocities, again.velocities)
        self.assertEqual(len(recording.contacts()), 3500)

    def test_recordings_know_mergers_gravity_walls_and_shear(self):
        positions, edge = lattice()
        velocities = np.random.default_rng(1).normal(size=positions.shape)
        for name, box, options in (
            ("merging", hardball.Box.periodic(edge), {"response": hardball.Merging()}),
            ("gravity", hardball.Box.walls(edge), {"gravity": [0, 0, -1]}),
            ("rough", hardball.Box.periodic(edge), {"response": hardball.Bounce(0.9, tangential_restitution=0.5)}),
            ("shear", hardball.Box.periodic(edge, shear_rate=0.5), {}),
        ):
            with self.subTest(name):
                make = lambda: hardball.Simulation(box, positions=positions, velocities=velocities, radius=0.5, **options)
                recorded = make()
                with recorded.output(name, recording=True, report=False):
                    recorded.run(until=2)
                recording = hardball.read(f"{name}/recording.hbr")
                simulation = make()
                for time in (0.5, 2.0):
                    simulation.run(until=time)
                    frame, now = recording.at(time), simulation.frame()
                    np.testing.assert_array_equal(frame.ids, now.ids)
                    np.testing.assert_allclose(frame.positions, now.positions, rtol=0, atol=1e-12)
                    np.testing.assert_allclose(frame.radii, now.radii)
                    np.testing.assert_allclose(frame.spins, now.spins)
                    np.testing.assert_allclose(frame.velocities, now.velocities, rtol=0, atol=1e-12)
                    self.assertAlmostEqual(frame.tilt, now.tilt)

    def test_tables(self):
        frames = hardball.read("out/trajectory.gsd")
        table = frames[-1].to_frame()
        names = ["id", "x", "y", "z", "vx", "vy", "vz", "radius", "mass", "species"]
        whole = frames.to_frame()
        if is_installed("pandas"):
            self.assertEqual(list(table.columns), names)
            self.assertEqual(list(whole.columns), ["time", *names])
        real = builtins.__import__

        def without_pandas(name, *arguments):
            if name == "pandas":
                raise ImportError(name)
            return real(name, *arguments)

        with mock.patch("builtins.__import__", without_pandas):
            plain = frames[-1].to_frame()
            plain_whole = frames.to_frame()
        self.assertEqual(list(plain.dtype.names), names)
        np.testing.assert_array_equal(plain["vy"], self.simulation.velocities[:, 1])
        for name in names:
            np.testing.assert_array_equal(np.asarray(table[name]), plain[name])
        self.assertEqual(sorted(set(plain_whole["time"])), [0, 0.25, 0.5, 0.75, 1])
        self.assertEqual(len(whole), 5 * len(self.simulation))

    @unittest.skipUnless(is_installed("ase"), "ASE is not installed")
    def test_ase(self):
        all_atoms = hardball.read("out/trajectory.gsd").to_ase()
        self.assertEqual([atoms.info["time"] for atoms in all_atoms], [0, 0.25, 0.5, 0.75, 1])
        np.testing.assert_array_equal(all_atoms[-1].positions, self.simulation.positions)
        again = hardball.Simulation.from_ase(all_atoms[-1])
        np.testing.assert_allclose(again.velocities, self.simulation.velocities, rtol=1e-14)
        self.assertEqual(again.box, self.simulation.box)
        flat = hardball.Simulation.gas(20, packing_fraction=0.2, dimensions=2).frame().to_ase()
        self.assertEqual(list(flat.pbc), [True, True, False])

    @unittest.skipUnless(is_installed("MDAnalysis"), "MDAnalysis is not installed")
    def test_mdanalysis(self):
        universe = hardball.read("out/trajectory.gsd").to_mdanalysis()
        self.assertEqual(len(universe.trajectory), 5)
        self.assertEqual([step.time for step in universe.trajectory], [0, 0.25, 0.5, 0.75, 1])
        universe.trajectory[-1]
        np.testing.assert_allclose(universe.atoms.positions, self.simulation.positions, rtol=1e-6)
        np.testing.assert_allclose(universe.atoms.velocities, self.simulation.velocities, rtol=1e-6)
        np.testing.assert_array_equal(universe.atoms.radii, self.simulation.radii)
        np.testing.assert_allclose(universe.dimensions, [*self.simulation.box.size, 90, 90, 90], rtol=1e-6)
        self.assertEqual(len(self.simulation.frame().to_mdanalysis().trajectory), 1)
        with self.assertRaisesRegex(hardball.Error, "different numbers of spheres"):
            gas().write("two.gsd")
            hardball.Simulation.gas(20, packing_fraction=0.2).write("two.gsd", append=True)
            hardball.read("two.gsd").to_mdanalysis()

    def test_freud(self):
        box, points = self.simulation.frame().to_freud()
        np.testing.assert_array_equal(box, [*self.simulation.box.size, 0, 0, 0])
        np.testing.assert_allclose(points, self.simulation.positions - self.simulation.box.size / 2)
        flat = hardball.Simulation.gas(20, packing_fraction=0.2, dimensions=2)
        box, points = flat.frame().to_freud()
        self.assertEqual(box[2], 0)
        self.assertEqual(np.abs(points[:, 2]).max(), 0)

    @unittest.skipUnless(is_installed("freud"), "freud is not installed")
    def test_freud_takes_it(self):
        import freud

        found = freud.locality.AABBQuery.from_system(self.simulation.frame().to_freud())
        self.assertEqual(len(found.points), len(self.simulation))

    def test_bad_files_are_refused(self):
        with self.assertRaisesRegex(hardball.Error, "cannot be read"):
            hardball.read("none.xyz")
        with self.assertRaises(hardball.Error):
            hardball.read("none.hbr")
        Path("bad.gsd").write_text("words")
        with self.assertRaises(hardball.Error):
            hardball.read("bad.gsd")
        with self.assertRaisesRegex(hardball.Error, "give the path of a file"):
            hardball.read(7)


def _toml(value):
    from hardball._scenario import toml_of

    return toml_of(value)


if __name__ == "__main__":
    unittest.main()
