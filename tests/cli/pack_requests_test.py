#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Packs spheres as requests ask for, and finds what the program prints in the files that it writes.

Usage: pack_requests_test.py PROGRAM
"""
import json
import math
import subprocess
import sys
import tempfile
from decimal import Decimal, localcontext
from itertools import product
from pathlib import Path

REQUESTS = """
--count 30 --phi 0.55
--count 30 --phi 0.5 --gap 0.05
--count 40 --phi max --rate 0.1
--count 40 --phi max --rate 0.1 --gap 0.01
--count 40 --phi max --rate 0.1 --gsd
--diameter 1 --box 3.1,3.3,3.5 --phi max --rate 0.1
--diameter 2.5 --box 9,9,12 --walls z --phi 0.4
--count 20 --diameter 1 --box 3
--count 25 --sizes uniform:20,50 --diameter 35 --phi 0.3
--count 25 --sizes uniform:20,50 --diameter 35 --phi max --rate 0.1 --walls xyz
--count 25 --sizes powerlaw:-2,1,4 --box 8,9,10 --phi 0.4
--count 30 --sizes discrete:1=0.5,5=0.5 --phi max --rate 0.1
--count 30 --dimensions 2 --sizes discrete:1,1.4 --phi max --rate 0.1
--count 30 --dimensions 2 --container sphere:7 --phi max --rate 0.1
--diameter 1 --container cylinder:1.5,10 --phi max --rate 0.1
--count 3 --diameter 10 --container cylinder:10,30
--count 25 --container cylinder:3,4 --phi max --rate 0.1
--count 25 --container sphere:5 --phi max --rate 0.1
--count 25 --container cone:4,6 --phi max --rate 0.1
--count 25 --container truncated_cone:2,4,3 --phi max --rate 0.1
--count 25 --container shell:2,5 --phi max --rate 0.1
--count 25 --container annulus:2,5,3 --phi max --rate 0.1
--count 60 --pressure 10
--count 30 --walls z --pressure 1e5 --rate 0.1
--diameter 1 --box 5 --pressure 5
""".strip().splitlines()


def read(file):
    """The centers, and the radii."""
    lines = file.read_text().splitlines()
    names = [part.split("=", 1)[1] for part in lines[1].split() if part.startswith("Properties=")][0].split(":")
    start = {}
    column = 0
    for name, _, count in zip(names[::3], names[1::3], names[2::3]):
        start[name] = column
        column += int(count)
    rows = [[float(value) for value in line.split()] for line in lines[2:]]
    return [row[start["pos"] : start["pos"] + 3] for row in rows], [row[start["radius"]] for row in rows]


def volume_of(container, dimensions):
    size = container["size"]
    if container["shape"] == "box":
        return math.prod(size)
    radius = size[0] / 2
    if container["shape"] == "shell":
        return 4 / 3 * math.pi * (radius**3 - (container["inner"] / 2) ** 3)
    if container["shape"] == "annulus":
        return math.pi * size[2] * (radius**2 - (container["inner"] / 2) ** 2)
    if container["shape"] == "truncated_cone":
        narrow = container["inner"] / 2
        return math.pi / 3 * size[2] * (radius**2 + radius * narrow + narrow**2)
    if container["shape"] == "sphere":
        return math.pi * radius**2 if dimensions == 2 else 4 / 3 * math.pi * radius**3
    return math.pi * radius**2 * size[2] / (1 if container["shape"] == "cylinder" else 3)


def wall_distances(position, container, dimensions):
    """Yields the distance of a center from each wall, in as many digits as the context has."""
    size = [Decimal(edge) for edge in container["size"]]
    if container["shape"] == "box":
        for axis in range(dimensions):
            if container["walls"][axis]:
                yield position[axis]
                yield size[axis] - position[axis]
        return
    radius = size[0] / 2
    round_axes = dimensions if container["shape"] in ("sphere", "shell") else 2
    from_axis = sum((position[axis] - size[axis] / 2) ** 2 for axis in range(round_axes)).sqrt()
    narrow = Decimal(container.get("inner", 0)) / 2
    if container["shape"] in ("shell", "annulus"):
        yield from_axis - narrow
    if container["shape"] == "truncated_cone":
        wider = radius - narrow
        yield (position[2] * wider + size[2] * (narrow - from_axis)) / (wider**2 + size[2] ** 2).sqrt()
    elif container["shape"] == "cone":
        yield (position[2] * radius - size[2] * from_axis) / (radius**2 + size[2] ** 2).sqrt()
    else:
        yield radius - from_axis
    if container["shape"] not in ("sphere", "shell"):
        yield position[2]
        yield size[2] - position[2]


def gaps_of(centers, radii, container, dimensions, within):
    """(first, second, gap over the sum of radii) of all bodies nearer than that; a wall has no number."""
    is_box = container["shape"] == "box"
    shifts = []
    for axis in range(dimensions):
        images = 0
        if is_box and not container["walls"][axis]:
            images = 1 + int(2 * max(radii) * (1 + within) / container["size"][axis])
        shifts.append([image * Decimal(container["size"][axis]) for image in range(-images, images + 1)])
    zero = (Decimal(0),) * dimensions
    points = [[Decimal(number) for number in center] for center in centers]
    sizes = [Decimal(radius) for radius in radii]
    found = []
    for i, j in product(range(len(radii)), repeat=2):
        for shift in product(*shifts) if i <= j else ():
            if i == j and shift <= zero:
                continue
            apart = [points[j][axis] + shift[axis] - points[i][axis] for axis in range(dimensions)]
            if math.hypot(*map(float, apart)) > (radii[i] + radii[j]) * (1.001 + within):
                continue
            reach = sizes[i] + sizes[j]
            found.append((i, j, sum(number**2 for number in apart).sqrt() / reach - 1))
    for i, point in enumerate(points):
        for distance in wall_distances(point, container, dimensions):
            found.append((i, None, distance / sizes[i] - 1))
    return [gap for gap in found if gap[2] <= Decimal(within)]


def backbone_of(contacts, spheres, dimensions):
    """How many contacts there are without those of rattlers, and how many rattlers."""
    held = list(contacts)
    loose = set()
    while True:
        count = [0] * spheres
        for first, second, _ in held:
            for sphere in (first, second):
                if sphere is not None:
                    count[sphere] += 1
        new = {sphere for sphere in range(spheres) if count[sphere] < dimensions + 1}
        if new == loose:
            return len(held), len(loose)
        loose = new
        held = [contact for contact in held if contact[0] not in loose and contact[1] not in loose]


def check(condition, what):
    if not condition:
        raise AssertionError(what)


def check_sizes(radii, kind, tolerance):
    """That sizes are in the range or among the values that were asked for, relative to their mean or absolute."""
    name, numbers = kind.split(":")
    values = [float(number.split("=")[0]) for number in numbers.split(",")]
    if name == "uniform":
        mean = (values[0] + values[1]) / 2 / (sum(radii) / len(radii))
        check(values[0] <= min(radii) * mean * (1 + tolerance), "the smallest size")
        check(values[1] >= max(radii) * mean * (1 - tolerance), "the largest size")
    elif name == "powerlaw":
        check(max(radii) / min(radii) <= values[2] / values[1] * (1 + tolerance), "the range of sizes")
    else:
        ratio = values[1] / values[0]
        for radius in radii:
            to_least = radius / min(radii)
            check(min(abs(to_least - 1), abs(to_least - ratio)) < tolerance * ratio, "a size")


def check_request(program, folder, text):
    words = text.split()
    is_single = "--gsd" in words
    if is_single:
        words.remove("--gsd")
    asked = dict(zip(words[::2], words[1::2]))
    file = folder / ("packing.gsd" if is_single else "packing.xyz")
    command = [program, "pack", *words, "--json", "--overwrite", "--out", file]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    check(run.returncode == 0, f"exit {run.returncode}: {run.stderr}")
    told = json.loads(run.stdout)
    if is_single:
        subprocess.run([program, "convert", file, folder / "read.xyz"], capture_output=True, check=True)
        file = folder / "read.xyz"
    centers, radii = read(file)
    dimensions = told["dimensions"]
    container = told["container"]
    # Jammed spheres reach a density to 1e-8, as diameters in 32 bits do to some 1e-7.
    exact = 1e-6 if is_single else 1e-8
    check(told["count"] == len(radii) == int(asked.get("--count", len(radii))), "count")
    diameter = 2 * math.fsum(radii) / len(radii)
    check(abs(told["diameter"] / diameter - 1) < 1e-13, "diameter")
    if "--diameter" in asked:
        check(abs(diameter / float(asked["--diameter"]) - 1) < exact, f"diameter {diameter}")
    volumes = [math.pi * r**2 if dimensions == 2 else 4 / 3 * math.pi * r**3 for r in radii]
    fraction = math.fsum(volumes) / volume_of(container, dimensions)
    check(abs(told["phi"] / fraction - 1) < 1e-12, f"packing fraction {fraction}")
    if asked.get("--phi", "max") != "max":
        off = abs(fraction - float(asked["--phi"]))
        whole = 0 if "--count" in asked else max(volumes) / volume_of(container, dimensions)
        check(off <= 3 * exact * fraction + whole / 2, f"packing fraction {fraction}")
    if "--pressure" in asked:
        check(told["pressure"] >= float(asked["--pressure"]), "pressure too low")
        check("--count" not in asked or told["pressure"] <= 1.1 * float(asked["--pressure"]), "pressure too high")
    if "--sizes" in asked:
        check_sizes(radii, asked["--sizes"], 1e-9)
    tolerance = told["contact_tolerance"] or 0
    gaps = gaps_of(centers, radii, container, dimensions, max(tolerance, 1.01 * told["smallest_gap"] + 1e-9))
    least = min(gap for _, _, gap in gaps)
    check(least >= 0 and told["largest_overlap"] == 0, f"overlap {least}")
    check(abs(float(least) - told["smallest_gap"]) <= 1e-15 + 1e-9 * told["smallest_gap"], f"gap {least}")
    check(float(least) >= float(asked.get("--gap", 0)) * (1 - 1e-9), f"gap {least}")
    if told["contact_tolerance"] is None:
        return
    contacts = [gap for gap in gaps if gap[2] <= Decimal(tolerance)]
    check(backbone_of(contacts, len(radii), dimensions) == (told["contacts"], told["rattlers"]), "contacts")


def main():
    program = str(Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as folder, localcontext() as context:
        context.prec = 40
        for text in REQUESTS:
            try:
                check_request(program, Path(folder), text)
            except AssertionError as error:
                sys.exit(f"hardball pack {text}: {error}")


if __name__ == "__main__":
    main()
