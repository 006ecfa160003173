// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Makes the pictures of the gallery, docs/figures/gallery, of the runs in docs/site/gallery.json:
// HARDBALL_PROGRAM=build/release/hardball node thumbnails.mjs [SCENARIO...]
// Needs cwebp (Debian's webp) in addition to what the tests need.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Browser } from './support/browser.mjs';
import { run, withFolder } from './support/program.mjs';

const kRoot = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
const kFigures = join(kRoot, 'docs', 'figures', 'gallery');
// The picture alone, without controls.
const kStyle = 'body > :not(main), main > :not(canvas) { display: none !important; } main { position: fixed !important; inset: 0; }';

const wanted = process.argv.slice(2);
const browser = await Browser.launch();
mkdirSync(kFigures, { recursive: true });
for (const { scenario, settings, time } of JSON.parse(readFileSync(join(kRoot, 'docs', 'site', 'gallery.json')))) {
  if (wanted.length > 0 && !wanted.includes(scenario)) continue;
  await withFolder(async (folder) => {
    const file = join(folder, 'replay.html');
    const options = settings.flatMap((setting) => ['--set', setting]);
    await run('replay', join(kRoot, 'scenarios', `${scenario}.toml`), '--out', file, '--quiet', ...options);
    const page = await browser.open(pathToFileURL(file).href, { width: 640, height: 480, scheme: 'light' });
    await page.addStyleTag({ content: kStyle });
    await page.evaluate((moment) => window.hardball.setTime(moment), time);
    await page.click('canvas', { position: { x: 3, y: 3 } });
    // The focus would have an outline.
    await page.keyboard.press('f');
    await page.evaluate(() => document.activeElement.blur());
    await page.waitForTimeout(1500);
    const picture = join(folder, 'picture.png');
    await page.screenshot({ path: picture });
    execFileSync('cwebp', ['-quiet', '-q', '75', '-m', '6', picture, '-o', join(kFigures, `${scenario}.webp`)]);
    await page.context().close();
  });
}
await browser.close();
