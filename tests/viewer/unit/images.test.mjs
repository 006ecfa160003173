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

const kSize = [6, 5, 7];
const kPeriodic = ['periodic', 'periodic', 'periodic'];
const kShear = { shear_rate: 0.3, shear_offset: 1 };

// By shear, the images of images lie up to forty boxes away along x.
for (const { name, box, reach, digits } of [
  { name: 'periodic', box: new Box({ size: kSize, boundary: kPeriodic }, [0, 0, -1]), reach: 1, digits: 9 },
  {
    name: 'periodic but for walls',
    box: new Box({ size: kSize, boundary: ['periodic', 'wall', 'periodic'] }, [0, 0, -1]),
    reach: 1,
    digits: 9,
  },
  { name: 'bounded', box: new Box({ size: kSize, boundary: ['wall', 'open', 'wall'] }, [0, 0, -1]), reach: 1, digits: 9 },
  { name: 'sheared', box: new Box({ size: kSize, boundary: kPeriodic, ...kShear }), reach: 40, digits: 7 },
]) {
  test(`the images in a box that is ${name} are those that reach into it`, () => {
    const spheres = randomSpheres(125, 6);
    const images = new Images(spheres.radii, box);
    const text = (id, place) => `${id}: ${[...place].map((part) => part.toFixed(digits))}`;
    for (const time of [0, 1.5, 40]) {
      const playback = playbackOf(spheres, time);
      images.update(playback);
      const expected = [];
      for (let id = 0; id < 125; ++id) {
        const center = readCenter(playback.paths, 7 * id, time, box, []);
        for (let n = 0; n < 9 * (2 * reach + 1); ++n) {
          const steps = [Math.floor(n / 9) - reach, (Math.floor(n / 3) % 3) - 1, (n % 3) - 1];
          if (steps.every((step) => step === 0)) continue;
          if (steps.some((step, axis) => step !== 0 && box.period[axis] === 0)) continue;
          const image = center.map((place, axis) => place + steps[axis] * box.period[axis]);
          if (name === 'sheared') image[0] += steps[1] * box.displacement(time);
          const reaches = image.every(
            (place, axis) =>
              (steps[axis] === 0 && name !== 'sheared') ||
              (place + spheres.radii[id] > 0 && place - spheres.radii[id] < box.size[axis]),
          );
          if (reaches) expected.push(text(id, image));
        }
      }
      const list = Array.from({ length: images.count }, (_, k) =>
        text(images.ids[k], images.centers.subarray(3 * k, 3 * k + 3)),
      );
      assert.deepEqual(list.sort(), expected.sort());
      if (time > 0)
        assert.equal(
          images.count > 10,
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
