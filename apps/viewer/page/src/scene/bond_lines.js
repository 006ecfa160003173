// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { halvesOf } from '../motion/bonds.js';
import { readCenter } from '../motion/path.js';
import { kPathNumbers } from '../recording/chunk.js';
import { kBondColor } from './colors.js';
import { Lines } from './lines.js';

const kWidth = 0.6; // of a rod, in the smaller radius

/** The bonds between spheres: rods from center to center, which follow them. */
export class BondLines {
  /** `bonds`: pairs of ids; `uniforms`: those of the spheres. */
  constructor(bonds, bodies, box, uniforms) {
    this.bonds = bonds;
    this.bodies = bodies;
    this.box = box;
    this.lines = new Lines(box, uniforms, [kBondColor]);
    this.lines.reserve(2 * bonds.length);
    this.object = this.lines.object;
  }

  /** Takes over where the spheres are in `playback`. */
  update({ paths, time }) {
    const centerOf = (id) => readCenter(paths, kPathNumbers * id, time, this.box, [0, 0, 0]);
    this.lines.clear();
    for (const [first, second] of this.bonds) {
      if (!this.bodies.exists(first) || !this.bodies.exists(second)) continue;
      const radius = Math.min(this.bodies.radii[first], this.bodies.radii[second]);
      for (const [begin, end] of halvesOf(centerOf(first), centerOf(second), this.box, time))
        this.lines.add(begin, end, (kWidth / 2) * radius, 0);
    }
    this.lines.show();
  }
}
