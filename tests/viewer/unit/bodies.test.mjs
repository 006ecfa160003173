// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Spheres that spin, merge, pass through each other, or are kinematic: recordings with bodies.
import assert from 'node:assert/strict';
import test from 'node:test';
import { Bodies, turned } from '../../../apps/viewer/page/src/motion/bodies.js';
import { Box } from '../../../apps/viewer/page/src/motion/box.js';
import { Cells } from '../../../apps/viewer/page/src/motion/cells.js';
import { nextContact, recentPaths } from '../../../apps/viewer/page/src/motion/contacts_of.js';
import { typicalScales } from '../../../apps/viewer/page/src/motion/default_speed.js';
import { Images } from '../../../apps/viewer/page/src/motion/images.js';
import { Playback } from '../../../apps/viewer/page/src/motion/playback.js';
import { SavedSource } from '../../../apps/viewer/page/src/recording/saved_source.js';
import { pick } from '../../../apps/viewer/page/src/scene/pick.js';
import { summarize } from '../../../apps/viewer/page/src/statistics/chunk_summary.js';
import { Sizes } from '../../../apps/viewer/page/src/statistics/sizes.js';
import { findKinds, readSpecies, readSpeeds } from '../../../apps/viewer/page/src/statistics/speeds.js';
import { writeRecording } from '../support/small_gas.mjs';
import { StoredSource } from '../support/stored_source.mjs';

const kQuarter = Math.PI / 2;
const kUpright = [0, 0, 0, 1];
const kStill = [0, 0, 0];
const kHeader = {
  spheres: 3,
  box: { size: [20, 10, 10], boundary: ['wall', 'wall', 'periodic'] },
  restitution: null,
  species: { names: ['drop', 'mist'], runs: [[0, 2], [1, 1]] },
};
const kBox = new Box(kHeader.box);

// Sphere 0 spins about z and meets sphere 1 at time 2, which passes through it, and again at time 4, when they
// merge. Sphere 2 is kinematic.
const kBytes = writeRecording(
  kHeader,
  [1, 1, 0.5],
  [1, 1, Infinity],
  [
    {
      begin: 0,
      end: 8,
      keyframe: [4, 5, 5, 1, 0, 0, 0, 8, 5, 5, 0, 0, 0, 0, 2, 2, 2, 0, 0, 0, 0],
      bodies: [
        ...[0, 0, kQuarter, ...kUpright, 1, 1, 0.4],
        ...[...kStill, ...kUpright, 1, 1, 0.4],
        ...[...kStill, ...kUpright, 0.5, Infinity, 0.4],
      ],
      contacts: [
        { time: 2, first: 0, second: 1, fate: 1, numbers: [6, 5, 5, 1, 0, 0, 0, 0, kQuarter, 8, 5, 5, 0, 0, 0, ...kStill] },
        { time: 3, first: 0, second: 0, fate: 0, numbers: [7, 5, 5, 1, 0, 0, 1, 0, 0, ...kStill, ...kStill, ...kStill] },
        { time: 4, first: 0, second: 1, fate: 2, numbers: [8, 5, 5, 0.5, 0, 0, 0, 0.25, 0, 8, 5, 5, 1.25, 2, 0.4, ...kStill] },
      ],
    },
  ],
);

function playbackOf(source) {
  return new Playback(3, () => undefined, new Bodies(source.radii, source.masses));
}

function assertNear(actual, expected, tolerance = 1e-14) {
  assert.equal(actual.length, expected.length);
  actual.forEach((value, k) => assert.ok(Math.abs(value - expected[k]) <= tolerance, `${actual} ${expected}`));
}

test('spheres that are missing at the start do not count', () => {
  const keyframe = [4, 5, 5, 3, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 2, 2, 3, 4, 0, 0];
  const bodies = [
    ...[...kStill, ...kUpright, 1, 1, 0.4],
    ...[...kStill, ...kUpright, 0, 0, 0.4],
    ...[...kStill, ...kUpright, 1, 2, 0.4],
  ];
  const contacts = [
    { time: 4, first: 0, second: 2, fate: 0, numbers: [4, 5, 5, 0, 0, 0, ...kStill, 2, 2, 2, 0, 0, 0, ...kStill] },
  ];
  const source = new StoredSource(
    writeRecording(kHeader, [1, 0, 1], [1, 0, 2], [{ begin: 0, end: 8, keyframe, bodies, contacts }]),
  );
  const playback = playbackOf(source);
  assert.equal(playback.bodies.count, 2);
  playback.moveTo(5, source.chunks[0], 0);
  assert.equal(playback.bodies.count, 2);
  assert.ok(!playback.bodies.exists(1));
  assert.deepEqual(findKinds(source.radii, source.masses).list.map(({ count }) => count), [1, 1]);
  const { speed, rate } = typicalScales(source.chunks[0], source.radii, source.header);
  assert.equal(speed, 5);
  assert.equal(rate, 2 / (2 * 8));
});

test('spheres that merge are one from then on, at any time, in either direction', () => {
  const source = new StoredSource(kBytes);
  const playback = playbackOf(source);
  const at = (time) => {
    playback.moveTo(time, source.chunks[0], 0);
    const { radii, masses, count } = playback.bodies;
    return [[...radii], [...masses], count];
  };
  const before = [[1, 1, 0.5], [1, 1, Infinity], 3];
  const after = [[1.25, 0, 0.5], [2, 0, Infinity], 2];
  assert.deepEqual(at(3.999), before);
  assert.deepEqual(at(4), after);
  assert.deepEqual([...playback.paths.subarray(0, 14)], [8, 5, 5, 0.5, 0, 0, 4, 8, 5, 5, 0, 0, 0, 4]);
  assert.deepEqual(at(6), after);
  assert.deepEqual(at(1), before);
  assert.deepEqual([...playback.collisions], [0, 0, 0]);
  at(8);
  assert.deepEqual([...playback.collisions], [1, 1, 0]);
});

test('a passage changes no path and is no contact', () => {
  const source = new StoredSource(kBytes);
  const [chunk] = source.chunks;
  const kinds = [0, 1, 2].map((k) => [chunk.isPass(k), chunk.isMerger(k), chunk.isCollision(k), chunk.isContact(k)]);
  assert.deepEqual(kinds, [
    [true, false, false, false],
    [false, false, false, false],
    [false, true, true, true],
  ]);
  const store = { get: (number) => source.chunks[number] };
  assert.equal(nextContact(store, null, 0, 0).time, 4);
  assert.deepEqual(
    recentPaths(store, 1, 0, 3, 9).map(({ numbers }) => [...numbers]),
    [
      [8, 5, 5, 0, 0, 0, 4],
      [8, 5, 5, 0, 0, 0, 0],
    ],
  );
  const playback = playbackOf(source);
  playback.moveTo(2.5, chunk, 0);
  assert.equal(playback.paths[6], 0);
  const saved = new SavedSource({ textContent: Buffer.from(kBytes).toString('base64') });
  assert.deepEqual([saved.status.collisions, saved.status.mergers], [1, 1]);
});

// A turn about z by 3/4, then about x by one radian.
test('spheres turn with their spins', () => {
  const source = new StoredSource(kBytes);
  const playback = playbackOf(source);
  const orientation = (time) => {
    playback.moveTo(time, source.chunks[0], 0);
    return playback.bodies.orientation(0, time - playback.paths[6]);
  };
  const half = Math.SQRT1_2;
  assertNear(orientation(0), kUpright);
  assertNear(orientation(1), [0, 0, half, half]);
  assertNear(orientation(2.5), [0, 0, Math.sin(2.5 * (kQuarter / 2)), Math.cos(2.5 * (kQuarter / 2))]);
  const then = [0, 0, half, -half]; // by 3/4
  assertNear(orientation(3), then);
  const [sine, cosine] = [Math.sin(0.25), Math.cos(0.25)];
  // (s i + c)(h k - h) = -s h j - s h i + c h k - c h
  assertNear(orientation(3.5), [-sine * half, -sine * half, cosine * half, -cosine * half]);
  assert.deepEqual([...playback.bodies.spin(0)], [1, 0, 0]);
  assertNear(turned(turned(kUpright, [0.3, 0.4, 0], 2), [0.3, 0.4, 0], -2), kUpright);
});

// Rodrigues' formula.
function rotated(vector, spin, duration) {
  const rate = Math.hypot(...spin);
  const axis = spin.map((part) => part / rate);
  const [cosine, sine] = [Math.cos(rate * duration), Math.sin(rate * duration)];
  const along = axis.reduce((sum, part, k) => sum + part * vector[k], 0);
  const across = cross(axis, vector);
  return vector.map((part, k) => cosine * part + sine * across[k] + (1 - cosine) * along * axis[k]);
}

function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

// As the shader does it.
function carried([x, y, z, real], vector) {
  const inner = cross([x, y, z], vector).map((part, k) => part + real * vector[k]);
  return cross([x, y, z], inner).map((part, k) => vector[k] + 2 * part);
}

test('one turn after another carries every direction along', () => {
  const spins = [[0.3, -0.7, 1.1], [-1.3, 0.2, 0.4], [0.5, 0.6, -0.2]];
  for (const start of [[1, 0, 0], [0, 1, 0], [0, 0, 1]]) {
    let orientation = kUpright;
    let direction = start;
    for (const spin of spins) {
      orientation = turned(orientation, spin, 1.7);
      direction = rotated(direction, spin, 1.7);
      assertNear(carried(orientation, start), direction, 1e-14);
    }
  }
});

test('what does not exist is neither picked, nor has it images, a size, a speed, or a kind', () => {
  const source = new StoredSource(kBytes);
  const playback = playbackOf(source);
  playback.moveTo(5, source.chunks[0], 0);
  const { radii, masses } = playback.bodies;
  const images = new Images(radii, kBox);
  images.update(playback);
  assert.equal(images.count, 0);
  const options = { tolerance: 0.2, leastSize: 0.2, isShown: () => true, images };
  const ray = { origin: { x: 8, y: 5, z: 50 }, direction: { x: 0, y: 0, z: -1 } };
  assert.equal(pick(playback, radii, kBox, ray, options), 0);
  assert.deepEqual([new Sizes(radii).smallest, new Sizes(radii).largest], [0.5, 1.25]);
  assert.deepEqual(
    findKinds(radii, masses).list.map(({ count }) => count),
    [1, 1],
  );
  const speeds = new Float64Array(3);
  assert.deepEqual(readSpeeds(playback.paths, 5, masses, kBox, speeds), { count: 1, energy: (2 * 0.5 ** 2) / 2 });
  assert.equal(speeds[0], 0.5);
});

test('the energy has that of rotation, and none of kinematic spheres', () => {
  const { chunks, masses } = new StoredSource(kBytes);
  const [whole] = summarize(chunks[0], masses, 0);
  // Of the middle, time 4: the merged sphere.
  assert.equal(whole.collisions * 8, 1);
  assert.ok(Math.abs(whole.energy - ((2 * 0.5 ** 2) / 2 + (0.4 * 2 * 1.25 ** 2 * 0.25 ** 2) / 2)) < 1e-15);
});

test('the header names the species', () => {
  const { of, list } = readSpecies(kHeader);
  assert.deepEqual([...of], [0, 0, 1]);
  assert.deepEqual(list, [
    { name: 'drop', count: 2 },
    { name: 'mist', count: 1 },
  ]);
  assert.deepEqual(readSpecies({ spheres: 2, species: { names: [], runs: [[1, 2]] } }).list, [
    { name: 'species 0', count: 0 },
    { name: 'species 1', count: 2 },
  ]);
  assert.equal(readSpecies({ spheres: 2 }), null);
});

test('the cells of a plane are squares', () => {
  const plane = new Box({ size: [10, 8, 0], boundary: ['periodic', 'wall', 'flat'] });
  assert.deepEqual([plane.dimensions, plane.isFlat, kBox.dimensions], [2, true, 3]);
  for (const cells of [Cells.fitting(2, plane), new Cells([2, 2, 0], [0, 0, 0], plane)]) {
    assert.deepEqual([cells.edge, cells.count], [
      [2, 2, 0],
      [5, 0, 0],
    ]);
    const visited = [];
    const path = Float64Array.of(5, 5, 0, 1, 0, 0, 0);
    cells.visit(path, 0.5, 0, 1, (indices) => visited.push([...indices]));
    assert.deepEqual(visited, [
      [2, 2, 0],
      [3, 2, 0],
    ]);
    assert.deepEqual(cells.nextCrossing(path, 0.5, 0), { time: 0.5, kind: 'enter', axis: 0 });
    assert.equal(cells.begin(0, 2), 0);
  }
});
