// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { crossingTime, placeAfter, rangeOf } from './path.js';

/**
 * The subdivision of space into cells: along each axis cell i reaches from origin + i edge to origin + (i + 1) edge.
 * A sphere is in each cell that its bounding box touches.
 */
export class Cells {
  /** `edge` and `origin`: three lengths [L] each. Cells are squares where the box is flat: the edge is zero there. */
  constructor(edge, origin, box) {
    this.edge = edge.map((length, axis) => (axis < box.dimensions ? length : 0));
    this.dimensions = box.dimensions;
    this.origin = origin;
    /** The number of cells along each periodic axis; zero along the others. */
    this.count = box.period.map((period, axis) => (period > 0 ? Math.round(period / edge[axis]) : 0));
    this.gravity = box.gravity;
  }

  /** Cells with edges of about `edge` [L], a whole number of which fits into the box. */
  static fitting(edge, box) {
    const edges = box.boundary.map((boundary, axis) => {
      if (boundary === 'open' || boundary === 'flat') return edge;
      return box.size[axis] / Math.max(1, Math.round(box.size[axis] / edge));
    });
    return new Cells(edges, [0, 0, 0], box);
  }

  /** The index of the cell in which `place` lies along `axis` [L]. */
  index(place, axis) {
    if (axis >= this.dimensions) return 0;
    return Math.floor((place - this.origin[axis]) / this.edge[axis]);
  }

  /** The lower end of cell `index` along `axis` [L], folded into the box. */
  begin(index, axis) {
    const count = this.count[axis];
    const folded = count === 0 ? index : index - Math.floor(index / count) * count;
    return this.origin[axis] + folded * this.edge[axis];
  }

  /**
   * When a sphere of radius `radius` on `path` touches the layer of cells `index` across `axis`: a list of pairs of
   * times [T] at which it enters and leaves. The path is taken as infinite.
   */
  layerTimes(path, radius, index, axis) {
    if (axis >= this.dimensions) return [[-Infinity, Infinity]];
    const begin = this.origin[axis] + index * this.edge[axis];
    const end = begin + this.edge[axis];
    const place = path[axis];
    const velocity = path[3 + axis];
    const gravity = this.gravity[axis];
    if (velocity === 0 && gravity === 0) {
      const touches = place + radius >= begin && place - radius < end;
      return touches ? [[-Infinity, Infinity]] : [];
    }
    const low = begin - radius;
    const high = end + radius;
    const cross = (level, forward) => path[6] + crossingTime(place, velocity, gravity, level, forward);
    if (gravity === 0 && velocity > 0) return [[cross(low, 1), cross(high, 1)]];
    if (gravity === 0) return [[cross(high, -1), cross(low, -1)]];
    // The motion comes from the side to which gravity pulls, turns, and returns.
    const toTurn = gravity < 0 ? 1 : -1;
    const [near, far] = gravity < 0 ? [low, high] : [high, low];
    const enter = cross(near, toTurn);
    if (enter === Infinity) return [];
    const leave = cross(near, -toTurn);
    const beyond = cross(far, toTurn);
    return beyond === Infinity
      ? [[enter, leave]]
      : [
          [enter, beyond],
          [cross(far, -toTurn), leave],
        ];
  }

  /** When a sphere on `path` touches the cell with the three `indices`; as layerTimes. */
  cellTimes(path, radius, indices) {
    let times = [[-Infinity, Infinity]];
    for (let axis = 0; axis < 3; ++axis) {
      const ofLayer = this.layerTimes(path, radius, indices[axis], axis);
      times = times.flatMap(([enter, leave]) =>
        ofLayer
          .map(([from, until]) => [Math.max(enter, from), Math.min(leave, until)])
          .filter(([from, until]) => from < until),
      );
    }
    return times;
  }

  /**
   * Calls `visit(indices, enter, leave)` for each cell that a sphere on `path` touches between `from` and `until`
   * [T], for each time that it does; `indices` lives only as long as the call. Returns false, and visits none, if that may be more than `most`.
   */
  visit(path, radius, from, until, visit, most = 512) {
    const low = [0, 0, 0];
    const high = [0, 0, 0];
    let cells = 1;
    for (let axis = 0; axis < 3; ++axis) {
      const [lowest, highest] = rangeOf(path, axis, from, until, this);
      low[axis] = this.index(lowest - radius, axis);
      high[axis] = this.index(highest + radius, axis);
      cells *= high[axis] - low[axis] + 1;
    }
    if (cells > most) return false;
    const indices = [0, 0, 0];
    for (indices[0] = low[0]; indices[0] <= high[0]; ++indices[0]) {
      for (indices[1] = low[1]; indices[1] <= high[1]; ++indices[1]) {
        for (indices[2] = low[2]; indices[2] <= high[2]; ++indices[2]) {
          for (const [enter, leave] of this.cellTimes(path, radius, indices)) {
            if (enter <= until && leave >= from) visit(indices, enter, leave);
          }
        }
      }
    }
    return true;
  }

  /** The first time after `time` at which a sphere on `path` enters or leaves a layer of cells. */
  nextCrossing(path, radius, time) {
    let next = { time: Infinity, kind: 'enter', axis: 0 };
    for (let axis = 0; axis < this.dimensions; ++axis) {
      const gravity = this.gravity[axis];
      const elapsed = time - path[6];
      const place = placeAfter(elapsed, path[axis], path[3 + axis], gravity);
      const velocity = path[3 + axis] + elapsed * gravity;
      for (const forward of [1, -1]) {
        if (!(forward * velocity > 0 || forward * gravity > 0)) continue;
        for (const kind of ['enter', 'leave']) {
          const surface = kind === 'enter' ? forward * radius : -forward * radius;
          let index = this.index(place + surface, axis) + (forward > 0 ? 1 : 0);
          for (;;) {
            const level = this.origin[axis] + index * this.edge[axis] - surface;
            const moment = path[6] + crossingTime(path[axis], path[3 + axis], gravity, level, forward);
            if (moment > time) {
              if (moment < next.time) next = { time: moment, kind, axis };
              break;
            }
            index += forward;
          }
        }
      }
    }
    return next;
  }
}
