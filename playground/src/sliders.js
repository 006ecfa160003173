// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { descriptionOf, nodeAt, numberNodeOf } from './schema.js';
import { numbersOf } from './toml_numbers.js';

const kMostSliders = 60;
const kAxes = ['x', 'y', 'z'];

// Numbers of lists of lists, such as positions, are too many for sliders.
function isSlid({ path }) {
  return !/\.\d+\.\d+$/.test(path);
}

function labelOf({ path }) {
  const vector = /\.(\d)$/.exec(path);
  const name = vector ? path.slice(0, -vector[0].length) : path;
  return vector ? `${name} ${kAxes[vector[1]] ?? vector[1]}` : name;
}

function magnitudeOf(number) {
  return number === 0 ? 1 : 10 ** Math.floor(Math.log10(Math.abs(number)));
}

/** The range of a slider for a number of the text: {min, max, step}. */
export function rangeOf({ value, isWhole }, node) {
  const whole = node ? node.multipleOf === 1 : isWhole;
  const [least, most] = [node?.minimum ?? -Infinity, node?.maximum ?? Infinity];
  if (whole) {
    return { min: Math.max(least, Math.floor(value / 4), value < 0 ? -Infinity : 0), max: Math.min(most, Math.max(10, 4 * value)), step: 1 };
  }
  if (most - least <= 2) return { min: least, max: most, step: 0.01 };
  const step = magnitudeOf(value) / 100;
  // Bounds such as 1e-60 stand for zero, which is excluded.
  const reach = value === 0 ? 2 : 4 * Math.abs(value);
  const low = value < 0 || (value === 0 && least < 0) ? -reach : least > 0 ? 10 * step : 0;
  return { min: Math.max(least, low), max: Math.min(most, value < 0 ? 0 : reach), step };
}

// As short as the step allows; with a point if the number had one.
function textOf(number, step, isWhole) {
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const text = String(Number(number.toFixed(Math.min(20, digits))));
  return isWhole || /[.e]/.test(text) ? text : `${text}.0`;
}

/** Sliders for the numbers of a scenario; they edit the numbers in the text, and leave all else as it is. */
export class Sliders {
  constructor(element, schema, editor) {
    this.element = element;
    this.schema = schema;
    this.editor = editor;
    this.shown = []; // paths
    this.isSliding = false;
  }

  /** Shows the numbers of the present text. */
  update() {
    if (this.isSliding) return;
    const numbers = numbersOf(this.editor.text).filter(isSlid).slice(0, kMostSliders);
    const paths = numbers.map(({ path }) => path);
    const inputs = [...this.element.querySelectorAll('input')];
    const areSame = paths.join() === this.shown.join();
    const fit = areSame && numbers.every(({ value }, k) => value >= Number(inputs[k].min) && value <= Number(inputs[k].max));
    if (fit) {
      numbers.forEach((number, k) => this.show(inputs[k], number.value));
      return;
    }
    this.shown = paths;
    this.element.replaceChildren(...numbers.map((number) => this.sliderOf(number)));
  }

  sliderOf(number) {
    const node = numberNodeOf(nodeAt(this.schema, number.keys));
    const { min, max, step } = rangeOf(number, node);
    const label = document.createElement('label');
    const name = document.createElement('span');
    const input = document.createElement('input');
    const output = document.createElement('output');
    name.textContent = labelOf(number);
    label.title = descriptionOf(nodeAt(this.schema, number.keys));
    Object.assign(input, { type: 'range', min, max, step });
    input.dataset.path = number.path;
    input.addEventListener('input', () => this.slide(input, step));
    label.append(name, input, output);
    this.show(input, number.value);
    return label;
  }

  show(input, value) {
    input.value = value;
    const words = String(Number(value.toPrecision(6)));
    input.setAttribute('aria-valuetext', words);
    input.parentElement?.querySelector('output').replaceChildren(words);
  }

  // The number may have moved in the text since.
  slide(input, step) {
    const number = numbersOf(this.editor.text).find(({ path }) => path === input.dataset.path);
    if (!number) return;
    const text = textOf(Number(input.value), step, number.isWhole && Number.isInteger(step));
    this.show(input, Number(text));
    this.isSliding = true;
    try {
      this.editor.replace(number.from, number.to, text);
    } finally {
      this.isSliding = false;
    }
  }
}
