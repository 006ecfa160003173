// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { BackSide, BoxGeometry, Color, Float32BufferAttribute, Mesh, Vector3 } from 'three';
import { kTranslucent, shaderMaterial } from './drawing.js';

const kVertex = /* glsl */ `
  precision highp float;
  in vec3 position;
  in vec2 uv;
  in vec2 boundary;          // at the sides across the two directions of uv
  uniform mat4 projectionMatrix;
  uniform mat4 modelViewMatrix;
  uniform vec3 size;
  out vec2 spot;
  flat out vec2 kind;
  flat out vec2 extent;

  void main() {
    spot = uv;
    kind = boundary;
    // Lengths of the face along its two directions of uv.
    extent = gl_VertexID < 8 ? size.zy : gl_VertexID < 16 ? size.xz : size.xy;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`;

// Walls are filled and have a solid outline, periodic faces a dashed one, open ones corners only.
const kFragment = /* glsl */ `
  precision highp float;
  in vec2 spot;
  flat in vec2 kind;
  flat in vec2 extent;
  uniform vec3 ink;
  uniform float dash;
  uniform bool isFilled;
  out vec4 outColor;

  void main() {
    vec2 pixel = fwidth(spot);
    vec2 toSide = min(spot, 1.0 - spot);
    vec2 line = 1.0 - smoothstep(vec2(0.8), vec2(1.8), toSide / pixel);
    vec2 place = spot * extent;
    // A line runs along the other direction: its dashes are counted there.
    vec2 dashed = step(0.45, fract(place.yx / dash));
    vec2 corners = step(min(place, extent - place).yx, vec2(dash));
    line *= mix(mix(vec2(1.0), dashed, step(0.5, kind)), corners, step(1.5, kind));
    float fill = isFilled && kind.x < 0.5 ? 0.045 : 0.0;
    float alpha = max(fill, 0.5 * max(line.x, line.y));
    if (alpha < 0.01) discard;
    outColor = vec4(ink, alpha);
  }
`;

const kKinds = { wall: 0, periodic: 1, open: 2 };

/** The box without its faces toward the camera, so that the inside is visible; in two dimensions a rectangle. */
export class BoxFrame {
  /** `boundary`: three of "wall", "periodic", "open", or "flat" for z. */
  constructor(boundary) {
    const geometry = new BoxGeometry(1, 1, 1);
    // Four vertices for each face, faces in the order of the axes.
    const sides = [0, 1, 2].flatMap((axis) => Array(8).fill(sidesOf(axis, boundary)).flat());
    geometry.setAttribute('boundary', new Float32BufferAttribute(sides, 2));
    this.uniforms = {
      size: { value: new Vector3() },
      ink: { value: new Color() },
      dash: { value: 1 },
      isFilled: { value: boundary[2] !== 'flat' },
    };
    // What lies in the plane does not hide it.
    const options = { ...kTranslucent, side: BackSide, depthTest: boundary[2] !== 'flat' };
    const material = shaderMaterial(kVertex, kFragment, this.uniforms, options);
    this.object = new Mesh(geometry, material);
    this.object.renderOrder = -1;
  }

  /** Makes the box extend from `low` to `high`, three lengths [L] each. */
  span(low, high) {
    const size = high.map((end, axis) => end - low[axis]);
    this.object.scale.set(...size);
    this.object.position.set(...low.map((begin, axis) => begin + size[axis] / 2));
    this.uniforms.size.value.set(...size);
    this.uniforms.dash.value = Math.max(...size) / 40;
  }
}

// What a face across `axis` is drawn as at its sides across the two directions of its uv: as what it is itself, or,
// if it is the plane of two dimensions, as what is at those sides.
function sidesOf(axis, boundary) {
  const kinds = boundary[axis] === 'flat' ? [boundary[0], boundary[1]] : [boundary[axis], boundary[axis]];
  return kinds.map((kind) => kKinds[kind] ?? kKinds.open);
}
