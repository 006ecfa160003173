// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kPathNumbers } from '../recording/chunk.js';
import { readCenter } from '../motion/path.js';

/**
 * The sphere that a ray from `origin` along the unit vector `direction` meets first, or −1; a ray that misses
 * by less than `tolerance` times the distance meets, too. `isShown(id, center)` says which spheres count.
 * Cost: O(spheres).
 */
export function pick({ paths, time }, radii, box, origin, direction, tolerance, isShown) {
  const center = [0, 0, 0];
  let found = -1;
  let nearest = Infinity;
  for (let id = 0; id < radii.length; ++id) {
    readCenter(paths, kPathNumbers * id, time, box, center);
    const x = center[0] - origin.x;
    const y = center[1] - origin.y;
    const z = center[2] - origin.z;
    const along = x * direction.x + y * direction.y + z * direction.z;
    if (along <= 0) continue;
    const miss = x * x + y * y + z * z - along * along;
    const reach = Math.max(radii[id], tolerance * along);
    if (miss > reach * reach) continue;
    const distance = along - Math.sqrt(reach * reach - miss);
    if (distance < nearest && isShown(id, center)) {
      nearest = distance;
      found = id;
    }
  }
  return found;
}
