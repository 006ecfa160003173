// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kMostSegments = 256;

/** Where a motion from `place` with `velocity` is along one axis after `elapsed` [T], under `gravity` there [L]. */
export function placeAfter(elapsed, place, velocity, gravity) {
  return place + elapsed * (velocity + (elapsed / 2) * gravity);
}

/**
 * Writes the center at `time` [L], folded into the box, into `center`.
 * `paths` holds the path from number `start` on: position, velocity, start time.
 */
export function readCenter(paths, start, time, box, center) {
  const elapsed = time - paths[start + 6];
  for (let axis = 0; axis < 3; ++axis) {
    center[axis] = placeAfter(elapsed, paths[start + axis], paths[start + 3 + axis], box.gravity[axis]);
  }
  return box.foldPoint(center, time);
}

/** Writes the velocity at `time` [L/T] of the image in the box into `velocity`; as readCenter. */
export function readVelocity(paths, start, time, box, velocity) {
  const elapsed = time - paths[start + 6];
  for (let axis = 0; axis < 3; ++axis) velocity[axis] = paths[start + 3 + axis] + elapsed * box.gravity[axis];
  velocity[0] -= box.layersAbove(paths[start + 1] + elapsed * paths[start + 4]) * box.imageSpeed;
  return velocity;
}

/**
 * How long after its start a motion along one axis crosses `level` upward (`forward` 1) or downward (−1) [T]:
 * before the start if negative, Infinity if never. Each happens at most once.
 */
export function crossingTime(place, velocity, gravity, level, forward) {
  const apart = level - place;
  if (gravity === 0) return velocity * forward > 0 ? apart / velocity : Infinity;
  const square = velocity * velocity + 2 * gravity * apart;
  if (!(square >= 0)) return Infinity;
  const velocityThere = forward * Math.sqrt(square);
  // Of two equal expressions, the one that does not cancel.
  return velocity * forward > 0
    ? (2 * apart) / (velocity + velocityThere)
    : (velocityThere - velocity) / gravity;
}

/** The lowest and the highest place of the motion on `path` along `axis` between `from` and `until` [T]. */
export function rangeOf(path, axis, from, until, box) {
  const gravity = box.gravity[axis];
  const at = (time) => placeAfter(time - path[6], path[axis], path[3 + axis], gravity);
  const places = [at(from), at(until)];
  const turn = path[6] - path[3 + axis] / gravity;
  if (turn > from && turn < until) places.push(at(turn));
  return [Math.min(...places), Math.max(...places)];
}

/**
 * The motion along `path` from time `from` to `until`, cut where it crosses a periodic face: a list of pairs of
 * points in the box [L]. At most `most` pieces between faces; under gravity each is divided so that its segments
 * deviate from the parabola by no more than `tolerance` [L].
 */
export function piecesInBox(original, from, until, box, { most = 64, tolerance = Infinity } = {}) {
  const segments = [];
  const { gravity, period } = box;
  const path = Array.from(original.slice(0, 7));
  // As seen from the layer of images of a sheared box that is `above` boxes above.
  const seeFrom = (above) => {
    path[0] = original[0] - above * box.displacement(original[6]);
    path[3] = original[3] - above * box.imageSpeed;
  };
  const begin = original[1] + (from - original[6]) * original[4];
  seeFrom(box.layersAbove(begin + 1e-9 * Math.sign(original[4]) * period[1]));
  // The middle of a short step ahead shows in which image of the box the motion continues.
  const images = [0, 1, 2].map((axis) => {
    if (period[axis] === 0) return 0;
    const elapsed = from - path[6];
    const place = placeAfter(elapsed, path[axis], path[3 + axis], gravity[axis]);
    const ahead = Math.sign(path[3 + axis] + elapsed * gravity[axis] || gravity[axis]);
    return Math.floor(place / period[axis] + ahead * 1e-9);
  });
  let time = from;
  for (let piece = 0; time < until && piece < most; ++piece) {
    let next = { time: until, axis: 0, forward: 0 };
    for (let axis = 0; axis < 3; ++axis) {
      if (period[axis] === 0) continue;
      for (const forward of [1, -1]) {
        const face = (forward > 0 ? images[axis] + 1 : images[axis]) * period[axis];
        const moment = path[6] + crossingTime(path[axis], path[3 + axis], gravity[axis], face, forward);
        // A motion that turns at a face crosses it twice at one time.
        const follows = moment > time || (moment === time && forward * gravity[axis] > 0);
        if (follows && moment < next.time) next = { time: moment, axis, forward };
      }
    }
    addSegments(segments, path, time, next.time, box, images, tolerance);
    images[next.axis] += next.forward;
    time = next.time;
    if (!box.isSheared || next.axis !== 1) continue;
    seeFrom(images[1]);
    images[0] = Math.floor((path[0] + (time - path[6]) * path[3]) / period[0]);
  }
  return segments;
}

// Adds the motion between two times, displaced by `images` boxes, as segments.
function addSegments(segments, path, from, until, { gravity, period }, images, tolerance) {
  const duration = until - from;
  // A chord over the time t deviates by g t² / 8.
  const wanted = duration * Math.sqrt(Math.hypot(...gravity) / (8 * tolerance));
  const count = Math.min(kMostSegments, Math.max(1, Math.ceil(wanted)));
  const at = (time) =>
    [0, 1, 2].map(
      (axis) =>
        placeAfter(time - path[6], path[axis], path[3 + axis], gravity[axis]) - images[axis] * period[axis],
    );
  let begin = at(from);
  for (let k = 1; k <= count; ++k) {
    const end = at(k === count ? until : from + (k / count) * duration);
    segments.push([begin, end]);
    begin = end;
  }
}
