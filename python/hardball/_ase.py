# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Reads an ASE Atoms object."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from . import _hardball

if TYPE_CHECKING:
    import ase


KINEMATIC = 1e60  # in files, for ASE, the mass of spheres that no collision deflects [M]


def arguments_of(atoms: ase.Atoms, radius: ArrayLike | None) -> dict[str, Any]:
    """The arguments of Simulation. Error: the cell is not rectangular; there are no radii."""
    if not hasattr(atoms, "get_momenta"):
        raise _hardball.Error(f"it is {type(atoms).__name__}: give an ASE Atoms object")
    cell = np.asarray(atoms.cell)
    size = np.diag(cell)
    # Programs that turn cells leave rounding errors.
    slanted = np.abs(cell - np.diag(size)) > 1e-12 * np.max(np.abs(cell))
    if np.any(slanted[atoms.pbc]) or np.any(slanted[:, atoms.pbc]) or np.any(atoms.pbc & (size <= 0)):
        raise _hardball.Error(
            "the cell of the atoms is not rectangular: align its edges with the axes"
        )
    if radius is None:
        if "radius" not in atoms.arrays:
            raise _hardball.Error("the atoms have no radii: give radius, or an array 'radius' of the atoms")
        radius = atoms.arrays["radius"]
    masses = atoms.get_masses()
    velocities = atoms.get_momenta() / masses[:, np.newaxis]
    return {
        "box": _hardball.Box(["periodic" if along else "open" for along in atoms.pbc], np.where(atoms.pbc, size, 0)),
        "positions": atoms.positions,
        "velocities": velocities,
        "radius": radius,
        "mass": np.where(masses < KINEMATIC, masses, np.inf),
    }
