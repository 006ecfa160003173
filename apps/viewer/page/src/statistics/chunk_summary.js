// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kBodyNumbers, kPathNumbers } from '../recording/chunk.js';

const kMostIntervals = 8;
const kContactsOfInterval = 200;
const kFewestContacts = 50; // a chunk that was closed early may hold too few for a rate

/**
 * What happens in a chunk, in intervals of equal length: a list of {time, collisions, walls, energy}, the rates
 * [1/T] about `time` and the energy [M L^2 T^-2] there: that of translation and rotation, and of the height under
 * `gravity` [L/T²]; kinematic spheres have none. Spheres that pass through each other do not count as a collision. `begin` [T]
 * is that of the recording. Of a chunk that is a moment (`isMoment`) only the energy at its begin is known.
 * Cost: O(spheres + contacts).
 */
export function summarize(chunk, masses, begin, gravity = [0, 0, 0], isMoment = false) {
  const count = Math.max(1, Math.min(kMostIntervals, Math.floor(chunk.contacts / kContactsOfInterval)));
  const length = (chunk.end - chunk.begin) / count;
  if (isMoment) return [{ time: chunk.begin, collisions: null, walls: null, energy: energyAtBegin(chunk, masses, gravity) }];
  if (!(length > 0) || (chunk.contacts < kFewestContacts && chunk.begin > begin)) return [];

  const spheres = masses.length;
  const energies = new Float64Array(spheres);
  const { bodies } = chunk;
  const mass = Float64Array.from(masses);
  const inertia = new Float64Array(spheres);
  const describe = (id, numbers, place) => {
    const [radius, itsMass, moment] = numbers.subarray(place, place + 3);
    mass[id] = itsMass;
    inertia[id] = moment * itsMass * radius ** 2;
  };
  let energy = 0;
  const become = (id, after) => {
    energy += after - energies[id];
    energies[id] = after;
  };
  for (let id = 0; id < spheres; ++id) {
    const start = kBodyNumbers * id;
    if (bodies) describe(id, bodies, start + 7);
    const turning = bodies ? rotationalEnergy(inertia[id], bodies, start) : 0;
    become(id, energyOf(mass[id], chunk.keyframe, kPathNumbers * id, gravity) + turning);
  }
  const change = (id, place) => {
    const turning = bodies ? rotationalEnergy(inertia[id], chunk.numbers, place + 6) : 0;
    become(id, energyOf(mass[id], chunk.numbers, place, gravity) + turning);
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
      if (chunk.isPass(k)) continue;
      if (chunk.isMerger(k)) describe(chunk.first(k), chunk.numbers, chunk.secondPlace(k) + 3);
      change(chunk.first(k), chunk.firstPlace(k));
      if (chunk.isMerger(k)) become(chunk.second(k), 0);
      else if (chunk.isCollision(k)) change(chunk.second(k), chunk.secondPlace(k));
      if (chunk.isWall(k)) ++walls;
      if (chunk.isCollision(k)) ++collisions;
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

function energyAtBegin({ bodies, keyframe }, masses, gravity) {
  return masses.reduce((energy, mass, id) => {
    const start = kBodyNumbers * id;
    const [radius, itsMass, moment] = bodies ? bodies.subarray(start + 7, start + 10) : [0, mass, 0];
    const turning = bodies ? rotationalEnergy(moment * itsMass * radius ** 2, bodies, start) : 0;
    return energy + energyOf(itsMass, keyframe, kPathNumbers * id, gravity) + turning;
  }, 0);
}

// Between contacts it does not change. Position and velocity are in `numbers` from `start` on.
function energyOf(mass, numbers, start, gravity) {
  if (mass === Infinity) return 0;
  let energy = 0;
  for (let axis = 0; axis < 3; ++axis)
    energy += mass * (numbers[start + 3 + axis] ** 2 / 2 - gravity[axis] * numbers[start + axis]);
  return energy;
}

// The spin is in `numbers` from `start` on.
function rotationalEnergy(inertia, numbers, start) {
  if (inertia === Infinity) return 0;
  return (inertia * (numbers[start] ** 2 + numbers[start + 1] ** 2 + numbers[start + 2] ** 2)) / 2;
}
