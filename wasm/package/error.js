// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/** What is wrong, where, and what to do instead. */
export class HardballError extends Error {
  /** `where`: "file:line:column", or an argument; `remedy`: what would be accepted. Both may be empty. */
  constructor({ problem, where = '', remedy = '' }) {
    super([where, problem].filter(Boolean).join(': ') + (remedy && `; ${remedy}`));
    this.name = 'HardballError';
    this.problem = problem;
    this.where = where;
    this.remedy = remedy;
  }

  /** The line and column of the scenario, from 1, or null. */
  get place() {
    const [, line, column] = this.where.match(/:(\d+):(\d+)$/) ?? [];
    return line ? { line: Number(line), column: Number(column) } : null;
  }
}
