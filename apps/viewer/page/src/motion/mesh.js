// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const onward = (a, part, along) => a.map((place, axis) => place + part * along[axis]);

// The point of the segment from a to b that is nearest to a place.
function nearestOnSegment(a, b, place) {
  const along = subtract(b, a);
  const part = dot(subtract(place, a), along) / (dot(along, along) || 1);
  return onward(a, Math.min(1, Math.max(0, part)), along);
}

/** The unit normal of a triangle, or zero if it has no area. */
export function normalOf([a, b, c]) {
  const [p, q] = [subtract(b, a), subtract(c, a)];
  const cross = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
  const length = Math.hypot(...cross) || 1;
  return cross.map((part) => part / length);
}

// The point of a triangle that is nearest to a place.
function nearestOnTriangle(corners, place) {
  const normal = normalOf(corners);
  const height = dot(subtract(place, corners[0]), normal);
  const foot = onward(place, -height, normal);
  const isWithin = corners.every((corner, k) => {
    const side = normalOf([corner, corners[(k + 1) % 3], foot]);
    return dot(side, normal) >= 0;
  });
  if (isWithin && dot(normal, normal) > 0) return foot;
  const ends = corners.map((corner, k) => nearestOnSegment(corner, corners[(k + 1) % 3], place));
  const distances = ends.map((end) => Math.hypot(...subtract(end, place)));
  return ends[distances.indexOf(Math.min(...distances))];
}

/** Whether a triangle is a segment, from its first corner to its last. */
export function isSegment([, b, c]) {
  return b.every((place, axis) => place === c[axis]);
}

/** The triangles of a mesh, around its point. */
export class MeshTriangles {
  /** Coordinates [L] and indices of corners, as in the header of a recording. */
  constructor(coordinates, corners) {
    const vertex = (index) => coordinates.slice(3 * index, 3 * index + 3);
    /** The three corners of each. */
    this.triangles = Array.from({ length: corners.length / 3 }, (_, k) =>
      corners.slice(3 * k, 3 * k + 3).map(vertex),
    );
    /** The extent of all: two corners [L]. */
    this.low = [Infinity, Infinity, Infinity];
    this.high = [-Infinity, -Infinity, -Infinity];
    coordinates.forEach((place, k) => {
      this.low[k % 3] = Math.min(this.low[k % 3], place);
      this.high[k % 3] = Math.max(this.high[k % 3], place);
    });
  }

  /** The point nearest to a place [L]. */
  nearest(place) {
    let nearest = place;
    let least = Infinity;
    for (const corners of this.triangles) {
      const point = nearestOnTriangle(corners, place);
      const distance = Math.hypot(...subtract(point, place));
      if (distance < least) [nearest, least] = [point, distance];
    }
    return nearest;
  }
}
