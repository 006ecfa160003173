// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Gravity, surfaces, sizes and periodic images, in recordings that are made here.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { middleOf } from '../support/browser.mjs';
import { recordLoneSpheres } from '../support/lone_spheres.mjs';
import { browser, follow, isBlue, isOrange, setQuality, setTime, state, withRecording } from '../support/pages.mjs';

const kOpen = { size: [0, 0, 0], boundary: ['open', 'open', 'open'] };

const withSpheres = (spheres, work) => withRecording(recordLoneSpheres(spheres), work);

// Two thrown spheres of different species, in space where nothing else is drawn.
const kThrown = {
  box: kOpen,
  gravity: [0, 0, -2],
  radii: [0.5, 0.6],
  positions: [
    [-3, 0, 0],
    [3, 0, 0],
  ],
  velocities: [
    [0.5, 0, 3],
    [-0.5, 0, 2],
  ],
  until: 4,
};

test('thrown spheres are drawn on their parabolas, as impostors and as points', async () => {
  await withSpheres(kThrown, async (page) => {
    const area = await page.locator('#canvas').boundingBox();
    for (const way of ['full', 'points']) {
      await setQuality(page, way);
      for (const time of [0.25, 1.5, 2.5]) {
        await setTime(page, time);
        const height = (await page.evaluate(() => window.hardball.position(0)))[2];
        assert.ok(Math.abs(height - (3 * time - time ** 2)) < 1e-12);
        const image = await browser.pixels(page);
        const places = await page.evaluate(() => [0, 1].map((id) => window.hardball.screenPosition(id)));
        [isBlue, isOrange].forEach((isMeant, id) => {
          const seen = middleOf(image, area, isMeant);
          assert.ok(seen.count > 100, `${way} at ${time}: sphere ${id} covers ${seen.count} pixels`);
          const tolerance = 1 + 0.06 * Math.sqrt(seen.count / Math.PI);
          for (const side of ['x', 'y'])
            assert.ok(
              Math.abs(seen[side] - places[id][side]) < tolerance,
              `${way} at ${time}: ${seen[side]} is not ${places[id][side]}`,
            );
        });
      }
    }
  });
});

test('the speed shown is that at the time shown, and up is against gravity', async () => {
  await withSpheres(kThrown, async (page) => {
    await follow(page, 0);
    await setTime(page, 1.5);
    await page.waitForFunction(() => document.getElementById('sphere-speed').textContent === '0.5000');
    await setTime(page, 3);
    await page.waitForFunction(() => document.getElementById('sphere-speed').textContent === '3.041');
    const [low, high] = await page.evaluate(() =>
      [
        [0, 0, 0],
        [0, 0, 1],
      ].map((place) => window.hardball.screenPlace(place)),
    );
    assert.ok(high.y < low.y - 10);
  });
});

test('spheres are colored by their speed at the time shown', async () => {
  await withSpheres(kThrown, async (page) => {
    await page.selectOption('#color-by', 'speed');
    // One that was faster when thrown is slower than the other.
    await setTime(page, 1.5);
    const image = await browser.pixels(page);
    const greens = [];
    for (const id of [0, 1]) {
      const { x, y } = await page.evaluate((id) => window.hardball.screenPosition(id), id);
      greens.push(image.data[4 * (Math.round(y) * image.width + Math.round(x)) + 1]);
    }
    assert.ok(greens[0] < greens[1] - 10, `${greens}`);
  });
});

const kWalls = {
  ...kThrown,
  surfaces: [
    { shape: 'plane', point: [0, 0, -1], direction: [0, 0, 1], amplitude: 0.25, frequency: 0.5 },
    { shape: 'cylinder', point: [0, 0, 0], direction: [0, 0, 1], radius: 5 },
    { shape: 'obstacle', point: [0, 0, 2], radius: 0.75, temperature: 1.5 },
    { shape: 'sphere', point: [0, 0, 0], radius: 9, velocity: [0.1, 0, 0] },
  ],
  until: 6,
};

test('surfaces are drawn where they are, named in the legend, and can be hidden', async () => {
  await withSpheres(kWalls, async (page) => {
    const names = ['wall 0: plane', 'wall 1: cylinder', 'wall 2: obstacle', 'wall 3: sphere'];
    assert.deepEqual((await state(page)).surfaces, names);
    const legend = await page.textContent('#legend-surfaces');
    for (const text of [...names, 'plane, oscillates', 'obstacle, kT = 1.50', 'sphere, moves'])
      assert.ok(legend.includes(text), `${text} is not in ${legend}`);
    await setTime(page, 0.5);
    assert.deepEqual(await page.evaluate(() => window.hardball.surfacePoint(0)), [0, 0, -0.75]);

    // The obstacle is red, since it is hot.
    const { x, y } = await page.evaluate(() => window.hardball.screenPlace([0, 0, 2]));
    const area = { x: x - 60, y: y - 60, width: 120, height: 120 };
    const isRed = (red, green, blue) => red > 1.4 * green && red > 1.4 * blue;
    const seen = middleOf(await browser.pixels(page), area, isRed);
    assert.ok(seen.count > 100, `${seen.count}`);
    assert.ok(Math.abs(seen.x - x) < 4 && Math.abs(seen.y - y) < 4, `${seen.x}, ${seen.y} is not ${x}, ${y}`);

    const canvas = page.locator('#canvas');
    const atRest = (await canvas.screenshot()).toString('base64');
    await page.keyboard.press('w');
    await setTime(page, 0.5);
    const hidden = (await canvas.screenshot()).toString('base64');
    assert.notEqual(hidden, atRest);
    assert.equal(middleOf(await browser.pixels(page), area, isRed).count, 0);
  });
});

test('an oscillating plane moves while nothing else does', async () => {
  const [plane] = kWalls.surfaces;
  const high = { ...kThrown, gravity: [0, 0, 0], velocities: kThrown.velocities.map(() => [0, 0, 0]) };
  await withSpheres({ ...high, surfaces: [plane] }, async (page) => {
    // In open space the page finds out how far things come when it refreshes its panels.
    for (const time of [0.5, 1.5]) {
      await setTime(page, time);
      await page.waitForTimeout(2000);
    }
    const pictures = new Set();
    for (const time of [0.5, 1, 1.5, 2]) {
      await setTime(page, time);
      pictures.add((await page.locator('#canvas').screenshot()).toString('base64'));
    }
    // At 1 and 2 it is in the middle.
    assert.equal(pictures.size, 3);
  });
});

test('contacts with surfaces are named', async () => {
  await withSpheres(kWalls, async (page) => {
    await follow(page, 1);
    await page.waitForFunction(() =>
      /^wall [01]: (plane|cylinder) in/.test(document.getElementById('sphere-next').textContent),
    );
    await page.keyboard.press('Shift+N');
    await page.waitForFunction(() =>
      /Sphere 1 meets wall [01]: (plane|cylinder)/.test(document.getElementById('notices').textContent),
    );
    await setTime(page, 0);
    await page.waitForFunction(() => !/meets/.test(document.getElementById('notices').textContent));
  });
});

test('a sphere of a hundredth of the radius of others is seen, and can be picked', async () => {
  const spheres = {
    ...kThrown,
    gravity: [0, 0, 0],
    radii: [2, 0.02],
    positions: [
      [-20, 0, 0],
      [20, 0, 0],
    ],
  };
  await withSpheres(spheres, async (page) => {
    await page.selectOption('#color-by', 'size');
    // Both ends and the geometric mean.
    const numbers = await page.locator('#legend-numbers span').allTextContents();
    assert.deepEqual(numbers, ['0.0200 L', '0.200 L', '2.00 L']);
    await setTime(page, 0);
    const { x, y } = await page.evaluate(() => window.hardball.screenPosition(1));
    const around = { x: x - 4, y: y - 4, width: 8, height: 8 };
    for (const way of ['full', 'points']) {
      await setQuality(page, way);
      await setTime(page, 0);
      // The smallest are violet, the largest yellow.
      const { count } = middleOf(
        await browser.pixels(page),
        around,
        (red, green) => green < 150 && red < 170,
      );
      assert.ok(count >= 4, `${way}: ${count}`);
    }
    await page.mouse.click(x, y);
    assert.equal((await state(page)).followed, 1);
  });
});

test('a sphere that crosses a periodic face is drawn on both sides, and can be picked there', async () => {
  const crossing = {
    ...kThrown,
    box: { size: [10, 10, 10], boundary: ['periodic', 'wall', 'wall'] },
    gravity: [0, 0, 0],
    radii: [1],
    positions: [[0.2, 5, 5]],
    velocities: [[1, 0, 0]],
  };
  await withSpheres(crossing, async (page) => {
    await setTime(page, 0);
    assert.equal((await state(page)).images, 1);
    const at = (place) => page.evaluate((place) => window.hardball.screenPlace(place), place);
    const { x, y } = await at([10.2, 5, 5]);
    const area = { x: x - 20, y: y - 20, width: 40, height: 40 };
    const isColored = (red, green, blue) => Math.max(red, green, blue) > Math.min(red, green, blue) + 40;
    for (const way of ['full', 'points']) {
      await setQuality(page, way);
      await setTime(page, 0);
      assert.ok(middleOf(await browser.pixels(page), area, isColored).count > 1000, way);
    }
    await page.mouse.click(x, y);
    assert.equal((await state(page)).followed, 0);
    await page.keyboard.press('Escape');
    await page.keyboard.press('i');
    await setTime(page, 0);
    assert.equal((await state(page)).images, 0);
    assert.equal(middleOf(await browser.pixels(page), area, isColored).count, 0);
    await page.keyboard.press('i');
    await setTime(page, 2);
    assert.equal((await state(page)).images, 0, 'it has left the face');
  });
});

test('the energy plot includes the potential energy', async () => {
  await withSpheres(kThrown, async (page) => {
    assert.equal(await page.textContent('#energy-name'), 'Kinetic and potential energy');
    assert.ok(await page.locator('#figure-energy').isVisible());
  });
  await withSpheres({ ...kThrown, gravity: [0, 0, 0] }, async (page) => {
    assert.ok(!(await page.locator('#figure-energy').isVisible()));
  });
});
