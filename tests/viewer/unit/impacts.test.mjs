// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import { emphasis, velocityChanges } from '../../../apps/viewer/page/src/motion/impacts.js';
import { scaleOf } from '../../../apps/viewer/page/src/panel/scale_bar.js';
import { recordLoneSpheres } from '../support/lone_spheres.mjs';
import { assertNear } from '../support/near.mjs';
import { randomSpheres, recordSmallGas } from '../support/small_gas.mjs';
import { StoredSource } from '../support/stored_source.mjs';

test('a ball that bounces off a floor changes its velocity by ever less', () => {
  const floor = { shape: 'plane', point: [0, 0, 0], direction: [0, 0, 1], restitution: 0.5 };
  const open = { size: [0, 0, 0], boundary: ['open', 'open', 'open'] };
  const { chunks } = new StoredSource(
    recordLoneSpheres({
      box: open,
      gravity: [0, 0, -2],
      surfaces: [floor],
      radii: [0.5],
      positions: [[0, 0, 4.5]],
      velocities: [[0, 0, 0]],
      until: 5.5,
    }),
  );
  const changes = velocityChanges(chunks[0], [0, 0, -2]);
  // It falls from a height of 4, meets the floor with a speed of 4, and then each time with half of it.
  assert.ok(changes.length >= 3);
  [6, 3, 1.5].forEach((change, k) => assertNear(changes[k], change, 1e-5));
});

test('the change of velocity in a collision is that of the lighter sphere', () => {
  const box = { size: [5, 5, 5], boundary: ['wall', 'wall', 'wall'] };
  const gas = randomSpheres(27, 5);
  const { chunks } = new StoredSource(recordSmallGas({ box, ...gas, until: 5, contactsOfChunk: 1000 }));
  const [chunk] = chunks;
  const changes = velocityChanges(chunk, [0, 0, 0]);
  const velocities = gas.velocities.map((velocity) => [...velocity]);
  for (let k = 0; k < chunk.contacts; ++k) {
    const partners = [[chunk.first(k), chunk.firstPlace(k)]];
    if (chunk.isCollision(k)) partners.push([chunk.second(k), chunk.secondPlace(k)]);
    const sizes = partners.map(([id, place]) => {
      const after = [0, 1, 2].map((axis) => chunk.numbers[place + 3 + axis]);
      const size = Math.hypot(...after.map((part, axis) => part - velocities[id][axis]));
      velocities[id] = after;
      return size;
    });
    assertNear(changes[k], Math.max(...sizes), 1e-5);
  }
});

test('under gravity a contact counts as far as it is harder than a short fall', () => {
  const gravity = [0, 0, -10];
  // A fall through a tenth of the radius 0.5 gives a speed of 1.
  assert.equal(emphasis(1, 0.5, gravity), 1);
  assert.equal(emphasis(50, 0.5, gravity), 1);
  assertNear(emphasis(0.5, 0.5, gravity), 0.25, 1e-12);
  assert.equal(emphasis(0, 0.5, gravity), 0);
  assert.equal(emphasis(Infinity, 0.5, gravity), 1);
  assert.equal(emphasis(1e-9, 0.5, [0, 0, 0]), 1);
});

test('a scale bar has a round length, and is neither short nor long', () => {
  for (let power = -9; power < 9; power += 0.03) {
    const lengthOfPixel = 10 ** power;
    const { length, pixels } = scaleOf(lengthOfPixel);
    assert.match(length.toExponential(9), /^[125]\.0+e/);
    assertNear(pixels * lengthOfPixel, length, 1e-12 * length);
    assert.ok(pixels > 50 && pixels < 141, `${pixels}`);
  }
  assert.equal(scaleOf(0.01).length, 1);
});
