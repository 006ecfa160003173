// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { show } from './numbers.js';

const kMostPixels = 140;

/** A round length and how wide it is drawn where a pixel is `lengthOfPixel` [L] wide: {length, pixels}. */
export function scaleOf(lengthOfPixel) {
  const most = kMostPixels * lengthOfPixel;
  const power = 10 ** Math.floor(Math.log10(most));
  const length = power * [5, 2, 1].find((digit) => digit * power <= most * (1 + 1e-9));
  return { length, pixels: length / lengthOfPixel };
}

/** The scale of the picture, at the distance of its middle. */
export class ScaleBar {
  constructor() {
    this.bar = document.getElementById('scale-bar');
    this.text = document.getElementById('scale-text');
  }

  update(lengthOfPixel) {
    if (!(lengthOfPixel > 0) || lengthOfPixel === this.shown) return;
    this.shown = lengthOfPixel;
    const { length, pixels } = scaleOf(lengthOfPixel);
    this.bar.style.width = `${pixels.toFixed(1)}px`;
    this.text.textContent = `${show(length, 1)} L`;
  }
}
