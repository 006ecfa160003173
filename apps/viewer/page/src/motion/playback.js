// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kPathNumbers } from '../recording/chunk.js';
import { Bodies } from './bodies.js';
import { kBoxFaces } from './surfaces.js';

/**
 * The paths that hold at one time, and how they change as time moves.
 * Moving by a few contacts touches only their spheres.
 */
export class Playback {
  /** `spheres`: their number. `chunkAt(number)`: a chunk if it is in memory. `bodies`: at the start. */
  constructor(spheres, chunkAt, bodies = new Bodies([], [])) {
    this.chunkAt = chunkAt;
    this.spheres = spheres;
    /** Shape (spheres, kPathNumbers). */
    this.paths = new Float64Array(kPathNumbers * spheres);
    /** What the spheres are, and how they turn. */
    this.bodies = bodies;
    /** Collisions of each sphere since `countedFrom`. */
    this.collisions = new Uint32Array(spheres);
    /** [T] */
    this.countedFrom = 0;
    this.chunk = null;
    this.number = -1;
    /** How many contacts of the chunk have happened. */
    this.cursor = 0;
    /** [T] */
    this.time = NaN;
    /** The spheres whose paths have changed since they were last taken, `touchedCount` of them, perhaps twice. */
    this.touched = new Uint32Array(spheres);
    this.touchedCount = 0;
    /** Whether all paths may have changed. */
    this.allTouched = true;
    this.collisionsAtBegin = new CollisionsAtBegin();
    /** The epoch of growth; see Chunk. */
    this.epoch = { since: 0, scale: 1, rate: 0 };
    /** Whether chunks do not continue each other, as those of moments. */
    this.hasMoments = false;
    /** The surfaces of the header, which motions may drive. */
    this.surfaces = [];
  }

  /** What radii at the start are multiplied by at the time shown. */
  get scale() {
    const { since, scale, rate } = this.epoch;
    return scale + rate * (this.time - since);
  }

  /** Goes to `time` in `chunk`, which is chunk `number`. Precondition: `time` lies in it. */
  moveTo(time, chunk, number) {
    const goesOn = number === this.number + 1 && this.chunk !== null && time >= this.time && !this.hasMoments;
    if (goesOn) {
      this.pass(Infinity);
      this.collisionsAtBegin.keep(number, this.collisions);
      this.chunk = chunk;
      this.number = number;
      this.cursor = 0;
    } else if (number !== this.number || time < this.time) {
      this.enter(chunk, number);
    }
    this.pass(time);
    this.time = time;
    this.bodies.scaleTo(this.scale);
  }

  /** Clears the list of touched spheres. */
  takeTouched() {
    this.touchedCount = 0;
    this.allTouched = false;
  }

  enter(chunk, number) {
    this.paths.set(chunk.keyframe);
    this.bodies.set(chunk.bodies);
    this.epoch = chunk.epoch ?? this.epoch;
    // A chunk begins with those that have gone on otherwise before it.
    for (const surface of this.surfaces) surface.follow(null);
    this.countBefore(chunk, number);
    this.chunk = chunk;
    this.number = number;
    this.cursor = 0;
    this.allTouched = true;
  }

  /** Counts collisions from the start of the recording, if all chunks until then are in memory by now; returns whether it does. */
  recount() {
    if (this.chunk === null || this.collisionsAtBegin.first === 0) return false;
    for (let number = this.number - 1; number >= 0; --number) if (!this.chunkAt(number)) return false;
    this.collisionsAtBegin = new CollisionsAtBegin();
    this.countBefore(this.chunk, this.number);
    for (let k = 0; k < this.cursor; ++k) if (!this.chunk.isPass(k)) this.count(this.chunk, k);
    this.allTouched = true;
    return true;
  }

  // Counts the collisions before chunk `number`: from the last chunk for which they are known, if all chunks between
  // are in memory, otherwise from the first of those that are.
  countBefore(chunk, number) {
    let from = number;
    while (from > 0 && !this.collisionsAtBegin.has(from) && this.chunkAt(from - 1)) --from;
    if (!this.collisionsAtBegin.has(from)) {
      const first = from === number ? chunk : this.chunkAt(from);
      this.collisionsAtBegin.restart(from, first.begin, this.collisions.fill(0));
    }
    this.collisions.set(this.collisionsAtBegin.get(from));
    this.countedFrom = this.collisionsAtBegin.from;
    for (; from < number; ++from) {
      const passed = this.chunkAt(from);
      for (let k = 0; k < passed.contacts; ++k) this.count(passed, k);
    }
  }

  count(chunk, k) {
    if (!chunk.isCollision(k)) return;
    ++this.collisions[chunk.first(k)];
    ++this.collisions[chunk.second(k)];
  }

  // Lets all contacts of the chunk at or before `time` happen.
  pass(time) {
    const { chunk } = this;
    const { contacts } = chunk;
    while (this.cursor < contacts && chunk.time(this.cursor) <= time) {
      const k = this.cursor++;
      if (chunk.isEpoch?.(k)) this.epoch = chunk.epochOf(k);
      if (chunk.isSurface?.(k)) {
        const driven = chunk.surfaceOf(k);
        this.surfaces[driven.number - kBoxFaces]?.follow(driven);
      }
      if (chunk.isPass(k)) continue;
      if (chunk.bodies) this.bodies.pass(chunk, k, this.paths);
      const first = chunk.first(k);
      const second = chunk.second(k);
      this.store(first, chunk, chunk.firstPlace(k), chunk.time(k));
      if (chunk.isCollision(k)) this.store(second, chunk, chunk.secondPlace(k), chunk.time(k));
      if (chunk.isMerger(k)) this.paths.fill(0, kPathNumbers * second + 3, kPathNumbers * second + 6);
      this.count(chunk, k);
    }
  }

  store(id, chunk, place, time) {
    const start = kPathNumbers * id;
    for (let n = 0; n < 6; ++n) this.paths[start + n] = chunk.numbers[place + n];
    this.paths[start + 6] = time;
    if (this.touchedCount < this.touched.length) this.touched[this.touchedCount++] = id;
    else this.allTouched = true;
  }
}

const kBytesKept = 64 << 20;

// The collisions of each sphere up to the start of chunks already passed, all counted from one time, the start of chunk `first`.
class CollisionsAtBegin {
  constructor() {
    this.kept = new Map();
    this.from = 0;
    this.first = -1;
  }

  restart(number, from, collisions) {
    this.kept.clear();
    this.first = number;
    this.from = from;
    this.keep(number, collisions);
  }

  keep(number, collisions) {
    if (this.kept.has(number) || (this.kept.size + 1) * collisions.byteLength > kBytesKept) return;
    this.kept.set(number, collisions.slice());
  }

  has(number) {
    return this.kept.has(number);
  }

  get(number) {
    return this.kept.get(number);
  }
}
