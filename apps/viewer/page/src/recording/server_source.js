// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { Chunk } from './chunk.js';

/** A recording that the program serves, and that may still be growing. */
export class ServerSource {
  /** `token`: the one in the page's address, which every request needs. */
  constructor(token) {
    this.token = token;
    this.header = null;
    this.radii = null;
    this.masses = null;
    /** Where each chunk ends [T]. */
    this.ends = [];
    /** The last known status of the run. */
    this.status = {
      finished: false,
      failed: null,
      damaged: null,
      reached: 0,
      collisions: 0,
      mergers: 0,
      walls: 0,
      rate: 0,
    };
  }

  /** The address from which the whole recording can be saved as one page. */
  get replayAddress() {
    return this.address('replay.html');
  }

  /** Fetches header, radii, masses and the list of chunks. Error: the server does not answer. */
  async open() {
    this.header = await (await this.ask('header')).json();
    const numbers = new Float64Array(await (await this.ask('spheres')).arrayBuffer());
    this.radii = numbers.subarray(0, this.header.spheres);
    this.masses = numbers.subarray(this.header.spheres);
    await this.poll();
  }

  /** Fetches the progress of the run. Error: the server does not answer. */
  async poll() {
    const { chunk_ends: ends, ...status } = await (
      await this.ask('status', { from: this.ends.length })
    ).json();
    this.ends.push(...ends);
    this.status = status;
  }

  /** Fetches chunk `number`. Error: the server does not answer. */
  async chunk(number) {
    const buffer = await (await this.ask('chunk', { number })).arrayBuffer();
    return new Chunk(buffer, 0, this.header);
  }

  async ask(what, query = {}) {
    const response = await fetch(this.address(what, query), { cache: 'no-store' });
    if (!response.ok) throw new Error(`${response.status}: ${(await response.text()).trim()}`);
    return response;
  }

  address(what, query = {}) {
    return `api/${what}?${new URLSearchParams({ ...query, token: this.token })}`;
  }
}
