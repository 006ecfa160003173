// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { writeRecording } from './small_gas.mjs';

const kStep = 1 / 512; // of time; shorter touches are overlooked
const kMostContacts = 10_000;
const kFaces = [0, 1, 2].flatMap((axis) => [false, true].map((isUpper) => ({ axis, isUpper })));

/**
 * Spheres that do not meet each other, under gravity, between surfaces: each contact is found by small steps and
 * bisection, slow and independent of the program and of the page. `box`, `gravity`, `surfaces`: as in the header of a
 * recording. Returns the bytes of a recording in one chunk.
 */
export function recordLoneSpheres({
  box,
  gravity = [0, 0, 0],
  surfaces = [],
  radii,
  masses = radii.map(() => 1),
  positions,
  velocities,
  until,
}) {
  const contacts = radii.flatMap((radius, id) =>
    contactsOf({ box, gravity, surfaces, radius, id, until }, positions[id], velocities[id]),
  );
  contacts.sort((a, b) => a.time - b.time);
  const keyframe = radii.flatMap((_, id) => [...positions[id], ...velocities[id], 0]);
  const chunk = { begin: 0, end: until, keyframe, contacts };
  return writeRecording({ box, gravity, surfaces }, radii, masses, [chunk]);
}

function contactsOf({ box, gravity, surfaces, radius, id, until }, position, velocity) {
  const walls = [
    ...kFaces.map(({ axis, isUpper }, number) => ({
      number,
      isThere: box.boundary[axis] === 'wall',
      normal: () => [0, 1, 2].map((other) => (other !== axis ? 0 : isUpper ? -1 : 1)),
      gap: (place) => (isUpper ? box.size[axis] - place[axis] : place[axis]) - radius,
      speed: () => 0,
      restitution: 1,
    })),
    ...surfaces.map((surface, k) => ({ number: 6 + k, isThere: true, ...wallOf(surface, radius) })),
  ].filter(({ isThere }) => isThere);
  let [x, v, t0] = [position, velocity, 0];
  const at = (time) => x.map((place, k) => place + (time - t0) * (v[k] + ((time - t0) / 2) * gravity[k]));
  const contacts = [];
  for (let time = 0; time < until;) {
    const next = Math.min(until, time + kStep);
    const hits = walls.filter(
      (wall) => wall.gap(at(next), next) < 0 && wall.gap(at(next), next) < wall.gap(at(time), time),
    );
    if (hits.length === 0) {
      time = next;
      continue;
    }
    const moments = hits.map((wall) => bisect((moment) => wall.gap(at(moment), moment), time, next));
    const moment = Math.min(...moments);
    const wall = hits[moments.indexOf(moment)];
    const place = at(moment);
    const arriving = v.map((part, k) => part + (moment - t0) * gravity[k]);
    const normal = wall.normal(place, moment);
    const closing = dot(arriving, normal) - wall.speed(moment, normal);
    [x, t0] = [place.map((part, axis) => fold(part, axis, box)), moment];
    v = arriving.map((part, k) => part - (1 + wall.restitution) * Math.min(closing, 0) * normal[k]);
    contacts.push({
      time: moment,
      first: id,
      second: -wall.number - 1,
      numbers: [...x, ...v, 0, 0, 0, 0, 0, 0],
    });
    time = moment;
    if (contacts.length > kMostContacts) throw new Error(`sphere ${id} is squeezed or at rest`);
  }
  return contacts;
}

// How far a sphere of radius `radius` is from a surface, the normal to its side, and the surface's speed along it.
function wallOf(surface, radius) {
  const { shape, direction, amplitude = 0, frequency = 0, restitution = 1, velocity = [0, 0, 0] } = surface;
  const angle = (time) => 2 * Math.PI * frequency * time;
  const pointAt = (time) =>
    surface.point.map(
      (part, k) =>
        part + velocity[k] * time + (amplitude ? amplitude * Math.sin(angle(time)) * direction[k] : 0),
    );
  const apart = (place, time) => {
    const difference = place.map((part, k) => part - pointAt(time)[k]);
    if (shape !== 'cylinder' && shape !== 'pillar') return difference;
    const along = dot(difference, direction);
    return difference.map((part, k) => part - along * direction[k]);
  };
  if (shape === 'plane') {
    return {
      gap: (place, time) => dot(apart(place, time), direction) - radius,
      normal: () => direction,
      speed: (time) => dot(velocity, direction) + amplitude * 2 * Math.PI * frequency * Math.cos(angle(time)),
      restitution,
    };
  }
  const side = shape === 'obstacle' || shape === 'pillar' ? 1 : -1;
  const normal = (place, time) => {
    const difference = apart(place, time);
    return difference.map((part) => (side * part) / Math.hypot(...difference));
  };
  return {
    gap: (place, time) => side * (Math.hypot(...apart(place, time)) - surface.radius) - radius,
    normal,
    speed: (moment, towards) => dot(velocity, towards),
    restitution,
  };
}

// Where a decreasing function becomes negative, from the side where it is not.
function bisect(f, low, high) {
  for (let round = 0; round < 60; ++round) {
    const middle = (low + high) / 2;
    if (f(middle) >= 0) low = middle;
    else high = middle;
  }
  return low;
}

function fold(place, axis, { size, boundary }) {
  return boundary[axis] === 'periodic' ? place - Math.floor(place / size[axis]) * size[axis] : place;
}

function dot(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
