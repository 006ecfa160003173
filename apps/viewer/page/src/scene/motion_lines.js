// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { piecesInBox, readCenter, readVelocity } from '../motion/path.js';
import { kPathNumbers } from '../recording/chunk.js';
import { kArrowColor, kTrailColor } from './colors.js';
import { Lines } from './lines.js';

const kMostLines = 60_000;
const kShaft = 0.12; // half its width, in radii of the sphere
const kHead = 3; // times the shaft
const kHeadShare = 0.3; // of the length of an arrow
const kTrail = 0.1; // half its width, in radii

/** An arrow for the velocity of each sphere: the way that it would go in some time. */
export class VelocityArrows {
  /** `uniforms`: those of the spheres. */
  constructor(bodies, box, uniforms) {
    this.bodies = bodies;
    this.box = box;
    this.lines = new Lines(box, uniforms, [kArrowColor]);
    this.object = this.lines.object;
  }

  /** Shows the way in `duration` [T] from where the spheres of `playback` are, of those of which `isShown(id, center)`. */
  update({ paths, time }, duration, isShown) {
    const count = this.bodies.radii.length;
    if (this.lines.geometry.attributes.begin.count < 2 * count) this.lines.reserve(2 * count);
    this.lines.clear();
    for (let id = 0; id < count; ++id) {
      if (!this.bodies.exists(id)) continue;
      const center = readCenter(paths, kPathNumbers * id, time, this.box, [0, 0, 0]);
      if (!isShown(id, center)) continue;
      const way = readVelocity(paths, kPathNumbers * id, time, this.box, [0, 0, 0]).map((part) => part * duration);
      const at = (share) => center.map((place, axis) => place + share * way[axis]);
      const width = kShaft * this.bodies.radii[id];
      this.lines.add(center, at(1 - kHeadShare), width, 0);
      this.lines.add(at(1 - kHeadShare), at(1), -kHead * width, 0);
    }
    this.lines.show();
  }
}

/** The ways of all spheres in some time before the present. */
export class Trails {
  /** `uniforms`: those of the spheres. */
  constructor(bodies, box, uniforms) {
    this.bodies = bodies;
    this.box = box;
    this.lines = new Lines(box, uniforms, [kTrailColor]);
    this.object = this.lines.object;
  }

  /** Shows the ways in the last `duration` [T], as far as the chunk of `playback` has them; as VelocityArrows. */
  update(playback, duration, isShown) {
    if (this.lines.geometry.attributes.begin.count === 0) this.lines.reserve(kMostLines);
    this.lines.clear();
    const { paths, time, chunk, cursor, hasMoments } = playback;
    const from = time - duration;
    const count = this.bodies.radii.length;
    const until = new Float64Array(count).fill(-Infinity);
    let open = 0;
    for (let id = 0; id < count; ++id) {
      if (!this.bodies.exists(id)) continue;
      const path = paths.subarray(kPathNumbers * id, kPathNumbers * (id + 1));
      if (!isShown(id, readCenter(path, 0, time, this.box, [0, 0, 0]))) continue;
      this.add(id, path, Math.max(from, path[6]), time);
      until[id] = path[6];
      if (path[6] > from) ++open;
    }
    if (!hasMoments) {
      const path = new Float64Array(kPathNumbers);
      const goBack = (id) => {
        this.add(id, path, Math.max(from, path[6]), until[id]);
        until[id] = path[6];
        if (path[6] <= from) --open;
      };
      for (let k = cursor - 1; k >= 0 && open > 0; --k) {
        for (const id of chunk.isCollision(k) ? [chunk.first(k), chunk.second(k)] : [chunk.first(k)]) {
          // The first contact found began the present path.
          if (chunk.isPass(k) || !(until[id] > from) || !(chunk.time(k) < until[id])) continue;
          chunk.readPathAfter(k, id, path);
          goBack(id);
        }
      }
      for (let id = 0; id < count && open > 0; ++id) {
        if (!(until[id] > from) || !(until[id] > chunk.begin)) continue;
        path.set(chunk.keyframe.subarray(kPathNumbers * id, kPathNumbers * (id + 1)));
        goBack(id);
      }
    }
    this.lines.show();
  }

  add(id, path, from, until) {
    const radius = this.bodies.radii[id];
    for (const [begin, end] of piecesInBox(path, from, until, this.box, { most: 8, tolerance: radius / 10 })) {
      if (this.lines.count < kMostLines) this.lines.add(begin, end, kTrail * radius, 0);
    }
  }
}
