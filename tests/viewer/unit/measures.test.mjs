// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Box } from '../../../apps/viewer/page/src/motion/box.js';
import { readRecording } from '../../../apps/viewer/page/src/recording/recording_file.js';
import { countNeighbors } from '../../../apps/viewer/page/src/statistics/neighbors.js';
import { Displacement } from '../../../apps/viewer/page/src/statistics/displacement.js';
import { radialDistribution } from '../../../apps/viewer/page/src/statistics/pairs.js';
import { randomSpheres, recordSmallGas } from '../support/small_gas.mjs';

const kPeriodic = new Box({ size: [10, 10, 10], boundary: ['periodic', 'periodic', 'periodic'] });

// A fixed sequence.
function randomNumbers() {
  let state = 11;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

test('g(r) of points anywhere is one, also between walls and in two dimensions', () => {
  const random = randomNumbers();
  const centers = Float64Array.from({ length: 3 * 3000 }, () => 10 * random());
  const walls = new Box({ size: [10, 10, 10], boundary: ['wall', 'periodic', 'wall'] });
  const flat = new Box({ size: [10, 10, 0], boundary: ['periodic', 'wall', 'flat'] });
  const inPlane = centers.map((place, k) => (k % 3 === 2 ? 0 : place));
  for (const [places, box] of [
    [centers, kPeriodic],
    [centers, walls],
    [inPlane, flat],
  ]) {
    const [middles, g] = radialDistribution(places, 0.5, box, 0);
    assert.ok(middles.at(-1) < 3 && middles.at(-1) > 2.9);
    const outer = g.slice(24);
    const mean = outer.reduce((sum, value) => sum + value, 0) / outer.length;
    assert.ok(Math.abs(mean - 1) < 0.05, `${mean}`);
  }
});

test('g(r) of a lattice is zero but at its distances', () => {
  const centers = Float64Array.from({ length: 1000 }, (_, k) => k).reduce((list, k) => {
    list.push((k % 10) + 0.1, (Math.floor(k / 10) % 10) + 0.2, Math.floor(k / 100) + 0.3);
    return list;
  }, []);
  const [middles, g] = radialDistribution(Float64Array.from(centers), 0.5, kPeriodic, 0);
  const near = (r) => [1, Math.SQRT2, Math.sqrt(3), 2, Math.sqrt(5), Math.sqrt(6), Math.sqrt(8), 3].some((d) => Math.abs(d - r) < 0.07);
  middles.forEach((r, k) => assert.ok(g[k] === 0 || near(r), `${r}`));
  const first = middles.findIndex((r) => r + 1 / 32 > 1 - 1e-9);
  assert.ok(g[first] > 2 || g[first + 1] > 2);
});

test('there is no g(r) in open space, and of few spheres', () => {
  const centers = Float64Array.from({ length: 90 }, (_, k) => k % 7);
  assert.equal(radialDistribution(centers, 0.5, new Box({ size: [7, 7, 7], boundary: ['open', 'wall', 'wall'] }), 0), null);
  assert.equal(radialDistribution(centers.subarray(0, 30), 0.5, kPeriodic, 0), null);
});

test('the displacement counts each box that is crossed', () => {
  const box = { size: [6, 6, 6], boundary: ['periodic', 'periodic', 'periodic'] };
  const gas = { ...randomSpheres(27, 6), until: 12, contactsOfChunk: 40, box };
  const { header, masses, chunks } = readRecording(recordSmallGas(gas));
  const displacement = new Displacement(masses, new Box(header.box));
  assert.ok(chunks.length > 3);
  for (const chunk of chunks) displacement.add(chunk);
  assert.equal(displacement.next, chunks.length);
  // The slow twin: many short steps, each shorter than half a box.
  const place = (id, time) => {
    const chunk = chunks.find(({ end }) => time <= end);
    const path = new Float64Array(7);
    chunk.readPath(id, chunk.contactsUntil(time), path);
    return [0, 1, 2].map((axis) => path[axis] + (time - path[6]) * path[3 + axis]);
  };
  const steps = 6000;
  let sum = 0;
  for (let id = 0; id < 27; ++id) {
    const total = [0, 0, 0];
    let before = place(id, 0);
    for (let k = 1; k <= steps; ++k) {
      const now = place(id, (12 * k) / steps);
      for (let axis = 0; axis < 3; ++axis) {
        const difference = now[axis] - before[axis];
        total[axis] += difference - 6 * Math.round(difference / 6);
      }
      before = now;
    }
    sum += total.reduce((squares, part) => squares + part ** 2, 0);
  }
  assert.equal(displacement.times.at(-1), 12);
  assert.ok(Math.abs(displacement.squares.at(-1) / (sum / 27) - 1) < 1e-6, `${displacement.squares.at(-1)} and ${sum / 27}`);
  assert.ok(displacement.squares.at(-1) > 9);
});

test('neighbors are found as by comparing all pairs', () => {
  const random = randomNumbers();
  for (const box of [
    kPeriodic,
    new Box({ size: [10, 10, 10], boundary: ['wall', 'open', 'periodic'] }),
    new Box({ size: [10, 10, 0], boundary: ['periodic', 'periodic', 'flat'] }),
    new Box({ size: [10, 10, 10], boundary: ['periodic', 'periodic', 'periodic'], shear_rate: 0.3 }),
    new Box({ size: [2, 2, 2], boundary: ['periodic', 'periodic', 'periodic'] }),
  ]) {
    const count = 300;
    const edge = box.size[0];
    const radii = Float64Array.from({ length: count }, (_, id) => (id % 17 === 0 ? 0 : 0.02 * edge * (1 + random())));
    const centers = Float64Array.from({ length: 3 * count }, (_, k) => (box.isFlat && k % 3 === 2 ? 0 : edge * random()));
    const expected = new Uint16Array(count);
    for (let id = 0; id < count; ++id)
      for (let other = 0; other < count; ++other) {
        if (other === id || radii[id] === 0 || radii[other] === 0) continue;
        const apart = [0, 1, 2].map((axis) => centers[3 * other + axis] - centers[3 * id + axis]);
        if (Math.hypot(...box.nearestApart(apart, 2)) <= 1.2 * (radii[id] + radii[other])) ++expected[id];
      }
    assert.deepEqual(countNeighbors(centers, radii, box, 2), expected);
    assert.ok(expected.reduce((sum, value) => sum + value, 0) > 50);
  }
});
