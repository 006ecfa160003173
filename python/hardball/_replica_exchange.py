# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Copies of a system at several temperatures, which they swap: the class ReplicaExchange."""

from __future__ import annotations

import copy
import math
import os
import random
from concurrent.futures import Executor, ThreadPoolExecutor
from typing import Any, Callable, Iterable

import numpy as np
from numpy.typing import NDArray

from ._arguments import not_negative, real_number, real_numbers, whole_number
from ._calls import ArgumentError
from ._hardball import Andersen
from ._simulation import Simulation

# Seeds of thermostats have so many bits.
SEED_BITS = 48


class ReplicaExchange:
    """Replicas of a system at several temperatures, which neighbors swap from time to time.

    A cold system with attractions may stay in one state for as long as a run lasts. Here it is warmed up, and cooled
    down again, by swaps that keep the canonical distribution at each temperature exactly. Every replica has an
    Andersen thermostat. After each interval two replicas at neighboring temperatures T and T' with potential energies
    U and U' swap temperatures with the probability min(1, exp((1/T - 1/T')(U - U'))), and their velocities are scaled
    by the square root of the ratio; even and odd neighbors take turns. Spheres must be smooth and elastic.

    The history depends on the seed alone, not on how many replicas run at once, on the executor, or on how a run is
    split. A ReplicaExchange can be pickled, and goes on from there.
    Source: Swendsen and Wang, Phys. Rev. Lett. 57 (1986) 2607; Sugita and Okamoto, Chem. Phys. Lett. 314 (1999) 141.
    """

    __slots__ = (
        "_temperatures",
        "_every",
        "_rate",
        "_random",
        "_begin",
        "_replicas",
        "_levels",
        "_attempts",
        "_accepted",
        "_times",
        "_energies",
        "_places",
        "_observed",
    )

    def __init__(
        self,
        simulation: Simulation,
        temperatures: Iterable[float],
        *,
        every: float,
        rate: float = 1.0,
        seed: int = 1,
    ) -> None:
        """Makes a replica for each temperature.

        :param simulation: the system, which is copied. Its thermostat is replaced.
        :param temperatures: kT, ascending [M L^2/T^2].
        :param every: the time between two swaps [T].
        :param rate: how often the thermostat gives each sphere a new velocity [1/T].
        :param seed: the seed of swaps and thermostats.

        Error: temperatures that are not positive and ascending; an interval that is not positive.
        """
        if not isinstance(simulation, Simulation):
            raise ArgumentError("simulation is a " + type(simulation).__name__ + "; give a Simulation")
        kept = real_numbers(temperatures, "temperatures")
        if len(kept) < 2 or kept[0] <= 0 or any(low >= high for low, high in zip(kept, kept[1:])):
            raise ArgumentError(f"temperatures are {kept}; give at least two positive numbers, ascending")
        self._temperatures = kept
        self._every = real_number(every, "every")
        if not self._every > 0:
            raise ArgumentError(f"every is {every}; give a positive time")
        self._rate = real_number(rate, "rate")
        self._random = random.Random(whole_number(seed, "seed"))
        self._begin = simulation.time
        self._replicas = [copy.copy(simulation) for _ in kept]
        # By replica, the number of its temperature.
        self._levels = list(range(len(kept)))
        self._attempts = [0] * (len(kept) - 1)
        self._accepted = [0] * (len(kept) - 1)
        self._times: list[float] = []
        self._energies: list[list[float]] = []
        self._places: list[list[int]] = []
        self._observed: list[list[Any]] = []
        for replica, level in enumerate(self._levels):
            self._set_thermostat(replica, level)

    @property
    def temperatures(self) -> NDArray[np.float64]:
        """kT of each level, ascending [M L^2/T^2], shape (levels,)."""
        return np.array(self._temperatures)

    @property
    def simulations(self) -> list[Simulation]:
        """The replica that is at each temperature now, in the order of temperatures."""
        return [self._replicas[self._levels.index(level)] for level in range(len(self._temperatures))]

    @property
    def time(self) -> float:
        """The time that all replicas have reached [T]."""
        return self._replicas[0].time

    @property
    def acceptance(self) -> NDArray[np.float64]:
        """Which fraction of the swaps of each two neighboring temperatures was made [1], shape (levels - 1,); NaN if none
        was tried."""
        return np.array([done / tried if tried else math.nan for done, tried in zip(self._accepted, self._attempts)])

    @property
    def times(self) -> NDArray[np.float64]:
        """When there were swaps [T], shape (swaps,)."""
        return np.array(self._times)

    @property
    def energies(self) -> NDArray[np.float64]:
        """The potential energy at each temperature, before each swap [M L^2/T^2], shape (swaps, levels)."""
        return np.array(self._energies).reshape(-1, len(self._temperatures))

    @property
    def places(self) -> NDArray[np.int64]:
        """The number of the replica at each temperature, before each swap, shape (swaps, levels)."""
        return np.array(self._places, dtype=np.int64).reshape(-1, len(self._temperatures))

    @property
    def observed(self) -> NDArray[Any]:
        """What `observe` has returned at each temperature, before each swap, shape (swaps, levels, ...)."""
        return np.array(self._observed)

    def run(
        self,
        until: float,
        *,
        observe: Callable[[Simulation], Any] | None = None,
        executor: Executor | None = None,
    ) -> None:
        """Runs all replicas, with swaps between them.

        :param until: the time to be reached [T].
        :param observe: called with the replica at each temperature before each swap; it returns a number, or an array.
        :param executor: a concurrent.futures.Executor, of threads or processes; if not given, as many threads as the
            machine has cores.

        Error: `until` is earlier than the time that has been reached.
        """
        until = not_negative(until, "until")
        if until < self.time:
            raise ArgumentError(f"until is {until}, and the time is already {self.time}; give a later one")
        if executor is not None:
            self._run(until, observe, executor)
            return
        with ThreadPoolExecutor(min(len(self._replicas), os.cpu_count() or 1)) as threads:
            self._run(until, observe, threads)

    def _run(self, until: float, observe: Callable[[Simulation], Any] | None, executor: Executor) -> None:
        while True:
            swap = self._begin + (len(self._times) + 1) * self._every
            reached = min(swap, until)
            futures = [executor.submit(_advanced, replica, reached) for replica in self._replicas]
            self._replicas = [future.result() for future in futures]
            if swap > until:
                return
            self._record(swap, observe)
            self._swap()

    def _record(self, time: float, observe: Callable[[Simulation], Any] | None) -> None:
        simulations = self.simulations
        self._times.append(time)
        self._energies.append([simulation.step_energy for simulation in simulations])
        self._places.append([self._levels.index(level) for level in range(len(simulations))])
        if observe is not None:
            self._observed.append([observe(simulation) for simulation in simulations])

    def _swap(self) -> None:
        energies, places = self._energies[-1], self._places[-1]
        for low in range((len(self._times) - 1) % 2, len(self._temperatures) - 1, 2):
            difference = 1 / self._temperatures[low] - 1 / self._temperatures[low + 1]
            exponent = difference * (energies[low] - energies[low + 1])
            self._attempts[low] += 1
            # Drawn in any case, so that each swap has numbers of its own.
            if self._random.random() >= math.exp(min(exponent, 0)):
                continue
            self._accepted[low] += 1
            for replica, level in ((places[low], low + 1), (places[low + 1], low)):
                self._scale(replica, self._temperatures[level] / self._temperatures[self._levels[replica]])
                self._levels[replica] = level
                self._set_thermostat(replica, level)

    def _scale(self, replica: int, ratio: float) -> None:
        simulation = self._replicas[replica]
        moves = np.isfinite(simulation.masses)
        simulation.set_velocity(simulation.ids[moves], math.sqrt(ratio) * simulation.velocities[moves])

    def _set_thermostat(self, replica: int, level: int) -> None:
        thermostat = Andersen(self._temperatures[level], self._rate)
        self._replicas[replica].set_thermostat(thermostat, self._random.getrandbits(SEED_BITS))


def _advanced(simulation: Simulation, until: float) -> Simulation:
    simulation.run(until=until)
    return simulation
