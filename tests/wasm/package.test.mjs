// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The npm package, as it is built in the folder that HARDBALL_PACKAGE names, in node: in workers and in this thread.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';
import { PortSource } from '../../apps/viewer/page/src/recording/port_source.js';
import { readRecording } from '../../apps/viewer/page/src/recording/recording_file.js';

const package_ = process.env.HARDBALL_PACKAGE;
const { open, load, check, HardballError } = await import(pathToFileURL(join(package_, 'index.js')));

const kGas = `
[box]
size = [10.0, 10.0, 10.0]
boundary = ["periodic", "periodic", "periodic"]

[[spheres]]
placement = "random"
count = 200
radius = 0.4
temperature = 1.0

[run]
seed = 3
until = 2.0
`;

const kRest = `
[box]
boundary = ["open", "open", "open"]

[[spheres]]
positions = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0]]
velocities = [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]]
radius = 0.5
`;

for (const worker of [true, false]) {
  const where = worker ? 'in a worker' : 'in this thread';

  test(`a run has the same history however it is cut into slices, ${where}`, async () => {
    const hashes = [];
    for (const slice of [1000, 0.2]) {
      const gas = await open(kGas, { worker });
      assert.deepEqual(gas.box, { size: [10, 10, 10], boundary: ['periodic', 'periodic', 'periodic'] });
      assert.equal(gas.until, 2);
      let told = 0;
      const status = await gas.run({ until: gas.until, slice, onProgress: () => ++told });
      assert.equal(status.reason, 'time');
      assert.equal(status.time, 2);
      assert.ok(status.collisions > 100 && (slice > 1 || told > 2), `${status.collisions} ${told}`);
      hashes.push(status.hash);
      gas.close();
    }
    assert.equal(hashes[0], hashes[1]);
  });

  test(`what is saved goes on to the same history, ${where}`, async () => {
    const gas = await open(kGas, { worker });
    await gas.run({ until: 1 });
    const saved = await load(await gas.save(), { worker });
    const [straight, resumed] = [await gas.run({ until: 2 }), await saved.run({ until: 2 })];
    assert.deepEqual(resumed, straight);
    gas.close();
    saved.close();
  });

  test(`contacts come as columns, ${where}`, async () => {
    const pair = await open(kRest, { worker });
    assert.deepEqual(await pair.nextContact(), { time: 3, kind: 'collision', first: 0, second: 1 });
    assert.equal(await pair.nextContact(2.5), null);
    await pair.keepContacts(true);
    await pair.run({ until: 10 });
    const contacts = await pair.contacts();
    assert.equal(contacts.length, 1);
    assert.deepEqual([...contacts.time], [3]);
    assert.deepEqual([...contacts.kind], [1]);
    assert.deepEqual([contacts.first[0], contacts.second[0]], [0, 1]);
    assert.deepEqual([...contacts.point], [3.5, 0, 0]);
    assert.deepEqual([...contacts.normal], [1, 0, 0]);
    assert.deepEqual([...contacts.impulse], [-1, 0, 0]);
    assert.deepEqual([...contacts.impactSpeed], [1]);
    assert.equal((await pair.contacts()).length, 0);
    pair.close();
  });

  test(`arrays are given and come back, ${where}`, async () => {
    const pair = await open(kRest, { worker });
    await pair.run({ until: 1 });
    assert.deepEqual([...(await pair.positions())], [1, 0, 0, 4, 0, 0]);
    const given = new Float32Array(6);
    const { buffer } = given;
    const back = await pair.positions(given);
    assert.ok(back instanceof Float32Array);
    assert.deepEqual([...back], [1, 0, 0, 4, 0, 0]);
    assert.equal(buffer.byteLength, worker ? 0 : 24, 'with a worker it moves');
    assert.deepEqual([...(await pair.radii())], [0.5, 0.5]);
    assert.deepEqual([...(await pair.ids())], [0, 1]);
    assert.deepEqual([...(await pair.species())], [0, 0]);
    pair.close();
  });

  test(`spheres are added, removed, driven and hit by rays, ${where}`, async () => {
    const pair = await open(kRest, { worker });
    await pair.setVelocities([0], [0, 1, 0]);
    assert.deepEqual([...(await pair.velocities())], [0, 1, 0, 0, 0, 0]);
    assert.equal(await pair.add({ position: [0, 5, 0], radius: 1, mass: 2 }), 2);
    assert.deepEqual(await pair.nextContact(), { time: 3.5, kind: 'collision', first: 0, second: 2 });
    const [hit, miss] = await pair.rays([0, -2, 0, 0, -2, 0], [0, 2, 0, 0, -1, 0]);
    assert.equal(miss, null);
    assert.deepEqual(hit, { kind: 'collision', body: 0, distance: 1.5, point: [0, -0.5, 0], normal: [0, -1, 0] });
    await pair.remove(2);
    assert.equal((await pair.status()).spheres, 2);
    assert.equal((await pair.totals()).mass, 2);
    await assert.rejects(pair.remove(2), HardballError);
    await assert.rejects(pair.setVelocities([0], [1, 2]), /3|three/);
    pair.close();
  });

  test(`errors have a place and a remedy, ${where}`, async () => {
    const bad = kGas.replace('radius = 0.4', 'radius = -0.4');
    const error = await check(bad, { worker, name: 'gas.toml' });
    assert.ok(error instanceof HardballError);
    assert.match(error.where, /^gas\.toml:9:\d+$/);
    assert.equal(error.place.line, 9);
    assert.match(error.problem, /-0\.4/);
    assert.ok(error.remedy.length > 0);
    assert.equal(error.message, `${error.where}: ${error.problem}; ${error.remedy}`);
    assert.equal(await check(kGas, { worker }), null);
    assert.equal((await check(kGas, { worker, values: { 'run.seed': -1 } })).place, null);
    await assert.rejects(open(kGas, { worker, engine: 'none' }), /there is no engine 'none'/);
    await assert.rejects(load(new Uint8Array(100), { worker }), HardballError);
    const gas = await open(kGas, { worker });
    await assert.rejects(gas.run({ until: -1 }), HardballError);
    assert.equal((await gas.run({ until: 0.1 })).time, 0.1);
    gas.close();
  });

  test(`runs are measured, ${where}`, async () => {
    const gas = await open(kGas, { worker, values: { 'measures.names': ['temperature', 'radial_distribution'] } });
    await assert.rejects(gas.measures(), HardballError);
    await gas.keepMeasures(true);
    const plain = await open(kGas, { worker });
    const { hash } = await gas.run({ until: 2 });
    assert.equal(hash, (await plain.run({ until: 2 })).hash);
    const [temperature, distribution, ...others] = await gas.measures();
    assert.equal(others.length, 0);
    assert.equal(temperature.name, 'temperature');
    const { value, theory } = temperature.quantities.find(({ name }) => name === 'temperature');
    assert.ok(Math.abs(value - 1) < 0.2 && theory !== undefined, `${value}`);
    assert.equal(temperature.duration, 2);
    const [radius, g] = distribution.columns;
    assert.deepEqual([radius.role, g.role], ['argument', 'value']);
    assert.ok(radius.values.length === g.values.length && g.values.some((each) => each > 1));
    await assert.rejects(gas.add({ position: [1, 1, 1] }), /measured/);
    gas.close();
    plain.close();
  });

  test(`runs are recorded, and the recording is served while it grows, ${where}`, async () => {
    const gas = await open(kGas, { worker });
    await assert.rejects(gas.recording(), /there is no recording/);
    await gas.beginRecording();
    const { port1, port2 } = new MessageChannel();
    await gas.serveRecording(port1);
    const source = new PortSource(port2);
    await source.open();
    assert.deepEqual([source.header.spheres, source.radii[7], source.masses[199]], [200, 0.4, 1]);
    assert.deepEqual([source.ends.length, source.status.finished], [0, false]);
    const { hash, collisions } = await gas.run({ until: 2 });
    await source.poll();
    const { finished, reached, event_log_hash } = source.status;
    assert.deepEqual([finished, reached, event_log_hash], [false, 2, hash]);
    const known = source.ends.length;
    assert.ok(known > 0 && source.ends.at(-1) < 2);
    await gas.endRecording();
    await source.poll();
    assert.ok(source.status.finished && source.ends.at(-1) === 2 && source.ends.length > known);
    let contacts = 0;
    for (let number = 0; number < source.ends.length; ++number) contacts += (await source.chunk(number)).contacts;
    assert.equal(contacts, collisions);
    await assert.rejects(source.chunk(source.ends.length));
    const whole = readRecording((await gas.recording()).buffer);
    assert.equal(whole.damage, null);
    assert.deepEqual(whole.chunks.map(({ end }) => end), source.ends);
    gas.close();
    port2.close();
  });

  test(`a run is stopped between slices, ${where}`, async () => {
    const gas = await open(kGas, { worker });
    const abort = new AbortController();
    const status = await gas.run({ until: 1e6, signal: abort.signal, onProgress: () => abort.abort() });
    assert.equal(status.reason, 'stopped');
    assert.ok(status.time < 1e6);
    await assert.rejects(gas.run({ signal: AbortSignal.abort() }), { name: 'AbortError' });
    const running = gas.run({ until: 1e6 });
    assert.ok((await gas.status()).time >= status.time);
    await gas.stop();
    assert.equal((await running).reason, 'stopped');
    gas.close();
  });
}

test('scenarios read the files that are given', async () => {
  const folder = new URL('../../scenarios/', import.meta.url);
  const text = readFileSync(new URL('hourglass.toml', folder), 'utf8');
  const mesh = readFileSync(new URL('hourglass.obj', folder));
  // In this thread they share one memory, where files stay for no other scenario.
  for (const worker of [true, false]) {
    for (let time = 0; time < 2; ++time) {
      const error = await check(text, { worker });
      assert.match(error.problem + error.where, /hourglass\.obj/);
      assert.doesNotMatch(error.message, /\/scenario\//, 'names are those that were given');
      const glass = await open(text, { worker, files: { 'hourglass.obj': mesh } });
      assert.ok((await glass.run({ contacts: 500 })).wallContacts > 0);
      glass.close();
    }
  }
});

test('the package is installed into an empty project, and found with its types', () => {
  const folder = mkdtempSync(join(tmpdir(), 'hardball_package_'));
  const run = (command, parts) => execFileSync(command, parts, { cwd: folder, encoding: 'utf8', stdio: 'pipe' });
  const [{ filename, files }] = JSON.parse(run('npm', ['pack', '--json', package_]));
  for (const name of ['index.js', 'index.d.ts', 'module.wasm', 'module.js', 'worker.js', 'README.md', 'LICENSE'])
    assert.ok(files.some(({ path }) => path === name), `${name} is in the package`);
  writeFileSync(join(folder, 'package.json'), '{ "type": "module", "private": true }');
  run('npm', ['install', '--offline', '--no-audit', '--no-fund', join(folder, filename)]);
  writeFileSync(
    join(folder, 'try.js'),
    `import { open } from 'hardball';
     const gas = await open(${JSON.stringify(kGas)});
     console.log((await gas.run({ until: 2 })).hash);
     gas.close();`,
  );
  const hash = run('node', ['try.js']);
  assert.match(hash, /^[0-9a-f]{16}\n$/);
  // The program of the docs runs the same gas.
  const page = readFileSync(new URL('../../docs/webassembly.md', import.meta.url), 'utf8');
  const [, program] = page.match(/```js\n(.*?)```/s);
  writeFileSync(join(folder, 'documented.js'), `${program}console.log(hash, positions.length);`);
  assert.equal(run('node', ['documented.js']), `${hash.trim()} 600\n`);
  copyFileSync(new URL('use.mts', import.meta.url), join(folder, 'use.mts'));
  const compiler = join(process.env.HARDBALL_TEST_PACKAGES, 'node_modules/typescript/bin/tsc');
  const options = '--noEmit --strict --target es2022 --module nodenext --lib es2022,dom use.mts';
  assert.equal(run('node', [compiler, ...options.split(' ')]), '');
});
