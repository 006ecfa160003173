#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Runs the study of docs/sweeps.md by what clusters have, with the files and commands that the page shows: the tables must
be those of the program, byte for byte, after a part of the members was killed, too.

Usage: engines_test.py PROGRAM PROJECT ENGINE, one of processes, mpi, dask, snakemake and slurm. Ends with 77 if that is
not installed.
"""
import importlib.util
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from one_node_slurm import one_node_slurm, why_not

PATIENCE = 300
TABLES = ("runs.csv", "points.csv")


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


def require(engine):
    if engine == "slurm" and why_not():
        skip(why_not())
    if engine == "snakemake" and not shutil.which("snakemake"):
        skip("snakemake is not installed")
    module = {"mpi": "mpi4py", "dask": "distributed"}.get(engine)
    if module and not importlib.util.find_spec(module):
        skip(f"{module} is not installed")
    if engine == "mpi" and not shutil.which("mpiexec"):
        skip("mpiexec is not installed")
    if engine in ("processes", "mpi", "dask") and not importlib.util.find_spec("hardball"):
        skip("the Python package is not built")


def write_files(page, folder):
    """The files that the page shows, each of which it names."""
    for name, text in re.findall(r"^```toml\n# (\w+\.toml)\n(.*?)^```", page, re.DOTALL | re.MULTILINE):
        (folder / name).write_text(text)
    for name in ("array.sh", "Snakefile", "pools.py"):
        (folder / name).write_text(re.search(rf"`{name}`:\n\n```\w+\n(.*?)^```", page, re.DOTALL | re.MULTILINE)[1])


def command_of(page, engine):
    """The command of the page that runs the study by an engine."""
    beginning = {
        "processes": "python3 pools.py processes",
        "dask": "python3 pools.py dask",
        "mpi": "mpiexec -n 3",
        "snakemake": "snakemake --cores 2",
        "slurm": "sbatch --wait",
    }[engine]
    return re.search(rf"^{re.escape(beginning)}.*$", page, re.MULTILINE)[0].split()


def run(command, folder, environment):
    if command[0] == "mpiexec":
        allowed = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        environment = {**environment, **allowed, "OMPI_MCA_rmaps_base_oversubscribe": "1"}
    command = [sys.executable if word == "python3" else word for word in command]
    done = subprocess.run(command, cwd=folder, env=environment, timeout=PATIENCE, capture_output=True, text=True)
    logs = "".join(path.read_text() for path in folder.glob("slurm-*.out"))
    assert done.returncode == 0, f"{command} ends with {done.returncode}: {done.stdout}{done.stderr}{logs}"


def kill_in_the_middle(folder, environment):
    """Leaves members that have finished, and some that have not, as a crash of the machine does."""
    sweep = subprocess.Popen(["hardball", "sweep", "study.toml", "--quiet"], cwd=folder, env=environment)
    deadline = time.monotonic() + PATIENCE
    while len(list(folder.glob("study/*/summary.json"))) < 3 and time.monotonic() < deadline:
        time.sleep(0.001)
    sweep.send_signal(signal.SIGKILL)
    sweep.wait()


def main():
    program, project, engine = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), sys.argv[3]
    require(engine)
    page = (project / "docs/sweeps.md").read_text()
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "work"
        folder.mkdir()
        write_files(page, folder)
        environment = {**os.environ, "PATH": f"{program.parent}{os.pathsep}{os.environ['PATH']}", "HOME": temporary}
        whole = ["hardball", "sweep", "study.toml", "--out", "whole", "--workers", "1", "--quiet"]
        run(whole, folder, environment)
        kill_in_the_middle(folder, environment)
        assert not (folder / "study/points.csv").exists()
        command = command_of(page, engine)
        if engine == "slurm":
            cluster = Path(temporary) / "slurm"
            cluster.mkdir()
            with one_node_slurm(cluster) as reached:
                run(command, folder, {**reached, "PATH": f"{program.parent}{os.pathsep}{reached['PATH']}"})
            run(["hardball", "sweep", "study.toml", "--table", "--quiet"], folder, environment)
        else:
            run(command, folder, environment)
        for name in TABLES:
            assert (folder / "study" / name).read_bytes() == (folder / "whole" / name).read_bytes(), name
        assert len((folder / "study/runs.csv").read_text().splitlines()) == 65
        print(f"{engine}: the tables of 64 members are those of the program")


if __name__ == "__main__":
    main()
