// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Spheres that merge and spin, and discs, in recordings that are made here.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { middleOf } from '../support/browser.mjs';
import { browser, follow, isBlue, isOrange, setQuality, setTime, state, withRecording } from '../support/pages.mjs';
import { writeRecording } from '../support/small_gas.mjs';

const kStill = [0, 0, 0];
const kUpright = [0, 0, 0, 1];

// Shows a recording of two spheres of different species.
async function withSpheres({ boundary, keyframe, bodies, contacts, bonds }, work) {
  const header = {
    box: { size: kStill, boundary },
    restitution: null,
    species: { names: ['drop', 'mist'], runs: [[0, 1], [1, 1]] },
    bonds,
  };
  const masses = [bodies[8], bodies[18]];
  const chunk = { begin: 0, end: 4, keyframe, bodies, contacts };
  const bytes = writeRecording(header, [bodies[7], bodies[17]], masses, [chunk]);
  await withRecording(bytes, async (page) => {
    await page.uncheck('#show-events');
    await work(page, await page.locator('#canvas').boundingBox());
  });
}

const kBox = ['open', 'open', 'open'];
const kMerging = {
  boundary: kBox,
  keyframe: [-2, 0, 0, 1, 0, 0, 0, 2, 0, 0, -1, 0, 0, 0],
  bodies: [...kStill, ...kUpright, 1, 1, 0.4, ...kStill, ...kUpright, 1, 1, 0.4],
  contacts: [
    {
      time: 1,
      first: 0,
      second: 1,
      fate: 2,
      numbers: [...[0, 0, 0, ...kStill, ...kStill], ...[1, 0, 0, 1.5, 2, 0.4, ...kStill]],
    },
  ],
};

test('of spheres that merge one vanishes, and the other grows, at the exact time', async () => {
  await withSpheres(kMerging, async (page, area) => {
    for (const way of ['full', 'points']) {
      await setQuality(page, way);
      const areas = [];
      for (const time of [0.999999, 1, 3, 0.5]) {
        await setTime(page, time);
        const image = await browser.pixels(page);
        areas.push([isBlue, isOrange].map((isMeant) => middleOf(image, area, isMeant).count));
      }
      const [before, after, later, again] = areas;
      assert.ok(before[1] > 100 && again[1] > 100, `${way}: ${areas}`);
      assert.deepEqual([after[1], later[1]], [0, 0], way);
      assert.ok(after[0] > 1.7 * before[0] && Math.abs(later[0] - after[0]) < 0.02 * after[0], `${way}: ${areas}`);
    }
    await setTime(page, 2);
    await page.waitForFunction(() => document.getElementById('legend-species').textContent === 'drop: 1mist: 0');
    await follow(page, 0);
    await page.waitForFunction(() => document.getElementById('sphere-kind').textContent === '1.500, 2.000');
    assert.equal(await page.textContent('#sphere-species'), 'drop');
    assert.equal(await page.textContent('#count-mergers'), '1');
    assert.match(await page.textContent('#legend-events'), /merger/);
  });
});

// Two spheres that part, whose bond is five diameters long at the start.
const kTied = {
  boundary: kBox,
  keyframe: [-5, 0, 0, 0, -1, 0, 0, 5, 0, 0, 0, 1, 0, 0],
  bodies: [...kStill, ...kUpright, 1, 1, 0.4, ...kStill, ...kUpright, 1, 1, 0.4],
  contacts: [],
  bonds: [[0, 1]],
};

test('a bond is a rod from sphere to sphere that follows them', async () => {
  await withSpheres(kTied, async (page) => {
    const isBond = (red, green, blue) => red > blue + 40;
    const bondAt = async (place) => {
      const { x, y } = await page.evaluate((place) => window.hardball.screenPlace(place), place);
      return middleOf(await browser.pixels(page), { x: x - 4, y: y - 4, width: 8, height: 8 }, isBond).count;
    };
    assert.equal((await state(page)).bonds, 1);
    await setTime(page, 0);
    assert.ok((await bondAt([2.5, 0, 0])) > 20);
    await setTime(page, 4);
    assert.ok((await bondAt([2.5, 2, 0])) > 20);
    assert.equal(await bondAt([2.5, 0, 0]), 0);
    await page.keyboard.press('b');
    assert.ok(!(await page.isChecked('#show-bonds')));
    await setTime(page, 3.9);
    assert.equal(await bondAt([2.5, 1.95, 0]), 0);
  });
});

// A disc that turns by a quarter in a unit of time, and one far away.
const kTurning = {
  boundary: ['open', 'open', 'flat'],
  keyframe: [0, 0, ...kStill, 0, 0, 6, 3, ...kStill, 0, 0],
  bodies: [
    ...[0, 0, Math.PI / 2, ...kUpright, 2, 1, 0.5],
    ...[...kStill, ...kUpright, 1, Infinity, 0.5],
  ],
  contacts: [],
};

test('the mark of a disc turns like the hand of a clock, the other way round', async () => {
  await withSpheres(kTurning, async (page, area) => {
    const hand = async () => {
      const image = await browser.pixels(page);
      const center = await page.evaluate(() => window.hardball.screenPosition(0));
      const disc = { x: center.x - 60, y: center.y - 60, width: 120, height: 120 };
      const { count, x, y } = middleOf(image, disc, (red, green, blue) => blue > red + 25 && blue < 100);
      return { count, x: x - center.x, y: y - center.y };
    };
    for (const [time, x, y] of [[0, 0, -1], [1, -1, 0], [2, 0, 1], [3, 1, 0]]) {
      await setTime(page, time);
      const seen = await hand();
      assert.ok(seen.count > 100, `${time}: ${seen.count} pixels`);
      const size = Math.hypot(seen.x, seen.y);
      assert.ok(seen.x * x + seen.y * y > 0.95 * size && size > 10, `${time}: ${seen.x} ${seen.y}`);
    }
    await page.uncheck('#show-spin');
    await setTime(page, 2.5);
    assert.equal((await hand()).count, 0);
    assert.match(await page.textContent('#legend-kinematic'), /1 of infinite mass/);
    assert.ok(middleOf(await browser.pixels(page), area, isBlue).count > 1000);
  });
});

test('a plane is drawn to scale, and is panned, not turned', async () => {
  await withSpheres(kTurning, async (page, area) => {
    const places = () =>
      page.evaluate(() =>
        [
          [0, 0, 0],
          [2, 0, 0],
          [0, 2, 0],
          [6, 3, 0],
        ].map((place) => window.hardball.screenPlace(place)),
      );
    const assertTrue = ([origin, x, y, far]) => {
      const scale = (x.x - origin.x) / 2;
      assert.ok(scale > 10);
      const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-3, `${a} ${b}`);
      near(x.y, origin.y);
      near(y.x, origin.x);
      near(origin.y - y.y, 2 * scale);
      near(far.x - origin.x, 6 * scale);
      near(origin.y - far.y, 3 * scale);
    };
    const before = await places();
    assertTrue(before);
    const [x, y] = [area.x + area.width / 2, area.y + area.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 60, y + 40, { steps: 4 });
    await page.mouse.up();
    await page.waitForTimeout(300);
    const after = await places();
    assertTrue(after);
    assert.ok(after[0].x - before[0].x > 20 && after[0].y - before[0].y > 15);
  });
});
