// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kReach = 1.2; // distance of the centers of neighbors, at most, over the sum of their radii

/**
 * How many neighbors each sphere has: others whose centers are nearer than 1.2 times the sum of the two radii. Those without a
 * radius do not exist. `centers`: three numbers of each sphere in the box [L]. Cost: O(spheres) where radii are alike.
 */
export function countNeighbors(centers, radii, box, time) {
  const count = radii.length;
  const neighbors = new Uint16Array(count);
  const largest = radii.reduce((most, radius) => Math.max(most, radius), 0);
  if (largest === 0) return neighbors;
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let id = 0; id < count; ++id) {
    for (let axis = 0; radii[id] > 0 && axis < 3; ++axis) {
      low[axis] = Math.min(low[axis], centers[3 * id + axis]);
      high[axis] = Math.max(high[axis], centers[3 * id + axis]);
    }
  }
  // Cells at least as large as the farthest neighbors are apart, and not many more than there are spheres.
  const least = Math.max(2 * kReach * largest, Math.cbrt(high.reduce((all, end, k) => all * Math.max(end - low[k], largest), 1) / count));
  const origin = low.map((place, axis) => (box.period[axis] > 0 ? 0 : place));
  const length = [0, 1, 2].map((axis) => box.period[axis] || high[axis] - low[axis]);
  const cells = length.map((edge) => Math.max(1, Math.floor(edge / least)));
  const indexOf = (place, axis) =>
    Math.min(cells[axis] - 1, Math.max(0, Math.floor(((place - origin[axis]) / (length[axis] || 1)) * cells[axis])));
  const first = new Int32Array(cells[0] * cells[1] * cells[2]).fill(-1);
  const next = new Int32Array(count).fill(-1);
  const at = (x, y, z) => (z * cells[1] + y) * cells[0] + x;
  for (let id = 0; id < count; ++id) {
    if (!(radii[id] > 0)) continue;
    const cell = at(...[0, 1, 2].map((axis) => indexOf(centers[3 * id + axis], axis)));
    next[id] = first[cell];
    first[cell] = id;
  }
  // The cells beside a cell along an axis, each once. Where images slide, all along x may be beside it.
  const beside = (index, axis) => {
    if (cells[axis] <= 3 || (box.isSheared && axis === 0)) return Array.from({ length: cells[axis] }, (_, k) => k);
    const isPeriodic = box.period[axis] > 0;
    const all = [index - 1, index, index + 1].map((k) => (isPeriodic ? (k + cells[axis]) % cells[axis] : k));
    return all.filter((k) => k >= 0 && k < cells[axis]);
  };
  for (let z = 0; z < cells[2]; ++z)
    for (let y = 0; y < cells[1]; ++y)
      for (let x = 0; x < cells[0]; ++x) {
        const around = [];
        for (const k of beside(z, 2)) for (const j of beside(y, 1)) for (const i of beside(x, 0)) around.push(at(i, j, k));
        for (let id = first[at(x, y, z)]; id >= 0; id = next[id])
          for (const cell of around)
            for (let other = first[cell]; other >= 0; other = next[other])
              if (other > id && areNeighbors(centers, radii, box, time, id, other)) {
                ++neighbors[id];
                ++neighbors[other];
              }
      }
  return neighbors;
}

function areNeighbors(centers, radii, box, time, id, other) {
  const difference = [0, 1, 2].map((axis) => centers[3 * other + axis] - centers[3 * id + axis]);
  const [x, y, z] = box.nearestApart(difference, time);
  return x * x + y * y + z * z <= (kReach * (radii[id] + radii[other])) ** 2;
}
