// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kPathNumbers } from '../recording/chunk.js';

/**
 * The paths of sphere `id` that started before or at the first `count` contacts of chunk `number`, latest first,
 * at most `most`: each with `numbers`, as in a keyframe, and `until`, when it ended (Infinity for the
 * latest). As far back as the chunks in memory reach.
 */
export function recentPaths(store, id, number, count, most) {
  const paths = [];
  let until = Infinity;
  const add = (write) => {
    const numbers = new Float64Array(kPathNumbers);
    write(numbers);
    paths.push({ numbers, until });
    until = numbers[6];
  };
  for (let chunk = store.get(number); chunk; chunk = store.get(--number), count = chunk?.contacts) {
    for (let k = count - 1; k >= 0 && paths.length < most; --k) {
      if (chunk.involves(k, id)) add((numbers) => chunk.readPathAfter(k, id, numbers));
    }
    if (paths.length === most) return paths;
    const isLast = !store.get(number - 1);
    // The first keyframe in memory has the start of the oldest path.
    if (isLast) add((numbers) => chunk.readPath(id, 0, numbers));
  }
  return paths;
}

/**
 * The next contact after the first `count` of chunk `number`, of sphere `id` or, if that is null, of any:
 * its time and its two partners. Undefined if there is none in the consecutive chunks in memory.
 */
export function nextContact(store, id, number, count) {
  for (let chunk = store.get(number); chunk; chunk = store.get(++number), count = 0) {
    for (let k = count; k < chunk.contacts; ++k) {
      if (chunk.isContact(k, id)) {
        return { time: chunk.time(k), first: chunk.first(k), second: chunk.second(k) };
      }
    }
  }
  return undefined;
}

/** The end of the chunks in memory that follow chunk `number` without a gap [T]. */
export function knownUntil(store, number) {
  let end = -Infinity;
  for (let chunk = store.get(number); chunk; chunk = store.get(++number)) end = chunk.end;
  return end;
}
