# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""What several tests need."""

import os
import subprocess
from pathlib import Path

import numpy as np

import hardball

ROOT = Path(__file__).resolve().parents[2]
SCENARIOS = ROOT / "scenarios"


def lattice(per_axis=5, spacing=1.6):
    """Centers of spheres of diameter one, and the edge of a box that holds them."""
    places = (np.arange(per_axis) + 0.5) * spacing
    return np.stack(np.meshgrid(places, places, places), axis=-1).reshape(-1, 3), per_axis * spacing


def gas(seed=1, **options):
    """125 spheres of diameter one in a periodic box."""
    positions, edge = lattice()
    velocities = np.random.default_rng(seed).normal(size=positions.shape)
    arguments = {"positions": positions, "velocities": velocities, "radius": 0.5, **options}
    box = arguments.pop("box", hardball.Box.periodic(edge))
    return hardball.Simulation(box, **arguments)


def program(*arguments):
    """What the command line prints."""
    command = [os.environ["HARDBALL_PROGRAM"], *map(str, arguments)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout
