// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import { halvesOf } from '../../../apps/viewer/page/src/motion/bonds.js';
import { Box } from '../../../apps/viewer/page/src/motion/box.js';

test('the halves of a bond meet in its middle', () => {
  const box = new Box({ size: [10, 10, 10], boundary: ['wall', 'wall', 'wall'] });
  const [first, second] = halvesOf([1, 2, 3], [9, 4, 3], box, 0);
  assert.deepEqual(first, [[1, 2, 3], [5, 3, 3]]);
  assert.deepEqual(second, [[9, 4, 3], [5, 3, 3]]);
});

test('a bond through a periodic face leaves the box on both sides and does not cross it', () => {
  const box = new Box({ size: [10, 10, 10], boundary: ['periodic', 'wall', 'wall'] });
  const [first, second] = halvesOf([1, 2, 3], [9, 4, 3], box, 0);
  assert.deepEqual(first, [[1, 2, 3], [0, 3, 3]]);
  assert.deepEqual(second, [[9, 4, 3], [10, 3, 3]]);
});
