#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Writes the stub of the compiled module, _hardball.pyi, beside it, from the signatures in its docstrings.

    type_stub.py hardball/_hardball.SUFFIX.so

Without NumPy the module cannot be imported, and there is no stub.
"""

import importlib.util
import inspect
import re
import sys
from pathlib import Path

BEGIN = """\
# Generated from the docstrings of the compiled module.
import os
from typing import Any, Callable, Dict, List, Literal, Mapping, Optional, Sequence, Tuple, Union, overload

import numpy
import pandas
from numpy.typing import ArrayLike, NDArray

from ._typing import AnyBounce, Response, Thermostat

__version__: str
"""

# What pybind11 writes, and what type checkers understand.
TYPES = {
    r"hardball\._hardball\.": "",
    r"numpy\.ndarray\[(numpy\.)?bool\]": "NDArray[numpy.bool_]",
    r"numpy\.ndarray\[": "NDArray[",
    r"numpy\.ndarray": "NDArray[Any]",
    r"\bos\.PathLike\b": "str | os.PathLike[str]",
}
ARGUMENTS = {
    r"^self: \w+": "self",
    r"\bList\[": "Sequence[",
    r": Processes\b": ": Processes | None",
    r"= inf\b": "= ...",
    r"(\barg\d+: .*)": r"\1, /",  # those without names
}
RESULTS = {
    r"^object$": "Any",
    r"^dict$": "dict[str, Any]",
}
# Those that every object has.
OMITTED = ("__eq__", "__getstate__", "__setstate__", "__repr__")


def replaced(text, *tables):
    for table in tables:
        for old, new in table.items():
            text = re.sub(old, new, text)
    return text


def indented(lines):
    return ["    " + line for line in lines]


def body_of(text):
    return indented([repr(text.strip()) if text and text.strip() else "..."])


def function_lines(name, documentation, *decorators):
    """The declarations of all overloads; none if the docstring has no signature."""
    parts = re.split(rf"^(?:\d+\. )?{name}\((.*)\) -> (.*)$", documentation, flags=re.MULTILINE)
    overloads = list(zip(parts[1::3], parts[2::3], parts[3::3]))
    for arguments, result, text in overloads:
        yield from ["@overload"] * (len(overloads) > 1) + list(decorators)
        yield f"def {name}({replaced(arguments, TYPES, ARGUMENTS)}) -> {replaced(result, TYPES, RESULTS)}:"
        yield from body_of(text)


def property_lines(name, value):
    kind = replaced(value.fget.__doc__.partition(" -> ")[2].strip(), TYPES, RESULTS)
    if value.fset:
        return [f"{name}: {kind}", repr(value.__doc__)]
    return ["@property", f"def {name}(self) -> {kind}:", *body_of(value.__doc__)]


def member_lines(name, value):
    if name in OMITTED:
        return []
    if isinstance(value, property):
        return property_lines(name, value)
    if isinstance(value, staticmethod):
        return function_lines(name, value.__func__.__doc__, "@staticmethod")
    return function_lines(name, value.__doc__ or "")


def class_lines(name, kind):
    bases = [base.__name__ for base in kind.__bases__ if base.__name__ != "pybind11_object"]
    yield f"class {name}({', '.join(bases)}):".replace("()", "")
    yield from body_of(kind.__doc__)
    for member, value in vars(kind).items():
        yield from indented(member_lines(member, value))


def stub_of(module):
    lines = []
    for name, entity in vars(module).items():
        if inspect.isclass(entity):
            lines += ["", *class_lines(name, entity)]
        elif inspect.isbuiltin(entity):
            lines += ["", *function_lines(name, entity.__doc__)]
    return BEGIN + "\n".join(lines) + "\n"


def main():
    library = Path(sys.argv[1])
    stub = library.with_name("_hardball.pyi")
    stub.unlink(missing_ok=True)
    specification = importlib.util.spec_from_file_location("hardball._hardball", library)
    try:
        module = importlib.util.module_from_spec(specification)
    except ImportError as error:
        print(f"the package has no stub for type checkers, as its module cannot be imported: {error.__cause__ or error}")
        return
    stub.write_text(stub_of(module))


if __name__ == "__main__":
    main()
