// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Plan } from '../../../apps/viewer/page/src/film/plan.js';

test('a film shows its first and its last time, and all between at even steps', () => {
  const plan = new Plan({ from: 0.1, to: 0.7, speed: 0.3, fps: 30 });
  assert.equal(plan.count, 61);
  assert.equal(plan.timeOf(0), 0.1);
  assert.equal(plan.timeOf(60), 0.7);
  assert.ok(Math.abs(plan.timeOf(17) - (0.1 + 17 * 0.01)) < 1e-15);
  // A last frame that is not due is not shown.
  assert.equal(new Plan({ from: 0, to: 1, speed: 0.3, fps: 1 }).count, 4);
});

test('the camera turns evenly, and the last frame of a full turn comes before the first', () => {
  const plan = new Plan({ from: 0, to: 2, speed: 1, fps: 2, turn: 360 });
  const angles = Array.from({ length: plan.count }, (_, k) => plan.angleOf(k));
  assert.deepEqual(
    angles.map((angle) => Math.round((1000 * angle) / Math.PI)),
    [0, 400, 800, 1200, 1600],
  );
});

test('where no time passes, there is one picture, or a turn', () => {
  assert.equal(Plan.ofPicture(3).count, 1);
  assert.equal(Plan.ofPicture(3).timeOf(0), 3);
  const turn = new Plan({ from: 1, to: 1, speed: 1, fps: 10, turn: -90 });
  assert.deepEqual([turn.count, turn.seconds, turn.timeOf(79)], [80, 8, 1]);
});
