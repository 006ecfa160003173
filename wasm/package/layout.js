// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Where the members of the structs of the C API lie in the memory of the module; layout.c holds it to the header.
export const kArray = { size: 12, stride: 4, type: 8 };
export const kContact = {
  size: 208,
  kind: 8,
  outcome: 12,
  first: 16,
  second: 20,
  point: 32,
  normal: 56,
  firstBefore: 80,
  secondBefore: 104,
  firstAfter: 128,
  secondAfter: 152,
  impulse: 176,
  impactSpeed: 200,
};
export const kError = { problem: 4, where: 8, remedy: 12 };
export const kFutureContact = { size: 24, first: 8, second: 12, kind: 16 };
export const kLimits = { size: 40, until: 8, contacts: 16, steps: 24, stop: 32, context: 36 };
export const kOptions = { size: 24, cellEdge: 8, threads: 16, engine: 20 };
export const kRayHit = { size: 64, point: 8, normal: 32, body: 56, kind: 60 };
export const kSphere = {
  size: 112,
  position: 8,
  velocity: 32,
  radius: 56,
  mass: 64,
  spin: 72,
  inertiaFactor: 96,
  species: 104,
};
export const kTotals = { size: 64, energy: 8, kineticEnergy: 16, rotationalEnergy: 24, momentum: 32, mass: 56 };

export const kTypes = { f64: 0, f32: 1, u32: 2, u64: 3 };
export const kFields = { id: 0, position: 1, velocity: 2, radius: 3, mass: 4, spin: 5, species: 6 };
export const kEngines = ['automatic', 'cells', 'neighbors', 'all_pairs', 'paper'];
export const kKinds = [null, 'collision', 'wall'];
export const kRunStatus = ['time', 'contacts', 'steps', 'stopped'];
export const kBoundaries = ['wall', 'periodic', 'open', 'flat'];
