// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import {
  DoubleSide,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  BufferAttribute,
  Mesh,
  RawShaderMaterial,
} from 'three';
import { kStrongForce, linesOf } from '../motion/forces.js';
import { readCenter } from '../motion/path.js';
import { kPathNumbers } from '../recording/chunk.js';
import { colorTexture, kMapColors } from './colors.js';

const kVertex = /* glsl */ `
  precision highp float;
  in vec3 position;          // across the line, from -1 to 1; along it, from 0 to 1; zero
  in vec3 begin;
  in vec3 end;
  in vec2 strength;          // half the width, and the force
  uniform bool isFlat;
  uniform float strong;
  uniform sampler2D colorMap;
  uniform mat4 projectionMatrix;
  uniform mat4 modelViewMatrix;
  flat out vec3 color;
  out float across;
  out float distance;

  void main() {
    vec3 from = (modelViewMatrix * vec4(begin, 1.0)).xyz;
    vec3 to = (modelViewMatrix * vec4(end, 1.0)).xyz;
    vec3 place = mix(from, to, position.y);
    vec3 side = cross(to - from, isFlat ? vec3(0.0, 0.0, 1.0) : place);
    float size = length(side);
    if (size > 0.0) place += position.x * strength.x / size * side;
    across = position.x;
    distance = -place.z;
    float share = clamp(strength.y / strong, 0.0, 1.0);
    color = texture(colorMap, vec2((32.0 * share + 0.5) / 33.0, 0.5)).rgb;
    gl_Position = projectionMatrix * vec4(place, 1.0);
  }
`;

const kFragment = /* glsl */ `
  precision highp float;
  flat in vec3 color;
  in float across;
  in float distance;
  uniform vec3 background;
  uniform vec2 haze;
  uniform bool isFlat;
  out vec4 outColor;

  void main() {
    float light = isFlat ? 1.0 : 0.6 + 0.4 * sqrt(1.0 - across * across);
    float veil = isFlat ? 0.0 : 0.55 * clamp((distance - haze.x) / (haze.y - haze.x), 0.0, 1.0);
    outColor = vec4(mix(light * color, background, veil), 1.0);
  }
`;

/** The forces that hold spheres at rest: lines between centers, thicker and brighter where they are stronger. */
export class ForceLines {
  /** `uniforms`: those of the spheres, whose haze the lines share. */
  constructor(forces, bodies, box, uniforms) {
    this.forces = forces;
    this.bodies = bodies;
    this.box = box;
    const corners = new Float32Array([-1, 0, 0, 1, 0, 0, 1, 1, 0, -1, 0, 0, 1, 1, 0, -1, 1, 0]);
    this.geometry = new InstancedBufferGeometry();
    this.geometry.setAttribute('position', new BufferAttribute(corners, 3));
    this.geometry.instanceCount = 0;
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: kVertex,
      fragmentShader: kFragment,
      uniforms: {
        background: uniforms.background,
        haze: uniforms.haze,
        isFlat: { value: box.isFlat },
        strong: { value: kStrongForce },
        colorMap: { value: colorTexture(kMapColors, true) },
      },
      side: DoubleSide,
      depthTest: !box.isFlat,
    });
    this.object = new Mesh(this.geometry, material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 1;
    this.object.visible = false;
  }

  /** Takes over where the spheres are in `playback`, once: they are at rest. */
  update({ paths, time }) {
    if (this.geometry.instanceCount > 0) return;
    const centerOf = (id) => readCenter(paths, kPathNumbers * id, time, this.box, [0, 0, 0]);
    const lines = linesOf(this.forces, centerOf, (id) => this.bodies.radii[id]);
    const attribute = (name, size, numbersOf) =>
      this.geometry.setAttribute(
        name,
        new InstancedBufferAttribute(new Float32Array(lines.flatMap(numbersOf)), size),
      );
    attribute('begin', 3, ({ begin }) => begin);
    attribute('end', 3, ({ end }) => end);
    attribute('strength', 2, ({ halfWidth, force }) => [halfWidth, force]);
    this.geometry.instanceCount = lines.length;
  }
}
