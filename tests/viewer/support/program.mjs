// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';

const kProgram = process.env.HARDBALL_PROGRAM;
if (!kProgram) throw new Error('HARDBALL_PROGRAM is not set; give the path of the program to be tested');

/** A temporary folder for `work(folder)`, removed at the end. */
export async function withFolder(work) {
  const folder = await mkdtemp(join(tmpdir(), 'hardball_viewer_'));
  try {
    return await work(folder);
  } finally {
    await rm(folder, { recursive: true });
  }
}

/** Runs the program to its end. Error: it fails. */
export async function run(...words) {
  const process = spawn(kProgram, words, { stdio: ['ignore', 'ignore', 'inherit'] });
  const [code] = await once(process, 'exit');
  if (code !== 0) throw new Error(`hardball ${words.join(' ')} ended with ${code}`);
}

/** Starts the program serving `what`, a scenario or the folder of a run: {url, stop}. */
export async function view(what, ...options) {
  const process = spawn(kProgram, ['view', what, '--no-open', ...options], {
    stdio: ['ignore', 'pipe', 'ignore'],
  });
  const ended = once(process, 'exit');
  const lines = createInterface({ input: process.stdout });
  const url = await Promise.race([
    once(lines, 'line').then(([line]) => line.trim()),
    ended.then(([code]) => Promise.reject(new Error(`hardball view ended with ${code}`))),
  ]);
  const stop = async () => {
    process.kill('SIGINT');
    await ended;
  };
  return { url, stop };
}

/** A scenario file in `folder`. */
export async function writeScenario(folder, text) {
  const path = join(folder, 'scenario.toml');
  await writeFile(path, text);
  return path;
}

/** The snapshots of an extended XYZ file: a list of {time, positions}, positions by id. */
export function readTrajectory(text) {
  const lines = text.split('\n');
  const snapshots = [];
  for (let line = 0; lines[line];) {
    const count = Number(lines[line]);
    const time = Number(/Time=(\S+)/.exec(lines[line + 1])[1]);
    const positions = [];
    for (const row of lines.slice(line + 2, line + 2 + count)) {
      const words = row.trim().split(/\s+/);
      // type, position (3), velocity (3), radius, mass, id, and the count of boxes
      positions[Number(words[9])] = words.slice(1, 4).map(Number);
    }
    snapshots.push({ time, positions });
    line += 2 + count;
  }
  return snapshots;
}
