// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kEventColors, kMapColors, kSpeciesColors, toCss } from '../scene/colors.js';
import { show, showCount } from './numbers.js';

/** What the colors of the spheres mean. */
export class ColorLegend {
  constructor() {
    this.bar = document.getElementById('legend-bar');
    this.numbers = document.getElementById('legend-numbers');
    this.species = document.getElementById('legend-species');
    this.bar.style.background = `linear-gradient(to right, ${kMapColors.map(toCss).join(', ')})`;
  }

  /** A bar from `low` to `high`. */
  showRange(low, high) {
    this.choose('range');
    [low, (low + high) / 2, high].forEach((value, k) => {
      const text = show(value, 3);
      if (this.numbers.children[k].textContent !== text) this.numbers.children[k].textContent = text;
    });
  }

  /** A swatch for each species. */
  showSpecies(list) {
    this.choose('species');
    this.species.replaceChildren(
      ...list
        .slice(0, kSpeciesColors.length)
        .map(({ radius, mass, count }, k) =>
          swatch(kSpeciesColors[k], `${showCount(count)} × radius ${show(radius, 3)}, mass ${show(mass, 3)}`),
        ),
    );
  }

  choose(way) {
    this.bar.hidden = this.numbers.hidden = way !== 'range';
    this.species.hidden = way !== 'species';
  }
}

/** What the colors of events and cells mean. */
export function showEventLegend(hasWalls) {
  const entries = [
    ['collision', 'collision', ''],
    ...(hasWalls ? [['wall', 'wall contact', '']] : []),
    ['enter', 'cell just entered', 'square'],
    ['leave', 'cell just left', 'square'],
  ];
  const place = document.getElementById('legend-events');
  place.replaceChildren(...entries.map(([name, text, shape]) => swatch(kEventColors[name], text, shape)));
}

function swatch(color, text, shape = '') {
  const item = document.createElement('li');
  const mark = document.createElement('span');
  mark.className = `swatch ${shape}`;
  mark.style.background = toCss(color);
  item.append(mark, text);
  return item;
}
