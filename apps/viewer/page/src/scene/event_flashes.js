// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kEventColors } from './colors.js';
import { Rings } from './rings.js';

const kMost = 512;

/** Rings that flash up where contacts happen, grow, and fade. */
export class EventFlashes {
  constructor(radii, box) {
    this.radii = radii;
    this.box = box;
    this.rings = new Rings(kMost, 0.3);
    this.object = this.rings.object;
    this.place = [0, 0, 0];
  }

  /** Shows the contacts of the last `window` [T] before the time of `playback`, the latest if there are too many. */
  update({ chunk, cursor, time }, window) {
    this.rings.clear();
    for (let k = cursor - 1; k >= 0 && !this.rings.isFull; --k) {
      const age = (time - chunk.time(k)) / window;
      if (age >= 1) break;
      this.add(chunk, k, age);
    }
    this.rings.send();
  }

  add(chunk, k, age) {
    const first = chunk.first(k);
    const second = chunk.second(k);
    const isCollision = second >= 0;
    const radius = this.radii[first];
    for (let axis = 0; axis < 3; ++axis) {
      let touch = chunk.numbers[chunk.firstPlace(k) + axis];
      if (isCollision) {
        const apart = this.box.nearest(chunk.numbers[chunk.secondPlace(k) + axis] - touch, axis);
        touch += (apart * radius) / (radius + this.radii[second]);
      } else if ((-second - 1) >> 1 === axis) {
        touch += (-second - 1) & 1 ? radius : -radius;
      }
      this.place[axis] = touch;
    }
    const size = isCollision ? Math.min(radius, this.radii[second]) : radius;
    this.rings.add(this.place, size, isCollision ? kEventColors.collision : kEventColors.wall, age);
  }
}
