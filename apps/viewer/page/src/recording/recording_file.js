// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { Chunk, chunkLength } from './chunk.js';

const kMagic = 'HBREC001';

/**
 * Reads a whole recording: its header, radii [L], masses [M], and chunks, which are views of `buffer`.
 * A truncated last chunk is ignored. Error: not a recording.
 */
export function readRecording(buffer) {
  const magic = new TextDecoder().decode(new Uint8Array(buffer, 0, Math.min(8, buffer.byteLength)));
  if (magic !== kMagic) throw new Error(`not a recording: it starts with '${magic}', not '${kMagic}'`);
  const headerLength = new DataView(buffer).getUint32(8, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 12, headerLength)));
  const radiiStart = 12 + headerLength;
  const massesStart = radiiStart + 8 * header.spheres;
  const radii = new Float64Array(buffer, radiiStart, header.spheres);
  const masses = new Float64Array(buffer, massesStart, header.spheres);

  const chunks = [];
  let offset = massesStart + 8 * header.spheres;
  for (;;) {
    const length = chunkLength(buffer, offset, header.spheres);
    if (length === undefined) break;
    chunks.push(new Chunk(buffer, offset, header.spheres));
    offset += length;
  }
  return { header, radii, masses, chunks };
}
