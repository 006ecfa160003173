# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Writes a trajectory, reads it as a table, and computes how far spheres diffuse. With the name of a file, draws it."""

import sys

import matplotlib.pyplot as plt
import pandas

import hardball

simulation = hardball.Simulation.gas(500, packing_fraction=0.2, seed=1)
for step in range(41):
    simulation.run(until=0.1 * step)
    simulation.write("gas.xyz", append=step > 0)

frames = hardball.read("gas.xyz")
table = pandas.DataFrame(frames.to_frame())
edge = frames[0].box.size[0]

# A row for each time. Steps between frames are shorter than half of the box, so its faces can be undone.
steps = table.pivot(index="time", columns="id", values=["x", "y", "z"]).diff().fillna(0)
steps -= edge * (steps / edge).round()
square = (steps.cumsum() ** 2).sum(axis=1) / len(simulation)

print("time  mean square displacement  over 6 t")
for time, value in square.iloc[5::5].items():
    print(f"{time:4.1f}  {value:24.4f}  {value / (6 * time):8.4f}")

if len(sys.argv) > 1:
    figure, axes = plt.subplots(figsize=(5, 4), layout="tight")
    axes.loglog(square.iloc[1:], "o-")
    axes.set(xlabel="time", ylabel="mean square displacement")
    figure.savefig(sys.argv[1])
