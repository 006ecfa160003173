// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Domains of a live run in several threads: their colors, and the windows of time that they have run.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from 'node:test';
import { middleOf } from '../support/browser.mjs';
import { browser, follow, setTime, state, withSaved, withView } from '../support/pages.mjs';
import { withFolder, writeScenario } from '../support/program.mjs';

// A gas that is cut across x, its longest axis.
const kGas = `
[box]
size = [24.0, 12.0, 12.0]
boundary = ["wall", "periodic", "wall"]

[[spheres]]
count = 400
radius = 0.5
placement = "random"
temperature = 1.0

[run]
until = 2.0
seed = 4
`;

// Shows the finished live run of the gas with these options.
function withGas(words, work) {
  return withFolder(async (folder) => {
    const showFinished = async (page) => {
      await page.waitForFunction(() => window.hardball.state().status.finished);
      await work(page, folder);
    };
    await withView(await writeScenario(folder, kGas), showFinished, { words });
  });
}

const offersDomains = (page) =>
  page.evaluate(() => [...document.getElementById('color-by').options].some(({ value }) => value === 'domain'));

// The colors of the legend: "rgb(…)".
const legend = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('#legend-species .swatch')].map((mark) => getComputedStyle(mark).backgroundColor),
  );

test('each sphere has the color of the domain whose block it is in', async () => {
  await withGas(['--threads', '2'], async (page) => {
    await page.locator('#color-by option[value=domain]').waitFor({ state: 'attached' });
    const { divisions } = (await state(page)).status;
    const cut = divisions[0].blocks[0].high[0];
    assert.ok(cut > 10 && cut < 14, `${cut}`);
    await page.selectOption('#color-by', 'domain');
    for (const time of [0, 1.5]) {
      const domains = await page.evaluate(async (time) => {
        await window.hardball.setTime(time);
        return Promise.all(
          Array.from({ length: 400 }, async (_, id) => [(await window.hardball.position(id))[0], window.hardball.domain(id)]),
        );
      }, time);
      for (const [x, domain] of domains) assert.equal(domain, x <= cut ? 0 : 1);
      const counts = [0, 1].map((k) => domains.filter(([, domain]) => domain === k).length);
      const isNamed = ([first, second]) =>
        document.getElementById('legend-species').textContent === `domain 0: ${first}domain 1: ${second}`;
      await page.waitForFunction(isNamed, counts);
    }
    // As drawn: blue on one side, orange on the other, the eye looking along z.
    await page.uncheck('#show-events');
    await page.keyboard.press('z');
    await setTime(page, 1);
    const colors = await legend(page);
    assert.deepEqual(colors, ['rgb(0, 114, 178)', 'rgb(230, 159, 0)']);
    const picture = await browser.pixels(page);
    const box = await page.locator('#canvas').boundingBox();
    const blue = middleOf(picture, box, (red, green, blue) => blue > 1.6 * red && blue > 90);
    const orange = middleOf(picture, box, (red, green, blue) => red > 1.6 * blue && red > 90);
    assert.ok(blue.count > 5000 && orange.count > 5000, `${blue.count} and ${orange.count}`);
    const [left, right] = await page.evaluate(() => [6, 18].map((x) => window.hardball.screenPlace([x, 6, 6]).x));
    assert.ok(Math.abs(blue.x - left) < 0.2 * Math.abs(right - left), `${blue.x} and ${left}`);
    assert.ok(Math.abs(orange.x - right) < 0.2 * Math.abs(right - left), `${orange.x} and ${right}`);
    // The card names the domain, too.
    await follow(page, 7);
    const domain = await page.evaluate(() => String(window.hardball.domain(7)));
    await page.waitForFunction((domain) => document.getElementById('sphere-domain').textContent === domain, domain);
  });
});

test('sixteen domains differ in color, and windows that failed are counted', async () => {
  const isDilute = ['--set', 'box.size=[200, 100, 100]', '--until', '30'];
  await withGas(['--threads', '16', ...isDilute], async (page) => {
    await page.locator('#color-by option[value=domain]').waitFor({ state: 'attached' });
    await page.selectOption('#color-by', 'domain');
    const { windows, divisions } = (await state(page)).status;
    assert.equal(divisions.at(-1).blocks.length, 16);
    const colors = await legend(page);
    assert.equal(new Set(colors).size, 16, `${colors}`);
    // Spheres fly past blocks in a window.
    assert.ok(windows.failed > 0);
    const { committed, failed, steps } = windows;
    const counts = [committed - steps, failed, steps].map((count) => count.toLocaleString('en-US'));
    await page.waitForFunction(
      ([committed, failed, steps]) =>
        document.getElementById('legend-windows').textContent.replace(/s$/, '') ===
        `${committed} committed${failed} failed${steps} single step`,
      counts,
    );
    const widths = await page.evaluate(() =>
      [...document.getElementById('windows-bar').children].map((part) => part.getBoundingClientRect().width),
    );
    const share = failed / (committed + failed);
    assert.ok(Math.abs(widths[1] / (widths[0] + widths[1] + widths[2]) - share) < 0.01, `${widths} and ${share}`);
  });
});

test('with one thread there are no domains, and in a saved replay none either', async () => {
  await withGas([], async (page) => {
    assert.ok(!(await offersDomains(page)));
    assert.ok(await page.locator('#windows').isHidden());
  });
  await withGas(['--threads', '2'], async (page, folder) => {
    assert.ok(await page.locator('#windows').isVisible());
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save')]);
    const saved = join(folder, 'saved.html');
    await download.saveAs(saved);
    assert.ok((await readFile(saved)).length > 100_000);
    await withSaved(saved, async (replay) => {
      assert.ok(!(await offersDomains(replay)));
      assert.ok(await replay.locator('#windows').isHidden());
    });
  });
});
