// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import {
  BufferAttribute,
  BufferGeometry,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
  Points,
} from 'three';
import { shaderMaterial } from './drawing.js';
import { kImpostorFragment, kImpostorVertex, kPointFragment, kPointVertex } from './sphere_shaders.js';

/** Numbers of a sphere on the graphics card: place and motion. */
export const kMotionNumbers = 8;

/** Numbers of a sphere that change only as it merges: radius, species, and 1 if it is kinematic. */
export const kKindNumbers = 3;

/** Numbers of how a sphere turns: spin, and orientation. */
export const kTurnNumbers = 7;

/**
 * Spheres as the graphics card draws them: as "impostors", shaded and of true depth, or as "points", which cost
 * less. `paths`, `kinds` and `turns` hold kMotionNumbers, kKindNumbers and kTurnNumbers for each; `turns` may be
 * null.
 */
export class SphereObject {
  constructor(way, paths, kinds, turns, uniforms) {
    this.asPoints = way === 'points';
    const { asPoints } = this;
    this.geometry = asPoints ? new BufferGeometry() : new InstancedBufferGeometry();
    const Buffer = asPoints ? InterleavedBuffer : InstancedInterleavedBuffer;
    /** Of `paths`, for the graphics card. */
    this.buffer = new Buffer(paths, kMotionNumbers);
    this.geometry.setAttribute('place', new InterleavedBufferAttribute(this.buffer, 4, 0));
    this.geometry.setAttribute('motion', new InterleavedBufferAttribute(this.buffer, 4, 4));
    const Kinds = asPoints ? BufferAttribute : InstancedBufferAttribute;
    /** Of `kinds`, for the graphics card. */
    this.kinds = new Kinds(kinds, kKindNumbers);
    this.geometry.setAttribute('kind', this.kinds);
    /** Of `turns`, for the graphics card, or null. */
    this.turns = turns && new Buffer(turns, kTurnNumbers);
    if (turns) {
      this.geometry.setAttribute('spin', new InterleavedBufferAttribute(this.turns, 3, 0));
      this.geometry.setAttribute('turn', new InterleavedBufferAttribute(this.turns, 4, 3));
    }
    if (asPoints) {
      this.geometry.setAttribute('position', this.geometry.getAttribute('place'));
    } else {
      const corners = new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]);
      this.geometry.setAttribute('position', new BufferAttribute(corners, 3));
      this.geometry.setIndex([0, 1, 2, 0, 2, 3]);
    }
    const [vertex, fragment] = asPoints ? [kPointVertex, kPointFragment] : [kImpostorVertex, kImpostorFragment];
    const material = shaderMaterial(vertex, fragment, uniforms);
    this.object = asPoints ? new Points(this.geometry, material) : new Mesh(this.geometry, material);
    this.object.frustumCulled = false;
    this.show(paths.length / kMotionNumbers);
  }

  /** Draws the first `count`. */
  show(count) {
    if (this.asPoints) this.geometry.setDrawRange(0, count);
    else this.geometry.instanceCount = count;
    this.object.visible = count > 0;
  }

  dispose() {
    this.object.removeFromParent();
    this.geometry.dispose();
    this.object.material.dispose();
  }
}
