#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Checks the #include lines of the library against hardball/floors.txt.

usage: check_floors.py PROJECT_FOLDER

A file of a room includes, by full path from the project's folder, files of its own room and of the rooms that its room
declares, which stand on strictly lower floors; nothing is declared in vain. Headers include nothing else but the
standard library, so that users need no other package. The headers beside the rooms are for users, and no room includes
them. The word "hot" after the floor is for the build.
"""

import re
from typing import NamedTuple

from checking import print_faults

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"][^>"]*[>"]|.*)')
STANDARD_HEADER = re.compile(r"[a-z_]+|(immintrin|arm_neon)\.h")
SOURCE_SUFFIXES = {".hpp", ".cpp"}


class Room(NamedTuple):
    line: int
    floor: int
    uses: list


def read_rooms(table):
    """The rooms by name, and faults of the table itself."""
    rooms, faults = {}, []
    for number, text in enumerate(table.read_text().splitlines(), start=1):
        words = text.partition("#")[0].split()
        if not words:
            continue
        name, floor, uses = words[0], words[1] if len(words) > 1 else "", words[2:]
        if not floor.isdigit():
            faults.append(f"{table}:{number}: expected: room, floor, 'hot' if it is, rooms it includes")
            continue
        if uses[:1] == ["hot"]:
            uses = uses[1:]
        if name in rooms:
            faults.append(f"{table}:{number}: '{name}' is listed twice")
        for used in uses:
            if used not in rooms:
                faults.append(f"{table}:{number}: '{name}' uses '{used}', which is not listed above it")
            elif rooms[used].floor >= int(floor):
                faults.append(f"{table}:{number}: '{name}' on floor {floor} uses '{used}' on floor {rooms[used].floor}")
        rooms[name] = Room(number, int(floor), uses)
    return rooms, faults


def read_includes(file):
    """The (line number, text with its delimiters) of each #include outside comments."""
    text = re.sub(r"/\*.*?\*/", lambda comment: "\n" * comment.group().count("\n"), file.read_text(), flags=re.DOTALL)
    for number, line in enumerate(text.splitlines(), start=1):
        if match := INCLUDE.match(line):
            yield number, match.group(1)


def check(project):
    """All faults, one line of text each."""
    library = project / "hardball"
    table = library / "floors.txt"
    rooms, faults = read_rooms(table)
    included = {name: set() for name in rooms}
    inhabited = set()

    for file in sorted(path for path in library.rglob("*") if path.is_file()):
        place = file.relative_to(library).parts
        room = place[0] if len(place) > 1 else None
        if file.suffix not in SOURCE_SUFFIXES:
            if room is not None:
                faults.append(f"{file}: a room holds only .hpp and .cpp files")
            continue
        if room is None:
            if file.suffix != ".hpp":
                faults.append(f"{file}: a file outside the rooms; only headers for users belong there")
                continue
        elif len(place) > 2:
            faults.append(f"{file}: a room has no folders")
        elif room not in rooms:
            faults.append(f"{file}: room '{room}' is missing from {table}")
            continue
        inhabited.add(room)

        for number, target in read_includes(file):
            here = f"{file}:{number}"
            if target.startswith("<") and target.endswith(">"):
                if file.suffix == ".hpp" and not STANDARD_HEADER.fullmatch(target[1:-1]):
                    faults.append(f"{here}: {target} in a header would be needed by every user; include it in a .cpp")
                continue
            parts = target.strip('"').split("/")
            if parts[0] != "hardball" or not (project / "/".join(parts)).is_file():
                faults.append(f'{here}: {target} is not the full path, "hardball/<room>/<file>", of a file')
            elif len(parts) == 2 and room is not None:
                faults.append(f"{here}: {target} is for users; include what is needed of it")
            elif room is not None and parts[1] != room and parts[1] in rooms:
                used = parts[1]
                included[room].add(used)
                if rooms[used].floor >= rooms[room].floor:
                    faults.append(
                        f"{here}: '{room}' on floor {rooms[room].floor} includes '{used}' on floor {rooms[used].floor}"
                    )
                elif used not in rooms[room].uses:
                    faults.append(f"{here}: '{room}' includes '{used}' without declaring it at {table}:{rooms[room].line}")

    for name in inhabited & rooms.keys():
        for used in sorted(set(rooms[name].uses) - included[name]):
            faults.append(f"{table}:{rooms[name].line}: '{name}' declares '{used}' but includes nothing of it")
    return faults


if __name__ == "__main__":
    print_faults(check)
