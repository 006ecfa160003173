// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import { Box } from '../../../apps/viewer/page/src/motion/box.js';
import { Cells } from '../../../apps/viewer/page/src/motion/cells.js';
import { placeAfter } from '../../../apps/viewer/page/src/motion/path.js';

const kBox = new Box({ size: [20, 20, 20], boundary: ['wall', 'periodic', 'open'] });
const kFalling = new Box({ size: [10, 20, 6], boundary: ['periodic', 'wall', 'periodic'] }, [0.5, 0, -2]);

test('a sphere enters a layer with its front and leaves it with its back', () => {
  const cells = new Cells([5, 5, 5], [0, 0, 0], kBox);
  const path = [7, 12, 1, 2, -1, 0, 100];
  // Along x: front at 8, layer 2 starts at 10; back at 6, layer 2 ends at 15.
  assert.deepEqual(cells.layerTimes(path, 1, 2, 0), [[101, 104.5]]);
  // Along y: front at 11, layer 1 ends at 10; back at 13, layer 1 starts at 5.
  assert.deepEqual(cells.layerTimes(path, 1, 1, 1), [[101, 108]]);
  // Along z it rests from 0 to 2, and a layer does not contain its end.
  assert.deepEqual(cells.layerTimes(path, 1, -1, 2), []);
  assert.deepEqual(cells.layerTimes(path, 1, 0, 2), [[-Infinity, Infinity]]);
  assert.deepEqual(cells.layerTimes(path, 1, 1, 2), []);
  assert.deepEqual(cells.cellTimes(path, 1, [2, 1, 0]), [[101, 104.5]]);
});

test('origin and edges may differ along the axes', () => {
  const cells = new Cells([5, 4, 2], [1, -2, 0.5], kBox);
  assert.deepEqual(cells.layerTimes([7, 12, 1, 2, 0, 0, 0], 1, 2, 0), [[1.5, 5]]);
  assert.equal(cells.index(-1.9, 1), 0);
  assert.equal(cells.begin(3, 2), 6.5);
});

test('cells fold into the box where it is periodic', () => {
  const cells = Cells.fitting(5.2, kBox);
  assert.deepEqual(cells.edge, [5, 5, 5.2]);
  assert.equal(cells.begin(4, 1), 0);
  assert.equal(cells.begin(-1, 1), 15);
  assert.equal(cells.begin(-1, 2), -5.2);
});

// Straight, and thrown up under gravity, so that a cell is entered again on the way down.
for (const { box, path, isThrown } of [
  { box: kBox, path: [10.3, 9.1, 4.7, 1.3, -0.7, 0.4, 2], isThrown: false },
  { box: kFalling, path: [5.3, 9.1, 1.7, -2, -0.2, 7.4, 2], isThrown: true },
]) {
  test(`the cells visited are those that the bounding box touches, and when: thrown ${isThrown}`, () => {
    const cells = new Cells([3, 3, 3], [0, 0, 0], box);
    const radius = 0.8;
    const [from, until, steps] = [3, 9, 60000];
    const touched = new Map();
    for (let step = 0; step <= steps; ++step) {
      const time = from + ((until - from) * step) / steps;
      const center = [0, 1, 2].map((axis) =>
        placeAfter(time - path[6], path[axis], path[3 + axis], box.gravity[axis]),
      );
      const [low, high] = [-radius, radius].map((side) =>
        center.map((place, axis) => cells.index(place + side, axis)),
      );
      for (let x = low[0]; x <= high[0]; ++x) {
        for (let y = low[1]; y <= high[1]; ++y) {
          for (let z = low[2]; z <= high[2]; ++z) {
            const times = touched.get(`${x} ${y} ${z}`) ?? [];
            touched.set(`${x} ${y} ${z}`, times);
            if (times.length > 0 && step - times.at(-1).last <= 1) times.at(-1).last = step;
            else times.push({ first: step, last: step });
          }
        }
      }
    }
    const length = (until - from) / steps;
    let visits = 0;
    cells.visit(path, radius, from, until, (indices, enter, leave) => {
      const begin = Math.max(enter, from);
      const end = Math.min(leave, until);
      const isFound = (touched.get(indices.join(' ')) ?? []).some(
        ({ first, last }) =>
          Math.abs(from + first * length - begin) <= 2 * length &&
          Math.abs(from + last * length - end) <= 2 * length,
      );
      if (isFound) ++visits;
      // Cells touched for less than the resolution may be missed by the steps.
      else assert.ok(end - begin <= 2 * length, `${indices} from ${begin} to ${end}`);
    });
    const times = [...touched.values()];
    assert.equal(visits, times.flat().length);
    assert.ok(visits > 10);
    assert.equal(times.some(({ length }) => length === 2), isThrown);
  });
}

test('the next crossing is the first of all that enter or leave', () => {
  const cells = new Cells([5, 5, 5], [0, 0, 0], kBox);
  const path = [7, 12, 1, 2, -1, 0, 100];
  // Front along x reaches 10 at 101, front along y reaches 10 at 101; back along x reaches 10 at 102.
  assert.deepEqual(cells.nextCrossing(path, 1, 100), { time: 101, kind: 'enter', axis: 0 });
  assert.deepEqual(cells.nextCrossing(path, 1, 101), { time: 102, kind: 'leave', axis: 0 });
  assert.equal(cells.nextCrossing([1, 1, 1, 0, 0, 0, 0], 1, 5).time, Infinity);
});
