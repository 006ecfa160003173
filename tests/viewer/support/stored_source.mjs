// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { readRecording } from '../../../apps/viewer/page/src/recording/recording_file.js';

/** A source of a recording's `bytes` whose chunks arrive when the test lets them. */
export class StoredSource {
  constructor(bytes) {
    const { header, radii, masses, chunks } = readRecording(bytes);
    Object.assign(this, { header, radii, masses, chunks });
    this.ends = chunks.map((chunk) => chunk.end);
    this.status = { finished: true, failed: null };
    this.asked = [];
    this.isLost = false;
    this.isHeld = false;
    this.held = [];
  }

  async chunk(number) {
    this.asked.push(number);
    if (this.isHeld) await new Promise((resolve) => this.held.push(resolve));
    if (this.isLost) throw new Error('lost');
    return this.chunks[number];
  }

  release() {
    for (const resolve of this.held.splice(0)) resolve();
  }
}

/** Lets everything that waits for a chunk continue. */
export function settle() {
  return new Promise((resolve) => setImmediate(resolve));
}
