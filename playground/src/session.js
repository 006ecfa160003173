// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { Session } from '../package/session.js';

/** A simulation of the playground: what the package has, with the summary and the report of the program. */
export class PlaygroundSession extends Session {
  status(reason) {
    const recordedBytes = this.recorded ? this.module.FS.stat(this.recorded.path).size : 0;
    return { ...super.status(reason), recordedBytes };
  }

  /** {summary, report}: texts in JSON and HTML, of a run that was to end at `until` [T]; `setup` and `run`: its seconds. */
  results({ until, setup, run }) {
    return this.native.scoped((scope) => {
      const [summary, report] = [scope.bytes(4), scope.bytes(4)];
      this.native.check(this.module._playground_results(this.address, until, setup, run, summary, report));
      const text = (address) => this.native.text(this.native.whole(address));
      return { summary: text(summary), report: text(report) };
    });
  }
}
