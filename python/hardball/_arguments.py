# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Arguments that are single numbers."""

from __future__ import annotations

import operator
from numbers import Real
from typing import Any

from . import _hardball


def whole_number(value: Any, name: str) -> int:
    """A number of things; 1e4 is one, too. Error: it is negative, or no whole number."""
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
    """Error: it is no number."""
    try:
        if not isinstance(value, (str, bytes)):
            return float(value)
    except TypeError:
        pass
    raise _hardball.Error(f"{name}: it is {value!r}; give a number")
