// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kTurn = Math.PI / 36; // radians by a key
const kPan = 0.06; // of the height of the picture
const kZoom = 1.12;
const kFaster = 1.25;

/**
 * The keys whose controls are on the page, by what they act on: a list of {name, bindings}. Of a binding, `shown` names the
 * keys, `does` says what they do, and `run` has a function for each.
 */
export function keyGroups(viewer) {
  const { view } = viewer;
  const { hasMoments } = viewer.player;
  const isShown = (id) => document.getElementById(id).getClientRects().length > 0;
  const isSpatial = !viewer.box.isFlat;
  const pan = (aside, upward) => view.pan(kPan * aside, kPan * upward);
  const arrow = (aside, upward) => (event) =>
    event.shiftKey || !isSpatial ? pan(aside, upward) : view.turn(kTurn * aside, kTurn * upward);
  const move = { ArrowLeft: arrow(-1, 0), ArrowRight: arrow(1, 0), ArrowUp: arrow(0, 1), ArrowDown: arrow(0, -1) };
  const alongAxes = Object.fromEntries(['x', 'y', 'z'].map((key, axis) => [key, () => view.lookAlongAxis(axis)]));
  const binding = (shown, does, run) => ({ shown, does, run });
  // One entry for the boxes that keys check or uncheck, each given as [key, what it shows, id].
  const boxes = (...all) => {
    const offered = all.filter(([, , id]) => isShown(id));
    if (offered.length === 0) return [];
    const click = (id) => () => document.getElementById(id).click();
    return [
      binding(
        offered.map(([key]) => key).join(' '),
        offered.map(([, does]) => does).join(', '),
        Object.fromEntries(offered.map(([key, , id]) => [key.toLowerCase(), click(id)])),
      ),
    ];
  };
  const groups = [
    {
      name: 'Playback',
      isOffered: isShown('transport'),
      bindings: [
        binding('Space', 'play, pause', { ' ': () => viewer.togglePlay() }),
        binding('N P', hasMoments ? 'next, previous moment' : 'next, previous contact; with Shift, of the followed sphere', {
          n: (event) => viewer.step(1, event.shiftKey),
          p: (event) => viewer.step(-1, event.shiftKey),
        }),
        binding('Home End', 'go to the start, go to the latest time', {
          Home: () => viewer.goToBegin(),
          End: () => viewer.goToEnd(),
        }),
        binding('PgUp PgDn', 'faster, slower', {
          PageUp: () => viewer.setSpeed(viewer.player.speed * kFaster),
          PageDown: () => viewer.setSpeed(viewer.player.speed / kFaster),
        }),
      ],
    },
    {
      name: 'Camera',
      bindings: [
        binding('← → ↑ ↓', isSpatial ? 'turn; with Shift, move' : 'move', move),
        binding('+ −', 'closer, farther', {
          '+': () => view.zoom(kZoom),
          '=': () => view.zoom(kZoom),
          '-': () => view.zoom(1 / kZoom),
        }),
        ...(isSpatial ? [binding('X Y Z', 'look along an axis; again, from its other side', alongAxes)] : []),
        binding('F', 'show everything', { f: () => viewer.fit() }),
        binding('0', 'back to the view at the start', { 0: () => viewer.resetView() }),
        binding('G', 'go to the followed sphere', { g: () => viewer.approach() }),
      ],
    },
    {
      name: 'Shown',
      bindings: [
        ...boxes(['C', 'cells', 'show-cells'], ['E', 'contacts', 'show-events']),
        ...boxes(['W', 'walls', 'show-walls'], ['I', 'periodic images', 'show-images']),
        ...boxes(['L', 'lines of forces', 'show-forces'], ['B', 'bonds', 'show-bonds']),
        ...boxes(['S', 'marks that turn with the spheres', 'show-spin']),
        binding('Esc', 'stop following', { Escape: () => viewer.follow(null) }),
        binding('?', 'these keys', { '?': () => viewer.help.toggle() }),
      ],
    },
  ];
  return groups.filter(({ isOffered = true }) => isOffered);
}

/** Keyboard shortcuts. Fields and buttons keep the keys that they use themselves. */
export function listenToKeys(viewer) {
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const bindings = keyGroups(viewer).flatMap((group) => group.bindings);
    const actions = Object.assign({}, ...bindings.map(({ run }) => run));
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (!actions[key] || isUsed(event)) return;
    // Esc closes the help, as the browser sees to.
    if (viewer.shooting.isOpen || (viewer.help.isOpen && key !== '?')) return;
    event.preventDefault();
    actions[key](event);
  });
}

function isUsed({ target, key }) {
  if (target.matches('select, input[type="number"]')) return true;
  if (target.matches('input[type="range"]'))
    return key.startsWith('Arrow') || key.startsWith('Page') || key === 'Home' || key === 'End';
  return key === ' ' && target.matches('button, a, input');
}
