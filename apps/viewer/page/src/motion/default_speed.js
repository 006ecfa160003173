// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kPathNumbers } from '../recording/chunk.js';

/**
 * Typical scales of a recording, from its first chunk: how fast spheres are [L/T], how often each collides [1/T],
 * and a playback speed at which they are seen to move [T per second].
 */
export function typicalScales(chunk, radii, { begin, until, box, gravity = [0, 0, 0] }) {
  let spheres = 0;
  let squares = 0;
  let radius = 0;
  for (let id = 0; id < radii.length; ++id) {
    if (radii[id] === 0) continue;
    ++spheres;
    const start = kPathNumbers * id + 3;
    squares += chunk.keyframe[start] ** 2 + chunk.keyframe[start + 1] ** 2 + chunk.keyframe[start + 2] ** 2;
    radius += radii[id];
  }
  radius /= spheres;
  const edges = box.size.filter((size, axis) => box.boundary[axis] !== 'open' && size > 0);
  const longest = edges.length > 0 ? Math.max(...edges) / 12 : 3 * radius;
  // Of spheres at rest under gravity, that which they soon have.
  const speed = Math.sqrt(squares / spheres + 2 * Math.hypot(...gravity) * longest);
  let collisions = 0;
  for (let k = 0; k < chunk.contacts; ++k) if (chunk.isCollision(k)) ++collisions;
  const duration = chunk.end - chunk.begin;
  const rate = duration > 0 ? (2 * collisions) / (spheres * duration) : 0;

  // In a second of real time a sphere collides once; but it moves at least a fifth of its radius, and at most a
  // twelfth of the box. A whole run takes at least ten seconds.
  const wanted = Math.min(Math.max(rate > 0 ? speed / rate : Infinity, radius / 5), longest);
  let playing = speed > 0 ? wanted / speed : 1;
  if (until !== null && until > begin) playing = Math.min(playing, (until - begin) / 10);
  return { speed, rate, playing };
}
