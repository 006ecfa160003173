// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kBoxFaces } from '../motion/surfaces.js';
import { kEventColors } from './colors.js';
import { Rings } from './rings.js';

const kMost = 512;

/** Rings that flash up where contacts happen, grow, and fade. */
export class EventFlashes {
  /** `surfaces`: as read by readSurfaces. */
  constructor(radii, box, surfaces) {
    this.radii = radii;
    this.box = box;
    this.surfaces = surfaces;
    this.rings = new Rings(kMost, 0.3);
    this.object = this.rings.object;
  }

  /** Shows the contacts of the last `window` [T] before the time of `playback`, the latest if there are too many. */
  update({ chunk, cursor, time }, window) {
    this.rings.clear();
    for (let k = cursor - 1; k >= 0 && !this.rings.isFull; --k) {
      const age = (time - chunk.time(k)) / window;
      if (age >= 1) break;
      if (chunk.isContact(k)) this.add(chunk, k, age);
    }
    this.rings.send();
  }

  add(chunk, k, age) {
    const first = chunk.first(k);
    const second = chunk.second(k);
    const isCollision = chunk.isCollision(k);
    if (chunk.isMerger(k)) {
      const place = chunk.firstPlace(k);
      const center = [0, 1, 2].map((axis) => chunk.numbers[place + axis]);
      this.rings.add(center, chunk.numbers[chunk.secondPlace(k) + 3], kEventColors.merger, age);
      return;
    }
    const size = isCollision ? Math.min(this.radii[first], this.radii[second]) : this.radii[first];
    const color = isCollision ? kEventColors.collision : kEventColors.wall;
    this.rings.add(this.touchPoint(chunk, k), size, color, age);
  }

  // Where the two of contact `k` touch.
  touchPoint(chunk, k) {
    const second = chunk.second(k);
    const radius = this.radii[chunk.first(k)];
    const place = chunk.firstPlace(k);
    const center = [0, 1, 2].map((axis) => chunk.numbers[place + axis]);
    if (chunk.isCollision(k)) {
      // Of spheres that have become one since, the middle will do.
      const reach = radius + this.radii[second];
      const share = reach > 0 ? radius / reach : 0.5;
      const other = chunk.secondPlace(k);
      return center.map(
        (from, axis) => from + share * this.box.nearest(chunk.numbers[other + axis] - from, axis),
      );
    }
    const number = -second - 1;
    if (number >= kBoxFaces)
      return this.surfaces[number - kBoxFaces].touchPoint(center, radius, chunk.time(k), this.box);
    center[number >> 1] += number & 1 ? radius : -radius;
    return center;
  }
}
