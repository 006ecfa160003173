// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import { Box } from '../../../apps/viewer/page/src/motion/box.js';
import { extentOf } from '../../../apps/viewer/page/src/motion/extent.js';
import { partnerName, readSurfaces } from '../../../apps/viewer/page/src/motion/surfaces.js';
import { readRecording } from '../../../apps/viewer/page/src/recording/recording_file.js';
import { planePatch, rangeAlong, tangents } from '../../../apps/viewer/page/src/scene/plane_patch.js';
import { recordLoneSpheres } from '../support/lone_spheres.mjs';
import { assertNear } from '../support/near.mjs';

const kOpen = { size: [0, 0, 0], boundary: ['open', 'open', 'open'] };
const kSurfaces = [
  { shape: 'plane', point: [0, 0, 1], direction: [0, 0.6, 0.8], amplitude: 0.5, frequency: 0.25 },
  { shape: 'cylinder', point: [1, 2, 0], direction: [0, 0, 1], radius: 3, velocity: [0.5, 0, 0] },
  { shape: 'sphere', point: [1, 1, 1], radius: 4, temperature: 2 },
  { shape: 'obstacle', point: [2, 1, 1], radius: 0.5, restitution: 0.9 },
];

function assertPlace(place, expected) {
  place.forEach((coordinate, axis) => assertNear(coordinate, expected[axis], 1e-12));
}

const dot = (a, b) => a.reduce((sum, part, axis) => sum + part * b[axis], 0);

test('surfaces are where they are at the time shown', () => {
  const [plane, cylinder, sphere] = readSurfaces({ surfaces: kSurfaces });
  assertPlace(plane.pointAt(1), [0, 0.3, 1.4]);
  assertPlace(plane.pointAt(2), [0, 0, 1]);
  assertPlace(plane.pointAt(3), [0, -0.3, 0.6]);
  assertPlace(cylinder.pointAt(4), [3, 2, 0]);
  assertPlace(sphere.pointAt(4), [1, 1, 1]);
  assert.deepEqual(
    [plane, cylinder, sphere].map(({ moves }) => moves),
    [true, true, false],
  );
  assert.deepEqual(readSurfaces({}), []);
});

test('surfaces that take energy are known', () => {
  const changes = (entry) => readSurfaces({ surfaces: [{ shape: 'plane', point: [0, 0, 0], ...entry }] })[0].changesEnergy;
  assert.equal(changes({}), false);
  assert.equal(changes({ restitution: 1 }), false);
  assert.equal(changes({ restitution: 0.5 }), true);
  assert.equal(changes({ restitution: null }), true);
});

test('partners of contacts have names', () => {
  const surfaces = readSurfaces({ surfaces: kSurfaces });
  assert.equal(partnerName(17, surfaces), 'sphere 17');
  assert.equal(partnerName(-1, surfaces), 'wall x_min');
  assert.equal(partnerName(-6, surfaces), 'wall z_max');
  assert.equal(partnerName(-7, surfaces), 'wall 0: plane');
  assert.equal(partnerName(-10, surfaces), 'wall 3: obstacle');
});

test('every contact with a surface is where sphere and surface touch', () => {
  const surfaces = [
    ...kSurfaces,
    { shape: 'pillar', point: [3, 2.6, 0], direction: [0, 0, 1], radius: 0.3 },
    { shape: 'plane', point: [0, 0, -2], direction: [0, 0, 1], velocity: [0, 0, 0.05] },
  ];
  const { header, radii, chunks } = readRecording(
    recordLoneSpheres({
      box: kOpen,
      gravity: [0, 0, -1],
      surfaces,
      radii: [0.2, 0.3, 0.1],
      positions: [
        [1, 2, 2],
        [1, 2.5, 2.5],
        [0, 2, 3],
      ],
      velocities: [
        [1, 0.5, 0],
        [-0.5, 1, 1],
        [2, -2, 0.5],
      ],
      until: 8,
    }),
  );
  const [chunk] = chunks;
  const box = new Box(header.box, header.gravity);
  const read = readSurfaces(header);
  const met = new Set();
  for (let k = 0; k < chunk.contacts; ++k) {
    const number = -chunk.second(k) - 7;
    const surface = read[number];
    met.add(number);
    const time = chunk.time(k);
    const place = chunk.firstPlace(k);
    const center = [...chunk.numbers.subarray(place, place + 3)];
    const touch = surface.touchPoint(center, radii[chunk.first(k)], time, box);
    assertNear(Math.hypot(...touch.map((part, axis) => part - center[axis])), radii[chunk.first(k)], 1e-9);
    const apart = touch.map((part, axis) => part - surface.pointAt(time)[axis]);
    const along = dot(apart, surface.direction);
    const distance = {
      plane: () => along,
      cylinder: () => Math.sqrt(dot(apart, apart) - along ** 2) - surface.radius,
      pillar: () => Math.sqrt(dot(apart, apart) - along ** 2) - surface.radius,
      sphere: () => Math.hypot(...apart) - surface.radius,
      obstacle: () => Math.hypot(...apart) - surface.radius,
    }[surface.shape]();
    assertNear(distance, 0, 1e-9);
  }
  assert.ok(chunk.contacts > 20);
  assert.ok(met.size >= 5, `${[...met]}`);
});

test('an obstacle is touched at its nearest periodic image', () => {
  const box = new Box({ size: [10, 10, 10], boundary: ['periodic', 'periodic', 'periodic'] });
  const [obstacle] = readSurfaces({ surfaces: [{ shape: 'obstacle', point: [9.5, 5, 5], radius: 1 }] });
  assertPlace(obstacle.touchPoint([1, 5, 5], 0.5, 0, box), [0.5, 5, 5]);
});

test('a plane is drawn as its part in the box', () => {
  const low = [-1, 0, 2];
  const high = [3, 5, 4];
  const normals = [
    [0, 0, 1],
    [1, 0, 0],
    [0.6, 0.8, 0],
    [1 / Math.sqrt(3), 1 / Math.sqrt(3), 1 / Math.sqrt(3)],
    [0.48, -0.6, 0.64],
  ];
  for (const normal of normals) {
    for (let step = 0; step <= 20; ++step) {
      const point = low.map((begin, axis) => begin + (step / 20) * (high[axis] - begin));
      const corners = planePatch(point, normal, low, high);
      for (const corner of corners) {
        assertNear(dot(normal, corner), dot(normal, point), 1e-9);
        corner.forEach((place, axis) => assert.ok(place > low[axis] - 1e-6 && place < high[axis] + 1e-6));
        const onFaces = corner.filter(
          (place, axis) => Math.min(Math.abs(place - low[axis]), Math.abs(place - high[axis])) < 1e-6,
        );
        assert.ok(onFaces.length >= 2, 'a corner lies on an edge of the box');
      }
      // Seen from the front they follow each other counterclockwise, and the patch is convex.
      corners.forEach((corner, k) => {
        const [next, afterNext] = [1, 2].map((step) => corners[(k + step) % corners.length]);
        const [a, b] = [next.map((p, i) => p - corner[i]), afterNext.map((p, i) => p - next[i])];
        const turn = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        assert.ok(dot(turn, normal) > -1e-9);
      });
      if (step > 0 && step < 20) assert.ok(corners.length >= 3 && corners.length <= 6, `${corners.length}`);
    }
  }
  assert.deepEqual(planePatch([0, 0, 7], [0, 0, 1], low, high), []);
  assert.equal(planePatch([0, 0, 3], [0, 0, 1], low, high).length, 4);
});

test('tangents are perpendicular to their normal and to each other', () => {
  for (const normal of [
    [0, 0, 1],
    [0, -1, 0],
    [0.48, -0.6, 0.64],
  ]) {
    const [first, second] = tangents(normal);
    for (const [a, b] of [
      [first, second],
      [first, normal],
      [second, normal],
    ])
      assertNear(dot(a, b), 0, 1e-12);
    for (const unit of [first, second]) assertNear(dot(unit, unit), 1, 1e-12);
  }
});

test('a cylinder ends where the box does', () => {
  assert.deepEqual(rangeAlong([1, 1, 1], [0, 0, 1], [0, 0, 0], [4, 5, 6]), [-1, 5]);
  assert.deepEqual(rangeAlong([1, 1, 1], [0, -1, 0], [0, 0, 0], [4, 5, 6]), [-4, 1]);
});

test('all surfaces are in the extent of open space', () => {
  const bodies = { radii: [1] };
  const playback = { paths: new Float64Array([0, 0, 5, 0, 0, 0, 0]), spheres: 1, time: 2, bodies };
  const surfaces = readSurfaces({
    surfaces: [
      { shape: 'plane', point: [7, 7, 0], direction: [0, 0, 1], amplitude: 0.5, frequency: 1 },
      { shape: 'cylinder', point: [0, 0, 0], direction: [0, 0, 1], radius: 3, velocity: [1, 0, 0] },
      { shape: 'obstacle', point: [0, 0, 9], radius: 2 },
    ],
  });
  const falling = new Box(kOpen, [0, 0, -2]);
  const [low, high] = extentOf(playback, falling, surfaces, 1);
  // The sphere has fallen to 1.
  assertPlace(low, [-2, -3, -0.5]);
  assertPlace(high, [5, 3, 11]);
  assert.deepEqual(extentOf(playback, falling, [], 1), [
    [-1, -1, 0],
    [1, 1, 2],
  ]);
  const walls = new Box({ size: [4, 5, 6], boundary: ['wall', 'periodic', 'wall'] });
  assert.deepEqual(extentOf(playback, walls, surfaces, 1), [
    [0, 0, 0],
    [4, 5, 6],
  ]);
});
