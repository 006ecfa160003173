// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

import { hasItsChecksum } from './crc32.js';

/** Numbers of one path: position (3) [L], velocity (3) [L/T], start time [T]. */
export const kPathNumbers = 7;

/**
 * Numbers of one body: spin (3) [1/T]; orientation when its path starts, a quaternion whose real part is last;
 * radius [L], mass [M], and moment of inertia over mass and squared radius. All zero but the real part and the
 * moment: it does not exist.
 */
export const kBodyNumbers = 10;

const kMagic = 0x4b4e4843; // "CHNK"
const kHeadBytes = 32;
export const kChecksumBytes = 8;
const kGrowthNumbers = 3;
const kEpoch = -(2 ** 31); // in place of a contact's second sphere, where an epoch of growth begins

const kSurface = kEpoch + 1; // likewise, where a surface goes on otherwise

// Where the numbers of a contact are, without bodies and with them: how many; the offsets of those of its spheres.
const kWithoutBodies = { bodies: 0, contact: 14, first: 2, second: 8 };
const kWithBodies = { bodies: kBodyNumbers, contact: 21, first: 3, second: 12 };

function layoutOf({ bodies }) {
  return bodies ? kWithBodies : kWithoutBodies;
}

/** How many numbers a chunk has for the growth at its begin. */
function growthNumbers({ growth }) {
  return growth ? kGrowthNumbers : 0;
}

const kPass = 1;
const kMerge = 2;

/**
 * The length of the chunk at `offset` [bytes], or undefined if the buffer ends before the chunk does.
 * Error: there is no chunk of a recording with such a header.
 */
export function chunkLength(buffer, offset, header) {
  if (buffer.byteLength - offset < kHeadBytes + kChecksumBytes) return undefined;
  const { bodies, contact } = layoutOf(header);
  const view = new DataView(buffer, offset, kHeadBytes);
  const contacts = view.getUint32(4, true);
  const length = Number(view.getBigUint64(8, true));
  const numbers =
    growthNumbers(header) + (kPathNumbers + bodies) * header.spheres + contact * contacts;
  const isSound = hasItsChecksum(buffer, offset, offset + kHeadBytes);
  if (!isSound || view.getUint32(0, true) !== kMagic || length !== kHeadBytes + 8 * numbers + 2 * kChecksumBytes) {
    throw new Error(`the recording is damaged: no chunk at byte ${offset}`);
  }
  return buffer.byteLength - offset < length ? undefined : length;
}

/**
 * A part of the recording: the paths at `begin`, and all contacts in (begin, end], in order. Counted as contacts
 * are also changes of one sphere's velocity without a contact.
 * It is a view of the buffer and copies nothing.
 */
export class Chunk {
  /**
   * Precondition: `offset` is a multiple of 8. Error: there is no complete chunk of a recording with such a header;
   * it is damaged.
   */
  constructor(buffer, offset, header) {
    const length = chunkLength(buffer, offset, header);
    if (length === undefined) throw new Error('the recording is damaged: a chunk is truncated');
    const view = new DataView(buffer, offset, kHeadBytes);
    const sphereCount = header.spheres;
    this.layout = layoutOf(header);
    const body = offset + kHeadBytes + kChecksumBytes;
    const keyframe = body + 8 * growthNumbers(header);
    if (!hasItsChecksum(buffer, body, offset + length - kChecksumBytes)) {
      const begin = view.getFloat64(16, true);
      throw new Error(`the recording is damaged after time ${begin}: wrong checksum at byte ${offset}`);
    }
    const bodies = keyframe + 8 * kPathNumbers * sphereCount;
    const first = bodies + 8 * this.layout.bodies * sphereCount;
    /** Number of contacts. */
    this.contacts = view.getUint32(4, true);
    /** Length in the recording. */
    this.bytes = length;
    /** [T] */
    this.begin = view.getFloat64(16, true);
    /** [T] */
    this.end = view.getFloat64(24, true);
    /** The paths that hold at `begin`; shape (spheres, kPathNumbers). */
    this.keyframe = new Float64Array(buffer, keyframe, kPathNumbers * sphereCount);
    /** The bodies likewise, shape (spheres, kBodyNumbers); null where they stay as they were. */
    this.bodies =
      this.layout.bodies > 0 ? new Float64Array(buffer, bodies, kBodyNumbers * sphereCount) : null;
    const [since, scale, rate] = new Float64Array(buffer, body, growthNumbers(header));
    /** The epoch of growth at `begin`: since when [T], the scale of all radii then, and its rate [1/T]. */
    this.epoch = { since: since ?? 0, scale: scale ?? 1, rate: rate ?? 0 };
    this.numbers = new Float64Array(buffer, first, this.layout.contact * this.contacts);
    this.integers = new Int32Array(buffer, first, 2 * this.layout.contact * this.contacts);
  }

  /** When contact `k` happens [T]. */
  time(k) {
    return this.numbers[this.layout.contact * k];
  }

  /** The sphere of contact `k`; for a collision, the one with the lower id. */
  first(k) {
    return this.integers[2 * this.layout.contact * k + 2];
  }

  /** The other sphere of contact `k`, −(face + 1) for a wall, or the sphere itself where nothing is touched. */
  second(k) {
    return this.integers[2 * this.layout.contact * k + 3];
  }

  isWall(k) {
    return this.second(k) < 0 && !this.isEpoch(k) && !this.isSurface(k);
  }

  /** Whether an epoch of growth begins, and nothing is touched. */
  isEpoch(k) {
    return this.second(k) === kEpoch;
  }

  /** That epoch; see `epoch`. */
  epochOf(k) {
    const place = this.firstPlace(k);
    return { since: this.time(k), scale: this.numbers[place], rate: this.numbers[place + 1] };
  }

  /** Whether a surface goes on otherwise, and nothing is touched. */
  isSurface(k) {
    return this.second(k) === kSurface;
  }

  /** How: the number of the surface, from that of the first face on; since when [T] its point is at `point` [L]. */
  surfaceOf(k) {
    const place = this.firstPlace(k);
    return {
      number: this.first(k),
      since: this.time(k),
      point: [...this.numbers.subarray(place, place + 3)],
      velocity: [...this.numbers.subarray(place + 3, place + 6)],
    };
  }

  /** Whether two spheres meet, and do not pass through each other. */
  isCollision(k) {
    return !this.isWall(k) && this.second(k) !== this.first(k) && !this.isPass(k);
  }

  /** Whether no path changes: two spheres pass through each other, an epoch of growth begins, or a surface goes on. */
  isPass(k) {
    if (this.isEpoch(k) || this.isSurface(k)) return true;
    return this.bodies !== null && this.integers[2 * this.layout.contact * k + 4] === kPass;
  }

  /** Whether two spheres become one: the first. */
  isMerger(k) {
    return this.bodies !== null && this.integers[2 * this.layout.contact * k + 4] === kMerge;
  }

  /** Whether something is touched that is not passed through: by sphere `id`, unless that is null. */
  isContact(k, id = null) {
    return this.second(k) !== this.first(k) && !this.isPass(k) && (id === null || this.involves(k, id));
  }

  /** Whether sphere `id` has another path after contact `k`. */
  involves(k, id) {
    return (this.first(k) === id || this.second(k) === id) && !this.isPass(k);
  }

  /** The offset in `numbers` of position and velocity, and with bodies the spin, of the first sphere after it. */
  firstPlace(k) {
    return this.layout.contact * k + this.layout.first;
  }

  /** The same for the second sphere. Of a merger, radius, mass and moment of the first stand for the velocity. */
  secondPlace(k) {
    return this.layout.contact * k + this.layout.second;
  }

  /** How many contacts happen at or before `time`. Cost: O(log contacts). */
  contactsUntil(time) {
    let low = 0;
    let high = this.contacts;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.time(middle) <= time) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** Writes the path of sphere `id` that holds after the first `count` contacts into `path`. Cost: O(count). */
  readPath(id, count, path) {
    for (let k = count - 1; k >= 0; --k) {
      if (this.involves(k, id)) {
        this.readPathAfter(k, id, path);
        return;
      }
    }
    for (let n = 0; n < kPathNumbers; ++n) path[n] = this.keyframe[kPathNumbers * id + n];
  }

  /** Writes the path of sphere `id` that starts with contact `k` into `path`. Precondition: `id` is in it. */
  readPathAfter(k, id, path) {
    const isFirst = this.first(k) === id;
    const place = isFirst ? this.firstPlace(k) : this.secondPlace(k);
    for (let n = 0; n < 6; ++n) path[n] = this.numbers[place + n];
    if (!isFirst && this.isMerger(k)) path.fill(0, 3, 6);
    path[6] = this.time(k);
  }
}
