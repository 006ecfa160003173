// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Of a recording, as docs/recording.md describes it.
const kLengthAt = 8; // of the length of the header, which follows
const kHeaderAt = 12;
const kChecksumBytes = 8;
const kHeadBytes = 32; // of a chunk
const kChunkLengthAt = 8;
const kChunkEndAt = 24;

let last = 0;

/** The file of a recording in the memory of the module, while it grows and afterwards. */
export class Recorded {
  /** `spheres`: how many there are when it begins. */
  constructor({ FS }, spheres) {
    this.FS = FS;
    this.spheresAtBegin = spheres;
    this.path = `/recording_${++last}.hbr`;
    this.isComplete = false;
    this.header = null;
    this.spheresAt = 0;
    this.end = 0; // of the chunks that are known
    this.chunks = []; // {at, length, end}
  }

  /** Reads the header. Precondition: the recording has begun. */
  begin() {
    const length = this.#view(kLengthAt, 4).getUint32(0, true);
    this.header = JSON.parse(new TextDecoder().decode(this.read(kHeaderAt, length)));
    this.spheresAt = kHeaderAt + length;
    this.end = this.spheresAt + 16 * this.header.spheres + kChecksumBytes;
  }

  /** Radii, then masses. */
  spheres() {
    return new Float64Array(this.read(this.spheresAt, 16 * this.header.spheres).buffer);
  }

  /** Finds the chunks that have been completed since the last call. */
  update() {
    const { size } = this.FS.stat(this.path);
    while (size - this.end >= kHeadBytes) {
      const head = this.#view(this.end, kHeadBytes);
      const length = Number(head.getBigUint64(kChunkLengthAt, true));
      if (size - this.end < length) return;
      this.chunks.push({ at: this.end, length, end: head.getFloat64(kChunkEndAt, true) });
      this.end += length;
    }
  }

  /** A copy of bytes of the file; of all that it has by default. */
  read(at = 0, length = this.FS.stat(this.path).size) {
    const bytes = new Uint8Array(length);
    const file = this.FS.open(this.path, 'r');
    this.FS.read(file, bytes, 0, length, at);
    this.FS.close(file);
    return bytes;
  }

  remove() {
    this.FS.unlink(this.path);
  }

  #view(at, length) {
    return new DataView(this.read(at, length).buffer);
  }
}
