#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Tests that bench/parallel_model.py finds the model by which measurements were made up."""

import itertools
import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "bench"))

import parallel_model  # noqa: E402
from parallel_model import Blocks  # noqa: E402

WORK = (50e-9, 700e-9, 30e-9, 5e-6)  # per contact, of a ghost, for a neighbor, per window
CONTACT = 800e-9
WINDOWS = 10


def timed(spheres, fraction, domains):
    blocks = Blocks(spheres, fraction, domains)
    own = parallel_model.WINDOW / 2 * spheres / domains
    ghosts = 0.8 * blocks.ghosts(parallel_model.HALO)
    handled = own * (1 + ghosts)
    work = handled * (CONTACT + WORK[0]) + own * ghosts * (WORK[1] + WORK[2] * blocks.neighbors()) + WORK[3]
    slowest = work * (1 + 1.5 * math.sqrt(2 * math.log(domains) / handled))
    return {
        "spheres": spheres, "packing_fraction": fraction, "domains": domains, "halo": parallel_model.HALO,
        "windows": WINDOWS, "failed": 0, "contacts": WINDOWS * domains * own,
        "handled_contacts": WINDOWS * domains * handled, "ghosts_per_sphere": blocks.ghosts(parallel_model.HALO),
        "neighbors": blocks.neighbors(), "sum_seconds": WINDOWS * domains * work,
        "critical_seconds": WINDOWS * slowest, "watch_seconds_per_domain": 0, "windows_per_watch": 64,
        "one_engine_seconds": WINDOWS * domains * own * CONTACT,
        "undo_seconds_per_domain": 2 * work,
        "bytes_per_window_and_domain": {"records": 300 * own * ghosts},
    }  # fmt: skip


def counted(fraction, halo, failed, length=1):
    """Of windows that are so many times as long as usual."""
    place = {"spheres": 256000, "packing_fraction": fraction, "domains": 64}
    contacts = 500 * length * parallel_model.WINDOW / 2 * 256000
    return place | {"halo": halo, "windows": 500, "failed": failed, "contacts": contacts}


def measurements():
    rows = []
    for fraction in parallel_model.PACKING_FRACTIONS:
        rows += [timed(n, fraction, d) for n in (10**5, 10**6) for d in (2, 4, 8, 16, 32, 64)]
        rows += [counted(fraction, 1.75, 1000), counted(fraction, 2.0, round(1000 * math.exp(-1)))]
    return rows


class Geometry(unittest.TestCase):
    def test_neighbors_are_the_blocks_around(self):
        for domains in (2, 4, 8, 16, 32, 64, 128, 1024):
            blocks = Blocks(1e6, 0.25, domains)
            self.assertEqual(math.prod(blocks.parts()), domains)
            around = {
                tuple(step % parts for step, parts in zip(steps, blocks.parts()))
                for steps in itertools.product((-1, 0, 1), repeat=3)
            }
            self.assertEqual(blocks.neighbors(), len(around) - 1)

    def test_ghosts_fill_the_halo(self):
        blocks = Blocks(1e6, 0.25, 64)
        side = blocks.least_side()
        self.assertAlmostEqual(blocks.ghosts(2) * side**3, (side + 4) ** 3 - side**3, 6)
        # Six faces of a block, each of which is that of another, too.
        self.assertAlmostEqual(blocks.area(), 64 * 3 * side**2, 6)

    def test_packing_fraction(self):
        blocks = Blocks(1e6, 0.25, 8)
        self.assertAlmostEqual(1e6 * math.pi / 6 / blocks.edge() ** 3, 0.25)


class Fit(unittest.TestCase):
    def test_it_finds_the_model(self):
        model = parallel_model.fit(measurements())
        for fraction in parallel_model.PACKING_FRACTIONS:
            for found, true in zip(model.work[fraction], WORK):
                self.assertAlmostEqual(found / true, 1, 6)
            self.assertLess(model.work_error[fraction], 1e-9)
        self.assertAlmostEqual(model.imbalance, 1.5)
        self.assertAlmostEqual(model.ghost_contacts, 0.8)
        self.assertAlmostEqual(model.undo, 2)
        self.assertAlmostEqual(model.sent[0.25], 300)

    def test_failures_fall_with_the_halo(self):
        rate = parallel_model.failure_rate(measurements(), 0.25)
        area = 500 * Blocks(256000, 0.25, 64).area()
        # By a factor of e within a quarter of a diameter.
        self.assertAlmostEqual(rate.at(1.75, False) * area / 1000, 1, 2)
        self.assertAlmostEqual(rate.at(2.0, False) * area / 1000, math.exp(-1), 2)
        self.assertGreater(rate.at(2.25, True), rate.at(2.25, False))

    def test_failures_grow_with_the_window(self):
        rows = [counted(0.25, 1.75, 1000), counted(0.25, 2.0, 368)]
        longer = [counted(0.25, 1.75, round(1000 * 2**2.5), 2), counted(0.25, 2.0, round(368 * 2**2.5), 2)]
        usual = parallel_model.failure_rate(rows, 0.25)
        self.assertAlmostEqual(parallel_model.failure_rate(longer, 0.25).at(1.75, False) / usual.at(1.75, False), 1, 2)

    def test_small_domains_have_longer_windows(self):
        def contacts(spheres, fraction, domains):
            return parallel_model.contacts_in_window(Blocks(spheres, fraction, domains))

        self.assertAlmostEqual(contacts(1e6, 0.25, 8), 1250)
        self.assertAlmostEqual(contacts(1e6, 0.25, 64), 256)
        self.assertAlmostEqual(contacts(1e6, 0.25, 1024), 1e6 / 1024 * 0.02)
        # In a dilute gas they would fly too far: by a tenth of a diameter in windows of .018.
        self.assertAlmostEqual(contacts(1e6, 0.02, 1024), 1e6 / 1024 * 0.01)

    def test_few_failures_leave_the_decay_open(self):
        few = parallel_model.failure_rate([counted(0.25, 1.75, 4), counted(0.25, 2.0, 0)], 0.25)
        many = parallel_model.failure_rate([counted(0.25, 1.75, 400), counted(0.25, 2.0, 0)], 0.25)
        self.assertLess(few.cautious[1], few.likely[1] - 1)
        self.assertLess(few.cautious[1], many.cautious[1])

    def test_communication_and_failures_cost_time(self):
        model = parallel_model.fit(measurements())
        blocks = Blocks(1e8, 0.25, 1024)
        free = parallel_model.Network(latency=0, overhead=0, bandwidth=math.inf)
        network = parallel_model.Network()
        alone = model.predict(blocks, 1.75, free)["speed_up"]
        told = model.predict(blocks, 1.75, network)["speed_up"]
        best = model.best(blocks, network)["speed_up"]
        self.assertLess(told, alone)
        self.assertGreaterEqual(best, told)
        self.assertLess(best, 1024)
        without_failures = model.predict(blocks, 1.75, network, may_fail=False)
        self.assertEqual(without_failures["failed"], 0)
        self.assertLess(told, without_failures["speed_up"])


if __name__ == "__main__":
    unittest.main()
