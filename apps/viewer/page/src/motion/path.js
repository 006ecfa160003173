// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/**
 * Writes the center at `time` [L], folded into the box, into `center`.
 * `paths` holds the path from number `start` on: position, velocity, start time.
 */
export function readCenter(paths, start, time, box, center) {
  const elapsed = time - paths[start + 6];
  for (let axis = 0; axis < 3; ++axis) {
    center[axis] = box.fold(paths[start + axis] + elapsed * paths[start + 3 + axis], axis);
  }
  return center;
}

/**
 * The straight motion along `path` from time `from` to `until`, cut where it crosses a periodic face:
 * a list of pairs of points in the box [L], at most `most` of them.
 */
export function piecesInBox(path, from, until, box, most = 64) {
  const pieces = [];
  let time = from;
  while (time < until && pieces.length < most) {
    let next = until;
    const boxes = [0, 0, 0];
    for (let axis = 0; axis < 3; ++axis) {
      const period = box.period[axis];
      const velocity = path[3 + axis];
      if (period === 0 || velocity === 0) continue;
      // The middle of a short step ahead shows in which image of the box the motion continues.
      const place = path[axis] + (time - path[6]) * velocity;
      const image = Math.floor(place / period + Math.sign(velocity) * 1e-9);
      boxes[axis] = image;
      const face = (velocity > 0 ? image + 1 : image) * period;
      next = Math.min(next, path[6] + (face - path[axis]) / velocity);
    }
    if (!(next > time)) break;
    const at = (moment) =>
      [0, 1, 2].map(
        (axis) => path[axis] + (moment - path[6]) * path[3 + axis] - boxes[axis] * box.period[axis],
      );
    pieces.push([at(time), at(next)]);
    time = next;
  }
  return pieces;
}
