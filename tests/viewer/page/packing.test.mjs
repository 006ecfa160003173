// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The page that pack writes: spheres at rest, and the forces that hold them.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { Browser } from '../support/browser.mjs';
import { run, withFolder } from '../support/program.mjs';

let browser;

before(async () => {
  browser = await Browser.launch();
});

after(() => browser?.close());

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

for (const options of [['--dimensions', '2', '--phi', 'max'], ['--phi', 'max'], ['--phi', '0.3']])
  test(`the page of a packing: ${options.join(' ')}`, async () => {
    await withFolder(async (folder) => {
      const file = join(folder, 'packing.html');
      await run('pack', '--count', '80', '--rate', '0.1', ...options, '--quiet', '--replay', file);
      const page = await browser.open(pathToFileURL(file).href, { width: 1200, height: 800 });
      const hasForces = options.includes('max');
      assert.equal(await page.isVisible('#show-forces'), hasForces);
      const { forces, spheres } = await page.evaluate(() => window.hardball.state());
      assert.equal(spheres, 80);
      if (hasForces) {
        assert.ok(forces > 100, `${forces}`);
        assert.match(await page.textContent('#legend-species'), /held: \d+rattlers: \d+/);
        const small = await coverage(page);
        await page.keyboard.press('l');
        await page.waitForTimeout(500);
        assert.ok((await coverage(page)) > 2 * small, 'spheres are small where lines are shown');
      } else {
        assert.equal(forces, 0);
      }
      assert.deepEqual(page.errors, []);
      await page.context().close();
    });
  });
