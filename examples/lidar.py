# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""A robot that drives among moving people, and measures distances by a fan of rays. With a file name, draws the last fan."""

import sys

import matplotlib.pyplot as plt
import numpy as np
from numpy.typing import NDArray

import hardball

Floats = NDArray[np.float64]
RANGE, RAYS = 6.0, 90
places = [[2.0, 5.0], *([x, y] for x in (5.0, 8.0, 11.0, 14.0) for y in (2.2, 3.4, 6.4, 7.9))]
velocities = [[1.0, 0.0], *([-0.2 * (k % 4), 0.1 * (k % 3) - 0.1] for k in range(16))]
simulation = hardball.Simulation(
    hardball.Box.flat_walls([16.0, 10.0]),
    positions=places,
    velocities=velocities,
    radius=[0.3] + [0.25] * 16,
)
angles = np.linspace(0, 2 * np.pi, RAYS, endpoint=False)
directions = np.stack([np.cos(angles), np.sin(angles)], axis=-1)



def look() -> tuple[Floats, Floats, set[int]]:
    """The robot's place, the distance along each ray, and the people that are seen."""
    robot = simulation.positions[0]
    # A ray that starts in the robot does not hit it.
    hits = [simulation.ray(robot, direction, RANGE) for direction in directions]
    distances = np.array([RANGE if hit is None else hit.distance for hit in hits])
    return robot, distances, {hit.body for hit in hits if hit is not None and hit.kind == "collision"}


print("time  people seen  nearest  at degrees")
for time in range(9):
    simulation.run(until=time)
    _, distances, seen = look()
    nearest = np.argmin(distances)
    print(f"{time:4}  {len(seen):11}  {distances[nearest]:7.3f}  {360 * nearest / RAYS:10.0f}")

if len(sys.argv) > 1:
    figure, axes = plt.subplots(figsize=(6.4, 4), layout="tight")
    robot, distances, seen = look()
    for direction, distance in zip(directions, distances):
        x, y = zip(robot[:2], robot[:2] + distance * direction)
        axes.plot(x, y, color="tab:green", linewidth=0.6)
    for number, (place, radius) in enumerate(zip(simulation.positions[:, :2], simulation.radii)):
        color = "tab:blue" if number == 0 else "tab:red" if number in seen else "lightgray"
        axes.add_patch(plt.Circle(place, radius, color=color, zorder=2))
    axes.set(aspect="equal", xlim=(0, 16), ylim=(0, 10))
    figure.savefig(sys.argv[1])
