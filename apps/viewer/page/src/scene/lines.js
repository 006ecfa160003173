// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { BufferAttribute, DoubleSide, InstancedBufferGeometry, Mesh } from 'three';
import { colorTexture } from './colors.js';
import { changingNumbers, shaderMaterial } from './drawing.js';

const kVertex = /* glsl */ `
  precision highp float;
  in vec3 position;          // across the line, from -1 to 1; along it, from 0 to 1; zero
  in vec3 begin;
  in vec3 end;
  in vec2 style;             // half the width, negative where it tapers to a point, and the place in the color map, from 0 to 1
  uniform bool isFlat;
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
    float halfWidth = style.x < 0.0 ? -style.x * (1.0 - position.y) : style.x;
    if (size > 0.0) place += position.x * halfWidth / size * side;
    across = position.x;
    distance = -place.z;
    float colors = float(textureSize(colorMap, 0).x);
    color = texture(colorMap, vec2((clamp(style.y, 0.0, 1.0) * (colors - 1.0) + 0.5) / colors, 0.5)).rgb;
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

/** Straight lines of any width, shaded as rods. */
export class Lines {
  /** `uniforms`: those of the spheres, whose haze the lines share; `colors`: of the map. */
  constructor(box, uniforms, colors) {
    const corners = new Float32Array([-1, 0, 0, 1, 0, 0, 1, 1, 0, -1, 0, 0, 1, 1, 0, -1, 1, 0]);
    this.geometry = new InstancedBufferGeometry();
    this.geometry.setAttribute('position', new BufferAttribute(corners, 3));
    this.reserve(0);
    const { background, haze } = uniforms;
    const own = { isFlat: { value: box.isFlat }, colorMap: { value: colorTexture(colors, true) } };
    const options = { side: DoubleSide, depthTest: !box.isFlat };
    const material = shaderMaterial(kVertex, kFragment, { background, haze, ...own }, options);
    this.object = new Mesh(this.geometry, material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 1;
    this.object.visible = false;
  }

  get count() {
    return this.geometry.instanceCount;
  }

  /** Makes room for `most` lines, of which there are none yet. */
  reserve(most) {
    for (const [name, size] of [['begin', 3], ['end', 3], ['style', 2]]) {
      this.geometry.setAttribute(name, changingNumbers(size, most));
    }
    this.geometry.instanceCount = 0;
  }

  /** Removes all lines. */
  clear() {
    this.geometry.instanceCount = 0;
  }

  /** Adds a line between two points [L], `share` of the way along the map of colors; it tapers if the width is negative. */
  add(begin, end, halfWidth, share) {
    const { attributes } = this.geometry;
    const line = this.geometry.instanceCount++;
    attributes.begin.setXYZ(line, ...begin);
    attributes.end.setXYZ(line, ...end);
    attributes.style.setXY(line, halfWidth, share);
  }

  /** Has what was added drawn. */
  show() {
    for (const name of ['begin', 'end', 'style']) this.geometry.attributes[name].needsUpdate = true;
  }
}
