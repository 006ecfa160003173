// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/**
 * The subdivision of space into cells: along each axis cell i reaches from origin + i edge to origin + (i + 1) edge.
 * A sphere is in each cell that its bounding box touches.
 */
export class Cells {
  /** `edge` and `origin`: three lengths [L] each. */
  constructor(edge, origin, box) {
    this.edge = edge;
    this.origin = origin;
    /** The number of cells along each periodic axis; zero along the others. */
    this.count = box.period.map((period, axis) => Math.round(period / edge[axis]));
  }

  /** Cells with edges of about `edge` [L], a whole number of which fits into the box. */
  static fitting(edge, box) {
    const edges = box.boundary.map((boundary, axis) =>
      boundary === 'open' ? edge : box.size[axis] / Math.max(1, Math.round(box.size[axis] / edge)),
    );
    return new Cells(edges, [0, 0, 0], box);
  }

  /** The index of the cell in which `place` lies along `axis` [L]. */
  index(place, axis) {
    return Math.floor((place - this.origin[axis]) / this.edge[axis]);
  }

  /** The lower end of cell `index` along `axis` [L], folded into the box. */
  begin(index, axis) {
    const count = this.count[axis];
    const folded = count === 0 ? index : index - Math.floor(index / count) * count;
    return this.origin[axis] + folded * this.edge[axis];
  }

  /**
   * When a sphere of radius `radius` on `path` enters the layer of cells `index` across `axis`, and when it
   * leaves it [T]: a pair; enter is not before leave if it is never there. The path is taken as infinite.
   */
  layerTimes(path, radius, index, axis) {
    const begin = this.origin[axis] + index * this.edge[axis];
    const end = begin + this.edge[axis];
    const place = path[axis];
    const velocity = path[3 + axis];
    if (velocity === 0) {
      const touches = place + radius >= begin && place - radius < end;
      return touches ? [-Infinity, Infinity] : [Infinity, -Infinity];
    }
    const [nearFace, farFace] =
      velocity > 0 ? [begin - radius, end + radius] : [end + radius, begin - radius];
    return [path[6] + (nearFace - place) / velocity, path[6] + (farFace - place) / velocity];
  }

  /** When a sphere on `path` enters the cell with the three `indices`, and when it leaves it; as layerTimes. */
  cellTimes(path, radius, indices) {
    let enter = -Infinity;
    let leave = Infinity;
    for (let axis = 0; axis < 3; ++axis) {
      const [from, until] = this.layerTimes(path, radius, indices[axis], axis);
      enter = Math.max(enter, from);
      leave = Math.min(leave, until);
    }
    return [enter, leave];
  }

  /**
   * Calls `visit(indices, enter, leave)` for each cell that a sphere on `path` touches between `from` and `until`
   * [T]; `indices` lives only as long as the call. Returns false, and visits none, if that may be more than `most`.
   */
  visit(path, radius, from, until, visit, most = 512) {
    const low = [0, 0, 0];
    const high = [0, 0, 0];
    let cells = 1;
    for (let axis = 0; axis < 3; ++axis) {
      const start = path[axis] + (from - path[6]) * path[3 + axis];
      const end = path[axis] + (until - path[6]) * path[3 + axis];
      low[axis] = this.index(Math.min(start, end) - radius, axis);
      high[axis] = this.index(Math.max(start, end) + radius, axis);
      cells *= high[axis] - low[axis] + 1;
    }
    if (cells > most) return false;
    const indices = [0, 0, 0];
    for (indices[0] = low[0]; indices[0] <= high[0]; ++indices[0]) {
      for (indices[1] = low[1]; indices[1] <= high[1]; ++indices[1]) {
        for (indices[2] = low[2]; indices[2] <= high[2]; ++indices[2]) {
          const [enter, leave] = this.cellTimes(path, radius, indices);
          if (enter < leave && enter <= until && leave >= from) visit(indices, enter, leave);
        }
      }
    }
    return true;
  }

  /** The first time after `time` at which a sphere on `path` enters or leaves a layer of cells. */
  nextCrossing(path, radius, time) {
    let next = { time: Infinity, kind: 'enter', axis: 0 };
    for (let axis = 0; axis < 3; ++axis) {
      const velocity = path[3 + axis];
      if (velocity === 0) continue;
      const place = path[axis] + (time - path[6]) * velocity;
      const forward = Math.sign(velocity);
      for (const kind of ['enter', 'leave']) {
        const surface = kind === 'enter' ? forward * radius : -forward * radius;
        let index = this.index(place + surface, axis) + (forward > 0 ? 1 : 0);
        for (;;) {
          const face = this.origin[axis] + index * this.edge[axis];
          const moment = path[6] + (face - surface - path[axis]) / velocity;
          if (moment > time) {
            if (moment < next.time) next = { time: moment, kind, axis };
            break;
          }
          index += forward;
        }
      }
    }
    return next;
  }
}
