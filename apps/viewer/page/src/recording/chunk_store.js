// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kLoadsAtOnce = 2;

/**
 * The chunks held in memory: those around the time shown, within a budget of bytes.
 * Near chunks are loaded ahead of use; distant ones are dropped, and loaded again when needed.
 */
export class ChunkStore {
  /** `onLoad(chunk, number)` is called for each chunk that arrives, `onLost(error)` for each that does not. */
  constructor(source, { budget = 256 << 20, onLoad = () => {}, onLost = () => {} } = {}) {
    this.source = source;
    this.budget = budget;
    this.onLoad = onLoad;
    this.onLost = onLost;
    this.chunks = new Map();
    this.loading = new Map();
    this.bytes = 0;
    this.center = 0;
    this.isSuspended = false;
  }

  /** Chunk `number` if it is in memory. */
  get(number) {
    return this.chunks.get(number);
  }

  /** The chunk that contains `time`; the first or last one for times outside all. */
  numberAt(time) {
    const ends = this.source.ends;
    let low = 0;
    let high = ends.length - 1;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (ends[middle] < time) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** Chunk `number`, loaded if it is not in memory. Error: the source does not answer. */
  async load(number) {
    const held = this.chunks.get(number);
    if (held) return held;
    const loading = this.loading.get(number) ?? this.start(number);
    return loading;
  }

  /** Centers the chunks held on `number`, and loads the near ones that fit, those needed first first. */
  focus(number) {
    this.center = number;
    if (this.isSuspended) return;
    const size = this.chunks.size > 0 ? this.bytes / this.chunks.size : 0;
    const room = size > 0 ? Math.floor(this.budget / size) - 2 : 1;
    const chunks = this.source.ends.length;
    for (let next = number; next <= number + Math.max(1, room) && next < chunks; ++next) this.want(next);
    if (chunks <= room) for (let next = number - 1; next >= 0; --next) this.want(next);
  }

  want(number) {
    if (this.loading.size >= kLoadsAtOnce || this.chunks.has(number) || this.loading.has(number)) return;
    this.start(number).catch(() => {});
  }

  start(number) {
    const loading = this.source.chunk(number).then(
      (chunk) => {
        this.loading.delete(number);
        this.hold(number, chunk);
        return chunk;
      },
      (error) => {
        this.loading.delete(number);
        this.onLost(error);
        throw error;
      },
    );
    this.loading.set(number, loading);
    return loading;
  }

  hold(number, chunk) {
    this.chunks.set(number, chunk);
    this.bytes += chunk.bytes;
    while (this.bytes > this.budget && this.chunks.size > 2) {
      let farthest = number;
      for (const other of this.chunks.keys()) {
        if (this.distance(other) > this.distance(farthest)) farthest = other;
      }
      this.bytes -= this.chunks.get(farthest).bytes;
      this.chunks.delete(farthest);
    }
    this.onLoad(chunk, number);
  }

  // Chunks behind are needed less than chunks ahead.
  distance(number) {
    return number < this.center ? 2 * (this.center - number) : number - this.center;
  }
}
