// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Walls that motions drive: records whose second sphere says that a surface goes on otherwise.
import assert from 'node:assert/strict';
import test from 'node:test';
import { Bodies } from '../../../apps/viewer/page/src/motion/bodies.js';
import { Playback } from '../../../apps/viewer/page/src/motion/playback.js';
import { readSurfaces } from '../../../apps/viewer/page/src/motion/surfaces.js';
import { readRecording } from '../../../apps/viewer/page/src/recording/recording_file.js';
import { summarize } from '../../../apps/viewer/page/src/statistics/chunk_summary.js';
import { writeRecording } from '../support/small_gas.mjs';

const kSurface = -(2 ** 31) + 1;
const kNothing = [0, 0, 0, 0, 0, 0];
const kFirstSurface = 6;

// A lid at rest at z = 9 comes down with 1 from time 2 on, meets a sphere at time 4, and stops at time 5.
const kBytes = writeRecording(
  {
    box: { size: [10, 10, 10], boundary: ['wall', 'wall', 'open'] },
    motions: true,
    surfaces: [{ shape: 'plane', point: [0, 0, 9], direction: [0, 0, -1], velocity: [0, 0, 0] }],
  },
  [0.5],
  [1],
  [
    {
      begin: 0,
      end: 4,
      keyframe: [2, 5, 6.5, 0, 0, 0, 0],
      contacts: [
        { time: 2, first: kFirstSurface, second: kSurface, numbers: [0, 0, 9, 0, 0, -1, ...kNothing] },
        { time: 4, first: 0, second: -7, numbers: [2, 5, 6.5, 0, 0, -2, ...kNothing] },
      ],
    },
    {
      begin: 4,
      end: 8,
      keyframe: [2, 5, 6.5, 0, 0, -2, 4],
      contacts: [
        { time: 4, first: kFirstSurface, second: kSurface, numbers: [0, 0, 7, 0, 0, -1, ...kNothing] },
        { time: 5, first: kFirstSurface, second: kSurface, numbers: [0, 0, 6, 0, 0, 0, ...kNothing] },
      ],
    },
  ],
);

test('a surface that goes on otherwise is no contact', () => {
  const [chunk] = readRecording(kBytes).chunks;
  assert.deepEqual(
    [0, 1].map((k) => [chunk.isSurface(k), chunk.isWall(k), chunk.isContact(k), chunk.isCollision(k)]),
    [
      [true, false, false, false],
      [false, true, true, false],
    ],
  );
  assert.ok(!chunk.involves(0, 6));
  const [interval] = summarize(chunk, [1], 0);
  assert.equal(interval.walls, 0.25);
});

test('surfaces are where they are at the time shown', () => {
  const { header, radii, masses, chunks } = readRecording(kBytes);
  const playback = new Playback(1, (number) => chunks[number], new Bodies(radii, masses));
  playback.surfaces = readSurfaces(header);
  const [lid] = playback.surfaces;
  assert.ok(lid.moves);
  const heightAt = (time, number) => {
    playback.moveTo(time, chunks[number], number);
    return lid.pointAt(time)[2];
  };
  assert.equal(heightAt(1, 0), 9);
  assert.equal(heightAt(3, 0), 8);
  assert.equal(heightAt(4.5, 1), 6.5);
  assert.equal(heightAt(7, 1), 6);
  assert.equal(heightAt(4.25, 1), 6.75);
  assert.equal(heightAt(1, 0), 9);
});

test('a recording with such walls that does not say so is refused', () => {
  const bytes = kBytes.slice(0);
  new Uint8Array(bytes)[7] = '3'.charCodeAt(0);
  assert.throws(() => readRecording(bytes), /another version/);
});
