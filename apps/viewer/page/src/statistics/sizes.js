// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kWideRatio = 10; // of radii

/** How different the sizes of spheres are, and how they are shown. Those without a radius do not exist. */
export class Sizes {
  constructor(radii) {
    /** [L] */
    this.smallest = radii.reduce((least, radius) => (radius > 0 ? Math.min(least, radius) : least), Infinity);
    /** [L] */
    this.largest = radii.reduce((largest, radius) => Math.max(largest, radius), 0);
    /** Whether a logarithmic scale shows them best. */
    this.areWide = this.largest > kWideRatio * this.smallest;
    /** The diameter below which none is drawn, in CSS pixels: small ones are seen beside much larger ones. */
    this.leastPixels = this.areWide ? 3 : 1.2;
  }

  /** The radii at the ends of the color map. On a dark background the smallest, hard to see, are bright. */
  range(isDark) {
    // Spheres of one size are in the middle.
    const range = this.largest > this.smallest ? [this.smallest, this.largest] : [0, 2 * this.largest];
    return isDark ? range.reverse() : range;
  }
}
