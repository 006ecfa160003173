#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""How fast one system would be in many domains, each on a processor core of its own: measurements and a model.

usage: parallel_model.py measure FILE [--program PROGRAM]    run critical_path over a grid, and store what it prints
       parallel_model.py report FILE [--figure FIGURE.svg]   fit the model, and print tables in Markdown

The model, in which lengths are in diameters. A domain has m spheres of its own in a block of side s, of which n axes
are divided. It has k neighbors, and c = w m / 2 contacts in a window; its ghosts have r c more. A window takes

    T = b (c ((t + q_1) (1 + r) + r (q_2 + q_3 k)) + q_0) (1 + l (1 + u)) + C

- t is the time of a contact in one engine of all spheres; q_1 what each contact costs in addition; q_2 what a contact
  of a ghost costs, which is told, compared and corrected, and q_3 the same for each neighbor; q_0 a window without
  contacts. Each packing fraction has its own.
- r = g ((1 + 2 h / s)^n - 1), where h is the depth of halos, and g how many contacts a ghost has for one of an own
  sphere.
- b = 1 + a sqrt(2 ln D / (c (1 + r))): in each step the slowest of D domains counts.
- l = p A (w / .02)^(5/2) is the number of failed windows for each that is committed, where A is the area of all
  frontiers and w the number of contacts for each sphere in a window; one costs a window, and u windows to go back.
- C is the time of communication: see Network.
"""

import argparse
import datetime
import json
import math
import platform
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Iterator, Sequence

import numpy as np

PROJECT = Path(__file__).resolve().parent.parent
PROGRAM = PROJECT / "build/bench/bench/critical_path"
Row = dict[str, Any]

PACKING_FRACTIONS = [0.02, 0.25, 0.49]
HALO = 1.75  # diameters
SLACK = 0.5  # diameters, in which spheres that were ghosts are ghosts still
# Contacts for each sphere in a window, and up to twice as many while a domain has fewer contacts than this, and spheres
# fly no farther than so many diameters.
WINDOW = 0.02
CONTACTS_OF_DOMAIN = 256
SHORT_FLIGHT = 0.1
# With windows of .02, .04, .08 and .16, 2, 11, 64 and 376 of 1,000 failed (256,000 spheres at .25 in 64 domains, halos
# of 2 diameters).
FAILURES_BY_WINDOW = 2.5  # the power with which they grow
MOST_NEIGHBORS = 31
# Below this side, in diameters, most spheres of a block are ghosts of another.
LEAST_SIDE = 12


@dataclass
class Network:
    """Assumed, not measured: a good network between machines, and processes that do nothing else meanwhile."""

    latency: float = 1.5e-6  # seconds, of a message
    overhead: float = 0.5e-6  # seconds, of each further message that is sent or received at the same time
    bandwidth: float = 10e9  # bytes per second, of each domain

    # After run, verify and commit, each domain tells its neighbors; after that, all agree how far they were right.
    EXCHANGES = 3
    REDUCTIONS = 1

    def seconds(self, domains: int, neighbors: float, sent: float) -> float:
        exchange = self.latency + max(neighbors - 1, 0) * self.overhead
        reduction = 2 * math.ceil(math.log2(domains)) * self.latency
        return self.EXCHANGES * exchange + self.REDUCTIONS * reduction + sent / self.bandwidth


# --- measuring --------------------------------------------------------------------------------------------------

# Spheres, numbers of domains, and how often they are timed: the least time counts, and short ones are disturbed as a
# whole.
TIMED = [(108000, "2,4,8,16", 9), (256000, "2,4,8,16,32,64", 9), (1000188, "2,8,64", 5), (1972156, "8,64", 5)]
# Windows before, by packing fraction: where spheres hardly move, it takes many until copies are corrected as often as
# later.
WARM_UP = {0.02: "25", 0.25: "25", 0.49: "150"}
# Halos and seeds, of which failures are counted.
COUNTED = [(1.6, 2), (1.75, 1), (1.75, 2), (2.0, 1), (2.0, 2), (2.25, 1)]


def commands() -> Iterator[list[str]]:
    for fraction in PACKING_FRACTIONS:
        gas = ["--packing-fraction", str(fraction), "--equilibration", "3"]
        for spheres, domains, repetitions in TIMED:
            yield [*gas, "--spheres", str(spheres), "--domains", domains, "--warm-up", WARM_UP[fraction]] + [
                "--windows", "10", "--repetitions", str(repetitions),
            ]  # fmt: skip
        for halo, seed in COUNTED:
            yield [*gas, "--spheres", "256000", "--domains", "64", "--halo", str(halo), "--seed", str(seed)] + [
                "--windows", "500", "--repetitions", "0",
            ]  # fmt: skip


def measure(file: Path, program: Path) -> None:
    results = where_measured() | {"rows": []}
    for command in commands():
        lines = subprocess.run([program, *command], check=True, text=True, stdout=subprocess.PIPE).stdout
        results["rows"] += [json.loads(line) for line in lines.splitlines()]
        file.write_text(dump(results))


def dump(results: Row) -> str:
    """A row to a line."""
    rows = ",\n".join(json.dumps(row) for row in results["rows"])
    head = json.dumps({key: value for key, value in results.items() if key != "rows"}, indent=1)
    return head.removesuffix("\n}") + ',\n "rows": [\n' + rows + "\n]}\n"


def where_measured() -> Row:
    commit = subprocess.run(["git", "rev-parse", "HEAD"], cwd=PROJECT, text=True, capture_output=True).stdout.strip()
    return {
        "commit": commit or "unknown",
        "date": datetime.datetime.now(datetime.timezone.utc).date().isoformat(),
        "processor": processor(),
        "commands": ["critical_path " + " ".join(command) for command in commands()],
    }


def processor() -> str:
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    except OSError:
        pass
    return platform.processor() or "unknown"


# --- geometry ---------------------------------------------------------------------------------------------------


@dataclass
class Blocks:
    """A periodic cube of equal spheres that is cut in two again and again."""

    spheres: float
    packing_fraction: float
    domains: int

    def parts(self) -> list[int]:
        """Along the axes."""
        cuts = round(math.log2(self.domains))
        return [2 ** (cuts // 3 + (axis < cuts % 3)) for axis in range(3)]

    def edge(self) -> float:
        return (self.spheres * math.pi / 6 / self.packing_fraction) ** (1 / 3)

    def least_side(self) -> float:
        return self.edge() / max(self.parts())

    def ghosts(self, halo: float) -> float:
        """For each own sphere."""
        return math.prod(1 + 2 * halo * parts / self.edge() for parts in self.parts() if parts > 1) - 1

    def neighbors(self) -> int:
        return math.prod(min(parts, 3) for parts in self.parts()) - 1

    def area(self) -> float:
        return self.edge() ** 2 * sum(parts for parts in self.parts() if parts > 1)


def blocks_of(row: Row) -> Blocks:
    return Blocks(row["spheres"], row["packing_fraction"], row["domains"])


# --- what was measured ------------------------------------------------------------------------------------------


def per_window(row: Row, seconds: float) -> float:
    """From all windows to one, with the share of the watch, which falls into few of them."""
    return seconds / row["windows"] + row["watch_seconds_per_domain"] / row["windows_per_watch"]


def domain_seconds(row: Row) -> float:
    """Of a window, the mean over the domains."""
    return per_window(row, row["sum_seconds"] / row["domains"])


def critical_seconds(row: Row) -> float:
    return per_window(row, row["critical_seconds"])


def one_engine_seconds(row: Row) -> float:
    return row["one_engine_seconds"] / row["windows"]


def seconds_per_contact(row: Row) -> float:
    """Of one engine."""
    return row["one_engine_seconds"] / row["contacts"]


def bytes_per_window(row: Row) -> float:
    """That a domain sends."""
    return sum(row["bytes_per_window_and_domain"].values())


def contacts(row: Row) -> float:
    """Of the own spheres of a domain in a window."""
    return row["contacts"] / row["windows"] / row["domains"]


def mean_free_path(packing_fraction: float) -> float:
    """In diameters, by Enskog, with the contact value of Carnahan and Starling."""
    at_contact = (1 - packing_fraction / 2) / (1 - packing_fraction) ** 3
    return 1 / (6 * math.sqrt(2) * packing_fraction * at_contact)


def contacts_in_window(blocks: Blocks) -> float:
    """Of the own spheres of a domain, as Cluster has it."""
    own = blocks.spheres / blocks.domains
    usual = WINDOW / 2 * own
    more = min(max(CONTACTS_OF_DOMAIN, usual), 2 * usual)
    short = SHORT_FLIGHT / mean_free_path(blocks.packing_fraction) / 2 * own
    return min(max(short, usual), more)


def failures_by_window(own: float, blocks: Blocks) -> float:
    """How many times as many windows fail that have so many contacts as of those of the usual length."""
    return float((own / (WINDOW / 2 * blocks.spheres / blocks.domains)) ** FAILURES_BY_WINDOW)


def redundancy(row: Row) -> float:
    return row["handled_contacts"] / row["contacts"] - 1


# --- the model --------------------------------------------------------------------------------------------------


@dataclass
class Model:
    work: dict[float, np.ndarray]  # q_1, q_2, q_3 per contact, q_0 per window [s], by packing fraction
    work_error: dict[float, float]  # root mean square, relative
    contact: dict[float, float]  # t by packing fraction [s]
    ghost_contacts: float  # g
    imbalance: float  # a
    failures: dict[float, "FailureRate"]
    undo: float  # of a window, over the time of a window
    sent: dict[float, float]  # bytes for a contact of a ghost

    def window_seconds(self, fraction: float, own: float, ghosts: float, neighbors: float, contact: float) -> float:
        return float(self.work[fraction] @ terms(own, ghosts, neighbors)) + own * contact * (1 + ghosts)

    def imbalance_of(self, own: float, ghosts: float, domains: int) -> float:
        return 1 + self.imbalance * unevenness(own, ghosts, domains)

    def predict(
        self, blocks: Blocks, halo: float, network: Network, is_cautious: bool = False, may_fail: bool = True
    ) -> Row:
        fraction = blocks.packing_fraction
        own = contacts_in_window(blocks)
        # In the long run spheres that have left the halo fill its slack by half.
        ghosts = self.ghost_contacts * blocks.ghosts(halo + SLACK / 2)
        work = self.window_seconds(fraction, own, ghosts, blocks.neighbors(), self.contact[fraction])
        balanced = work * self.imbalance_of(own, ghosts, blocks.domains)
        failed = self.failures[fraction].at(halo, is_cautious) * blocks.area() if may_fail else 0
        failed *= failures_by_window(own, blocks)
        computing = balanced * (1 + failed * (1 + self.undo))
        sent = self.sent[fraction] * ghosts * own
        waiting = network.seconds(blocks.domains, blocks.neighbors(), sent) * (1 + failed)
        return {
            "speed_up": own * blocks.domains * self.contact[fraction] / (computing + waiting),
            "halo": halo,
            "side": blocks.least_side(),
            "ghosts": blocks.ghosts(halo + SLACK / 2),
            "imbalance": balanced / work,
            "failed": failed,
            "sent": sent,
            "waiting": waiting / (computing + waiting),
        }

    def best(self, blocks: Blocks, network: Network, is_cautious: bool = False) -> Row:
        """With the depth of halos that makes it fastest."""
        halos = [HALO + 0.25 * step for step in range(8)]
        predictions = (self.predict(blocks, halo, network, is_cautious) for halo in halos)
        return max(predictions, key=lambda row: row["speed_up"])


def terms(own: float, ghosts: float, neighbors: float) -> np.ndarray:
    return np.array([own * (1 + ghosts), own * ghosts, own * ghosts * neighbors, 1])


def unevenness(own: float, ghosts: float, domains: int) -> float:
    return math.sqrt(2 * math.log(domains) / (own * (1 + ghosts)))


def fit(rows: Sequence[Row]) -> Model:
    timed = timed_rows(rows)
    work = {fraction: fit_work(timed, fraction) for fraction in PACKING_FRACTIONS}
    uneven = np.array([unevenness(contacts(row), redundancy(row), row["domains"]) for row in timed])
    lost = np.array([critical_seconds(row) / domain_seconds(row) - 1 for row in timed])
    return Model(
        work={fraction: found for fraction, (found, _) in work.items()},
        work_error={fraction: error for fraction, (_, error) in work.items()},
        contact={fraction: contact_seconds(timed, fraction) for fraction in PACKING_FRACTIONS},
        ghost_contacts=float(np.median([redundancy(row) / row["ghosts_per_sphere"] for row in timed])),
        imbalance=float(uneven @ lost / (uneven @ uneven)),
        failures={fraction: failure_rate(rows, fraction) for fraction in PACKING_FRACTIONS},
        undo=float(np.median([row["undo_seconds_per_domain"] / domain_seconds(row) for row in timed])),
        sent={fraction: bytes_sent(timed, fraction) for fraction in PACKING_FRACTIONS},
    )


def fit_work(timed: Sequence[Row], fraction: float) -> tuple[np.ndarray, float]:
    """The costs, and the root mean square of the relative errors."""
    matrix, excess = [], []
    for row in timed:
        if row["packing_fraction"] != fraction:
            continue
        own, ghosts, seconds = contacts(row), redundancy(row), domain_seconds(row)
        matrix.append(terms(own, ghosts, row["neighbors"]) / seconds)
        excess.append(1 - own * (1 + ghosts) * seconds_per_contact(row) / seconds)
    work = least_squares_not_negative(np.array(matrix), np.array(excess))
    errors = np.array(matrix) @ work - np.array(excess)
    return work, float(np.sqrt(np.mean(errors**2)))


def contact_seconds(timed: Sequence[Row], fraction: float) -> float:
    """Of one engine with as many spheres as were measured."""
    rows = [row for row in timed if row["packing_fraction"] == fraction]
    largest = max(row["spheres"] for row in rows)
    return min(seconds_per_contact(row) for row in rows if row["spheres"] == largest)


def bytes_sent(timed: Sequence[Row], fraction: float) -> float:
    """For a contact of a ghost."""
    rows = [row for row in timed if row["packing_fraction"] == fraction]
    return float(np.median([bytes_per_window(row) / (redundancy(row) * contacts(row)) for row in rows]))


def least_squares_not_negative(matrix: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Drops the terms that would be negative."""
    kept = list(range(matrix.shape[1]))
    while True:
        found = np.linalg.lstsq(matrix[:, kept], wanted, rcond=None)[0]
        if (found >= 0).all():
            break
        kept.pop(int(np.argmin(found)))
    values = np.zeros(matrix.shape[1])
    values[kept] = found
    return values


@dataclass
class FailureRate:
    """The number of failures, for a window and a square diameter of frontier, falls exponentially with the halo."""

    likely: tuple[float, float]  # logarithm at the depth HALO, and decay for a diameter
    cautious: tuple[float, float]  # with the slowest decay that the counts allow

    def at(self, halo: float, is_cautious: bool) -> float:
        logarithm, decay = self.cautious if is_cautious else self.likely
        return math.exp(logarithm - decay * (halo - HALO))


def failure_rate(rows: Sequence[Row], fraction: float) -> FailureRate:
    counted = [row for row in rows if "sum_seconds" not in row and row["packing_fraction"] == fraction]
    places = np.array([row["halo"] - HALO for row in counted])
    areas = np.array([blocks_of(row).area() * failures_by_window(contacts(row), blocks_of(row)) for row in counted])
    exposures = areas * np.array([row["windows"] for row in counted])
    failed = np.array([row["failed"] for row in counted])

    def of_decay(decay: float) -> tuple[float, tuple[float, float]]:
        """How unlikely the counts are, by Poisson's distribution, at the likeliest rate; and rate and decay."""
        weights = exposures * np.exp(-decay * places)
        # One half, so that a rate is not zero because no failure was seen.
        rate = (failed.sum() + 0.5) / weights.sum()
        expected = rate * weights
        return float((expected - failed * np.log(expected)).sum()), (math.log(rate), decay)

    # A factor of a thousand within a diameter is the most that is believed.
    tried = [of_decay(0.1 * step) for step in range(70)]
    least, likely = min(tried)
    # Likelihoods within two standard deviations.
    cautious = next(rate for unlikeliness, rate in tried if unlikeliness < least + 2)
    return FailureRate(likely, cautious)


# --- tables -----------------------------------------------------------------------------------------------------

SIZES = [1e6, 1e8, 1e9]
DOMAINS = [8, 64, 1024]


def markdown(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    for number, row in enumerate(rows):
        yield "| " + " | ".join(row) + " |"
        if number == 0:
            yield "|" + "---:|" * len(row)


def timed_rows(rows: Sequence[Row]) -> list[Row]:
    timed = [row for row in rows if "sum_seconds" in row]
    return sorted(timed, key=lambda row: (row["packing_fraction"], row["spheres"], row["domains"]))


def place(row: Row) -> list[str]:
    return [f"{row['spheres']:,}", f"{row['packing_fraction']:.2f}".lstrip("0"), str(row["domains"])]


def measured_table(rows: Sequence[Row], model: Model) -> Iterator[str]:
    table = [
        ["spheres", "packing fraction", "domains", "side", "ghosts", "all domains over one engine"]
        + ["by the model", "slowest domain over mean", "by the model", "one engine over critical path"]
    ]
    for row in timed_rows(rows):
        own, ghosts = contacts(row), redundancy(row)
        predicted = model.window_seconds(
            row["packing_fraction"], own, ghosts, row["neighbors"], seconds_per_contact(row)
        )
        one = one_engine_seconds(row)
        table.append(
            place(row)
            + [f"{blocks_of(row).least_side():.0f}", f"{row['ghosts_per_sphere']:.2f}"]
            + [f"{domain_seconds(row) * row['domains'] / one:.2f}", f"{predicted * row['domains'] / one:.2f}"]
            + [f"{critical_seconds(row) / domain_seconds(row):.2f}"]
            + [f"{model.imbalance_of(own, ghosts, row['domains']):.2f}", f"{one / critical_seconds(row):.2f}"]
        )
    yield from markdown(table)


def step_table(rows: Sequence[Row]) -> Iterator[str]:
    steps = ["run", "verify", "doubt", "commit", "receive"]
    table = [["spheres", "packing fraction", "domains", *steps, "watch", "one engine", "journal"]]
    for row in timed_rows(rows):
        handled = row["handled_contacts"]
        watch = row["watch_seconds_per_domain"] / row["windows_per_watch"] * row["windows"] * row["domains"]
        seconds = [row["steps"][step]["sum_seconds"] for step in steps]
        table.append(
            place(row)
            + [f"{each / handled * 1e9:.0f}" for each in [*seconds, watch]]
            + [f"{seconds_per_contact(row) * 1e9:.0f}"]
            + [f"{row['one_engine_with_journal_seconds'] / row['one_engine_seconds']:.2f}"]
        )
    yield from markdown(table)


def failure_table(rows: Sequence[Row]) -> Iterator[str]:
    counted = [row for row in rows if "sum_seconds" not in row]
    halos = sorted({row["halo"] for row in counted})
    table = [["packing fraction", *(f"halo {halo:.2f}" for halo in halos)]]
    for fraction in PACKING_FRACTIONS:
        cells = []
        for halo in halos:
            here = [row for row in counted if (row["packing_fraction"], row["halo"]) == (fraction, halo)]
            cells.append(f"{sum(row['failed'] for row in here)} of {sum(row['windows'] for row in here):,}")
        table.append([f"{fraction:.2f}".lstrip("0"), *cells])
    yield from markdown(table)


def is_reasonable(predicted: Row, blocks: Blocks) -> bool:
    return predicted["side"] >= LEAST_SIDE and predicted["speed_up"] > blocks.domains / 4


def prediction_table(model: Model, network: Network) -> Iterator[str]:
    table = [
        ["spheres", "packing fraction", "domains", "side", "halo", "ghosts", "imbalance", "failed windows, %"]
        + ["communication, %", "speed-up", "at least", f"with halos of {HALO}", "if none failed"]
    ]
    for spheres in SIZES:
        for fraction in PACKING_FRACTIONS:
            for domains in DOMAINS:
                blocks = Blocks(spheres, fraction, domains)
                best = model.best(blocks, network)
                least = model.best(blocks, network, is_cautious=True)["speed_up"]
                fixed = model.predict(blocks, HALO, network)["speed_up"]
                sound = model.predict(blocks, HALO, network, may_fail=False)["speed_up"]
                mark = "" if is_reasonable(best, blocks) else " *"
                table.append(
                    [f"{spheres:,.0f}", f"{fraction:.2f}".lstrip("0"), f"{domains:,}"]
                    + [f"{best['side']:.0f}", f"{best['halo']:.2f}", f"{best['ghosts']:.2f}"]
                    + [f"{best['imbalance']:.2f}", f"{100 * best['failed']:.1f}"]
                    + [f"{100 * best['waiting']:.1f}", to_text(best["speed_up"]) + mark]
                    + [to_text(min(least, best["speed_up"])), to_text(fixed), to_text(sound)]
                )
    yield from markdown(table)


def to_text(speed_up: float) -> str:
    return f"{speed_up:.1f}" if speed_up < 10 else f"{speed_up:.0f}"


def report(results: Row, figure: Path | None) -> None:
    rows, network = results["rows"], Network()
    model = fit(rows)
    print(f"{results['processor']}, commit {results['commit'][:12]}, {results['date']}\n")
    print("\n".join(measured_table(rows, model)) + "\n")
    print("Nanoseconds for each contact that a domain handles:\n\n" + "\n".join(step_table(rows)) + "\n")
    print("Windows that failed:\n\n" + "\n".join(failure_table(rows)) + "\n")
    heads = ["packing fraction", "t, ns", "q_1, ns", "q_2, ns", "q_3, ns", "q_0, µs", "error of work, %", "p", "decay"]
    costs = [heads]
    for fraction in PACKING_FRACTIONS:
        work, rate = model.work[fraction], model.failures[fraction]
        costs.append(
            [f"{fraction:.2f}".lstrip("0"), f"{model.contact[fraction] * 1e9:.0f}"]
            + [f"{each * 1e9:.0f}" for each in work[:3]]
            + [f"{work[3] * 1e6:.0f}", f"{100 * model.work_error[fraction]:.0f}"]
            + [f"{math.exp(rate.likely[0]):.1e}", f"{rate.cautious[1]:.1f} to {rate.likely[1]:.1f}"]
        )
    print("\n".join(markdown(costs)))
    print(f"\ng = {model.ghost_contacts:.2f}, a = {model.imbalance:.2f}, u = {model.undo:.2f}")
    print("bytes for a contact of a ghost: " + ", ".join(f"{sent:.0f} at {at}" for at, sent in model.sent.items()))
    print(f"{network}\n")
    print("\n".join(prediction_table(model, network)))
    if figure:
        draw(rows, model, network, figure)


def draw(rows: Sequence[Row], model: Model, network: Network, figure: Path) -> None:
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams |= {"svg.fonttype": "none", "svg.hashsalt": "parallel_model", "font.family": "sans-serif"}
    from matplotlib import pyplot

    drawing, axes = pyplot.subplots(1, 3, figsize=(11, 4), sharey=True, constrained_layout=True)
    counts = [2**power for power in range(1, 13)]
    for axis, fraction in zip(axes, PACKING_FRACTIONS):
        axis.plot(counts, counts, color="#999999", linewidth=0.8, linestyle="--")
        for spheres, color in zip(SIZES, ("#d55e00", "#0072b2", "#009e73")):
            shown = [count for count in counts if Blocks(spheres, fraction, count).least_side() >= LEAST_SIDE]
            speed_ups = [model.best(Blocks(spheres, fraction, count), network)["speed_up"] for count in shown]
            axis.plot(shown, speed_ups, color=color, label=f"{spheres:,.0f}, model")
        largest = 1_000_188  # the nearest to the least size
        at_fraction = [row for row in timed_rows(rows) if row["packing_fraction"] == fraction]
        points = [row for row in at_fraction if row["spheres"] == largest]
        axis.plot(
            [row["domains"] for row in points],
            [one_engine_seconds(row) / critical_seconds(row) for row in points],
            "o", color="#d55e00", markersize=5, label=f"{largest:,}, measured",
        )  # fmt: skip
        axis.set(xscale="log", yscale="log", title=f"packing fraction {fraction}", xlabel="domains")
        axis.grid(which="major", color="#dddddd", linewidth=0.6)
    axes[0].set_ylabel("speed-up over one engine")
    axes[0].legend(frameon=False)
    drawing.savefig(figure, metadata={"Date": None})


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=["measure", "report"])
    parser.add_argument("file", type=Path)
    parser.add_argument("--program", type=Path, default=PROGRAM, help="default: build/bench/bench/critical_path")
    parser.add_argument("--figure", type=Path, help="where to draw the speed-ups")
    options = parser.parse_args()
    if options.command == "measure":
        measure(options.file, options.program)
    else:
        report(json.loads(options.file.read_text()), options.figure)
    return 0


if __name__ == "__main__":
    sys.exit(main())
