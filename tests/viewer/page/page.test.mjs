// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { readRecording } from '../../../apps/viewer/page/src/recording/recording_file.js';
import { middleOf } from '../support/browser.mjs';
import {
  browser,
  isBlue,
  isOrange,
  setQuality,
  setTime,
  state,
  withOutput,
  withSaved,
  withView,
} from '../support/pages.mjs';
import { readTrajectory, run, withFolder, writeScenario } from '../support/program.mjs';

const kGas = `
[box]
size = [12.0, 12.0, 12.0]
boundary = ["periodic", "wall", "periodic"]

[[spheres]]
count = 300
radius = 0.5
placement = "random"
temperature = 1.0

[run]
until = 8.0
seed = 4

[output]
snapshots_every = 1.0
recording = true
`;

// A small sphere and a large one, which differ in color, in space where nothing else is drawn.
const kPair = `
[box]
boundary = ["open", "open", "open"]

[[spheres]]
radius = 0.5
positions = [[-3.0, 1.0, 0.0]]
velocities = [[1.0, 0.2, -0.3]]

[[spheres]]
radius = 1.2
positions = [[3.0, -2.0, 1.0]]
velocities = [[-0.6, 0.4, 0.1]]

[run]
until = 4.0

[output]
recording = true
`;

// Runs `scenario` to its end, and shows it.
function withRun(scenario, work, options) {
  return withOutput(scenario, (out, folder) =>
    withView(out, (page, program) => work(page, { out, program, folder }), options),
  );
}

// Shows a live run of the gas.
function withLive(words, work) {
  return withFolder(async (folder) => withView(await writeScenario(folder, kGas), work, { words }));
}

async function contactTimes(out) {
  const bytes = await readFile(join(out, 'recording.hbr'));
  const { chunks } = readRecording(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
  return chunks.flatMap((chunk) => Array.from({ length: chunk.contacts }, (_, k) => chunk.time(k)));
}

test('a finished run can be played, paused, scrubbed and stepped through, without errors', async () => {
  await withRun(kGas, async (page, { out }) => {
    const start = await state(page);
    assert.equal(start.time, 0);
    assert.equal(start.spheres, 300);
    assert.equal(start.knownEnd, 8);
    assert.ok(start.status.finished);
    assert.match(await page.textContent('#count-hash'), /^[0-9a-f]{16}$/);

    await page.click('#play');
    await page.waitForFunction(() => window.hardball.time > 0);
    await page.click('#play');
    const paused = (await state(page)).time;
    assert.ok(paused < 8);
    await page.evaluate(
      () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
    );
    assert.equal((await state(page)).time, paused);

    await page.locator('#scrub').fill('50000');
    await page.waitForFunction(() => window.hardball.time === 4);

    const times = await contactTimes(out);
    const next = times.find((time) => time > 4);
    await page.click('#forward');
    await page.waitForFunction((time) => window.hardball.time === time, next);
    await page.click('#back');
    await page.waitForFunction(
      (time) => window.hardball.time === time,
      times.filter((time) => time < next).at(-1),
    );

    await page.locator('#canvas').focus();
    await page.keyboard.press('End');
    await page.waitForFunction(() => window.hardball.time === 8);
    await page.keyboard.press('Home');
    await page.waitForFunction(() => window.hardball.time === 0);
    await page.keyboard.press('n');
    await page.waitForFunction((time) => window.hardball.time === time, times[0]);
    const { speed } = await state(page);
    await page.keyboard.press('PageDown');
    assert.ok((await state(page)).speed < speed);
    await page.keyboard.press(' ');
    await page.waitForFunction(
      (time) => window.hardball.state().isPlaying && window.hardball.time > time,
      times[0],
    );
  });
});

test('centers are those that the library writes into its trajectory', async () => {
  await withRun(kGas, async (page, { out }) => {
    const snapshots = readTrajectory(await readFile(join(out, 'trajectory.xyz'), 'utf8'));
    assert.ok(snapshots.length > 7);
    let farthest = 0;
    for (const { time, positions } of snapshots) {
      assert.equal(positions.length, 300);
      const shown = await page.evaluate(
        ([time, count]) =>
          Promise.all(Array.from({ length: count }, (_, id) => window.hardball.position(id, time))),
        [time, positions.length],
      );
      positions.forEach((place, id) =>
        place.forEach((coordinate, axis) => {
          assert.ok(shown[id][axis] >= 0 && shown[id][axis] <= 12);
          const apart = Math.abs(coordinate - shown[id][axis]);
          farthest = Math.max(farthest, axis === 1 ? apart : Math.min(apart, 12 - apart));
        }),
      );
    }
    // Times in a recording are single doubles: half a unit of the last place of 8, at speeds below 6; and rounding.
    assert.ok(farthest < 2 ** -50 * 6 + 2 ** -48, `${farthest}`);
  });
});

test('spheres are drawn where they are, in their colors and sizes, as impostors and as points', async () => {
  await withRun(kPair, async (page) => {
    const area = await page.locator('#canvas').boundingBox();
    const background = (image) => [
      ...image.data.subarray(4 * ((area.y + 30) * image.width + area.x + area.width - 30)).subarray(0, 3),
    ];
    await page.evaluate(() => (document.getElementById('color-by').value = 'species'));
    for (const way of ['full', 'points']) {
      await setQuality(page, way);
      for (const time of [0.5, 2.5]) {
        await setTime(page, time);
        const image = await browser.pixels(page);
        assert.deepEqual(background(image), [0xf4, 0xf5, 0xf7]);
        const places = await page.evaluate(() => [0, 1].map((id) => window.hardball.screenPosition(id)));
        const seen = [middleOf(image, area, isBlue), middleOf(image, area, isOrange)];
        for (const id of [0, 1]) {
          const radius = Math.sqrt(seen[id].count / Math.PI);
          // Near the edge of the picture a sphere looks like an ellipse, whose middle is not its center.
          const tolerance = 1 + 0.06 * radius;
          assert.ok(seen[id].count > 100, `${way}: sphere ${id} covers ${seen[id].count} pixels`);
          for (const side of ['x', 'y'])
            assert.ok(
              Math.abs(seen[id][side] - places[id][side]) < tolerance,
              `${way}: ${seen[id][side]} is not ${places[id][side]}`,
            );
        }
        // Of radii 0.5 and 1.2, at about the same distance.
        const ratio = Math.sqrt(seen[1].count / seen[0].count);
        assert.ok(ratio > 1.8 && ratio < 3, `${way}: ${ratio}`);
      }
    }
  });
});

test('a clicked sphere is followed: its numbers, its path, its cells', async () => {
  await withRun(kPair, async (page) => {
    await setTime(page, 1);
    const { x, y } = await page.evaluate(() => window.hardball.screenPosition(1));
    await page.mouse.click(x, y);
    assert.equal((await state(page)).followed, 1);
    await page.waitForFunction(() => document.getElementById('sphere-speed').textContent === '0.7280');
    assert.equal(await page.textContent('#sphere-position'), '2.400  −1.600  1.100');
    await page.check('#show-cells');
    await page.waitForFunction(() =>
      /^(enter|leave) along [xyz]/.test(document.getElementById('sphere-crossing').textContent),
    );
    await page.check('#camera-follows');
    await setTime(page, 3);
    const area = await page.locator('#canvas').boundingBox();
    const followed = await page.evaluate(() => window.hardball.screenPosition(1));
    assert.ok(
      Math.abs(followed.x - area.x - area.width / 2) < 1 &&
        Math.abs(followed.y - area.y - area.height / 2) < 1,
    );
    await page.keyboard.press('Escape');
    assert.equal((await state(page)).followed, null);
  });
});

test('all colorings, cells, flashes and a screenshot', async () => {
  await withRun(kGas, async (page) => {
    await setTime(page, 3);
    const pictures = new Set();
    for (const name of ['speed', 'size', 'species', 'collisions', 'last contact']) {
      await page.selectOption('#color-by', name);
      await setTime(page, 3);
      pictures.add((await page.locator('#canvas').screenshot()).toString('base64'));
    }
    // All spheres are equal, so that two of the colorings need not differ from others.
    assert.ok(pictures.size >= 4);
    await page.uncheck('#show-events');
    await page.check('#show-cells');
    await page.fill('#cell-edge', '3');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.getElementById('cell-edge').value === '3');
    assert.notEqual((await state(page)).followed, null);
    await page.click('#slow');
    await page.click('#screenshot');
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-picture')]);
    assert.equal((await readFile(await download.path())).subarray(1, 4).toString(), 'PNG');
  });
});

test('a live run can be watched', async () => {
  await withLive(['--until', '20'], async (page) => {
    await page.waitForFunction(
      () => window.hardball.state().status.finished && window.hardball.state().knownEnd === 20,
    );
    await setTime(page, 19.5);
    assert.equal((await state(page)).time, 19.5);
  });
});

test('a saved replay needs no server', async () => {
  await withRun(kGas, async (page, { program, folder }) => {
    const place = await page.evaluate(() => window.hardball.position(7, 5.5));
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save')]);
    const path = join(folder, 'replay.html');
    await writeFile(path, await readFile(await download.path()));
    await program.stop();
    await withSaved(path, async (replay) => {
      await setTime(replay, 5.5);
      assert.deepEqual(await replay.evaluate(() => window.hardball.position(7)), place);
      assert.equal(await replay.textContent('#status-text'), 'Saved replay');
    });
    page.errors = []; // of the page whose server is gone
  });
});

test('a replay is shown within the page of a notebook', async () => {
  await withFolder(async (folder) => {
    const scenario = await writeScenario(folder, kPair);
    const path = join(folder, 'replay.html');
    await run('replay', scenario, '--out', path);
    const inside = (await readFile(path, 'utf8')).replaceAll('&', '&amp;').replaceAll('"', '&quot;');
    const notebook = join(folder, 'notebook.html');
    await writeFile(notebook, `<!doctype html><p>A cell.</p><iframe srcdoc="${inside}" width="800" height="600"></iframe>`);
    const page = await browser.openPage(pathToFileURL(notebook).href);
    const frame = await (await page.waitForSelector('iframe')).contentFrame();
    await frame.waitForFunction(() => window.hardball?.state().isReady, null, { timeout: 120_000 });
    assert.equal(await frame.evaluate(() => window.hardball.state().spheres), 2);
    assert.equal(await frame.textContent('#count-spheres'), '2');
    assert.deepEqual(page.errors, []);
    await page.close();
  });
});

test('no one is served without the right token', async () => {
  await withRun(kPair, async (page, { program }) => {
    const wrong = new URL(program.url);
    wrong.searchParams.set('token', '0'.repeat(32));
    for (const path of ['/', '/page.js', '/api/header', '/api/chunk?number=0', '/api/replay.html']) {
      const address = new URL(path, wrong);
      assert.equal((await fetch(address)).status, 403, path);
      address.searchParams.set('token', wrong.searchParams.get('token'));
      assert.equal((await fetch(address)).status, 403, path);
    }
  });
});

test('when the program is gone, the page says so, and the part loaded can be viewed', async () => {
  await withLive(['--until', '1e7'], async (page, program) => {
    await page.waitForFunction(() => window.hardball.state().chunksInMemory > 2);
    await program.stop();
    await page.waitForFunction(() => window.hardball.state().isLost);
    assert.match(await page.textContent('#notices'), /does not answer/);
    const moment = await setTime(page, 0.25);
    assert.equal(moment, 0.25);
    page.errors = []; // that the program does not answer
  });
});

test('the page fits a phone, and all controls have names', async () => {
  await withRun(
    kGas,
    async (page) => {
      const widths = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
      assert.ok(widths[0] <= widths[1], `${widths}`);
      for (const role of ['button', 'slider', 'checkbox', 'spinbutton', 'combobox', 'link']) {
        for (const control of await page.getByRole(role).all()) {
          const name = await control.evaluate(
            (element) =>
              element.ariaLabel || element.labels?.[0]?.textContent.trim() || element.textContent.trim(),
          );
          assert.ok(name, await control.evaluate((element) => element.outerHTML));
        }
      }
      assert.equal(await page.getByRole('button', { name: 'Play', exact: true }).count(), 1);
    },
    { width: 390, height: 844, pixelRatio: 2, scheme: 'dark' },
  );
});
