// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// In pages of Chromium: the hashes of all scenarios, each in a worker, the example with three.js, and the size of what is loaded.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { createServer } from 'node:http';
import { join } from 'node:path';
import test from 'node:test';
import { brotliCompressSync } from 'node:zlib';
import { Browser } from '../viewer/support/browser.mjs';

const package_ = process.env.HARDBALL_PACKAGE;
const packages = process.env.HARDBALL_TEST_PACKAGES;
const scenarios = new URL('../../scenarios/', import.meta.url);
const kMostContacts = 3000; // of tests/golden/scenario_hashes.c

const kTypes = { js: 'text/javascript', wasm: 'application/wasm', html: 'text/html', json: 'application/json' };

// Without an icon a browser would ask for one.
const kPage = '<!doctype html><title>Hardball</title><link rel="icon" href="data:,">';

const kExample = new URL('../../examples/web/', import.meta.url);

function contentOf(url) {
  if (url === '/') return kPage;
  if (url === '/example/') return readFileSync(new URL('index.html', kExample));
  // As npm installs them.
  const [, installed, name, path] = url.match(/^(\/example\/node_modules\/)?(hardball|three)?\/?(.*)/);
  return readFileSync(installed && name === 'three' ? join(packages, 'node_modules/three', path) : join(package_, path));
}

// The files of the package and of the example, as any server of static files has them, without the headers that shared
// memory needs.
async function withBrowser(use) {
  const server = createServer(({ url }, response) => {
    try {
      const type = kTypes[url.split('.').at(-1)] ?? 'text/html';
      response.writeHead(200, { 'content-type': type }).end(contentOf(url));
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const browser = await Browser.launch();
  try {
    await use(browser, `http://127.0.0.1:${server.address().port}/`);
  } finally {
    await browser.close();
    server.close();
  }
}

test('every scenario has its native hash in a page', async () => {
  await withBrowser(async (browser, address) => {
    const page = await browser.openPage(address);
    const files = Object.fromEntries(
      readdirSync(scenarios)
        .filter((name) => /\.(obj|txt|csv)$/.test(name))
        .map((name) => [name, readFileSync(new URL(name, scenarios), 'utf8')]),
    );
    const expected = readFileSync(new URL('../golden/expected_scenarios.txt', import.meta.url), 'utf8');
    const lines = expected.trim().split('\n');
    assert.ok(lines.length > 20);
    for (const line of lines) {
      const [name, hash] = line.split(' ');
      const found = await page.evaluate(
        async ({ name, text, files, contacts }) => {
          const { open } = await import('/index.js');
          const simulation = await open(text, { name, files });
          const status = await simulation.run({ until: simulation.until ?? Infinity, contacts });
          simulation.close();
          return status.hash;
        },
        { name, text: readFileSync(new URL(name, scenarios), 'utf8'), files, contacts: kMostContacts },
      );
      assert.equal(`${name} ${found}`, `${name} ${hash}`);
    }
    assert.deepEqual(page.errors, []);
  });
});

test('the example with three.js draws spheres that move', async () => {
  await withBrowser(async (browser, address) => {
    const page = await browser.openPage(`${address}example/`, { width: 300, height: 200 });
    await page.waitForSelector('canvas');
    // The empty page, and spheres at one time, would be two.
    const pictures = new Set();
    for (let look = 0; look < 100 && pictures.size < 4; ++look) {
      pictures.add((await page.screenshot()).toString('base64'));
      await page.waitForTimeout(200);
    }
    assert.equal(pictures.size, 4);
    assert.deepEqual(page.errors, []);
  });
});

test('the module grows no further', () => {
  const module = readFileSync(join(package_, 'module.wasm'));
  assert.ok(module.length <= 2.25e6, `${module.length} bytes`);
  const compressed = brotliCompressSync(module).length;
  assert.ok(compressed <= 6.4e5, `${compressed} bytes compressed`);
});
