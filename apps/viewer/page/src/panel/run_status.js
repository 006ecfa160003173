// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { show, showCount } from './numbers.js';

/** The status of the run in the header of the page. `spheres`: how many there were at the start. */
export function showRunStatus(source, spheres, isLost) {
  const { header, status } = source;
  const put = (id, text) => {
    const element = document.getElementById(id);
    if (element.textContent !== text) element.textContent = text;
  };
  const [state, words] = describe(source, isLost);
  document.getElementById('status').dataset.state = state;
  put('status-text', words);
  put('count-spheres', showCount(spheres));
  put('count-collisions', count(status.collisions));
  put('count-mergers', count(status.mergers));
  put('count-walls', count(status.walls));
  put('count-hash', status.event_log_hash || '–');
  document.getElementById('counts-mergers').hidden = !(status.mergers > 0);
  document.getElementById('counts-walls').hidden =
    !header.box.boundary.includes('wall') && !(header.surfaces?.length > 0);
  document.getElementById('counts-hash').hidden = !status.event_log_hash;
}

function describe({ header, status, replayAddress }, isLost) {
  if (isLost) return ['lost', 'Connection lost'];
  if (status.failed) return ['failed', 'Run failed'];
  if (status.damaged) return ['failed', 'Recording damaged'];
  if (header.moments) return ['saved', 'Moments of a run'];
  if (replayAddress === null) return ['saved', 'Saved replay'];
  if (status.finished) return ['finished', `Finished at ${show(status.reached)} T`];
  return ['running', `Running, at ${show(status.reached)} T`];
}

function count(value) {
  return value === undefined || value === null ? '–' : showCount(value);
}
