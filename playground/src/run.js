// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { open } from '../package/index.js';

/** As many contacts have a hash that is compared with the native one. */
export const kComparedContacts = 3000;
/** A recording grows no further, since it is in memory. */
export const kMostRecordedBytes = 4e8;

/** One run of a scenario, from its start to its end. */
export class Run {
  /** `onProgress(status)` is called some hundred times a second. */
  constructor({ text, name, files, wasm, until, measures, onProgress }) {
    Object.assign(this, { text, name, files, wasm, until, measures, onProgress });
    this.simulation = null;
    this.seconds = { setup: 0, run: 0 };
    this.status = null;
    /** The hash of the first contacts, once there are as many, or the run has ended. */
    this.firstHash = null;
    /** Whether the recording has grown as far as it may. */
    this.isFull = false;
    this.isEnded = false;
  }

  /** Starts the simulation. Error: it is no scenario; spheres do not fit. */
  async start() {
    const begin = performance.now();
    this.simulation = await open(this.text, { name: `${this.name}.toml`, files: this.files, wasm: await this.wasm });
    await this.simulation.keepMeasures(this.measures);
    await this.simulation.beginRecording();
    this.seconds.setup = (performance.now() - begin) / 1000;
    this.status = await this.simulation.status();
  }

  /** Has the recording served through a port. */
  serve(port) {
    return this.simulation.serveRecording(port);
  }

  /** Goes on until the end or until pause(); whether it has come to its end. Error: the run cannot continue. */
  async go() {
    const begin = performance.now();
    this.abort = new AbortController();
    const { signal } = this.abort;
    const onProgress = (status) => {
      this.status = status;
      if (status.recordedBytes > kMostRecordedBytes) {
        this.isFull = true;
        this.pause();
      }
      this.onProgress(status);
    };
    const run = async (limits) => (this.status = await this.simulation.run({ until: this.until, signal, onProgress, ...limits }));
    try {
      if (this.firstHash === null) {
        const { collisions, wallContacts } = this.status;
        const { reason, hash } = await run({ contacts: kComparedContacts - collisions - wallContacts });
        if (reason === 'stopped') return false;
        this.firstHash = hash;
        if (reason === 'time') return true;
        if (signal.aborted) return false;
      }
      return (await run({})).reason === 'time';
    } finally {
      this.seconds.run += (performance.now() - begin) / 1000;
      this.onProgress(this.status);
    }
  }

  pause() {
    this.abort?.abort();
  }

  /** Ends the recording at the present time. */
  async end() {
    this.isEnded = true;
    await this.simulation.endRecording();
  }

  /** {summary, report}, up to the present time. */
  results() {
    return this.simulation.engine.call('results', [{ until: this.until, ...this.seconds }]);
  }

  close() {
    this.simulation?.close();
    this.simulation = null;
  }
}
