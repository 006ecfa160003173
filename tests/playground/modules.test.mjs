// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The modules of the page that need no browser.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import test from 'node:test';
import { completionsAt } from '../../playground/src/completion.js';
import { fragmentOf, packed, partsOf, unpacked } from '../../playground/src/link.js';
import { shown, unitText, withError } from '../../playground/src/numbers.js';
import { rangeOf } from '../../playground/src/sliders.js';
import { numbersOf } from '../../playground/src/toml_numbers.js';

const scenarios = new URL('../../scenarios/', import.meta.url);
const schema = JSON.parse(readFileSync(new URL('scenario.schema.json', scenarios)));
const texts = readdirSync(scenarios)
  .filter((name) => name.endsWith('.toml'))
  .map((name) => readFileSync(new URL(name, scenarios), 'utf8'));

function found(text) {
  return Object.fromEntries(numbersOf(text).map(({ path, value }) => [path, value]));
}

test('numbers of a scenario have their paths', () => {
  const text = `# 1 comment
[box]
size = [1_000.5, -2, 3e2] # 4
boundary = ["wall 5", 'x 6', "\\"7"]
[[spheres]]
radius = { distribution = "uniform", min = 0.4, max = 0.6 }
positions = [
  [1, 2], # 8
  [3, 4],
]
[[spheres]]
count = 9
[box.faces.x_min]
temperature = 10
[[response.pairs]]
restitution = .5x
settle = true
seed.deep = 11`;
  assert.deepEqual(found(text), {
    'box.size.0': 1000.5,
    'box.size.1': -2,
    'box.size.2': 300,
    'spheres.0.radius.min': 0.4,
    'spheres.0.radius.max': 0.6,
    'spheres.0.positions.0.0': 1,
    'spheres.0.positions.0.1': 2,
    'spheres.0.positions.1.0': 3,
    'spheres.0.positions.1.1': 4,
    'spheres.1.count': 9,
    'box.faces.x_min.temperature': 10,
    'response.pairs.0.seed.deep': 11,
  });
});

test('numbers lie where they are said to lie', () => {
  for (const text of texts) {
    const numbers = numbersOf(text);
    assert.ok(numbers.length > 0);
    for (const { from, to, value } of numbers) assert.equal(Number(text.slice(from, to).replaceAll('_', '')), value);
    assert.equal(new Set(numbers.map(({ path }) => path)).size, numbers.length);
  }
});

test('texts that are not TOML do not hang', () => {
  for (const text of ['[', '[[a', 'a = "', 'a = [', 'a = {b', '= = =', 'a = """x', ']]]', 'a = ,,,']) numbersOf(text);
});

test('sliders reach from where the schema allows', () => {
  const range = (value, isWhole, node) => Object.values(rangeOf({ value, isWhole }, node));
  assert.deepEqual(range(400, true, { multipleOf: 1, minimum: 1 }), [100, 1600, 1]);
  assert.deepEqual(range(1, true, { multipleOf: 1, minimum: 1 }), [1, 10, 1]);
  assert.deepEqual(range(0.7, false, { minimum: 0, maximum: 1 }), [0, 1, 0.01]);
  const [low, high] = range(0.5, false, { minimum: 1e-60, maximum: 1e60 });
  assert.ok(low > 0 && low < 0.1 && high === 2);
  assert.deepEqual(range(-1, false, { minimum: -1e60 }), [-4, 0, 0.01]);
  assert.deepEqual(range(0, false, { minimum: -1e60 }).slice(0, 2), [-2, 2]);
  assert.deepEqual(range(0, false, { minimum: 0 }).slice(0, 2), [0, 2]);
});

test('completion knows tables, keys and values', () => {
  const labels = (text) => completionsAt(schema, text, text.length)?.options.map(({ label }) => label) ?? [];
  assert.ok(labels('[bo').includes('[box]') && labels('[').includes('[[spheres]]'));
  assert.ok(labels('[box]\nbou').includes('boundary') && !labels('[box]\nbou').includes('placement'));
  assert.deepEqual(labels('[box]\nboundary = ["'), ['"wall"', '"periodic"', '"open"']);
  assert.deepEqual(labels('[[spheres]]\nplacement = '), ['"random"', '"fcc"', '"hexagonal"']);
  assert.ok(labels('[[spheres]]\nradius = { ').includes('distribution'));
  assert.ok(labels('[[spheres]]\nradius = { distribution = "').includes('"lognormal"'));
  assert.ok(labels('[[walls]]\nshape = "').includes('"cone"'));
  assert.ok(labels('[box.faces.x_min]\n').includes('temperature'));
  assert.deepEqual(labels('[[spheres]]\nkinematic = '), ['true', 'false']);
  assert.deepEqual(labels('[box]\nsize = '), []);
  assert.deepEqual(labels('# [bo'), []);
  const [key] = completionsAt(schema, '[run]\nunt', 9).options;
  assert.ok(key.apply === 'until = ' && key.info.length > 10);
  // What an editor has closed by itself is a part of what is replaced.
  const replaced = (text, after) => {
    const { from, closed } = completionsAt(schema, text + after, text.length);
    return text.slice(from) + closed.exec(after)[0];
  };
  assert.equal(replaced('[resp', ']\n'), '[resp]');
  assert.equal(replaced('[[sph', ']]\n'), '[[sph]]');
  assert.equal(replaced('[box]\nboundary = ["wa', '"]'), '"wa"');
  assert.equal(replaced('[[spheres]]\nkinematic = t', '\n'), 't');
});

test('links have the whole text', async () => {
  for (const text of [...texts, '', 'ä 🎱 &=#+/%']) {
    const letters = await packed(text);
    assert.match(letters, /^[\w-]*$/);
    assert.equal(await unpacked(letters), text);
    assert.ok(letters.length < text.length / 1.2 + 40);
  }
  await assert.rejects(unpacked('AAAA'));
  await assert.rejects(unpacked('*'));
  const parts = { name: 'a b', s: 'x_-1', v: 'camera=1&time=2' };
  assert.deepEqual(partsOf(fragmentOf({ ...parts, until: null })), parts);
});

test('numbers are short', () => {
  assert.equal(withError(1.61345, 0.0123), '1.613 ± 0.012');
  assert.equal(withError(-1.61345, 0), '−1.61345');
  assert.equal(withError(null, null), '–');
  assert.equal(withError(123456, 789), '123456 ± 789');
  assert.equal(withError(1.5e-9, 2.5e-10), '1.50e−9 ± 2.5e−10');
  assert.equal(shown(1 / 3), '0.333333');
  assert.equal(shown(null), '–');
  assert.equal(unitText('M L^-1 T^-2'), 'M L⁻¹ T⁻²');
  assert.equal(unitText('1'), '');
});
