# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Packings on request: the function pack, and the class Packing."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _hardball
from ._arguments import not_negative, path_text, real_number, real_numbers, text, truth, whole_number
from ._hardball import Mesh
from ._simulation import Simulation

if TYPE_CHECKING:
    import ase

Number = Union[int, float]


class Packing(_hardball.Packing):
    """Spheres that have been packed, at rest, and what is known about them; made by pack.

    Contacts are a structured array with the fields i and j, the numbers of the two spheres, or of a sphere and a
    wall where `wall` is true; `image`, by how many boxes the second is displaced where they touch; `gap` [L];
    `separation` [L], the vector from the center of the first to that of the second, or to the wall; and `force`, over
    the mean of all, NaN where it is not known. There are none of spheres that are far from jamming.

    wall_profile() returns distances [L] from the wall of a cylinder, a cone or a sphere, of a shell or
    an annulus from the outer one, and the packing fraction there: arrays of shape (steps,), empty in a box or a mesh.
    """

    def simulation(self, temperature: float = 1.0, seed: int = 1) -> Simulation:
        """The spheres as a gas of this kT, with masses of one."""
        flat = self.box.dimensions == 2
        random = np.random.default_rng(whole_number(seed, "seed"))
        speed = np.sqrt(not_negative(temperature, "temperature"))
        velocities = speed * random.standard_normal(self.positions.shape)
        if flat:
            velocities[:, 2] = 0
        return Simulation(
            self.box, positions=self.positions, velocities=velocities, radius=self.radii, surfaces=self.surfaces
        )

    def to_ase(self) -> ase.Atoms:
        """The spheres as an ASE Atoms object, with an array 'radius', as Simulation.from_ase reads it."""
        try:
            import ase
        except ImportError as error:
            raise ImportError("to_ase needs ASE, which is not installed: install it with 'pip install ase'") from error

        size = np.asarray(self.box.size)
        periodic = [boundary == "periodic" for boundary in self.box.boundary]
        atoms = ase.Atoms(
            numbers=np.zeros(len(self.radii), dtype=int),
            positions=self.positions,
            cell=np.where(np.isfinite(size), size, 0),
            pbc=periodic,
        )
        atoms.set_array("radius", np.array(self.radii))
        return atoms

    def __repr__(self) -> str:
        return f"<hardball.Packing: {self.status}, {len(self.radii)} spheres, phi = {self.phi:.6g}>"


class PackingFailed(_hardball.RunFailure):
    """Spheres could not be packed as densely as wanted; `packing` is how dense they are."""

    def __init__(self, packing: Packing) -> None:
        rate = packing.suggested_rate
        remedy = f"; try rate={rate:.3g}" if rate else ""
        super().__init__(f"{packing.reason}: phi is {packing.phi:.6g}{remedy}")
        self.packing = packing


def pack(
    count: int | None = None,
    *,
    diameter: float | None = None,
    sizes: str | tuple[Any, ...] | ArrayLike | None = None,
    box: float | Sequence[float] | str | None = None,
    walls: str | None = None,
    container: str | Mesh | None = None,
    phi: float | str | None = None,
    pressure: float | None = None,
    rate: float | None = None,
    gap: float = 0.0,
    dimensions: int = 3,
    start: str | os.PathLike[str] | None = None,
    seed: int = 1,
    limit: float | None = None,
    polish: bool = False,
    threads: int = 1,
) -> Packing:
    """Packs spheres, and returns the packing.

    Give three of count, diameter, box or container, and density; the fourth follows.

    :param count: the number of spheres.
    :param diameter: their mean diameter [L]; 1 if nothing else has a length.
    :param sizes: how they are distributed: a tuple such as ('lognormal', 0.3), ('uniform', 1, 2) or ('powerlaw', -2, 1,
        10), a text as on the command line, or an array of radii [L].
    :param box: edges [L], one for all or each; a text such as '1:1:2' for proportions.
    :param walls: the axes of the box with walls, as in 'z'; the others are periodic.
    :param container: instead of a box, as in 'cylinder:7,50'; see docs/packing.md. A closed Mesh is filled as it is,
        and scaled if count, diameter and density are given.
    :param phi: the packing fraction, or 'max' for as dense as spheres jam.
    :param pressure: instead of phi, PV/NkT of the median sphere, reached to between this and 1.1 times it.
    :param rate: how fast the mean diameter grows, over the thermal speed; chosen by the density if not given.
    :param gap: by which fraction diameters are reduced in the end; diameter and phi are those of the reduced spheres.
    :param dimensions: 2 for discs.
    :param start: a file with spheres, which grow from where they are.
    :param seed: the seed of the random numbers.
    :param limit: a time after which packing ends [s].
    :param polish: whether to remove the last gaps between spheres that have jammed; where that fails, `warnings` says
        so, and `is_polished` is false.
    :param threads: threads that share the work; affects only the speed.

    Error: what is given does not determine a packing, or none exists. PackingFailed: it was not reached.
    """
    parts: dict[str, str] = {"seed": str(whole_number(seed, "seed"))}
    radii: list[float] = []
    if isinstance(sizes, str):
        parts["sizes"] = sizes
    elif isinstance(sizes, tuple) and sizes and isinstance(sizes[0], str):
        parts["sizes"] = sizes[0] + ":" + _numbers_text(sizes[1:], "sizes")
    elif sizes is not None:
        radii = real_numbers(sizes, "sizes")
    if count is not None:
        parts["count"] = str(whole_number(count, "count"))
    if box is not None:
        parts["box"] = box if isinstance(box, str) else _numbers_text(box, "box")
    if phi is not None:
        parts["phi"] = phi if isinstance(phi, str) else repr(real_number(phi, "phi"))
    numbers = {"diameter": diameter, "pressure": pressure, "rate": rate, "gap": gap}
    parts.update({name: repr(real_number(value, name)) for name, value in numbers.items() if value is not None})
    if walls is not None:
        parts["walls"] = text(walls, "walls", "z")
    mesh = container if isinstance(container, Mesh) else None
    if container is not None and mesh is None:
        parts["container"] = text(container, "container", "cylinder:7,50")
    if start is not None:
        parts["start"] = path_text(start, "start")
    parts["dimensions"] = str(whole_number(dimensions, "dimensions"))
    packing = Packing.__new__(Packing)
    made = _hardball._pack(
        parts,
        radii,
        mesh,
        whole_number(threads, "threads"),
        None if limit is None else not_negative(limit, "limit"),
        truth(polish, "polish"),
    )
    _hardball.Packing.__init__(packing, made)
    if packing.status == "not reached":
        raise PackingFailed(packing)
    return packing


def _numbers_text(values: ArrayLike, name: str) -> str:
    return ",".join(repr(number) for number in real_numbers(values, name))
