// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Keys and their help, units, the scale of the picture, the card on a phone, and rings in a heap.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { recordLoneSpheres } from '../support/lone_spheres.mjs';
import { follow, setTime, state, withOutput, withRecording, withView } from '../support/pages.mjs';

// Grains that have come to rest on the floor, and hop there by less than can be seen.
const kHeap = `
[box]
size = [8.0, 8.0, 12.0]
boundary = ["periodic", "periodic", "wall"]
gravity = [0.0, 0.0, -1.0]

[[spheres]]
count = 150
radius = 0.5
placement = "random"
temperature = 0.1

[response]
restitution = 0.6
elastic_below = 0.02
settle = false

[run]
until = 60.0
seed = 2

[output]
recording = true
`;

const kTwo = {
  box: { size: [10, 10, 10], boundary: ['wall', 'wall', 'wall'] },
  radii: [0.5, 0.5],
  positions: [
    [2, 5, 5],
    [7, 5, 5],
  ],
  velocities: [
    [1, 0.5, 0.25],
    [-0.5, 1, 0.5],
  ],
  until: 8,
};

function withTwo(work, options, spheres = kTwo) {
  return withRecording(recordLoneSpheres(spheres), work, options);
}

const lengthOfPixel = (page) => page.evaluate(() => window.hardball.lengthOfPixel());
const same = (one, other) => Math.hypot(one.x - other.x, one.y - other.y) < 0.5;
const seen = (page, place) => page.evaluate((place) => window.hardball.screenPlace(place), place);

test('a question mark shows all keys and what units mean, and Esc hides them', async () => {
  await withTwo(async (page) => {
    await follow(page, 1);
    await page.keyboard.press('?');
    assert.ok(await page.locator('#help').isVisible());
    const keys = (await page.locator('#help dt').allTextContents()).join(' ');
    for (const key of ['Space', 'N P', 'Home', 'PgUp', '← → ↑ ↓', '+ −', 'X Y Z', 'F', '0', 'G', 'Esc', '?'])
      assert.ok(keys.includes(key), key);
    const text = await page.textContent('#help');
    assert.match(text, /units of length, time and mass/);
    assert.match(text, /diameters are 1\.00 L/);
    // Keys of the page do nothing behind it.
    await page.keyboard.press('f');
    await page.keyboard.press('Escape');
    assert.ok(await page.locator('#help').isHidden());
    assert.equal((await state(page)).followed, 1);
    await page.keyboard.press('?');
    await page.keyboard.press('?');
    assert.ok(await page.locator('#help').isHidden());
    await page.click('#help-button');
    assert.ok(await page.locator('#help').isVisible());
    await page.click('#help-close');
    assert.ok(await page.locator('#help').isHidden());
  });
});

test('the camera has keys', async () => {
  await withTwo(async (page) => {
    const corner = [10, 10, 10];
    const start = await seen(page, corner);
    const at = async (key) => {
      await page.keyboard.press(key);
      return seen(page, corner);
    };
    assert.ok(!same(await at('ArrowRight'), start));
    assert.ok(same(await at('ArrowLeft'), start));
    assert.ok(!same(await at('ArrowUp'), start));
    assert.ok(same(await at('ArrowDown'), start));
    const moved = await at('Shift+ArrowRight');
    assert.ok(moved.x < start.x - 20 && Math.abs(moved.y - start.y) < 0.5);
    const far = await lengthOfPixel(page);
    await page.keyboard.press('+');
    assert.ok((await lengthOfPixel(page)) < 0.95 * far);
    // Along x, upright along y: z is across the picture, x is not.
    await page.keyboard.press('0');
    await page.keyboard.press('x');
    const [middle, along, across] = [
      await seen(page, [5, 5, 5]),
      await seen(page, [6, 5, 5]),
      await seen(page, [5, 5, 6]),
    ];
    assert.ok(Math.abs(along.x - middle.x) < Math.abs(across.x - middle.x) / 5);
    const other = async () => (await seen(page, [5, 5, 6])).x - (await seen(page, [5, 5, 5])).x;
    const before = await other();
    await page.keyboard.press('x');
    assert.ok(before * (await other()) < 0, 'again: from the other side');
    await page.keyboard.press('0');
    assert.ok(same(await seen(page, corner), start));
  });
});

test('in a plane the arrows move the picture, and nothing turns it', async () => {
  const flat = {
    ...kTwo,
    box: { size: [10, 10, 0], boundary: ['wall', 'wall', 'flat'] },
    positions: [
      [2, 5, 0],
      [7, 5, 0],
    ],
    velocities: [
      [1, 0.5, 0],
      [-0.5, 1, 0],
    ],
  };
  await withTwo(
    async (page) => {
      const [one, other] = [await seen(page, [2, 2, 0]), await seen(page, [8, 8, 0])];
      await page.keyboard.press('ArrowUp');
      const [oneMoved, otherMoved] = [await seen(page, [2, 2, 0]), await seen(page, [8, 8, 0])];
      assert.ok(oneMoved.y > one.y + 20);
      assert.ok(Math.abs(otherMoved.y - oneMoved.y - (other.y - one.y)) < 0.5);
      await page.keyboard.press('x');
      assert.ok(same(await seen(page, [2, 2, 0]), oneMoved));
      await page.keyboard.press('?');
      assert.ok(!(await page.textContent('#help-keys')).includes('X Y Z'));
    },
    {},
    flat,
  );
});

test('the scale bar is as long as it says, and numbers have units', async () => {
  await withTwo(async (page) => {
    await setTime(page, 1);
    await follow(page, 0);
    await page.keyboard.press('g');
    await page.keyboard.press('z');
    const lengths = [];
    for (const zooms of [0, 12, 20]) {
      for (let k = 0; k < zooms; ++k) await page.keyboard.press('+');
      await setTime(page, 1);
      const text = await page.textContent('#scale-text');
      const length = Number(/^([\d.]+) L$/.exec(text)[1]);
      const { width } = await page.locator('#scale-bar').boundingBox();
      assert.ok(width > 50 && width < 145, `${width}`);
      // The sphere is in the middle of the picture.
      const [from, to] = [await seen(page, [3, 5.5, 5.25]), await seen(page, [3 + length / 100, 5.5, 5.25])];
      const drawn = 100 * Math.hypot(to.x - from.x, to.y - from.y);
      assert.ok(Math.abs(drawn / width - 1) < 0.02, `${drawn} and ${width}`);
      lengths.push(length);
    }
    assert.ok(lengths[0] > lengths[1] && lengths[1] > lengths[2], `${lengths}`);
    await page.waitForFunction(() => / in [\d.]+ T$/.test(document.getElementById('sphere-next').textContent));
    assert.match(await page.textContent('#sphere'), /Position \[L\].*Velocity \[L T⁻¹\]/s);
    assert.match(await page.textContent('#time'), /^1\.0+ T$/);
    assert.match(await page.textContent('#speed-text'), / T per s$/);
    assert.match(await page.textContent('#legend-numbers'), /L T⁻¹/);
    assert.match(await page.textContent('#plots'), /\[T⁻¹\].*\[L T⁻¹\].*\[M L² T⁻²\]/s);
  });
});

test('rings do not bury a heap at rest, and show where spheres fall on it', async () => {
  const work = async (page) => {
    assert.ok(await page.isChecked('#show-events'));
    const ringsAt = async (time) => {
      await setTime(page, time);
      return (await state(page)).flashes;
    };
    let falling = 0;
    let resting = 0;
    for (let k = 0; k < 10; ++k) {
      falling = Math.max(falling, await ringsAt(1 + k / 4));
      resting = Math.max(resting, await ringsAt(50 + k / 4));
    }
    assert.ok(falling > 5, `${falling}`);
    assert.ok(resting < 1, `${resting}`);
    // However fast it is played, most spheres stay uncovered.
    await page.evaluate(() => (document.getElementById('speed').value = document.getElementById('speed').max));
    await page.locator('#speed').dispatchEvent('input');
    assert.ok((await ringsAt(3)) <= 150 / 5 + 1e-3);
  };
  await withOutput(kHeap, (out) => withView(out, work));
});

test('on a phone the card shows position and velocity', async () => {
  await withTwo(
    async (page) => {
      await setTime(page, 1);
      await follow(page, 0);
      await page.waitForFunction(() => document.getElementById('sphere-position').textContent !== '');
      for (const id of ['#sphere-position', '#sphere-velocity', '#sphere-speed', '#sphere-next']) {
        assert.ok(await page.locator(id).isVisible(), id);
        const isWhole = await page.locator(id).evaluate((element) => element.scrollWidth <= element.clientWidth);
        assert.ok(isWhole, `${id} is cut`);
      }
      assert.equal(await page.textContent('#sphere-position'), '3.000  5.500  5.250');
      // It leaves most of the picture free.
      const [card, canvas] = [await page.locator('#sphere').boundingBox(), await page.locator('#canvas').boundingBox()];
      assert.ok(card.height < 0.5 * canvas.height, `${card.height} of ${canvas.height}`);
    },
    { width: 390, height: 844, pixelRatio: 2 },
  );
});
