// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { joinState, numbersIn, poseText, splitState } from '../../../apps/viewer/page/src/link.js';

test('a state is read as it was written', () => {
  const items = { t: '0.1', color: 'last contact', show: 'walls,cells', name: 'a&b=c #%', none: null, empty: '' };
  const text = joinState(items);
  assert.equal(text, 't=0.1&color=last+contact&show=walls,cells&name=a%26b%3Dc+%23%25&empty=');
  const { none, ...written } = items;
  assert.deepEqual(splitState(`#${text}`), written);
});

test('a rounded camera is rounded to itself, and by less than is seen', () => {
  for (const distance of [3e-5, 0.7, 12.3456789, 4e7]) {
    const pose = [distance + 1 / 3, 2 / 3, -distance / 7, 1 / 3, 2 / 3, -distance / 7];
    const text = poseText(pose);
    const rounded = numbersIn(text, 6);
    assert.equal(poseText(rounded), text);
    rounded.forEach((place, k) => assert.ok(Math.abs(place - pose[k]) <= 1e-5 * distance, `${text}`));
  }
  assert.ok(poseText([12.3456789, 5.111111, 30.999999, 5, 5, 5]).length <= 60);
});

test('numbers that are missing, too many or none are not taken', () => {
  assert.deepEqual(numbersIn('1,-2.5,3e4', 3), [1, -2.5, 3e4]);
  for (const text of [null, '', '1,2', '1,2,3,4', '1,,3', '1,x,3', '1,Infinity,3']) assert.equal(numbersIn(text, 3), null);
});
