# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Folds a chain whose beads attract each other, at eight temperatures that swap. With a file name, draws a walk."""

import sys

import matplotlib.pyplot as plt
import numpy as np

import hardball

BEADS, SWAPS, SKIPPED = 12, 800, 100
temperatures = [0.25 * 1.2**k for k in range(8)]

table = hardball.StepTable()
table.set_for_all(hardball.StepPotential([(1.5, -1.0)]))
bond = table.add_bond(hardball.StepPotential([(1.15, 0.0)], core=0.9, tether=True))
places = np.zeros((BEADS, 3))
places[:, 0] = np.arange(BEADS)
chain = hardball.Simulation(
    hardball.Box.open(),
    positions=places,
    radius=0.5,
    steps=table,
    bonds=[(bead, bead + 1, bond) for bead in range(BEADS - 1)],
)


def squared_radius(simulation: hardball.Simulation) -> float:
    """The mean square distance of the beads from their middle."""
    return float(simulation.positions.var(axis=0).sum())


exchange = hardball.ReplicaExchange(chain, temperatures, every=1.0, rate=0.5, seed=1)
exchange.run(until=SWAPS, observe=squared_radius)
energies, sizes = exchange.energies[SKIPPED:], exchange.observed[SKIPPED:]

print("  kT   contacts  heat capacity  radius  swaps")
for level, temperature in enumerate(temperatures):
    capacity = energies[:, level].var() / temperature**2 / BEADS
    swaps = f"{exchange.acceptance[level]:5.2f}" if level < len(temperatures) - 1 else ""
    radius = np.sqrt(sizes[:, level].mean())
    print(f"{temperature:.3f}  {-energies[:, level].mean():8.2f}  {capacity:13.2f}  {radius:6.3f}  {swaps}".rstrip())

if len(sys.argv) > 1:
    # The level at which the first replica was.
    levels = np.argmax(exchange.places == 0, axis=1)
    figure, axes = plt.subplots(figsize=(6.4, 3), layout="tight")
    axes.step(exchange.times[:400], np.array(temperatures)[levels[:400]], where="post", linewidth=0.8)
    axes.set(xlabel="time", ylabel="kT of the first replica", yscale="log")
    figure.savefig(sys.argv[1])
