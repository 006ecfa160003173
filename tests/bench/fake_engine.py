#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""An engine that speaks the protocol of bench/grid.py with invented numbers.

usage: fake_engine.py NANOSECONDS [--uneven] [--fault FAULT] [--bare] --spheres N ...

Its slices take NANOSECONDS per collision, and one, two, three... times as much in turn with --uneven. FAULT is what
goes wrong: start, ready, run (in the third slice), text, silence or nothing. With --bare it says what it must and no
more.
"""

import argparse
import json
import sys
import time


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("nanoseconds", type=float)
    parser.add_argument("--fault")
    parser.add_argument("--bare", action="store_true")
    parser.add_argument("--uneven", action="store_true")
    for name in ("spheres", "packing-fraction", "equilibration", "seed"):
        parser.add_argument("--" + name, type=float, required=True)
    options = parser.parse_args()

    if options.fault == "start":
        sys.exit("there is no such density")
    ready = "ready " + json.dumps({} if options.bare else {"bytes_per_sphere": 48})
    print("hello" if options.fault == "ready" else ready, flush=True)
    slices = 0
    for line in sys.stdin:
        contacts = int(line.removeprefix("run "))
        slices += 1
        if options.fault == "run" and slices == 3:
            sys.exit("inelastic collapse")
        if options.fault == "silence":
            time.sleep(60)
        factor = slices if options.uneven else 1
        report = {"collisions": contacts, "seconds": factor * options.nanoseconds * contacts * 1e-9}
        if options.fault == "nothing":
            report["collisions"] = 0
        if not options.bare:
            report |= {
                "cycles": 3 * contacts,
                "instructions": None,
                "counters": {
                    "enter": 2 * contacts,
                    "stale": 0,
                    "predictions": 64 * contacts,
                    "rebuilds": int(slices == 2),
                },
            }
        print("done" if options.fault == "text" else json.dumps(report), flush=True)


if __name__ == "__main__":
    main()
