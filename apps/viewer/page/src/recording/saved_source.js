// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { readRecording } from './recording_file.js';

const kPiece = 1 << 22; // letters decoded at a time; a multiple of 4

/** Decodes the base-64 `text`. */
export function decodeBase64(text) {
  const letters = text.replace(/\s+/g, '');
  const padding = letters.endsWith('==') ? 2 : letters.endsWith('=') ? 1 : 0;
  const bytes = new Uint8Array((letters.length / 4) * 3 - padding);
  for (let start = 0, end = 0; start < letters.length; start += kPiece) {
    const piece = atob(letters.slice(start, start + kPiece));
    for (let k = 0; k < piece.length; ++k) bytes[end++] = piece.charCodeAt(k);
  }
  return bytes.buffer;
}

/** A whole recording that was saved inside the page: it needs no server. */
export class SavedSource {
  /** `element` holds the recording in base 64, and is emptied. Error: it is not a recording. */
  constructor(element) {
    const { header, radii, masses, chunks, damage } = readRecording(decodeBase64(element.textContent));
    element.textContent = '';
    this.header = header;
    this.radii = radii;
    this.masses = masses;
    this.chunks = chunks;
    this.ends = chunks.map((chunk) => chunk.end);
    // A recording of moments says what happened between them.
    const { moments } = header;
    let { collisions, mergers, walls } = moments ?? { collisions: 0, mergers: 0, walls: 0 };
    for (const chunk of moments ? [] : chunks) {
      for (let k = 0; k < chunk.contacts; ++k) {
        if (chunk.isWall(k)) ++walls;
        else if (chunk.isCollision(k)) ++collisions;
        if (chunk.isMerger(k)) ++mergers;
      }
    }
    this.status = {
      finished: true,
      failed: null,
      damaged: damage && `${damage}; the part before is shown`,
      reached: this.ends.at(-1) ?? header.begin,
      collisions,
      mergers,
      walls,
    };
    this.replayAddress = null;
  }

  async open() {}

  async poll() {}

  async chunk(number) {
    return this.chunks[number];
  }
}
