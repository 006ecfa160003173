#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Measures engines over a grid of sizes and densities, in turn, slice by slice.

At each point of the grid all engines under test are started as processes on one core of the processor, or on those given. Then each runs
for a slice of time, round after round, while the others wait for input and cost nothing. Other load on the machine
slows all of them, so that ratios hold on a shared machine too.

The protocol. An engine is a command to which these arguments are appended:
  --spheres N --packing-fraction PHI --equilibration C --seed S
It places N equal spheres of diameter 1 and mass 1 in a periodic cube, with Gaussian velocities at k T = 1, and runs
for C collisions per sphere, that is C * N / 2 in all. Then it prints, and flushes, a line
  ready {JSON}
with any of the keys bytes_per_sphere, peak_rss_bytes, setup_seconds, engine, cell_edge, compiler, flags. For each line
  run K
of its standard input it continues for K further contacts, and prints and flushes a line
  {JSON}
with the keys collisions and seconds (of these contacts alone), and any of simulated_time, cycles, instructions, and
counters, an object of event counts such as enter, stale, predictions, rebuilds. Unknown values are absent or null. At
the end of the input it exits. measured_engine also understands the line
  finish
prints {"event_log_hash": "..."} of all contacts so far, and exits.

The tables. One row is one engine; everything but memory is per collision. Nanoseconds, cycles and instructions are
medians over the rounds, with the spread (largest less smallest, over the median). The mean is the nanoseconds of all
rounds over all collisions: if far from the median, few slices do much of the work, such as rebuilds, and slices should
be longer. Events are totals of all rounds over all collisions. The ratio is the time over that of the
first engine in the same round, median over the rounds.
"""

from __future__ import annotations

import argparse
import datetime
import json
import os
import platform
import select
import shlex
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from dataclasses import asdict, dataclass, field
from pathlib import Path
from statistics import median
from typing import Any

PROJECT = Path(__file__).resolve().parent.parent
PROGRAM = PROJECT / "build/bench/bench/measured_engine"

# Numbers of spheres that fill a cube of face-centered cubic cells: 4 n^3.
SPHERES = [4_000, 108_000, 1_000_188]
PACKING_FRACTIONS = [0.001, 0.02, 0.25, 0.49, 0.60]
QUICK_SPHERES = [4_000]
MOST_SPHERES_EQUILIBRATED_LONG = 108_000

Report = dict[str, Any]


class EngineFailure(Exception):
    """An engine violated the protocol."""


@dataclass
class Engine:
    """An engine under test."""

    name: str
    command: list[str]


@dataclass
class Point:
    """A point of the grid."""

    spheres: int
    packing_fraction: float
    equilibration: float
    seed: int

    def arguments(self) -> list[str]:
        return [
            "--spheres", str(self.spheres),
            "--packing-fraction", str(self.packing_fraction),
            "--equilibration", str(self.equilibration),
            "--seed", str(self.seed),
        ]  # fmt: skip


@dataclass
class Measurement:
    """The measurement of one engine at one point; `failure` says why it ended early."""

    name: str
    command: list[str]
    ready: Report = field(default_factory=dict)
    contacts_per_slice: int = 0
    slices: list[Report] = field(default_factory=list)
    failure: str | None = None


@dataclass
class Settings:
    """How to measure; times in seconds."""

    rounds: int = 7
    slice_seconds: float = 0.5
    patience: float = 3600
    cores: list[int] | None = None


# --- engines ----------------------------------------------------------------------------------------------------


class LiveEngine:
    """A process that speaks the protocol."""

    def __init__(self, command: Sequence[str], settings: Settings):
        self._patience = settings.patience
        self._messages = tempfile.TemporaryFile()
        self._unread = b""
        cores = settings.cores
        pin = None if cores is None else (lambda: os.sched_setaffinity(0, cores))
        try:
            self._process = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self._messages, preexec_fn=pin, bufsize=0
            )
        except OSError as error:
            self._messages.close()
            raise EngineFailure(f"cannot be started: {error}") from error

    def __enter__(self) -> LiveEngine:
        return self

    def __exit__(self, *_: object) -> None:
        # A finished engine has no state worth waiting for.
        self._process.kill()
        self._process.wait()
        self._process.stdin.close()
        self._process.stdout.close()
        self._messages.close()

    def wait_until_ready(self) -> Report:
        line = self._read_line()
        if not line.startswith("ready "):
            raise EngineFailure(f"said {line!r} instead of being ready")
        return parse_report(line.removeprefix("ready "))

    def run(self, contacts: int) -> Report:
        try:
            self._process.stdin.write(f"run {contacts}\n".encode())
        except OSError:
            raise EngineFailure(self._end()) from None
        report = parse_report(self._read_line())
        for key in ("collisions", "seconds"):
            number = number_in(report, key)
            if number is None or not number > 0:
                raise EngineFailure(f"reported {key}: {report.get(key)!r} of {contacts} contacts")
        return report

    def _read_line(self) -> str:
        deadline = time.monotonic() + self._patience
        while b"\n" not in self._unread:
            left = max(0.0, deadline - time.monotonic())
            if not select.select([self._process.stdout], [], [], left)[0]:
                raise EngineFailure(f"gave no answer for {self._patience:g} s")
            text = self._process.stdout.read(65536)
            if not text:
                raise EngineFailure(self._end())
            self._unread += text
        line, self._unread = self._unread.split(b"\n", 1)
        return line.decode(errors="replace")

    def _end(self) -> str:
        """How the process ended, and its last message."""
        try:
            status = self._process.wait(self._patience)
        except subprocess.TimeoutExpired:
            return "closed its output"
        self._messages.seek(0)
        lines = self._messages.read().decode(errors="replace").strip().splitlines()
        how = f"exit code {status}" if status >= 0 else f"signal {-status}"
        return f"ended with {how}" + (f": {lines[-1]}" if lines else "")


def parse_report(text: str) -> Report:
    try:
        report = json.loads(text)
    except ValueError:
        report = None
    if not isinstance(report, dict):
        raise EngineFailure(f"said {text!r} instead of a JSON object")
    return report


def number_in(report: Report | None, key: str) -> float | None:
    """None if the report has no such number."""
    value = report.get(key) if isinstance(report, dict) else None
    return value if isinstance(value, (int, float)) and not isinstance(value, bool) else None


# --- measuring --------------------------------------------------------------------------------------------------


def calibrate(engine: LiveEngine, slice_seconds: float) -> int:
    """The number of contacts that takes about this long."""
    contacts = 100
    while True:
        seconds = engine.run(contacts)["seconds"]
        if seconds >= slice_seconds / 4:
            return max(1, round(contacts * slice_seconds / seconds))
        contacts *= 3


def measure_point(point: Point, engines: Sequence[Engine], settings: Settings) -> list[Measurement]:
    """Runs all engines in turn; one that fails is dropped."""
    measurements = []
    live: list[tuple[Measurement, LiveEngine]] = []
    with ExitStack() as stack:
        for engine in engines:
            measurement = Measurement(engine.name, engine.command + point.arguments())
            measurements.append(measurement)
            try:
                process = stack.enter_context(LiveEngine(measurement.command, settings))
                measurement.ready = process.wait_until_ready()
                measurement.contacts_per_slice = calibrate(process, settings.slice_seconds)
                live.append((measurement, process))
            except EngineFailure as failure:
                measurement.failure = str(failure)
        for round_number in range(settings.rounds):
            # Back and forth, so that none always runs after the same other.
            for measurement, process in live if round_number % 2 == 0 else reversed(live):
                try:
                    measurement.slices.append(process.run(measurement.contacts_per_slice))
                except EngineFailure as failure:
                    measurement.failure = str(failure)
            live = [pair for pair in live if pair[0].failure is None]
    return measurements


# --- results ----------------------------------------------------------------------------------------------------


def nanoseconds(measurement: Measurement) -> list[float]:
    """Per collision, of each round."""
    return [1e9 * each["seconds"] / each["collisions"] for each in measurement.slices]


def mean_nanoseconds(measurement: Measurement) -> float:
    """Per collision, of all rounds together."""
    seconds = sum(each["seconds"] for each in measurement.slices)
    return 1e9 * seconds / sum(each["collisions"] for each in measurement.slices)


def spread(values: Sequence[float]) -> float:
    """Largest less smallest, over the median."""
    return (max(values) - min(values)) / median(values)


def median_per_collision(measurement: Measurement, key: str) -> float | None:
    """The median over the rounds; None if unknown for a round."""
    values = [number_in(each, key) for each in measurement.slices]
    if not values or None in values:
        return None
    return median(value / each["collisions"] for value, each in zip(values, measurement.slices))


def count_per_collision(measurement: Measurement, counter: str) -> float | None:
    """The count over all rounds together, since rare events happen in few of them; None if unknown for a round."""
    values = [number_in(each.get("counters"), counter) for each in measurement.slices]
    if not values or None in values:
        return None
    return sum(values) / sum(each["collisions"] for each in measurement.slices)


def ratio(measurement: Measurement, reference: Measurement) -> float:
    """Time over that of the reference in the same round, median over the rounds."""
    pairs = zip(nanoseconds(measurement), nanoseconds(reference))
    return median(mine / other for mine, other in pairs)


def is_complete(measurement: Measurement) -> bool:
    return measurement.failure is None and bool(measurement.slices)


def find_stored(stored: Report, point: Point, name: str) -> Measurement | None:
    """The complete measurement of an engine of this name at this size and density in a file of results."""
    for entry in stored["points"]:
        same = entry["point"]
        if (same["spheres"], same["packing_fraction"]) != (point.spheres, point.packing_fraction):
            continue
        for each in entry["measurements"]:
            measurement = Measurement(**each)
            if measurement.name == name and is_complete(measurement):
                return measurement
    return None


# --- tables -----------------------------------------------------------------------------------------------------

COUNTERS = ["enter", "stale", "predictions", "rebuilds"]


def to_text(number: float | None, form: str) -> str:
    return "-" if number is None else format(number, form)


def table(point: Point, measurements: Sequence[Measurement], stored: Report | None = None) -> list[list[str]]:
    """Heads and rows of the complete measurements; ratios to stored results only if there are some."""
    complete = [each for each in measurements if is_complete(each)]
    if not complete:
        return []
    reference = complete[0]
    heads = ["engine", "nanoseconds", "spread", "mean", *COUNTERS, "bytes per sphere", "cycles", "instructions"]
    heads.append(f"over {reference.name}")
    if stored is not None:
        heads.append("over stored")
    rows = [heads]
    for each in complete:
        times = nanoseconds(each)
        row = [each.name, format(median(times), ".1f"), format(spread(times), ".1%")]
        row.append(format(mean_nanoseconds(each), ".1f"))
        row += [to_text(count_per_collision(each, counter), ".3g") for counter in COUNTERS]
        row.append(to_text(number_in(each.ready, "bytes_per_sphere"), ".1f"))
        row += [to_text(median_per_collision(each, key), ".0f") for key in ("cycles", "instructions")]
        row.append(format(ratio(each, reference), ".3f"))
        if stored is not None:
            old = find_stored(stored, point, each.name)
            row.append("-" if old is None else format(median(times) / median(nanoseconds(old)), ".3f"))
        rows.append(row)
    return rows


def plain_table(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    widths = [max(map(len, column)) for column in zip(*rows)]
    for row in rows:
        cells = [row[0].ljust(widths[0])] + [cell.rjust(width) for cell, width in zip(row[1:], widths[1:])]
        yield "  ".join(cells).rstrip()


def markdown_table(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    for number, row in enumerate(rows):
        yield "| " + " | ".join(row) + " |"
        if number == 0:
            yield "|---|" + "---:|" * (len(row) - 1)


def point_report(
    point: Point, measurements: Sequence[Measurement], stored: Report | None = None, markdown: bool = False
) -> str:
    """The table of a point, and its failures."""
    title = f"{point.spheres} spheres, packing fraction {point.packing_fraction:g}; per collision:"
    lines = [f"**{title}**" if markdown else title, *([""] if markdown else [])]
    if rows := table(point, measurements, stored):
        lines += markdown_table(rows) if markdown else plain_table(rows)
    failures = [f"{each.name} failed: {each.failure}" for each in measurements if each.failure is not None]
    if markdown and failures:
        lines.append("")
    return "\n".join(lines + failures) + "\n"


# --- the grid ---------------------------------------------------------------------------------------------------


def processor() -> str:
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    except OSError:
        pass
    return platform.processor() or "unknown"


def git(*arguments: str) -> str | None:
    try:
        return subprocess.run(
            ["git", *arguments], cwd=PROJECT, check=True, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
        ).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return None


def where_measured(settings: Settings) -> Report:
    """The context of a speed claim; each engine names its own compiler and flags when it is ready."""
    changes = git("status", "--porcelain", "--untracked-files=no")
    return {
        "commit": git("rev-parse", "HEAD"),
        "dirty": None if changes is None else changes != "",
        "date": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"),
        "processor": processor(),
        "command": sys.argv,
        "settings": asdict(settings),
    }


def default_equilibration(spheres: int) -> float:
    return 20 if spheres <= MOST_SPHERES_EQUILIBRATED_LONG else 5


def run_grid(
    points: Sequence[Point],
    engines: Sequence[Engine],
    settings: Settings,
    out: Path,
    stored: Report | None = None,
    markdown: bool = False,
) -> bool:
    """Measures, prints and stores each point; returns whether anything was measured at every one of them."""
    results = where_measured(settings) | {"points": []}
    out.parent.mkdir(parents=True, exist_ok=True)
    if stored is not None:
        print(f"over stored: {stored['commit']} of {stored['date']} on {stored['processor']}, not interleaved\n")
    success = True
    for point in points:
        measurements = measure_point(point, engines, settings)
        results["points"].append({"point": asdict(point), "measurements": [asdict(each) for each in measurements]})
        # After each point, so that an aborted run leaves its results.
        out.write_text(json.dumps(results, indent=1) + "\n")
        print(point_report(point, measurements, stored, markdown), flush=True)
        success = success and any(is_complete(each) for each in measurements)
    print(f"every slice is in {out}")
    return success


# --- the command line -------------------------------------------------------------------------------------------


def list_of(convert: type) -> Any:
    """Parses a comma-separated list."""

    def parse(text: str) -> list[Any]:
        return [convert(item) for item in text.split(",")]

    parse.__name__ = f"list of {convert.__name__}"
    return parse


def named_command(text: str) -> Engine:
    name, separator, command = text.partition("=")
    if not (name and separator and command):
        raise argparse.ArgumentTypeError(f"'{text}' is not of the form name=command line")
    return Engine(name, shlex.split(command))


def results_file(text: str) -> Report:
    try:
        results = json.loads(Path(text).read_text())
    except (OSError, ValueError) as error:
        raise argparse.ArgumentTypeError(f"cannot read {text}: {error}") from error
    if not isinstance(results, dict) or "points" not in results:
        raise argparse.ArgumentTypeError(f"{text} holds no results of this program")
    return results


def available_cores() -> list[int]:
    """Empty where processes cannot be pinned to a core."""
    return sorted(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else []


def parse_arguments(arguments: Sequence[str] | None = None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="./dev bench", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--quick", action="store_true", help="a trial: 4000 spheres, 3 rounds, slices of 0.05 s")
    parser.add_argument("--spheres", type=list_of(int), metavar="N,...", help="default: 4000,108000,1000188")
    parser.add_argument(
        "--packing-fractions", type=list_of(float), metavar="PHI,...", default=PACKING_FRACTIONS,
        help="default: 0.001,0.02,0.25,0.49,0.6",
    )  # fmt: skip
    parser.add_argument("--engines", type=list_of(str), metavar="NAME,...", default=["auto"],
                        help="engines of this build, as in auto,paper; default: auto")  # fmt: skip
    parser.add_argument("--against", type=named_command, metavar="NAME=COMMAND", action="append", default=[],
                        help="another engine that speaks the protocol; may be repeated")  # fmt: skip
    parser.add_argument("--compare", type=results_file, metavar="FILE", help="stored results to print ratios to")
    parser.add_argument("--equilibration", type=float, metavar="C",
                        help="collisions per sphere; default: 20 up to 108000 spheres, else 5")  # fmt: skip
    parser.add_argument("--seed", type=int, default=1, help="default: 1")
    parser.add_argument("--rounds", type=int, help="default: 7")
    parser.add_argument("--slice", type=float, metavar="SECONDS", help="length of a slice; default: 0.5")
    parser.add_argument("--cores", type=list_of(int), metavar="CORE,...", default=available_cores()[-1:] or None,
                        help="for engines of several threads, as many; default: the last one")  # fmt: skip
    parser.add_argument("--patience", type=float, metavar="SECONDS", default=3600,
                        help="an engine that gives no answer for this long has failed; default: 3600")  # fmt: skip
    parser.add_argument("--out", type=Path, metavar="FILE", default=PROJECT / "build/bench/results.json",
                        help="default: build/bench/results.json")  # fmt: skip
    parser.add_argument("--markdown", action="store_true", help="print tables as Markdown")
    parser.add_argument("--program", type=Path, default=PROGRAM, help="the measured_engine of this build")
    options = parser.parse_args(arguments)
    if options.rounds is not None and options.rounds < 1:
        parser.error("--rounds: give at least 1")
    if not set(options.cores or []) <= set(available_cores()):
        parser.error(f"--cores: give some of {', '.join(map(str, available_cores()))}")
    if options.slice is not None and not options.slice > 0:
        parser.error("--slice: give a positive time")
    names = options.engines + [engine.name for engine in options.against]
    if len(set(names)) < len(names):
        parser.error("two engines have the same name")
    return options


def main(arguments: Sequence[str] | None = None) -> int:
    options = parse_arguments(arguments)
    settings = Settings(
        rounds=options.rounds or (3 if options.quick else 7),
        slice_seconds=options.slice or (0.05 if options.quick else 0.5),
        patience=options.patience,
        cores=options.cores,
    )
    points = [
        Point(
            spheres,
            packing_fraction,
            default_equilibration(spheres) if options.equilibration is None else options.equilibration,
            options.seed,
        )
        for spheres in options.spheres or (QUICK_SPHERES if options.quick else SPHERES)
        for packing_fraction in options.packing_fractions
    ]
    engines = [Engine(name, [str(options.program), "--engine", name]) for name in options.engines] + options.against
    return 0 if run_grid(points, engines, settings, options.out, options.compare, options.markdown) else 1


if __name__ == "__main__":
    sys.exit(main())
