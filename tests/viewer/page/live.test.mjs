// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The front end of the live view in notebooks, with a stand-in for the notebook's model.
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { browser } from '../support/pages.mjs';
import { run, withFolder, writeScenario } from '../support/program.mjs';

const kFrontEnd = new URL('../../../python/hardball/live_view.js', import.meta.url);
const kScenario = `
[box]
size = [6.0, 6.0, 6.0]
boundary = ["periodic", "periodic", "periodic"]
[[spheres]]
count = 40
radius = 0.5
placement = "random"
temperature = 1.0
[run]
until = 120.0
seed = 2
[measures]
names = []
[output]
recording = true
`;

// What the kernel sends: of a recording the header, the spheres and the chunks.
async function messagesOf(folder) {
  const recording = await readFile(join(folder, 'out', 'recording.hbr'));
  const length = recording.readUInt32LE(8);
  const header = JSON.parse(recording.subarray(12, 12 + length).toString());
  const spheresAt = 12 + length;
  let at = spheresAt + 16 * header.spheres;
  const spheres = recording.subarray(spheresAt, at).toString('base64');
  at += 8;
  const chunks = [];
  while (at < recording.length) {
    const size = Number(recording.readBigUInt64LE(at + 8));
    chunks.push({ end: recording.readDoubleLE(at + 24), bytes: recording.subarray(at, at + size).toString('base64') });
    at += size;
  }
  await run('replay', join(folder, 'out'), '--out', join(folder, 'replay.html'));
  const replay = await readFile(join(folder, 'replay.html'), 'utf8');
  // Without the recording, as the kernel has it.
  const viewer = replay.replace(/(id="recording">)[^<]*/, '$1');
  return { header, spheres, chunks, viewer };
}

// In the page: a model whose messages are kept in `window.model.asked`, and a function that has the front end hear some.
async function begin(page, frontEnd) {
  await page.evaluate(async (source) => {
    const { default: widget } = await import(URL.createObjectURL(new Blob([source], { type: 'text/javascript' })));
    const bytes = (text) => new DataView(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer);
    const listeners = new Set();
    window.model = {
      asked: [],
      on: (name, listener) => name === 'msg:custom' && listeners.add(listener),
      off: (name, listener) => listeners.delete(listener),
      send: (message) => window.model.asked.push(message),
    };
    window.hear = (message, ...buffers) => {
      for (const listener of listeners) listener(message, buffers.map(bytes));
    };
    window.end = widget.render({ model: window.model, el: document.body });
  }, frontEnd);
}

const status = (reached, finished = false) => ({
  finished, failed: null, damaged: null, reached, collisions: 5, mergers: 0, walls: 0, event_log_hash: 'abc',
});

test('the live view shows what the kernel has sent, and asks for what it has missed', async () => {
  await withFolder(async (folder) => {
    await run('run', await writeScenario(folder, kScenario), '--out', join(folder, 'out'), '--quiet');
    const { header, spheres, chunks, viewer } = await messagesOf(folder);
    assert.ok(chunks.length >= 3, `${chunks.length} chunks`);
    await writeFile(join(folder, 'empty.html'), '<!doctype html><title>Notebook</title><body></body>');
    const page = await browser.openPage(pathToFileURL(join(folder, 'empty.html')).href);
    await begin(page, await readFile(kFrontEnd, 'utf8'));
    const asked = () => page.evaluate(() => window.model.asked);
    assert.deepEqual(await asked(), [{ what: 'ready', from: 0, is_open: false }]);
    const hear = (...parts) => page.evaluate((all) => window.hear(...all), parts);
    const chunk = (number) => hear({ what: 'chunk', number, end: chunks[number].end }, chunks[number].bytes);

    await hear({ what: 'open', header, status: status(0) }, Buffer.from(viewer).toString('base64'), spheres);
    await chunk(0);
    await hear({ what: 'status', status: status(chunks[0].end) });
    await page.waitForFunction(() => frames[0]?.hardball?.state().isReady);
    await page.waitForFunction((end) => frames[0].hardball.state().knownEnd === end, chunks[0].end);

    // The second chunk is lost on the way.
    await chunk(2);
    assert.deepEqual((await asked()).at(-1), { what: 'ready', from: 1, is_open: true });
    await chunk(1);
    await chunk(2);
    await hear({ what: 'status', status: status(chunks[2].end, true) });
    await page.waitForFunction((end) => frames[0].hardball.state().knownEnd === end, chunks[2].end);
    const shown = await page.evaluate(async () => {
      await frames[0].hardball.setTime(1);
      return frames[0].hardball.position(7);
    });
    // As the page with the whole recording shows it.
    const replay = await browser.open(pathToFileURL(join(folder, 'replay.html')).href);
    const expected = await replay.evaluate(async () => {
      await window.hardball.setTime(1);
      return window.hardball.position(7);
    });
    assert.deepEqual(shown, expected);
    assert.deepEqual(page.errors, []);
    await page.evaluate(() => window.end());
    assert.equal(await page.locator('iframe').count(), 0);
    await page.context().close();
    await replay.context().close();
  });
});
