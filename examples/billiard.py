# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Sinai's billiard: a small disc among walls, with a fixed one in the middle. With the name of a file, draws two ways."""

import sys

import matplotlib.pyplot as plt
import numpy as np

import hardball


def billiard(y: float) -> hardball.Simulation:
    """A disc that starts at this height at the left."""
    return hardball.Simulation(
        hardball.Box.flat_walls([1.0, 1.0]),
        positions=[[0.1, y]],
        velocities=[0.8, 0.6],
        radius=0.01,
        surfaces=[hardball.Surface.obstacle(0.25, [0.5, 0.5])],
    )


simulations = [billiard(0.2), billiard(0.2 + 1e-9)]
ways = [[simulation.positions[0, :2]] for simulation in simulations]
print("time  bounces  distance of the two")
for time in range(1, 13):
    for simulation, way in zip(simulations, ways):
        way += [simulation.positions[0, :2] for _ in simulation.events(until=time)]
    apart = simulations[0].positions[0] - simulations[1].positions[0]
    print(f"{time:4}  {len(ways[0]) - 1:7}  {np.sqrt(np.sum(apart**2)):19.1e}")

if len(sys.argv) > 1:
    figure, axes = plt.subplots(figsize=(5, 5), layout="tight")
    axes.add_patch(plt.Circle((0.5, 0.5), 0.25, color="lightgray"))
    for way, color in zip(ways, ("tab:blue", "tab:orange")):
        axes.plot(*np.array(way).T, color=color, linewidth=0.8)
    axes.set(aspect="equal", xlim=(0, 1), ylim=(0, 1))
    figure.savefig(sys.argv[1])
