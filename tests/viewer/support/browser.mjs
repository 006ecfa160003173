// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { createRequire } from 'node:module';
import { join } from 'node:path';

// The build installs packages in a separate folder; otherwise they are beside the tests.
const packages = process.env.HARDBALL_TEST_PACKAGES;
const { chromium } = createRequire(packages ? join(packages, 'package.json') : import.meta.url)(
  'playwright-core',
);

const kArguments = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
];
const kPatience = 120_000; // milliseconds; far longer than anything takes

/** A browser with an emulated graphics card, so that it draws the same everywhere. */
export class Browser {
  static async launch() {
    const executablePath = process.env.HARDBALL_CHROMIUM ?? '/usr/bin/chromium';
    return new Browser(await chromium.launch({ executablePath, args: kArguments, timeout: kPatience }));
  }

  constructor(browser) {
    this.browser = browser;
  }

  close() {
    return this.browser.close();
  }

  /** Opens `url`, and returns the page. Errors are listed in `page.errors`. */
  async openPage(
    url,
    { width = 1000, height = 700, scheme = 'light', pixelRatio = 1, reducedMotion = 'no-preference', hasTouch = false } = {},
  ) {
    const context = await this.browser.newContext({
      viewport: { width, height },
      colorScheme: scheme,
      deviceScaleFactor: pixelRatio,
      reducedMotion,
      hasTouch,
      isMobile: hasTouch,
      acceptDownloads: true,
    });
    const page = await context.newPage();
    page.setDefaultTimeout(kPatience);
    page.errors = [];
    page.on('pageerror', (error) => page.errors.push(error.message));
    page.on('console', (message) => message.type() === 'error' && page.errors.push(message.text()));
    await page.goto(url);
    return page;
  }

  /** Opens the viewer at `url`, and returns its page once it shows the first frame; `options`: as for openPage. */
  async open(url, options) {
    const page = await this.openPage(url, options);
    await page.waitForFunction(() => window.hardball?.state().isReady);
    // Tests use the best quality, however slow the machine.
    await page.evaluate(() => window.hardball.setQuality('full'));
    return page;
  }

  /** A screenshot of `page`: {width, height, data}, four bytes per pixel. */
  async pixels(page) {
    const image = (await page.screenshot()).toString('base64');
    this.decoder ??= await this.browser.newPage();
    const { width, height, data } = await this.decoder.evaluate(async (image) => {
      const bytes = Uint8Array.from(atob(image), (letter) => letter.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext('2d');
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      let text = '';
      for (let start = 0; start < data.length; start += 8192)
        text += String.fromCharCode(...data.subarray(start, start + 8192));
      return { width: bitmap.width, height: bitmap.height, data: btoa(text) };
    }, image);
    return { width, height, data: Buffer.from(data, 'base64') };
  }
}

/** The middle of all pixels within `box` {x, y, width, height} of which `isMeant(red, green, blue)`, and how many. */
export function middleOf({ width, data }, box, isMeant) {
  let [count, x, y] = [0, 0, 0];
  for (let row = Math.ceil(box.y); row < box.y + box.height; ++row) {
    for (let column = Math.ceil(box.x); column < box.x + box.width; ++column) {
      const place = 4 * (row * width + column);
      if (!isMeant(data[place], data[place + 1], data[place + 2])) continue;
      ++count;
      x += column + 0.5;
      y += row + 0.5;
    }
  }
  return { count, x: x / count, y: y / count };
}
