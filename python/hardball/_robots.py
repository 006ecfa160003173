# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Joints of robots from URDF files."""

from __future__ import annotations

import os
import xml.etree.ElementTree as ElementTree
from typing import Any, Mapping

from ._arguments import path_text, real_number
from ._hardball import Error

_KINDS = {"revolute": "revolute", "continuous": "revolute", "prismatic": "prismatic", "fixed": "fixed"}


def read_joints(path: str | os.PathLike[str], locked: Mapping[str, float] | None = None) -> list[dict[str, Any]]:
    """The joints of a URDF file, as Robot.from_spheres takes them, in their order.

    `locked` gives joints that do not move, by their names, the coordinate that they keep, an angle or a length [L],
    as for the fingers of a gripper. Joints that mimic others must be locked. Limits and shapes are passed over.

    Error: the file is not XML; a joint is neither revolute, continuous, prismatic nor fixed; it has no parent or no
    child; a number cannot be read; a joint that mimics another is not locked; a locked joint does not exist. OSError:
    the file cannot be read.
    """
    file = path_text(path, "path")
    try:
        root = ElementTree.parse(file).getroot()
    except ElementTree.ParseError as error:
        raise Error(f"{file}:{error.position[0]}: it is not XML: {error}; give a URDF file") from None
    remaining = dict(locked or {})
    joints: list[dict[str, Any]] = []
    for element in root.iter("joint"):
        # Transmissions name joints, too.
        if "type" not in element.attrib:
            continue
        joints.append(_joint_of(element, f"{file}: joint '{element.get('name', '')}'", remaining))
    if remaining:
        raise Error(f"locked: there is no joint '{next(iter(remaining))}' that moves; give joints of {file}")
    return joints


def _joint_of(element: ElementTree.Element, where: str, locked: dict[str, float]) -> dict[str, Any]:
    kind = element.get("type", "")
    if kind not in _KINDS:
        raise Error(f"{where}: it is of the type '{kind}'; Hardball knows {', '.join(_KINDS)}")
    name = element.get("name", "")
    joint: dict[str, Any] = {"name": name, "kind": _KINDS[kind]}
    for end in ("parent", "child"):
        link = element.find(end)
        if link is None or not link.get("link"):
            raise Error(f"{where}: it has no {end}; name a link")
        joint[end] = link.get("link")
    origin = element.find("origin")
    joint["origin"] = _numbers(origin, "xyz", "0 0 0", where)
    joint["rpy"] = _numbers(origin, "rpy", "0 0 0", where)
    joint["axis"] = _numbers(element.find("axis"), "xyz", "1 0 0", where)
    if joint["kind"] == "fixed":
        return joint
    if name in locked:
        return {**joint, "locked": real_number(locked.pop(name), f"locked['{name}']")}
    if element.find("mimic") is not None:
        raise Error(f"{where}: it mimics another joint; lock it, as in locked={{'{name}': 0.0}}")
    return joint


def _numbers(element: ElementTree.Element | None, key: str, default: str, where: str) -> list[float]:
    text = default if element is None else element.get(key, default)
    try:
        numbers = [float(word) for word in text.split()]
    except ValueError:
        numbers = []
    if len(numbers) != 3:
        raise Error(f"{where}: {key} is '{text}'; give three numbers")
    return numbers
