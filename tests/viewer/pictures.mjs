// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Makes the pictures of the viewer in docs/figures: HARDBALL_PROGRAM=build/release/hardball node pictures.mjs [NAME...]
// Needs pngquant and img2webp (Debian's webp) in addition to what the tests need.
import { execFileSync } from 'node:child_process';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Browser } from './support/browser.mjs';
import { run, view, withFolder } from './support/program.mjs';

const kRoot = join(dirname(fileURLToPath(import.meta.url)), '..', '..');

const kPictures = {
  // The experiment of the paper.
  viewer_paper: {
    scenario: 'paper.toml',
    settings: ['--until', '4'],
    scheme: 'light',
    async prepare(page) {
      await page.evaluate(() => window.hardball.setTime(3));
    },
    movie: { frames: 40, from: 1, step: 0.02, milliseconds: 60 },
  },
  // Spheres that fill 54.5% of a periodic box stay on the sites of their crystal.
  viewer_crystal: {
    scenario: 'dense_gas.toml',
    settings: ['--until', '1', '--set', 'box.size=[15.66,15.66,15.66]'],
    scheme: 'dark',
    async prepare(page) {
      await page.selectOption('#color-by', 'last contact');
      await page.evaluate(() => window.hardball.setTime(0.8));
    },
  },
  // A gas that loses energy in each collision does not stay uniform: its spheres form clusters.
  viewer_cluster: {
    scenario: 'granular_gas.toml',
    settings: [
      ...['--until', '900', '--set', 'response.restitution=0.7'],
      ...['--set', 'spheres.0.count=8000', '--set', 'box.size=[60,60,12]'],
    ],
    scheme: 'light',
    async prepare(page) {
      await page.evaluate(() => window.hardball.setTime(900));
    },
  },
  // Grains in a tube above a floor that oscillates.
  viewer_shaken: {
    scenario: 'shaken_cylinder.toml',
    settings: ['--until', '10'],
    scheme: 'light',
    async prepare(page) {
      await page.evaluate(() => window.hardball.setTime(8));
    },
  },
  // Discs that fill 80% of the plane stay on the sites of their crystal.
  viewer_discs: {
    scenario: 'disc_crystal.toml',
    settings: ['--until', '1', '--set', 'box.size=[20.0, 17.3205]', '--set', 'spheres.0.count=400'],
    scheme: 'light',
    async prepare(page) {
      await page.evaluate(() => window.hardball.setTime(0.8));
      await page.evaluate(() => window.hardball.follow(190));
    },
  },
  // Discs of two sizes that have jammed, and the forces that hold them.
  viewer_packing: {
    packing: ['--count', '300', '--dimensions', '2', '--sizes', 'discrete:1=0.5,1.4=0.5', '--phi', 'max'],
    scheme: 'light',
    async prepare() {},
  },
  // The cells of the paper, as a sphere enters and leaves them.
  viewer_cells: {
    scenario: 'paper.toml',
    settings: ['--until', '4'],
    scheme: 'dark',
    async prepare(page) {
      await page.evaluate(() => window.hardball.setTime(2));
      await page.check('#show-cells');
      await page.evaluate(() => window.hardball.setTime(2.15));
    },
  },
  // Grains in an hourglass, a mesh from a file.
  viewer_hourglass: {
    scenario: 'hourglass.toml',
    settings: ['--until', '9'],
    scheme: 'light',
    async prepare(page) {
      await page.evaluate(() => window.hardball.setTime(8));
    },
  },
  // Two rows of kinematic spheres stir a few grains.
  viewer_mixer: {
    scenario: 'mixer.toml',
    settings: ['--until', '20', '--set', 'spheres.1.count=120'],
    scheme: 'light',
    async prepare(page) {
      await page.evaluate(() => window.hardball.setTime(19));
    },
  },
  // Balls that have fallen through the pegs of a Galton board.
  viewer_galton: {
    scenario: 'galton_board.toml',
    settings: ['--until', '26'],
    scheme: 'light',
    async prepare(page) {
      await page.evaluate(() => window.hardball.setTime(20));
    },
  },
};

const settled = (page) =>
  page.waitForFunction(() => {
    const { chunks, chunksInMemory, isBuffering } = window.hardball.state();
    return !isBuffering && chunksInMemory === chunks;
  });

async function runAndView(folder, scenario, settings) {
  const path = join(kRoot, 'scenarios', scenario);
  await run('run', path, '--out', folder, '--quiet', '--set', 'output.recording=true', ...settings);
  return view(folder);
}

// The page of a packing, which needs no server.
async function pack(folder, request) {
  const file = join(folder, 'packing.html');
  await run('pack', ...request, '--quiet', '--replay', file);
  return { url: pathToFileURL(file).href, stop: async () => {} };
}

// Writes an animated WebP of frames that are half as large as the picture.
async function makeMovie(page, { frames, from, step, milliseconds }, folder, file) {
  const images = [];
  for (let k = 0; k < frames; ++k) {
    await page.evaluate((time) => window.hardball.setTime(time), from + k * step);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    images.push(join(folder, `frame${k}.png`));
    await page.screenshot({ path: images.at(-1) });
  }
  const looks = ['-lossy', '-q', '40', '-m', '6', '-d', String(milliseconds)];
  execFileSync('img2webp', ['-loop', '0', ...images.flatMap((image) => [...looks, image]), '-o', file]);
}

const wanted = process.argv.slice(2);
const browser = await Browser.launch();
for (const [name, { scenario, settings, packing, scheme, prepare, movie }] of Object.entries(kPictures)) {
  if (wanted.length > 0 && !wanted.includes(name)) continue;
  await withFolder(async (folder) => {
    const program = packing ? await pack(folder, packing) : await runAndView(folder, scenario, settings);
    const page = await browser.open(program.url, { width: 1280, height: 780, scheme });
    await prepare(page);
    await settled(page);
    // Plots are updated less often.
    await page.waitForTimeout(1500);
    const file = join(kRoot, 'docs', 'figures', `${name}.png`);
    await page.screenshot({ path: file });
    execFileSync('pngquant', ['--force', '--strip', '--ext', '.png', '200', file]);
    if (movie) {
      const small = await browser.open(program.url, { width: 1280, height: 780, scheme, pixelRatio: 0.5 });
      await settled(small);
      await makeMovie(small, movie, folder, join(kRoot, 'docs', 'figures', `${name}.webp`));
    }
    await program.stop();
  });
}
await browser.close();
