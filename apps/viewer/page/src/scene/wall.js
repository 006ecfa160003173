// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import {
  BufferGeometry,
  CapsuleGeometry,
  CylinderGeometry,
  DoubleSide,
  EdgesGeometry,
  Float32BufferAttribute,
  Group,
  Line,
  LineLoop,
  LineSegments,
  Mesh,
  SphereGeometry,
  Vector3,
} from 'three';
import { isSegment, normalOf } from '../motion/mesh.js';
import { roundUp } from '../statistics/speeds.js';
import { kTranslucent, shaderMaterial } from './drawing.js';
import { dot, planePatch, rangeAlong, tangents } from './plane_patch.js';
import { kLineFragment, kLineVertex, kWallFragment, kWallVertex } from './surface_shaders.js';

const kLinesAround = 24; // of a cylinder or sphere
const kLinesAcross = 12; // of the box
const kBend = 1; // degrees from which an edge of a mesh is drawn
const kTicks = 3; // along each direction of a plane

// A material for walls; `shared` are uniforms of all walls, `nearStrength` is that of the part in front of spheres.
function wallMaterial(tint, shared, nearStrength) {
  const own = { tint: { value: tint }, nearStrength: { value: nearStrength } };
  return shaderMaterial(kWallVertex, kWallFragment, { ...shared, ...own }, { ...kTranslucent, side: DoubleSide });
}

// Makes the attribute "spot" of texture coordinates: `u` lines around, `v` along.
function useSpots(geometry, u, v) {
  const uv = geometry.getAttribute('uv');
  const spots = Float32Array.from({ length: 2 * uv.count }, (_, k) => uv.array[k] * (k % 2 === 0 ? u : v));
  geometry.setAttribute('spot', new Float32BufferAttribute(spots, 2));
}

function lineMaterial(tint) {
  return shaderMaterial(kLineVertex, kLineFragment, { tint: { value: tint } }, kTranslucent);
}

/** A wall of any shape: the surface that it is, and the object that shows it. */
class Wall {
  constructor(surface, object) {
    this.surface = surface;
    this.moves = surface.moves;
    this.object = object;
    for (const part of [object, ...object.children]) part.frustumCulled = false;
  }

  /** Fits it to the box between two corners at `time` [T]. */
  update(time) {
    this.object.position.set(...this.surface.pointAt(time));
  }
}

// A line, or a closed one, through points: three numbers each.
function lineThrough(points, tint, Kind) {
  const geometry = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(points, 3));
  return new Kind(geometry, lineMaterial(tint));
}

/** A plane within the box: translucent, with a grid, an outline, and ticks to the side of the spheres. */
export class PlaneWall extends Wall {
  constructor(surface, tint, shared) {
    const patch = new Mesh(new BufferGeometry(), wallMaterial(tint, shared, 1));
    const lines = new LineSegments(new BufferGeometry(), lineMaterial(tint));
    super(surface, new Group().add(patch, lines));
    this.patch = patch;
    this.lines = lines;
  }

  update(time, low, high) {
    const { direction } = this.surface;
    const point = this.surface.pointAt(time);
    const corners = planePatch(point, direction, low, high);
    this.object.visible = corners.length > 0;
    if (!this.object.visible) return;
    const size = Math.max(...high.map((end, axis) => end - low[axis]));
    const [first, second] = tangents(direction);
    const spacing = roundUp(size / kLinesAcross);
    const spotOf = (corner) => [first, second].map((tangent) => dot(tangent, corner) / spacing);
    const triangles = corners.slice(2).flatMap((corner, k) => [corners[0], corners[k + 1], corner]);
    this.put(this.patch, {
      position: [triangles.flat(), 3],
      normal: [triangles.flatMap(() => direction), 3],
      spot: [triangles.flatMap(spotOf), 2],
    });
    const outline = corners.flatMap((corner, k) => [corner, corners[(k + 1) % corners.length]]);
    this.put(this.lines, { position: [[...outline, ...this.ticks(corners, 0.03 * size)].flat(), 3] });
  }

  // From points spread between the middle and the corners of the patch, along the normal.
  ticks(corners, length) {
    const { direction } = this.surface;
    const middle = [0, 1, 2].map(
      (axis) => corners.reduce((sum, corner) => sum + corner[axis], 0) / corners.length,
    );
    const feet = [middle];
    for (const corner of corners) {
      for (let k = 1; k < kTicks; ++k)
        feet.push(middle.map((place, axis) => place + (k / kTicks) * (corner[axis] - place)));
    }
    return feet.flatMap((foot) => [foot, foot.map((place, axis) => place + length * direction[axis])]);
  }

  put(part, attributes) {
    part.geometry.dispose();
    part.geometry = new BufferGeometry();
    for (const [name, [numbers, size]] of Object.entries(attributes))
      part.geometry.setAttribute(name, new Float32BufferAttribute(numbers, size));
  }
}

// A wall around an axis, of height one along it, and of these radii at its ends.
function wallAround({ direction }, [from, to], tint, shared) {
  const geometry = new CylinderGeometry(to, from, 1, 4 * kLinesAround, 1, true);
  useSpots(geometry, kLinesAround, kLinesAcross);
  const wall = new Mesh(geometry, wallMaterial(tint, shared, 0.3));
  // The geometry's axis is y.
  wall.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(...direction));
  return wall;
}

/** A cylinder within the box, with the spheres inside, or outside if it is a pillar. */
export class CylinderWall extends Wall {
  constructor(surface, tint, shared) {
    super(surface, wallAround(surface, [1, 1], tint, shared));
  }

  update(time, low, high) {
    const { direction, radius } = this.surface;
    const point = this.surface.pointAt(time);
    const [from, to] = rangeAlong(point, direction, low, high);
    this.object.scale.set(radius, Math.max(to - from, 1e-9 * radius), radius);
    this.object.position.set(...point.map((place, axis) => place + ((from + to) / 2) * direction[axis]));
  }
}

/** A cone within the box, with the spheres inside. */
export class ConeWall extends Wall {
  constructor(surface, tint, shared) {
    super(surface, wallAround(surface, [0, 1], tint, shared));
  }

  update(time, low, high) {
    const { direction, slope } = this.surface;
    const point = this.surface.pointAt(time);
    const height = Math.max(rangeAlong(point, direction, low, high)[1], 1e-9);
    this.object.scale.set(slope * height, height, slope * height);
    this.object.position.set(...point.map((place, axis) => place + (height / 2) * direction[axis]));
  }
}

/** What a cone is in two dimensions: two lines from its apex, with the discs between them. */
export class WedgeWall extends Wall {
  constructor(surface, tint) {
    const [x, y] = surface.direction;
    const ends = [surface.slope, -surface.slope].map((slope) => [x - slope * y, y + slope * x, 0]);
    super(surface, lineThrough([...ends[0], 0, 0, 0, ...ends[1]], tint, Line));
  }

  update(time, low, high) {
    super.update(time);
    const point = this.surface.pointAt(time);
    this.object.scale.setScalar(Math.max(rangeAlong(point, this.surface.direction, low, high)[1], 1e-9));
  }
}

/** A sphere, with the spheres inside. */
export class SphereWall extends Wall {
  constructor(surface, tint, shared) {
    const geometry = new SphereGeometry(1, 4 * kLinesAround, 2 * kLinesAround);
    useSpots(geometry, kLinesAround, kLinesAround / 2);
    super(surface, new Mesh(geometry, wallMaterial(tint, shared, 0.3)));
    this.object.scale.setScalar(surface.radius);
  }
}

// A segment as a rod with round ends.
function rod([from, , to], radius, tint, shared) {
  const [begin, end] = [new Vector3(...from), new Vector3(...to)];
  const geometry = new CapsuleGeometry(radius, begin.distanceTo(end), 4, 12);
  useSpots(geometry, 0, 0);
  const made = new Mesh(geometry, wallMaterial(tint, shared, 0.5));
  made.position.lerpVectors(begin, end, 0.5);
  made.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), end.sub(begin).normalize());
  return made;
}

/** A mesh: translucent, with the edges at which it bends. Its segments are rods if it has a thickness, and lines if not. */
export class MeshWall extends Wall {
  constructor(surface, tint, shared) {
    const { triangles } = surface.mesh;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(triangles.flat(2), 3));
    const normals = triangles.flatMap((corners) => corners.flatMap(() => normalOf(corners)));
    geometry.setAttribute('normal', new Float32BufferAttribute(normals, 3));
    // Between the lines that other walls have.
    geometry.setAttribute('spot', new Float32BufferAttribute(new Float32Array(6 * triangles.length).fill(0.5), 2));
    const lines = new LineSegments(new EdgesGeometry(geometry, kBend), lineMaterial(tint));
    const faces = new Mesh(geometry, wallMaterial(tint, shared, 0.5));
    const segments = triangles.filter(isSegment);
    const { thickness } = surface;
    const rods =
      thickness > 0
        ? segments.map((segment) => rod(segment, thickness, tint, shared))
        : segments.map(([from, , to]) => lineThrough([...from, ...to], tint, Line));
    super(surface, new Group().add(faces, lines, ...rods));
  }
}

/** What a cylinder or a pillar along z, or a sphere, is in two dimensions: a circle. */
export class CircleWall extends Wall {
  constructor(surface, tint) {
    const angles = Array.from({ length: 16 * kLinesAround }, (_, k) => (k * Math.PI) / (8 * kLinesAround));
    const points = angles.flatMap((angle) => [Math.cos(angle), Math.sin(angle), 0]);
    super(surface, lineThrough(points, tint, LineLoop));
    this.object.scale.setScalar(surface.radius);
  }
}
