# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Scenarios as dicts, and those that come with the package."""

from __future__ import annotations

import json
import os
from numbers import Integral, Real
from pathlib import Path
from typing import Any, Mapping

import numpy as np

from . import _hardball


def scenarios() -> Path:
    """The folder of the scenarios that come with the package, such as paper.toml, and their schema for editors,
    scenario.schema.json."""
    return Path(__file__).parent / "scenario_files"


def scenario_text(scenario: Mapping[str, Any]) -> str:
    """A scenario as the text of a file. Error: TOML has no such value."""
    return "".join(f"{key} = {toml_of(value)}\n" for key, value in scenario.items())


def changes_of(overrides: Mapping[str, Any] | None) -> list[str]:
    """Overrides as the command line takes them. Error: they are not a dict; TOML has no such value."""
    if overrides is not None and not isinstance(overrides, Mapping):
        raise _hardball.Error("overrides: it is not a dict; give one such as {'run.seed': 7}")
    return [f"{key}={toml_of(value)}" for key, value in (overrides or {}).items()]


def toml_of(value: Any) -> str:
    """A value in TOML, on one line. Error: TOML has no such value."""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, Integral):
        return str(int(value))
    if isinstance(value, Real):
        # 1e+30 and inf are numbers in TOML, too.
        return repr(float(value))
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{json.dumps(str(key))} = {toml_of(item)}" for key, item in value.items()) + "}"
    if isinstance(value, np.ndarray) and value.ndim == 0:
        return toml_of(value.item())
    if isinstance(value, (list, tuple, np.ndarray)):
        return "[" + ", ".join(toml_of(item) for item in value) + "]"
    raise _hardball.Error(
        f"a scenario has no value such as {value!r}: give a number, a string, a list or a dict"
    )
