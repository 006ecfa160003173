// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The hashes of all scenarios in a page of Chromium, each in a worker, and the size of what the page loads.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { createServer } from 'node:http';
import { join } from 'node:path';
import test from 'node:test';
import { brotliCompressSync } from 'node:zlib';
import { Browser } from '../viewer/support/browser.mjs';

const package_ = process.env.HARDBALL_PACKAGE;
const scenarios = new URL('../../scenarios/', import.meta.url);
const kMostContacts = 3000; // of tests/golden/scenario_hashes.c

const kTypes = { js: 'text/javascript', wasm: 'application/wasm', html: 'text/html', json: 'application/json' };

// Without an icon a browser would ask for one.
const kPage = '<!doctype html><title>Hardball</title><link rel="icon" href="data:,">';

// The files of the package, as any server of static files has them, without the headers that shared memory needs.
async function serve() {
  const server = createServer(({ url }, response) => {
    const name = url === '/' ? 'page.html' : url.slice(1);
    try {
      const content = name === 'page.html' ? kPage : readFileSync(join(package_, name));
      response.writeHead(200, { 'content-type': kTypes[name.split('.').at(-1)] ?? 'text/plain' }).end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return server;
}

test('every scenario has its native hash in a page', async () => {
  const server = await serve();
  const browser = await Browser.launch();
  try {
    const page = await browser.openPage(`http://127.0.0.1:${server.address().port}/`);
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
  } finally {
    await browser.close();
    server.close();
  }
});

test('the module grows no further', () => {
  const module = readFileSync(join(package_, 'module.wasm'));
  assert.ok(module.length <= 2.05e6, `${module.length} bytes`);
  const compressed = brotliCompressSync(module).length;
  assert.ok(compressed <= 5.8e5, `${compressed} bytes compressed`);
});
