// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Domains of live runs: blocks, from when they hold, and which of them a sphere is in.
import assert from 'node:assert/strict';
import test from 'node:test';
import { Domains, nearestBlock } from '../../../apps/viewer/page/src/motion/domains.js';

// As a status describes it: two blocks side by side, periodic along y, between walls along the other axes.
function cutAt(x, from) {
  return {
    from,
    blocks: [
      { low: [null, 0, null], high: [x, 10, null] },
      { low: [x, 0, null], high: [null, 10, null] },
    ],
  };
}
const kWhole = { from: 0, blocks: [{ low: [null, 0, null], high: [null, 10, null] }] };

test('a recording has no domains', () => {
  const domains = new Domains();
  domains.update(undefined);
  domains.update([]);
  assert.ok(!domains.areSeveral);
  assert.deepEqual(domains.at(1), []);
  assert.equal(nearestBlock(domains.at(1), [1, 1, 1]), -1);
});

test('a run in one thread has one', () => {
  const domains = new Domains();
  domains.update([kWhole]);
  assert.ok(!domains.areSeveral);
  assert.equal(nearestBlock(domains.at(1), [-3, 1, 1e9]), 0);
});

test('a sphere is in the block that holds its center', () => {
  const domains = new Domains();
  domains.update([cutAt(4, 0)]);
  assert.ok(domains.areSeveral);
  const blocks = domains.at(0);
  assert.equal(nearestBlock(blocks, [-0.5, 3, 2]), 0);
  assert.equal(nearestBlock(blocks, [3.9, 3, 2]), 0);
  assert.equal(nearestBlock(blocks, [4.1, 3, -2]), 1);
  assert.equal(nearestBlock(blocks, [4.1, 10.000001, 2]), 1, 'beside all by rounding');
});

test('each division holds until the next', () => {
  const domains = new Domains();
  domains.update([kWhole, cutAt(4, 1)]);
  // A status repeats what earlier ones said.
  domains.update([kWhole, cutAt(4, 1), cutAt(6, 2)]);
  assert.equal(domains.at(0.5).length, 1);
  const numberAt = (time) => nearestBlock(domains.at(time), [5, 5, 5]);
  assert.deepEqual([-1, 0, 1, 1.9, 2, 7].map(numberAt), [0, 0, 1, 1, 0, 0]);
  assert.equal(domains.at(1), domains.at(1.5), 'the same list');
});
