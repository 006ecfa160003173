// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import { readRecording } from '../../../apps/viewer/page/src/recording/recording_file.js';
import { decodeBase64 } from '../../../apps/viewer/page/src/recording/saved_source.js';
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

test('a truncated last chunk is ignored, wherever it ends', () => {
  const bytes = recordSmallGas(kTwo);
  const whole = readRecording(bytes).chunks;
  const cut = whole.at(-1).bytes;
  for (let missing = 1; missing <= cut; missing += 1) {
    assert.equal(readRecording(bytes.slice(0, bytes.byteLength - missing)).chunks.length, whole.length - 1);
  }
});

test('damage is distinguished from truncation', () => {
  const bytes = recordSmallGas(kTwo);
  const second = bytes.byteLength - readRecording(bytes).chunks.at(-1).bytes;
  for (const offset of [0, second, second + 4, second + 8]) {
    const damaged = bytes.slice(0);
    new DataView(damaged).setUint8(offset, new DataView(damaged).getUint8(offset) ^ 1);
    assert.throws(() => readRecording(damaged), /damaged|not a recording/);
  }
});

test('base 64 is decoded, whatever the padding', () => {
  for (let length = 0; length < 9; ++length) {
    const bytes = Uint8Array.from({ length }, (_, k) => 251 - 37 * k);
    const text = `\n${Buffer.from(bytes).toString('base64')}\n`;
    assert.deepEqual(new Uint8Array(decodeBase64(text)), bytes);
  }
});
