// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import { show, showTime } from '../../../apps/viewer/page/src/panel/numbers.js';
import { Quality } from '../../../apps/viewer/page/src/scene/quality.js';
import { summarize } from '../../../apps/viewer/page/src/statistics/chunk_summary.js';
import { Sizes } from '../../../apps/viewer/page/src/statistics/sizes.js';
import {
  density,
  findKinds,
  maxwellDensity,
  quantile,
  roundUp,
} from '../../../apps/viewer/page/src/statistics/speeds.js';
import { assertNear } from '../support/near.mjs';
import { randomSpheres, recordSmallGas } from '../support/small_gas.mjs';
import { StoredSource } from '../support/stored_source.mjs';

test('intervals of a chunk contain all its contacts, and the energy that collisions conserve', () => {
  const box = { size: [5, 5, 5], boundary: ['wall', 'wall', 'wall'] };
  const { chunks, masses } = new StoredSource(
    recordSmallGas({ box, ...randomSpheres(27, 5), until: 20, contactsOfChunk: 1000 }),
  );
  const [chunk] = chunks;
  const intervals = summarize(chunk, masses, 0);
  assert.ok(intervals.length > 1);
  const length = (chunk.end - chunk.begin) / intervals.length;
  const total = intervals.reduce((sum, { collisions, walls }) => sum + (collisions + walls) * length, 0);
  assertNear(total, chunk.contacts, 1e-6);
  const walls = Array.from({ length: chunk.contacts }, (_, k) => chunk.second(k)).filter(
    (second) => second < 0,
  ).length;
  assertNear(
    intervals.reduce((sum, interval) => sum + interval.walls * length, 0),
    walls,
    1e-6,
  );
  for (const { energy } of intervals) assertNear(energy, intervals[0].energy, 1e-9);
});

for (const dimensions of [3, 2]) {
  test(`Maxwell's density in ${dimensions} dimensions has the area one and the mean square of its temperature`, () => {
    const species = [
      { mass: 1, count: 30 },
      { mass: 4, count: 10 },
      { mass: Infinity, count: 5 },
    ];
    let area = 0;
    let squares = 0;
    for (let k = 0; k < 20000; ++k) {
      const speed = (k + 0.5) * 1e-3;
      const share = maxwellDensity(speed, species, 2, dimensions) * 1e-3;
      area += share;
      squares += share * speed ** 2;
    }
    assertNear(area, 1, 1e-6);
    assertNear(squares, (dimensions * 2 * (30 / 1 + 10 / 4)) / 40, 1e-5);
  });
}

test('a density sums to the share of values below its end', () => {
  const shares = density([0.1, 0.2, 1.5, 2.5], 2, 4);
  assert.deepEqual([...shares], [1, 0, 0, 0.5]);
});

test('spheres of equal radius and mass are one species', () => {
  const { of, list } = findKinds([1, 2, 1, 1], [1, 1, 1, 3]);
  assert.deepEqual([...of], [0, 1, 0, 2]);
  assert.deepEqual(
    list.map(({ count }) => count),
    [2, 1, 1],
  );
});

test('sizes that differ by more than a factor of ten have a logarithmic scale, and none is drawn too small', () => {
  const wide = new Sizes(Float64Array.of(0.5, 0.01, 1));
  assert.deepEqual([wide.smallest, wide.largest, wide.areWide, wide.leastPixels], [0.01, 1, true, 3]);
  assert.deepEqual(wide.range(false), [0.01, 1]);
  assert.deepEqual(wide.range(true), [1, 0.01]);
  const narrow = new Sizes(Float64Array.of(0.5, 0.2));
  assert.ok(!narrow.areWide && narrow.leastPixels < 2);
  assert.deepEqual(new Sizes(Float64Array.of(2, 2)).range(false), [0, 4]);
});

test('ends of ranges are round and contain their values', () => {
  for (const value of [0.0123, 0.99, 1, 17.3, 4500]) {
    assert.ok(roundUp(value) >= value);
    assert.ok(roundUp(value) <= 1.6 * value);
  }
  assert.equal(quantile([5, 1, 3, 2, 4], 0.5), 3);
});

test('numbers are formatted for people', () => {
  assert.equal(show(0), '0');
  assert.equal(show(-1.23456), '−1.235');
  assert.equal(show(1.5e-7, 2), '1.5·10⁻⁷');
  assert.equal(show(null), '–');
  assert.equal(showTime(1.23456, 0.01), '1.23');
});

test('drawing quality drops step by step while frames are slow, and never if it is fixed', () => {
  const chosen = [];
  const quality = new Quality(1, (way) => chosen.push(way.name));
  for (let frame = 0; frame < 200; ++frame) quality.note(1 / 60);
  assert.deepEqual(chosen, []);
  for (let frame = 0; frame < 200; ++frame) quality.note(1 / 10);
  // On a screen of pixel ratio 1 a lower limit of that ratio would change nothing.
  assert.deepEqual(chosen, ['points', 'coarse']);
  const fixed = new Quality(2, (way) => chosen.push(way.name));
  fixed.fix('full');
  for (let frame = 0; frame < 200; ++frame) fixed.note(1);
  assert.deepEqual(chosen, ['points', 'coarse']);
});
