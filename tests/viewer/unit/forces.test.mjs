// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import { countContacts, linesOf } from '../../../apps/viewer/page/src/motion/forces.js';

const kCenters = [
  [1, 5, 5],
  [9, 5, 5],
  [1, 1, 5],
];
const kRadii = [0.5, 1.5, 1];
const lines = (forces) => linesOf(forces, (id) => kCenters[id], (id) => kRadii[id]);

test('lines of a force across a periodic face end where the spheres touch, on either side', () => {
  const [first, second, ...others] = lines([[0, 1, -2, 0, 0, 1]]);
  assert.equal(others.length, 0);
  assert.deepEqual(first.begin, kCenters[0]);
  assert.deepEqual(first.end, [0.5, 5, 5]);
  assert.deepEqual(second.begin, kCenters[1]);
  assert.deepEqual(second.end, [10.5, 5, 5]);
});

test('a force of a wall is one line to it', () => {
  const [line, ...others] = lines([[2, -3, 0, -1, 0, 2]]);
  assert.equal(others.length, 0);
  assert.deepEqual(line.end, [1, 0, 5]);
});

test('stronger forces have thicker lines, and unknown ones are thin', () => {
  const widths = [4, 1, 0, null].map((force) => lines([[0, 1, -2, 0, 0, force]])[0].halfWidth);
  assert.equal(widths[0], 2 * widths[1]);
  assert.ok(widths[1] > widths[2] && widths[2] > 0);
  assert.equal(widths[3], widths[2]);
});

test('contacts count for both spheres, and those with walls for one', () => {
  const forces = [
    [0, 1, -2, 0, 0, 1],
    [1, 2, 0, 1, 0, null],
    [2, -3, 0, -1, 0, 2],
  ];
  assert.deepEqual([...countContacts(forces, 4)], [1, 2, 2, 0]);
});
