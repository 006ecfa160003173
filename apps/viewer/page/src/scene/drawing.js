// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import {
  DynamicDrawUsage,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  RawShaderMaterial,
} from 'three';

/** A material that draws with these shaders; `options`: others of RawShaderMaterial. */
export function shaderMaterial(vertexShader, fragmentShader, uniforms, options = {}) {
  return new RawShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader, uniforms, ...options });
}

/** Options of a material through which one sees what is behind. */
export const kTranslucent = { transparent: true, depthWrite: false };

/** `size` numbers for each of `most` instances, which may change from frame to frame. */
export function changingNumbers(size, most) {
  return new InstancedBufferAttribute(new Float32Array(size * most), size).setUsage(DynamicDrawUsage);
}

/** Many instances of a shape; `attributes`: by their names in shaders, the numbers of each. */
export function instancesOf(shape, attributes) {
  const geometry = new InstancedBufferGeometry();
  geometry.setIndex(shape.index);
  for (const name of ['position', 'uv']) geometry.setAttribute(name, shape.getAttribute(name));
  for (const [name, numbers] of Object.entries(attributes)) geometry.setAttribute(name, numbers);
  return geometry;
}
