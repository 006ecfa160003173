// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { withDocument } from './pages.mjs';

const packages = process.env.HARDBALL_TEST_PACKAGES;
const { resolve } = createRequire(packages ? join(packages, 'package.json') : import.meta.url);

/**
 * The decoded frames of the film `file`, whose folder is `folder`: {codec, width, height, frames}, of each frame its `time` [s] and
 * `sum`, a number that follows from all its pixels.
 */
export async function decodeFilm(file, folder) {
  const decoder = await readFile(join(resolve('mediabunny'), '../mediabunny.mjs'), 'utf8');
  const film = (await readFile(file)).toString('base64');
  let decoded = null;
  await withDocument(folder, async (page) => {
    decoded = await page.evaluate(
      async ({ decoder, film }) => {
        const address = URL.createObjectURL(new Blob([decoder], { type: 'text/javascript' }));
        const { ALL_FORMATS, BufferSource, Input, VideoSampleSink } = await import(address);
        const bytes = Uint8Array.from(atob(film), (letter) => letter.charCodeAt(0));
        const input = new Input({ source: new BufferSource(bytes.buffer), formats: ALL_FORMATS });
        const track = await input.getPrimaryVideoTrack();
        const frames = [];
        for await (const sample of new VideoSampleSink(track).samples()) {
          const canvas = new OffscreenCanvas(sample.displayWidth, sample.displayHeight);
          const context = canvas.getContext('2d');
          sample.draw(context, 0, 0);
          const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
          let sum = 7;
          for (const part of data) sum = (Math.imul(sum, 31) + part) | 0;
          frames.push({ time: sample.timestamp, sum, width: canvas.width, height: canvas.height });
          sample.close();
        }
        const [{ width, height }] = frames;
        return { codec: await track.getCodec(), width, height, frames };
      },
      { decoder, film },
    );
  });
  return decoded;
}

/** How many different frames there are. */
export const different = ({ frames }) => new Set(frames.map(({ sum }) => sum)).size;
