// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import zlib from 'node:zlib';
import { crc32 } from '../../../apps/viewer/page/src/recording/crc32.js';
import { readRecording } from '../../../apps/viewer/page/src/recording/recording_file.js';
import { decodeBase64, SavedSource } from '../../../apps/viewer/page/src/recording/saved_source.js';
import { recordSmallGas } from '../support/small_gas.mjs';

// Two spheres on a line between walls: they meet at time 1.5, and each meets its wall at time 5.5.
const kTwo = {
  box: { size: [10, 4, 4], boundary: ['wall', 'wall', 'periodic'] },
  radii: [0.5, 0.5],
  masses: [1, 1],
  positions: [
    [3, 2, 1],
    [7, 2, 1],
  ],
  velocities: [
    [1, 0, 0],
    [-1, 0, 0],
  ],
  until: 6,
  contactsOfChunk: 1,
};

test('a recording is read as it was written', () => {
  const { header, radii, masses, chunks } = readRecording(recordSmallGas(kTwo));
  assert.equal(header.spheres, 2);
  assert.deepEqual(header.box, kTwo.box);
  assert.deepEqual([...radii], kTwo.radii);
  assert.deepEqual([...masses], kTwo.masses);
  assert.deepEqual(
    chunks.map(({ begin, end, contacts }) => [begin, end, contacts]),
    [
      [0, 1.5, 1],
      [1.5, 6, 2],
    ],
  );
  const [chunk] = chunks;
  assert.deepEqual([...chunk.keyframe], [3, 2, 1, 1, 0, 0, 0, 7, 2, 1, -1, 0, 0, 0]);
  assert.equal(chunk.time(0), 1.5);
  assert.deepEqual([chunk.first(0), chunk.second(0)], [0, 1]);
  assert.deepEqual([chunks[1].first(0), chunks[1].second(0)], [0, -1]);
  assert.deepEqual([chunks[1].first(1), chunks[1].second(1)], [1, -2]);
});

test('the path of a sphere follows from keyframe and contacts', () => {
  const { chunks } = readRecording(recordSmallGas(kTwo));
  const path = new Float64Array(7);
  chunks[0].readPath(1, chunks[0].contactsUntil(1.4), path);
  assert.deepEqual([...path], [7, 2, 1, -1, 0, 0, 0]);
  chunks[0].readPath(1, chunks[0].contactsUntil(1.5), path);
  assert.deepEqual([...path], [5.5, 2, 1, 1, 0, 0, 1.5]);
});

test('contacts up to a time are counted, including those at that time', () => {
  const [chunk] = readRecording(recordSmallGas({ ...kTwo, contactsOfChunk: 100 })).chunks;
  const counted = (time) =>
    Array.from({ length: chunk.contacts }, (_, k) => chunk.time(k)).filter((t) => t <= time).length;
  for (const time of [0, 1.4, 1.5, 1.6, 5.5, 5.9, 6]) assert.equal(chunk.contactsUntil(time), counted(time));
});

test('a truncated last chunk is ignored, wherever it ends, and is no damage', () => {
  const bytes = recordSmallGas(kTwo);
  const whole = readRecording(bytes).chunks;
  const cut = whole.at(-1).bytes;
  for (let missing = 1; missing <= cut; ++missing) {
    const { chunks, damage } = readRecording(bytes.slice(0, bytes.byteLength - missing));
    assert.deepEqual([chunks.length, damage], [whole.length - 1, null]);
  }
});

test('damage is distinguished from truncation', () => {
  const bytes = recordSmallGas(kTwo);
  const second = bytes.byteLength - readRecording(bytes).chunks.at(-1).bytes;
  for (const offset of [second, second + 4, second + 8]) {
    const { chunks, damage } = readRecording(flipped(bytes, offset, 0));
    assert.equal(chunks.length, 1);
    assert.match(damage, /damaged: no chunk at byte/);
  }
  assert.throws(() => readRecording(flipped(bytes, 0, 0)), /not a recording/);
});

function flipped(bytes, offset, bit) {
  const damaged = bytes.slice(0);
  new Uint8Array(damaged)[offset] ^= 1 << bit;
  return damaged;
}

test('no flipped bit passes, and what comes before is read', () => {
  const bytes = recordSmallGas(kTwo);
  const { chunks } = readRecording(bytes);
  const second = bytes.byteLength - chunks.at(-1).bytes;
  const first = second - chunks[0].bytes;
  for (let offset = 0; offset < bytes.byteLength; ++offset) {
    for (let bit = 0; bit < 8; ++bit) {
      const damaged = flipped(bytes, offset, bit);
      if (offset < first) {
        assert.throws(() => readRecording(damaged), Error, `byte ${offset}, bit ${bit}`);
      } else {
        const read = readRecording(damaged);
        assert.match(read.damage, /damaged/, `byte ${offset}, bit ${bit}`);
        assert.equal(read.chunks.length, offset < second ? 0 : 1);
      }
    }
  }
});

test('a saved page with a damaged recording says so and shows what comes before', () => {
  const bytes = recordSmallGas(kTwo);
  const textOf = (buffer) => ({ textContent: Buffer.from(buffer).toString('base64') });
  assert.equal(new SavedSource(textOf(bytes)).status.damaged, null);
  const source = new SavedSource(textOf(flipped(bytes, bytes.byteLength - 30, 3)));
  assert.match(source.status.damaged, /damaged after time 1.5: wrong checksum at byte \d+; the part before/);
  assert.deepEqual(source.ends, [1.5]);
});

test('the checksum is that of zlib, wherever it begins and ends', () => {
  const bytes = Uint8Array.from({ length: 70 }, (_, k) => 41 * k * k + 7);
  for (let begin = 0; begin < 9; ++begin) {
    for (let end = begin; end <= bytes.length; ++end) {
      assert.equal(crc32(bytes.buffer, begin, end), zlib.crc32(bytes.subarray(begin, end)));
    }
  }
});

test('base 64 is decoded, whatever the padding', () => {
  for (let length = 0; length < 9; ++length) {
    const bytes = Uint8Array.from({ length }, (_, k) => 251 - 37 * k);
    const text = `\n${Buffer.from(bytes).toString('base64')}\n`;
    assert.deepEqual(new Uint8Array(decodeBase64(text)), bytes);
  }
});
