// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/** Checks scenarios in a worker, one at a time; of those that wait, only the last is checked. */
export class Checks {
  /** `wasm`: a promise of the module. */
  constructor(wasm) {
    this.wasm = wasm;
    this.worker = new Worker(new URL('./checker.js', import.meta.url), { type: 'module' });
    this.worker.onmessage = ({ data }) => this.receive(data);
    this.last = 0;
    this.busy = null;
    this.next = null;
  }

  /** {until} or {error} of a scenario; null if another one was given before this one's turn. */
  check(scenario) {
    return new Promise((resolve) => {
      this.next?.resolve(null);
      this.next = { scenario, resolve };
      if (!this.busy) this.begin();
    });
  }

  async begin() {
    this.busy = this.next;
    this.next = null;
    const { text, name, files } = this.busy.scenario;
    this.worker.postMessage({ id: ++this.last, text, name, files: await files, wasm: await this.wasm });
  }

  receive({ until, error }) {
    this.busy.resolve({ until, error });
    this.busy = null;
    if (this.next) this.begin();
  }
}
