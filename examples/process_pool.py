# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Runs a gas with several seeds in a pool of processes: the mean of its pressure, and the error of the mean."""

from concurrent.futures import ProcessPoolExecutor
from statistics import mean, stdev

import hardball

SEEDS = range(1, 9)


def compressibility(seed: int) -> float:
    """PV/NkT of a gas with a packing fraction of .3, in equilibrium."""
    simulation = hardball.Simulation.gas(200, packing_fraction=0.3, seed=seed)
    simulation.run(until=2)
    simulation.measure("pressure", start=2)
    simulation.run(until=20)
    return float(simulation.results()["pressure"]["compressibility"].value)


# Processes may import this file, and must not start others.
if __name__ == "__main__":
    with ProcessPoolExecutor() as pool:
        values = list(pool.map(compressibility, SEEDS))
    print("seed  PV/NkT")
    for seed, value in zip(SEEDS, values):
        print(f"{seed:4}  {value:.4f}")
    print(f"mean  {mean(values):.4f} +- {stdev(values) / len(values) ** 0.5:.4f}")
