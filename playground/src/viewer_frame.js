// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What the next run has in common with the one that is shown, of a state that the viewer has in its address.
function withoutTime(state) {
  const parts = new URLSearchParams(state);
  for (const name of ['t', 'play']) parts.delete(name);
  return String(parts);
}

/** The page of the viewer in a frame, fed by a run. */
export class ViewerFrame {
  constructor(parent) {
    this.parent = parent;
    this.state = '';
    this.frame = null;
    addEventListener('message', ({ data, source }) => {
      if (data === 'hardball-ready' && source === this.frame?.contentWindow) this.feed();
    });
  }

  /** Has the next run shown with this state, as the viewer has it in its address. */
  beginWith(state) {
    this.state = withoutTime(state);
  }

  /** Shows the recording of a run, with the camera of the one before. */
  show(run) {
    this.clear();
    this.run = run;
    this.frame = document.createElement('iframe');
    this.frame.title = 'The spheres, moving';
    const state = new URLSearchParams(this.state);
    if (!matchMedia('(prefers-reduced-motion: reduce)').matches) state.set('play', '1');
    this.frame.src = `view/index.html?source=port#${state}`;
    this.parent.append(this.frame);
  }

  clear() {
    if (!this.frame) return;
    this.state = this.viewState;
    this.frame.remove();
    this.frame = null;
  }

  /** How the viewer looks now, as its address has it. */
  get viewState() {
    const { protocol, hash } = this.frame?.contentWindow.location ?? {};
    return hash && protocol !== 'about:' ? withoutTime(hash.slice(1)) : this.state;
  }

  feed() {
    const { port1, port2 } = new MessageChannel();
    this.run.serve(port1).catch(() => {}); // if the run was closed meanwhile
    this.frame.contentWindow.postMessage('hardball-source', location.origin, [port2]);
  }
}
