// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Spheres that grow: records whose second sphere says that an epoch begins.
import assert from 'node:assert/strict';
import test from 'node:test';
import { Bodies } from '../../../apps/viewer/page/src/motion/bodies.js';
import { Playback } from '../../../apps/viewer/page/src/motion/playback.js';
import { readRecording } from '../../../apps/viewer/page/src/recording/recording_file.js';
import { summarize } from '../../../apps/viewer/page/src/statistics/chunk_summary.js';
import { writeRecording } from '../support/small_gas.mjs';

const kEpoch = -(2 ** 31);
const kNothing = [0, 0, 0, 0, 0, 0];

// A sphere of radius .5 grows at .1 from time -1 on, at .25 from time 2 on, and from time 4 on not at all.
const kBytes = writeRecording(
  { box: { size: [10, 10, 10], boundary: ['wall', 'wall', 'wall'] } },
  [0.5],
  [1],
  [
    {
      begin: 0,
      end: 4,
      epoch: [-1, 1, 0.1],
      keyframe: [2, 5, 5, 1, 0, 0, 0],
      contacts: [
        { time: 2, first: -1, second: kEpoch, numbers: [1.3, 0.25, 0, 0, 0, 0, ...kNothing] },
        { time: 4, first: 0, second: -2, numbers: [9, 5, 5, -1, 0, 0, ...kNothing] },
        { time: 4, first: -1, second: kEpoch, numbers: [1.8, 0, 0, 0, 0, 0, ...kNothing] },
      ],
    },
    { begin: 4, end: 8, epoch: [4, 1.8, 0], keyframe: [9, 5, 5, -1, 0, 0, 4], contacts: [] },
  ],
);

test('an epoch is no contact', () => {
  const { chunks } = readRecording(kBytes);
  const [chunk] = chunks;
  assert.deepEqual(
    [0, 1].map((k) => [chunk.isEpoch(k), chunk.isWall(k), chunk.isContact(k), chunk.isCollision(k)]),
    [
      [true, false, false, false],
      [false, true, true, false],
    ],
  );
  assert.ok(!chunk.involves(0, 0));
  const [interval] = summarize(chunk, [1], 0);
  assert.deepEqual([interval.walls, interval.collisions, interval.energy], [0.25, 0, 0.5]);
});

test('radii are those of the time shown', () => {
  const { radii, masses, chunks } = readRecording(kBytes);
  const playback = new Playback(1, (number) => chunks[number], new Bodies(radii, masses));
  const radiusAt = (time, number) => {
    playback.moveTo(time, chunks[number], number);
    return playback.bodies.radii[0];
  };
  const near = (value, expected) => assert.ok(Math.abs(value - expected) < 1e-12, `${value}, not ${expected}`);
  near(radiusAt(0, 0), 0.5 * 1.1);
  near(radiusAt(1.5, 0), 0.5 * 1.25);
  near(radiusAt(3, 0), 0.5 * 1.55);
  near(radiusAt(6, 1), 0.5 * 1.8);
  near(radiusAt(1, 0), 0.5 * 1.2);
  assert.equal(playback.bodies.baseRadii[0], 0.5);
});

test('a recording of growth that does not say so is refused', () => {
  const bytes = kBytes.slice(0);
  new Uint8Array(bytes)[7] = '3'.charCodeAt(0);
  assert.throws(() => readRecording(bytes), /another version/);
});
