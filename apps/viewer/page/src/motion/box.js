// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/** The space in which spheres move, as the header of a recording describes it: the box, and gravity. */
export class Box {
  /**
   * `size`: three lengths [L]; `boundary`: three of "wall", "periodic", "open", and "flat" for z in two dimensions;
   * `shear_rate` [1/T] and `shear_offset` [L], zero if absent: of a box whose images above along y slide along x;
   * `gravity`: three of [L/T²].
   */
  constructor({ size, boundary, shear_rate: rate = 0, shear_offset: offset = 0 }, gravity = [0, 0, 0]) {
    this.boundary = boundary;
    /** Edge lengths [L]; along open axes they say nothing about the motion. */
    this.size = size.map((length) => (Number.isFinite(length) ? length : 0));
    /** Edge lengths along periodic axes, zero along the others [L]. */
    this.period = this.size.map((length, axis) => (boundary[axis] === 'periodic' ? length : 0));
    this.isSheared = rate !== 0 || offset !== 0;
    /** The velocity along x of the image above [L/T]. */
    this.imageSpeed = rate * this.size[1];
    this.shearOffset = offset;
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

  /** By how much the image above is displaced along x at `time` [L]. */
  displacement(time) {
    return this.shearOffset + this.imageSpeed * time;
  }

  /** How many boxes above the box `height` along y is, where the box is sheared; otherwise zero. */
  layersAbove(height) {
    return this.isSheared ? Math.floor(height / this.period[1]) : 0;
  }

  /** Folds the point `place` [L] at `time` into the box, in place. */
  foldPoint(place, time) {
    const above = this.layersAbove(place[1]);
    if (above !== 0) place[0] -= above * this.displacement(time);
    for (let axis = 0; axis < 3; ++axis) place[axis] = this.fold(place[axis], axis);
    return place;
  }

  /** The shortest difference between all images at `time` of two places that are `difference` apart [L]. */
  nearestApart(difference, time) {
    const above = this.isSheared ? Math.round(difference[1] / this.period[1]) : 0;
    const slid = above === 0 ? 0 : above * this.displacement(time);
    return difference.map((apart, axis) => this.nearest(axis === 0 ? apart - slid : apart, axis));
  }

  /** The shortest of the differences `difference` along `axis` between all images of two places [L]. */
  nearest(difference, axis) {
    const period = this.period[axis];
    return period === 0 ? difference : difference - Math.round(difference / period) * period;
  }
}
