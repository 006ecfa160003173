// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { kWindowColors, toCss } from '../scene/colors.js';
import { swatch } from './legend.js';
import { showCount } from './numbers.js';

/** How the windows of time of a run's domains have ended. */
export class WindowsPanel {
  constructor() {
    this.section = document.getElementById('windows');
    this.bar = document.getElementById('windows-bar');
    this.legend = document.getElementById('legend-windows');
    this.parts = Object.fromEntries(
      Object.entries(kWindowColors).map(([name, color]) => {
        const part = document.createElement('span');
        part.style.background = toCss(color);
        return [name, part];
      }),
    );
    this.bar.append(...Object.values(this.parts));
  }

  /** Shows the `windows` of a status, if `areSeveral` domains have run them. */
  update(windows, areSeveral) {
    this.section.hidden = !areSeveral;
    if (!areSeveral) return;
    const { committed, failed, steps } = windows;
    const key = `${committed} ${failed} ${steps}`;
    if (key === this.key) return;
    this.key = key;
    const counts = { committed: committed - steps, failed, steps };
    const words = { committed: 'committed', failed: 'failed', steps: steps === 1 ? 'single step' : 'single steps' };
    for (const [name, part] of Object.entries(this.parts)) part.style.flexGrow = counts[name];
    this.legend.replaceChildren(
      ...Object.entries(kWindowColors).map(([name, color]) =>
        swatch(color, `${showCount(counts[name])} ${words[name]}`, 'square'),
      ),
    );
  }
}
