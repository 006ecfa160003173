// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { Chunk, chunkLength, kChecksumBytes } from './chunk.js';
import { hasItsChecksum } from './crc32.js';

const kMagics = { plain: 'HBREC003', growing: 'HBREC004', driven: 'HBREC005' };

/**
 * Reads a whole recording: its header, radii [L], masses [M], and chunks, which are views of `buffer`.
 * A truncated last chunk is ignored. `damage` says what is wrong after the chunks, or is null. Error: not a recording;
 * its header or the radii or masses are damaged.
 */
export function readRecording(buffer) {
  const magic = new TextDecoder().decode(new Uint8Array(buffer, 0, Math.min(8, buffer.byteLength)));
  if (!Object.values(kMagics).includes(magic)) throw new Error(`not a recording of a known version: it starts with '${magic}'`);
  const headerLength = new DataView(buffer).getUint32(8, true);
  if (buffer.byteLength - 12 < headerLength) throw new Error('the recording is damaged: it ends within its header');
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 12, headerLength)));
  // So that no damage to its mark turns a recording into one of another version.
  const kind = header.motions ? 'driven' : header.growth ? 'growing' : 'plain';
  if (magic !== kMagics[kind]) {
    throw new Error('the recording is damaged: of another version');
  }
  const radiiStart = 12 + headerLength;
  const massesStart = radiiStart + 8 * header.spheres;
  const spheresEnd = massesStart + 8 * header.spheres;
  if (buffer.byteLength - spheresEnd < kChecksumBytes || !hasItsChecksum(buffer, 0, spheresEnd)) {
    throw new Error('the recording is damaged: its header or its spheres do not match their checksum');
  }
  const radii = new Float64Array(buffer, radiiStart, header.spheres);
  const masses = new Float64Array(buffer, massesStart, header.spheres);

  const chunks = [];
  let damage = null;
  try {
    let offset = spheresEnd + kChecksumBytes;
    for (;;) {
      const length = chunkLength(buffer, offset, header);
      if (length === undefined) break;
      chunks.push(new Chunk(buffer, offset, header));
      offset += length;
    }
  } catch (error) {
    damage = error.message;
  }
  return { header, radii, masses, chunks, damage };
}
