// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import { Box } from '../../../apps/viewer/page/src/motion/box.js';
import { extentOf } from '../../../apps/viewer/page/src/motion/extent.js';
import { isSegment, normalOf } from '../../../apps/viewer/page/src/motion/mesh.js';
import { readSurfaces } from '../../../apps/viewer/page/src/motion/surfaces.js';
import { assertNear } from '../support/near.mjs';

// Two sides of a roof over the plane z = 0, whose ridge is one high.
const kRoof = {
  shape: 'mesh',
  point: [10, 0, 0],
  vertices: [0, 0, 1, 0, 4, 1, -2, 2, 0, 2, 2, 0],
  triangles: [0, 1, 2, 0, 3, 1],
};
const kOpen = new Box({ size: [0, 0, 0], boundary: ['open', 'open', 'open'] });

function assertPlace(place, expected) {
  place.forEach((coordinate, axis) => assertNear(coordinate, expected[axis], 1e-12));
}

test('a mesh has the triangles of the header', () => {
  const [roof] = readSurfaces({ surfaces: [kRoof] });
  assert.equal(roof.mesh.triangles.length, 2);
  assert.deepEqual(roof.mesh.low, [-2, 0, 0]);
  assert.deepEqual(roof.mesh.high, [2, 4, 1]);
  assertPlace(normalOf(roof.mesh.triangles[1]), [1, 0, 2].map((part) => part / Math.sqrt(5)));
  assertPlace(normalOf([[0, 0, 0], [1, 1, 1], [2, 2, 2]]), [0, 0, 0]);
  assert.equal(roof.mesh.triangles.some(isSegment), false);
  assert.equal(isSegment([[0, 0, 0], [1, 2, 3], [1, 2, 3]]), true);
});

test('spheres touch faces, edges and corners of a mesh', () => {
  const [roof] = readSurfaces({ surfaces: [kRoof] });
  assertPlace(roof.touchPoint([10, 2, 3], 2, 0, kOpen), [10, 2, 1]);
  assertPlace(roof.touchPoint([12, 2, 2.5], 2, 0, kOpen), [11, 2, 0.5]);
  assertPlace(roof.touchPoint([10, 6, 1], 2, 0, kOpen), [10, 4, 1]);
  assertPlace(roof.touchPoint([14, 2, 0], 2, 0, kOpen), [12, 2, 0]);
});

test('the extent of open space reaches around meshes', () => {
  const surfaces = readSurfaces({ surfaces: [kRoof] });
  const nothing = { paths: [], spheres: 0, time: 0, bodies: { radii: [] } };
  const box = { size: [0, 0, 0], boundary: ['open', 'open', 'open'], gravity: [0, 0, 0], dimensions: 3 };
  assert.deepEqual(extentOf(nothing, box, surfaces, 0), [
    [8, 0, 0],
    [12, 4, 1],
  ]);
});
