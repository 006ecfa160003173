#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Runs every command line of the program that README.md, docs/*.md and the pages of the site show, page by page, each in
a folder with the scenarios, the files of the page that begin with their names, and, as gas.toml, its first scenario.
What a console shows must be what is printed, where "…" stands for any part of a line, or alone on a line for any lines.
Reads the scenario parts on pages other than docs/scenarios.md, which another test reads.

Usage: documented_commands_test.py PROGRAM PROJECT
"""
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

# Tested with the package in a bare system, as projects and packages of tests, or on other platforms; chromium makes a figure of the pages.
OTHERS = {"apt-get", "cc", "cd", "chromium", "cmake", "g++", "git", "make_root.sh", "man", "mpiexec", "my_game", "npm", "pip", "python3",
          "sbatch", "snakemake"}
PATIENCE = 300


def blocks_of(page, language):
    return re.findall(rf"^```{language}\n(.*?)^```", page.read_text(), re.DOTALL | re.MULTILINE)


def name_of(part):
    """The name of the file that a part shows, if its first line says it."""
    found = re.match(r"# (\w+\.toml)\n", part)
    return found and found[1]


def commands_of(page):
    """The command lines that a page shows, as lists of words; and what they print, if that is shown."""
    for language, block in re.findall(r"^```(sh|console)\n(.*?)^```", page.read_text(), re.DOTALL | re.MULTILINE):
        if language == "sh":
            for line in block.replace("\\\n", " ").splitlines():
                yield shlex.split(line, comments=True), None
        else:
            for shown in block.removeprefix("$ ").split("\n$ "):
                line, _, output = shown.partition("\n")
                yield shlex.split(line), output.rstrip()


def is_as_shown(printed, shown):
    lines = "".join(
        "(?:.*\n)*?" if line == "…" else ".*".join(map(re.escape, line.split("…"))) + "\n"
        for line in shown.splitlines()
    )
    return re.fullmatch(lines, printed.rstrip() + "\n") is not None


def view(command, folder):
    """The viewer prints its address and serves until it is interrupted."""
    with subprocess.Popen([*command, "--no-open"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as viewer:
        try:
            address = viewer.stdout.readline()
            viewer.send_signal(signal.SIGINT)
            assert viewer.wait(PATIENCE) == 0 and address.startswith("http://127.0.0.1:"), f"{command}: {address}"
        finally:
            viewer.kill()


def run_page(page, program, project):
    ran = 0
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "scenarios").symlink_to(project / "scenarios")
        for part in blocks_of(page, "toml")[:1]:
            (Path(folder) / "gas.toml").write_text(part)
        for part in blocks_of(page, "toml"):
            if name := name_of(part):
                (Path(folder) / name).write_text(part)
        for words, output in commands_of(page):
            while words and re.fullmatch(r"[A-Z]+=.*", words[0]):
                words = words[1:]
            name = Path(words[0]).name if words else ""
            if name == "hardball":
                if any(word.startswith("/usr/") for word in words):
                    continue
                if words[1] == "film" and not shutil.which("chromium"):
                    continue
                # A run that was shown before has left its files there.
                command = [program, *words[1:], *(["--overwrite"] if words[1] == "run" and "--out" in words else [])]
                print(page.name, *words, flush=True)
                if words[1] == "view":
                    view(command, folder)
                else:
                    done = subprocess.run(command, cwd=folder, check=True, timeout=PATIENCE, stdout=subprocess.PIPE, text=True)
                    assert output is None or is_as_shown(done.stdout, output), f"{command} prints\n{done.stdout}"
                ran += 1
            elif name == "dev":
                listed = subprocess.run([project / "dev", "help"], check=True, capture_output=True, text=True).stdout
                assert re.search(rf"^  {words[1]} ", listed, re.MULTILINE), f"{page}: {words}"
            else:
                assert not name or name in OTHERS, f"{page}: {words} is run nowhere"
    return ran


def check_parts(page, program, project):
    """Adds each part of a scenario to a whole one that lacks it."""
    for part in blocks_of(page, "toml"):
        if name_of(part):
            continue
        with tempfile.TemporaryDirectory() as folder:
            scenario = Path(folder) / "whole.toml"
            scenario.write_text((project / "scenarios/dense_gas.toml").read_text() + part)
            subprocess.run([program, "check", scenario], check=True, timeout=PATIENCE, stdout=subprocess.DEVNULL)


def main():
    program, project = map(Path, map(os.path.abspath, sys.argv[1:]))
    docs = project / "docs"
    pages = [project / "README.md", *sorted(docs.glob("*.md")), *sorted(docs.glob("site/*.md"))]
    ran = sum(run_page(page, program, project) for page in pages)
    assert ran > 15, "the pages show more than that"
    for page in pages:
        if page.name != "scenarios.md":
            check_parts(page, program, project)


if __name__ == "__main__":
    main()
