# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Files with spheres, read frame by frame, and what other packages take."""

from __future__ import annotations

import os
from math import inf
from typing import TYPE_CHECKING, Any, Callable, Iterator, Sequence, TypeVar, Union, overload

import numpy as np
from numpy.typing import NDArray

from . import _hardball
from ._arguments import path_text, real_number
from ._ase import KINEMATIC
from ._view import View

if TYPE_CHECKING:
    import ase
    import MDAnalysis
    import pandas

Self = TypeVar("Self", bound="Trajectory")
Table = Union["pandas.DataFrame", NDArray[np.void]]


class Frame(_hardball.Frame):
    __doc__ = _hardball.Frame.__doc__

    def to_frame(self) -> Table:
        """A table with a row for each sphere: a pandas.DataFrame if pandas is installed, else a structured array.

        Its columns are those of CSV files: id, x, y, z [L], vx, vy, vz [L/T], radius [L], mass [M] and species.
        """
        return _table_of(_columns_of(self))

    def to_ase(self) -> ase.Atoms:
        """The spheres as an ASE Atoms object, with arrays 'radius' and 'species', as Simulation.from_ase reads it.

        Its cell is zero along open axes. Error (ImportError): ASE is not installed.
        """
        try:
            import ase
        except ImportError as error:
            raise ImportError("to_ase needs ASE, which is not installed: install it with 'pip install ase'") from error

        periodic = _periodic_axes(self)
        cell = np.diag(np.where(periodic, self.edges, 0.0))
        cell[1, 0] = self.tilt
        atoms = ase.Atoms(
            numbers=np.zeros(len(self), dtype=int),
            positions=self.positions - np.where(periodic, self.origin, 0.0),
            masses=np.minimum(self.masses, KINEMATIC),
            cell=cell,
            pbc=periodic,
        )
        atoms.set_velocities(self.velocities)
        atoms.set_array("radius", np.array(self.radii))
        atoms.set_array("species", np.array(self.species))
        if self.time is not None:
            atoms.info["time"] = self.time
        return atoms

    def to_mdanalysis(self) -> MDAnalysis.Universe:
        """The spheres as an MDAnalysis Universe of one frame; see Trajectory.to_mdanalysis."""
        return _universe_of([self])

    def to_freud(self) -> tuple[list[float], NDArray[np.float64]]:
        """What freud takes as a system: the box as [Lx, Ly, Lz, xy, xz, yz], and positions about its center [L].

        Lz is zero in two dimensions. freud needs periodic boxes: along other axes the box spans the spheres.
        """
        flat = self.box.dimensions == 2
        edges = np.array(self.edges)
        points = self.positions - (self.origin + edges / 2)
        if flat:
            edges[2] = 0.0
            points[:, 2] = 0.0
        slope = self.tilt / edges[1] if self.tilt else 0.0
        return [float(edges[0]), float(edges[1]), float(edges[2]), slope, 0.0, 0.0], points

    def __repr__(self) -> str:
        return f"<hardball.Frame of {len(self)} spheres{'' if self.time is None else f' at time {self.time:g}'}>"


class Trajectory(Sequence[Frame]):
    """The frames of a file, which are read when they are asked for: a sequence, whose slices read nothing.

    Reading in order is fastest. Error: as in `read`; IndexError: there is no such frame.
    """

    __slots__ = ("_path", "_numbers", "_read")

    def __init__(self, path: str, count: int, read: Callable[[int], _hardball.Frame]) -> None:
        self._path = path
        self._numbers: Sequence[int] = range(count)
        self._read = read

    @property
    def path(self) -> str:
        """The name of the file."""
        return self._path

    def __len__(self) -> int:
        return len(self._numbers)

    @overload
    def __getitem__(self, index: int) -> Frame: ...

    @overload
    def __getitem__(self: Self, index: slice) -> Self: ...

    def __getitem__(self: Self, index: int | slice) -> Frame | Self:
        if isinstance(index, slice):
            part = object.__new__(type(self))
            for kind in type(self).__mro__:
                for name in getattr(kind, "__slots__", ()):
                    if hasattr(self, name):
                        setattr(part, name, getattr(self, name))
            part._numbers = self._numbers[index]
            return part
        try:
            number = self._numbers[index]
        except IndexError:
            raise IndexError(f"there is no frame {index}: {self._path} has {len(self)}") from None
        return frame_of(self._read(number))

    def __iter__(self) -> Iterator[Frame]:
        for number in self._numbers:
            yield frame_of(self._read(number))

    def to_frame(self) -> Table:
        """All frames as one table, as Frame.to_frame makes it, with a first column `time` [T], NaN if unknown."""
        columns: dict[str, list[NDArray[Any]]] = {}
        for frame in self:
            time = np.nan if frame.time is None else frame.time
            for name, values in {"time": np.full(len(frame), time), **_columns_of(frame)}.items():
                columns.setdefault(name, []).append(values)
        return _table_of({name: np.concatenate(parts) for name, parts in columns.items()})

    def to_ase(self) -> list[ase.Atoms]:
        """All frames as ASE Atoms objects, as ase.io.write takes them; see Frame.to_ase."""
        return [frame.to_ase() for frame in self]

    def to_mdanalysis(self) -> MDAnalysis.Universe:
        """All frames in one MDAnalysis Universe, in memory, with masses, radii, ids and species as types.

        MDAnalysis keeps positions and velocities in single precision. Error: frames have other numbers of spheres;
        ImportError: MDAnalysis is not installed.
        """
        return _universe_of(list(self))

    def __repr__(self) -> str:
        return f"<hardball.{type(self).__name__} {self._path}: {len(self)} frames>"


class Recording(Trajectory):
    """The whole history of a run, from recording.hbr: a sequence of frames, and the spheres at any other time.

    Its frames are those asked for in `read`: by default those at which its parts begin, and its end.
    """

    __slots__ = ("_recording",)

    def __init__(self, path: str, every: float | None) -> None:
        recording = _hardball._Recording(path)
        begin, end = recording.begin, recording.end
        if every is None:
            times = recording.times()
        else:
            # A time that is beyond the end only by rounding is the end.
            count = int(np.floor((end - begin) / every * (1 + 1e-12))) + 1
            times = [min(begin + k * every, end) for k in range(count)]
        super().__init__(path, len(times), lambda number: recording.at(times[number]))
        self._recording = recording

    @property
    def begin(self) -> float:
        """When it begins [T]."""
        return self._recording.begin

    @property
    def end(self) -> float:
        """Up to when the run is known [T]."""
        return self._recording.end

    def at(self, time: float) -> Frame:
        """The spheres at a time from begin to end [T], after all contacts at that time. Error: any other time."""
        return frame_of(self._recording.at(real_number(time, "time")))

    def view(self) -> View:
        """The run in the viewer, as `hardball replay` shows it: inline in a notebook, otherwise to be saved or opened.

        Error: the recording exceeds 200 MB, more than browsers open.
        """
        return View(_hardball.Simulation._page_of(self.path))

    def contacts(self) -> NDArray[np.void]:
        """All collisions and wall contacts, as a structured array with the fields time [T], kind, first and second.

        They mean what they mean in events.npy. Cost: that of reading the file.
        """
        return _structured(self._recording.contacts())


def read(path: str | os.PathLike[str], *, every: float | None = None) -> Trajectory:
    """Opens a file with spheres: extended XYZ, GSD, a LAMMPS dump or data file, CSV, NumPy, .sph or recording.hbr.

    Text formats may be compressed: .xyz.zst. Returns a Trajectory, a sequence of frames; of a recording a Recording,
    whose frames are `every` apart [T]. Error: the file cannot be read, or is not what its name says.
    """
    name = path_text(path, "path")
    if name.endswith(".hbr"):
        step = None if every is None else real_number(every, "every")
        if step is not None and not 0 < step < inf:
            raise _hardball.Error(f"every: it is {step}; give a positive time")
        return Recording(name, step)
    if every is not None:
        raise _hardball.Error("every: only recordings have frames at any time; leave it out, or take a slice")
    snapshots = _hardball._Snapshots(name)
    return Trajectory(name, len(snapshots), snapshots.read)


def frame_of(made: _hardball.Frame) -> Frame:
    """A frame as Python shows it, of which `made` gives up the spheres."""
    frame = Frame.__new__(Frame)
    _hardball.Frame.__init__(frame, made)
    return frame


def _periodic_axes(frame: Frame) -> NDArray[np.bool_]:
    return np.array([boundary == "periodic" for boundary in frame.box.boundary])


def _columns_of(frame: Frame) -> dict[str, NDArray[Any]]:
    columns: dict[str, NDArray[Any]] = {"id": frame.ids}
    for names, vectors in (("xyz", frame.positions), (("vx", "vy", "vz"), frame.velocities)):
        columns.update({name: vectors[:, axis] for axis, name in enumerate(names)})
    return {**columns, "radius": frame.radii, "mass": frame.masses, "species": frame.species}


def _table_of(columns: dict[str, NDArray[Any]]) -> Table:
    try:
        import pandas
    except ImportError:
        return _structured(columns)
    return pandas.DataFrame(columns)


def _structured(columns: dict[str, Any]) -> NDArray[np.void]:
    length = len(next(iter(columns.values()), ()))
    table = np.empty(length, dtype=[(name, values.dtype) for name, values in columns.items()])
    for name, values in columns.items():
        table[name] = values
    return table


def _universe_of(frames: list[Frame]) -> MDAnalysis.Universe:
    try:
        import MDAnalysis
        from MDAnalysis.coordinates.memory import MemoryReader
    except ImportError as error:
        raise ImportError(
            "to_mdanalysis needs MDAnalysis, which is not installed: install it with 'pip install MDAnalysis'"
        ) from error

    first = frames[0] if frames else None
    if first is None or any(len(frame) != len(first) for frame in frames):
        raise _hardball.Error("the frames have different numbers of spheres: take a slice of those that have not")
    universe = MDAnalysis.Universe.empty(len(first), n_residues=1, trajectory=True, velocities=True)
    universe.add_TopologyAttr("masses", first.masses)
    universe.add_TopologyAttr("radii", first.radii)
    universe.add_TopologyAttr("ids", first.ids)
    universe.add_TopologyAttr("types", [str(species) for species in first.species])
    times = [0.0 if frame.time is None else frame.time for frame in frames]
    universe.load_new(
        np.array([frame.positions - frame.origin for frame in frames]),
        format=MemoryReader,
        order="fac",
        velocities=np.array([frame.velocities for frame in frames]),
        dimensions=np.array([_dimensions_of(frame) for frame in frames]),
        dt=times[1] - times[0] if len(times) > 1 and times[1] > times[0] else 1.0,
    )
    return universe


# Edges and angles.
def _dimensions_of(frame: Frame) -> list[float]:
    edges = [float(edge) for edge in frame.edges]
    slanted = float(np.hypot(edges[1], frame.tilt))
    gamma = float(np.degrees(np.arccos(frame.tilt / slanted))) if slanted > 0 else 90.0
    return [edges[0], slanted, edges[2], 90.0, 90.0, gamma]
