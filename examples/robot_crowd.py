# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Robots that cross a hall and look ahead, and others that do not. With the name of a file, draws the ways of the former."""

import sys

import matplotlib.pyplot as plt
import numpy as np
from numpy.typing import NDArray

import hardball

COUNT, RADIUS, FRAME, HORIZON = 30, 0.3, 0.1, 2.0
# Cosines and sines of the turns that a robot considers: 0, 37, 53, 90 and 143 degrees to both sides.
TURNS = [(1, 0), (0.8, 0.6), (0.8, -0.6), (0.6, 0.8), (0.6, -0.8), (0, 1), (0, -1), (-0.8, 0.6), (-0.8, -0.6)]


def choose(simulation: hardball.Simulation, robot: int, way: NDArray[np.float64], looks_ahead: bool) -> list[float]:
    """The velocity, toward the goal or turned from it, that is free for long and leads there."""
    distance = np.sqrt(np.sum(way**2))
    x, y = way / max(distance, FRAME)
    best, best_score = [0.0, 0.0], 0.0
    for cosine, sine in TURNS if looks_ahead else TURNS[:1]:
        velocity = [cosine * x - sine * y, sine * x + cosine * y]
        contact = simulation.first_contact(robot, velocity, until=simulation.time + HORIZON) if looks_ahead else None
        free = HORIZON if contact is None else contact.time - simulation.time
        if free > 2 * FRAME and free * (1.5 + cosine) > best_score:
            best, best_score = velocity, free * (1.5 + cosine)
    return best


def ways(looks_ahead: bool) -> NDArray[np.float64]:
    simulation = hardball.Simulation.gas(COUNT, radius=RADIUS, density=0.2, dimensions=2, boundary="wall", seed=4)
    # The goal of each is where another one starts.
    goals = np.roll(simulation.positions, 1, axis=0)[:, :2]
    collisions, path = 0, [simulation.positions]
    for _ in range(300):
        for robot in range(COUNT):
            way = goals[robot] - simulation.positions[robot, :2]
            simulation.set_velocity(robot, choose(simulation, robot, way, looks_ahead))
        collisions += simulation.run(until=simulation.time + FRAME)
        path.append(simulation.positions)
    left = np.sqrt(np.sum((goals - simulation.positions[:, :2]) ** 2, axis=1))
    print(f"{'yes' if looks_ahead else 'no':11}  {np.sum(left < RADIUS):7}  {collisions:10}")
    return np.array(path)


print("looks ahead  arrived  collisions")
ways(False)
path = ways(True)
if len(sys.argv) > 1:
    figure, axes = plt.subplots(figsize=(5, 5), layout="tight")
    for robot in range(COUNT):
        axes.plot(*path[::6, robot, :2].T, linewidth=1)
    axes.plot(*path[-1, :, :2].T, "o", color="black", markersize=5)
    axes.set(aspect="equal")
    figure.savefig(sys.argv[1])
