// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kPathNumbers } from '../recording/chunk.js';
import { placeAfter } from './path.js';

/**
 * Where the spheres of `playback` are: the box, and along open axes all spheres and surfaces; two corners [L].
 * `largestRadius`: of the spheres [L].
 */
export function extentOf({ paths, spheres, time, bodies }, box, surfaces, largestRadius) {
  const low = [0, 0, 0];
  const high = [...box.size];
  const isOpen = box.boundary.map((kind) => kind === 'open');
  for (let axis = 0; axis < 3; ++axis) {
    if (!isOpen[axis]) continue;
    low[axis] = Infinity;
    high[axis] = -Infinity;
    for (let id = 0; id < spheres; ++id) {
      if (bodies.radii[id] === 0) continue;
      const start = kPathNumbers * id;
      const elapsed = time - paths[start + 6];
      const place = placeAfter(elapsed, paths[start + axis], paths[start + 3 + axis], box.gravity[axis]);
      low[axis] = Math.min(low[axis], place - largestRadius);
      high[axis] = Math.max(high[axis], place + largestRadius);
    }
  }
  const widen = (axis, from, to) => {
    if (!isOpen[axis]) return;
    low[axis] = Math.min(low[axis], from);
    high[axis] = Math.max(high[axis], to);
  };
  for (const surface of surfaces) {
    if (surface.shape === 'plane' || surface.shape === 'cone') continue;
    const point = surface.pointAt(time);
    for (let axis = 0; axis < 3; ++axis) {
      if (surface.mesh) {
        widen(axis, point[axis] + surface.mesh.low[axis], point[axis] + surface.mesh.high[axis]);
        continue;
      }
      // A cylinder reaches less far along axes to which its own is inclined, and is unbounded along its own.
      const along = surface.isAlongAxis ? surface.direction[axis] : 0;
      const reach = surface.radius * Math.sqrt(Math.max(0, 1 - along ** 2));
      if (Math.abs(along) < 0.999) widen(axis, point[axis] - reach, point[axis] + reach);
    }
  }
  for (let axis = 0; axis < box.dimensions; ++axis) {
    // There is neither sphere nor surface.
    if (low[axis] > high[axis]) [low[axis], high[axis]] = [-1, 1];
  }
  for (const surface of surfaces) {
    if (surface.shape === 'plane') reachPlane(surface, time, low, high, widen);
  }
  return [low, high];
}

// Widens the extent to the part of the plane that is nearest to its middle.
function reachPlane(surface, time, low, high, widen) {
  const { direction } = surface;
  const point = surface.pointAt(time);
  const middle = low.map((begin, axis) => (begin + high[axis]) / 2);
  const apart = direction.reduce((sum, part, axis) => sum + part * (point[axis] - middle[axis]), 0);
  for (let axis = 0; axis < 3; ++axis) {
    if (Math.abs(direction[axis]) < 1e-9) continue;
    const foot = middle[axis] + apart * direction[axis];
    const swing = Math.abs(surface.amplitude * direction[axis]);
    widen(axis, foot - swing, foot + swing);
  }
}
