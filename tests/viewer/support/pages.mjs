// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Pages in the one browser that all tests of a file share.
import assert from 'node:assert/strict';
import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { after } from 'node:test';
import { pathToFileURL } from 'node:url';
import { Browser } from './browser.mjs';
import { run, view, withFolder, writeScenario } from './program.mjs';

export const browser = await Browser.launch();
after(() => browser.close());

/** A page for `work(page)`, closed at the end; it must have reported no errors. */
async function withPage(opening, work) {
  const page = await opening;
  try {
    await work(page);
    assert.deepEqual(page.errors, []);
  } finally {
    await page.context().close();
  }
}

/** The page saved as `file`, such as a replay, for `work(page)`; `options`: as for Browser.openPage. */
export function withSaved(file, work, options) {
  return withPage(browser.open(pathToFileURL(file).href, options), work);
}

/** A page without the viewer, such as a report. */
export function withDocument(file, work, options) {
  return withPage(browser.openPage(pathToFileURL(file).href, options), work);
}

/** The page of the program that views `what`, with the options `words`, for `work(page, program)`. */
export async function withView(what, work, { words = [], ...options } = {}) {
  const program = await view(what, ...words);
  try {
    await withPage(browser.open(program.url, options), (page) => work(page, program));
  } finally {
    await program.stop();
  }
}

/** Shows a recording of these bytes. */
export function withRecording(bytes, work, options) {
  return withFolder(async (folder) => {
    await writeFile(join(folder, 'recording.hbr'), Buffer.from(bytes));
    await withView(folder, work, options);
  });
}

/** Runs a scenario to its end, and calls `work(out, folder)` with the folder of the run, and one for other files. */
export function withOutput(scenario, work) {
  return withFolder(async (folder) => {
    const out = join(folder, 'out');
    await run('run', await writeScenario(folder, scenario), '--out', out, '--quiet');
    await work(out, folder);
  });
}

/** What the page says of itself. */
export const state = (page) => page.evaluate(() => window.hardball.state());
export const setTime = (page, time) => page.evaluate((time) => window.hardball.setTime(time), time);
export const follow = (page, id) => page.evaluate((id) => window.hardball.follow(id), id);
export const setQuality = (page, way) => page.evaluate((way) => window.hardball.setQuality(way), way);

/** The colors of the first two species. */
export const isBlue = (red, green, blue) => blue > red + 25;
export const isOrange = (red, green, blue) => red > blue + 60;
