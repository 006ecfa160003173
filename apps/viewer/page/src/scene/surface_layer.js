// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { Group, Vector3 } from 'three';
import { surfaceColors } from './colors.js';
import { Obstacles } from './obstacles.js';
import { CylinderWall, PlaneWall, SphereWall } from './wall.js';

const kWalls = { plane: PlaneWall, cylinder: CylinderWall, sphere: SphereWall };

/** The surfaces that spheres bounce off, besides the faces of the box, where they are at the time shown. */
export class SurfaceLayer {
  /** `surfaces`: as read by readSurfaces; `shared`: uniforms of the spheres. */
  constructor(surfaces, box, shared) {
    this.object = new Group();
    /** For each surface, its color: red, green, blue from 0 to 1. */
    this.colors = surfaceColors(surfaces);
    this.clip = { low: { value: new Vector3() }, high: { value: new Vector3() } };
    this.extent = '';
    const isObstacle = surfaces.map((surface) => surface.shape === 'obstacle');
    this.parts = surfaces.flatMap((surface, k) =>
      isObstacle[k] ? [] : [new kWalls[surface.shape](surface, this.colors[k], this.clip)],
    );
    if (isObstacle.includes(true)) {
      const tints = this.colors.filter((_, k) => isObstacle[k]);
      this.parts.push(
        new Obstacles(
          surfaces.filter((_, k) => isObstacle[k]),
          tints,
          box,
          shared,
        ),
      );
    }
    for (const { object } of this.parts) this.object.add(object);
    this.object.renderOrder = -1;
  }

  /** Shows the surfaces at `time` [T] within the extent `low` to `high` [L]. */
  update(time, [low, high]) {
    const extent = `${low} ${high}`;
    const hasChanged = extent !== this.extent;
    this.extent = extent;
    this.clip.low.value.set(...low);
    this.clip.high.value.set(...high);
    for (const part of this.parts) if (hasChanged || part.moves) part.update(time, low, high);
  }
}
