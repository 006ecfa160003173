// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import { Box } from '../../../apps/viewer/page/src/motion/box.js';
import { Cells } from '../../../apps/viewer/page/src/motion/cells.js';
import { recentPaths } from '../../../apps/viewer/page/src/motion/contacts_of.js';
import { typicalScales } from '../../../apps/viewer/page/src/motion/default_speed.js';
import {
  crossingTime,
  piecesInBox,
  placeAfter,
  rangeOf,
  readCenter,
  readVelocity,
} from '../../../apps/viewer/page/src/motion/path.js';
import { readRecording } from '../../../apps/viewer/page/src/recording/recording_file.js';
import { summarize } from '../../../apps/viewer/page/src/statistics/chunk_summary.js';
import { readSpeeds } from '../../../apps/viewer/page/src/statistics/speeds.js';
import { recordLoneSpheres } from '../support/lone_spheres.mjs';
import { assertNear } from '../support/near.mjs';

const kGravity = [0.5, 0, -2];
const kBox = new Box({ size: [10, 20, 6], boundary: ['periodic', 'wall', 'periodic'] }, kGravity);

// Numbers from −1 to 1, always the same.
function randomNumbers(seed) {
  let state = seed;
  return () => ((state = (state * 48271) % 2147483647) / 2147483647) * 2 - 1;
}

test('a center follows a parabola, and the velocity changes along it', () => {
  const path = [1, 5, 1, 2, 1, 3, 100];
  assert.deepEqual(readCenter(path, 0, 102, kBox, []), [6, 7, 3]);
  assert.deepEqual(readVelocity(path, 0, 102, kBox, []), [3, 1, -1]);
  // 1 + 3 · 4 − 16 = −3, one box below.
  assert.deepEqual(readCenter(path, 0, 104, kBox, []), [3, 9, 3]);
  assert.deepEqual(readCenter(path, 0, 100, kBox, []), [1, 5, 1]);
});

test('a level is crossed when and in the direction that the motion says', () => {
  const random = randomNumbers(3);
  let crossed = 0;
  for (let k = 0; k < 2000; ++k) {
    const [place, velocity, level] = [random(), random(), 2 * random()];
    const gravity = k % 10 === 0 ? 0 : random() * 10 ** (6 * random() - 3);
    for (const forward of [1, -1]) {
      const time = crossingTime(place, velocity, gravity, level, forward);
      if (time === Infinity) {
        // Then the extreme place is not beyond the level, or the motion is straight and in the other direction.
        const extreme = place - velocity ** 2 / (2 * gravity);
        assert.ok(gravity === 0 ? velocity * forward <= 0 : (level - extreme) * gravity < 0);
        continue;
      }
      ++crossed;
      const size = Math.abs(velocity * time) + Math.abs(gravity) * time ** 2 + 2;
      assertNear(placeAfter(time, place, velocity, gravity), level, 1e-13 * size);
      assert.ok((velocity + gravity * time) * forward >= -1e-9);
    }
  }
  assert.ok(crossed > 1000);
});

test('the range of a motion includes where it turns', () => {
  const path = [1, 5, 1, 2, 1, 3, 0];
  assert.deepEqual(rangeOf(path, 2, 0, 4, kBox), [-3, 3.25]);
  assert.deepEqual(rangeOf(path, 2, 0, 1, kBox), [1, 3]);
  assert.deepEqual(rangeOf(path, 1, 1, 3, kBox), [6, 8]);
});

test('a drawn parabola is cut at periodic faces, and deviates by no more than its tolerance', () => {
  const random = randomNumbers(5);
  for (let k = 0; k < 50; ++k) {
    const path = [5 + 5 * random(), 10, 3 + 3 * random(), 4 * random(), random(), 6 * random(), 7];
    const [from, until, tolerance] = [7 + 0.5 * k, 12 + 0.5 * k, 0.01];
    const pieces = piecesInBox(path, from, until, kBox, { most: 1000, tolerance });
    assert.ok(pieces.length > 10);
    const same = (place, expected, what) => {
      for (let axis = 0; axis < 3; ++axis)
        assertNear(kBox.nearest(place[axis] - expected[axis], axis), 0, 1e-9, `${what} along ${axis}`);
    };
    same(pieces[0][0], readCenter(path, 0, from, kBox, []), 'the first point');
    same(pieces.at(-1)[1], readCenter(path, 0, until, kBox, []), 'the last point');
    pieces.forEach(([begin, end], number) => {
      if (number > 0) same(begin, pieces[number - 1][1], `point ${number}`);
      for (const place of [begin, end]) {
        for (const axis of [0, 2])
          assert.ok(place[axis] > -1e-9 && place[axis] < kBox.size[axis] + 1e-9, `${place} is outside`);
      }
    });
    // Along y the motion is uniform: it tells the time of each point.
    for (const [begin, end] of path[4] === 0 ? [] : pieces) {
      const middle = [0, 1, 2].map((axis) => (begin[axis] + end[axis]) / 2);
      const time = path[6] + (middle[1] - path[1]) / path[4];
      const center = readCenter(path, 0, time, kBox, []);
      const apart = Math.hypot(...middle.map((place, axis) => kBox.nearest(place - center[axis], axis)));
      assert.ok(apart < 1.01 * tolerance, `${apart}`);
    }
  }
});

test('a motion that turns at a periodic face stays in its box', () => {
  const box = new Box({ size: [4, 4, 4], boundary: ['periodic', 'periodic', 'periodic'] }, [0, 0, -2]);
  // It rises from 3 and turns at 4, after one unit of time.
  const pieces = piecesInBox([1, 1, 3, 0, 0, 2, 0], 0, 2, box, { tolerance: 0.01 });
  assert.deepEqual(pieces.at(-1)[1], [1, 1, 3]);
});

test('the next crossing under gravity is the first at which the cells touched change', () => {
  const cells = new Cells([3, 2, 1.5], [0.1, 0, -0.2], kBox);
  const random = randomNumbers(11);
  const radius = 0.4;
  for (let k = 0; k < 200; ++k) {
    const path = [5 * random(), 5 * random(), 5 * random(), random(), random(), 5 * random(), 1];
    const time = 1 + 2 * Math.abs(random());
    const next = cells.nextCrossing(path, radius, time);
    const touched = (moment) =>
      [0, 1, 2]
        .flatMap((axis) => {
          const place = placeAfter(moment - path[6], path[axis], path[3 + axis], kGravity[axis]);
          return [cells.index(place - radius, axis), cells.index(place + radius, axis)];
        })
        .join(' ');
    const before = touched(time + 1e-9);
    for (let share = 0.05; share < 1; share += 0.05)
      assert.equal(touched(time + share * (next.time - time) + 1e-9 * (1 - share)), before);
    assert.notEqual(touched(next.time + 1e-6), before);
  }
});

// Spheres that bounce between a floor and a ceiling.
const kBouncing = {
  box: { size: [8, 8, 8], boundary: ['periodic', 'open', 'wall'] },
  gravity: [0, 0, -3],
  radii: [0.5, 0.25, 0.75],
  masses: [1, 2, 3],
  positions: [
    [1, 1, 4],
    [2, 1, 7],
    [3, 1, 2],
  ],
  velocities: [
    [1, 0, 0],
    [0, 1, 2],
    [-1, 0.5, 9],
  ],
  until: 6,
};

test('paths lead from contact to contact', () => {
  const { header, radii, chunks } = readRecording(recordLoneSpheres(kBouncing));
  const box = new Box(header.box, header.gravity);
  assert.deepEqual(box.gravity, [0, 0, -3]);
  const store = { get: (number) => chunks[number] };
  for (let id = 0; id < 3; ++id) {
    const paths = recentPaths(store, id, 0, chunks[0].contacts, 100);
    assert.ok(paths.length > 1);
    for (let k = 1; k < paths.length; ++k) {
      const end = readCenter(paths[k].numbers, 0, paths[k].until, box, []);
      assertNear(end[2], paths[k - 1].numbers[2], 1e-9);
      const isAtFace = Math.min(end[2], 8 - end[2]) - radii[id];
      assertNear(isAtFace, 0, 1e-9);
    }
  }
});

test('speeds are those at the time shown', () => {
  const { masses, chunks } = readRecording(recordLoneSpheres(kBouncing));
  const speeds = new Float64Array(3);
  const box = new Box(kBouncing.box, kBouncing.gravity);
  const { energy } = readSpeeds(chunks[0].keyframe, 0.5, masses, box, speeds);
  const expected = [Math.hypot(1, 1.5), Math.hypot(1, 0.5), Math.hypot(1, 0.5, 7.5)];
  expected.forEach((speed, id) => assertNear(speeds[id], speed, 1e-12));
  assertNear(
    energy,
    expected.reduce((sum, speed, id) => sum + (masses[id] * speed ** 2) / 2, 0),
    1e-12,
  );
});

test('kinetic and potential energy together are conserved', () => {
  const { masses, chunks } = readRecording(recordLoneSpheres({ ...kBouncing, until: 400 }));
  const intervals = summarize(chunks[0], masses, 0, kBouncing.gravity);
  assert.ok(intervals.length > 1);
  const height = (place) => 3 * place[2];
  const energy = kBouncing.positions.reduce(
    (sum, place, id) => sum + masses[id] * (Math.hypot(...kBouncing.velocities[id]) ** 2 / 2 + height(place)),
    0,
  );
  for (const interval of intervals) assertNear(interval.energy, energy, 1e-9 * energy);
});

test('spheres that start at rest under gravity have a typical speed', () => {
  const { header, radii, chunks } = readRecording(
    recordLoneSpheres({ ...kBouncing, velocities: kBouncing.velocities.map(() => [0, 0, 0]) }),
  );
  const { speed, playing } = typicalScales(chunks[0], radii, header);
  assert.ok(speed > 0.5 && speed < 10, `${speed}`);
  assert.ok(playing > 0.01 && playing < 1, `${playing}`);
});
