# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Error messages for calls with unsuitable arguments."""

from __future__ import annotations

import difflib
import functools
import inspect
import re
from numbers import Real
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
            setattr(kind, name, type(value)(explained(value.__func__, title)))
        elif callable(value):
            setattr(kind, name, explained(value, title))


def explained(function: Callable[..., Any], title: str) -> Callable[..., Any]:
    """The function, which raises ArgumentError where its arguments do not fit."""
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
            if not _is_of_call(error, function, arguments, options):
                raise
        raise ArgumentError(f"{title}: {_what_is_wrong(function, title, arguments, options)}")

    return call


def _is_of_call(error: TypeError, function: Callable[..., Any], arguments: Any, options: Any) -> bool:
    """Whether a function did not accept its arguments, rather than failed inside."""
    return bool(_UNFIT.search(str(error)) or _binding_error(function, arguments, options))


def _binding_error(function: Callable[..., Any], arguments: Any, options: Any) -> str:
    """Why a function in Python cannot be called so; nothing if it can, or if that is not known."""
    try:
        inspect.signature(function).bind(*arguments, **options)
    except TypeError as error:
        return str(error)
    except ValueError:  # with several overloads
        pass
    return ""


def _what_is_wrong(function: Callable[..., Any], title: str, arguments: Any, options: Any) -> str:
    signature = _signature_of(function) or _signature_in_python(function)
    positional = (signature or "").partition("*")[0]
    has_self = f"{function.__name__}(self: " in (function.__doc__ or "")
    given = arguments[1:] if has_self else arguments
    numbers = [argument for argument in given if isinstance(argument, Real)]
    if "ArrayLike" in positional and len(given) > positional.count(":") and len(numbers) > 1:
        listed = f"[{', '.join(str(number) for number in numbers)}]"
        call = function.__name__ if has_self and "." in title else f"hardball.{title}"
        example = f", as in {call}({listed})" if len(numbers) == len(given) else f": {listed}"
        return f"there are {len(numbers)} numbers; give them as one list{example}"
    problem = _binding_error(function, arguments, options) or "these arguments do not fit"
    return f"{problem}; it takes {signature or 'others'}"


def _signature_in_python(function: Callable[..., Any]) -> Optional[str]:
    try:
        signature = inspect.signature(function)
    except ValueError:
        return None
    empty = inspect.Parameter.empty
    shown = [each.replace(annotation=empty) for each in signature.parameters.values() if each.name not in ("self", "cls")]
    return str(inspect.Signature(shown))


def _suggestion(name: str, names: list[str]) -> str:
    near = difflib.get_close_matches(name, names, n=1, cutoff=0.65)
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
