// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { Vector3 } from 'three';
import { kPathNumbers } from '../recording/chunk.js';
import { kKindNumbers, kMotionNumbers, kTurnNumbers, SphereObject } from './sphere_object.js';

/** Periodic images of spheres, drawn as the spheres are. */
export class SphereImages {
  /** `kinds` and `uniforms`: those of the spheres, which have marks if `canTurn`. */
  constructor(kinds, canTurn, uniforms, parent) {
    this.kinds = kinds;
    this.canTurn = canTurn;
    this.parent = parent;
    this.capacity = 0;
    this.velocity = [0, 0, 0];
    // Images are sent as they are now, and stay outside the box.
    this.uniforms = {
      ...uniforms,
      elapsed: { value: 0 },
      period: { value: new Vector3() },
      inversePeriod: { value: new Vector3() },
      followed: { value: -1 },
    };
  }

  /** Draws them as "impostors" or "points". */
  drawAs(way) {
    this.way = way;
    this.drawn?.dispose();
    this.drawn = null;
    this.capacity = 0;
  }

  /** Shows `images` at the time of `playback`; `numbers`: by id, as Spheres.numbersOf. */
  update(images, playback, numbers) {
    if (images.count > this.capacity) this.make(images.ids.length);
    if (!this.drawn) return;
    const { paths, time, bodies } = playback;
    const { array } = this.drawn.buffer;
    const kinds = this.drawn.kinds.array;
    for (let k = 0; k < images.count; ++k) {
      const id = images.ids[k];
      const to = kMotionNumbers * k;
      images.readVelocity(playback, k, this.velocity);
      for (let axis = 0; axis < 3; ++axis) {
        array[to + axis] = images.centers[3 * k + axis];
        array[to + 4 + axis] = this.velocity[axis];
      }
      array[to + 3] = paths[kPathNumbers * id + 6] - time;
      array[to + 7] = numbers[id];
      if (this.canTurn) {
        const turn = kTurnNumbers * k;
        this.drawn.turns.array.set(bodies.spin(id), turn);
        this.drawn.turns.array.set(bodies.orientation(id, time - paths[kPathNumbers * id + 6]), turn + 3);
      }
      for (let n = 0; n < kKindNumbers; ++n) kinds[kKindNumbers * k + n] = this.kinds[kKindNumbers * id + n];
    }
    this.drawn.show(images.count);
    for (const [buffer, numbers] of [
      [this.drawn.buffer, kMotionNumbers],
      [this.drawn.kinds, kKindNumbers],
      ...(this.canTurn ? [[this.drawn.turns, kTurnNumbers]] : []),
    ]) {
      buffer.clearUpdateRanges();
      buffer.addUpdateRange(0, numbers * images.count);
      buffer.needsUpdate = true;
    }
  }

  make(capacity) {
    this.drawn?.dispose();
    this.capacity = capacity;
    this.drawn = new SphereObject(
      this.way,
      new Float32Array(kMotionNumbers * capacity),
      new Float32Array(kKindNumbers * capacity),
      this.canTurn ? new Float32Array(kTurnNumbers * capacity) : null,
      this.uniforms,
    );
    this.parent.add(this.drawn.object);
  }
}
