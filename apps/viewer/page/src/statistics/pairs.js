// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kMostCenters = 200; // around which others are counted
const kIntervals = 48;
const kReach = 6; // mean radii
const kFewestSpheres = 20;

/**
 * The radial distribution g(r): how many spheres have their centers at a distance r of that of another, over how many there were
 * if they were anywhere in the box with equal probability. Null where the box is open, or too small for it. The centers
 * around which others are counted are a sample; none is so near to a wall that the wall would count.
 * `centers`: three numbers of each sphere [L]; `radius`: the mean [L]. Returns the middles of intervals of r [L] and g there.
 * Cost: O(sample times spheres).
 */
export function radialDistribution(centers, radius, box, time) {
  const count = centers.length / 3;
  const axes = [0, 1, 2].slice(0, box.dimensions);
  if (count < kFewestSpheres || axes.some((axis) => box.boundary[axis] === 'open')) return null;
  const halves = axes.filter((axis) => box.period[axis] > 0).map((axis) => box.period[axis] / 2);
  const reach = Math.min(kReach * radius, ...halves);
  const isInner = (id) =>
    axes.every((axis) => {
      if (box.period[axis] > 0) return true;
      const place = centers[3 * id + axis];
      return place >= reach && place <= box.size[axis] - reach;
    });
  const inner = Array.from({ length: count }, (_, id) => id).filter(isInner);
  if (inner.length === 0) return null;
  const every = Math.max(1, Math.floor(inner.length / kMostCenters));
  const sample = inner.filter((_, k) => k % every === 0).slice(0, kMostCenters);

  const pairs = new Float64Array(kIntervals);
  for (const id of sample) {
    const [atX, atY, atZ] = centers.subarray(3 * id, 3 * id + 3);
    for (let place = 0; place < centers.length; place += 3) {
      let x = centers[place] - atX;
      let y = centers[place + 1] - atY;
      let z = centers[place + 2] - atZ;
      if (box.isSheared) {
        [x, y, z] = box.nearestApart([x, y, z], time);
      } else {
        x = box.nearest(x, 0);
        if (x >= reach || x <= -reach) continue;
        y = box.nearest(y, 1);
        z = box.nearest(z, 2);
      }
      const interval = Math.floor((Math.sqrt(x * x + y * y + z * z) / reach) * kIntervals);
      if (interval < kIntervals) ++pairs[interval];
    }
    --pairs[0]; // with itself
  }
  const width = reach / kIntervals;
  const volume = axes.reduce((product, axis) => product * box.size[axis], 1);
  const ball = (r) => (box.dimensions === 2 ? Math.PI * r ** 2 : (4 / 3) * Math.PI * r ** 3);
  const expected = (k) => (sample.length * (count - 1) * (ball((k + 1) * width) - ball(k * width))) / volume;
  const middles = Array.from(pairs, (_, k) => (k + 0.5) * width);
  return [middles, Array.from(pairs, (number, k) => number / expected(k))];
}
