# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Has LAMMPS read data files of the program and go on with them, and reads back what LAMMPS writes.

usage: check_lammps.py PROGRAM

Skipped where there is no LAMMPS: lmp, of the package lammps.
"""
import csv
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

MIXTURE = """
[box]
size = [10.0, 8.0, 9.0]
boundary = ["periodic", "periodic", "periodic"]
[[spheres]]
count = 50
radius = 0.5
mass = 3.0
placement = "random"
mean_speed = 1.0
[[spheres]]
count = 20
radius = 0.25
placement = "random"
mean_speed = 1.0
"""

SCENARIOS = {
    "mixture": MIXTURE,
    "discs": MIXTURE.replace("[box]", "[box]\ndimensions = 2").replace(", 9.0]", "]").replace(', "periodic"]', "]"),
    "walls": MIXTURE.replace('"periodic", "periodic", "periodic"', '"periodic", "wall", "wall"'),
}

OUTPUT = "[run]\nuntil = 2\n[output]\nsnapshots_every = 1\n"

INPUT = """
units lj
dimension {dimensions}
atom_style sphere
boundary {boundary}
read_data start.data
pair_style gran/hooke/history 2000.0 NULL 0.0 NULL 0.5 1
pair_coeff * *
comm_modify vel yes
fix 1 all nve/sphere
{flat}
timestep 0.00001
dump scaled all custom 1000 scaled.lammpstrj id type xs ys zs vx vy vz radius mass
dump unfolded all custom 1000 unfolded.0.lammpstrj id type type xu yu zu ix iy iz vx vy vz diameter mass
dump_modify scaled format float %.17g
dump_modify unfolded format float %.17g
run 1000
write_data end.data
"""

COLUMNS = ["type", "x", "y", "z", "vx", "vy", "vz", "radius", "mass"]


def spheres_of(program, path, *more):
    """The columns of the spheres of a frame, by id."""
    table = path.parent / "table.csv"
    subprocess.run([program, "convert", path, table, "--overwrite", *more], check=True, stdout=subprocess.DEVNULL)
    with open(table) as file:
        return {int(row["id"]): {name: float(row[name]) for name in COLUMNS} for row in csv.DictReader(file)}


def expect_near(found, expected, size, tolerance, what):
    assert found.keys() == expected.keys(), what
    for number, sphere in expected.items():
        for name, value in sphere.items():
            difference = found[number][name] - value
            if name in size:
                difference = math.remainder(difference, size[name])
            assert abs(difference) <= tolerance * max(1, abs(value)), (what, number, name, found[number][name], value)


def check(program, name, scenario, folder):
    (folder / "scenario.toml").write_text(scenario + OUTPUT)
    subprocess.run([program, "run", folder / "scenario.toml", "--out", folder / "out", "--quiet"], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run([program, "convert", folder / "out" / "trajectory.xyz", folder / "start.data"], check=True,
                   stdout=subprocess.DEVNULL)
    is_flat = name == "discs"
    text = INPUT.format(dimensions=2 if is_flat else 3, boundary="p f f" if name == "walls" else "p p p",
                        flat="fix 2 all enforce2d" if is_flat else "")
    (folder / "in.lammps").write_text(text)
    subprocess.run(["lmp", "-in", "in.lammps"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    # Ids count from one in data files.
    start = {number + 1: sphere for number, sphere in spheres_of(program, folder / "out" / "trajectory.xyz").items()}
    assert {sphere["type"] for sphere in start.values()} == {1, 2}
    size = {"x": 10, "y": 8, "z": 9}
    # Scaling by the box and back rounds some times.
    expect_near(spheres_of(program, folder / "scaled.lammpstrj", "--frame", "0"), start, size, 1e-13, "scaled")
    expect_near(spheres_of(program, folder / "unfolded.0.lammpstrj", "--frame", "0"), start, size, 1e-13, "unfolded")
    end = spheres_of(program, folder / "scaled.lammpstrj")
    moved = [number for number, sphere in end.items() if sphere["x"] != start[number]["x"]]
    assert len(moved) == len(start), "LAMMPS has gone on with all"
    expect_near(spheres_of(program, folder / "unfolded.0.lammpstrj"), end, size, 1e-13, "the end of both dumps")
    expect_near(spheres_of(program, folder / "end.data"), end, size, 1e-13, "write_data")
    print(f"{name}: LAMMPS: positions, velocities, types, radii, masses, there and back")


def main():
    if not shutil.which("lmp"):
        print("skipped: there is no lmp")
        sys.exit(77)
    program = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        for name, scenario in SCENARIOS.items():
            (pathlib.Path(folder) / name).mkdir()
            check(program, name, scenario, pathlib.Path(folder) / name)


main()
