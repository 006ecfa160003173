// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { Group, Vector3 } from 'three';
import { surfaceColors } from './colors.js';
import { Obstacles } from './obstacles.js';
import { CircleWall, ConeWall, CylinderWall, MeshWall, PlaneWall, SphereWall, WedgeWall } from './wall.js';

const kWalls = {
  plane: PlaneWall,
  cylinder: CylinderWall,
  pillar: CylinderWall,
  sphere: SphereWall,
  cone: ConeWall,
  mesh: MeshWall,
};
const kFlatWalls = {
  plane: PlaneWall,
  cylinder: CircleWall,
  pillar: CircleWall,
  sphere: CircleWall,
  cone: WedgeWall,
};
const kFlattened = 1e-4; // heights over the plane of two dimensions, so that only lines are seen

/** The surfaces that spheres bounce off, besides the faces of the box, where they are at the time shown. */
export class SurfaceLayer {
  /** `surfaces`: as read by readSurfaces; `shared`: uniforms of the spheres. */
  constructor(surfaces, box, shared) {
    this.object = new Group();
    /** For each surface, its color: red, green, blue from 0 to 1. */
    this.colors = surfaceColors(surfaces);
    this.clip = { low: { value: new Vector3() }, high: { value: new Vector3() } };
    this.extent = '';
    this.isFlat = box.isFlat;
    if (box.isFlat) this.object.scale.z = kFlattened;
    const walls = box.isFlat ? kFlatWalls : kWalls;
    const isObstacle = surfaces.map((surface) => surface.shape === 'obstacle');
    this.parts = surfaces.flatMap((surface, k) =>
      isObstacle[k] ? [] : [new walls[surface.shape](surface, this.colors[k], this.clip)],
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

  /** Shows the surfaces at `time` [T] within an extent, from its lower to its upper corner [L]. */
  update(time, [lower, upper]) {
    const height = this.isFlat ? Math.max(...upper.map((end, axis) => end - lower[axis])) : 0;
    const [low, high] = [[lower[0], lower[1], lower[2] - height], [upper[0], upper[1], upper[2] + height]];
    const extent = `${low} ${high}`;
    const hasChanged = extent !== this.extent;
    this.extent = extent;
    this.clip.low.value.set(...low);
    this.clip.high.value.set(...high);
    for (const part of this.parts) if (hasChanged || part.moves) part.update(time, low, high);
  }
}
