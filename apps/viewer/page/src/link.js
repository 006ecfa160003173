// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kSecondsBetweenWrites = 0.5;
const kDigits = 6; // of places, relative to the distance of what the camera is directed at
const kUnmoved = 1e-9; // of that distance: rounding of the camera's own

const element = (id) => document.getElementById(id);

/** The layers of the picture that are shown or not, and the boxes that say so. */
const kLayers = {
  walls: 'show-walls',
  images: 'show-images',
  spin: 'show-spin',
  forces: 'show-forces',
  bonds: 'show-bonds',
  cells: 'show-cells',
  events: 'show-events',
  arrows: 'show-arrows',
  trails: 'show-trails',
  near: 'near-only',
  follow: 'camera-follows',
};

/**
 * What a link says, in the order in which it is read: each item once. `write` gives its text, or null if there is none;
 * `read` takes it over, also from a link that somebody has edited, of which it ignores what it does not understand.
 */
const kItems = {
  q: {
    write: ({ quality }) => (quality.isFixed ? quality.way.name : null),
    read: (viewer, text) => viewer.quality.isWay(text) && viewer.setQuality(text),
  },
  sel: {
    write: ({ followed }) => (followed === null ? null : String(followed)),
    read: (viewer, text) => viewer.follow(text ? Number(text) : null),
  },
  color: {
    write: ({ colorBy }) => colorBy,
    read: (viewer, text) => viewer.colorings.includes(text) && viewer.setColorBy(text),
  },
  range: {
    write: ({ fixedRange }) => fixedRange?.join(',') ?? null,
    read: (viewer, text) => viewer.fixRange(numbersIn(text, 2)),
  },
  edge: {
    write: ({ cellEdge }) => (cellEdge === null ? null : String(cellEdge)),
    read: (viewer, text) => viewer.setCellEdge(Number(text ?? 0)),
  },
  show: {
    write: () => Object.keys(kLayers).filter((name) => element(kLayers[name]).checked).join(','),
    read: (viewer, text) => {
      const names = text.split(',');
      for (const [name, id] of Object.entries(kLayers)) element(id).checked = names.includes(name);
      viewer.view.isStale = true;
    },
  },
  slice: {
    write: ({ slice }) => slice.text,
    read: ({ slice }, text) => slice.read(text),
  },
  speed: {
    write: ({ player }) => String(Number(player.speed.toPrecision(4))),
    read: (viewer, text) => Number(text) > 0 && viewer.setSpeed(Number(text)),
  },
  // The scale of speeds follows only large changes, so that it depends on what has been shown.
  fast: {
    write: ({ plots }) => (plots.fast === plots.fastNow ? null : String(plots.fast)),
    read: (viewer, text) => viewer.plots.restart(Number(text) || 0),
  },
  cam: {
    write: ({ view }) => poseText(view.pose),
    read: (viewer, text) => {
      const numbers = numbersIn(text, 6);
      if (numbers) viewer.view.place(numbers);
    },
  },
  // In open space, what was shown when everything was fitted into the picture.
  seen: {
    write: ({ box, surroundings }) => (box.boundary.includes('open') ? surroundings.extent.flat().map(rounded).join(',') : null),
    read: (viewer, text) => {
      const numbers = numbersIn(text, 6);
      if (numbers) viewer.span([numbers.slice(0, 3), numbers.slice(3)]);
    },
  },
  play: {
    write: ({ player }) => (player.isPlaying ? '1' : '0'),
    read: (viewer, text) => (text === '1' ? viewer.player.play() : viewer.player.pause()),
  },
};

/** The text of an address after its #, of the texts of items. */
export function joinState(items) {
  const escaped = (text) => encodeURIComponent(text).replaceAll('%2C', ',').replaceAll('%20', '+');
  return Object.entries(items)
    .filter(([, text]) => text !== null)
    .map(([name, text]) => `${name}=${escaped(text)}`)
    .join('&');
}

/** The texts of the items in the part of an address after its #. */
export function splitState(text) {
  return Object.fromEntries(new URLSearchParams(text.replace(/^#/, '')));
}

/** Six numbers of a camera, those of its place and those of what it is directed at [L], with six digits of its distance. */
export function poseText(pose) {
  const distance = Math.hypot(...[0, 1, 2].map((axis) => pose[axis] - pose[3 + axis]));
  const decimals = Math.min(12, Math.max(0, kDigits - 1 - Math.floor(Math.log10(distance || 1))));
  return pose.map((place) => String(Number(place.toFixed(decimals)))).join(',');
}

/** As many numbers as `count`, or null if `text` has others. */
export function numbersIn(text, count) {
  const numbers = (text ?? '').split(',').map((part) => (part.trim() === '' ? NaN : Number(part)));
  return numbers.length === count && numbers.every(Number.isFinite) ? numbers : null;
}

function rounded(value) {
  return String(Number(value.toPrecision(kDigits)));
}

/**
 * The state of the page in its address after the #, so that a copied link shows the same to the pixel. What is as at the start
 * is left out. A page inside of another one also tells it each new state by `postMessage`, as {hardball: 'state', state}, and
 * shows the state that it is sent as {hardball: 'show', state}.
 */
export class Link {
  constructor(viewer) {
    this.viewer = viewer;
    /** Whether the page has an address of its own, which a page inside the text of another has not. */
    this.hasAddress = location.protocol !== 'about:' && location.protocol !== 'blob:';
    this.isInside = window.parent !== window;
    this.starts = {};
    this.written = '';
    this.due = Infinity;
    // What is fed through a port shows nothing under its address alone.
    const isFed = new URLSearchParams(location.search).get('source') === 'port';
    element('copy-link').hidden = !this.hasAddress || isFed;
    element('copy-link').addEventListener('click', () => this.copy());
    if (this.hasAddress) addEventListener('hashchange', () => this.show(location.hash));
    addEventListener('message', ({ source, data }) => {
      const isState = data?.hardball === 'show' && typeof data.state === 'string';
      if (isState && this.isInside && source === window.parent) this.show(data.state);
    });
  }

  /** The state at the start is known, so that others can be shown and written; shows that of the address. */
  async begin() {
    const { viewer } = this;
    for (const [name, item] of Object.entries(kItems)) this.starts[name] = item.write(viewer);
    this.extent = viewer.surroundings.extent;
    this.size = this.sizeNow;
    const begins = this.hasAddress ? location.hash.slice(1) : '';
    if (begins === '') this.due = -Infinity;
    else await this.show(begins);
  }

  /** Shows the state of a link. */
  async show(text) {
    if (text.replace(/^#/, '') === this.written) return;
    const { viewer } = this;
    const { t, ...items } = splitState(text);
    this.due = Infinity;
    const time = Number(t ?? viewer.source.header.begin);
    if (Number.isFinite(time)) await viewer.player.seek(time);
    for (const [name, item] of Object.entries(kItems)) {
      // A link without a camera shows everything, whatever the size of the window.
      if (name === 'cam' && items.cam === undefined) viewer.resetCamera(this.extent);
      item.read(viewer, items[name] ?? (name === 'cam' ? null : this.starts[name]));
    }
    this.due = -Infinity;
  }

  /** The state as in an address. */
  get state() {
    const { viewer } = this;
    const { time, source } = viewer.player;
    const items = { t: time === source.header.begin ? null : String(time) };
    const isResized = this.sizeNow !== this.size;
    for (const [name, item] of Object.entries(kItems)) {
      const text = item.write(viewer);
      const isStart = text === this.starts[name] && !(name === 'cam' && isResized);
      items[name] = isStart ? null : text ?? '';
    }
    return joinState(items);
  }

  /** The whole address. */
  get address() {
    return `${location.href.split('#')[0]}#${this.state}`;
  }

  /** Writes the state into the address, if it is time to: `now` [s]. */
  update(now) {
    if (now < this.due || this.viewer.player.wanted !== null) return;
    this.due = now + kSecondsBetweenWrites;
    if (!this.viewer.player.isPlaying) this.settle();
    const { state } = this;
    if (state === this.written) return;
    this.written = state;
    this.viewer.settle();
    // Some browsers refuse when it is done too often, and some do not let a page in a file change its address.
    try {
      if (this.hasAddress) history.replaceState(null, '', state === '' ? location.href.split('#')[0] : `#${state}`);
    } catch {
      this.due = now + 20 * kSecondsBetweenWrites;
    }
    if (this.isInside) window.parent.postMessage({ hardball: 'state', state }, '*');
  }

  // Rounds what is shown as the text of the state does.
  settle() {
    const { viewer } = this;
    const { view } = viewer;
    const pose = numbersIn(poseText(view.pose), 6);
    const distance = Math.hypot(...[0, 1, 2].map((axis) => pose[axis] - pose[3 + axis]));
    if (view.pose.some((place, k) => Math.abs(place - pose[k]) > kUnmoved * distance)) view.place(pose);
    const { seen, speed } = kItems;
    const extent = seen.write(viewer);
    if (extent !== null && viewer.surroundings.extent.flat().join(',') !== extent) seen.read(viewer, extent);
    if (String(viewer.player.speed) !== speed.write(viewer)) speed.read(viewer, speed.write(viewer));
    if (viewer.playback.recount()) viewer.view.isStale = true;
  }

  get sizeNow() {
    const { clientWidth, clientHeight } = this.viewer.view.canvas;
    return `${clientWidth} ${clientHeight}`;
  }

  async copy() {
    this.due = -Infinity;
    this.update(performance.now() / 1000);
    const { address } = this;
    const { notices } = this.viewer;
    try {
      await navigator.clipboard.writeText(address);
      notices.show('link', 'Link copied');
    } catch {
      // Without permission it can be copied by hand.
      notices.show('link', address);
    }
    clearTimeout(this.hiding);
    this.hiding = setTimeout(() => notices.hide('link'), 4000);
  }
}
