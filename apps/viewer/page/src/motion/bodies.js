// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kBodyNumbers, kPathNumbers } from '../recording/chunk.js';

/** The orientation that follows `orientation` when a sphere turns for `duration` [T] with the spin (x, y, z) [1/T]. */
export function turned([i, j, k, real], [x, y, z], duration) {
  const rate = Math.hypot(x, y, z);
  if (rate === 0) return [i, j, k, real];
  const half = (rate * duration) / 2;
  const sine = Math.sin(half) / rate;
  const cosine = Math.cos(half);
  const [a, b, c] = [sine * x, sine * y, sine * z];
  return [
    cosine * i + real * a + b * k - c * j,
    cosine * j + real * b + c * i - a * k,
    cosine * k + real * c + a * j - b * i,
    cosine * real - a * i - b * j - c * k,
  ];
}

/** What the spheres are at one time, by id, and how they turn. One that has become part of another, or was removed, has no radius. */
export class Bodies {
  /** Those of a recording's start: radii [L] and masses [M]. */
  constructor(radii, masses) {
    /** At the time shown [L]. */
    this.radii = Float64Array.from(radii);
    /** Without growth [L]. */
    this.baseRadii = Float64Array.from(radii);
    /** What they are multiplied by. */
    this.scale = 1;
    /** [M]; infinite for kinematic spheres. */
    this.masses = Float64Array.from(masses);
    /** Of inertia, over mass and squared radius. */
    this.moments = new Float64Array(radii.length).fill(0.4);
    /** Shape (spheres, 3) [1/T]. */
    this.spins = new Float64Array(3 * radii.length);
    /** When the sphere's path started: quaternions, the real part last; shape (spheres, 4). */
    this.orientations = new Float64Array(4 * radii.length);
    for (let id = 0; id < radii.length; ++id) this.orientations[4 * id + 3] = 1;
    /** How many spheres there are. */
    this.count = this.radii.reduce((count, radius) => count + (radius > 0 ? 1 : 0), 0);
  }

  setRadius(id, base) {
    this.baseRadii[id] = base;
    this.radii[id] = this.scale * base;
  }

  /** Gives all spheres the sizes of a moment of growth. */
  scaleTo(scale) {
    if (scale === this.scale) return;
    this.scale = scale;
    for (let id = 0; id < this.radii.length; ++id) this.radii[id] = scale * this.baseRadii[id];
  }

  exists(id) {
    return this.radii[id] > 0;
  }

  isKinematic(id) {
    return this.masses[id] === Infinity;
  }

  spin(id) {
    return this.spins.subarray(3 * id, 3 * id + 3);
  }

  /** The orientation of sphere `id` after `elapsed` [T] on its path. */
  orientation(id, elapsed) {
    return turned(this.orientations.subarray(4 * id, 4 * id + 4), this.spin(id), elapsed);
  }

  /** Takes over all `bodies` of a chunk; null: they stay as they are. */
  set(bodies) {
    if (!bodies) return;
    this.count = 0;
    for (let id = 0; id < this.radii.length; ++id) {
      const start = kBodyNumbers * id;
      this.spins.set(bodies.subarray(start, start + 3), 3 * id);
      this.orientations.set(bodies.subarray(start + 3, start + 7), 4 * id);
      this.setRadius(id, bodies[start + 7]);
      this.masses[id] = bodies[start + 8];
      this.moments[id] = bodies[start + 9];
      if (this.exists(id)) ++this.count;
    }
  }

  /** Lets contact `k` of `chunk` happen, which has bodies. `paths`: those before it. */
  pass(chunk, k, paths) {
    const first = chunk.first(k);
    const second = chunk.second(k);
    const turn = (id, place) => {
      const elapsed = chunk.time(k) - paths[kPathNumbers * id + 6];
      this.orientations.set(this.orientation(id, elapsed), 4 * id);
      this.spins.set(chunk.numbers.subarray(place + 6, place + 9), 3 * id);
    };
    turn(first, chunk.firstPlace(k));
    if (chunk.isMerger(k)) {
      const place = chunk.secondPlace(k) + 3;
      const [radius, mass, moment] = chunk.numbers.subarray(place, place + 3);
      this.setRadius(first, radius);
      [this.masses[first], this.moments[first]] = [mass, moment];
      this.remove(second);
    } else if (chunk.isCollision(k)) {
      turn(second, chunk.secondPlace(k));
    }
  }

  remove(id) {
    this.setRadius(id, 0);
    this.masses[id] = 0;
    this.spins.fill(0, 3 * id, 3 * id + 3);
    --this.count;
  }
}
