// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kStrongForce, linesOf } from '../motion/forces.js';
import { readCenter } from '../motion/path.js';
import { kPathNumbers } from '../recording/chunk.js';
import { kMapColors } from './colors.js';
import { Lines } from './lines.js';

/** The forces that hold spheres at rest: lines between centers, thicker and brighter where they are stronger. */
export class ForceLines {
  /** `uniforms`: those of the spheres. */
  constructor(forces, bodies, box, uniforms) {
    this.forces = forces;
    this.bodies = bodies;
    this.box = box;
    this.lines = new Lines(box, uniforms, kMapColors);
    this.object = this.lines.object;
  }

  /** Takes over where the spheres are in `playback`, once: they are at rest. */
  update({ paths, time }) {
    if (this.lines.count > 0) return;
    const centerOf = (id) => readCenter(paths, kPathNumbers * id, time, this.box, [0, 0, 0]);
    const lines = linesOf(this.forces, centerOf, (id) => this.bodies.radii[id]);
    this.lines.reserve(lines.length);
    for (const { begin, end, halfWidth, force } of lines) this.lines.add(begin, end, halfWidth, force / kStrongForce);
    this.lines.show();
  }
}
