// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { keyGroups } from './keyboard.js';
import { show } from './numbers.js';

/** The keys, and what units mean, over the page. */
export class Help {
  constructor(viewer) {
    this.viewer = viewer;
    this.dialog = document.getElementById('help');
    document.getElementById('help-button').addEventListener('click', () => this.toggle());
    document.getElementById('help-close').addEventListener('click', () => this.dialog.close());
    // A click beside it is one on its backdrop.
    this.dialog.addEventListener('click', ({ target }) => target === this.dialog && this.dialog.close());
  }

  get isOpen() {
    return this.dialog.open;
  }

  toggle() {
    if (this.isOpen) return this.dialog.close();
    const sections = keyGroups(this.viewer).map(({ name, bindings }) => section(name, bindings));
    document.getElementById('help-keys').replaceChildren(...sections);
    document.getElementById('help-scales').textContent = this.scales();
    this.dialog.showModal();
  }

  // How long, fast and massive things are in the units of this run.
  scales() {
    const { sizes, scales, source } = this.viewer;
    const masses = source.masses.filter((mass, id) => source.radii[id] > 0 && mass < Infinity);
    const range = (low, high, unit) =>
      low === high ? `${show(low, 3)} ${unit}` : `${show(low, 3)} to ${show(high, 3)} ${unit}`;
    const parts = [`diameters are ${range(2 * sizes.smallest, 2 * sizes.largest, 'L')}`];
    if (masses.length > 0) {
      const ends = masses.reduce(([low, high], mass) => [Math.min(low, mass), Math.max(high, mass)], [Infinity, 0]);
      parts.push(`masses ${range(...ends, 'M')}`);
    }
    if (scales?.speed > 0) parts.push(`speeds about ${show(scales.speed, 2)} L T⁻¹`);
    return `In this run ${parts.join(', ')}.`;
  }
}

function section(name, bindings) {
  const place = document.createElement('section');
  const heading = document.createElement('h3');
  heading.textContent = name;
  const list = document.createElement('dl');
  for (const { shown, does } of bindings) {
    const [key, meaning] = [document.createElement('dt'), document.createElement('dd')];
    key.textContent = shown;
    meaning.textContent = does;
    list.append(key, meaning);
  }
  place.append(heading, list);
  return place;
}
