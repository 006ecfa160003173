// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kPathNumbers } from '../recording/chunk.js';

/** Groups spheres of equal radius and mass: `of` gives the species of each sphere, `list` what they are. */
export function findSpecies(radii, masses) {
  const numbers = new Map();
  const of = new Uint16Array(radii.length);
  const list = [];
  for (let id = 0; id < radii.length; ++id) {
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

/**
 * The speeds of all spheres at `time` [T]: the list [L/T], into which they are written, and their total kinetic
 * energy.
 */
export function readSpeeds(paths, time, masses, box, speeds) {
  let energy = 0;
  const [x, y, z] = box.gravity;
  for (let id = 0; id < speeds.length; ++id) {
    const start = kPathNumbers * id + 3;
    const elapsed = time - paths[start + 3];
    const square =
      (paths[start] + elapsed * x) ** 2 +
      (paths[start + 1] + elapsed * y) ** 2 +
      (paths[start + 2] + elapsed * z) ** 2;
    energy += (masses[id] * square) / 2;
    speeds[id] = Math.sqrt(square);
  }
  return energy;
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
 * The density of speeds in equilibrium [T/L]: 4π v² (m/2πkT)^{3/2} exp(−m v²/2kT), the mean over all species
 * at the temperature kT = 2/3 of the mean kinetic energy. Source: Maxwell, 1860.
 */
export function maxwellDensity(speed, species, temperature) {
  let spheres = 0;
  let sum = 0;
  for (const { mass, count } of species) {
    const a = mass / (2 * temperature);
    sum += count * 4 * Math.PI * speed ** 2 * (a / Math.PI) ** 1.5 * Math.exp(-a * speed ** 2);
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
