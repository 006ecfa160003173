#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Turns the documentation comments of headers into constants for docstrings, so that both have the same words.

    header_documentation.py OUTPUT.hpp HEADER...

A comment of the member `run` of the class `Simulation` becomes `doc::Simulation_run`, one of a class or function
`Simulation` becomes `doc::Simulation`. Of several overloads the first counts; that of a function whose first
parameter is of the class `Robot` is also `doc::function_Robot`.
"""

import re
import sys
from pathlib import Path

CLASS = re.compile(r"^(?:class|struct|enum class) (\w+)")
MEMBER = re.compile(r"(\w+)(?: final)?(?: : [\w:]+)? ?(?:\(|;| = |\{|,|$)")
OVERLOAD = re.compile(r"(\w+)\(const (\w+)&")
TRAILING = re.compile(r"(\w+)(?: = [^;]*?| ?\{\})?[;,] +///< (.*)")


def comments_of(lines):
    """Yields (name, text) for each documented declaration."""
    outer = None
    text = []
    for line in lines:
        line = line.replace("HARDBALL_EXPORT ", "")
        stripped = line.strip()
        indentation = len(line) - len(line.lstrip())
        if stripped.startswith("/// ") or stripped == "///":
            text.append(stripped[4:])
            continue
        if indentation == 0 and (found := CLASS.match(stripped)):
            outer = None if stripped.endswith(";") else found[1]
            if text:
                yield found[1], text
        elif stripped == "};" and indentation == 0:
            outer = None
        elif trailing := TRAILING.search(stripped):
            yield f"{outer}_{trailing[1]}" if outer else trailing[1], [trailing[2]]
        elif text and not stripped.startswith("template"):
            if found := MEMBER.search(re.sub(r"^(?:explicit|static|virtual|inline|constexpr|struct) ", "", stripped)):
                yield f"{outer}_{found[1]}" if outer else found[1], text
            if not outer and (found := OVERLOAD.search(stripped)):
                yield f"{found[1]}_{found[2]}", text
        elif text:
            continue
        text = []


def paragraphs_of(lines):
    """The text with line breaks between paragraphs alone."""
    return "\n\n".join(" ".join(part.split("\n")) for part in "\n".join(lines).split("\n\n"))


def main():
    output, headers = Path(sys.argv[1]), sys.argv[2:]
    found = {}
    for header in headers:
        for name, text in comments_of(Path(header).read_text().splitlines()):
            if not name.isupper():  # macros
                found.setdefault(name, paragraphs_of(text))
    lines = ["#pragma once", "", "namespace hardball::python::doc {", ""]
    for name, text in sorted(found.items()):
        lines.append(f'inline constexpr const char* {name} = R"doc({text})doc";')
    lines += ["", "}  // namespace hardball::python::doc", ""]
    output.parent.mkdir(parents=True, exist_ok=True)
    output.write_text("\n".join(lines))


if __name__ == "__main__":
    main()
