#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Measures what it costs to use Hardball from Python.

usage: PYTHONPATH=build/python python3 bench/python_face.py PROGRAM [ROUNDS]

Alternately: the paper's experiment run by the program and from Python, and with all contacts recorded; then a response
written in Python. Medians of ratios. Pin it to one core.
"""

import copy
import json
import statistics
import subprocess
import sys
import time
from pathlib import Path

import hardball

SCENARIO = Path(__file__).resolve().parents[1] / "scenarios" / "paper.toml"
UNTIL = 300.0


def seconds_of_program(program):
    command = [program, "run", SCENARIO, "--until", str(UNTIL), "--quiet", "--json"]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    return json.loads(done.stdout)["seconds"]["run"]


def seconds_of(simulation, **options):
    begin = time.perf_counter()
    result = simulation.run(until=UNTIL, **options)
    return time.perf_counter() - begin, result


def elastic(contact):
    normal = contact.normal
    if contact.kind == "wall":
        return contact.before[0] - 2 * contact.normal_speed * normal, contact.before[1]
    first, second = contact.masses
    exchange = 2 * contact.normal_speed * first * second / (first + second)
    return contact.before[0] - exchange / first * normal, contact.before[1] + exchange / second * normal


def main():
    program, rounds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 9
    start = hardball.Simulation.from_scenario(SCENARIO)
    from_python, recorded = [], []
    for _ in range(rounds):
        by_program = seconds_of_program(program)
        plain, contacts = seconds_of(copy.copy(start))
        with_record, events = seconds_of(copy.copy(start), record=True)
        assert len(events) == contacts
        from_python.append(plain / by_program)
        recorded.append(with_record / plain)
    print(f"{contacts} contacts; from Python over by the program: {statistics.median(from_python):.3f}")
    print(f"recorded over not recorded: {statistics.median(recorded):.3f}")

    costs = []
    for _ in range(rounds):
        own, built_in = copy.copy(start), copy.copy(start)
        own.respond_with(elastic)
        begin = time.perf_counter()
        own.run(collisions=20_000)
        middle = time.perf_counter()
        built_in.run(collisions=20_000)
        costs.append((2 * middle - begin - time.perf_counter()) / own.collisions)
    print(f"a response in Python: {1e6 * statistics.median(costs):.1f} microseconds a collision")

    many = hardball.Simulation.from_scenario(SCENARIO.with_name("dense_gas.toml"))
    begin = time.perf_counter()
    many_contacts = many.run(contacts=10_000_000)
    middle = time.perf_counter()
    many_events = many.run(contacts=10_000_000, record=True)
    end = time.perf_counter()
    assert len(many_events) == many_contacts
    print(f"10 million contacts of a dense gas: {middle - begin:.2f} s, recorded {end - middle:.2f} s")


if __name__ == "__main__":
    main()
