// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kPathNumbers } from '../recording/chunk.js';

const kMostIntervals = 8;
const kContactsOfInterval = 200;
const kFewestContacts = 50; // a chunk that was closed early may hold too few for a rate

/**
 * What happens in a chunk, in intervals of equal length: a list of {time, collisions, walls, energy}, the rates
 * [1/T] about `time` and the kinetic energy [M L^2 T^-2] there. `begin` [T] is that of the recording.
 * Cost: O(spheres + contacts).
 */
export function summarize(chunk, masses, begin) {
  const count = Math.max(1, Math.min(kMostIntervals, Math.floor(chunk.contacts / kContactsOfInterval)));
  const length = (chunk.end - chunk.begin) / count;
  if (!(length > 0) || (chunk.contacts < kFewestContacts && chunk.begin > begin)) return [];

  const spheres = masses.length;
  const energies = new Float64Array(spheres);
  let energy = 0;
  for (let id = 0; id < spheres; ++id) {
    energies[id] = kineticEnergy(masses[id], chunk.keyframe, kPathNumbers * id + 3);
    energy += energies[id];
  }
  const change = (id, place) => {
    const after = kineticEnergy(masses[id], chunk.numbers, place + 3);
    energy += after - energies[id];
    energies[id] = after;
  };

  const intervals = [];
  let k = 0;
  for (let n = 0; n < count; ++n) {
    const middle = chunk.begin + (n + 0.5) * length;
    const end = n + 1 === count ? Infinity : chunk.begin + (n + 1) * length;
    let collisions = 0;
    let walls = 0;
    let energyThere = NaN;
    for (; k < chunk.contacts && chunk.time(k) <= end; ++k) {
      if (Number.isNaN(energyThere) && chunk.time(k) > middle) energyThere = energy;
      change(chunk.first(k), chunk.firstPlace(k));
      if (chunk.second(k) >= 0) {
        change(chunk.second(k), chunk.secondPlace(k));
        ++collisions;
      } else {
        ++walls;
      }
    }
    if (Number.isNaN(energyThere)) energyThere = energy;
    intervals.push({
      time: middle,
      collisions: collisions / length,
      walls: walls / length,
      energy: energyThere,
    });
  }
  return intervals;
}

function kineticEnergy(mass, numbers, start) {
  return (mass * (numbers[start] ** 2 + numbers[start + 1] ** 2 + numbers[start + 2] ** 2)) / 2;
}
