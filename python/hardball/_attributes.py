# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Attributes that do not exist are refused when they are assigned to."""

from __future__ import annotations

import difflib
from typing import Any


def refuse_unknown_attributes(kind: type) -> None:
    """Makes objects of a class refuse values for attributes that it does not have, or that are read-only.

    Objects of subclasses may have attributes of their own.
    """
    inherited: Any = kind.__setattr__

    def assign(self: Any, name: str, value: Any) -> None:
        if type(self) is kind and not name.startswith("__") and not _can_be_assigned(kind, name):
            raise AttributeError(_message(kind, name))
        inherited(self, name, value)

    setattr(kind, "__setattr__", assign)


def _can_be_assigned(kind: type, name: str) -> bool:
    attribute = getattr(kind, name, None)
    return attribute.fset is not None if isinstance(attribute, property) else hasattr(attribute, "__set__")


def _message(kind: type, name: str) -> str:
    title = f"hardball.{kind.__name__}"
    if hasattr(kind, name):
        return f"{title}.{name} is read-only" if isinstance(getattr(kind, name), property) else f"{title}.{name} is a method"
    known = [each for each in dir(kind) if not each.startswith("_")]
    near = difflib.get_close_matches(name, known, n=1)
    remedy = f"did you mean {near[0]}?" if near else f"it has {', '.join(known)}"
    return f"{title} has no attribute {name}; {remedy}"
