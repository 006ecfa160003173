// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Pages that show one moment, such as that of a packing: they have no controls of time, and of motion only where
// spheres move.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { browser, follow, state, withSaved } from '../support/pages.mjs';
import { run, withFolder, writeScenario } from '../support/program.mjs';

const kWindow = { width: 1200, height: 800 };

// The share of the picture that spheres cover; their color is blue, that of rattlers orange.
async function coverage(page) {
  const { width, height, data } = await browser.pixels(page);
  const isSphere = (red, green, blue) => (blue > red + 60 && blue > green + 25) || red > blue + 80;
  let covered = 0;
  let all = 0;
  for (let y = 100; y < height - 100; ++y)
    for (let x = 200; x < width - 500; ++x) {
      const start = 4 * (y * width + x);
      ++all;
      if (isSphere(data[start], data[start + 1], data[start + 2])) ++covered;
    }
  return covered / all;
}

// What only makes sense as time passes, and where spheres move.
const kOfTime = ['#transport', '#play', '#scrub', '#speed', '#show-cells', '#show-events', '#slow', '#plot-rate'];
const kOfMotion = ['#plots', '#plot-speeds'];

const visible = async (page, selectors) => {
  const seen = await Promise.all(selectors.map((selector) => page.isVisible(selector)));
  return selectors.filter((_, k) => seen[k]);
};
const colorings = (page) => page.locator('#color-by option').allTextContents();
const keys = async (page) => {
  await page.keyboard.press('?');
  const shown = await page.locator('#help-keys dt').allTextContents();
  await page.keyboard.press('Escape');
  await page.waitForFunction(() => document.activeElement === document.body);
  return shown;
};
const pixelsOf = async (page) => (await browser.pixels(page)).data;

for (const options of [['--dimensions', '2', '--phi', 'max'], ['--phi', 'max'], ['--phi', '0.3']])
  test(`the page of a packing: ${options.join(' ')}`, async () => {
    await withFolder(async (folder) => {
      const file = join(folder, 'packing.html');
      await run('pack', '--count', '80', '--rate', '0.1', ...options, '--quiet', '--replay', file);
      await withSaved(file, (page) => examine(page, options), kWindow);
    });
  });

async function examine(page, options) {
  const hasForces = options.includes('max');
  assert.equal(await page.isVisible('#show-forces'), hasForces);
  const { forces, spheres, colorBy } = await state(page);
  assert.deepEqual(await visible(page, [...kOfTime, ...kOfMotion]), []);
  assert.equal(await page.isVisible('#screenshot'), true);
  assert.deepEqual(await colorings(page), ['Size', 'Species', ...(hasForces ? ['Contacts'] : []), 'Neighbors']);
  assert.equal(await page.inputValue('#color-by'), colorBy);
  const isFlat = options.includes('2');
  assert.deepEqual(await keys(page), [
    ...['← → ↑ ↓', '+ −', ...(isFlat ? [] : ['X Y Z']), 'F', '0', 'G'],
    ...['I', ...(hasForces ? ['L'] : []), 'Esc', '?'],
  ]);
  await follow(page, 0);
  await page.waitForSelector('#sphere', { state: 'visible' });
  const card = ['#sphere-position', '#sphere-contacts', '#sphere-velocity', '#sphere-speed', '#sphere-collisions'];
  assert.deepEqual(
    await visible(page, [...card, '#sphere-next', '#sphere-crossing', '#camera-follows']),
    ['#sphere-position', ...(hasForces ? ['#sphere-contacts'] : [])],
  );
  await follow(page, null);
  await page.waitForSelector('#sphere', { state: 'hidden' });
  assert.equal(spheres, 80);
  if (hasForces) {
    assert.ok(forces > 100, `${forces}`);
    assert.match(await page.textContent('#legend-species'), /held: \d+rattlers: \d+/);
    const small = await coverage(page);
    await page.keyboard.press('l');
    await page.waitForTimeout(500);
    assert.ok((await coverage(page)) > 2 * small, 'spheres are small where lines are shown');
    const bySpecies = await pixelsOf(page);
    await page.selectOption('#color-by', 'contacts');
    await page.waitForTimeout(500);
    assert.ok(!bySpecies.equals(await pixelsOf(page)), 'spheres have other colors');
    const [least, , most] = await page.locator('#legend-numbers span').allTextContents();
    assert.equal(Number(least), 0);
    assert.ok(Number(most) >= (isFlat ? 4 : 6), most);
  } else {
    assert.equal(forces, 0);
  }
}

// A gas at one moment: its spheres move, but no time passes.
const kGas = `
[box]
size = [9.0, 9.0, 9.0]
boundary = ["wall", "wall", "wall"]

[[spheres]]
count = 50
radius = 0.5
placement = "random"
temperature = 1.0
`;

for (const [until, hasTime] of [
  [0, false],
  [0.5, true],
])
  test(`the page of a gas until time ${until}`, async () => {
    await withFolder(async (folder) => {
      const file = join(folder, 'gas.html');
      await run('replay', await writeScenario(folder, kGas), '--until', String(until), '--out', file);
      const show = async (page) => {
        assert.deepEqual(await visible(page, kOfTime), hasTime ? kOfTime : []);
        assert.deepEqual(await visible(page, kOfMotion), kOfMotion);
        const ofTime = hasTime ? ['Collisions', 'Last contact'] : [];
        assert.deepEqual(await colorings(page), ['Speed', 'Size', 'Species', ...ofTime, 'Energy', 'Neighbors']);
        assert.equal((await keys(page)).includes('Space'), hasTime);
        await page.keyboard.press(' ');
        assert.equal((await state(page)).isPlaying, hasTime);
      };
      await withSaved(file, show, kWindow);
    });
  });
