// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { show } from './numbers.js';

const kAxes = ['x', 'y', 'z'];
const kSteps = 1000;

/** Which slice of the spheres is drawn: those whose centers are between two places along an axis. */
export class Slice {
  constructor(viewer) {
    this.viewer = viewer;
    const element = (id) => document.getElementById(id);
    this.choice = element('slice-axis');
    this.sliders = { middle: element('slice-middle'), width: element('slice-width') };
    this.ends = element('slice-ends');
    this.description = element('slice-text');
    /** The axis, and the two places along it [L]; null if all spheres are drawn. */
    this.value = null;
    this.choice.addEventListener('change', () => this.choose());
    for (const slider of Object.values(this.sliders)) slider.addEventListener('input', () => this.choose());
    if (viewer.box.isFlat) this.choice.querySelector('[value="z"]').remove();
  }

  /** As in a link. */
  get text() {
    return this.value && `${kAxes[this.value.axis]},${this.value.low},${this.value.high}`;
  }

  /** Takes it over from a link. */
  read(text) {
    const [name, low, high] = (text ?? '').split(',');
    const axis = kAxes.indexOf(name);
    const isMeant = axis >= 0 && axis < this.viewer.box.dimensions && Number(low) < Number(high);
    this.set(isMeant ? { axis, low: Number(low), high: Number(high) } : null);
    const [from, to] = this.span(axis);
    if (this.value === null) return;
    this.sliders.middle.value = (kSteps * ((this.value.low + this.value.high) / 2 - from)) / (to - from);
    this.sliders.width.value = (kSteps * (this.value.high - this.value.low)) / (to - from);
  }

  /** Whether a center is in it. */
  has(center) {
    if (this.value === null) return true;
    const { axis, low, high } = this.value;
    return center[axis] >= low && center[axis] <= high;
  }

  // What the controls say.
  choose() {
    const axis = kAxes.indexOf(this.choice.value);
    if (axis < 0) return this.set(null);
    const [from, to] = this.span(axis);
    const at = (slider) => (Number(slider.value) / kSteps) * (to - from);
    const [middle, half] = [from + at(this.sliders.middle), at(this.sliders.width) / 2];
    const rounded = (place) => Number(place.toPrecision(5));
    this.set({ axis, low: rounded(middle - half), high: rounded(middle + half) });
  }

  set(value) {
    const { spheres, view } = this.viewer;
    this.value = value;
    this.choice.value = value ? kAxes[value.axis] : '';
    this.ends.hidden = value === null;
    if (value) this.description.textContent = `${kAxes[value.axis]} from ${show(value.low)} to ${show(value.high)} L`;
    spheres.slice(value ? value.axis : null, value?.low, value?.high);
    view.isStale = true;
  }

  // Between which places all spheres are along an axis [L].
  span(axis) {
    const [low, high] = this.viewer.surroundings.extent;
    return axis < 0 ? [0, 1] : [low[axis], high[axis]];
  }
}
