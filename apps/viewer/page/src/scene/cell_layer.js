// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { BoxGeometry, DoubleSide, Mesh, Vector3 } from 'three';
import { readCenter } from '../motion/path.js';
import { kPathNumbers } from '../recording/chunk.js';
import { kEventColors } from './colors.js';
import { changingNumbers, instancesOf, kTranslucent, shaderMaterial } from './drawing.js';

const kMost = 2048; // cells drawn at a time
const kSpheresAround = 60; // whose cells are drawn besides those of the followed sphere

/** Up to this many spheres the cells of all are drawn. */
export const kFew = 60;

const kVertex = /* glsl */ `
  precision highp float;
  in vec3 position;
  in vec2 uv;
  in vec3 corner;            // the cell's lowest corner
  in vec4 tint;              // color, and how strong
  uniform vec3 edge;
  uniform mat4 projectionMatrix;
  uniform mat4 modelViewMatrix;
  out vec2 spot;
  flat out vec4 light;

  void main() {
    spot = uv;
    light = tint;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(corner + (position + 0.5) * edge, 1.0);
  }
`;

const kFragment = /* glsl */ `
  precision highp float;
  in vec2 spot;
  flat in vec4 light;
  out vec4 outColor;

  void main() {
    vec2 toSide = min(spot, 1.0 - spot) / fwidth(spot);
    float line = 1.0 - smoothstep(0.7, 1.7, min(toSide.x, toSide.y));
    float alpha = light.a * max(0.1, line);
    if (alpha < 0.01) discard;
    outColor = vec4(light.rgb, alpha);
  }
`;

/**
 * The cells of the paper: those that the followed sphere touches, bright as it enters, fading where it has left;
 * and faintly those of the spheres near it.
 */
export class CellLayer {
  constructor(radii, box) {
    this.radii = radii;
    this.box = box;
    this.corners = changingNumbers(3, kMost);
    this.tints = changingNumbers(4, kMost);
    this.geometry = instancesOf(new BoxGeometry(1, 1, 1), { corner: this.corners, tint: this.tints });
    this.uniforms = { edge: { value: new Vector3() } };
    const options = { ...kTranslucent, side: DoubleSide, depthTest: !box.isFlat };
    const material = shaderMaterial(kVertex, kFragment, this.uniforms, options);
    this.object = new Mesh(this.geometry, material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 1;
    this.object.visible = false;
    this.ink = [0.5, 0.5, 0.5];
    this.accent = [0, 0.5, 1];
    this.near = new Uint32Array(kSpheresAround);
    this.nearCount = 0;
  }

  /** Chooses the spheres whose cells are drawn besides those of `followed`: the nearest, within `reach` [L]. */
  gather({ paths, time }, followed, reach) {
    this.nearCount = 0;
    const count = this.radii.length;
    const centerOf = (id, center) => readCenter(paths, kPathNumbers * id, time, this.box, center);
    const center = followed < 0 ? null : centerOf(followed, [0, 0, 0]);
    const other = [0, 0, 0];
    for (let id = 0; id < count && this.nearCount < kSpheresAround; ++id) {
      if (id === followed || this.radii[id] === 0) continue;
      let apart = 0;
      if (center && count > kFew) {
        centerOf(id, other);
        const difference = center.map((place, axis) => other[axis] - place);
        for (const part of this.box.nearestApart(difference, time)) apart += part ** 2;
      }
      if (apart <= reach * reach) this.near[this.nearCount++] = id;
    }
  }

  /**
   * Shows the cells of `cells` at the time of `playback`; those that sphere `followed` (or −1) has entered or left
   * within the last `window` [T] are highlighted.
   */
  update(playback, followed, cells, window) {
    this.count = 0;
    this.uniforms.edge.value.set(...cells.edge);
    const isFew = this.radii.length <= kFew;
    for (let k = 0; k < this.nearCount; ++k)
      this.add(playback, this.near[k], cells, isFew ? window : 0, this.ink, 0.22);
    if (followed >= 0) this.add(playback, followed, cells, window, this.accent, 0.9);
    this.geometry.instanceCount = this.count;
    this.corners.needsUpdate = this.tints.needsUpdate = true;
  }

  add({ paths, time }, id, cells, window, color, strength) {
    const path = paths.subarray(kPathNumbers * id, kPathNumbers * (id + 1));
    // Earlier crossings were on another path.
    const from = Math.max(path[6], time - window);
    const show = (indices, enter, leave) => {
      if (leave <= time) this.put(cells, indices, kEventColors.leave, 1 - (time - leave) / window);
      else if (enter > from)
        this.put(cells, indices, kEventColors.enter, 1, color, (time - enter) / window, strength);
      else this.put(cells, indices, color, strength);
    };
    // If a sphere is so fast that it has crossed too many, only those it touches are shown.
    if (!cells.visit(path, this.radii[id], from, time, show))
      cells.visit(path, this.radii[id], time, time, show);
  }

  // From `color`, `strength` strong, the cell fades to `later` as `share` goes to 1.
  put(cells, indices, color, strength, later = color, share = 0, laterStrength = strength) {
    if (this.count === kMost) return;
    const slot = this.count++;
    for (let axis = 0; axis < 3; ++axis) {
      this.corners.array[3 * slot + axis] = cells.begin(indices[axis], axis);
      this.tints.array[4 * slot + axis] = color[axis] + share * (later[axis] - color[axis]);
    }
    this.tints.array[4 * slot + 3] = strength + share * (laterStrength - strength);
  }
}
