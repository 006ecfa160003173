// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Pictures of any size, films of the page, and those of the program, which are decoded.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { readdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from 'node:test';
import { decodeFilm, different } from '../support/film.mjs';
import { setTime, state, withRecording } from '../support/pages.mjs';
import { withFolder } from '../support/program.mjs';
import { randomSpheres, recordSmallGas } from '../support/small_gas.mjs';

const kGas = recordSmallGas({
  ...randomSpheres(27, 8),
  box: { size: [8, 8, 8], boundary: ['wall', 'periodic', 'wall'] },
  until: 2,
  contactsOfChunk: 20,
});

const kWindow = { width: 700, height: 500 };

// The size of a picture in a PNG.
const sizeOf = (picture) => [picture.readUInt32BE(16), picture.readUInt32BE(20)];

async function save(page, button) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(button)]);
  return [await download.path(), download.suggestedFilename()];
}

test('a picture has the size asked for, and the page is as before', async () => {
  await withRecording(
    kGas,
    async (page) => {
      await setTime(page, 1.5);
      const before = [await page.evaluate(() => window.hardball.link()), await page.locator('#canvas').screenshot()];
      await page.click('#screenshot');
      assert.ok(await page.isVisible('#film'));
      await page.fill('#picture-width', '1001');
      await page.fill('#picture-height', '333');
      const [file, name] = await save(page, '#save-picture');
      assert.equal(name, 'hardball_1.50000.png');
      assert.deepEqual(sizeOf(await readFile(file)), [1001, 333]);
      await page.waitForSelector('#shooting', { state: 'hidden' });
      assert.equal(await page.evaluate(() => window.hardball.link()), before[0]);
      await page.waitForTimeout(500);
      assert.ok(before[1].equals(await page.locator('#canvas').screenshot()));
    },
    kWindow,
  );
});

test('the film of the page has every frame, and may be ended early', async () => {
  await withFolder(async (folder) =>
    withRecording(
      kGas,
      async (page) => {
        await page.click('#screenshot');
        await page.fill('#picture-width', '201');
        await page.fill('#picture-height', '150');
        await page.fill('#film-from', '0.5');
        await page.fill('#film-to', '1.4');
        await page.fill('#film-speed', '1');
        await page.fill('#film-fps', '10');
        assert.equal(await page.textContent('#film-length'), '10 frames, 1.0 s');
        await page.waitForFunction(() => document.getElementById('film-format').options.length > 0);
        await page.selectOption('#film-format', 'webm');
        const [file, name] = await save(page, '#save-film');
        assert.equal(name, 'hardball.webm');
        const film = await decodeFilm(file, folder);
        assert.deepEqual([film.codec, film.width, film.height], ['vp9', 200, 150]);
        assert.equal(film.frames.length, 10);
        assert.equal(different(film), 10);
        film.frames.forEach(({ time }, k) => assert.ok(Math.abs(time - k / 10) < 1e-3, `${time}`));
        assert.equal((await state(page)).time, 0);
        // The whole run, slowly, is too long to be waited for.
        await page.fill('#film-speed', '0.0001');
        const saving = page.waitForEvent('download');
        await page.click('#save-film');
        await page.waitForFunction(() => /^[2-9] of/.test(document.getElementById('shooting-text').textContent));
        assert.equal(await page.textContent('#save-film'), 'End it here');
        await page.click('#save-film');
        const short = await decodeFilm(await (await saving).path(), folder);
        assert.ok(short.frames.length >= 2 && short.frames.length < 1000);
      },
      kWindow,
    ),
  );
});

// How the program ends: {code, output, messages}.
async function outcome(words, environment = {}) {
  const started = spawn(process.env.HARDBALL_PROGRAM, words, { env: { ...process.env, ...environment } });
  let [output, messages] = ['', ''];
  started.stdout.on('data', (part) => (output += part));
  started.stderr.on('data', (part) => (messages += part));
  const [code] = await once(started, 'close');
  return { code, output, messages };
}

const kBrowser = { HARDBALL_BROWSER: process.env.HARDBALL_CHROMIUM ?? '/usr/bin/chromium' };

for (const [extension, codec] of [
  ['webm', 'vp9'],
  ['mp4', 'avc'],
])
  test(`hardball film writes every frame once: ${extension}`, async () => {
    await withFolder(async (folder) => {
      await writeFile(join(folder, 'recording.hbr'), Buffer.from(kGas));
      const [out, frames] = [join(folder, `out.${extension}`), join(folder, 'frames')];
      const view = 'http://127.0.0.1:1/?token=none#color=size&sel=3';
      const words = ['--from', '0.25', '--to', '1', '--speed', '2', '--fps', '16', '--size', '160x120'];
      const pictures = ['--frames', frames, '--spin', '360', '--view', view];
      const { code, output, messages } = await outcome(['film', out, folder, ...words, ...pictures], kBrowser);
      assert.deepEqual([code, messages], [0, '']);
      assert.match(output, /^wrote .*out\.(webm|mp4), .* kB, 7 frames of 160 by 120\nwrote 7 pictures in .*frames\n$/);
      const film = await decodeFilm(out, folder);
      assert.deepEqual([film.codec, film.width, film.height], [codec, 160, 120]);
      assert.equal(film.frames.length, 7);
      assert.equal(different(film), 7);
      film.frames.forEach(({ time }, k) => assert.ok(Math.abs(time - k / 16) < 2e-3, `${time}`));
      const names = (await readdir(frames)).sort();
      assert.deepEqual([names[0], names.length], ['frame_000000.png', 7]);
      const all = await Promise.all(names.map((name) => readFile(join(frames, name))));
      for (const picture of all) assert.deepEqual(sizeOf(picture), [160, 120]);
      assert.equal(new Set(all.map((picture) => picture.toString('base64'))).size, 7);
      const again = await outcome(['film', out, folder], kBrowser);
      assert.equal(again.code, 2);
      assert.match(again.messages, /exists already/);
    });
  });

test('hardball film says what is wrong with its options, and what is missing', async () => {
  await withFolder(async (folder) => {
    await writeFile(join(folder, 'recording.hbr'), Buffer.from(kGas));
    const fails = async (what, words, environment = kBrowser) => {
      const { code, messages } = await outcome(['film', ...words], environment);
      assert.equal(code, 2, messages);
      assert.match(messages, what);
      assert.equal(messages.trim().split('\n').length, 1);
    };
    const out = join(folder, 'out.webm');
    await fails(/out\.gif: the extension/, [join(folder, 'out.gif'), folder]);
    await fails(/--size: a side has 101 pixels/, [out, folder, '--size', '101x100']);
    await fails(/--to: the run has no time 3/, [out, folder, '--to', '3']);
    await fails(/--to: the film would end before/, [out, folder, '--from', '1', '--to', '0.5']);
    await fails(/--fps: the number is 0/, [out, folder, '--fps', '0']);
    await fails(/--quality: there is no quality 'best'/, [out, folder, '--quality', 'best']);
    await fails(/no such program: \/nowhere/, [out, folder], { HARDBALL_BROWSER: '/nowhere' });
    await fails(/needs Chromium, .* install/, [out, folder], { HARDBALL_BROWSER: '', PATH: '/nowhere' });
    // A browser that ends at once.
    const ended = await outcome(['film', out, folder], { HARDBALL_BROWSER: '/bin/true' });
    assert.equal(ended.code, 1);
    assert.match(ended.messages, /the browser ended before the film/);
  });
});
