// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { Mesh, SphereGeometry } from 'three';
import { visitImages } from '../motion/images.js';
import { changingNumbers, instancesOf, shaderMaterial } from './drawing.js';
import { kObstacleFragment, kObstacleVertex } from './surface_shaders.js';

const kMostImages = 8; // of an obstacle at a corner of a periodic box, itself among them

/** All obstacles, and their periodic images that reach into the box. */
export class Obstacles {
  /** `tints`: a color for each of `surfaces`; `shared`: uniforms of the spheres. */
  constructor(surfaces, tints, box, shared) {
    this.surfaces = surfaces;
    this.moves = surfaces.some((surface) => surface.moves);
    this.tints = tints;
    this.box = box;
    const most = surfaces.length * (box.period.some((period) => period > 0) ? kMostImages : 1);
    this.balls = changingNumbers(4, most);
    this.colors = changingNumbers(3, most);
    this.geometry = instancesOf(new SphereGeometry(1, 48, 24), { ball: this.balls, tint: this.colors });
    this.most = most;
    const { background, haze } = shared;
    const material = shaderMaterial(kObstacleVertex, kObstacleFragment, { background, haze });
    this.object = new Mesh(this.geometry, material);
    this.object.frustumCulled = false;
  }

  /** Moves them to where they are at `time` [T]. */
  update(time) {
    this.count = 0;
    this.surfaces.forEach((surface, k) => {
      const center = surface.pointAt(time).map((place, axis) => this.box.fold(place, axis));
      this.add(center, surface.radius, this.tints[k]);
      visitImages(center, surface.radius, this.box, (...image) =>
        this.add(image, surface.radius, this.tints[k]),
      );
    });
    this.geometry.instanceCount = this.count;
    this.balls.needsUpdate = this.colors.needsUpdate = true;
  }

  add(center, radius, tint) {
    if (this.count === this.most) return;
    const slot = this.count++;
    this.balls.array.set([...center, radius], 4 * slot);
    this.colors.array.set(tint, 3 * slot);
  }
}
