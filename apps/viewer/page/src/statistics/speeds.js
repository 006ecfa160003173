// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kPathNumbers } from '../recording/chunk.js';

/**
 * Groups spheres of equal radius and mass: `of` gives the kind of each sphere, `list` what they are. Spheres without
 * a radius do not exist.
 */
export function findKinds(radii, masses) {
  const numbers = new Map();
  const of = new Uint16Array(radii.length);
  const list = [];
  for (let id = 0; id < radii.length; ++id) {
    if (radii[id] === 0) continue;
    const key = `${radii[id]} ${masses[id]}`;
    let number = numbers.get(key);
    if (number === undefined && list.length < 0xffff) {
      number = list.length;
      numbers.set(key, number);
      list.push({ radius: radii[id], mass: masses[id], count: 0 });
    }
    of[id] = number ?? 0;
    ++list[of[id]].count;
  }
  return { of, list };
}

/** The species that the header of a recording names, as findKinds; null if it names none. */
export function readSpecies({ species, spheres }) {
  if (!species) return null;
  const of = new Uint16Array(spheres);
  const list = (species.names ?? []).map((name) => ({ name, count: 0 }));
  let id = 0;
  for (const [number, length] of species.runs ?? [[0, spheres]]) {
    while (list.length <= number) list.push({ name: `species ${list.length}`, count: 0 });
    of.fill(number, id, id + length);
    list[number].count += length;
    id += length;
  }
  return { of, list };
}

/**
 * Writes the speeds at `time` [T] of all spheres that exist and are not kinematic into `speeds` [L/T]; returns how
 * many there are, and their kinetic energy.
 */
export function readSpeeds(paths, time, masses, box, speeds) {
  let energy = 0;
  let count = 0;
  const [x, y, z] = box.gravity;
  for (let id = 0; id < masses.length; ++id) {
    if (masses[id] === 0 || masses[id] === Infinity) continue;
    const start = kPathNumbers * id + 3;
    const elapsed = time - paths[start + 3];
    const square =
      (paths[start] + elapsed * x) ** 2 +
      (paths[start + 1] + elapsed * y) ** 2 +
      (paths[start + 2] + elapsed * z) ** 2;
    energy += (masses[id] * square) / 2;
    speeds[count++] = Math.sqrt(square);
  }
  return { count, energy };
}

/** The share of `values` in each of `count` even intervals from 0 to `end`, divided by their length: a density. */
export function density(values, end, count) {
  const shares = new Float64Array(count);
  for (const value of values) {
    const interval = Math.floor((value / end) * count);
    if (interval < count) shares[interval] += count / (end * values.length);
  }
  return shares;
}

/**
 * The density of speeds in equilibrium [T/L]: 4π v² (m/2πkT)^{3/2} exp(−m v²/2kT), in two dimensions
 * 2π v (m/2πkT) exp(−m v²/2kT), the mean over all `kinds` of spheres that are not kinematic. Source: Maxwell, 1860.
 */
export function maxwellDensity(speed, kinds, temperature, dimensions = 3) {
  let spheres = 0;
  let sum = 0;
  for (const { mass, count } of kinds) {
    if (mass === Infinity) continue;
    const a = mass / (2 * temperature);
    const shell = dimensions === 2 ? 2 * Math.PI * speed : 4 * Math.PI * speed ** 2;
    sum += count * shell * (a / Math.PI) ** (dimensions / 2) * Math.exp(-a * speed ** 2);
    spheres += count;
  }
  return sum / spheres;
}

/** A round number not below `value`: 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6 or 8 times a power of ten. */
export function roundUp(value) {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  const digit = [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10].find(
    (digit) => digit * power >= value * (1 - 1e-12),
  );
  return digit * power;
}

/** The value below which the share `share` of `values` lies; sorts a sample of them. */
export function quantile(values, share) {
  const step = Math.ceil(values.length / 4096);
  const sample = Float64Array.from(
    { length: Math.ceil(values.length / step) },
    (_, k) => values[k * step],
  ).sort();
  return sample[Math.min(sample.length - 1, Math.floor(share * sample.length))];
}
