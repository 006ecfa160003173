# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Compares the pressure of hard spheres with the formula of Carnahan and Starling. With the name of a file, draws both."""

import sys

import matplotlib.pyplot as plt
import numpy as np

import hardball

COUNT = 500


def compressibility(packing_fraction: float) -> hardball.Quantity:
    """PV/NkT of a gas after it has forgotten its start."""
    simulation = hardball.Simulation.gas(COUNT, packing_fraction=packing_fraction)
    simulation.run(collisions=20 * COUNT)
    simulation.measure("pressure", start=simulation.time)
    simulation.run(collisions=100 * COUNT)
    quantity: hardball.Quantity = simulation.results()["pressure"]["compressibility"]
    return quantity


packing_fractions = np.linspace(0.05, 0.35, 7)
measured = [compressibility(packing_fraction) for packing_fraction in packing_fractions]
formula = (1 + packing_fractions + packing_fractions**2 - packing_fractions**3) / (1 - packing_fractions) ** 3

print("packing fraction  PV/NkT   error   Carnahan-Starling")
for fraction, z, expected in zip(packing_fractions, measured, formula):
    print(f"{fraction:16.2f}  {z.value:6.3f}  {z.error:6.3f}  {expected:17.3f}")

if len(sys.argv) > 1:
    figure, axes = plt.subplots(figsize=(5, 4), layout="tight")
    axes.errorbar(packing_fractions, [z.value for z in measured], [z.error for z in measured], fmt="o", label="Hardball")
    axes.plot(packing_fractions, formula, label="Carnahan and Starling")
    axes.set(xlabel="packing fraction", ylabel="PV/NkT")
    axes.legend()
    figure.savefig(sys.argv[1])
