// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kStrongForce } from '../motion/forces.js';
import { kDomainColors, kEventColors, kKinematicColor, kMapColors, kSpeciesColors, toCss } from '../scene/colors.js';
import { show, showCount } from './numbers.js';

const kMostSurfaces = 12; // named in the legend

/** What the colors of the spheres mean. */
export class ColorLegend {
  constructor() {
    this.bar = document.getElementById('legend-bar');
    this.numbers = document.getElementById('legend-numbers');
    this.species = document.getElementById('legend-species');
    this.bar.style.background = mapGradient();
    this.scale = document.getElementById('scale-row');
    this.fixed = document.getElementById('fix-scale');
    this.ends = ['scale-left', 'scale-right'].map((id) => document.getElementById(id));
  }

  /** A bar from `low` to `high`, in `unit`; `fixed`: these ends, if they stay as they are, and otherwise null. */
  showRange(low, high, unit, isLogarithmic = false, fixed = null) {
    this.choose('range');
    this.fixed.checked = fixed !== null;
    this.ends.forEach((end, k) => {
      end.hidden = fixed === null;
      if (fixed !== null && document.activeElement !== end) end.value = fixed[k];
    });
    const middle = isLogarithmic ? Math.sqrt(low * high) : (low + high) / 2;
    [low, middle, high].forEach((value, k) => {
      const text = `${show(value, 3)} ${unit}`.trim();
      if (this.numbers.children[k].textContent !== text) this.numbers.children[k].textContent = text;
    });
  }

  /** A swatch for each species: named, or known by radius and mass. */
  showSpecies(list) {
    const texts = list.map(({ name, radius, mass, count }) =>
      name ? `${name}: ${showCount(count)}` : `${showCount(count)} × radius ${show(radius, 3)} L, mass ${show(mass, 3)} M`,
    );
    this.showSwatches(kSpeciesColors, texts);
  }

  /** A swatch for each domain, which has so many spheres. */
  showDomains(counts) {
    this.showSwatches(
      kDomainColors,
      counts.map((count, k) => `domain ${k}: ${showCount(count)}`),
    );
  }

  showSwatches(colors, texts) {
    this.choose('species');
    if (this.texts === texts.join('\n')) return;
    this.texts = texts.join('\n');
    // As many colors as there are: further species and domains use them again.
    this.species.replaceChildren(
      ...texts
        .slice(0, 3 * colors.length)
        .map((text, k) => swatch(colors[k % colors.length], text)),
    );
  }

  /** A swatch for kinematic spheres, of which there are `count`. */
  showKinematic(count) {
    const place = document.getElementById('legend-kinematic');
    place.replaceChildren(
      ...(count > 0 ? [swatch(kKinematicColor, `grayish: ${showCount(count)} of infinite mass, kinematic`)] : []),
    );
  }

  choose(way) {
    this.bar.hidden = this.numbers.hidden = this.scale.hidden = way !== 'range';
    this.species.hidden = way !== 'species';
  }
}

/** What the colors of events and cells mean. */
export function showEventLegend(hasWalls, mayMerge) {
  const entries = [
    ['collision', 'collision', ''],
    ...(mayMerge ? [['merger', 'merger', '']] : []),
    ...(hasWalls ? [['wall', 'wall contact', '']] : []),
    ['enter', 'cell just entered', 'square'],
    ['leave', 'cell just left', 'square'],
  ];
  const place = document.getElementById('legend-events');
  place.replaceChildren(...entries.map(([name, text, shape]) => swatch(kEventColors[name], text, shape)));
}

/** What the colors of `surfaces` mean; `colors`: one for each. */
export function showSurfaceLegend(surfaces, colors) {
  const place = document.getElementById('legend-surfaces');
  const shown = surfaces
    .slice(0, kMostSurfaces)
    .map((surface, k) => swatch(colors[k], describe(surface), 'square'));
  place.replaceChildren(...shown);
  if (surfaces.length > kMostSurfaces) place.append(`and ${showCount(surfaces.length - kMostSurfaces)} more`);
}

/** What the colors of forces mean, if there are any. */
export function showForceLegend(areAny) {
  document.getElementById('forces').hidden = !areAny;
  document.getElementById('forces-bar').style.background = mapGradient();
  document.getElementById('forces-strong').textContent = `${kStrongForce} times the mean`;
}

// The colors of the map, side by side.
function mapGradient() {
  return `linear-gradient(to right, ${kMapColors.map(toCss).join(', ')})`;
}

function describe(surface) {
  const parts = [surface.name];
  if (surface.temperature !== null) parts.push(`kT = ${show(surface.temperature, 3)} M L² T⁻²`);
  if (surface.oscillates) parts.push('oscillates');
  if (surface.velocity.some((part) => part !== 0)) parts.push('moves');
  return parts.join(', ');
}

/** An entry of a legend: a mark of a color, square or round, and what it means. */
export function swatch(color, text, shape = '') {
  const item = document.createElement('li');
  const mark = document.createElement('span');
  mark.className = `swatch ${shape}`;
  mark.style.background = toCss(color);
  item.append(mark, text);
  return item;
}
