// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { Group } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import { piecesInBox } from '../motion/path.js';
import { Rings } from './rings.js';

const kMostDeviation = 0.02; // of drawn lines from parabolas, in radii of the sphere

/** The path of the followed sphere: its past, contact by contact, and its next piece. */
export class Trail {
  constructor(box) {
    this.box = box;
    this.past = line({ linewidth: 2.5 });
    this.ahead = line({ linewidth: 2, dashed: true });
    this.object = new Group();
    this.rings = new Rings(1, 0);
    this.object.add(this.past, this.ahead, this.rings.object);
    this.object.visible = false;
  }

  /** The color, red, green, blue from 0 to 1, and the length of dashes [L]. */
  style(color, dash) {
    this.color = color;
    for (const { material } of [this.past, this.ahead]) material.color.setRGB(...color, 'srgb');
    this.ahead.material.dashSize = dash;
    this.ahead.material.gapSize = 0.7 * dash;
  }

  /**
   * Shows the motion along `paths` (see recentPaths) up to `time` [T], and on along the latest until `until` [T];
   * and a ring around the sphere, of radius `radius`, at `center` [L].
   */
  update(paths, time, until, center, radius) {
    this.rings.clear();
    this.rings.add(center, 1.3 * radius, this.color, 0);
    this.rings.send();
    const past = [];
    const tolerance = kMostDeviation * radius;
    for (const { numbers, until: end } of [...paths].reverse()) {
      past.push(...piecesInBox(numbers, numbers[6], Math.min(end, time), this.box, { tolerance }));
    }
    replace(this.past, past);
    replace(this.ahead, piecesInBox(paths[0].numbers, time, until, this.box, { most: 8, tolerance }));
  }
}

function line(options) {
  // The path is visible through the spheres in front of it.
  const material = new LineMaterial({ ...options, depthTest: false, depthWrite: false, transparent: true });
  const object = new LineSegments2(new LineSegmentsGeometry(), material);
  object.frustumCulled = false;
  object.renderOrder = 2;
  return object;
}

function replace(object, pieces) {
  object.geometry.dispose();
  object.geometry = new LineSegmentsGeometry();
  object.visible = pieces.length > 0;
  if (!object.visible) return;
  object.geometry.setPositions(pieces.flat(2));
  if (object.material.dashed) object.computeLineDistances();
}
