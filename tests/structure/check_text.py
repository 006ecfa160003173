#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Checks that every doc comment stands alone, and that lines of prose are short enough to read in an editor.

usage: check_text.py PROJECT_FOLDER

A doc comment is shown without its neighbors: in an editor, in the reference of the site, as a docstring. So it may not
begin with words that refer to the comment before it, nor use the word "like" with "wise" after it. This holds for the comments /// and ///< of
C++ and C, the docstrings of Python, and those that bindings give to pybind11. Lines of Markdown have at most 160 characters,
except in tables, in code, and where they hold a link.
"""

import ast
import re

from checking import files_of, print_faults

LONGEST = 160
DEPENDENT = re.compile(
    r"(The same|Of|Likewise|And|Or|Also|That of|Those of|Its|Their|They|It)\b(?! is\b)|.*\blikewise\b", re.IGNORECASE | re.DOTALL
)
COMMENT = re.compile(r"///<? ?(.*)")
STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')


def cpp_comments(text):
    """Yields (line number, text) of each doc comment."""
    number, parts, is_trailing = 0, [], False
    for k, line in enumerate([*text.splitlines(), ""], start=1):
        begins = line.strip().startswith("///")
        continues = begins and parts and (not is_trailing or line.strip().startswith("///<"))
        found = COMMENT.search(line)
        if parts and not continues:
            yield number, " ".join(parts)
            parts = []
        if found:
            if not parts:
                number, is_trailing = k, not begins or line.strip().startswith("///<")
            parts.append(found[1].strip())


def docstrings(text):
    """Yields (line number, text) of each docstring."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)):
            if said := ast.get_docstring(node):
                yield getattr(node, "lineno", 1), said


def bound_docstrings(text):
    """Yields (line number, text) of each string that begins a sentence, and does not continue the line before."""
    before = ""
    for number, line in enumerate(text.splitlines(), start=1):
        for said in STRING.findall(line):
            if re.match("[A-Z].* ", said) and not before.endswith('"'):
                yield number, said
        before = line.rstrip()


def long_lines(text):
    """Yields the numbers of the lines of prose in Markdown that are too long."""
    is_code = False
    for number, line in enumerate(text.splitlines(), start=1):
        is_formula = line.strip().startswith("$$")
        if line.strip().startswith(("```", "~~~")) or (is_formula and line.count("$$") == 1):
            is_code = not is_code
        elif not (is_code or is_formula or line.strip().startswith("|") or "](" in line) and len(line) > LONGEST:
            yield number


def check(project):
    """All faults, one line of text each."""
    for file in files_of(project):
        name = file.relative_to(project)
        if file.suffix in (".hpp", ".cpp", ".h"):
            said = list(cpp_comments(file.read_text()))
            if str(name).startswith("python/bindings/"):
                said += bound_docstrings(file.read_text())
        elif file.suffix == ".py":
            said = list(docstrings(file.read_text()))
        else:
            said = []
        for number, text in said:
            if DEPENDENT.match(text):
                yield f"{name}:{number}: a doc comment that does not stand alone: {text.splitlines()[0][:60]}"
        if file.suffix == ".md":
            for number in long_lines(file.read_text()):
                yield f"{name}:{number}: a line of prose with more than {LONGEST} characters"


if __name__ == "__main__":
    print_faults(check)
