// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import {
  BufferTarget,
  canEncodeVideo,
  CanvasSource,
  Mp4OutputFormat,
  Output,
  Quality,
  StreamTarget,
  WebMOutputFormat,
} from 'mediabunny';

/** The formats of films, by the extensions of their files. */
export const kFormats = {
  webm: { codec: 'vp9', type: 'video/webm', create: () => new WebMOutputFormat() },
  mp4: { codec: 'avc', type: 'video/mp4', create: () => new Mp4OutputFormat({ fastStart: 'in-memory' }) },
};

const kQuality = new Quality('high');
const kPieceBytes = 1 << 20;

/** The formats in which this browser can write films of `width` by `height` pixels. */
export async function offeredFormats(width, height) {
  if (!('VideoEncoder' in window)) return [];
  const names = Object.keys(kFormats);
  const can = await Promise.all(
    names.map((name) => canEncodeVideo(kFormats[name].codec, { width, height, quality: kQuality })),
  );
  return names.filter((_, k) => can[k]);
}

/** A film that is being written, frame by frame, from what a canvas shows. */
export class FilmFile {
  /**
   * `format`: a name of kFormats. `write(bytes, position)`, which may take its time, gets the pieces of the file; without it the
   * file is kept in memory.
   */
  constructor(format, canvas, fps, write = null) {
    const { codec, type, create } = kFormats[format];
    this.type = type;
    this.fps = fps;
    const sink = () => new WritableStream({ write: ({ data, position }) => write(data, position) });
    const target = write ? new StreamTarget(sink(), { chunked: true, chunkSize: kPieceBytes }) : new BufferTarget();
    this.output = new Output({ format: create(), target });
    this.source = new CanvasSource(canvas, { codec, quality: kQuality, latencyMode: 'quality' });
    this.output.addVideoTrack(this.source, { frameRate: fps });
  }

  begin() {
    return this.output.start();
  }

  /** Adds frame `number`, which the canvas shows at the call. */
  add(number) {
    return this.source.add(number / this.fps, 1 / this.fps);
  }

  /** Ends the film; returns the file if it is in memory. */
  async close() {
    await this.output.finalize();
    const { buffer } = this.output.target;
    return buffer ? new Blob([buffer], { type: this.type }) : null;
  }

  cancel() {
    return this.output.cancel();
  }
}
