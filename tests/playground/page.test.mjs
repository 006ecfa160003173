// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The playground, in the folder that HARDBALL_PLAYGROUND names, in a browser that gets it as static files.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { join } from 'node:path';
import test, { after, before } from 'node:test';
import { Browser } from '../viewer/support/browser.mjs';

const folder = process.env.HARDBALL_PLAYGROUND;
const kTypes = { html: 'text/html', js: 'text/javascript', css: 'text/css', json: 'application/json', wasm: 'application/wasm' };

const kGas = `[box]
size = [10.0, 10.0, 10.0] # kept
boundary = ["periodic", "periodic", "periodic"]
[[spheres]]
count = 100
radius = 0.4
placement = "random"
temperature = 1.0
[measures]
names = ["temperature", "pressure"]
[run]
until = 2.0
`;

let server;
let browser;
let address;

before(async () => {
  server = createServer(async ({ url }, response) => {
    const path = new URL(url, 'http://localhost').pathname.replace(/\/$/, '/index.html');
    try {
      const content = await readFile(join(folder, path));
      response.writeHead(200, { 'content-type': kTypes[path.split('.').at(-1)] ?? 'text/plain' }).end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  address = `http://127.0.0.1:${server.address().port}/`;
  browser = await Browser.launch();
});

after(async () => {
  await browser?.close();
  server?.close();
});

async function whenReady(page) {
  await page.waitForFunction(() => document.getElementById('run')?.disabled === false);
}

async function openPlayground(fragment = '', options = {}) {
  const page = await browser.openPage(address + fragment, options);
  await whenReady(page);
  return page;
}

async function close(page) {
  assert.deepEqual(page.errors, []);
  await page.context().close();
}

function textOf(page) {
  return page.evaluate(() => window.playground.editor.text);
}

// As a user does.
async function replaceText(page, text) {
  await page.click('.cm-content');
  await page.keyboard.press('Control+A');
  await page.keyboard.insertText(text);
}

async function whenState(page, state) {
  await page.waitForFunction((wanted) => document.body.dataset.state === wanted, state);
}

// Begins a run by `begin`, and waits for its end.
async function runToEnd(page, begin = () => page.click('#run')) {
  await page.evaluate(() => (window.before = window.playground.run));
  await begin();
  await page.waitForFunction(() => window.playground.run && window.playground.run !== window.before && window.playground.state === 'ended');
}

async function viewerOf(page) {
  const frame = await (await page.waitForSelector('#viewer iframe')).contentFrame();
  await frame.waitForFunction(() => window.hardball?.state().isReady);
  return frame;
}

async function downloadedBy(page, id) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(`#${id}`)]);
  return { name: download.suggestedFilename(), content: await readFile(await download.path()) };
}

test('a scenario is run, watched, measured and saved', async () => {
  const page = await openPlayground();
  const text = kGas.replace('until = 2.0', 'until = 60.0');
  await replaceText(page, text);
  await page.waitForFunction(() => document.getElementById('until').value === '60');
  await page.click('#run');
  await whenState(page, 'ended');
  const viewer = await viewerOf(page);
  await viewer.waitForFunction(() => window.hardball.state().status.finished);
  await viewer.evaluate(() => window.hardball.setTime(60));
  const { spheres, knownEnd, status } = await viewer.evaluate(() => window.hardball.state());
  assert.deepEqual([spheres, knownEnd, status.event_log_hash], [100, 60, await page.textContent('#hash')]);
  assert.match(await page.textContent('#status'), /^Finished at time 60 of 60: 100 spheres, [\d,]+ collisions$/);
  await page.waitForSelector('#measures tbody');
  const table = await page.innerText('#measures');
  assert.match(table, /Temperature[\s\S]*temperature\s+[\d.]+/i);
  assert.match(table, /compressibility\s+[\d.]+ ± [\d.]+\s+1\.\d+/);

  assert.deepEqual(await downloadedBy(page, 'save-scenario'), { name: 'bouncing_heap.toml', content: Buffer.from(text) });
  const recording = await downloadedBy(page, 'save-recording');
  assert.equal(recording.name, 'bouncing_heap.hbr');
  assert.equal(recording.content.subarray(0, 8).toString(), 'HBREC003');
  const summary = JSON.parse((await downloadedBy(page, 'save-summary')).content);
  assert.equal(summary.event_log_hash.replace('0x', ''), status.event_log_hash);
  assert.deepEqual([summary.time, summary.spheres, summary.scenario.text], [60, 100, text]);
  const report = (await downloadedBy(page, 'save-report')).content.toString();
  assert.match(report, /^<!DOCTYPE html>/i);
  assert.match(report, /compressibility/i);
  await page.click('#show-report');
  const inside = await (await page.waitForSelector('#report-page')).contentFrame();
  await inside.waitForSelector('h1');
  await page.click('#report .close');
  await page.waitForSelector('#report', { state: 'hidden' });
  await close(page);
});

test('a run is paused, goes on to the same history, and is stopped', async () => {
  const page = await openPlayground('#scenario=dense_gas');
  await page.fill('#until', '4');
  await page.uncheck('#measure');
  await page.click('#run');
  // From within the page, which is sooner than the end of the run.
  await page.waitForFunction(() => {
    const hasBegun = window.playground.run?.status?.collisions > 0;
    if (hasBegun) document.getElementById('run').click();
    return hasBegun;
  });
  await whenState(page, 'paused');
  assert.equal(await page.textContent('#run'), 'Go on');
  await page.click('#run');
  await whenState(page, 'ended');
  const hash = await page.textContent('#hash');
  await runToEnd(page);
  assert.equal(await page.textContent('#hash'), hash);
  await page.fill('#until', '100');
  assert.equal(await page.textContent('#run'), 'Run');
  await page.click('#run');
  await whenState(page, 'running');
  await page.click('#stop');
  await whenState(page, 'ended');
  assert.match(await page.textContent('#status'), /^Stopped at time/);
  const viewer = await viewerOf(page);
  await viewer.waitForFunction(() => window.hardball.state().status.finished);
  await close(page);
});

test('every scenario has its native hash', async () => {
  const page = await openPlayground();
  await page.uncheck('#measure');
  const names = await page.$$eval('#scenario option', (options) => options.map(({ value }) => value).filter(Boolean));
  assert.ok(names.length > 20);
  for (const name of names) {
    await page.selectOption('#scenario', name);
    await page.waitForFunction((wanted) => location.hash === `#scenario=${wanted}`, name);
    await page.click('#run');
    const words = await page.waitForFunction(() => document.getElementById('comparison').textContent || document.getElementById('failure').textContent);
    assert.equal(`${name}: ${await words.jsonValue()}`, `${name}: the same as natively`);
  }
  await close(page);
});

test('errors are marked where they are, and say what would be accepted', async () => {
  const page = await openPlayground();
  await replaceText(page, kGas.replace('radius = 0.4', 'radius = -0.4'));
  await page.waitForSelector('#problem');
  assert.equal(await page.textContent('#problem-place'), 'Line 6');
  assert.match(await page.textContent('#problem-text'), /-0\.4.*;/);
  const marked = await page.textContent('.cm-lintRange-error');
  assert.match(marked, /-0\.4$/);
  await page.click('#problem-place');
  assert.equal(await page.evaluate(() => window.playground.editor.view.state.doc.lineAt(window.playground.editor.view.state.selection.main.head).number), 6);
  await page.click('#run');
  await page.waitForSelector('#failure');
  assert.match(await page.textContent('#failure'), /:6:\d+: .*-0\.4/);
  await replaceText(page, kGas);
  await page.waitForSelector('#problem', { state: 'hidden' });
  await replaceText(page, kGas.replace('until = 2.0', ''));
  await page.waitForFunction(() => document.getElementById('until').value === '');
  await page.click('#run');
  await page.waitForFunction(() => document.getElementById('failure').textContent.includes('does not say when it ends'));
  await close(page);
});

test('keys and values are completed', async () => {
  const page = await openPlayground();
  await replaceText(page, '[box]\n');
  await page.keyboard.type('boun');
  await page.waitForSelector('.cm-tooltip-autocomplete');
  assert.match(await page.textContent('.cm-tooltip-autocomplete'), /boundary/);
  assert.match(await page.textContent('.cm-completionInfo'), /boundaries of the box/);
  await page.waitForTimeout(200); // CodeMirror ignores keys that come too soon
  await page.keyboard.press('Enter');
  assert.equal(await textOf(page), '[box]\nboundary = ');
  // The editor closes brackets and quotation marks by itself.
  await page.keyboard.type('["');
  await page.waitForSelector('.cm-tooltip-autocomplete');
  await page.keyboard.type('p');
  await page.waitForTimeout(400);
  await page.keyboard.press('Enter');
  assert.equal(await textOf(page), '[box]\nboundary = ["periodic"]');
  await replaceText(page, '');
  await page.keyboard.type('[');
  await page.waitForSelector('.cm-tooltip-autocomplete');
  await page.keyboard.type('o');
  await page.waitForTimeout(400);
  await page.keyboard.press('Enter');
  assert.match(await textOf(page), /^\[{1,2}o[a-z]+\]{1,2}$/);
  await close(page);
});

test('sliders edit the numbers of the text, and nothing else', async () => {
  const page = await openPlayground();
  await replaceText(page, kGas);
  const slide = (path, value) =>
    page.$eval(
      `#sliders input[data-path="${path}"]`,
      (input, wanted) => {
        input.value = wanted;
        input.dispatchEvent(new Event('input', { bubbles: true }));
      },
      value,
    );
  await slide('spheres.0.count', '57');
  await slide('box.size.1', '12.5');
  await slide('spheres.0.temperature', '2');
  const expected = kGas.replace('count = 100', 'count = 57').replace('10.0, 10.0, 10.0', '10.0, 12.5, 10.0').replace('temperature = 1.0', 'temperature = 2.0');
  assert.equal(await textOf(page), expected);
  // What is typed moves the slider.
  await replaceText(page, kGas.replace('count = 100', 'count = 70'));
  assert.equal(await page.inputValue('#sliders input[data-path="spheres.0.count"]'), '70');
  // By keys.
  await page.focus('#sliders input[data-path="spheres.0.count"]');
  await page.keyboard.press('ArrowRight');
  assert.match(await textOf(page), /count = 71\n/);

  await page.click('#run');
  await whenState(page, 'ended');
  await page.check('#at-once');
  await slide('spheres.0.count', '60');
  await page.waitForFunction(() => /: 60 spheres/.test(document.getElementById('status').textContent));
  await whenState(page, 'ended');
  await close(page);
});

test('a link has the whole scenario', async () => {
  const page = await openPlayground();
  await replaceText(page, kGas);
  // The end in the text and the one beside the button are one.
  await page.fill('#until', '1.5');
  const edited = kGas.replace('until = 2.0', 'until = 1.5');
  assert.equal(await textOf(page), edited);
  await page.click('#share');
  await page.waitForSelector('#link[open]');
  const link = await page.inputValue('#address');
  assert.ok(link.startsWith(`${address}#`) && link.length < 1000, link);
  await page.click('#link .close');
  // The address of the page itself keeps it, too.
  await page.waitForFunction(() => location.hash.includes('s='));
  for (let time = 0; time < 2; ++time) {
    await page.reload();
    await whenReady(page);
    assert.equal(await textOf(page), edited);
  }
  await close(page);

  const other = await openPlayground(new URL(link).hash);
  assert.equal(await textOf(other), edited);
  await other.waitForFunction(() => document.getElementById('until').value === '1.5');
  await other.goto(`${address}#s=AAAA`);
  await other.waitForFunction(() => document.getElementById('alert').textContent.includes('The link is damaged'));
  await close(other);

  const third = await openPlayground('#scenario=two_spheres');
  assert.match(await textOf(third), /count = 2/);
  await close(third);
});

test('the viewer plays at once, and looks as it did before and as a link says', async () => {
  const page = await openPlayground('#scenario=newtons_cradle&v=color%3Dlast%2Bcontact');
  await page.click('#run');
  const viewer = await viewerOf(page);
  await viewer.waitForFunction(() => window.hardball.state().isPlaying && window.hardball.state().time > 0);
  // The address of the frame shows nothing by itself.
  assert.ok(await viewer.locator('#copy-link').isHidden());
  assert.equal((await viewer.evaluate(() => window.hardball.state())).colorBy, 'last contact');
  await viewer.selectOption('#color-by', 'collisions');
  await viewer.waitForFunction(() => location.hash.includes('color=collisions'));
  await page.click('#share');
  await page.waitForSelector('#link[open]');
  assert.match(decodeURIComponent(await page.inputValue('#address')), /v=.*color=collisions/);
  await page.click('#link .close');
  await runToEnd(page);
  const next = await viewerOf(page);
  await next.waitForFunction(() => window.hardball.state().colorBy === 'collisions');
  await page.selectOption('#scenario', 'two_spheres');
  await runToEnd(page);
  const other = await viewerOf(page);
  assert.notEqual((await other.evaluate(() => window.hardball.state())).colorBy, 'collisions');
  await close(page);
});

test('what was changed last says when a run ends', async () => {
  const page = await openPlayground('#scenario=dense_gas&until=3');
  assert.equal(await page.inputValue('#until'), '3');
  const slider = page.locator('#sliders input[data-path="run.until"]');
  await slider.evaluate((input) => {
    input.value = 2;
    input.dispatchEvent(new Event('input'));
  });
  await page.waitForFunction(() => document.getElementById('until').value === '2');
  await page.fill('#until', '8');
  assert.match(await textOf(page), /^until = 8$/m);
  await page.fill('#until', '.5');
  assert.match(await textOf(page), /^until = 0.5$/m);
  await page.fill('#until', '8');
  await page.waitForFunction(() => document.querySelector('#sliders input[data-path="run.until"]').value === '8');
  await close(page);
});

test('what is edited stays when another scenario is chosen', async () => {
  const page = await openPlayground('#scenario=dense_gas');
  await replaceText(page, kGas);
  await page.selectOption('#scenario', 'two_spheres');
  assert.notEqual(await textOf(page), kGas);
  const other = kGas.replace('count = 100', 'count = 90');
  await replaceText(page, other);
  for (const [number, text] of [[0, kGas], [1, other], [0, kGas]]) {
    await page.selectOption('#scenario', `yours ${number}`);
    assert.equal(await textOf(page), text);
  }
  assert.equal(await page.locator('#yours option').count(), 2);
  await close(page);
});

test('a run that cannot begin shows why, and begins when that is mended', async () => {
  const page = await openPlayground('#scenario=newtons_cradle', { width: 390, height: 844, hasTouch: true });
  await page.click('#parts button[data-part="sliders"]');
  await page.check('#at-once');
  await page.click('#parts button[data-part="scenario"]');
  await replaceText(page, kGas.replace('radius = 0.4', 'radius = -0.4'));
  await page.waitForSelector('#problem');
  await page.click('#run');
  await page.waitForFunction(() => document.body.dataset.part === 'scenario');
  assert.ok(await page.isVisible('#problem'));
  await replaceText(page, kGas);
  await whenState(page, 'ended');
  assert.match(await page.textContent('#status'), /^Finished/);
  await close(page);
});

test('on a phone, parts are shown one at a time, and nothing is wider than the screen', async () => {
  const page = await openPlayground('#scenario=newtons_cradle', { width: 360, height: 640, pixelRatio: 2 });
  const isWide = () => page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
  const shownParts = () => page.$$eval('.part', (parts) => parts.filter((part) => part.offsetHeight > 0).map((part) => part.dataset.part));
  for (const part of ['sliders', 'spheres', 'results', 'scenario']) {
    await page.click(`#parts button[data-part="${part}"]`);
    assert.deepEqual(await shownParts(), [part]);
    assert.equal(await isWide(), false, part);
  }
  await page.click('#run');
  assert.deepEqual(await shownParts(), ['spheres']);
  await viewerOf(page);
  await page.click('#parts button[data-part="results"]');
  await page.waitForSelector('#measures tbody');
  assert.equal(await isWide(), false);
  await close(page);
});

test('all is reached by keys', async () => {
  const page = await openPlayground();
  await page.keyboard.press('Tab');
  const focused = () => page.evaluate(() => document.activeElement.id);
  const goTo = async (id, key = 'Tab') => {
    for (let step = 0; step < 100 && (await focused()) !== id; ++step) await page.keyboard.press(key);
    assert.equal(await focused(), id);
  };
  await goTo('scenario');
  await page.keyboard.type('Two');
  await page.waitForFunction(() => location.hash === '#scenario=two_spheres');
  await goTo('until');
  await page.keyboard.press('Control+A');
  await page.keyboard.type('20');
  await goTo('run', 'Shift+Tab');
  await runToEnd(page, () => page.keyboard.press('Enter'));
  await goTo('show-report');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#report[open]');
  await page.keyboard.press('Escape');
  await page.waitForSelector('#report', { state: 'hidden' });
  // From within the editor.
  await page.evaluate(() => window.playground.editor.view.focus());
  await runToEnd(page, () => page.keyboard.press('Control+Enter'));
  await close(page);
});

test('what has been loaded once works without a network', async () => {
  const page = await openPlayground();
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForFunction(() => navigator.serviceWorker.controller);
  await page.context().setOffline(true);
  await page.goto(`${address}#scenario=hourglass`);
  await page.reload();
  await whenReady(page);
  await page.fill('#until', '0.5');
  await page.click('#run');
  await viewerOf(page);
  await whenState(page, 'ended');
  await page.context().close();
});

test('lessons are shown beside their scenario', async (context) => {
  const page = await openPlayground();
  const lessons = await page.$$eval('#lesson option', (options) => options.map(({ value }) => value).filter(Boolean));
  if (lessons.length === 0) {
    await close(page);
    return context.skip('there are no lessons');
  }
  for (const lesson of lessons) {
    await page.selectOption('#lesson', lesson);
    await page.waitForFunction((wanted) => location.hash === `#lesson=${wanted}`, lesson);
    assert.ok((await page.innerText('#lesson-text')).length > 100, lesson);
    assert.equal(await page.isVisible('#problem'), false, `${lesson}: ${await page.textContent('#problem-text')}`);
  }
  await page.selectOption('#lesson', '');
  assert.equal(await page.isVisible('#lesson-text'), false);
  await close(page);
});

test('colors are those of the system, and what lacks a feature says so', async () => {
  const page = await openPlayground('', { scheme: 'dark' });
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(22, 26, 32)');
  await close(page);
  const context = await browser.browser.newContext();
  const old = await context.newPage();
  await old.addInitScript(() => (WebAssembly.validate = () => false));
  await old.goto(address);
  await old.waitForFunction(() => /lacks vectors in WebAssembly/.test(document.getElementById('alert').textContent));
  await context.close();
});

test('figures of this machine', async (context) => {
  const page = await openPlayground('#scenario=paper', { width: 1280, height: 800 });
  const paints = await page.evaluate(() => performance.getEntriesByType('paint').map(({ name, startTime }) => `${name} ${Math.round(startTime)} ms`));
  await page.click('#run');
  const viewer = await viewerOf(page);
  await whenState(page, 'ended');
  context.diagnostic(paints.join(', '));
  for (const quality of ['reduced', 'points', 'coarse']) {
    const { spheres, framesPerSecond } = await viewer.evaluate(async (wanted) => {
      window.hardball.setQuality(wanted);
      await window.hardball.setTime(0);
      window.hardball.play();
      await new Promise((resolve) => setTimeout(resolve, 5000));
      return window.hardball.state();
    }, quality);
    assert.equal(spheres, 10000);
    context.diagnostic(`${spheres} spheres, quality ${quality}: ${framesPerSecond.toFixed(1)} pictures a second`);
  }
  await close(page);
});
