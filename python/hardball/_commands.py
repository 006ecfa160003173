# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""What the commands of the program do, with the same words."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Mapping, Union

import numpy as np
from numpy.typing import NDArray

from . import _hardball
from ._arguments import engine_name, path_text, real_number, text, truth, whole_number
from ._scenario import changes_of, scenario_text

Scenario = Union[str, "os.PathLike[str]", Mapping[str, Any]]


class Check(dict[str, Union[int, float, str]]):
    """What is known of a scenario before it runs: the rows of `hardball check` by their names, numbers as numbers.

    Printing it shows the table. `notes` are its warnings.
    """

    __slots__ = ("_rows",)

    def __init__(self, rows: list[tuple[str, str]]) -> None:
        super().__init__({name.strip(): _number_or_text(value) for name, value in rows if value and name != "note"})
        self._rows = rows

    @property
    def notes(self) -> list[str]:
        """What may not be as it was meant, a sentence each."""
        return [value for name, value in self._rows if name == "note"]

    def __str__(self) -> str:
        return "\n".join(f"{name:<24}{value}".rstrip() for name, value in self._rows)

    def __repr__(self) -> str:
        return f"<hardball.Check of {self['scenario']}: {self['spheres']} spheres>"


@dataclass(frozen=True)
class VerifiedRun:
    """One way in which `verify` has run a scenario."""

    #: The way, such as 'neighbors'.
    name: str
    #: Why it was left out; empty if it was not.
    skipped: str
    #: The hash of all contacts, in 16 hexadecimal digits.
    event_log_hash: str
    #: The number of collisions.
    collisions: int
    #: The deepest overlap of two bodies, in diameters [1].
    max_overlap: float
    #: Whether the hash and the final state are those of the first way, bit by bit.
    is_same: bool
    #: Whether nothing overlaps, and all numbers are finite.
    is_sound: bool
    #: Wall time.
    seconds: float


class Verification(tuple[VerifiedRun, ...]):
    """The runs of one scenario by every engine; true if all are the same, and sound."""

    __slots__ = ()

    def __bool__(self) -> bool:
        return all(run.is_same and run.is_sound for run in self)

    def __repr__(self) -> str:
        runs = sum(not run.skipped for run in self)
        return f"<hardball.Verification: {runs} runs {'are the same' if self else 'DIFFER, OR SPHERES OVERLAP'}>"


@dataclass(frozen=True)
class Tuning:
    """The cost of cells of many sizes, predicted and measured: arrays with an element for each size."""

    #: Edges of the cells, ascending [L].
    cell_edge: NDArray[np.float64]
    #: The cost of a unit of simulated time [s/T], as predicted.
    predicted: NDArray[np.float64]
    #: The median, the least and the largest of those measured [s/T].
    measured: NDArray[np.float64]
    least: NDArray[np.float64]
    most: NDArray[np.float64]
    #: The edge that is chosen without a tuning, that of the paper, and that of the least measured cost [L].
    chosen: float
    paper: float
    best: float
    #: The table that `hardball tune` prints.
    text: str

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<hardball.Tuning: best {self.best:.4g}, chosen {self.chosen:.4g}>"


def check(
    scenario: Scenario,
    *,
    overrides: Mapping[str, Any] | None = None,
    until: float | None = None,
    seed: int | None = None,
    engine: str = "auto",
) -> Check:
    """Validates a scenario, a file or a dict, and predicts its cost, as `hardball check` does.

    `overrides` are as in Simulation.from_scenario, `until` is the end of the run [T]. It takes about a second. Error:
    that of the scenario; neither it nor `until` says when the run ends.
    """
    return Check(_hardball._check(_choice_of(scenario, overrides, until, seed), engine_name(engine)))


def verify(
    scenario: Scenario,
    *,
    overrides: Mapping[str, Any] | None = None,
    until: float | None = None,
    seed: int | None = None,
) -> Verification:
    """Runs a scenario with every engine and compares the runs bit by bit, as `hardball verify` does.

    Cost: that of about ten runs, of which those by slow engines are left out where they would take too long. Error:
    as for check.
    """
    runs = _hardball._verify(_choice_of(scenario, overrides, until, seed))
    return Verification(VerifiedRun(**run) for run in runs)


def tune(
    scenario: Scenario,
    *,
    overrides: Mapping[str, Any] | None = None,
    until: float | None = None,
    seed: int | None = None,
    budget: float = 10.0,
    unit_costs: str = "auto",
    out: str | os.PathLike[str] | None = None,
) -> Tuning:
    """Compares cells of many sizes, as `hardball tune` does: what they should cost, and what they cost.

    `budget` is how long to measure [s], `out` a directory for tune.csv and tune.svg. Error: as for check; nothing
    moves.
    """
    found = _hardball._tune(
        _choice_of(scenario, overrides, until, seed),
        text(unit_costs, "unit_costs", "auto"),
        repr(real_number(budget, "budget")),
        None if out is None else path_text(out, "out"),
    )
    return Tuning(**found)


def convert(
    source: str | os.PathLike[str],
    target: str | os.PathLike[str],
    *,
    frame: int | None = None,
    overwrite: bool = False,
) -> int:
    """Converts the frames of a file to the format that the name of another says, as `hardball convert` does.

    Converts all frames or, if the format has a single one, the last; or number `frame`, from 0 on. Returns how many
    were written. Error: a file cannot be read or written; the target exists, unless `overwrite`.
    """
    number = None if frame is None else str(whole_number(frame, "frame"))
    return _hardball._convert(
        path_text(source, "source"), path_text(target, "target"), number, truth(overwrite, "overwrite")
    )


def info(path: str | os.PathLike[str]) -> str:
    """Describes a file of any kind in lines, as `hardball info` does: snapshots, recordings, checkpoints, scenarios.

    Error: it cannot be read, or is none of these.
    """
    return _hardball._describe_file(Path(path_text(path, "path"))).rstrip("\n")


def _choice_of(
    scenario: Scenario, overrides: Mapping[str, Any] | None, until: float | None, seed: int | None
) -> _hardball._ScenarioChoice:
    is_dict = isinstance(scenario, Mapping)
    return _hardball._ScenarioChoice(
        path="scenario" if is_dict else path_text(scenario, "scenario"),
        text=scenario_text(scenario) if isinstance(scenario, Mapping) else None,
        overrides=changes_of(overrides),
        until=None if until is None else repr(real_number(until, "until")),
        seed=None if seed is None else str(whole_number(seed, "seed")),
    )


def _number_or_text(value: str) -> int | float | str:
    try:
        number = float(value)
    except ValueError:
        return value
    return int(value) if value.isdigit() else number
