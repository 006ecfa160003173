# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Opens every file that the program writes with the readers that users have, and compares what they find.

usage: check_files.py PROGRAM

What is true is read from trajectory.xyz, digit by digit, with nothing but Python. Each check says which fields were
compared; one that differs ends the script. Readers: ASE, gsd, MDAnalysis, VTK, NumPy and the zstd tool.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import warnings
import xml.etree.ElementTree

warnings.simplefilter("ignore")
try:
    import ase.calculators.lammps
    import ase.io
    import gsd.fl
    import gsd.hoomd
    import MDAnalysis
    import numpy
    import vtkmodules.vtkIOXML
    from vtkmodules.util.numpy_support import vtk_to_numpy
except ImportError as missing:
    print("skipped:", missing)
    sys.exit(77)

FORMATS = ["xyz", "xyz.zst", "gsd", "lammps", "vtp"]

OUTPUT = '[run]\nuntil = 3\n[output]\nsnapshots_every = 0.5\ntrajectory = ' + json.dumps(FORMATS) + "\n"

SCENARIOS = {
    # Species, masses, spins from the first contact on, periodic axes and walls.
    "mixture": """
[box]
size = [10.0, 8.0, 9.0]
boundary = ["periodic", "wall", "periodic"]
[[species]]
name = "glass"
[[species]]
name = "steel"
[[spheres]]
count = 200
radius = {distribution = "uniform", min = 0.2, max = 0.4}
placement = "random"
mean_speed = 3.0
[[spheres]]
count = 5
radius = 0.4
mass = 2.5
species = "steel"
placement = "random"
mean_speed = 1.0
[response]
restitution = 0.9
tangential_restitution = 0.5
""",
    "cloud": """
[box]
boundary = ["open", "open", "open"]
[[spheres]]
count = 50
radius = 0.5
placement = "random"
mean_speed = 1.0
""",
    "discs": """
[box]
dimensions = 2
size = [20.0, 15.0]
boundary = ["periodic", "wall"]
[[spheres]]
count = 60
radius = 0.5
placement = "random"
mean_speed = 2.0
""",
    # Two chains of three discs, which a face of the box cuts.
    "chains": """
[box]
dimensions = 2
size = [10.0, 8.0]
boundary = ["periodic", "wall"]
[[spheres]]
count = 6
radius = 0.5
mean_speed = 1.0
positions = [[9.2, 3.0], [0.3, 3.0], [1.4, 3.0], [9.2, 5.0], [0.3, 5.0], [1.4, 5.0]]
[[bonds]]
chain = [0, 5]
beads = 3
core = 0.9
longest = 1.3
""",
    # The number of spheres falls, and ids have gaps.
    "drops": """
[box]
size = [10.0, 10.0, 10.0]
boundary = ["periodic", "periodic", "periodic"]
[[spheres]]
count = 100
radius = 0.4
placement = "random"
mean_speed = 2.0
[response]
kind = "merge"
""",
}


class Frame:
    """What is true of a frame of trajectory.xyz."""

    def __init__(self, comment, rows):
        self.rows = [row.split() for row in rows]
        self.comment = comment
        columns = comment.split("Properties=")[1].split(":")
        self.columns = {}
        at = 0
        for name, width in zip(columns[0::3], map(int, columns[2::3])):
            self.columns[name] = slice(at, at + width)
            at += width
        self.time = float(comment.split("Time=")[1].split()[0])
        lattice = [float(x) for x in comment.split('Lattice="')[1].split('"')[0].split()]
        self.size = numpy.array(lattice[::4])
        origin = comment.split('Origin="')[1].split('"')[0].split() if "Origin=" in comment else "000"
        self.origin = numpy.array([float(x) for x in origin])
        self.pbc = [axis == "T" for axis in comment.split('pbc="')[1].split('"')[0].split()]
        self.is_flat = "dimensions=2" in comment

    def __len__(self):
        return len(self.rows)

    def has(self, name):
        return name in self.columns

    def __getitem__(self, name):
        values = numpy.array([[float(x) for x in row[self.columns[name]]] for row in self.rows])
        return values[:, 0] if values.shape[1] == 1 else values


def frames_of(text):
    lines = text.splitlines()
    frames = []
    at = 0
    while at < len(lines):
        count = int(lines[at])
        frames.append(Frame(lines[at + 1], lines[at + 2 : at + 2 + count]))
        at += 2 + count
    return frames


def same(found, expected, what):
    """Equal to the last bit."""
    found = numpy.asarray(found, dtype=float)
    if found.shape != numpy.shape(expected) or not (found == expected).all():
        raise SystemExit(f"FAILED: {what}: {found} instead of {expected}")


def single(found, expected, what):
    """Equal as far as single precision goes."""
    same(found, numpy.asarray(expected, dtype=numpy.float32), what)


def near(found, expected, what):
    if not numpy.allclose(found, expected, rtol=1e-6, atol=1e-5):
        raise SystemExit(f"FAILED: {what}: {found} instead of {expected}")


def centered(frame):
    """The centers in single precision, as GSD wants them: in a box around the origin."""
    position = (frame["pos"] - (frame.origin + frame.size / 2)).astype(numpy.float32)
    half = (frame.size.astype(numpy.float32) / 2).astype(numpy.float32)
    for axis in range(3):
        if frame.pbc[axis]:
            position[:, axis] = numpy.clip(position[:, axis], -half[axis], numpy.nextafter(half[axis], numpy.float32(0)))
    return position


def check_ase_xyz(path, frames):
    read = ase.io.read(path, index=":")
    assert len(read) == len(frames)
    for atoms, frame in zip(read, frames):
        same(atoms.positions, frame["pos"], "ASE xyz positions")
        for name in ["velo", "radius", "mass", "id", "type", "map_shift"]:
            same(atoms.arrays[name], frame[name], "ASE xyz " + name)
        for name in ["angular_velocity", "moment"]:
            if frame.has(name):
                same(atoms.arrays[name], frame[name], "ASE xyz " + name)
        same(atoms.get_masses(), numpy.minimum(frame["mass"], 1e60), "ASE xyz masses")
        # Rounded twice: as momenta, and by ASE.
        if not numpy.allclose(atoms.get_velocities(), frame["velo"], rtol=2**-52, atol=0):
            raise SystemExit("FAILED: ASE xyz velocities")
        same(atoms.cell.lengths(), frame.size, "ASE xyz cell")
        assert atoms.pbc.tolist() == frame.pbc
        assert float(atoms.info["Time"]) == frame.time
    return "positions, velocities, masses, cell, pbc, Time, and all columns as arrays"


def check_ase_lammps(path, frames):
    read = ase.io.read(path, index=":", format="lammps-dump-text")
    assert len(read) == len(frames)
    unit = ase.calculators.lammps.convert(1.0, "velocity", "metal", "ASE")
    for atoms, frame in zip(read, frames):
        near(atoms.positions, frame["pos"], "ASE dump positions")
        near(atoms.get_velocities() / unit, frame["velo"], "ASE dump velocities")
        near(atoms.cell.lengths(), frame.size, "ASE dump cell")
        assert atoms.pbc.tolist() == frame.pbc
    return "positions, velocities (in the order of ids), cell, pbc"


# By scenario; none in the others.
BONDS = {"chains": [[0, 1], [1, 2], [3, 4], [4, 5]]}


def check_gsd(path, frames, bonds):
    with gsd.fl.open(str(path), "rb") as file:
        assert file.schema == "hoomd" and file.schema_version == (1, 4) and file.nframes == len(frames)
    with gsd.hoomd.open(str(path), "rb") as trajectory:
        assert len(trajectory) == len(frames)
        # Backwards, so that no frame depends on what was read before.
        for number in reversed(range(len(frames))):
            read, frame = trajectory[number], frames[number]
            read.validate()
            particles, log = read.particles, read.log
            assert read.configuration.step == number and particles.N == len(frame)
            assert read.configuration.dimensions == (2 if frame.is_flat else 3)
            size = frame.size * [1, 1, 0] if frame.is_flat else frame.size
            single(read.configuration.box, list(size) + [0, 0, 0], "gsd box")
            same(particles.position, centered(frame), "gsd position")
            single(particles.velocity, frame["velo"], "gsd velocity")
            single(particles.diameter, 2 * frame["radius"], "gsd diameter")
            single(particles.mass, frame["mass"], "gsd mass")
            same(particles.typeid, frame["type"] - 1, "gsd typeid")
            same(particles.image, frame["map_shift"], "gsd image")
            assert read.bonds.N == len(bonds) and numpy.array_equal(read.bonds.group, numpy.reshape(bonds, (-1, 2)))
            same(log["time"], [frame.time], "gsd log/time")
            same(log["pbc"], frame.pbc, "gsd log/pbc")
            same(log["box/origin"], frame.origin, "gsd log/box/origin")
            same(log["box/size"], frame.size, "gsd log/box/size")
            for name, column in [("position64", "pos"), ("velocity64", "velo"), ("radius64", "radius"),
                                 ("mass64", "mass"), ("id", "id"), ("angular_velocity64", "angular_velocity"),
                                 ("moment64", "moment")]:
                if frame.has(column):
                    same(log["particles/" + name], frame[column], "gsd log/particles/" + name)
    return "every chunk of the schema in single precision, every one under log/ exactly"


def check_mdanalysis(folder, frames):
    if len({len(frame) for frame in frames}) > 1:
        return "skipped: it needs the same number of spheres in all frames"
    universe = MDAnalysis.Universe(str(folder / "trajectory.gsd"))
    single(universe.atoms.masses, frames[0]["mass"], "MDAnalysis gsd masses")
    near(universe.atoms.radii, frames[0]["radius"], "MDAnalysis gsd radii")
    assert len(universe.trajectory) == len(frames)
    for step, frame in zip(universe.trajectory, frames):
        near(step.positions, centered(frame), "MDAnalysis gsd positions")
        near(step.dimensions[:2], frame.size[:2], "MDAnalysis gsd dimensions")
    dump = str(folder / "trajectory.lammpstrj")
    universe = MDAnalysis.Universe(dump, format="LAMMPSDUMP", topology_format="LAMMPSDUMP")
    same(universe.atoms.ids, frames[0]["id"], "MDAnalysis dump ids")
    assert len(universe.trajectory) == len(frames)
    both = MDAnalysis.Universe(str(folder / "trajectory.gsd"), dump, format="LAMMPSDUMP")
    single(both.atoms.masses, frames[0]["mass"], "MDAnalysis gsd and dump masses")
    for step, step_of_both, frame in zip(universe.trajectory, both.trajectory, frames):
        near(step.positions, frame["pos"] - frame.origin, "MDAnalysis dump positions")
        near(step.velocities, frame["velo"], "MDAnalysis dump velocities")
        near(step.dimensions[:3], frame.size, "MDAnalysis dump dimensions")
        same(step_of_both.positions, step.positions, "MDAnalysis gsd and dump positions")
        same(step_of_both.velocities, step.velocities, "MDAnalysis gsd and dump velocities")
    universe = MDAnalysis.Universe(str(folder / "trajectory.xyz"))
    assert len(universe.trajectory) == len(frames)
    for step, frame in zip(universe.trajectory, frames):
        near(step.positions, frame["pos"], "MDAnalysis xyz positions")
    return ("gsd: positions, masses, radii, dimensions; dump: positions, velocities, dimensions, ids; "
            "gsd and dump together: all of these; xyz: positions")


def check_vtk(path, frames):
    entries = list(xml.etree.ElementTree.parse(path).getroot().iter("DataSet"))
    assert len(entries) == len(frames)
    for entry, frame in zip(entries, frames):
        assert float(entry.get("timestep")) == frame.time
        reader = vtkmodules.vtkIOXML.vtkXMLPolyDataReader()
        reader.SetFileName(str(path.parent / entry.get("file")))
        reader.Update()
        data = reader.GetOutput()
        assert data.GetNumberOfPoints() == data.GetNumberOfVerts() == len(frame)
        same(vtk_to_numpy(data.GetVerts().GetConnectivityArray()), numpy.arange(len(frame)), "VTK vertices")
        same(vtk_to_numpy(data.GetVerts().GetOffsetsArray()), numpy.arange(len(frame) + 1), "VTK offsets")
        assert data.GetFieldData().GetArray("TimeValue").GetValue(0) == frame.time
        same(vtk_to_numpy(data.GetPoints().GetData()), frame["pos"], "VTK points")
        for name, column in [("velocity", "velo"), ("radius", "radius"), ("mass", "mass"), ("id", "id"), ("type", "type"),
                             ("image", "map_shift"), ("angular_velocity", "angular_velocity"), ("moment", "moment")]:
            if frame.has(column):
                same(vtk_to_numpy(data.GetPointData().GetArray(name)), frame[column], "VTK " + name)
    return "points, velocity, radius, mass, id, type, image, angular_velocity, moment, times"


def check_numpy(program, folder, frames):
    last = frames[-1]
    names = {"vx": ("velo", 0), "vy": ("velo", 1), "vz": ("velo", 2), "x": ("pos", 0), "y": ("pos", 1), "z": ("pos", 2),
             "ix": ("map_shift", 0), "iy": ("map_shift", 1), "iz": ("map_shift", 2), "radius": ("radius", None),
             "mass": ("mass", None), "id": ("id", None), "type": ("type", None)}
    for ending in ["npy", "csv"]:
        path = folder / ("last." + ending)
        subprocess.run([program, "convert", folder / "trajectory.gsd", path], check=True, stdout=subprocess.DEVNULL)
        if ending == "npy":
            read = numpy.load(path)
        else:
            read = numpy.genfromtxt(path, delimiter=",", names=True)
        for name, (column, axis) in names.items():
            same(read[name], last[column] if axis is None else last[column][:, axis], ending + " " + name)
    return "every field of .npy and .csv, exactly"


def check(program, name, scenario, folder):
    (folder / "scenario.toml").write_text(scenario + OUTPUT)
    out = folder / "out"
    subprocess.run([program, "run", folder / "scenario.toml", "--out", out, "--quiet"], check=True,
                   stdout=subprocess.DEVNULL)
    text = (out / "trajectory.xyz").read_text()
    frames = frames_of(text)
    assert len(frames) == 7 and frames[-1].time == 3
    expanded = subprocess.run(["zstd", "-dc", out / "trajectory.xyz.zst"], check=True, capture_output=True).stdout
    assert expanded.decode() == text
    results = {
        "zstd": "the same text",
        "ASE, xyz": check_ase_xyz(out / "trajectory.xyz", frames),
        "ASE, dump": check_ase_lammps(out / "trajectory.lammpstrj", frames),
        "gsd": check_gsd(out / "trajectory.gsd", frames, BONDS.get(name, [])),
        "MDAnalysis": check_mdanalysis(out, frames),
        "VTK": check_vtk(out / "trajectory.pvd", frames),
        "NumPy": check_numpy(program, out, frames),
    }
    for reader, fields in results.items():
        print(f"{name}: {reader}: {fields}")


def write_with_gsd(path):
    """A start state by another program: single precision, a box around the origin."""
    frame = gsd.hoomd.Snapshot()
    frame.particles.N = 2
    frame.particles.position = [[-4, 0, 0], [4, 0.5, 0]]
    frame.particles.velocity = [[1, 0, 0], [0, 0, 0]]
    frame.particles.diameter = [1, 0.5]
    frame.configuration.box = [10, 10, 10, 0, 0, 0]
    with gsd.hoomd.open(str(path), "wb") as file:
        file.append(frame)


def check_start(program, folder):
    """Files that other programs write are read as they mean them."""
    write_with_gsd(folder / "start.gsd")
    numpy.save(folder / "start.npy", numpy.array([[1, 5, 5, 1, 0, 0, 0.5], [9, 5.5, 5, 0, 0, 0, 0.25]]))
    record = [("position", "f4", 3), ("velocity", "<f8", (3,)), ("diameter", "f8"), ("name", "u1")]
    numpy.save(folder / "fields.npy", numpy.array([((1, 5, 5), (1, 0, 0), 1, 7), ((9, 5.5, 5), (0, 0, 0), 0.5, 8)], dtype=record))
    ase_atoms = ase.Atoms("X2", positions=[[1, 5, 5], [9, 5.5, 5]], cell=[10, 10, 10], pbc=True)
    ase_atoms.arrays["velo"] = numpy.array([[1.0, 0, 0], [0, 0, 0]])
    ase_atoms.arrays["radius"] = numpy.array([0.5, 0.25])
    ase.io.write(folder / "start.xyz", ase_atoms, format="extxyz")
    del ase_atoms.arrays["velo"]
    ase_atoms.set_masses([1, 1])
    ase_atoms.set_velocities([[1.0, 0, 0], [0, 0, 0]])
    ase.io.write(folder / "momenta.xyz", ase_atoms, format="extxyz")
    expected = None
    for name in ["start.gsd", "start.npy", "fields.npy", "start.xyz", "momenta.xyz"]:
        out = folder / (name + ".csv")
        subprocess.run([program, "convert", folder / name, out], check=True, stdout=subprocess.DEVNULL)
        read = numpy.genfromtxt(out, delimiter=",", names=True)
        found = [read[column].tolist() for column in ["x", "y", "z", "vx", "vy", "vz", "radius", "mass"]]
        expected = expected or [[1, 9], [5, 5.5], [5, 5], [1, 0], [0, 0], [0, 0], [0.5, 0.25], [1, 1]]
        assert found == expected, (name, found)
        print(f"start states: {name}: positions, velocities, radii, masses")


def check_kinematic(program, folder):
    """ASE, which knows no infinite mass, has the velocities of spheres that no collision deflects, too."""
    (folder / "kinematic.csv").write_text("x,y,z,vx,vy,vz,radius,mass\n1,2,3,0.1,-0.2,0,0.5,inf\n4,5,6,0.3,0,0,0.5,2\n")
    subprocess.run([program, "convert", folder / "kinematic.csv", folder / "kinematic.xyz"], check=True,
                   stdout=subprocess.DEVNULL)
    atoms = ase.io.read(folder / "kinematic.xyz")
    same(atoms.arrays["mass"], [numpy.inf, 2], "ASE xyz mass")
    same(atoms.get_masses(), [1e60, 2], "ASE xyz masses")
    near(atoms.get_velocities(), [[0.1, -0.2, 0], [0.3, 0, 0]], "ASE xyz velocities")
    print("kinematic: ASE, xyz: velocities, masses")


def check_face_forces(program, folder):
    """The forces on the triangles of a mesh add up to the force on it, and lie where it is at the end."""
    (folder / "faces.toml").write_text('''
[box]
size = [6.0, 6.0, 6.0]
boundary = ["open", "open", "open"]
[[walls]]
shape = "box"
size = [4.0, 3.0, 2.0]
point = [1.0, 2.0, 3.0]
velocity = [0.0, 0.0, 0.1]
spheres = "inside"
[[spheres]]
count = 20
radius = 0.2
placement = "random"
mean_speed = 1.0
[measures]
names = ["wall_forces"]
face_forces = true
[run]
until = 20
''')
    out = folder / "faces"
    subprocess.run([program, "run", folder / "faces.toml", "--out", out, "--quiet"], check=True, stdout=subprocess.DEVNULL)
    reader = vtkmodules.vtkIOXML.vtkXMLPolyDataReader()
    reader.SetFileName(str(out / "measures" / "mesh_0_face_forces.vtp"))
    reader.Update()
    data = reader.GetOutput()
    assert data.GetNumberOfPoints() == 8 and data.GetNumberOfPolys() == data.GetNumberOfCells() == 12
    force, pressure, contacts, group = (
        vtk_to_numpy(data.GetCellData().GetArray(name)) for name in ["force", "pressure", "contacts", "group"])
    near([data.GetBounds()], [[-1, 3, 0.5, 3.5, 4, 6]], "VTK bounds")
    corners = vtk_to_numpy(data.GetPoints().GetData())[vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
    wall = json.loads((out / "summary.json").read_text())["walls"][0]
    near(force.sum(axis=0), numpy.array(wall["impulse"]) / 20, "VTK force")
    near(force, pressure[:, None] * normals, "VTK pressure")
    assert contacts.sum() == wall["contacts"] > 100 and not group.any()
    print("faces: VTK: points, triangles, force, pressure, contacts, group")


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        for name, scenario in SCENARIOS.items():
            (pathlib.Path(folder) / name).mkdir()
            check(program, name, scenario, pathlib.Path(folder) / name)
        check_start(program, pathlib.Path(folder))
        check_kinematic(program, pathlib.Path(folder))
        check_face_forces(program, pathlib.Path(folder))


main()
