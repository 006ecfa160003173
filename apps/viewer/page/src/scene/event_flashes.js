// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, GLSL3, Points, RawShaderMaterial } from 'three';
import { kEventColors } from './colors.js';

const kMost = 512;

const kVertex = /* glsl */ `
  precision highp float;
  in vec3 position;
  in vec4 flash;             // color, and its age from 0 to 1
  in float extent;
  uniform mat4 projectionMatrix;
  uniform mat4 modelViewMatrix;
  uniform float pixels;
  out vec4 light;

  void main() {
    light = flash;
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    gl_Position = projectionMatrix * seen;
    float size = extent * projectionMatrix[1][1] * pixels / max(-seen.z, 1e-6);
    gl_PointSize = clamp(size * (0.5 + 0.9 * flash.a), 7.0, 160.0);
  }
`;

const kFragment = /* glsl */ `
  precision highp float;
  in vec4 light;
  out vec4 outColor;

  void main() {
    float radius = length(2.0 * gl_PointCoord - 1.0);
    float width = fwidth(radius);
    float disk = 1.0 - smoothstep(1.0 - width, 1.0, radius);
    float ring = disk * smoothstep(0.72 - width, 0.72, radius);
    float alpha = (1.0 - light.a) * max(0.9 * ring, 0.25 * disk);
    if (alpha < 0.01) discard;
    outColor = vec4(light.rgb, alpha);
  }
`;

/** Rings that flash up where contacts happen, grow, and fade. */
export class EventFlashes {
  constructor(radii, box) {
    this.radii = radii;
    this.box = box;
    this.places = new BufferAttribute(new Float32Array(3 * kMost), 3).setUsage(DynamicDrawUsage);
    this.flashes = new BufferAttribute(new Float32Array(4 * kMost), 4).setUsage(DynamicDrawUsage);
    this.extents = new BufferAttribute(new Float32Array(kMost), 1).setUsage(DynamicDrawUsage);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.places);
    geometry.setAttribute('flash', this.flashes);
    geometry.setAttribute('extent', this.extents);
    this.uniforms = { pixels: { value: 1 } };
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: kVertex,
      fragmentShader: kFragment,
      uniforms: this.uniforms,
      transparent: true,
      depthTest: false,
      depthWrite: false,
    });
    this.object = new Points(geometry, material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 3;
    this.object.visible = false;
  }

  /** Shows the contacts of the last `window` [T] before the moment of `playback`, the latest of them at most. */
  update({ chunk, cursor, time }, window) {
    let count = 0;
    for (let k = cursor - 1; k >= 0 && count < kMost; --k) {
      const age = (time - chunk.time(k)) / window;
      if (age >= 1) break;
      this.add(count++, chunk, k, age);
    }
    this.object.geometry.setDrawRange(0, count);
    for (const attribute of [this.places, this.flashes, this.extents]) attribute.needsUpdate = true;
  }

  add(slot, chunk, k, age) {
    const first = chunk.first(k);
    const second = chunk.second(k);
    const place = chunk.firstPlace(k);
    const isCollision = second >= 0;
    const radius = this.radii[first];
    const color = isCollision ? kEventColors.collision : kEventColors.wall;
    for (let axis = 0; axis < 3; ++axis) {
      let touch = chunk.numbers[place + axis];
      if (isCollision) {
        const apart = this.box.nearest(chunk.numbers[chunk.secondPlace(k) + axis] - touch, axis);
        touch += (apart * radius) / (radius + this.radii[second]);
      } else if ((-second - 1) >> 1 === axis) {
        touch += (-second - 1) & 1 ? radius : -radius;
      }
      this.places.array[3 * slot + axis] = touch;
      this.flashes.array[4 * slot + axis] = color[axis];
    }
    this.flashes.array[4 * slot + 3] = age;
    this.extents.array[slot] = isCollision ? Math.min(radius, this.radii[second]) : radius;
  }
}
