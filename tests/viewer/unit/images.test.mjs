// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import { Box } from '../../../apps/viewer/page/src/motion/box.js';
import { Images } from '../../../apps/viewer/page/src/motion/images.js';
import { readCenter } from '../../../apps/viewer/page/src/motion/path.js';
import { pick } from '../../../apps/viewer/page/src/scene/pick.js';
import { randomSpheres } from '../support/small_gas.mjs';

const kNone = { count: 0 };

function playbackOf({ positions, velocities }, time) {
  return {
    paths: Float64Array.from(positions.flatMap((place, id) => [...place, ...velocities[id], 0])),
    time,
  };
}

function list(images) {
  return Array.from({ length: images.count }, (_, k) => {
    const place = [...images.centers.subarray(3 * k, 3 * k + 3)].map((part) => part.toFixed(9));
    return `${images.ids[k]}: ${place}`;
  });
}

for (const boundary of [
  ['periodic', 'periodic', 'periodic'],
  ['periodic', 'wall', 'periodic'],
  ['wall', 'open', 'wall'],
]) {
  test(`the images in a box that is ${boundary} are those that reach into it`, () => {
    const box = new Box({ size: [6, 5, 7], boundary }, [0, 0, -1]);
    const spheres = randomSpheres(125, 6);
    const images = new Images(spheres.radii, box);
    for (const time of [0, 1.5, 40]) {
      const playback = playbackOf(spheres, time);
      images.update(playback);
      const expected = [];
      for (let id = 0; id < 125; ++id) {
        const center = readCenter(playback.paths, 7 * id, time, box, []);
        for (let n = 0; n < 27; ++n) {
          const steps = [Math.floor(n / 9) - 1, (Math.floor(n / 3) % 3) - 1, (n % 3) - 1];
          if (steps.every((step) => step === 0)) continue;
          if (steps.some((step, axis) => step !== 0 && box.period[axis] === 0)) continue;
          const image = center.map((place, axis) => place + steps[axis] * box.period[axis]);
          const reaches = image.every(
            (place, axis) =>
              steps[axis] === 0 ||
              (place + spheres.radii[id] > 0 && place - spheres.radii[id] < box.size[axis]),
          );
          if (reaches) expected.push(`${id}: ${image.map((part) => part.toFixed(9))}`);
        }
      }
      assert.deepEqual(list(images).sort(), expected.sort());
      if (time > 0)
        assert.equal(
          images.count > 0,
          box.period.some((period) => period > 0),
        );
    }
    images.clear();
    assert.equal(images.count, 0);
  });
}

const kBox = new Box({ size: [10, 10, 10], boundary: ['periodic', 'wall', 'wall'] });
const kRay = { origin: { x: 5, y: 5, z: 100 }, direction: { x: 0, y: 0, z: -1 } };
const kOptions = { tolerance: 0.01, leastSize: 0, isShown: () => true, images: kNone };

function resting(positions) {
  return playbackOf({ positions, velocities: positions.map(() => [0, 0, 0]) }, 3);
}

test('the sphere picked is the first that the ray meets', () => {
  const playback = resting([
    [5, 5, 2],
    [5.4, 5, 6],
    [5, 5, 4],
  ]);
  const radii = [1, 0.5, 0.5];
  assert.equal(pick(playback, radii, kBox, kRay, kOptions), 1);
  const isShown = (id) => id !== 1;
  assert.equal(pick(playback, radii, kBox, kRay, { ...kOptions, isShown }), 2);
  // The front counts, not the center.
  assert.equal(pick(playback, [4.7, 0.5, 0.5], kBox, kRay, kOptions), 0);
  const upward = { origin: kRay.origin, direction: { x: 0, y: 0, z: 1 } };
  assert.equal(pick(playback, radii, kBox, upward, kOptions), -1);
});

test('a near miss is picked only if nothing is met', () => {
  const playback = resting([
    [5, 5, 2],
    [5.5, 5, 6],
    [5.3, 5, 1],
  ]);
  assert.equal(pick(playback, [1, 0.1, 0.1], kBox, kRay, kOptions), 0);
  assert.equal(pick(playback, [1, 0.1, 0.1], kBox, kRay, { ...kOptions, isShown: (id) => id > 0 }), 2);
  assert.equal(
    pick(playback, [1, 0.1, 0.1], kBox, kRay, { ...kOptions, tolerance: 1e-3, isShown: (id) => id > 0 }),
    -1,
  );
});

test('a sphere drawn larger than it is can be picked where it is drawn', () => {
  const playback = resting([
    [5, 5, 2],
    [5.05, 5, 8],
  ]);
  assert.equal(pick(playback, [1, 0.001], kBox, kRay, kOptions), 0);
  assert.equal(pick(playback, [1, 0.001], kBox, kRay, { ...kOptions, leastSize: 0.001 }), 1);
});

test('an image picked stands for its sphere', () => {
  const playback = resting([
    [5, 5, 2],
    [9.8, 5, 4],
  ]);
  const radii = [0.5, 0.5];
  const images = new Images(radii, kBox);
  images.update(playback);
  const outside = { ...kRay, origin: { x: -0.3, y: 5, z: 100 } };
  assert.equal(pick(playback, radii, kBox, outside, kOptions), -1);
  assert.equal(pick(playback, radii, kBox, outside, { ...kOptions, images }), 1);
});
