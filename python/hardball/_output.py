# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The files that a simulation writes while it runs."""

from __future__ import annotations

from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._simulation import Simulation


class Output:
    """The files that a simulation writes while it runs, made by Simulation.output.

    As a context manager it completes the files at the end of the block, also where that ends by an exception.
    """

    __slots__ = ("_simulation", "_directory")

    def __init__(self, simulation: Simulation) -> None:
        self._simulation = simulation
        self._directory = Path(str(simulation._output_directory))

    @property
    def directory(self) -> Path:
        """Where the files are."""
        return self._directory

    @property
    def is_open(self) -> bool:
        """Whether they are still being written."""
        return self._simulation._output_directory == self._directory

    def close(self) -> None:
        """Completes the files, and writes the measures, the report and the summary; see Simulation.close."""
        if self.is_open:
            self._simulation.close()

    def __enter__(self) -> Output:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self.is_open:
            self._simulation._end_output(kind is None)

    def __repr__(self) -> str:
        return f"<hardball.Output in {self._directory}{'' if self.is_open else ', complete'}>"
