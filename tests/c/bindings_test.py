#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Runs the bindings that docs/c.md shows, that of Rust where there is a compiler, and compares what they do.

usage: bindings_test.py LIBRARY PROJECT_FOLDER
"""

import ctypes
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SCENARIO = """
[box]
size = [8, 8, 8]
boundary = ["wall", "wall", "periodic"]
[[spheres]]
count = 20
radius = 0.5
placement = "random"
temperature = 1
"""
USE_OF_RUST = """
fn main() -> Result<(), String> {
    let scenario = std::env::args().nth(1).unwrap();
    let mut simulation = Simulation::start(&scenario)?;
    simulation.run_until(3.0)?;
    for [x, y, z] in simulation.positions()? {
        println!("{x:?} {y:?} {z:?}");
    }
    let refused = Simulation::start("[box]").err().unwrap();
    eprintln!("{refused}");
    Ok(())
}
"""


def positions_by_ctypes(text, library):
    """The positions that the binding in Python reads, after a look at its errors."""
    names = {}
    ctypes.CDLL(library)  # the loader then finds it by its name
    exec(compile(text, "docs/c.md", "exec"), names)
    simulation = names["Simulation"](SCENARIO)
    simulation.run_until(3)
    for refused in (lambda: names["Simulation"]("[box]"), lambda: simulation.run_until(1)):
        try:
            refused()
        except ValueError as error:
            assert "; " in str(error), error
        else:
            sys.exit("what is wrong was not refused")
    return [tuple(row) for row in simulation.positions()]


def positions_by_rust(text, library):
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "binding.rs"
        source.write_text(text + USE_OF_RUST)
        link = ["-L", Path(library).parent, "-C", f"link-arg=-Wl,-rpath,{Path(library).parent}"]
        subprocess.run(["rustc", "--edition", "2021", "-D", "warnings", *link, source, "-o", f"{folder}/binding"], check=True)
        done = subprocess.run([f"{folder}/binding", SCENARIO], check=True, capture_output=True, text=True)
    assert "scenario:1:1" in done.stderr, done.stderr
    return [tuple(map(float, line.split())) for line in done.stdout.splitlines()]


def main():
    library, project = os.path.abspath(sys.argv[1]), Path(sys.argv[2])
    page = (project / "docs/c.md").read_text()
    shown = {language: re.search(rf"^```{language}\n(.*?)^```", page, re.DOTALL | re.MULTILINE)[1] for language in ("python", "rust")}
    positions = positions_by_ctypes(shown["python"], library)
    assert len(positions) == 20 and len(set(positions)) == 20, positions
    if shutil.which("rustc"):
        assert positions_by_rust(shown["rust"], library) == positions
    else:
        print("that of Rust was not compiled: there is no rustc")
    return 0


if __name__ == "__main__":
    sys.exit(main())
