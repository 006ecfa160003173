// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The page for all: axe-core, keyboard, touch, reduced motion; and a scale of colors that stays.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';
import { follow, setTime, withRecording, withSaved } from '../support/pages.mjs';
import { run, withFolder } from '../support/program.mjs';
import { randomSpheres, recordSmallGas } from '../support/small_gas.mjs';

const packages = process.env.HARDBALL_TEST_PACKAGES;
const { resolve } = createRequire(packages ? join(packages, 'package.json') : import.meta.url);
const axe = await readFile(resolve('axe-core'), 'utf8');

const kGas = recordSmallGas({
  ...randomSpheres(27, 8),
  box: { size: [8, 8, 8], boundary: ['wall', 'periodic', 'wall'] },
  until: 4,
  contactsOfChunk: 20,
  cellEdge: 2,
});

const kPhone = { width: 390, height: 844, pixelRatio: 2 };
const kWindow = { width: 1300, height: 760 };

// What axe-core objects to by the rules of WCAG 2.2 AA and best practice.
async function violations(page) {
  // The page's policy lets no script run that is not its own; this one is not in the document.
  await page.evaluate(axe);
  const found = await page.evaluate(() => window.axe.run(document, { resultTypes: ['violations'] }));
  return found.violations.flatMap(({ id, nodes }) =>
    nodes.map(({ target, failureSummary }) => `${id} ${target}: ${failureSummary.split('\n').slice(1).join(' ').trim()}`),
  );
}

async function isForAll(page) {
  assert.deepEqual(await violations(page), []);
  await page.click('#help-button');
  assert.deepEqual(await violations(page), [], 'with the help');
  await page.click('#help-close');
  await page.click('#screenshot');
  await page.waitForTimeout(300);
  assert.deepEqual(await violations(page), [], 'with pictures and films');
  await page.click('#shooting-close');
}

for (const [name, options] of [
  ['light', kWindow],
  ['dark', { ...kWindow, scheme: 'dark' }],
  ['on a phone', kPhone],
  ['on a phone, dark', { ...kPhone, scheme: 'dark' }],
])
  test(`axe-core finds nothing: ${name}`, async () => {
    await withRecording(
      kGas,
      async (page) => {
        await setTime(page, 1);
        await follow(page, 3);
        await page.check('#show-cells');
        await page.selectOption('#color-by', 'collisions');
        await page.waitForSelector('#sphere', { state: 'visible' });
        await isForAll(page);
      },
      options,
    );
  });

test('axe-core would find too little contrast, and a control without a name', async () => {
  await withRecording(
    kGas,
    async (page) => {
      await page.evaluate(() => {
        document.getElementById('name').style.color = '#aaaaaa';
        document.getElementById('help-button').removeAttribute('aria-label');
        document.getElementById('help-button').removeAttribute('title');
        document.getElementById('help-button').textContent = '';
      });
      const rules = new Set((await violations(page)).map((text) => text.split(' ')[0]));
      assert.deepEqual([...rules].sort(), ['button-name', 'color-contrast']);
    },
    kWindow,
  );
});

test('axe-core finds nothing in a replay and in a packing', async () => {
  await withFolder(async (folder) => {
    const [replay, packing] = [join(folder, 'replay.html'), join(folder, 'packing.html')];
    await run('pack', '--count', '40', '--rate', '0.1', '--phi', 'max', '--quiet', '--replay', packing);
    await withSaved(packing, isForAll, { ...kWindow, scheme: 'dark' });
    await run('pack', '--count', '40', '--dimensions', '2', '--phi', '0.3', '--quiet', '--replay', replay);
    await withSaved(replay, isForAll, kPhone);
  });
});

test('all controls of the page are reached by keyboard, in order, and seen', async () => {
  await withRecording(
    kGas,
    async (page) => {
      const reached = [];
      for (let k = 0; k < 80; ++k) {
        await page.keyboard.press('Tab');
        const id = await page.evaluate(() => document.activeElement.id);
        if (id === '' || id === reached[0]) break;
        const outline = await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
        assert.notEqual(outline, 'none', id);
        reached.push(id);
      }
      const offered = await page.evaluate(() =>
        [...document.querySelectorAll('button, a[href], input, select, canvas[tabindex]')]
          .filter((control) => control.getClientRects().length > 0 && !control.disabled)
          .map(({ id }) => id),
      );
      assert.deepEqual(reached, offered);
    },
    kWindow,
  );
});

test('a fixed scale of colors stays, and is in links', async () => {
  await withRecording(
    kGas,
    async (page) => {
      await page.selectOption('#color-by', 'speed');
      assert.ok(await page.locator('#scale-left').isHidden());
      await page.check('#fix-scale');
      await page.fill('#scale-left', '0.5');
      await page.fill('#scale-right', '2.5');
      await page.keyboard.press('Enter');
      const ends = () => page.locator('#legend-numbers span').allTextContents();
      assert.deepEqual(await ends(), ['0.500 L T⁻¹', '1.50 L T⁻¹', '2.50 L T⁻¹']);
      await setTime(page, 3);
      await page.waitForTimeout(700);
      assert.equal((await ends())[2], '2.50 L T⁻¹');
      assert.match(await page.evaluate(() => window.hardball.link()), /range=0\.5,2\.5/);
      // Other colors have other units.
      await page.selectOption('#color-by', 'size');
      assert.ok(!(await page.isChecked('#fix-scale')));
      await page.evaluate(() => window.hardball.show('color=collisions&range=2,7'));
      assert.deepEqual(await ends(), ['2.00', '4.50', '7.00']);
      await page.uncheck('#fix-scale');
      assert.equal((await ends())[0], '0');
      await page.selectOption('#color-by', 'species');
      assert.ok(await page.locator('#scale-row').isHidden());
    },
    kWindow,
  );
});

test('with reduced motion the camera stops at once, and nothing flashes unless asked for', async () => {
  const angle = (page) => page.evaluate(() => window.hardball.screenPlace([8, 8, 8]));
  for (const reducedMotion of ['reduce', 'no-preference'])
    await withRecording(
      kGas,
      async (page) => {
        assert.equal(await page.isChecked('#show-events'), reducedMotion !== 'reduce');
        const { x, y, width, height } = await page.locator('#canvas').boundingBox();
        await page.mouse.move(x + width / 2, y + height / 2);
        await page.mouse.down();
        await page.mouse.move(x + width / 2 + 60, y + height / 2);
        await page.mouse.up();
        await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
        const before = await angle(page);
        await page.waitForTimeout(1500);
        const after = await angle(page);
        assert.equal(Math.hypot(before.x - after.x, before.y - after.y) > 0.5, reducedMotion !== 'reduce');
      },
      { ...kWindow, reducedMotion },
    );
});

test('on a touch screen the help begins with what fingers do', async () => {
  await withRecording(
    kGas,
    async (page) => {
      assert.ok(await page.isVisible('#touches'));
      assert.ok(await page.locator('#keys').isHidden());
      await page.click('#help-button');
      const top = async (id) => (await page.locator(id).boundingBox()).y;
      assert.ok((await top('#help-touch')) < (await top('#help-keys')));
      assert.ok(await page.locator('#help-mouse').isHidden());
    },
    { ...kPhone, hasTouch: true },
  );
  await withRecording(kGas, async (page) => assert.ok(await page.locator('#touches').isHidden()), kWindow);
});
