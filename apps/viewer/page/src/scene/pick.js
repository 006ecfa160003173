// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kPathNumbers } from '../recording/chunk.js';
import { readCenter } from '../motion/path.js';

/**
 * The sphere that a ray from `origin` along the unit vector `direction` meets first, itself or one of its `images`;
 * if it meets none, the one that it misses by the least, if by less than `tolerance` times the distance; or −1.
 * Spheres are at least `leastSize` times the distance large, as they are drawn. `isShown(id, center)` says which
 * count; spheres without a radius do not exist. Cost: O(spheres).
 */
export function pick(playback, radii, box, { origin, direction }, { tolerance, leastSize, isShown, images }) {
  const { paths, time } = playback;
  const center = [0, 0, 0];
  let [met, nearest] = [-1, Infinity];
  let [missed, leastMiss] = [-1, tolerance];
  const test = (id) => {
    const x = center[0] - origin.x;
    const y = center[1] - origin.y;
    const z = center[2] - origin.z;
    const along = x * direction.x + y * direction.y + z * direction.z;
    if (along <= 0) return;
    const miss = x * x + y * y + z * z - along * along;
    const radius = Math.max(radii[id], leastSize * along);
    if (miss <= radius * radius) {
      const distance = along - Math.sqrt(radius * radius - miss);
      if (distance < nearest && isShown(id, center)) [met, nearest] = [id, distance];
    } else if (met < 0) {
      const missBy = (Math.sqrt(miss) - radius) / along;
      if (missBy < leastMiss && isShown(id, center)) [missed, leastMiss] = [id, missBy];
    }
  };
  for (let id = 0; id < radii.length; ++id) {
    if (radii[id] === 0) continue;
    readCenter(paths, kPathNumbers * id, time, box, center);
    test(id);
  }
  for (let k = 0; k < images.count; ++k) {
    for (let axis = 0; axis < 3; ++axis) center[axis] = images.centers[3 * k + axis];
    test(images.ids[k]);
  }
  return met < 0 ? missed : met;
}
