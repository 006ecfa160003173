// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { emphasis, velocityChanges } from '../motion/impacts.js';
import { kBoxFaces } from '../motion/surfaces.js';
import { kEventColors } from './colors.js';
import { Rings } from './rings.js';

const kMost = 512;
const kMostLookedAt = 20_000; // contacts for a picture
const kRingsPerSphere = 1 / 5; // with more, rings fade: spheres are to be seen
const kFewRings = 12;
const kFaintest = 0.05;

/**
 * Rings that flash up where contacts happen, grow, and fade. They are the fainter the more there are, and where
 * contacts hardly change a velocity, as between spheres at rest on each other.
 */
export class EventFlashes {
  /** `surfaces`: as read by readSurfaces. */
  constructor(radii, box, surfaces) {
    this.radii = radii;
    this.box = box;
    this.surfaces = surfaces;
    this.rings = new Rings(kMost, 0.3);
    this.object = this.rings.object;
    this.changes = new WeakMap(); // of velocity, by chunk
  }

  /** Shows the contacts of the last `window` [T] before the time of `playback`, the latest if there are too many. */
  update({ chunk, cursor, time, bodies }, window) {
    if (!this.changes.has(chunk)) this.changes.set(chunk, velocityChanges(chunk, this.box.gravity));
    const first = Math.max(chunk.contactsUntil(time - window), cursor - kMostLookedAt);
    let total = 0;
    for (let k = first; k < cursor; ++k) if (chunk.isContact(k)) total += this.emphasisOf(chunk, k);
    const share = Math.min(1, Math.max(kFewRings, kRingsPerSphere * bodies.count) / total);
    this.rings.clear();
    for (let k = cursor - 1; k >= first && !this.rings.isFull; --k) {
      if (!chunk.isContact(k)) continue;
      const strength = share * this.emphasisOf(chunk, k);
      if (strength >= kFaintest) this.add(chunk, k, (time - chunk.time(k)) / window, strength);
    }
    this.rings.send();
  }

  /** How much of the picture rings take: the sum of how opaque they are at first. */
  get total() {
    const { count, extents } = this.rings;
    let total = 0;
    for (let ring = 0; ring < count; ++ring) total += extents.array[2 * ring + 1];
    return total;
  }

  emphasisOf(chunk, k) {
    return emphasis(this.changes.get(chunk)[k], this.radii[chunk.first(k)], this.box.gravity);
  }

  add(chunk, k, age, strength) {
    const first = chunk.first(k);
    const second = chunk.second(k);
    const isCollision = chunk.isCollision(k);
    if (chunk.isMerger(k)) {
      const place = chunk.firstPlace(k);
      const center = [0, 1, 2].map((axis) => chunk.numbers[place + axis]);
      this.rings.add(center, chunk.numbers[chunk.secondPlace(k) + 3], kEventColors.merger, age, strength);
      return;
    }
    const size = isCollision ? Math.min(this.radii[first], this.radii[second]) : this.radii[first];
    const color = isCollision ? kEventColors.collision : kEventColors.wall;
    this.rings.add(this.touchPoint(chunk, k), size, color, age, strength);
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
      const apart = center.map((from, axis) => chunk.numbers[other + axis] - from);
      const nearest = this.box.nearestApart(apart, chunk.time(k));
      return center.map((from, axis) => from + share * nearest[axis]);
    }
    const number = -second - 1;
    if (number >= kBoxFaces)
      return this.surfaces[number - kBoxFaces].touchPoint(center, radius, chunk.time(k), this.box);
    center[number >> 1] += number & 1 ? radius : -radius;
    return center;
  }
}
