// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// How a browser sets the report of a run, on the screen and on paper.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { withDocument, withOutput } from '../support/pages.mjs';

// A mixture between walls: it has everything that makes labels and formulas long.
const kMixture = `
[box]
size = [10.0, 10.0, 10.0]
boundary = ["periodic", "wall", "periodic"]

[[species]]
name = "helium"

[[species]]
name = "krypton"

[[spheres]]
count = 100
radius = 0.5
species = "helium"
placement = "random"
temperature = 1.0

[[spheres]]
count = 50
radius = 0.8
mass = 4.0
species = "krypton"
placement = "random"
temperature = 1.0

[run]
until = 20.0
seed = 4

[measures]
every = 0.5
`;

function withReport(work, options) {
  return withOutput(kMixture, (out) => withDocument(join(out, 'report.html'), work, options));
}

for (const width of [1280, 390]) {
  test(`no label is clipped in a window of ${width} pixels`, async () => {
    await withReport(
      async (page) => {
        const clipped = await page.evaluate(() =>
          [...document.querySelectorAll('svg.chart text')]
            .filter((text) => {
              const [inner, outer] = [text, text.ownerSVGElement].map((part) => part.getBoundingClientRect());
              return (
                inner.left < outer.left - 0.5 ||
                inner.right > outer.right + 0.5 ||
                inner.top < outer.top - 0.5 ||
                inner.bottom > outer.bottom + 0.5
              );
            })
            .map((text) => text.textContent),
        );
        assert.deepEqual(clipped, []);
        const widths = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
        assert.ok(widths[0] <= widths[1], `${widths}`);
      },
      { width },
    );
  });
}

test('formulas are set, species have their names, and all sections have results', async () => {
  await withReport(async (page) => {
    const heights = await page.evaluate(() =>
      [...document.querySelectorAll('math')].map((math) => [
        math.textContent,
        math.getBoundingClientRect().height,
      ]),
    );
    assert.ok(heights.length > 20);
    for (const [text, height] of heights) assert.ok(height > 5, `${text}: ${height}`);
    // A fraction has its parts above each other.
    const apart = await page.evaluate(() => {
      const [above, below] = document.querySelector('mfrac').children;
      return below.getBoundingClientRect().top - above.getBoundingClientRect().top;
    });
    assert.ok(apart > 5, `${apart}`);
    const names = await page.locator('article th[scope=row]').allTextContents();
    assert.ok(names.some((name) => name.startsWith('collision rate, helium–krypton')));
    assert.deepEqual(
      names.filter((name) => /[a-z] \d/.test(name)),
      [],
    );
    for (const article of await page.locator('article').all()) {
      assert.ok((await article.locator('svg, table').count()) > 0, await article.textContent());
    }
  });
});

test('on paper nothing is split that belongs together', async () => {
  await withReport(async (page) => {
    await page.emulateMedia({ media: 'print' });
    const styles = (selector, property) =>
      page.evaluate(
        ([selector, property]) =>
          [...document.querySelectorAll(selector)].map((element) => getComputedStyle(element)[property]),
        [selector, property],
      );
    for (const selector of ['article', 'figure', 'table', 'tr', '.pair', '.formula', '.note'])
      for (const value of await styles(selector, 'breakInside')) assert.equal(value, 'avoid', selector);
    for (const selector of ['h2', 'h3', '.formula'])
      for (const value of await styles(selector, 'breakAfter')) assert.equal(value, 'avoid', selector);
    // Every article fits a page of A4 or Letter within its margins.
    const longest = await page.evaluate(() => {
      document.body.style.width = '178mm';
      return Math.max(
        ...[...document.querySelectorAll('article')].map((article) => article.getBoundingClientRect().height),
      );
    });
    const millimeter = 96 / 25.4;
    assert.ok(longest < 243 * millimeter, `${longest}`);
  });
});
