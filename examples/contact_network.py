# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Counts the contacts of discs that have jammed. With the name of a file, draws them, and forces as lines."""

import sys

import matplotlib.pyplot as plt
import numpy as np

import hardball

packing = hardball.pack(90, sizes="discrete:1=1,1.4=1", phi="max", rate=0.1, dimensions=2, seed=3)
contacts = packing.contacts
ends = np.concatenate([contacts["i"], contacts["j"]])
numbers = np.bincount(ends, minlength=len(packing.radii))

print(f"{len(packing.radii)} discs, packing fraction {packing.phi:.4f}")
print("contacts  discs")
for number, discs in enumerate(np.bincount(numbers)):
    if discs:
        print(f"{number:8}  {discs:5}")
stable = ~packing.rattlers
print(f"mean without {packing.rattlers.sum()} rattlers: {numbers[stable].mean():.3f}")

if len(sys.argv) > 1:
    edge = packing.box.size[0]
    # The axes fill the figure, and 72 points are an inch, so that the sizes of markers are diameters.
    figure = plt.figure(figsize=(5, 5))
    axes = figure.add_axes((0, 0, 1, 1), xlim=(0, edge), ylim=(0, edge))
    for place, radius, rattles in zip(packing.positions, packing.radii, packing.rattlers):
        color = "gold" if rattles else "lightsteelblue"
        axes.plot(*place[:2], "o", color=color, markersize=72 * 5 * 2 * radius / edge, markeredgewidth=0)
    for contact in contacts:
        # The second disc may be an image of the one in the box.
        begin = packing.positions[contact["i"], :2]
        axes.plot(*zip(begin, begin + contact["separation"][:2]), color="crimson", linewidth=1.5 * contact["force"])
    axes.axis("off")
    figure.savefig(sys.argv[1])
