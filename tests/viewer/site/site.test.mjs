// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The documentation site in the folder HARDBALL_SITE: nothing is cut at the right edge of a window, wide or narrow; the
// front page, the gallery and the lessons have what they should.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { withDocument } from '../support/pages.mjs';

const kSite = process.env.HARDBALL_SITE;
const kFiles = readdirSync(kSite, { recursive: true });
// Replays and the playground are no documents.
const kPages = kFiles.filter((name) => name.endsWith('.html') && !/^(_|replays|playground)/.test(name));

// What of the page reaches beyond the window, or is cut; and how many blocks of code and of output there are.
function measure() {
  const cut = [];
  const { scrollWidth } = document.documentElement;
  if (scrollWidth > innerWidth + 1) cut.push(`the page is ${scrollWidth} pixels wide`);
  const blocks = [...document.querySelectorAll('pre')];
  for (const block of blocks) {
    const isOutput = block.closest('.highlight-console, .highlight-text') !== null;
    const { overflowX } = getComputedStyle(block);
    const isWhole = block.scrollWidth <= block.clientWidth + 1;
    if (!isWhole && !(isOutput && overflowX === 'auto')) cut.push(block.textContent.slice(0, 60));
  }
  return { cut, blocks: blocks.length };
}

for (const width of [1280, 390])
  test(`no page is cut in a window of ${width} pixels`, async () => {
    assert.ok(kPages.length > 40, `${kPages.length} pages`);
    let blocks = 0;
    for (const name of kPages) {
      const examine = async (page) => {
        const found = await page.evaluate(measure);
        assert.deepEqual(found.cut, [], name);
        blocks += found.blocks;
      };
      await withDocument(join(kSite, name), examine, { width, height: 900 });
    }
    assert.ok(blocks > 100, `${blocks} blocks of code`);
  });

test('the front page has a picture, and leads to installation and tour', async () => {
  const examine = async (page) => {
    const width = await page.evaluate(() => document.querySelector('article img').naturalWidth);
    assert.ok(width >= 600, `${width} pixels`);
    for (const target of ['install.html', 'tour.html'])
      assert.ok((await page.locator(`article a[href="${target}"]`).count()) > 0, target);
  };
  await withDocument(join(kSite, 'index.html'), examine, { width: 1280, height: 900 });
});

test('the gallery has a dozen pictures, each of which leads to a replay', async () => {
  const examine = async (page) => {
    const cards = await page.evaluate(() =>
      [...document.querySelectorAll('.gallery figure')].map((card) => ({
        picture: card.querySelector('img').getAttribute('src'),
        replay: card.querySelector('a').getAttribute('href'),
        text: card.querySelector('figcaption').textContent,
      })),
    );
    assert.ok(cards.length >= 12, `${cards.length} pictures`);
    for (const { picture, replay, text } of cards) {
      assert.ok(existsSync(join(kSite, picture)) && text.includes('hardball replay'), text);
      assert.match(readFileSync(join(kSite, replay), 'utf8').slice(0, 1000), /<title>Hardball/);
    }
  };
  await withDocument(join(kSite, 'gallery.html'), examine, { width: 390, height: 900 });
});

test('lessons hide their answers until they are asked for', async () => {
  const lessons = kPages.filter((name) => /^lessons\/(?!index)/.test(name));
  assert.ok(lessons.length >= 12, `${lessons.length} lessons`);
  const examine = async (page) => {
    const answers = page.locator('article details');
    assert.ok((await answers.count()) >= 3);
    assert.equal(await answers.first().locator('p').first().isVisible(), false);
    await answers.first().locator('summary').click();
    assert.equal(await answers.first().locator('p').first().isVisible(), true);
  };
  await withDocument(join(kSite, lessons[0]), examine, { width: 390, height: 900 });
});
