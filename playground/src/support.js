// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Modules of a few bytes: one with a vector, one with a try block.
const kWithVectors = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11];
const kWithExceptions = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 8, 1, 6, 0, 6, 64, 25, 11, 11];

function isValid(bytes) {
  return WebAssembly.validate(Uint8Array.from(bytes));
}

/** What the playground needs and this browser lacks, as words; empty if nothing. */
export function missingFeatures() {
  if (typeof WebAssembly !== 'object') return ['WebAssembly'];
  const missing = [];
  if (!isValid(kWithVectors)) missing.push('vectors in WebAssembly (SIMD)');
  if (!isValid(kWithExceptions)) missing.push('exceptions in WebAssembly');
  if (typeof CompressionStream !== 'function') missing.push('compression for links');
  if (!document.createElement('canvas').getContext('webgl2')) missing.push('WebGL 2, by which spheres are drawn');
  return missing;
}
