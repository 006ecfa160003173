// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import { Box } from '../../../apps/viewer/page/src/motion/box.js';
import { piecesInBox, readCenter, readVelocity } from '../../../apps/viewer/page/src/motion/path.js';

const kBox = new Box({
  size: [6, 5, 7],
  boundary: ['periodic', 'periodic', 'periodic'],
  shear_rate: 0.3,
  shear_offset: 1,
});

const mod = (place, period) => place - Math.floor(place / period) * period;

test('a sphere that leaves above comes in below, displaced and slower', () => {
  // At time 2 the image above is displaced by 1 + 0.3 * 5 * 2 = 4.
  const path = [3, 4, 2, 0.25, 1, 0, 0];
  assert.deepEqual(readCenter(path, 0, 2, kBox, []), [mod(3.5 - 4, 6), 1, 2]);
  assert.deepEqual(readVelocity(path, 0, 2, kBox, []), [0.25 - 1.5, 1, 0]);
  assert.deepEqual(readVelocity(path, 0, 0.5, kBox, []), [0.25, 1, 0]);
});

test('the pieces of a path in a sheared box follow the sphere', () => {
  for (const path of [
    [3, 4, 2, 0.7, 1.3, 0.2, 1],
    [1, 1, 1, -2, -0.9, 0.1, 0],
  ]) {
    const [from, until] = [path[6] + 0.4, path[6] + 30];
    const pieces = piecesInBox(path, from, until, kBox, { most: 1000 });
    for (const point of pieces.flat())
      point.forEach((place, axis) => assert.ok(place > -1e-9 && place < kBox.size[axis] + 1e-9));
    const isOn = ([begin, end], point) => {
      const length = Math.hypot(...end.map((place, axis) => place - begin[axis]));
      const apart = (a, b) => Math.hypot(...a.map((place, axis) => place - b[axis]));
      return apart(begin, point) + apart(point, end) < length + 1e-9;
    };
    for (let time = from; time < until; time += 0.37) {
      const center = readCenter(path, 0, time, kBox, []);
      assert.ok(
        pieces.some((piece) => isOn(piece, center)),
        `at ${time}`,
      );
    }
  }
});
