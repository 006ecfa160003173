// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';

export function assertNear(value, expected, tolerance, what = '') {
  assert.ok(Math.abs(value - expected) <= tolerance, `${what} ${value} is not ${expected}`);
}
