// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { readCenter, readVelocity } from '../motion/path.js';
import { partnerName } from '../motion/surfaces.js';
import { kPathNumbers } from '../recording/chunk.js';
import { show, showCount } from './numbers.js';

const kAxes = ['x', 'y', 'z'];

/** The followed sphere in numbers. */
export class SpherePanel {
  constructor(viewer) {
    this.viewer = viewer;
    this.card = document.getElementById('sphere');
    this.number = document.getElementById('follow-id');
    this.number.max = viewer.source.header.spheres - 1;
    this.number.addEventListener('change', () => {
      viewer.follow(this.number.value === '' ? null : Number(this.number.value));
    });
    document.getElementById('unfollow').addEventListener('click', () => viewer.follow(null));
    document.getElementById('approach').addEventListener('click', () => viewer.approach());
  }

  update() {
    const { playback, followed, source, box, next, surfaces, species, canTurn, contacts } = this.viewer;
    this.card.hidden = followed === null;
    if (document.activeElement !== this.number) this.number.value = followed ?? '';
    if (followed === null) return;
    text('sphere-number', showCount(followed));
    const start = kPathNumbers * followed;
    const { paths, time } = playback;
    const { bodies } = playback;
    const axes = box.dimensions;
    const velocity = readVelocity(paths, start, time, box, [0, 0, 0]);
    const vector = (numbers) => Array.from(numbers, (number) => show(number, 4)).join('  ');
    text('sphere-position', vector(readCenter(paths, start, time, box, [0, 0, 0]).slice(0, axes)));
    text('sphere-velocity', vector(velocity.slice(0, axes)));
    text('sphere-speed', show(Math.hypot(...velocity)));
    const mass = bodies.isKinematic(followed) ? 'kinematic' : show(bodies.masses[followed]);
    text('sphere-kind', bodies.exists(followed) ? `${show(bodies.radii[followed])}, ${mass}` : 'merged');
    document.getElementById('sphere-species-row').hidden = species === null;
    if (species) text('sphere-species', species.list[species.of[followed]].name);
    const { domains } = this.viewer;
    document.getElementById('sphere-domain-row').hidden = !domains.areSeveral;
    if (domains.areSeveral) text('sphere-domain', String(this.viewer.domainOf(followed)));
    document.getElementById('sphere-contacts-row').hidden = contacts === null;
    if (contacts) text('sphere-contacts', showCount(contacts[followed]));
    document.getElementById('sphere-spin-row').hidden = !canTurn;
    const spin = bodies.spin(followed);
    if (canTurn) text('sphere-spin', axes === 2 ? show(spin[2], 4) : vector(spin));
    text('sphere-collisions', showCount(playback.collisions[followed]));
    const isWhole = playback.countedFrom <= source.header.begin;
    text(
      'sphere-collisions-label',
      isWhole ? 'Collisions' : `Collisions since ${show(playback.countedFrom)} T`,
    );
    text(
      'sphere-next',
      next ? `${partner(next, followed, surfaces)} in ${show(next.time - time, 3)} T` : 'unknown',
    );
    text('sphere-crossing', this.crossing());
  }

  crossing() {
    const { cells, playback, followed, next } = this.viewer;
    if (!cells || !playback.bodies.exists(followed)) return '–';
    const path = playback.paths.subarray(kPathNumbers * followed, kPathNumbers * (followed + 1));
    const { time, kind, axis } = cells.nextCrossing(path, playback.bodies.radii[followed], playback.time);
    if (!Number.isFinite(time)) return 'none: at rest';
    if (next && time > next.time) return 'after the contact';
    return `${kind} along ${kAxes[axis]} in ${show(time - playback.time, 3)} T`;
  }
}

function partner({ first, second }, id, surfaces) {
  return partnerName(second === id ? first : second, surfaces);
}

function text(id, value) {
  const element = document.getElementById(id);
  if (element.textContent !== value) element.textContent = value;
}
