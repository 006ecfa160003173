#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Checks that a wheel needs nothing but the C library and is the same wherever it is built, and writes it to a folder
with the tag of the C library that it needs. auditwheel does this, too, but is not in Debian 12.

usage: audit_wheel.py WHEEL FOLDER
"""

import base64
import csv
import hashlib
import io
import re
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

LIBRARIES = re.compile(r"lib(c|m|pthread|dl|rt)\.so\.\d|ld-linux-.*\.so\.\d")
PARTS = ["hardball/_hardball.*.so", "hardball/_hardball.pyi", "hardball/__main__.py", "hardball/py.typed"]
PARTS += ["hardball/live_view.js"]
PARTS += ["hardball/scenario_files/paper.toml", "hardball/scenario_files/scenario.schema.json"]
PARTS += ["hardball-*.data/scripts/hardball", "hardball-*.dist-info/LICENSE"]


def digest(content):
    return "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


def read(wheel):
    """The files of a wheel, as pairs of ZipInfo and bytes by name."""
    with zipfile.ZipFile(wheel) as archive:
        return {entry.filename: (entry, archive.read(entry)) for entry in archive.infolist() if not entry.is_dir()}


def is_elf(content):
    return content.startswith(b"\x7fELF")


def faults_of_binary(name, content):
    """What a program or module needs and cannot have, one line of text each; and the versions of the C library that its
    symbols name, as tuples."""
    with tempfile.NamedTemporaryFile() as file:
        file.write(content)
        file.flush()
        told = subprocess.run(["objdump", "-p", "-T", file.name], check=True, capture_output=True, text=True).stdout
    faults = [f"{name} needs {needed}" for needed in re.findall(r"NEEDED +(\S+)", told) if not LIBRARIES.fullmatch(needed)]
    faults += [f"{name} has a run path" for _ in re.findall(r"\bR(?:UN)?PATH\b", told)]
    faults += [f"{name} needs {version}" for version in sorted(set(re.findall(r"\b(?:GLIBCXX|CXXABI|GCC)_[\d.]+", told)))]
    faults += [f"{name} is not stripped" for _ in re.findall(rb"\.symtab", content)]
    # As asserts do.
    sources = rb"/(?:home|root|tmp|work|build)/[\w/.+-]*\.(?:c|cc|cpp|h|hpp)\b"
    faults += [f"{name} names the source {source.decode()}" for source in sorted(set(re.findall(sources, content)))]
    return faults, [tuple(map(int, version.split("."))) for version in re.findall(r"\bGLIBC_([\d.]+)", told)]


def faults_of_files(files):
    """What is wrong with the files of a wheel, whatever they need, one line of text each."""
    for part in PARTS:
        if not any(Path(name).match(part) for name in files):
            yield f"{part} is missing"
    record = next(name for name in files if name.endswith(".dist-info/RECORD"))
    listed = {row[0]: row[1] for row in csv.reader(files[record][1].decode().splitlines())}
    for name in sorted(files.keys() ^ listed.keys()):
        yield f"{name} is not both in the wheel and in its RECORD"
    for name in files.keys() & listed.keys() - {record}:
        if listed[name] != digest(files[name][1]):
            yield f"{name} is not the file that RECORD describes"
    if len({entry.date_time for entry, _ in files.values()}) != 1:
        yield "the files have different dates: set SOURCE_DATE_EPOCH"
    for name, (entry, content) in files.items():
        if "/scripts/" in name and not entry.external_attr >> 16 & 0o111:
            yield f"{name} cannot be executed"


def write(files, path, tag):
    """Writes the files as a wheel that has the platform tag."""
    description = next(name for name in files if name.endswith(".dist-info/WHEEL"))
    record = description[: -len("WHEEL")] + "RECORD"
    entry, content = files[description]
    files[description] = entry, re.sub(rb"(?m)^(Tag: \S+-\S+-)\S+$", rb"\g<1>" + tag.encode(), content)
    lines = io.StringIO()
    rows = [(name, digest(content), len(content)) for name, (_, content) in files.items() if name != record]
    csv.writer(lines, lineterminator="\n").writerows([*rows, (record, "", "")])
    files[record] = files[record][0], lines.getvalue().encode()
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for entry, content in files.values():
            # Not as the settings of the user had it.
            entry.external_attr = (0o100755 if entry.external_attr >> 16 & 0o100 else 0o100644) << 16
            archive.writestr(entry, content)


def main():
    wheel, folder = Path(sys.argv[1]), Path(sys.argv[2])
    files = read(wheel)
    faults = list(faults_of_files(files))
    versions = []
    for name, (_, content) in files.items():
        if is_elf(content):
            found, needed = faults_of_binary(name, content)
            faults += found
            versions += needed
    if faults:
        sys.exit("\n".join(faults))
    major, minor, *_ = max(versions)
    platform = re.fullmatch(r".*-(\w+)", wheel.stem)[1]
    tag = re.sub(r"^linux", f"manylinux_{major}_{minor}", platform)
    folder.mkdir(parents=True, exist_ok=True)
    target = folder / wheel.name.replace(platform, tag)
    write(files, target, tag)
    print(target)


if __name__ == "__main__":
    main()
