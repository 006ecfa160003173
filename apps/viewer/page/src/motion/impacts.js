// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kPathNumbers } from '../recording/chunk.js';

const kShareOfRadius = 0.1;

/**
 * By how much each contact of `chunk` changes a velocity [L/T]: the larger of the changes of its two spheres.
 * Infinity for mergers. Cost: O(spheres + contacts).
 */
export function velocityChanges(chunk, gravity) {
  const paths = chunk.keyframe.slice();
  const changes = new Float32Array(chunk.contacts);
  const change = (id, place, time) => {
    const start = kPathNumbers * id;
    const elapsed = time - paths[start + 6];
    let square = 0;
    for (let axis = 0; axis < 3; ++axis) {
      const before = paths[start + 3 + axis] + elapsed * gravity[axis];
      const after = chunk.numbers[place + 3 + axis];
      square += (after - before) ** 2;
      paths[start + 3 + axis] = after;
    }
    paths[start + 6] = time;
    return Math.sqrt(square);
  };
  for (let k = 0; k < chunk.contacts; ++k) {
    if (chunk.isPass(k)) continue;
    const time = chunk.time(k);
    changes[k] = change(chunk.first(k), chunk.firstPlace(k), time);
    if (chunk.isMerger(k)) changes[k] = Infinity;
    else if (chunk.isCollision(k))
      changes[k] = Math.max(changes[k], change(chunk.second(k), chunk.secondPlace(k), time));
  }
  return changes;
}

/**
 * How noticeable a contact is, from 0 to 1, that changes a velocity by `change` [L/T]: fully if that is what a fall
 * through a tenth of `radius` gives, less for spheres that rest on each other. Without `gravity` [L/T²] all are.
 */
export function emphasis(change, radius, gravity) {
  const square = 2 * Math.hypot(...gravity) * kShareOfRadius * radius;
  return square > 0 ? Math.min(1, change ** 2 / square) : 1;
}
