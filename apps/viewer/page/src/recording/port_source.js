// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { Chunk } from './chunk.js';

/**
 * A recording that comes through a MessagePort, and that may still be growing: from a worker that runs the library, say.
 *
 * The page asks {id, what}, and is answered {id, ...} or {id, error}. 'header' is answered by {header, spheres}: what the
 * recording says of itself, and the radii [L] and masses [M] of all spheres, as one Float64Array. 'status', with how many chunks
 * are known as `from`, by {ends, status}: where the other chunks end [T], and the status that the server would give. 'chunk', with
 * its `number`, by {buffer}.
 */
export class PortSource {
  constructor(port) {
    this.port = port;
    this.header = null;
    this.radii = null;
    this.masses = null;
    /** Where each chunk ends [T]. */
    this.ends = [];
    /** The last known status of the run. */
    this.status = null;
    /** There is no page to be saved. */
    this.replayAddress = '';
    this.waiting = new Map();
    this.asked = 0;
    port.onmessage = ({ data: { id, error, ...answer } }) => {
      const { resolve, reject } = this.waiting.get(id);
      this.waiting.delete(id);
      if (error) reject(new Error(error));
      else resolve(answer);
    };
  }

  /** Gets header, radii, masses and the list of chunks. Error: there is no recording. */
  async open() {
    const { header, spheres } = await this.ask('header');
    this.header = header;
    this.radii = spheres.subarray(0, header.spheres);
    this.masses = spheres.subarray(header.spheres);
    await this.poll();
  }

  /** Gets the progress of the run. Error: there is no recording any more. */
  async poll() {
    const { ends, status } = await this.ask('status', { from: this.ends.length });
    this.ends.push(...ends);
    this.status = status;
  }

  /** Gets chunk `number`. Error: as for poll. */
  async chunk(number) {
    const { buffer } = await this.ask('chunk', { number });
    return new Chunk(buffer, 0, this.header);
  }

  ask(what, parts = {}) {
    const id = ++this.asked;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.port.postMessage({ id, what, ...parts });
    });
  }
}

/** Says to the page around this one that it is ready, and resolves to the port that this hands over. */
export function portOfParent() {
  return new Promise((resolve) => {
    addEventListener('message', ({ data, ports, source }) => {
      if (source === parent && data === 'hardball-source') resolve(ports[0]);
    });
    parent.postMessage('hardball-ready', '*');
  });
}
