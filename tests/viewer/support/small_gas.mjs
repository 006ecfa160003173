// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import zlib from 'node:zlib';

/**
 * A few spheres that collide with each other and with walls, found by comparing all pairs after each contact:
 * slow, short, and independent of the program. `box`: as in the header of a recording. Returns the bytes of a
 * recording, with `contactsOfChunk` contacts in each chunk or, if some are simultaneous, a few more.
 */
export function recordSmallGas({
  box,
  radii,
  masses,
  positions,
  velocities,
  until,
  contactsOfChunk,
  cellEdge = 0,
}) {
  const gas = {
    box,
    radii,
    masses,
    positions: positions.map((place) => [...place]),
    velocities: velocities.map((v) => [...v]),
  };
  const times = radii.map(() => 0);
  const keyframe = () => radii.flatMap((_, id) => [...gas.positions[id], ...gas.velocities[id], times[id]]);
  const chunks = [];
  let chunk = { begin: 0, keyframe: keyframe(), contacts: [] };
  const close = (end) => {
    chunks.push({ ...chunk, end });
    chunk = { begin: end, keyframe: keyframe(), contacts: [] };
  };
  let last = [-1, -1];
  for (;;) {
    const next = earliest(gas, times, last);
    if (next.time > until) break;
    if (chunk.contacts.length >= contactsOfChunk && next.time > chunk.contacts.at(-1).time)
      close(chunk.contacts.at(-1).time);
    const { time, first, second } = next;
    for (const id of second < 0 ? [first] : [first, second]) {
      for (let axis = 0; axis < 3; ++axis) gas.positions[id][axis] = place(gas, times, id, axis, time);
      times[id] = time;
    }
    bounce(gas, first, second);
    const after = (id) => [...gas.positions[id], ...gas.velocities[id]];
    chunk.contacts.push({
      time,
      first,
      second,
      numbers: [...after(first), ...(second < 0 ? Array(6).fill(0) : after(second))],
    });
    last = [first, second];
  }
  close(until);
  return writeRecording({ box, cell_edge: Array(3).fill(cellEdge) }, radii, masses, chunks);
}

/** Spheres at random places of a lattice in a box of edge `edge` [L], with random velocities; a fixed history. */
export function randomSpheres(count, edge, seed = 1) {
  let state = seed;
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
  const side = Math.ceil(Math.cbrt(count));
  const spacing = edge / side;
  const positions = Array.from({ length: count }, (_, id) =>
    [id % side, Math.floor(id / side) % side, Math.floor(id / side ** 2)].map(
      (step) => (step + 0.5) * spacing,
    ),
  );
  const velocities = positions.map(() => [0, 1, 2].map(() => 2 * random() - 1));
  return {
    positions,
    velocities,
    radii: positions.map(() => 0.3 * spacing),
    masses: positions.map((_, id) => 1 + (id % 2)),
  };
}

function place({ box, positions, velocities }, times, id, axis, time) {
  const unfolded = positions[id][axis] + (time - times[id]) * velocities[id][axis];
  if (box.boundary[axis] !== 'periodic') return unfolded;
  return unfolded - Math.floor(unfolded / box.size[axis]) * box.size[axis];
}

// The earliest contact of all, other than the previous one.
function earliest(gas, times, last) {
  const now = Math.max(...times);
  const { box, radii, velocities } = gas;
  let best = { time: Infinity };
  const at = (id, axis) => place(gas, times, id, axis, now);
  const count = radii.length;
  for (let first = 0; first < count; ++first) {
    for (let axis = 0; axis < 3; ++axis) {
      const velocity = velocities[first][axis];
      if (box.boundary[axis] !== 'wall' || velocity === 0) continue;
      const face = velocity > 0 ? box.size[axis] - radii[first] : radii[first];
      const time = now + Math.max(0, (face - at(first, axis)) / velocity);
      if (time < best.time) best = { time, first, second: -(2 * axis + (velocity > 0 ? 1 : 0)) - 1 };
    }
    for (let second = first + 1; second < count; ++second) {
      if (first === last[0] && second === last[1]) continue;
      const relative = [0, 1, 2].map((axis) => velocities[second][axis] - velocities[first][axis]);
      for (const image of images(box)) {
        const apart = [0, 1, 2].map((axis) => at(second, axis) - at(first, axis) + image[axis]);
        const closing = dot(apart, relative);
        if (closing >= 0) continue;
        const reach = radii[first] + radii[second];
        const root = closing ** 2 - dot(relative, relative) * (dot(apart, apart) - reach ** 2);
        if (root < 0) continue;
        const time = now + Math.max(0, (-closing - Math.sqrt(root)) / dot(relative, relative));
        if (time < best.time) best = { time, first, second };
      }
    }
  }
  return best;
}

function images({ size, boundary }) {
  const steps = boundary.map((kind, axis) => (kind === 'periodic' ? [-size[axis], 0, size[axis]] : [0]));
  return steps[0].flatMap((x) => steps[1].flatMap((y) => steps[2].map((z) => [x, y, z])));
}

function bounce({ box, positions, velocities, masses }, first, second) {
  if (second < 0) {
    const axis = (-second - 1) >> 1;
    velocities[first][axis] = -velocities[first][axis];
    return;
  }
  const apart = [0, 1, 2].map((axis) => {
    const difference = positions[second][axis] - positions[first][axis];
    if (box.boundary[axis] !== 'periodic') return difference;
    return difference - Math.round(difference / box.size[axis]) * box.size[axis];
  });
  const relative = [0, 1, 2].map((axis) => velocities[second][axis] - velocities[first][axis]);
  const impulse = (2 * dot(relative, apart)) / (dot(apart, apart) * (1 / masses[first] + 1 / masses[second]));
  for (let axis = 0; axis < 3; ++axis) {
    velocities[first][axis] += (impulse * apart[axis]) / masses[first];
    velocities[second][axis] -= (impulse * apart[axis]) / masses[second];
  }
}

function dot(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/**
 * The bytes of a recording; `chunks`: a list of {begin, end, keyframe, contacts}. Where they also have `bodies`,
 * contacts have a `fate`; where they have an `epoch`, of three numbers, spheres grow. What `header` leaves out is that
 * of a run of elastic spheres without cells.
 */
export function writeRecording(header, radii, masses, chunks) {
  const hasBodies = chunks.some(({ bodies }) => bodies !== undefined);
  const grows = chunks.some(({ epoch }) => epoch !== undefined);
  const usual = {
    spheres: radii.length,
    begin: 0,
    until: chunks.at(-1).end,
    cell_edge: [0, 0, 0],
    cell_origin: [0, 0, 0],
    name: 'small recording',
    restitution: 1,
  };
  let text = JSON.stringify({ ...usual, ...header, bodies: hasBodies, ...(grows ? { growth: true } : {}) });
  while ((12 + text.length) % 8 !== 0) text += ' ';
  const parts = [];
  const seal = (...part) => {
    const checksum = Buffer.alloc(8);
    checksum.writeUInt32LE(zlib.crc32(Buffer.concat(part)));
    parts.push(...part, checksum);
  };
  const numbers = (values) => Buffer.from(Float64Array.from(values).buffer);
  const integers = (...values) => Buffer.from(Uint32Array.from(values, (value) => value >>> 0).buffer);
  const magic = grows ? 'HBREC004' : header.motions ? 'HBREC005' : 'HBREC003';
  seal(Buffer.from(magic), integers(text.length), Buffer.from(text), numbers([...radii, ...masses]));
  for (const { begin, end, epoch = [], keyframe, bodies = [], contacts } of chunks) {
    const rest = Buffer.concat([
      numbers([...epoch, ...keyframe, ...bodies]),
      ...contacts.flatMap(({ time, first, second, fate, numbers: moves }) => [
        numbers([time]),
        integers(first, second, ...(hasBodies ? [fate, 0] : [])),
        numbers(moves),
      ]),
    ]);
    seal(integers(0x4b4e4843, contacts.length, 48 + rest.length, 0), numbers([begin, end]));
    seal(rest);
  }
  return Uint8Array.from(Buffer.concat(parts)).buffer;
}
