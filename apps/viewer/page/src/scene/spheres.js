// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import {
  BufferAttribute,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  BufferGeometry,
  Mesh,
  Points,
  RawShaderMaterial,
  Vector2,
  Vector3,
} from 'three';
import { kPathNumbers } from '../recording/chunk.js';
import { colorTexture, kMapColors, kSpeciesColors } from './colors.js';
import { kImpostorFragment, kImpostorVertex, kPointFragment, kPointVertex } from './sphere_shaders.js';

const kNumbers = 8; // per sphere on the graphics card: place and motion
const kBlock = 256; // spheres sent to the graphics card together

/** What spheres can be colored by, in the order in which the shader knows them. */
export const kColorBy = ['speed', 'radius', 'species', 'collisions', 'last contact'];

/**
 * All spheres, drawn by the graphics card. It gets each path once, relative to a reference time, and moves the
 * sphere by itself; only paths changed by a contact are sent again.
 */
export class Spheres {
  /** `species`: for each sphere the number of its kind. */
  constructor(radii, species, box) {
    this.count = radii.length;
    this.paths = new Float32Array(kNumbers * this.count);
    this.kinds = new Float32Array(2 * this.count);
    for (let id = 0; id < this.count; ++id) {
      this.kinds[2 * id] = radii[id];
      this.kinds[2 * id + 1] = species[id] % kSpeciesColors.length;
    }
    /** The time to which all places refer [T]. */
    this.reference = NaN;
    this.referenceEnd = NaN;
    this.dirty = new Uint8Array(Math.ceil(this.count / kBlock));
    this.ranges = Array.from(this.dirty, () => ({ start: 0, count: 0 }));
    this.longest = Math.max(...box.size);
    this.uniforms = {
      elapsed: { value: 0 },
      period: { value: new Vector3(...box.period) },
      inversePeriod: { value: new Vector3(...box.period.map((period) => (period > 0 ? 1 / period : 0))) },
      colorBy: { value: 0 },
      colorRange: { value: new Vector2(0, 1) },
      colorMap: { value: colorTexture(kMapColors, true) },
      speciesColors: { value: colorTexture(kSpeciesColors, false) },
      followed: { value: -1 },
      followedCenter: { value: new Vector3() },
      reach: { value: 0 },
      background: { value: new Vector3() },
      haze: { value: new Vector2(0, 1) },
      pixels: { value: 1 },
    };
    this.object = null;
    this.drawAs('impostors');
  }

  /** Draws spheres as "impostors", shaded and of true depth, or as "points", which cost less. */
  drawAs(way) {
    this.object?.geometry.dispose();
    this.object?.material.dispose();
    const asPoints = way === 'points';
    const geometry = asPoints ? new BufferGeometry() : new InstancedBufferGeometry();
    this.buffer = asPoints
      ? new InterleavedBuffer(this.paths, kNumbers)
      : new InstancedInterleavedBuffer(this.paths, kNumbers);
    geometry.setAttribute('place', new InterleavedBufferAttribute(this.buffer, 4, 0));
    geometry.setAttribute('motion', new InterleavedBufferAttribute(this.buffer, 4, 4));
    const Kinds = asPoints ? BufferAttribute : InstancedBufferAttribute;
    geometry.setAttribute('kind', new Kinds(this.kinds, 2));
    if (asPoints) {
      geometry.setDrawRange(0, this.count);
      geometry.setAttribute('position', geometry.getAttribute('place'));
    } else {
      geometry.instanceCount = this.count;
      geometry.setAttribute(
        'position',
        new BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3),
      );
      geometry.setIndex([0, 1, 2, 0, 2, 3]);
    }
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: asPoints ? kPointVertex : kImpostorVertex,
      fragmentShader: asPoints ? kPointFragment : kImpostorFragment,
      uniforms: this.uniforms,
    });
    const parent = this.object?.parent;
    this.object?.removeFromParent();
    this.object = asPoints ? new Points(geometry, material) : new Mesh(geometry, material);
    this.object.frustumCulled = false;
    parent?.add(this.object);
    this.way = way;
  }

  /** Takes over the paths touched by `playback`, and its time. */
  update(playback) {
    const { time } = playback;
    if (playback.allTouched || !(time >= this.reference && time < this.referenceEnd)) {
      this.refer(playback);
    } else {
      for (let k = 0; k < playback.touchedCount; ++k) {
        const id = playback.touched[k];
        this.store(playback, id);
        this.dirty[(id / kBlock) | 0] = 1;
      }
      this.send();
    }
    playback.takeTouched();
    this.uniforms.elapsed.value = time - this.reference;
  }

  // Makes the time of `playback` the reference. It holds until spheres have crossed the space they occupy a few
  // times, so that single precision suffices.
  refer(playback) {
    const { paths, time } = playback;
    this.reference = time;
    let fastest = 0;
    let { longest } = this;
    for (let id = 0; id < this.count; ++id) {
      this.store(playback, id);
      for (let axis = 0; axis < 3; ++axis) longest = Math.max(longest, Math.abs(this.paths[kNumbers * id + axis]));
      const start = kPathNumbers * id + 3;
      fastest = Math.max(fastest, paths[start] ** 2 + paths[start + 1] ** 2 + paths[start + 2] ** 2);
    }
    this.referenceEnd = time + (3 * longest) / Math.sqrt(fastest);
    this.dirty.fill(1);
    this.send();
  }

  store({ paths, collisions }, id) {
    const from = kPathNumbers * id;
    const to = kNumbers * id;
    const elapsed = this.reference - paths[from + 6];
    for (let axis = 0; axis < 3; ++axis) {
      const period = this.uniforms.period.value.getComponent(axis);
      const velocity = paths[from + 3 + axis];
      let place = paths[from + axis] + elapsed * velocity;
      if (period > 0) place -= Math.floor(place / period) * period;
      this.paths[to + axis] = place;
      this.paths[to + 4 + axis] = velocity;
    }
    this.paths[to + 3] = -elapsed;
    this.paths[to + 7] = collisions[id];
  }

  // Marks neighboring dirty blocks as ranges to be sent with the next drawing.
  send() {
    const { updateRanges } = this.buffer;
    updateRanges.length = 0;
    for (let block = 0; block < this.dirty.length; ++block) {
      if (!this.dirty[block]) continue;
      const first = block;
      while (block < this.dirty.length && this.dirty[block]) this.dirty[block++] = 0;
      const range = this.ranges[updateRanges.length];
      range.start = kNumbers * kBlock * first;
      range.count = Math.min(kNumbers * kBlock * block, this.paths.length) - range.start;
      updateRanges.push(range);
    }
    if (updateRanges.length > 0) this.buffer.needsUpdate = true;
  }
}
