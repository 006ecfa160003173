# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Sweeps: one scenario run with many values, by any executor."""

from __future__ import annotations

import json
import os
import time
import traceback
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Callable, Mapping, Optional, Protocol, Union

import numpy as np
from numpy.typing import NDArray

from . import _hardball
from ._arguments import path_text, truth, whole_number
from ._scenario import scenario_text
from ._simulation import Simulation

Study = Union[str, "os.PathLike[str]", Mapping[str, Any]]
Results = Mapping[str, Any]
_Choice = tuple[str, Optional[str], Optional[str], Optional[str]]  # what _hardball._Study takes

_PATIENCE = 0.2  # seconds, until members that other processes run are tried again


class _Future(Protocol):
    def result(self) -> Any: ...


class Executor(Protocol):
    """What runs functions: of concurrent.futures, mpi4py.futures, Dask and others."""

    def submit(self, function: Callable[..., Any], /, *arguments: Any) -> _Future:
        """Has a function called, here or elsewhere."""
        ...


@dataclass(frozen=True, repr=False)
class Sweep:
    """What a sweep has found, as in the tables in its directory."""

    #: The directory of the tables, and of the members, 0001 and so on.
    directory: Path
    #: A structured array with an element for each combination of values: the values by their keys, the number of
    #: `runs` that have finished, and for each quantity its mean and, with the endings _error_between, _error_within and
    #: _error_ratio, its standard error by the scatter of the runs, that by the errors of the runs, and their ratio.
    points: NDArray[np.void]
    #: A structured array with an element for each member: its name, values, replica, seed and status, and each quantity
    #: with its error, which has the ending _error.
    runs: NDArray[np.void]
    #: The messages of members that have failed, by their names.
    failed: dict[str, str]
    _charts: list[dict[str, Any]] = field(compare=False)

    def __repr__(self) -> str:
        finished = int(np.count_nonzero(self.runs["status"] == "finished"))
        return f"<hardball.Sweep {self.directory}: {finished} of {len(self.runs)} members finished>"


def sweep(
    study: Study,
    *,
    executor: Executor | None = None,
    workers: int | None = None,
    function: Callable[[Simulation], Results] | None = None,
    out: str | os.PathLike[str] | None = None,
    retry: bool = False,
) -> Sweep:
    """Runs a scenario with many values, several times each, as `hardball sweep` does, and writes its tables.

    `study` is a file or a dict; `out` the directory, which a dict needs. Members that have finished are not run again,
    those that were interrupted are resumed, and those that have failed are left, unless `retry`. `executor` has any
    method `submit`, such as a pool of processes or of MPI, or Dask's `client.get_executor()`; its workers share the
    file system. Without one, `workers` threads run the members. `function` is called with the Simulation of each member,
    in place of the run, and returns numbers, or pairs of a number and its error, by their names. Error: as for check, of
    any member before the first one runs.
    """
    choice = _choice_of(study, out)
    read = _hardball._Study(*choice)
    if truth(retry, "retry"):
        read.forget_failures()
    count = None if workers is None else whole_number(workers, "workers")
    if count == 0 or (count is not None and executor is not None):
        raise _hardball.Error(f"workers: it is {workers}; give a positive number, or an executor instead")
    if function is not None and not callable(function):
        raise _hardball.Error(f"function: it is {function!r}; give a function of a simulation")
    indices, usual = read.check()
    read.begin()
    if executor is not None:
        _run_all(executor, choice, indices, function)
    else:
        _run_in_threads(count or usual, choice, indices, function)
    return _found(read)


def _choice_of(study: Study, out: str | os.PathLike[str] | None) -> _Choice:
    directory = None if out is None else os.path.abspath(path_text(out, "out"))
    if not isinstance(study, Mapping):
        return os.path.abspath(path_text(study, "study")), None, None, directory
    if directory is None:
        raise _hardball.Error("out: it is missing; give the directory of the sweep, which a file would name")
    whole = dict(study)
    scenario = whole.get("scenario")
    if isinstance(scenario, Mapping):
        del whole["scenario"]
        return "study", scenario_text(whole), scenario_text(scenario), directory
    if scenario is not None:
        # Workers may have another current directory.
        whole["scenario"] = os.path.abspath(path_text(scenario, "scenario"))
    return "study", scenario_text(whole), None, directory


def _run_all(
    executor: Executor, choice: _Choice, indices: list[int], function: Callable[[Simulation], Results] | None
) -> None:
    while indices:
        tasks = [(index, executor.submit(_run_member, choice, index, function)) for index in indices]
        indices = [index for index, task in tasks if task.result() == "busy"]
        if indices:
            time.sleep(_PATIENCE)


def _run_in_threads(
    workers: int, choice: _Choice, indices: list[int], function: Callable[[Simulation], Results] | None
) -> None:
    with ThreadPoolExecutor(workers) as executor:
        try:
            _run_all(executor, choice, indices, function)
        except BaseException:
            # Such as Ctrl-C: members write checkpoints and end.
            _hardball._request_interruption(True)
            executor.shutdown(cancel_futures=True)
            raise
        finally:
            _hardball._request_interruption(False)


def _run_member(choice: _Choice, index: int, function: Callable[[Simulation], Results] | None) -> str:
    """Runs a member, in whichever process. Returns how that ended."""
    study = _hardball._Study(*choice)
    if function is None:
        return study.run(index)
    lock = study.lock(index)
    if lock is None:
        return "busy"
    if study.state(index) in ("finished", "failed"):
        return study.state(index)
    study.prepare(index)
    folder = Path(study.directory_of(index))
    try:
        text = json.dumps({str(name): _number_of(value) for name, value in function(_member(study, choice, index)).items()})
    except Exception:
        _write(folder / "failed.txt", traceback.format_exc())
        return "failed"
    _write(folder / "results.json", text)
    return "finished"


def _member(study: _hardball._Study, choice: _Choice, index: int) -> Simulation:
    overrides = study.overrides_of(index)
    if choice[2] is not None:
        return Simulation._of(Simulation._from_scenario_text(choice[2], "scenario", overrides, "auto", None, None))
    return Simulation._of(Simulation._from_scenario_file(study.scenario_path, overrides, "auto", None, None))


def _number_of(value: Any) -> Any:
    """A result in JSON: a number, or a pair of a number and its error."""
    if isinstance(value, _hardball.Quantity):
        value = (value.value, value.error)
    if isinstance(value, (tuple, list)):
        number, error = (float(part) for part in value)
        return [number, error if np.isfinite(error) else None]
    return float(value)


def _write(path: Path, text: str) -> None:
    part = path.with_name(path.name + ".part")
    part.write_text(text)
    part.replace(path)


def _found(study: _hardball._Study) -> Sweep:
    found = study.write_tables()
    names = found["quantities"]
    rows, points = found["rows"], found["points"]
    unknown = (np.nan, np.nan)
    runs = {
        "member": [row["member"] for row in rows],
        **_columns_of_values(rows),
        **{name: [row[name] for row in rows] for name in ("replica", "seed", "status")},
    }
    for name in names:
        pairs = [row["quantities"].get(name, unknown) for row in rows]
        runs[name], runs[name + "_error"] = map(list, zip(*pairs))
    means = {**_columns_of_values(points), "runs": [point["runs"] for point in points]}
    for number, name in enumerate(names):
        for part, ending in enumerate(("", "_error_between", "_error_within", "_error_ratio")):
            means[name + ending] = [point["quantities"][number][part] for point in points]
    directory = Path(study.directory)
    failed = {
        name: (directory / name / "failed.txt").read_text().rstrip("\n")
        for name, status in zip(runs["member"], runs["status"])
        if status == "failed"
    }
    return Sweep(directory, _structured(means), _structured(runs), failed, found["charts"])


def _columns_of_values(rows: list[dict[str, Any]]) -> dict[str, list[Any]]:
    columns: dict[str, list[Any]] = {}
    for key in rows[0]["values"]:
        values = [json.loads(row["values"][key]) for row in rows]
        are_numbers = all(isinstance(value, (int, float)) for value in values)
        columns[key] = values if are_numbers else [v if isinstance(v, str) else json.dumps(v) for v in values]
    return columns


def _structured(columns: dict[str, list[Any]]) -> NDArray[np.void]:
    arrays = {name: np.asarray(column) for name, column in columns.items()}
    table = np.empty(len(next(iter(arrays.values()))), [(name, array.dtype) for name, array in arrays.items()])
    for name, array in arrays.items():
        table[name] = array
    table.flags.writeable = False
    return table
