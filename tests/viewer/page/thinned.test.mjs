// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Replays that are small enough to be sent: what fits of them is exact, and the page says what is left out.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { statSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { follow, setTime, state, withOutput, withSaved } from '../support/pages.mjs';

const kGas = `
[box]
size = [12.0, 12.0, 12.0]
boundary = ["periodic", "wall", "periodic"]
gravity = [0.0, -0.2, 0.0]

[[spheres]]
count = 200
radius = 0.5
placement = "random"
temperature = 1.0

[response]
tangential_restitution = 0.5

[run]
until = 20.0
seed = 4

[output]
recording = true
`;

function replay(out, file, ...words) {
  const { status, stdout, stderr } = spawnSync(process.env.HARDBALL_PROGRAM, ['replay', out, '--out', file, ...words], {
    encoding: 'utf8',
  });
  assert.equal(status, 0, stderr);
  return stdout;
}

const position = (page, id, time) => page.evaluate(([id, time]) => window.hardball.position(id, time), [id, time]);
const orientation = (page, id) => page.evaluate((id) => window.hardball.orientation(id), id);

test('a replay of at most some size has exact moments, or an exact begin', async () => {
  await withOutput(kGas, async (out, folder) => {
    const file = (name) => join(folder, name);
    replay(out, file('whole.html'));
    const whole = statSync(file('whole.html')).size;
    const most = Math.round((whole - 500_000) / 1000);
    assert.ok(most > 1100, `${most}`);
    // What fits is not thinned.
    assert.match(replay(out, file('same.html'), '--most', '50MB'), /collisions\n$/);
    assert.equal(statSync(file('same.html')).size, whole);

    const said = replay(out, file('moments.html'), '--most', `${most}kB`);
    const [, count, step] = /thinned: (\d+) moments, ([\d.]+) apart\n$/.exec(said);
    assert.ok(statSync(file('moments.html')).size <= 1000 * most);
    assert.ok(statSync(file('moments.html')).size > 950 * most);
    const known = { positions: [], orientations: [] };
    assert.ok(count > 4, said);
    const times = [0, 2 * Number(step), 20];
    await withSaved(file('whole.html'), async (page) => {
      for (const time of times) {
        await setTime(page, time);
        known.positions.push(await position(page, 3, time));
        known.orientations.push(await orientation(page, 3));
      }
      known.status = (await state(page)).status;
    });
    await withSaved(file('moments.html'), async (page) => {
      const { status, chunks, knownEnd } = await state(page);
      assert.deepEqual([chunks, knownEnd], [Number(count), 20]);
      assert.deepEqual([status.collisions, status.walls], [known.status.collisions, known.status.walls]);
      for (const [k, time] of times.entries()) {
        // Any time until the next moment shows this one.
        assert.equal(await setTime(page, time + 0.4 * step), time);
        (await position(page, 3, time)).forEach((place, axis) => assert.equal(place, known.positions[k][axis]));
        const turned = await orientation(page, 3);
        turned.forEach((part, axis) => assert.ok(Math.abs(part - known.orientations[k][axis]) < 1e-9, `${turned}`));
      }
      assert.equal(await page.textContent('#status-text'), 'Moments of a run');
      for (const id of ['#plot-rate', '#show-events', '#slow']) assert.ok(await page.locator(id).isHidden(), id);
      await follow(page, 3);
      await page.waitForSelector('#sphere', { state: 'visible' });
      assert.ok(await page.locator('#sphere-next').isHidden());
      await page.click('#home');
      await page.waitForFunction(() => window.hardball.time === 0);
      await page.click('#forward');
      await page.waitForFunction((step) => window.hardball.time === step, Number(step));
      await page.click('#back');
      await page.waitForFunction(() => window.hardball.time === 0);
      await page.evaluate(() => window.hardball.play());
      await page.waitForFunction(() => window.hardball.time > 0.5);
    });

    const cut = replay(out, file('cut.html'), '--most', `${most}kB`, '--thin', 'end');
    const end = Number(/thinned: ends at ([\d.]+)\n$/.exec(cut)[1]);
    assert.ok(statSync(file('cut.html')).size <= 1000 * most);
    assert.ok(end > 2 && end < 20, `${end}`);
    await withSaved(file('cut.html'), async (page) => {
      assert.equal((await state(page)).knownEnd, end);
      assert.deepEqual(await position(page, 3, times[1]), known.positions[1]);
    });
  });
});

test('sizes in which nothing fits are refused', async () => {
  await withOutput(kGas, async (out, folder) => {
    for (const [words, what] of [
      [['--most', '10kB'], /bytes hold not enough of the recording/],
      [['--most', '10kB', '--thin', 'end'], /bytes hold not enough of the recording/],
      [['--most', 'small'], /--most: .*is not accepted/],
      [['--most', '0'], /--most: the size is 0/],
      [['--thin', 'spheres'], /--thin: there is no 'spheres'/],
    ]) {
      const file = join(folder, 'refused.html');
      const { status, stderr } = spawnSync(process.env.HARDBALL_PROGRAM, ['replay', out, '--out', file, ...words], {
        encoding: 'utf8',
      });
      assert.equal(status, 2, stderr);
      assert.match(stderr, what);
    }
  });
});
