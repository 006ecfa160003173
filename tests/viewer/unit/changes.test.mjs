// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Changes of one sphere's velocity without a contact: records whose second sphere is the first.
import assert from 'node:assert/strict';
import test from 'node:test';
import { nextContact, recentPaths } from '../../../apps/viewer/page/src/motion/contacts_of.js';
import { typicalScales } from '../../../apps/viewer/page/src/motion/default_speed.js';
import { Playback } from '../../../apps/viewer/page/src/motion/playback.js';
import { Player } from '../../../apps/viewer/page/src/motion/player.js';
import { ChunkStore } from '../../../apps/viewer/page/src/recording/chunk_store.js';
import { SavedSource } from '../../../apps/viewer/page/src/recording/saved_source.js';
import { summarize } from '../../../apps/viewer/page/src/statistics/chunk_summary.js';
import { writeRecording } from '../support/small_gas.mjs';
import { settle, StoredSource } from '../support/stored_source.mjs';

const kNothing = [0, 0, 0, 0, 0, 0];

// Sphere 0 is sent off at time 1 and meets sphere 1 at time 3; then sphere 1 is sent off, and meets a wall.
const kBytes = writeRecording(
  { box: { size: [10, 10, 10], boundary: ['wall', 'wall', 'wall'] } },
  [0.5, 0.5],
  [1, 2],
  [
    {
      begin: 0,
      end: 8,
      keyframe: [2, 5, 5, 0, 0, 0, 0, 5, 5, 5, 0, 0, 0, 0],
      contacts: [
        { time: 1, first: 0, second: 0, numbers: [2, 5, 5, 1, 0, 0, ...kNothing] },
        { time: 3, first: 0, second: 1, numbers: [4, 5, 5, 0, 0, 0, 5, 5, 5, 1, 0, 0] },
        { time: 4, first: 1, second: 1, numbers: [6, 5, 5, 2, 0, 0, ...kNothing] },
        { time: 5.75, first: 1, second: -2, numbers: [9.5, 5, 5, -2, 0, 0, ...kNothing] },
      ],
    },
  ],
);

function pathsAt(playback, time, source) {
  playback.moveTo(time, source.chunks[0], 0);
  return [[...playback.paths.subarray(0, 7)], [...playback.paths.subarray(7, 14)]];
}

test('a change gives the sphere a path and leaves the others alone', () => {
  const source = new StoredSource(kBytes);
  const playback = new Playback(2, () => undefined);
  assert.deepEqual(pathsAt(playback, 2, source), [
    [2, 5, 5, 1, 0, 0, 1],
    [5, 5, 5, 0, 0, 0, 0],
  ]);
  assert.deepEqual(pathsAt(playback, 4.5, source), [
    [4, 5, 5, 0, 0, 0, 3],
    [6, 5, 5, 2, 0, 0, 4],
  ]);
  assert.deepEqual([...playback.collisions], [1, 1]);
  const path = new Float64Array(7);
  source.chunks[0].readPath(1, 3, path);
  assert.deepEqual([...path], [6, 5, 5, 2, 0, 0, 4]);
  const store = { get: (number) => source.chunks[number] };
  const starts = recentPaths(store, 1, 0, 4, 9).map(({ numbers }) => numbers[6]);
  assert.deepEqual(starts, [5.75, 4, 3, 0]);
});

test('a change is no contact: it is neither counted, nor named, nor stepped to', async () => {
  const source = new StoredSource(kBytes);
  const [chunk] = source.chunks;
  const kinds = Array.from({ length: 4 }, (_, k) => [chunk.isCollision(k), chunk.isWall(k), chunk.isContact(k)]);
  assert.deepEqual(kinds, [
    [false, false, false],
    [true, false, true],
    [false, false, false],
    [false, true, true],
  ]);
  const store = { get: (number) => source.chunks[number] };
  assert.equal(nextContact(store, null, 0, 0).time, 3);
  assert.equal(nextContact(store, 1, 0, 2).time, 5.75);
  assert.equal(typicalScales(chunk, [0.5, 0.5], source.header).rate, 2 / (2 * 8));

  const player = new Player(source, new ChunkStore(source));
  player.advance(0);
  await settle();
  player.advance(0);
  const seen = [];
  for (const step of ['stepForward', 'stepForward', 'stepBack']) {
    let isDone = false;
    player[step]().then(() => (isDone = true));
    for (let frame = 0; frame < 10 && !isDone; ++frame) {
      await settle();
      player.advance(0);
    }
    seen.push(player.time);
  }
  assert.deepEqual(seen, [3, 5.75, 3]);

  const saved = new SavedSource({ textContent: Buffer.from(kBytes).toString('base64') });
  assert.deepEqual([saved.status.collisions, saved.status.walls], [1, 1]);
});

test('the energy that a change gives is seen', () => {
  const { chunks, masses } = new StoredSource(kBytes);
  const [{ collisions, walls, energy }] = summarize(chunks[0], masses, 0);
  assert.deepEqual([collisions * 8, walls * 8], [1, 1]);
  // At time 4, the middle, sphere 1 has been sent off.
  assert.equal(energy, (2 * 2 ** 2) / 2);
});
