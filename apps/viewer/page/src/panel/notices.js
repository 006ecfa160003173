// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/** Short messages over the picture, one per matter. */
export class Notices {
  constructor() {
    this.place = document.getElementById('notices');
    this.shown = new Map();
  }

  /** Shows `text` about `matter`, as "bad" news or as "good" ones, with a button if `action` is {label, run}. */
  show(matter, text, { kind = 'good', action = null } = {}) {
    let notice = this.shown.get(matter);
    if (!notice) {
      notice = document.createElement('p');
      this.shown.set(matter, notice);
      this.place.append(notice);
    }
    if (notice.text === text) return;
    notice.text = text;
    notice.dataset.kind = kind;
    notice.replaceChildren(text);
    if (action) {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = action.label;
      button.addEventListener('click', action.run);
      notice.append(button);
    }
  }

  hide(matter) {
    this.shown.get(matter)?.remove();
    this.shown.delete(matter);
  }
}
