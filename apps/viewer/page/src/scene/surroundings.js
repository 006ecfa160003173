// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { extentOf } from '../motion/extent.js';
import { Images } from '../motion/images.js';
import { SurfaceLayer } from './surface_layer.js';

/** What is around the spheres: walls and obstacles, and their own periodic images. */
export class NeighborQuery {
  /** `surfaces`: as read by readSurfaces; `spheres`: those drawn; `largestRadius`: of them [L]. */
  constructor(surfaces, radii, box, spheres, largestRadius) {
    this.surfaces = surfaces;
    this.box = box;
    this.spheres = spheres;
    this.largestRadius = largestRadius;
    this.images = new Images(radii, box);
    this.layer = new SurfaceLayer(surfaces, box, spheres.uniforms);
    this.object = this.layer.object;
    /** Within which surfaces are drawn: two corners [L]. */
    this.extent = null;
  }

  /** Takes over where the spheres of `playback` are, and returns it: two corners [L]. */
  measure(playback) {
    this.extent = extentOf(playback, this.box, this.surfaces, this.largestRadius);
    return this.extent;
  }

  /** In open space, widens the extent to where the spheres of `playback` have come; returns whether it has changed. */
  widen(playback) {
    if (this.surfaces.length === 0 || !this.box.boundary.includes('open')) return false;
    const [low, high] = this.extent;
    const [lowest, highest] = extentOf(playback, this.box, this.surfaces, this.largestRadius);
    this.extent = [
      low.map((place, axis) => Math.min(place, lowest[axis])),
      high.map((place, axis) => Math.max(place, highest[axis])),
    ];
    const isLess = (place, axis) => place < low[axis];
    const isMore = (place, axis) => place > high[axis];
    return lowest.some(isLess) || highest.some(isMore);
  }

  /** Shows walls and images, if they are to be shown, at the time of `playback`. */
  update(playback, { walls, images }) {
    this.object.visible = walls;
    this.layer.update(playback.time, this.extent);
    if (images) this.images.update(playback);
    else this.images.clear();
    this.spheres.images.update(this.images, playback, this.spheres.numbersOf(playback.collisions));
  }
}
