// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Links: a page opened with the address of another shows the same to the pixel.
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from 'node:test';
import { recordLoneSpheres } from '../support/lone_spheres.mjs';
import { browser, setTime, state, withDocument, withRecording } from '../support/pages.mjs';
import { run, withFolder } from '../support/program.mjs';
import { randomSpheres, recordSmallGas } from '../support/small_gas.mjs';

const kWindow = { width: 900, height: 600 };

const kGas = recordSmallGas({
  ...randomSpheres(27, 8),
  box: { size: [8, 8, 8], boundary: ['wall', 'periodic', 'wall'] },
  until: 6,
  contactsOfChunk: 20,
  cellEdge: 2,
});

const kOpen = recordLoneSpheres({
  box: { size: [0, 0, 0], boundary: ['open', 'open', 'open'] },
  radii: [0.5, 1],
  positions: [
    [-2, 0, 0],
    [3, 1, -1],
  ],
  velocities: [
    [-1, 0.5, 0.25],
    [1.5, 1, 0.5],
  ],
  until: 8,
});

const kDiscs = recordSmallGas({
  ...randomSpheres(27, 9),
  box: { size: [9, 9, 9], boundary: ['wall', 'wall', 'wall'] },
  until: 2,
  contactsOfChunk: 50,
});

const written = (page) =>
  page.waitForFunction(() => decodeURIComponent(location.hash) === decodeURIComponent(`#${window.hardball.link()}`));

// The camera has come to rest, and where is in the address.
async function atRest(page) {
  for (let before = null; before !== page.url();) {
    before = page.url();
    await page.waitForTimeout(1500);
  }
  await written(page);
}

// What is shown of the spheres, with the card of the followed one.
async function picture(page) {
  await page.waitForTimeout(1200);
  await page.evaluate(() => {
    document.getElementById('notices').style.visibility = 'hidden';
    document.activeElement.blur();
  });
  return page.locator('main').screenshot();
}

async function isSame(page, address = page.url()) {
  const other = await browser.open(address, kWindow);
  try {
    await written(other);
    await other.waitForFunction((time) => window.hardball.time === time, (await state(page)).time);
    const [one, two] = [await picture(page), await picture(other)];
    assert.equal(await other.evaluate(() => window.hardball.link()), await page.evaluate(() => window.hardball.link()));
    assert.deepEqual(other.errors, []);
    return one.equals(two);
  } finally {
    await other.context().close();
  }
}

test('a copied link shows time, camera, colors, layers, and the followed sphere to the pixel', async () => {
  await withRecording(
    kGas,
    async (page) => {
      await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
      await setTime(page, 4.0625 + 1 / 3);
      await page.locator('#canvas').focus();
      for (const key of ['ArrowRight', 'ArrowRight', 'ArrowUp', '+', '+', 'w']) await page.keyboard.press(key);
      await page.selectOption('#color-by', 'collisions');
      await page.fill('#follow-id', '5');
      await page.locator('#follow-id').press('Enter');
      await page.check('#show-cells');
      await page.fill('#cell-edge', '1.7');
      await page.locator('#cell-edge').press('Enter');
      await page.locator('#slow').click();
      await written(page);
      await page.click('#copy-link');
      await page.waitForFunction(() => document.getElementById('notices').textContent.includes('Link copied'));
      const link = await page.evaluate(() => navigator.clipboard.readText());
      assert.equal(link, page.url());
      const text = new URL(link).hash;
      for (const item of ['t=4.3958', 'cam=', 'color=collisions', 'sel=5', 'edge=1.7', 'speed=', 'show='])
        assert.ok(text.includes(item), `${item} in ${text}`);
      assert.ok(await isSame(page, link));
    },
    kWindow,
  );
});

test('a link shows the same after playing, dragging and steps back', async () => {
  await withRecording(
    kGas,
    async (page) => {
      await page.keyboard.press(' ');
      await page.waitForFunction(() => window.hardball.time > 1.5);
      await page.keyboard.press(' ');
      const { x, y, width, height } = await page.locator('#canvas').boundingBox();
      await page.mouse.move(x + width / 2, y + height / 2);
      await page.mouse.down();
      await page.mouse.move(x + width / 2 + 90, y + height / 2 - 40, { steps: 4 });
      await page.mouse.up();
      for (const key of ['n', 'n', 'p']) await page.keyboard.press(key);
      await atRest(page);
      assert.ok(await isSame(page));
    },
    kWindow,
  );
});

test('in open space a link shows the same extent', async () => {
  await withRecording(
    kOpen,
    async (page) => {
      await setTime(page, 6);
      await page.keyboard.press('f');
      await setTime(page, 2);
      await written(page);
      assert.match(page.url(), /seen=/);
      assert.ok(await isSame(page));
    },
    kWindow,
  );
});

test('at the start an address says nothing, and what it does not understand it ignores', async () => {
  await withRecording(
    kDiscs,
    async (page, program) => {
      await page.waitForTimeout(1200);
      // Tests draw in full quality.
      assert.equal(new URL(page.url()).hash, '#q=full');
      const strange = '#t=x&cam=1,2,3&color=smell&sel=-4&speed=-1&q=best&edge=&seen=1&show=fog&play=maybe&else=1';
      const other = await browser.open(program.url + strange, kWindow);
      await written(other);
      assert.deepEqual(other.errors, []);
      assert.equal((await state(other)).time, 0);
      assert.equal((await state(other)).colorBy, (await state(page)).colorBy);
      await other.context().close();
      // An address that changes while the page is open.
      await page.evaluate(() => (location.hash = 't=0.75&sel=3'));
      await page.waitForFunction(() => window.hardball.time === 0.75 && window.hardball.state().followed === 3);
    },
    kWindow,
  );
});

test('a page inside of another one has no address, and exchanges its state with it', async () => {
  await withFolder(async (folder) => {
    await writeFile(join(folder, 'recording.hbr'), Buffer.from(kDiscs));
    await run('replay', folder, '--out', join(folder, 'replay.html'), '--quiet');
    const text = await readFile(join(folder, 'replay.html'), 'utf8');
    const quoted = text.replaceAll('&', '&amp;').replaceAll('"', '&quot;');
    const outside = join(folder, 'outside.html');
    await writeFile(
      outside,
      `<script>addEventListener('message', ({ data }) => (window.said = data));</script>
       <iframe width="800" height="600" srcdoc="${quoted}"></iframe>`,
    );
    await withDocument(outside, async (page) => {
      await page.waitForFunction(() => window.frames[0]?.hardball?.state().isReady);
      const [, inside] = page.frames();
      assert.ok(await inside.locator('#copy-link').isHidden());
      const state = 't=1.25&sel=4&color=size';
      await page.evaluate((state) => window.frames[0].postMessage({ hardball: 'show', state }, '*'), state);
      await inside.waitForFunction(() => window.hardball.time === 1.25);
      await page.waitForFunction(() => window.said?.state === window.frames[0].hardball.link());
      assert.deepEqual(await page.evaluate(() => window.said), { hardball: 'state', state: 't=1.25&sel=4&color=size' });
      // Only who contains it is listened to.
      await inside.evaluate(() => window.postMessage({ hardball: 'show', state: 't=0.5' }, '*'));
      await page.waitForTimeout(300);
      assert.equal(await inside.evaluate(() => window.hardball.time), 1.25);
    });
  });
});
