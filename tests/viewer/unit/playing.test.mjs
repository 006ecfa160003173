// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import { Box } from '../../../apps/viewer/page/src/motion/box.js';
import { nextContact, recentPaths } from '../../../apps/viewer/page/src/motion/contacts_of.js';
import { piecesInBox, readCenter } from '../../../apps/viewer/page/src/motion/path.js';
import { Playback } from '../../../apps/viewer/page/src/motion/playback.js';
import { Player } from '../../../apps/viewer/page/src/motion/player.js';
import { ChunkStore } from '../../../apps/viewer/page/src/recording/chunk_store.js';
import { randomSpheres, recordSmallGas } from '../support/small_gas.mjs';
import { settle, StoredSource } from '../support/stored_source.mjs';

const kBox = { size: [6, 6, 6], boundary: ['periodic', 'wall', 'periodic'] };
const kGas = recordSmallGas({ box: kBox, ...randomSpheres(27, 6), until: 8, contactsOfChunk: 8 });

// All contacts of the recording, and the path of a sphere after those up to `time`, found the slow way.
function pathOf(source, id, time) {
  let path = [...source.chunks[0].keyframe.subarray(7 * id, 7 * id + 7)];
  for (const chunk of source.chunks) {
    for (let k = 0; k < chunk.contacts; ++k) {
      if (chunk.time(k) > time) return path;
      if (chunk.first(k) === id) path = [...chunk.numbers.subarray(14 * k + 2, 14 * k + 8), chunk.time(k)];
      if (chunk.second(k) === id) path = [...chunk.numbers.subarray(14 * k + 8, 14 * k + 14), chunk.time(k)];
    }
  }
  return path;
}

function collisionsOf(source, id, time) {
  let count = 0;
  for (const chunk of source.chunks) {
    for (let k = 0; k < chunk.contacts && chunk.time(k) <= time; ++k) {
      if (chunk.second(k) >= 0 && (chunk.first(k) === id || chunk.second(k) === id)) ++count;
    }
  }
  return count;
}

function assertShows(playback, source, time) {
  for (let id = 0; id < playback.spheres; ++id) {
    assert.deepEqual(
      [...playback.paths.subarray(7 * id, 7 * id + 7)],
      pathOf(source, id, time),
      `sphere ${id} at ${time}`,
    );
  }
}

async function openPlayer(options) {
  const source = new StoredSource(kGas);
  const store = new ChunkStore(source, options);
  const player = new Player(source, store);
  player.advance(0);
  await settle();
  player.advance(0);
  return { source, store, player };
}

test('the small gas has enough chunks', () => {
  assert.ok(new StoredSource(kGas).chunks.length > 8);
});

test('the paths shown are those of the recording, forward, backward and in jumps', () => {
  const source = new StoredSource(kGas);
  const playback = new Playback(27, () => undefined);
  const moments = [0, 0.01, 0.5, 0.51, 3, 2.9, 8, 0.2, 7.9, source.ends[2], source.ends[1]];
  for (const time of moments) {
    const number = source.ends.findIndex((end) => end >= time);
    playback.moveTo(time, source.chunks[number], number);
    assertShows(playback, source, time);
  }
});

test('only spheres in contacts are touched while time advances', () => {
  const source = new StoredSource(kGas);
  const playback = new Playback(27, () => undefined);
  const [chunk] = source.chunks;
  playback.moveTo(0, chunk, 0);
  assert.ok(playback.allTouched);
  playback.takeTouched();
  playback.moveTo(chunk.time(1), chunk, 0);
  assert.ok(!playback.allTouched);
  const partners = [0, 1].flatMap((k) => [chunk.first(k), chunk.second(k)]).filter((id) => id >= 0);
  assert.deepEqual([...playback.touched.subarray(0, playback.touchedCount)], partners);
});

test('collisions are counted from the start, also after going back', () => {
  const source = new StoredSource(kGas);
  const playback = new Playback(27, () => undefined);
  const go = (time) => {
    const number = source.ends.findIndex((end) => end >= time);
    playback.moveTo(time, source.chunks[number], number);
  };
  for (let number = 0; number < source.ends.length; ++number) go(source.ends[number]);
  go(3);
  assert.equal(playback.countedFrom, 0);
  for (let id = 0; id < 27; ++id) assert.equal(playback.collisions[id], collisionsOf(source, id, 3));
});

test('after a jump, collisions are counted through the chunks in memory', () => {
  const source = new StoredSource(kGas);
  const playback = new Playback(27, (number) => source.chunks[number]);
  playback.moveTo(0, source.chunks[0], 0);
  playback.moveTo(source.ends[5], source.chunks[5], 5);
  assert.equal(playback.countedFrom, 0);
  for (let id = 0; id < 27; ++id)
    assert.equal(playback.collisions[id], collisionsOf(source, id, source.ends[5]));
});

test('after a jump across missing chunks, collisions are counted from there, as shown', () => {
  const source = new StoredSource(kGas);
  const playback = new Playback(27, () => undefined);
  playback.moveTo(0, source.chunks[0], 0);
  playback.moveTo(source.ends[5], source.chunks[5], 5);
  assert.equal(playback.countedFrom, source.ends[4]);
  for (let id = 0; id < 27; ++id) {
    assert.equal(
      playback.collisions[id],
      collisionsOf(source, id, source.ends[5]) - collisionsOf(source, id, source.ends[4]),
    );
  }
});

test('a time whose chunk is missing is not shown until it arrives', async () => {
  const { source, player } = await openPlayer();
  source.isHeld = true;
  const shown = player.seek(source.ends[7]);
  player.advance(0.01);
  assert.ok(player.isBuffering);
  assert.equal(player.time, 0);
  assertShows(player.playback, source, 0);
  source.isHeld = false;
  source.release();
  await settle();
  player.advance(0.01);
  player.advance(0.01);
  await settle();
  player.advance(0.01);
  assert.equal(await shown, source.ends[7]);
  assert.ok(!player.isBuffering);
  assertShows(player.playback, source, source.ends[7]);
});

test('playback keeps its speed, waits for chunks, and ends with the recording', async () => {
  const { source, player } = await openPlayer();
  player.speed = 0.5;
  player.play();
  player.advance(0.05);
  assert.equal(player.time, 0.025);
  for (let frame = 0; frame < 1000 && player.isPlaying; ++frame) {
    player.advance(0.1);
    await settle();
    assert.ok(player.time <= source.ends.at(-1));
  }
  assert.ok(!player.isPlaying);
  assert.equal(player.time, 8);
  assertShows(player.playback, source, 8);
});

test('steps stop at each contact, of all spheres or of one, forward and back', async () => {
  const { source, player } = await openPlayer();
  const times = source.chunks.flatMap((chunk) =>
    Array.from({ length: chunk.contacts }, (_, k) => chunk.time(k)),
  );
  const step = async (method, id) => {
    const shown = player[method](id);
    for (let k = 0; k < 12; ++k) {
      await settle();
      player.advance(0);
    }
    return shown;
  };
  for (let k = 0; k < 50; ++k) assert.equal(await step('stepForward'), times[k]);
  for (let k = 48; k >= 0; --k) assert.equal(await step('stepBack'), times[k]);
  assert.equal(await step('stepBack'), 0);
  const of4 = source.chunks.flatMap((chunk) =>
    Array.from({ length: chunk.contacts }, (_, k) => k)
      .filter((k) => chunk.involves(k, 4))
      .map((k) => chunk.time(k)),
  );
  for (let k = 0; k < 3; ++k) assert.equal(await step('stepForward', 4), of4[k]);
  assert.equal(await step('stepBack', 4), of4[1]);
});

test('memory stays within its budget, and dropped chunks are loaded again', async () => {
  const size = Math.max(...new StoredSource(kGas).chunks.map((chunk) => chunk.bytes));
  const { source, store, player } = await openPlayer({ budget: 4 * size });
  player.speed = 1;
  player.play();
  for (let frame = 0; frame < 500 && player.isPlaying; ++frame) {
    player.advance(0.1);
    await settle();
    assert.ok(store.bytes <= 4 * size);
    assert.equal(
      store.bytes,
      [...store.chunks.values()].reduce((sum, chunk) => sum + chunk.bytes, 0),
    );
  }
  assert.equal(player.time, 8);
  assert.equal(store.get(0), undefined);
  player.seek(0.01);
  for (let k = 0; k < 4; ++k) {
    player.advance(0);
    await settle();
  }
  assert.equal(player.time, 0.01);
  assert.ok(source.asked.filter((number) => number === 0).length > 1);
});

test('a lost source leaves the picture unchanged', async () => {
  let lost = 0;
  const { source, store, player } = await openPlayer({ onLost: () => (lost += 1) });
  await settle();
  source.isLost = true;
  player.seek(7.9);
  for (let k = 0; k < 3; ++k) {
    player.advance(0);
    await settle();
  }
  assert.ok(lost > 0);
  assert.equal(player.time, 0);
  store.isSuspended = true;
  const asked = source.asked.length;
  player.advance(0);
  assert.equal(source.asked.length, asked);
});

test('the recent paths of a sphere follow each other, and its next contact comes after them', async () => {
  const { source, store } = await openPlayer();
  for (let number = 0; number < source.ends.length; ++number) await store.load(number);
  const number = source.ends.length - 5;
  const { end: time, contacts } = source.chunks[number];
  const paths = recentPaths(store, 9, number, contacts, 6);
  assert.equal(paths.length, 6);
  assert.deepEqual([...paths[0].numbers], pathOf(source, 9, time));
  for (let k = 1; k < paths.length; ++k) {
    assert.equal(paths[k].until, paths[k - 1].numbers[6]);
    const box = new Box(kBox);
    const place = readCenter(paths[k].numbers, 0, paths[k].until, box, [0, 0, 0]);
    for (let axis = 0; axis < 3; ++axis)
      assert.ok(Math.abs(box.nearest(place[axis] - paths[k - 1].numbers[axis], axis)) < 1e-9);
  }
  const next = nextContact(store, 9, number, contacts);
  assert.ok(next.time > time);
  assert.deepEqual(pathOf(source, 9, (time + next.time) / 2), pathOf(source, 9, time));
  assert.equal(pathOf(source, 9, next.time)[6], next.time);
});

test('a center is folded into the box along periodic axes, and only there', () => {
  const box = new Box({ size: [10, 10, 10], boundary: ['periodic', 'open', 'periodic'] });
  const path = [9, 5, 1, 2, 3, -1, 100];
  assert.deepEqual(readCenter(path, 0, 100, box, []), [9, 5, 1]);
  assert.deepEqual(readCenter(path, 0, 112, box, []), [3, 41, 9]);
});

test('a motion across periodic faces is cut there', () => {
  const box = new Box({ size: [10, 10, 10], boundary: ['periodic', 'wall', 'periodic'] });
  const path = [9, 5, 1, 2, 0, -1, 0];
  const pieces = piecesInBox(path, 0, 6, box);
  assert.deepEqual(pieces, [
    [
      [9, 5, 1],
      [10, 5, 0.5],
    ],
    [
      [0, 5, 0.5],
      [1, 5, 0],
    ],
    [
      [1, 5, 10],
      [10, 5, 5.5],
    ],
    [
      [0, 5, 5.5],
      [1, 5, 5],
    ],
  ]);
});
