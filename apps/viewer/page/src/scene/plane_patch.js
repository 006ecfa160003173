// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/** Two unit vectors that are perpendicular to the unit vector `normal` and to each other. */
export function tangents(normal) {
  // The axis to which the normal is least inclined.
  const least = normal.map(Math.abs).reduce((best, part, axis, all) => (part < all[best] ? axis : best), 0);
  const axis = [0, 1, 2].map((k) => (k === least ? 1 : 0));
  const first = cross(axis, normal);
  const length = Math.hypot(...first);
  const unit = first.map((part) => part / length);
  return [unit, cross(normal, unit)];
}

/** The part of a plane, given by a point and its unit normal, in the box between two corners: its corners in order. */
export function planePatch(point, normal, low, high) {
  const corners = [];
  const height = (place) => dot(normal, place) - dot(normal, point);
  const size = Math.hypot(...high.map((end, axis) => end - low[axis]));
  for (let axis = 0; axis < 3; ++axis) {
    const [second, third] = [(axis + 1) % 3, (axis + 2) % 3];
    for (let edge = 0; edge < 4; ++edge) {
      const begin = [0, 0, 0];
      begin[axis] = low[axis];
      begin[second] = (edge & 1 ? high : low)[second];
      begin[third] = (edge & 2 ? high : low)[third];
      const slope = normal[axis] * (high[axis] - low[axis]);
      if (slope === 0) continue;
      const share = -height(begin) / slope;
      if (!(share >= -1e-9 && share <= 1 + 1e-9)) continue;
      begin[axis] += share * (high[axis] - low[axis]);
      // Through a corner of the box run three edges.
      const isNew = corners.every((corner) => distance(corner, begin) > 1e-7 * size);
      if (isNew) corners.push(begin);
    }
  }
  if (corners.length < 3) return [];
  const middle = [0, 1, 2].map(
    (axis) => corners.reduce((sum, corner) => sum + corner[axis], 0) / corners.length,
  );
  const [first, second] = tangents(normal);
  const angle = (corner) => {
    const apart = corner.map((place, axis) => place - middle[axis]);
    return Math.atan2(dot(second, apart), dot(first, apart));
  };
  return corners.sort((a, b) => angle(a) - angle(b));
}

/** The range of lengths along `direction` from `point` that the box between two corners covers [L]. */
export function rangeAlong(point, direction, low, high) {
  let [from, to] = [0, 0];
  for (let axis = 0; axis < 3; ++axis) {
    const ends = [low[axis], high[axis]].map((place) => direction[axis] * (place - point[axis]));
    from += Math.min(...ends);
    to += Math.max(...ends);
  }
  return [from, to];
}

export function dot(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function distance(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
