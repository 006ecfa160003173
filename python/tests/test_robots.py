# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Robots on trajectories: what they touch first, and files that describe them."""

import math
import tempfile
import unittest
from pathlib import Path

import numpy as np

import hardball

URDF = """<?xml version="1.0"?>
<robot name="two_links">
  <link name="base"/><link name="upper"/><link name="lower"/><link name="finger"/>
  <joint name="shoulder" type="continuous">
    <parent link="base"/><child link="upper"/><origin xyz="0 0 0.5" rpy="0 0 1.5707963267948966"/><axis xyz="0 0 1"/>
  </joint>
  <joint name="elbow" type="revolute">
    <parent link="upper"/><child link="lower"/><origin xyz="0.5 0 0"/><axis xyz="0 0 1"/><limit lower="-2" upper="2"/>
  </joint>
  <joint name="grip" type="prismatic"><parent link="lower"/><child link="finger"/></joint>
  <transmission name="drive"><joint name="shoulder"/></transmission>
</robot>
"""

SPHERES = """
collision_spheres:
  upper:
    - center: [0.25, 0.0, 0.0]
      radius: 0.05
  lower:
    - {center: [0.25, 0.0, 0.0], radius: 0.05}
  finger: [{center: [0, 0, 0], radius: 0.02}]
  attached_object:
    - center: [0, 0, 0]
      radius: -10.0
self_collision_ignore:
  upper: [finger]
"""


def piston(radius=0.5):
    return hardball.Robot.from_spheres(
        {"piston": [[0, 0, 0, radius]]}, [{"kind": "prismatic", "parent": "base", "child": "piston", "axis": [1, 0, 0]}]
    )


def arm():
    links = {"upper": [[0.2, 0, 0, 0.05], [0.4, 0, 0, 0.05]], "lower": [[0.3, 0, 0, 0.04]]}
    joints = [
        {"name": "shoulder", "parent": "base", "child": "upper", "origin": [0, 0, 0.5]},
        {"name": "elbow", "parent": "upper", "child": "lower", "origin": [0.5, 0, 0]},
    ]
    return hardball.Robot.from_spheres(links, joints)


class FirstContact(unittest.TestCase):
    def test_of_a_piston_is_exact(self):
        cube = hardball.JointTrajectory.from_pieces([0, 2], [[[0, 0, 0, 1]]])
        obstacles = hardball.Obstacles()
        self.assertEqual(obstacles.add_spheres([[0, 5, 0], [2.728, 0, 0]], 0.5), 0)
        contact = hardball.first_contact(piston(), cube, obstacles)
        self.assertAlmostEqual(contact.time, 1.2, delta=1e-15)
        self.assertEqual((contact.sphere, contact.obstacle, contact.other_sphere), (0, 1, None))
        np.testing.assert_allclose(contact.point, [2.228, 0, 0], atol=1e-15)
        np.testing.assert_allclose(contact.normal, [-1, 0, 0], atol=1e-15)
        self.assertRegex(repr(contact), r"<hardball.RobotContact at 1\.\d+: sphere 0 and obstacle 1, .* apart>")
        self.assertIsNone(hardball.first_contact(piston(0.4), cube, hardball.Obstacles()))

    def test_finds_every_shape(self):
        way = hardball.JointTrajectory.linear([1, 4], [[0], [3]])
        shapes = {
            "add_box": ([1.75, 0, 0], [1, 1, 1], np.eye(3)),
            "add_capsule": ([1.5, -1, 0], [1.5, 1, 0], 0.25),
            "add_plane": ([1.25, 0, 0], [-2, 0, 0]),
            "add_mesh": ([[1.25, -1, -1], [1.25, 1, -1], [1.25, 0, 1]], [[0, 1, 2]]),
            "add_spheres": ([[3.5, 0, 0]], 0.25, [-1, 0, 0]),
        }
        for name, arguments in shapes.items():
            with self.subTest(name):
                obstacles = hardball.Obstacles()
                getattr(obstacles, name)(*arguments)
                self.assertEqual(len(obstacles), 1)
                self.assertAlmostEqual(hardball.first_contact(piston(0.25), way, obstacles).time, 2, delta=1e-15)

    def test_knows_simulations(self):
        simulation = hardball.Simulation(
            hardball.Box.walls(10), positions=[[5, 5, 5]], velocities=[[-1, 0, 0]], radius=0.5
        )
        simulation.run(until=1)
        robot = hardball.Robot.from_spheres(
            {"hand": [[1, 5, 5, 0.5]]}, [{"kind": "prismatic", "parent": "base", "child": "hand", "axis": [1, 0, 0]}]
        )
        obstacles = hardball.Obstacles()
        obstacles.add_simulation(simulation)
        self.assertEqual(len(obstacles), 7)
        still = hardball.JointTrajectory.linear([1, 9], [[0], [0]])
        contact = hardball.first_contact(robot, still, obstacles)
        self.assertEqual((contact.time, contact.obstacle), (3, 0))

    def test_of_many_is_that_of_each(self):
        random = np.random.default_rng(1)
        obstacles = hardball.Obstacles()
        obstacles.add_spheres(random.uniform(-1, 1, (20, 3)) * [1, 1, 0.3] + [0, 0, 0.5], 0.05)
        ways = [hardball.JointTrajectory.cubic([0, 1, 2], random.uniform(-2, 2, (3, 2)), "clamped") for _ in range(20)]
        found = hardball.first_contacts(arm(), ways, obstacles, clearance=0.01, threads=2)
        nearest = hardball.least_clearances(arm(), ways, obstacles)
        self.assertTrue(0 < sum(each is None for each in found) < len(ways))
        for way, contact, least in zip(ways, found, nearest):
            self.assertEqual(repr(hardball.first_contact(arm(), way, obstacles, 0.01)), repr(contact))
            self.assertEqual(repr(hardball.least_clearance(arm(), way, obstacles)), repr(least))
            self.assertEqual(contact is None, least.distance > 0.01)
            gaps = (arm().centers(way.coordinates_at(least.time)) - least.point) @ least.normal - arm().radii
            self.assertAlmostEqual(gaps[least.sphere], least.distance, delta=1e-14)

    def test_refuses_what_does_not_fit(self):
        way = hardball.JointTrajectory.linear([0, 1], [[0], [1]])
        none = hardball.Obstacles()
        refusals = {
            "the trajectory is of 1 joints": lambda: hardball.first_contact(arm(), way, none),
            "the clearance is -1": lambda: hardball.first_contact(piston(), way, none, -1),
            "a time": lambda: hardball.JointTrajectory.linear([0, math.nan], [[0], [1]]),
            "it is no table": lambda: hardball.JointTrajectory.linear([0, 1], [0, 1]),
            "there is no 'free'": lambda: hardball.JointTrajectory.cubic([0, 1], [[0], [1]], ends="free"),
            "it is no rotation": lambda: none.add_box([0, 0, 0], [1, 1, 1], [1, 2]),
            "there is no key 'knd'": lambda: hardball.Robot.from_spheres({}, [{"knd": "fixed"}]),
            "there is no kind 'ball'": lambda: hardball.Robot.from_spheres({}, [{"kind": "ball"}]),
            "there is no sphere 3": lambda: arm().link_of(3),
        }
        for text, act in refusals.items():
            with self.subTest(text), self.assertRaisesRegex(hardball.Error, text):
                act()
        self.assertEqual(len(none), 0)


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.urdf = Path(self.folder.name) / "robot.urdf"
        self.urdf.write_text(URDF)

    def test_describe_robots(self):
        spheres = Path(self.folder.name) / "robot.yml"
        spheres.write_text(SPHERES)
        links, ignored = hardball.read_spheres(spheres)
        self.assertEqual(ignored, [("upper", "finger")])
        robot = hardball.Robot.from_spheres(links, hardball.read_joints(self.urdf, {"grip": 0.125}), ignored)
        self.assertEqual(robot.joint_names, ["shoulder", "elbow"])
        self.assertEqual([robot.link_of(k) for k in range(3)], ["upper", "lower", "finger"])
        expected = [[0, 0.25, 0.5], [0, 0.75, 0.5], [0, 0.625, 0.5]]
        np.testing.assert_allclose(robot.centers([0, 0]), expected, atol=1e-15)
        np.testing.assert_allclose(robot.centers([0, math.pi / 2])[1], [-0.25, 0.5, 0.5], atol=1e-15)

    def test_errors_say_where(self):
        changes = {
            "it is of the type 'floating'": ('type="continuous"', 'type="floating"'),
            "it has no child": ('<child link="upper"/>', ""),
            "xyz is '0 0'": ('xyz="0 0 0.5"', 'xyz="0 0"'),
            "it mimics another joint": ('<child link="finger"/>', '<child link="finger"/><mimic joint="elbow"/>'),
            "robot.urdf:2: it is not XML": ("<robot", "<<robot"),
        }
        for text, (old, new) in changes.items():
            with self.subTest(text), self.assertRaisesRegex(hardball.Error, text):
                self.urdf.write_text(URDF.replace(old, new, 1))
                hardball.read_joints(self.urdf)
        self.urdf.write_text(URDF)
        with self.assertRaisesRegex(hardball.Error, "there is no joint 'thumb' that moves"):
            hardball.read_joints(self.urdf, locked={"thumb": 0})


if __name__ == "__main__":
    unittest.main()
