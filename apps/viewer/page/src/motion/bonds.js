// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/**
 * The halves of a bond between spheres whose centers are `one` and `other` at `time`: each a pair of points, from a
 * center half the way to the nearest image of the other, so that none crosses the box [L].
 */
export function halvesOf(one, other, box, time) {
  const apart = box.nearestApart(
    other.map((place, axis) => place - one[axis]),
    time,
  );
  return [
    [one, one.map((place, axis) => place + apart[axis] / 2)],
    [other, other.map((place, axis) => place - apart[axis] / 2)],
  ];
}
