// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/** The space in which spheres move, as the header of a recording describes it: the box, and gravity. */
export class Box {
  /**
   * `size`: three lengths [L]; `boundary`: three of "wall", "periodic", "open", and "flat" for z in two dimensions;
   * `gravity`: three of [L/T²].
   */
  constructor({ size, boundary }, gravity = [0, 0, 0]) {
    this.boundary = boundary;
    /** Edge lengths [L]; along open axes they say nothing about the motion. */
    this.size = size.map((length) => (Number.isFinite(length) ? length : 0));
    /** Edge lengths along periodic axes, zero along the others [L]. */
    this.period = this.size.map((length, axis) => (boundary[axis] === 'periodic' ? length : 0));
    /** Acceleration of all spheres [L/T²]. */
    this.gravity = gravity;
    this.hasGravity = gravity.some((part) => part !== 0);
    /** Whether everything lies in the plane z = 0. */
    this.isFlat = boundary[2] === 'flat';
    this.dimensions = this.isFlat ? 2 : 3;
  }

  /** `place` along `axis` [L], folded into the box where that is periodic. */
  fold(place, axis) {
    const period = this.period[axis];
    if (period === 0 || (place >= 0 && place < period)) return place;
    return place - Math.floor(place / period) * period;
  }

  /** The shortest of the differences `difference` along `axis` between all images of two places [L]. */
  nearest(difference, axis) {
    const period = this.period[axis];
    return period === 0 ? difference : difference - Math.round(difference / period) * period;
  }
}
