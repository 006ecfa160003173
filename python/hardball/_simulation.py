# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The class Simulation: the C++ class, and what only Python needs."""

from __future__ import annotations

import json
import os
from contextlib import nullcontext
from copy import deepcopy
from math import inf
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Iterable, Iterator, Literal, Mapping, Sequence, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _hardball
from ._arguments import (
    bonds_of,
    engine_name,
    list_of,
    path_text,
    processes_of,
    real_number,
    species_pairs,
    truth,
    whole_number,
)
from ._frames import Frame, frame_of
from ._live import LiveView, live_view_of
from ._notebook import html_of
from ._output import Output
from ._progress import shown_progress
from ._scenario import changes_of, scenario_text
from ._view import View, is_notebook, view_of

if TYPE_CHECKING:
    import ase

    from ._typing import Response, Thermostat

Self = TypeVar("Self", bound="Simulation")


class Simulation(_hardball.Simulation):
    __doc__ = _hardball.Simulation.__doc__
    _live: LiveView | None = None  # which follows its runs

    def __init__(
        self,
        box: _hardball.Box,
        *,
        positions: ArrayLike,
        velocities: ArrayLike = (0.0, 0.0, 0.0),
        radius: ArrayLike = 1.0,
        mass: ArrayLike = 1.0,
        spin: ArrayLike = (0.0, 0.0, 0.0),
        species: ArrayLike = 0,
        moment: ArrayLike | None = None,
        gravity: ArrayLike = (0.0, 0.0, 0.0),
        surfaces: Sequence[_hardball.Surface] = (),
        passing: Sequence[tuple[int, int]] = (),
        steps: _hardball.StepTable | _hardball.StepPotential | None = None,
        bonds: Sequence[tuple[int, int, int]] = (),
        response: Response | None = None,
        thermostat: Thermostat | None = None,
        seed: int = 1,
        engine: str = "auto",
        cell_edge: float | None = None,
        processes: _hardball.Processes | None = None,
    ) -> None:
        """Starts at time zero.

        :param positions: centers [L], shape (n, 3), or (n, 2) in two dimensions.
        :param velocities: [L/T], of the same shape, or one vector for all. Vectors have three numbers, in two
            dimensions also two.
        :param radius: [L], of shape (n,), or one number for all.
        :param mass: [M], of the same shape as radius. A sphere of infinite mass is kinematic: no collision deflects it.
        :param spin: angular velocity [1/T], of the same shape as velocities.
        :param species: a number from 0 to 255, of the same shape as radius.
        :param moment: the moment of inertia over mass and squared radius, of the same shape as radius; by default that
            of uniform spheres or discs.
        :param gravity: acceleration of all spheres [L/T^2].
        :param surfaces: walls inside the box, and obstacles.
        :param passing: pairs of species that pass through each other.
        :param steps: potentials of steps: a StepTable, or one StepPotential for all spheres.
        :param bonds: spheres that are tied together: the ids of two, their numbers in `positions`, and the number that
            StepTable.add_bond gave.
        :param response: what contacts do: a coefficient of restitution, a Bounce, a Merging, a ResponseTable, or a
            function that takes a Contact and returns the velocities of both bodies, or an Outcome; elastic by default.
        :param thermostat: an Andersen, a Rescale or a Heating.
        :param seed: the seed of the thermostat's random numbers.
        :param engine: how collisions are found: 'auto', 'cells', 'neighbors', 'all-pairs' or 'paper'. The choice changes
            the speed and never the history.
        :param cell_edge: the edge of its cells [L]; also changes only the speed.
        :param processes: mpi_processes() for processes that share the simulation, each of which gives the same
            arguments; by default this one alone.

        Error: spheres that overlap or reach through a wall; numbers that are not finite or out of range.
        """
        if not isinstance(box, _hardball.Box):
            raise _hardball.Error(f"box: it is {box!r}; give one such as hardball.Box.periodic(10.0)")
        super().__init__(
            box,
            positions=positions,
            velocities=velocities,
            radius=radius,
            mass=mass,
            spin=spin,
            species=species,
            moment=moment,
            gravity=gravity,
            surfaces=list_of(_hardball.Surface, surfaces, "surfaces"),
            passing=species_pairs(passing, "passing"),
            steps=steps,
            bonds=bonds_of(bonds, "bonds"),
            response=response,
            thermostat=thermostat,
            seed=whole_number(seed, "seed"),
            engine=engine_name(engine),
            cell_edge=None if cell_edge is None else real_number(cell_edge, "cell_edge"),
            processes=processes_of(processes),
        )

    @classmethod
    def _of(cls: type[Self], made: _hardball.Simulation) -> Self:
        self = cls.__new__(cls)
        _hardball.Simulation.__init__(self, made)
        return self

    # --- other ways to make one ---

    @classmethod
    def from_scenario(
        cls: type[Self],
        scenario: str | os.PathLike[str] | Mapping[str, Any],
        *,
        overrides: Mapping[str, Any] | None = None,
        engine: str = "auto",
        cell_edge: float | None = None,
        processes: _hardball.Processes | None = None,
    ) -> Self:
        """The simulation of a scenario: the path of a file, or the same keys and values as a dict.

        `overrides` replaces or adds values: {'run.seed': 7, 'spheres.0.count': 100}. A run without a limit ends
        where the scenario says. `processes` share the simulation if each gives the same scenario; see mpi_processes.
        Error: the same as on the command line, with its location.
        """
        changes = changes_of(overrides)
        engine = engine_name(engine)
        cell_edge = None if cell_edge is None else real_number(cell_edge, "cell_edge")
        shared = processes_of(processes)
        if isinstance(scenario, Mapping):
            text = scenario_text(scenario)
            return cls._of(cls._from_scenario_text(text, "scenario", changes, engine, cell_edge, shared))
        return cls._of(cls._from_scenario_file(path_text(scenario, "scenario"), changes, engine, cell_edge, shared))

    @classmethod
    def from_file(
        cls: type[Self],
        path: str | os.PathLike[str],
        *,
        overrides: Mapping[str, Any] | None = None,
        engine: str = "auto",
        cell_edge: float | None = None,
        processes: _hardball.Processes | None = None,
    ) -> Self:
        """Starts from the last frame of a file: extended XYZ, GSD, a LAMMPS dump or data file, CSV, NumPy or .sph.

        The box is that of the file: periodic where the file says so, otherwise open; that of a LAMMPS data file, which
        says nothing, is periodic. `overrides` changes it or adds other keys of a scenario: {'box.boundary':
        ['wall'] * 3, 'start.shrink': True, 'response.restitution': 0.9}. `processes` share the simulation; see
        mpi_processes.
        """
        file = path_text(path, "path")
        scenario = {"box": cls._box_of_file(file), "start": {"file": os.path.abspath(file)}}
        return cls.from_scenario(
            scenario, overrides=overrides, engine=engine, cell_edge=cell_edge, processes=processes
        )

    @classmethod
    def from_ase(cls: type[Self], atoms: ase.Atoms, *, radius: ArrayLike | None = None, **options: Any) -> Self:
        """The simulation of an ASE Atoms object: its cell, positions, masses and velocities.

        Periodic axes of the cell stay periodic, the others are open; the cell must be rectangular.
        `radius` [L] is needed if the atoms have no array 'radius'. `options` are those of Simulation, and override the
        values of the atoms.
        """
        from ._ase import arguments_of

        return cls(**{**arguments_of(atoms, radius), **options})

    @classmethod
    def gas(
        cls: type[Self],
        count: int,
        *,
        radius: float = 0.5,
        packing_fraction: float | None = None,
        density: float | None = None,
        temperature: float = 1.0,
        boundary: str = "periodic",
        dimensions: int = 3,
        seed: int = 1,
        engine: str = "auto",
        processes: _hardball.Processes | None = None,
    ) -> Self:
        """A gas of equal spheres of mass one at random places, in a cubic box that is made for them.

        The box follows from their packing fraction [1], or from their density, their number over its volume
        [L^-3], or area in two dimensions. `radius` [L], kT [M L^2 T^-2]; `boundary` is 'periodic' or 'wall'. The other
        arguments are as in Simulation. Error: both, or neither, of packing_fraction and density are given; the
        spheres do not fit.
        """
        spheres = whole_number(count, "count")
        size = real_number(radius, "radius")
        axes = whole_number(dimensions, "dimensions")
        if axes not in (2, 3):
            raise _hardball.Error(f"dimensions: it is {axes}; give 2 or 3")
        if (packing_fraction is None) == (density is None):
            raise _hardball.Error("packing_fraction: give either it or density, by which the box is made")
        box: dict[str, Any] = {"boundary": [boundary] * axes, "dimensions": axes}
        if density is not None:
            number_density = real_number(density, "density")
            if not number_density > 0:
                raise _hardball.Error(f"density: it is {number_density}; give a positive number")
            box["size"] = [(spheres / number_density) ** (1 / axes)] * axes
        else:
            box["packing_fraction"] = real_number(packing_fraction, "packing_fraction")
        group = {"count": spheres, "radius": size, "placement": "random", "temperature": real_number(temperature, "temperature")}
        scenario = {"box": box, "spheres": [group], "run": {"seed": whole_number(seed, "seed")}}
        return cls.from_scenario(scenario, engine=engine, processes=processes)

    @classmethod
    def resume(
        cls: type[Self],
        directory: str | os.PathLike[str],
        *,
        checkpoint: str | None = None,
        processes: _hardball.Processes | None = None,
    ) -> Self:
        """The simulation of a run that has not ended, from its directory; further runs continue its files.

        It is that of the last checkpoint, by the program or by `output`, or of another one in the directory, such as
        'checkpoints/10.hbc'; what the files hold beyond is cut off. `close` completes them. Custom responses and
        listeners are not saved: set them again. Error: there is no checkpoint; it or a file is damaged; another run is
        writing to the directory.
        """
        return cls._of(cls._resumed(path_text(directory, "directory"), checkpoint, processes_of(processes)))

    @classmethod
    def load(
        cls: type[Self],
        saved: bytes | bytearray | memoryview | str | os.PathLike[str],
        *,
        processes: _hardball.Processes | None = None,
    ) -> Self:
        """A simulation from the bytes or the file of `save`, or from a checkpoint of the command line.

        `processes` share the simulation, whatever number of them saved it; see mpi_processes. Error: it is damaged, or
        of a later version.
        """
        shared = processes_of(processes)
        if isinstance(saved, (bytes, bytearray, memoryview)):
            return cls._of(cls._loaded(bytes(saved), shared))
        return cls._of(cls._load_file(path_text(saved, "saved"), shared))

    @overload
    def save(self, path: None = ...) -> bytes: ...

    @overload
    def save(self, path: str | os.PathLike[str]) -> None: ...

    def save(self, path: str | os.PathLike[str] | None = None) -> bytes | None:
        """Saves the whole state, with the measures, as bytes or to a file.

        From either, `load` makes a simulation that continues to the same history. Listeners, custom responses and the
        attributes of a subclass are not saved. `pickle` keeps custom responses and attributes, `copy` also listeners. The file
        is either unchanged or complete. Of several processes, the first writes it. Copies are shared by the same
        processes; a simulation that was pickled, by one. Cost: O(size).
        """
        if path is None:
            return self._saved()
        self._save_file(path_text(path, "path"))
        return None

    def __copy__(self: Self) -> Self:
        other = type(self)._of(self._copy())
        other.__dict__.update(self.__dict__)
        return other

    def __deepcopy__(self: Self, memo: dict[int, Any]) -> Self:
        other = type(self)._of(self._copy())
        memo[id(self)] = other
        other.__dict__.update(deepcopy(self.__dict__, memo))
        return other

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (type(self), self._saved(), self._response), self.__dict__ or None

    # --- running ---

    @overload
    def run(
        self,
        until: float | None = ...,
        *,
        collisions: int | None = ...,
        contacts: int | None = ...,
        record: Literal[False] = ...,
        progress: bool = ...,
    ) -> int: ...

    @overload
    def run(
        self,
        until: float | None = ...,
        *,
        collisions: int | None = ...,
        contacts: int | None = ...,
        record: Literal[True],
        progress: bool = ...,
    ) -> NDArray[np.void]: ...

    def run(
        self,
        until: float | None = None,
        *,
        collisions: int | None = None,
        contacts: int | None = None,
        record: bool = False,
        progress: bool = False,
    ) -> int | NDArray[np.void]:
        """Runs to the time `until` [T], events at that time included, or for a number of collisions or contacts.

        The run ends at the first limit that it reaches. A contact is a collision of two spheres or a contact with a
        wall. If spheres may never meet again, in open space or a periodic box, give a finite time. Returns the number
        of contacts or, with `record`, all of them as an array with the fields of events.npy: time, kind (0 a collision,
        1 a wall), first, second, normal_speed and impulse. `progress` shows a bar if tqdm is installed. Releases the
        GIL. Ctrl-C stops the run cleanly between two events; the simulation can be run further. Several processes stop
        where the first one is interrupted, and RunFailure is raised in the others.
        """
        if until is not None:
            until = real_number(until, "until")
        if collisions is not None:
            collisions = whole_number(collisions, "collisions")
        if contacts is not None:
            contacts = whole_number(contacts, "contacts")
        end = self.until if until is None and collisions is None and contacts is None else until
        with shown_progress(self.time, end) if progress and self.processes.rank == 0 else nullcontext() as bar:
            live = self._live
            done: int | NDArray[np.void]
            done = self._run(until, collisions, contacts, record, bar if live is None else live._following(bar))
        if live is not None:
            live._complete()
        return done

    def events(self, until: float | None = None) -> Iterator[_hardball.Contact]:
        """Runs from contact to contact up to `until` [T]: at each, the simulation is at its time and may be edited."""
        end = inf if until is None else real_number(until, "until")
        while (contact := self._step(end)) is not None:
            yield contact

    def measure(
        self,
        names: str | Iterable[str] = "all",
        *,
        every: float | None = None,
        start: float = 0.0,
        face_forces: bool = False,
        torque_about: Mapping[int, ArrayLike] = MappingProxyType({}),
    ) -> None:
        """Starts measures for all further runs: some of measure_names(), or "all".

        `every` is the time between samples [T], by default each measure's own choice; `start` is when measuring begins
        [T]. With `face_forces`, those on each triangle of meshes are measured with "wall_forces". `torque_about` says,
        by the index of a surface, about which point torque on it is measured, as a vector from the surface's point [L].
        Earlier results are discarded. While measures are on, spheres cannot be added or removed. Other
        edits are accounted for, with a warning, as results then average over the states before and after. No
        measure changes the history.
        """
        chosen = [names] if isinstance(names, str) else list_of(str, names, "names")
        interval = None if every is None else real_number(every, "every")
        points = [(whole_number(surface, "torque_about"), offset) for surface, offset in torque_about.items()]
        self._measure(chosen, interval, real_number(start, "start"), truth(face_forces, "face_forces"), points)

    # --- files ---

    def write(self, path: str | os.PathLike[str], *, append: bool = False) -> None:
        """Writes the spheres as they are now to a file, in the format that its name says.

        Formats: extended XYZ (.xyz, .xyz.zst), GSD (.gsd), LAMMPS dump (.lammpstrj), data file (.data), VTP (.pvd), CSV
        (.csv), NumPy (.npy) and .sph. The file is replaced or, with `append`, continued by a frame; after each it is
        complete. Of several processes, the first writes it. Error: the name says no format; it cannot be written; with
        `append`, the format has a single frame, or the last frame of the file is damaged. Cost: O(size), and for the
        first frame that is appended to a file, that of reading it.
        """
        self._write(path_text(path, "path"), truth(append, "append"))

    def output(
        self,
        directory: str | os.PathLike[str] | None = None,
        *,
        snapshots_every: float | None = None,
        snapshots_per_decade: int | None = None,
        first_snapshot: float | None = None,
        snapshots_every_contacts: int | None = None,
        trajectory: str | Sequence[str] | None = None,
        event_log: bool | None = None,
        recording: bool | None = None,
        checkpoint_every: float | None = None,
        checkpoint_at: Sequence[float] | None = None,
        report: bool | None = None,
        overwrite: bool = False,
    ) -> Output:
        """Writes files during all further runs, like the program: those of the table [output] of a scenario.

        Arguments are the keys of [output], with their meanings and defaults (docs/scenarios.md); those that are not
        given are as in the scenario that the simulation is made of. The directory then has the trajectory, events.npy,
        recording.hbr and checkpoint.hbc and, once the files are completed by `close` or at the end of a `with` block,
        measures/, report.html and summary.json. Measures are those that `measure` has chosen before. Spheres cannot be
        added or removed, nor responses replaced, while a recording is written.

        :param directory: where the files are; it is made if necessary.
        :param snapshots_every: the time between frames [T]; none are written unless this or one of the next is given.
        :param snapshots_per_decade: or: how many frames while the time grows tenfold, from `first_snapshot` [T] on.
        :param snapshots_every_contacts: or: how many contacts lie between frames.
        :param trajectory: 'xyz', 'xyz.zst', 'gsd', 'lammps' or 'vtp', or several of them.
        :param event_log: whether to write events.npy.
        :param recording: whether to write recording.hbr, for the viewer and for `read`.
        :param checkpoint_every: seconds of wall time between checkpoints, from which `resume` and `hardball resume` resume.
        :param checkpoint_at: times [T] at which a checkpoint is also written, and kept.
        :param report: whether to write report.html.
        :param overwrite: whether files of another run in the directory are replaced.

        Error: no directory is given; it holds files of another run; an unsuitable value; files are being written already.
        """
        keys: dict[str, Any] = {
            "directory": None if directory is None else path_text(directory, "directory"),
            "snapshots_every": snapshots_every,
            "snapshots_per_decade": snapshots_per_decade,
            "first_snapshot": first_snapshot,
            "snapshots_every_contacts": snapshots_every_contacts,
            "trajectory": [trajectory] if isinstance(trajectory, str) else trajectory,
            "event_log": event_log,
            "recording": recording,
            "checkpoint_every": checkpoint_every,
            "checkpoint_at": checkpoint_at,
            "report": report,
        }
        given = {f"output.{key}": value for key, value in keys.items() if value is not None}
        self._begin_output(changes_of(given), truth(overwrite, "overwrite"))
        return Output(self)

    def close(self) -> None:
        """Completes the files that `output` has begun; does nothing if there are none. The simulation may be run further."""
        self._end_output(True)

    def report(self, path: str | os.PathLike[str]) -> None:
        """Writes the report of the run so far: one page of HTML with the results of all measures, as the program does.

        Of several processes, all call it, and the first writes. Cost: that of an audit.
        """
        page = self._report()
        if self.processes.rank == 0:
            Path(path_text(path, "path")).write_bytes(page)

    def summary(self) -> dict[str, Any]:
        """The results of the run so far, with the keys of summary.json (docs/scenarios.md). Cost: that of an audit."""
        found: dict[str, Any] = json.loads(self._summary())
        return found

    def frame(self) -> Frame:
        """The spheres as they are now, with all that can be done to frames of files: to_frame, to_ase and so on."""
        return frame_of(_hardball._frame_of(self))

    # --- pictures ---

    def view(self, until: float | None = None, *, contacts: int | None = None) -> View:
        """Shows what happens next: inline in a notebook, elsewhere in the browser.

        The view ends at the time `until` [T], or after `contacts` contacts; without a limit, after about ten contacts
        of each sphere, but not beyond the end of the scenario. The simulation does not change: the page shows what a
        run would do without listeners. It can be saved as a file. Error: the page exceeds 200 MB, more than browsers
        open.
        """
        end = None if until is None else real_number(until, "until")
        page = view_of(self, end, None if contacts is None else whole_number(contacts, "contacts"))
        if not is_notebook():
            page.open()
        return page

    def live(self) -> LiveView:
        """Shows further runs in a notebook while they go on, as pictures that can be turned, paused and wound back.

        Twice a second the page gets what has been recorded since. Until the view is closed, runs are recorded: in the
        files of `output`, if these have a recording, or else in a temporary folder. Spheres cannot be added or removed
        meanwhile. Error: files are being written without a recording; ImportError: anywidget is missing, which
        `pip install hardball[live]` installs: `view` does without.
        """
        if self._live is None:
            self._follow(live_view_of(self))
        assert self._live is not None
        return self._live

    def _follow(self, view: LiveView | None) -> None:
        self.__dict__["_live"] = view

    def __repr__(self) -> str:
        return (
            f"<hardball.Simulation of {len(self)} spheres at time {self.time:g}: {self.collisions} collisions, "
            f"{self.wall_contacts} wall contacts>"
        )

    def _repr_html_(self) -> str:
        return html_of(self)


def _restored(kind: type[Simulation], saved: bytes, response: Any) -> Simulation:
    simulation = kind.load(saved)
    if response is not None:
        simulation._set_response(response)
    return simulation
