// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Points } from 'three';
import { kTranslucent, shaderMaterial } from './drawing.js';

const kVertex = /* glsl */ `
  precision highp float;
  in vec3 position;
  in vec4 flash;             // color, and its age from 0 to 1
  in vec2 extent;            // radius, and how opaque it is at first
  uniform mat4 projectionMatrix;
  uniform mat4 modelViewMatrix;
  uniform float pixels;
  out vec4 light;
  out float strength;
  flat out float line;       // width, in units of the ring's radius

  void main() {
    light = flash;
    strength = extent.y;
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    gl_Position = projectionMatrix * seen;
    float size = extent.x * projectionMatrix[1][1] * pixels / max(-seen.z, 1e-6);
    gl_PointSize = clamp(size * (1.0 + flash.a), 8.0, 400.0);
    line = 6.0 / gl_PointSize;
  }
`;

const kFragment = /* glsl */ `
  precision highp float;
  in vec4 light;
  in float strength;
  flat in float line;
  uniform float filling;
  out vec4 outColor;

  void main() {
    float radius = length(2.0 * gl_PointCoord - 1.0);
    float width = fwidth(radius);
    float disk = 1.0 - smoothstep(1.0 - width, 1.0, radius);
    float ring = disk * smoothstep(1.0 - line - width, 1.0 - line, radius);
    float alpha = strength * (1.0 - light.a) * max(ring, filling * disk);
    if (alpha < 0.01) discard;
    outColor = vec4(light.rgb, alpha);
  }
`;

/** Rings that face the camera and are seen through everything. */
export class Rings {
  /** At most `most` of them; `filling`: how opaque their inside is, from 0 to 1. */
  constructor(most, filling) {
    this.most = most;
    this.count = 0;
    this.places = new BufferAttribute(new Float32Array(3 * most), 3).setUsage(DynamicDrawUsage);
    this.flashes = new BufferAttribute(new Float32Array(4 * most), 4).setUsage(DynamicDrawUsage);
    this.extents = new BufferAttribute(new Float32Array(2 * most), 2).setUsage(DynamicDrawUsage);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.places);
    geometry.setAttribute('flash', this.flashes);
    geometry.setAttribute('extent', this.extents);
    /** `pixels`: height of the drawing in its own pixels. */
    this.uniforms = { pixels: { value: 1 }, filling: { value: filling } };
    const material = shaderMaterial(kVertex, kFragment, this.uniforms, { ...kTranslucent, depthTest: false });
    this.object = new Points(geometry, material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 3;
  }

  get isFull() {
    return this.count === this.most;
  }

  clear() {
    this.count = 0;
  }

  /**
   * Adds a ring around `place`, for a sphere of radius `radius` [L]; from age 0 to 1 it grows and fades. `strength`:
   * how opaque it is, from 0 to 1.
   */
  add(place, radius, color, age, strength = 1) {
    const slot = this.count++;
    for (let axis = 0; axis < 3; ++axis) {
      this.places.array[3 * slot + axis] = place[axis];
      this.flashes.array[4 * slot + axis] = color[axis];
    }
    this.flashes.array[4 * slot + 3] = age;
    this.extents.array[2 * slot] = radius;
    this.extents.array[2 * slot + 1] = strength;
  }

  /** Makes the added rings visible. */
  send() {
    this.object.geometry.setDrawRange(0, this.count);
    for (const attribute of [this.places, this.flashes, this.extents]) attribute.needsUpdate = true;
  }
}
