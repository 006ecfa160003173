// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

import { MeshTriangles } from './mesh.js';

/** The faces of the box are numbered before the surfaces of the header. */
export const kBoxFaces = 6;

/** A surface that spheres bounce off, besides the faces of the box. */
export class Surface {
  /** `entry`: as in the header of a recording; `number`: its place in the list there. */
  constructor(entry, number, isDriven = false) {
    /** "plane", "cylinder", "pillar", "sphere", "obstacle", "cone" or "mesh". */
    this.shape = entry.shape;
    this.point = entry.point;
    /** Unit normal of a plane, to the side of the spheres; unit vector along an axis. */
    this.direction = entry.direction ?? [0, 0, 1];
    /** [L] */
    this.radius = entry.radius ?? 0;
    /** Of a cone: its radius over the distance from the apex. */
    this.slope = entry.slope ?? 0;
    /** By how much a mesh is thicker than its triangles, to all sides [L]. */
    this.thickness = entry.thickness ?? 0;
    this.velocity = entry.velocity ?? [0, 0, 0];
    this.amplitude = entry.amplitude ?? 0;
    this.frequency = entry.frequency ?? 0;
    /** k_B T [M L² T⁻²] of a thermal surface, or null. */
    this.temperature = entry.temperature ?? null;
    /** Null if it is not one number, or the surface is rough. */
    this.restitution = entry.restitution === undefined ? 1 : entry.restitution;
    /** The triangles of a mesh around its point; null of other shapes. */
    this.mesh = entry.shape === 'mesh' ? new MeshTriangles(entry.vertices, entry.triangles) : null;
    /** Whether a motion may drive it. */
    this.isDriven = isDriven;
    /** How it moves at the time shown, unless as at the start: since when, its point then, and its velocity. */
    this.driven = null;
    this.name = `wall ${number}: ${this.shape}`;
  }

  /** Whether it is unbounded along its axis, with the same radius everywhere. */
  get isAlongAxis() {
    return this.shape === 'cylinder' || this.shape === 'pillar';
  }

  /** Whether spheres are around it, not within. */
  get isMetFromOutside() {
    return this.shape === 'obstacle' || this.shape === 'pillar';
  }

  get oscillates() {
    return this.amplitude !== 0 && this.frequency !== 0;
  }

  get moves() {
    return this.isDriven || this.oscillates || this.velocity.some((part) => part !== 0);
  }

  /** Whether contacts with it may change the energy of a sphere. */
  get changesEnergy() {
    return this.moves || this.temperature !== null || this.restitution !== 1;
  }

  /** Lets it go on as `driven` says, see Chunk.surfaceOf, or as at the start if that is null. */
  follow(driven) {
    this.driven = driven;
  }

  /** Where its point is at `time` [T]: a point of the plane or of the axis, the center, or the apex [L]. */
  pointAt(time) {
    if (this.driven) {
      const { since, point, velocity } = this.driven;
      return point.map((place, axis) => place + (time - since) * velocity[axis]);
    }
    const swing = this.oscillates ? this.amplitude * Math.sin(2 * Math.PI * this.frequency * time) : 0;
    return this.point.map((place, axis) => place + time * this.velocity[axis] + swing * this.direction[axis]);
  }

  /** Where a sphere of radius `radius` with its center at `center` touches it at `time`: a point [L]. */
  touchPoint(center, radius, time, box) {
    if (this.shape === 'plane') return center.map((place, axis) => place - radius * this.direction[axis]);
    const point = this.pointAt(time);
    const apart = center.map((place, axis) => box.nearest(place - point[axis], axis));
    if (this.mesh) {
      const nearest = this.mesh.nearest(apart);
      return center.map((place, axis) => place + nearest[axis] - apart[axis]);
    }
    if (this.isAlongAxis || this.shape === 'cone') {
      const along = apart.reduce((sum, part, axis) => sum + part * this.direction[axis], 0);
      for (let axis = 0; axis < 3; ++axis) apart[axis] -= along * this.direction[axis];
    }
    if (this.shape === 'cone') {
      // Perpendicular to the wall, which is inclined to the axis.
      const fromAxis = Math.hypot(...apart) || 1;
      for (let axis = 0; axis < 3; ++axis)
        apart[axis] = apart[axis] / fromAxis - this.slope * this.direction[axis];
    }
    const distance = Math.hypot(...apart) || 1;
    const reach = this.isMetFromOutside ? -radius : radius;
    return center.map((place, axis) => place + (reach * apart[axis]) / distance);
  }
}

/** The surfaces of a recording's header, in its order. */
export function readSurfaces({ surfaces = [], motions = false }) {
  return surfaces.map((entry, number) => new Surface(entry, number, motions));
}

const kFaces = ['x_min', 'x_max', 'y_min', 'y_max', 'z_min', 'z_max'];

/** What a contact's number `second` stands for, in words: "sphere 3", "wall x_min", "wall 2: cylinder". */
export function partnerName(second, surfaces) {
  if (second >= 0) return `sphere ${second}`;
  const number = -second - 1;
  return number < kBoxFaces ? `wall ${kFaces[number]}` : surfaces[number - kBoxFaces].name;
}
