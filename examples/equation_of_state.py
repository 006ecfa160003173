# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Plots the pressure of hard spheres against their density, with standard errors and theory: equation_of_state.png."""

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
import numpy as np

import hardball

COUNT = 500


def compressibility(packing_fraction):
    simulation = hardball.Simulation.from_scenario(
        {
            "box": {"packing_fraction": packing_fraction, "boundary": ["periodic"] * 3},
            "spheres": [{"count": COUNT, "radius": 0.5, "placement": "fcc", "temperature": 1.0}],
            "run": {"seed": 1},
        }
    )
    simulation.measure("pressure")
    simulation.run(collisions=100 * COUNT)
    return simulation.results()["pressure"]["compressibility"]


packing_fractions = np.linspace(0.05, 0.45, 9)
measured = [compressibility(packing_fraction) for packing_fraction in packing_fractions]
plt.errorbar(packing_fractions, [z.value for z in measured], [z.error for z in measured], fmt="o", label="Hardball")
plt.plot(packing_fractions, [z.theory for z in measured], label="theory")
plt.xlabel("packing fraction")
plt.ylabel("P V / N k T")
plt.legend()
plt.savefig("equation_of_state.png")
print("the figure is equation_of_state.png")
