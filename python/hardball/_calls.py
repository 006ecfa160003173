# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Error messages for calls with unsuitable arguments."""

from __future__ import annotations

import difflib
import functools
import inspect
import re
from typing import Any, Callable, Optional

from . import _hardball

_OPERATORS = ("__init__", "__contains__", "__getitem__")  # that take arguments of any type
_UNFIT = re.compile(r"incompatible (function|constructor) arguments")


class ArgumentError(_hardball.Error, TypeError):
    """A call with unknown arguments, or with arguments of other types."""


def explain_calls(kind: type) -> None:
    """Makes the functions of a class, in Python or C++, explain which arguments they take."""
    for name, value in list(vars(kind).items()):
        if name.startswith("_") and name not in _OPERATORS:
            continue
        title = kind.__name__ if name == "__init__" else f"{kind.__name__}.{name}"
        if isinstance(value, (staticmethod, classmethod)):
            setattr(kind, name, type(value)(_explained(value.__func__, title)))
        elif callable(value):
            setattr(kind, name, _explained(value, title))


def _explained(function: Callable[..., Any], title: str) -> Callable[..., Any]:
    names = _names_of(function)

    @functools.wraps(function)
    def call(*arguments: Any, **options: Any) -> Any:
        if names is not None:
            for name in options:
                if name not in names:
                    raise ArgumentError(f"{title}: unknown argument {name}=; {_suggestion(name, names)}")
        try:
            return function(*arguments, **options)
        except TypeError as error:
            if not _UNFIT.search(str(error)):
                raise
        raise ArgumentError(f"{title}: these arguments do not fit; it takes {_signature_of(function) or 'others'}")

    return call


def _suggestion(name: str, names: list[str]) -> str:
    near = difflib.get_close_matches(name, names, n=1)
    return f"did you mean {near[0]}=?" if near else f"it takes {', '.join(names)}"


def _names_of(function: Callable[..., Any]) -> Optional[list[str]]:
    """The names that arguments may have; None if any will do."""
    signature = _signature_of(function)
    if signature is not None:
        return re.findall(r"[(,] ?(\w+): ", signature)
    try:
        parameters = inspect.signature(function).parameters.values()
    except ValueError:  # with several overloads
        return None
    if any(parameter.kind is parameter.VAR_KEYWORD for parameter in parameters):
        return None
    return [parameter.name for parameter in parameters if parameter.name not in ("self", "cls")]


def _signature_of(function: Callable[..., Any]) -> Optional[str]:
    """The parameters of a C++ function, as in (size: float), from the first line of its docstring."""
    first, _, _ = (function.__doc__ or "").partition("\n")
    found = re.fullmatch(rf"{function.__name__}(\(.*\)) -> .*", first)
    if found is None or "*args" in first:
        return None
    return re.sub(r"self: [\w.]+(, )?", "", found[1]).replace("hardball._hardball.", "")
