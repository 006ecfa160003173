// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kPathNumbers } from '../recording/chunk.js';

const kMostIntervals = 8;
const kContactsOfInterval = 200;
const kFewestContacts = 50; // a chunk that was closed early may hold too few for a rate

/**
 * What happens in a chunk, in intervals of equal length: a list of {time, collisions, walls, energy}, the rates
 * [1/T] about `time` and the energy [M L^2 T^-2] there: the kinetic one and that of the height under `gravity`
 * [L/T²]. `begin` [T] is that of the recording.
 * Cost: O(spheres + contacts).
 */
export function summarize(chunk, masses, begin, gravity = [0, 0, 0]) {
  const count = Math.max(1, Math.min(kMostIntervals, Math.floor(chunk.contacts / kContactsOfInterval)));
  const length = (chunk.end - chunk.begin) / count;
  if (!(length > 0) || (chunk.contacts < kFewestContacts && chunk.begin > begin)) return [];

  const spheres = masses.length;
  const energies = new Float64Array(spheres);
  let energy = 0;
  for (let id = 0; id < spheres; ++id) {
    energies[id] = energyOf(masses[id], chunk.keyframe, kPathNumbers * id, gravity);
    energy += energies[id];
  }
  const change = (id, place) => {
    const after = energyOf(masses[id], chunk.numbers, place, gravity);
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
      if (chunk.isWall(k)) {
        ++walls;
      } else if (chunk.isCollision(k)) {
        change(chunk.second(k), chunk.secondPlace(k));
        ++collisions;
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

// Between contacts it does not change. Position and velocity are in `numbers` from `start` on.
function energyOf(mass, numbers, start, gravity) {
  let energy = 0;
  for (let axis = 0; axis < 3; ++axis)
    energy += mass * (numbers[start + 3 + axis] ** 2 / 2 - gravity[axis] * numbers[start + axis]);
  return energy;
}
