// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/** Keyboard shortcuts. Fields and buttons keep the keys that they use themselves. */
export function listenToKeys(viewer) {
  const actions = {
    ' ': () => viewer.togglePlay(),
    ArrowRight: (event) => viewer.step(1, event.shiftKey),
    ArrowLeft: (event) => viewer.step(-1, event.shiftKey),
    Home: () => viewer.goToBegin(),
    End: () => viewer.goToEnd(),
    '+': () => viewer.setSpeed(viewer.player.speed * 1.25),
    '=': () => viewer.setSpeed(viewer.player.speed * 1.25),
    '-': () => viewer.setSpeed(viewer.player.speed / 1.25),
    Escape: () => viewer.follow(null),
    f: () => viewer.fit(),
    g: () => viewer.approach(),
    c: () => document.getElementById('show-cells').click(),
    e: () => document.getElementById('show-events').click(),
    w: () => document.getElementById('show-walls').click(),
    i: () => document.getElementById('show-images').click(),
    s: () => document.getElementById('show-spin').click(),
  };
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action || isUsed(event)) return;
    event.preventDefault();
    action(event);
  });
}

function isUsed({ target, key }) {
  if (target.matches('select, input[type="number"]')) return true;
  if (target.matches('input[type="range"]'))
    return key.startsWith('Arrow') || key === 'Home' || key === 'End';
  return key === ' ' && target.matches('button, a, input');
}
