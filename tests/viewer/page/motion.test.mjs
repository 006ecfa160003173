// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Slices, velocities, trails, and the plots of pairs and displacements.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { recordLoneSpheres } from '../support/lone_spheres.mjs';
import { browser, setTime, state, withRecording } from '../support/pages.mjs';
import { randomSpheres, recordSmallGas } from '../support/small_gas.mjs';

const kWindow = { width: 1000, height: 700 };

const kGas = recordSmallGas({
  ...randomSpheres(27, 8),
  box: { size: [8, 8, 8], boundary: ['wall', 'periodic', 'wall'] },
  until: 3,
  contactsOfChunk: 200,
});

const kTwo = recordLoneSpheres({
  box: { size: [10, 10, 10], boundary: ['wall', 'wall', 'wall'] },
  radii: [0.5, 0.5],
  positions: [
    [2, 5, 5],
    [7, 5, 5],
  ],
  velocities: [
    [0.5, 0, 0],
    [0, 1, 0],
  ],
  until: 8,
});

// Whether a sphere is drawn where the page says that it is: the color there differs from that of the background.
async function isDrawn(page, id) {
  const { x, y } = await page.evaluate((id) => window.hardball.screenPosition(id), id);
  const { width, data } = await browser.pixels(page);
  const place = 4 * (Math.round(y) * width + Math.round(x));
  return Math.max(...[0, 1, 2].map((part) => Math.abs(data[place + part] - [244, 245, 247][part]))) > 40;
}

test('a slice hides what is outside, which cannot be clicked then, and is in links', async () => {
  await withRecording(
    kTwo,
    async (page) => {
      await setTime(page, 1);
      assert.deepEqual([await isDrawn(page, 0), await isDrawn(page, 1)], [true, true]);
      await page.selectOption('#slice-axis', 'x');
      // The middle fifth of the box.
      assert.equal(await page.textContent('#slice-text'), 'x from 4.000 to 6.000 L');
      await setTime(page, 1);
      assert.deepEqual([await isDrawn(page, 0), await isDrawn(page, 1)], [false, false]);
      await page.locator('#slice-middle').fill('250');
      await setTime(page, 1);
      assert.deepEqual([await isDrawn(page, 0), await isDrawn(page, 1)], [true, false]);
      const click = async (id) => {
        const { x, y } = await page.evaluate((id) => window.hardball.screenPosition(id), id);
        await page.mouse.click(x, y);
        return (await state(page)).followed;
      };
      assert.equal(await click(1), null);
      assert.equal(await click(0), 0);
      assert.match(await page.evaluate(() => window.hardball.link()), /slice=x,1\.5,3\.5/);
      await page.evaluate(() => window.hardball.show('t=1&slice=x,6,8'));
      assert.deepEqual([await isDrawn(page, 0), await isDrawn(page, 1)], [false, true]);
      assert.equal(await page.inputValue('#slice-middle'), '700');
      await page.selectOption('#slice-axis', '');
      assert.ok(await page.locator('#slice-ends').isHidden());
      await setTime(page, 1);
      assert.deepEqual([await isDrawn(page, 0), await isDrawn(page, 1)], [true, true]);
    },
    kWindow,
  );
});

test('velocities and trails of all spheres', async () => {
  await withRecording(
    kGas,
    async (page) => {
      await setTime(page, 2);
      const bare = await page.locator('#canvas').screenshot();
      await page.check('#show-arrows');
      await setTime(page, 2);
      // A shaft and a head of each.
      assert.equal((await state(page)).arrows, 54);
      const arrows = await page.locator('#canvas').screenshot();
      assert.ok(!arrows.equals(bare));
      await page.uncheck('#show-arrows');
      await page.check('#show-trails');
      await setTime(page, 2);
      const { trails } = await state(page);
      assert.ok(trails > 27, `${trails}`);
      assert.ok(!(await page.locator('#canvas').screenshot()).equals(bare));
      assert.match(await page.textContent('#motion-text'), /^An arrow is the way in [\d.]+ T, a trail that of the last [\d.]+ T\.$/);
      // At the start nothing has moved yet.
      await setTime(page, 0);
      assert.equal((await state(page)).trails, 0);
      await page.uncheck('#show-trails');
      await setTime(page, 2);
      assert.ok((await page.locator('#canvas').screenshot()).equals(bare));
    },
    kWindow,
  );
});

test('colors by energy and by neighbors follow the time', async () => {
  await withRecording(
    kGas,
    async (page) => {
      const pictures = new Set();
      for (const name of ['energy', 'neighbors'])
        for (const time of [1, 3]) {
          await page.selectOption('#color-by', name);
          await setTime(page, time);
          await page.waitForTimeout(700);
          pictures.add((await page.locator('#canvas').screenshot()).toString('base64'));
          const ends = await page.locator('#legend-numbers span').allTextContents();
          if (name === 'energy') assert.match(ends[2], /^[\d.]+ M L² T⁻²$/);
          else assert.ok(Number.isInteger(Number(ends[2])) && Number(ends[2]) >= 1, ends[2]);
        }
      assert.equal(pictures.size, 4);
    },
    kWindow,
  );
});

test('the plots show pairs and displacements', async () => {
  await withRecording(
    kGas,
    async (page) => {
      await setTime(page, 3);
      await page.waitForFunction(() => document.querySelectorAll('#plot-pairs canvas, #plot-displacement canvas').length === 2);
      const inked = (id) =>
        page.waitForFunction((id) => {
          const canvas = document.querySelector(`#${id} canvas`);
          const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
          let count = 0;
          // The color of lines: --accent.
          for (let k = 0; k < data.length; k += 4) if (data[k] < 40 && data[k + 2] > 150 && data[k + 3] > 200) ++count;
          return count > 60;
        }, id);
      await inked('plot-displacement');
      await inked('plot-pairs');
    },
    kWindow,
  );
});
