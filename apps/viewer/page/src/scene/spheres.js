// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { DataTexture, FloatType, Group, Matrix3, RGBAFormat, Vector2, Vector3 } from 'three';
import { placeAfter } from '../motion/path.js';
import { kPathNumbers } from '../recording/chunk.js';
import { colorTexture, kDomainColors, kKinematicColor, kMapColors, kSpeciesColors } from './colors.js';
import { SphereImages } from './sphere_images.js';
import { kKindNumbers, kMotionNumbers as kNumbers, kTurnNumbers, SphereObject } from './sphere_object.js';

const kBlock = 256; // spheres sent to the graphics card together
const kFar = 1e30; // instead of infinity, which shaders need not know [L]

/** What spheres can be colored by, in the order in which the shader knows them. */
export const kColorBy = ['speed', 'size', 'species', 'collisions', 'last contact', 'spin', 'domain', 'contacts', 'energy', 'neighbors'];

/** Those of them that are measured anew for each picture. */
export const kMeasured = ['energy', 'neighbors'];

/**
 * All spheres, drawn by the graphics card. It gets each path once, relative to a reference time, and moves the
 * sphere by itself; only paths changed by a contact are sent again.
 */
export class Spheres {
  /**
   * `bodies`: those of the playback; `species`: for each sphere its number; `canTurn`: whether spheres may spin;
   * `contacts`: how many each sphere at rest has, or null.
   */
  constructor(bodies, species, box, canTurn, contacts) {
    this.bodies = bodies;
    this.contacts = contacts;
    /** By id: what spheres are colored by, if it is measured for each picture; otherwise null. */
    this.measured = null;
    this.count = bodies.radii.length;
    this.paths = new Float32Array(kNumbers * this.count);
    this.kinds = new Float32Array(kKindNumbers * this.count);
    this.turns = canTurn ? new Float32Array(kTurnNumbers * this.count) : null;
    for (let id = 0; id < this.count; ++id) {
      this.kinds[kKindNumbers * id] = bodies.baseRadii[id];
      this.kinds[kKindNumbers * id + 1] = species[id] % kSpeciesColors.length;
      this.kinds[kKindNumbers * id + 2] = bodies.isKinematic(id) ? 1 : 0;
    }
    /** The time to which all places refer [T]. */
    this.reference = NaN;
    this.referenceEnd = NaN;
    this.dirty = new Uint8Array(Math.ceil(this.count / kBlock));
    this.box = box;
    this.center = [0, 0, 0];
    this.longest = Math.max(...box.size);
    this.uniforms = {
      elapsed: { value: 0 },
      scale: { value: 1 },
      gravity: { value: new Vector3(...box.gravity) },
      period: { value: new Vector3(...box.period) },
      inversePeriod: { value: new Vector3(...box.period.map((period) => (period > 0 ? 1 / period : 0))) },
      colorBy: { value: 0 },
      colorRange: { value: new Vector2(0, 1) },
      colorIsLogarithmic: { value: false },
      colorMap: { value: colorTexture(kMapColors, true) },
      speciesColors: { value: colorTexture(kSpeciesColors, false) },
      domainColors: { value: colorTexture(kDomainColors, false) },
      domainBlocks: { value: null },
      domainCount: { value: 0 },
      slid: { value: new Vector2() },
      boxPeriod: { value: new Vector3(...box.period) },
      kinematicColor: { value: new Vector3(...kKinematicColor) },
      hasMarks: { value: canTurn },
      fromCamera: { value: new Matrix3() },
      isFlat: { value: box.isFlat },
      followed: { value: -1 },
      followedCenter: { value: new Vector3() },
      reach: { value: 0 },
      sliceLow: { value: new Vector3(-kFar, -kFar, -kFar) },
      sliceHigh: { value: new Vector3(kFar, kFar, kFar) },
      background: { value: new Vector3() },
      haze: { value: new Vector2(0, 1) },
      pixels: { value: 1 },
      leastPixels: { value: 1 },
    };
    this.object = new Group();
    this.images = new SphereImages(this.kinds, canTurn, this.uniforms, this.object);
    this.drawAs('impostors');
  }

  /** Draws spheres as "impostors" or "points" (see SphereObject). */
  drawAs(way) {
    this.drawn?.dispose();
    this.drawn = new SphereObject(way, this.paths, this.kinds, this.turns, this.uniforms);
    this.object.add(this.drawn.object);
    this.images.drawAs(way);
    this.way = way;
  }

  /** Colors spheres by the `blocks` that they are in, where they are colored by domain. */
  divide(blocks) {
    if (blocks === this.blocks || blocks.length === 0) return;
    this.blocks = blocks;
    const { domainBlocks, domainCount } = this.uniforms;
    domainBlocks.value?.dispose();
    const numbers = blocks.flatMap(({ low, high }) =>
      [...low, 0, ...high, 0].map((place) => Math.min(Math.max(place, -kFar), kFar)),
    );
    domainBlocks.value = new DataTexture(new Float32Array(numbers), 2, blocks.length, RGBAFormat, FloatType);
    domainBlocks.value.needsUpdate = true;
    domainCount.value = blocks.length;
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
    this.uniforms.scale.value = playback.scale;
    this.uniforms.slid.value.set(this.box.fold(this.box.displacement(time), 0), this.box.imageSpeed);
  }

  /** By id, the number that a coloring shows: the collisions, unless it is another. */
  numbersOf(collisions) {
    return this.measured ?? this.contacts ?? collisions;
  }

  /** Draws only spheres whose centers are between `low` and `high` along `axis` [L]; all if that is null. */
  slice(axis, low = -kFar, high = kFar) {
    const { sliceLow, sliceHigh } = this.uniforms;
    sliceLow.value.setScalar(-kFar);
    sliceHigh.value.setScalar(kFar);
    if (axis === null) return;
    sliceLow.value.setComponent(axis, low);
    sliceHigh.value.setComponent(axis, high);
  }

  /** Places follow from the next moment alone, as on a page that has shown no other. */
  forget() {
    this.reference = NaN;
  }

  // Makes the time of `playback` the reference. It holds until spheres have crossed the space they occupy a few
  // times, so that single precision suffices.
  refer(playback) {
    const { paths } = this;
    this.reference = playback.time;
    let fastest = 0;
    let { longest } = this;
    for (let id = 0; id < this.count; ++id) {
      this.store(playback, id);
      const start = kNumbers * id;
      for (let axis = 0; axis < 3; ++axis) longest = Math.max(longest, Math.abs(paths[start + axis]));
      fastest = Math.max(fastest, paths[start + 4] ** 2 + paths[start + 5] ** 2 + paths[start + 6] ** 2);
    }
    // The least t with v t + g t² / 2 = 3 L.
    const speed = Math.sqrt(fastest);
    const gravity = Math.hypot(...this.box.gravity);
    this.referenceEnd = this.reference + (6 * longest) / (speed + Math.sqrt(fastest + 6 * gravity * longest));
    this.dirty.fill(1);
    this.send();
  }

  store({ paths, collisions }, id) {
    const from = kPathNumbers * id;
    const to = kNumbers * id;
    const elapsed = this.reference - paths[from + 6];
    for (let axis = 0; axis < 3; ++axis) {
      const gravity = this.box.gravity[axis];
      const velocity = paths[from + 3 + axis];
      this.center[axis] = placeAfter(elapsed, paths[from + axis], velocity, gravity);
      this.paths[to + 4 + axis] = velocity + elapsed * gravity;
    }
    this.paths[to + 4] -= this.box.layersAbove(this.center[1]) * this.box.imageSpeed;
    this.paths.set(this.box.foldPoint(this.center, this.reference), to);
    this.paths[to + 3] = -elapsed;
    this.paths[to + 7] = this.numbersOf(collisions)[id];
    if (this.turns) this.storeBody(id, elapsed);
  }

  // How the sphere turns, and what it is, which changes as spheres merge; `elapsed` on its path until the reference.
  storeBody(id, elapsed) {
    const { bodies } = this;
    this.turns.set(bodies.spin(id), kTurnNumbers * id);
    this.turns.set(bodies.orientation(id, elapsed), kTurnNumbers * id + 3);
    const kind = kKindNumbers * id;
    const radius = Math.fround(bodies.baseRadii[id]);
    const isKinematic = bodies.isKinematic(id) ? 1 : 0;
    if (this.kinds[kind] === radius && this.kinds[kind + 2] === isKinematic) return;
    this.kinds[kind] = radius;
    this.kinds[kind + 2] = isKinematic;
    this.drawn.kinds.needsUpdate = true;
  }

  // Marks neighboring dirty blocks as ranges to be sent with the next drawing.
  send() {
    const buffers = [[this.drawn.buffer, kNumbers], ...(this.turns ? [[this.drawn.turns, kTurnNumbers]] : [])];
    for (const [buffer] of buffers) buffer.clearUpdateRanges();
    for (let block = 0; block < this.dirty.length; ++block) {
      if (!this.dirty[block]) continue;
      const first = block;
      while (block < this.dirty.length && this.dirty[block]) this.dirty[block++] = 0;
      const [start, end] = [kBlock * first, Math.min(kBlock * block, this.count)];
      for (const [buffer, numbers] of buffers) {
        buffer.addUpdateRange(numbers * start, numbers * (end - start));
        buffer.needsUpdate = true;
      }
    }
  }
}
