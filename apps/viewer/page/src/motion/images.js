// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kPathNumbers } from '../recording/chunk.js';
import { readCenter, readVelocity } from './path.js';

/**
 * Calls `visit(x, y, z)` for each periodic image, other than the sphere itself, of a sphere of radius `radius` at
 * `center` in the box at `time` that reaches into the box: its center [L].
 */
export function visitImages(center, radius, box, visit, time = 0) {
  const { period } = box;
  const isNear = (axis, step, place) => {
    if (step === 0) return true;
    if (period[axis] === 0) return false;
    return step > 0 ? place < radius : place > period[axis] - radius;
  };
  for (let y = -1; y <= 1; ++y) {
    if (!isNear(1, y, center[1])) continue;
    const slides = box.isSheared && y !== 0;
    const along = slides ? box.fold(center[0] + y * box.displacement(time), 0) : center[0];
    for (let x = -1; x <= 1; ++x) {
      if (!isNear(0, x, along)) continue;
      for (let z = -1; z <= 1; ++z) {
        if (!isNear(2, z, center[2]) || (x === 0 && y === 0 && z === 0)) continue;
        visit(along + x * period[0], center[1] + y * period[1], center[2] + z * period[2]);
      }
    }
  }
}

/** The periodic images of the spheres whose surfaces cross a periodic face: what reaches into the box there. */
export class Images {
  constructor(radii, box) {
    this.radii = radii;
    this.box = box;
    this.isPeriodic = box.period.some((period) => period > 0);
    /** How many there are. */
    this.count = 0;
    /** Of which sphere each is. */
    this.ids = new Uint32Array(64);
    /** Their centers, three numbers each [L]. */
    this.centers = new Float64Array(3 * 64);
    this.time = NaN;
    this.center = [0, 0, 0];
  }

  /** Finds those at the time of `playback`. Cost: O(spheres), once for each time. */
  update(playback) {
    const { paths, time } = playback;
    if (!this.isPeriodic || time === this.time) return;
    this.time = time;
    this.count = 0;
    const { radii } = this;
    for (let id = 0; id < radii.length; ++id) {
      if (this.isFarFromFaces(paths, kPathNumbers * id, time, radii[id])) continue;
      readCenter(paths, kPathNumbers * id, time, this.box, this.center);
      visitImages(this.center, radii[id], this.box, (x, y, z) => this.add(id, x, y, z), time);
    }
  }

  // Most spheres are: this is what costs time.
  isFarFromFaces(paths, start, time, radius) {
    const { period, gravity } = this.box;
    const elapsed = time - paths[start + 6];
    const above = this.box.layersAbove(paths[start + 1] + elapsed * paths[start + 4]);
    for (let axis = 0; axis < 3; ++axis) {
      const length = period[axis];
      if (length === 0) continue;
      let place = paths[start + axis] + elapsed * (paths[start + 3 + axis] + 0.5 * elapsed * gravity[axis]);
      if (axis === 0 && above !== 0) place -= above * this.box.displacement(time);
      const inBox = place - Math.floor(place / length) * length;
      if (inBox < radius || inBox > length - radius) return false;
    }
    return true;
  }

  /** Forgets all. */
  clear() {
    this.count = 0;
    this.time = NaN;
  }

  /** Writes the velocity of image `k` at the time of `playback` into `velocity` [L/T]. */
  readVelocity({ paths, time }, k, velocity) {
    return readVelocity(paths, kPathNumbers * this.ids[k], time, this.box, velocity);
  }

  add(id, x, y, z) {
    if (this.count === this.ids.length) this.grow();
    const k = this.count++;
    this.ids[k] = id;
    this.centers[3 * k] = x;
    this.centers[3 * k + 1] = y;
    this.centers[3 * k + 2] = z;
  }

  grow() {
    const [ids, centers] = [new Uint32Array(2 * this.ids.length), new Float64Array(2 * this.centers.length)];
    ids.set(this.ids);
    centers.set(this.centers);
    [this.ids, this.centers] = [ids, centers];
  }
}
