// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { Chunk, chunkLength } from './chunk.js';

const kMagics = ['HBREC001', 'HBREC002']; // by version, from 1 on

/**
 * Reads a whole recording: its header and version, radii [L], masses [M], and chunks, which are views of `buffer`.
 * A truncated last chunk is ignored. Error: not a recording.
 */
export function readRecording(buffer) {
  const magic = new TextDecoder().decode(new Uint8Array(buffer, 0, Math.min(8, buffer.byteLength)));
  const version = kMagics.indexOf(magic) + 1;
  if (version === 0) throw new Error(`not a recording of a known version: it starts with '${magic}'`);
  const headerLength = new DataView(buffer).getUint32(8, true);
  const header = { ...JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 12, headerLength))), version };
  const radiiStart = 12 + headerLength;
  const massesStart = radiiStart + 8 * header.spheres;
  const radii = new Float64Array(buffer, radiiStart, header.spheres);
  const masses = new Float64Array(buffer, massesStart, header.spheres);

  const chunks = [];
  let offset = massesStart + 8 * header.spheres;
  for (;;) {
    const length = chunkLength(buffer, offset, header.spheres, version);
    if (length === undefined) break;
    chunks.push(new Chunk(buffer, offset, header.spheres, version));
    offset += length;
  }
  return { header, radii, masses, chunks };
}
