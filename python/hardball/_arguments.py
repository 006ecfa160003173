# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Arguments that are checked in Python."""

from __future__ import annotations

import operator
import os
from numbers import Real
from typing import Any, Iterable, TypeVar

import numpy as np

from . import _hardball

Item = TypeVar("Item")


def whole_number(value: Any, name: str) -> int:
    """A count; 1e4 is allowed. Error: it is negative, or not a whole number."""
    try:
        number = operator.index(value)
    except TypeError:
        if not isinstance(value, Real) or not float(value).is_integer():
            raise _hardball.Error(f"{name}: it is {value!r}; give a whole number") from None
        number = int(value)
    if number < 0:
        raise _hardball.Error(f"{name}: it is {number}; give a number that is not negative")
    return number


def real_number(value: Any, name: str) -> float:
    """Error: it is not a number."""
    try:
        if not isinstance(value, (str, bytes)):
            return float(value)
    except TypeError:
        pass
    raise _hardball.Error(f"{name}: it is {value!r}; give a number")


def not_negative(value: Any, name: str) -> float:
    """Error: it is not a number, or negative or NaN."""
    number = real_number(value, name)
    if not number >= 0:
        raise _hardball.Error(f"{name}: it is {number}; give a number that is not negative")
    return number


def real_numbers(values: Any, name: str) -> list[float]:
    """Error: it is neither a number nor an array of numbers."""
    try:
        return [float(number) for number in np.asarray(values, dtype=float).ravel()]
    except (TypeError, ValueError):
        raise _hardball.Error(f"{name}: it is {values!r}; give a number, or a list of numbers") from None


def truth(value: Any, name: str) -> bool:
    """Error: it is neither True nor False."""
    if isinstance(value, (bool, np.bool_)):
        return bool(value)
    raise _hardball.Error(f"{name}: it is {value!r}; give True or False")


def text(value: Any, name: str, example: str) -> str:
    """Error: it is not a string."""
    if isinstance(value, str):
        return value
    raise _hardball.Error(f"{name}: it is {value!r}; give a text such as {example!r}")


def path_text(value: Any, name: str) -> str:
    """The name of a file as a string. Error: it is not a path."""
    try:
        return os.fsdecode(value)
    except TypeError:
        raise _hardball.Error(f"{name}: it is {value!r}; give the path of a file") from None


def list_of(kind: type[Item], values: Any, name: str) -> list[Item]:
    """Error: it is not a list of objects of this class."""
    found = list(values) if isinstance(values, Iterable) and not isinstance(values, str) else None
    if found is None or not all(isinstance(item, kind) for item in found):
        raise _hardball.Error(f"{name}: it is {values!r}; give a list of {kind.__name__}")
    return found


def species_pairs(values: Any, name: str) -> list[tuple[int, int]]:
    """Error: it is not a list of pairs of species."""
    try:
        pairs = [(operator.index(first), operator.index(second)) for first, second in values]
    except (TypeError, ValueError):
        pairs = [(-1, -1)]
    if any(not 0 <= species < 256 for pair in pairs for species in pair):
        raise _hardball.Error(f"{name}: it is {values!r}; give pairs of numbers from 0 to 255, as in [(0, 1)]")
    return pairs


def bonds_of(values: Any, name: str) -> list[tuple[int, int, int]]:
    """Error: it is not a list of two ids and the number of a potential each."""
    try:
        bonds = [(operator.index(first), operator.index(second), operator.index(kind)) for first, second, kind in values]
    except (TypeError, ValueError):
        bonds = [(-1, -1, -1)]
    if any(not 0 <= number < 2**32 for bond in bonds for number in bond):
        raise _hardball.Error(
            f"{name}: it is {values!r}; give two ids and the number of a potential for each, as in [(0, 1, 0)]"
        )
    return bonds


def engine_name(value: Any) -> str:
    """Error: it is not a string."""
    if not isinstance(value, str):
        raise _hardball.Error(f"engine: it is {value!r}; give a name such as 'auto'")
    return value


def processes_of(value: Any) -> _hardball.Processes | None:
    """Error: it is neither None nor what mpi_processes returns."""
    if value is None or isinstance(value, _hardball.Processes):
        return value
    raise _hardball.Error(f"processes: it is {value!r}; give hardball.mpi_processes()")
