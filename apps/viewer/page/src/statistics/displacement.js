// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { placeAfter } from '../motion/path.js';
import { kPathNumbers } from '../recording/chunk.js';

const kPoints = 8; // of a chunk

/**
 * The mean squared displacement of all spheres that are not kinematic since the start, as far as the chunks have been in
 * memory one after the other. It adds up the pieces of their paths, so that it knows nothing of the faces of the box.
 */
export class Displacement {
  constructor(masses, box) {
    this.masses = masses;
    this.box = box;
    this.total = new Float64Array(3 * masses.length);
    /** The number of the chunk that comes next. */
    this.next = 0;
    /** The times [T], and the mean squares there [L²]. */
    this.times = [];
    this.squares = [];
  }

  /** Adds the next chunk. */
  add(chunk) {
    const paths = Float64Array.from(chunk.keyframe);
    // From here on a path counts from the time at which its piece began to be added.
    const since = new Float64Array(this.masses.length).fill(chunk.begin);
    const moveTo = (id, time) => {
      const start = kPathNumbers * id;
      for (let axis = 0; axis < 3; ++axis) {
        const at = (moment) => placeAfter(moment - paths[start + 6], 0, paths[start + 3 + axis], this.box.gravity[axis]);
        this.total[3 * id + axis] += at(time) - at(since[id]);
      }
      since[id] = time;
    };
    let k = 0;
    for (let point = 1; point <= kPoints; ++point) {
      const time = point === kPoints ? chunk.end : chunk.begin + (point / kPoints) * (chunk.end - chunk.begin);
      for (; k < chunk.contacts && chunk.time(k) <= time; ++k) {
        if (chunk.isPass(k)) continue;
        for (const id of chunk.isCollision(k) ? [chunk.first(k), chunk.second(k)] : [chunk.first(k)]) {
          moveTo(id, chunk.time(k));
          chunk.readPathAfter(k, id, paths.subarray(kPathNumbers * id, kPathNumbers * (id + 1)));
        }
      }
      for (let id = 0; id < this.masses.length; ++id) moveTo(id, time);
      this.times.push(time);
      this.squares.push(this.meanSquare());
    }
    ++this.next;
  }

  meanSquare() {
    let sum = 0;
    let count = 0;
    for (let id = 0; id < this.masses.length; ++id) {
      if (this.masses[id] === 0 || this.masses[id] === Infinity) continue;
      ++count;
      for (let axis = 0; axis < 3; ++axis) sum += this.total[3 * id + axis] ** 2;
    }
    return count > 0 ? sum / count : 0;
  }
}
