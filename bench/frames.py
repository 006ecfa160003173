#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Measures what frames take at 60 a second: elastic spheres at several densities and speeds, on one thread.

usage: PYTHONPATH=build/python python3 bench/frames.py [SPHERES]

Prints two tables in Markdown. The first has for each frame the contacts, and the median, the 99th of a hundred and the
longest time. In the second a frame ends after so many contacts at the latest, and simulated time falls behind.
"""

import math
import statistics
import sys
import time

import hardball

WARM_FRAMES = 60
FRAMES = 300
FRAME = 1 / 60  # s
DENSITIES = (0.05, 0.1, 0.3)
DISPLACEMENTS = (0.1, 0.3, 1.0)  # root mean square of a sphere in a frame, in diameters


def simulation_of(spheres, density, displacement):
    speed = displacement / FRAME
    edge = (spheres * math.pi / 6 / density) ** (1 / 3)
    scenario = {
        "box": {"size": [edge] * 3, "boundary": ["periodic"] * 3},
        "spheres": [{"count": spheres, "radius": 0.5, "placement": "random", "temperature": speed**2 / 3}],
        "run": {"until": 1e6},
    }
    return hardball.Simulation.from_scenario(scenario)


def milliseconds_of_frames(simulation, budget):
    """The time of each frame, and its contacts."""
    times, contacts = [], []
    for frame in range(1, WARM_FRAMES + FRAMES + 1):
        begin = time.perf_counter()
        done = simulation.run(until=frame * FRAME, contacts=budget)
        if frame > WARM_FRAMES:
            times.append(1e3 * (time.perf_counter() - begin))
            contacts.append(done)
    return sorted(times), statistics.mean(contacts)


def print_row(*cells):
    print("|", " | ".join(str(cell) for cell in cells), "|", flush=True)


def numbers_of(times):
    return tuple(f"{number:.2f}" for number in (statistics.median(times), times[len(times) * 99 // 100], times[-1]))


def main():
    spheres = int(sys.argv[1]) if len(sys.argv) > 1 else 20000
    print(f"{spheres} spheres, one thread\n")
    print_row("packing fraction", "diameters in a frame", "contacts in a frame", "median ms", "99%", "longest")
    print_row(*["---"] * 6)
    slowest = 0.0
    for density in DENSITIES:
        for displacement in DISPLACEMENTS:
            times, contacts = milliseconds_of_frames(simulation_of(spheres, density, displacement), None)
            print_row(density, displacement, round(contacts), *numbers_of(times))
            slowest = contacts

    print(f"\npacking fraction {DENSITIES[-1]}, {DISPLACEMENTS[-1]} diameters in a frame\n")
    print_row("budget", "contacts in a frame", "simulated over real time", "median ms", "99%", "longest")
    print_row(*["---"] * 6)
    for part in (1, 0.5, 0.25):
        budget = round(part * slowest)
        simulation = simulation_of(spheres, DENSITIES[-1], DISPLACEMENTS[-1])
        times, contacts = milliseconds_of_frames(simulation, budget)
        pace = simulation.time / (FRAME * (WARM_FRAMES + FRAMES))
        print_row(budget, round(contacts), f"{pace:.2f}", *numbers_of(times))


if __name__ == "__main__":
    main()
