// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kWidth = 0.16; // of the line of a mean force, in the smaller radius
const kThinnest = 0.05; // force whose line is the thinnest, over the mean

/** Forces that have the last color, over the mean force. */
export const kStrongForce = 3;

/** How many contacts each of `spheres` spheres has, with others and with walls. */
export function countContacts(forces, spheres) {
  const counts = new Uint32Array(spheres);
  for (const [first, second] of forces) {
    ++counts[first];
    if (second >= 0) ++counts[second];
  }
  return counts;
}

/** The lines from centers to contacts: of every force two, or one to a wall. */
export function linesOf(forces, centerOf, radiusOf) {
  const lines = [];
  for (const [first, second, x, y, z, force] of forces) {
    const begin = centerOf(first);
    const apart = [x, y, z];
    const isWall = second < 0;
    // A line ends where surfaces touch, so that none crosses the box.
    const share = isWall ? 1 : radiusOf(first) / (radiusOf(first) + radiusOf(second));
    const radius = isWall ? radiusOf(first) : Math.min(radiusOf(first), radiusOf(second));
    const known = force ?? 0;
    const halfWidth = (kWidth / 2) * radius * Math.sqrt(Math.max(known, kThinnest));
    const add = (center, part) =>
      lines.push({ begin: center, end: center.map((place, axis) => place + part * apart[axis]), halfWidth, force: known });
    add(begin, share);
    if (!isWall) add(centerOf(second), share - 1);
  }
  return lines;
}
