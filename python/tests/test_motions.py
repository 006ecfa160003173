# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Prescribed motions, and spheres that are put elsewhere."""

import math
import pickle
import tempfile
import unittest
from pathlib import Path

import numpy as np

import hardball
from support import SCENARIOS


def arm(gravity=(0, 0, 0), **keys):
    """A kinematic sphere and one beside it."""
    return hardball.Simulation(
        hardball.Box.open(),
        positions=[[3, 0, 5], [0, 0, 20]],
        radius=0.5,
        mass=[math.inf, 1],
        gravity=gravity,
        **keys,
    )


class Motions(unittest.TestCase):
    def test_they_lead_spheres_along_their_curve(self):
        simulation = arm()
        motion = hardball.Motion.rotation([0, 0, 0], [0, 0, 2], frequency=0.25, tolerance=1e-3)
        simulation.drive(motion, ids=[0], name="arm")
        simulation.run(until=1)
        np.testing.assert_allclose(simulation.positions[0], [0, 3, 5], atol=1e-14)
        (driven,) = simulation.motions
        self.assertEqual((driven.name, driven.motion.kind, list(driven.ids), list(driven.surfaces)), ("arm", "rotation", [0], []))
        self.assertGreater(driven.next, 1)
        self.assertEqual(driven.work, 0)
        self.assertIn("Motion.rotation", repr(motion))
        self.assertEqual(motion.tolerance, 1e-3)
        again = pickle.loads(pickle.dumps(simulation))
        for each in (simulation, again):
            each.run(until=3)
            np.testing.assert_allclose(each.positions[0], [0, -3, 5], atol=1e-14)
        simulation.stop_driving()
        self.assertEqual(simulation.motions, [])

    def test_kinds(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "knots.csv"
            path.write_text("t,x,y,z\n0,0,0,0\n2,0,4,0\n")
            motions = [
                hardball.Motion.oscillation([0, 1, 0], amplitude=2, frequency=0.25, tolerance=0.01),
                hardball.Motion.keyframes([0, 2], [[1, 1, 1], [1, 5, 1]]),
                hardball.Motion.read(path),
                hardball.Motion.function(lambda t: [0, 2 * t * t, 0], until=2, acceleration=4, tolerance=1e-3),
            ]
        for motion in motions:
            simulation = arm()
            simulation.drive(motion, ids=[0])
            simulation.run(until=1)
            np.testing.assert_allclose(simulation.positions[0], [3, 2, 5], atol=1e-3)

    def test_walls(self):
        floor = hardball.Surface.plane(normal=[0, 0, 1], point=[0, 0, 0])
        simulation = arm(surfaces=[floor])
        simulation.drive(hardball.Motion.keyframes([0, 1], [[0, 0, 0], [0, 0, -2]]), surfaces=[0])
        simulation.run(until=2)
        self.assertEqual(list(simulation.motions[0].surfaces), [0])

    def test_a_piston_stops_at_a_pressure(self):
        simulation = hardball.Simulation.from_scenario(SCENARIOS / "piston.toml")
        simulation.stop_driving()
        down = hardball.Motion.keyframes([0, 1000], [[0, 0, 0], [0, 0, -20]])
        with self.assertRaisesRegex(hardball.Error, "stop_interval"):
            simulation.drive(down, surfaces=[1], stop_pressure=0.05)
        simulation.drive(down, surfaces=[1], stop_pressure=0.05, stop_interval=20)
        self.assertIsNone(simulation.motions[0].stopped_at)
        simulation.run(until=400)
        self.assertGreater(simulation.motions[0].stopped_at, 100)
        self.assertEqual(simulation.motions[0].next, math.inf)

    def test_they_are_refused(self):
        simulation = arm()
        still = hardball.Motion.keyframes([0], [[0, 0, 0]])
        with self.assertRaisesRegex(hardball.Error, "sphere 1 is not kinematic"):
            simulation.drive(still, ids=[1])
        with self.assertRaisesRegex(hardball.Error, "not later"):
            hardball.Motion.keyframes([0, 0], [[0, 0, 0], [1, 0, 0]])
        falling = arm(gravity=[0, 0, -1])
        with self.assertRaisesRegex(hardball.Error, "does not fall"):
            falling.run(until=1)
        falling.drive(hardball.Motion.keyframes([0], [[0, 0, 0]], tolerance=0.01), ids=[0])
        falling.run(until=1)
        self.assertAlmostEqual(falling.positions[0, 2], 5, delta=0.011)


class Put(unittest.TestCase):
    def test_spheres_are_put_elsewhere(self):
        simulation = arm()
        simulation.run(until=1)
        simulation.put([1], [[4.5, 0, 5]], [[-1, 0, 0]])
        np.testing.assert_array_equal(simulation.positions[1], [4.5, 0, 5])
        self.assertEqual(simulation.next_event(until=2).time, 1.5)

    def test_they_do_not_overlap(self):
        simulation = arm()
        with self.assertRaises(hardball.Error):
            simulation.put([1], [[3.5, 0, 5]], [[0, 0, 0]])
        np.testing.assert_array_equal(simulation.positions[1], [0, 0, 20])
        with self.assertRaisesRegex(hardball.Error, "two places"):
            simulation.put([1, 1], [[9, 0, 5], [9, 0, 9]], [0, 0, 0])


if __name__ == "__main__":
    unittest.main()
