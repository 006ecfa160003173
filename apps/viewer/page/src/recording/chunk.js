// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/** Numbers of one path: position (3) [L], velocity (3) [L/T], start time [T]. */
export const kPathNumbers = 7;

const kMagic = 0x4b4e4843; // "CHNK"
const kHeadBytes = 32;
const kContactBytes = 112;
const kContactNumbers = kContactBytes / 8;
const kContactIntegers = kContactBytes / 4;

/**
 * The length of the chunk at `offset` [bytes], or undefined if the buffer ends before the chunk does.
 * Error: there is no chunk of `sphereCount` spheres.
 */
export function chunkLength(buffer, offset, sphereCount) {
  if (buffer.byteLength - offset < kHeadBytes) return undefined;
  const view = new DataView(buffer, offset, kHeadBytes);
  const contacts = view.getUint32(4, true);
  const length = Number(view.getBigUint64(8, true));
  const expected = kHeadBytes + 8 * kPathNumbers * sphereCount + kContactBytes * contacts;
  if (view.getUint32(0, true) !== kMagic || length !== expected) {
    throw new Error(`the recording is damaged: no chunk at byte ${offset}`);
  }
  return buffer.byteLength - offset < length ? undefined : length;
}

/**
 * A part of the recording: the paths at `begin`, and all contacts in (begin, end], in order. Counted as contacts
 * are also changes of one sphere's velocity without a contact.
 * It is a view of the buffer and copies nothing, so that decoding costs no time.
 */
export class Chunk {
  /** Precondition: `offset` is a multiple of 8. Error: there is no complete chunk of `sphereCount` spheres. */
  constructor(buffer, offset, sphereCount) {
    const length = chunkLength(buffer, offset, sphereCount);
    if (length === undefined) throw new Error('the recording is damaged: a chunk is truncated');
    const view = new DataView(buffer, offset, kHeadBytes);
    const keyframeNumbers = kPathNumbers * sphereCount;
    const first = offset + kHeadBytes + 8 * keyframeNumbers;
    /** Number of contacts. */
    this.contacts = view.getUint32(4, true);
    /** Length in the recording. */
    this.bytes = length;
    /** [T] */
    this.begin = view.getFloat64(16, true);
    /** [T] */
    this.end = view.getFloat64(24, true);
    /** The paths that hold at `begin`; shape (spheres, kPathNumbers). */
    this.keyframe = new Float64Array(buffer, offset + kHeadBytes, keyframeNumbers);
    this.numbers = new Float64Array(buffer, first, kContactNumbers * this.contacts);
    this.integers = new Int32Array(buffer, first, kContactIntegers * this.contacts);
  }

  /** When contact `k` happens [T]. */
  time(k) {
    return this.numbers[kContactNumbers * k];
  }

  /** The sphere of contact `k`; for a collision, the one with the lower id. */
  first(k) {
    return this.integers[kContactIntegers * k + 2];
  }

  /** The other sphere of contact `k`, −(face + 1) for a wall, or the sphere itself where nothing is touched. */
  second(k) {
    return this.integers[kContactIntegers * k + 3];
  }

  isWall(k) {
    return this.second(k) < 0;
  }

  isCollision(k) {
    return !this.isWall(k) && this.second(k) !== this.first(k);
  }

  /** Whether something is touched: by sphere `id`, unless that is null. */
  isContact(k, id = null) {
    return this.second(k) !== this.first(k) && (id === null || this.involves(k, id));
  }

  involves(k, id) {
    return this.first(k) === id || this.second(k) === id;
  }

  /** The offset in `numbers` of position and velocity of the first sphere after contact `k`. */
  firstPlace(k) {
    return kContactNumbers * k + 2;
  }

  /** The offset in `numbers` of position and velocity of the second sphere after contact `k`. */
  secondPlace(k) {
    return kContactNumbers * k + 8;
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
    const place = this.first(k) === id ? this.firstPlace(k) : this.secondPlace(k);
    for (let n = 0; n < 6; ++n) path[n] = this.numbers[place + n];
    path[6] = this.time(k);
  }
}
