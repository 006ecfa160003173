// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kPatience = 100; // ms between looks at whether the viewer is ready

/** The page of the viewer in a frame, fed by a run. */
export class ViewerFrame {
  /** `state`: how the viewer begins, as its address has it. */
  constructor(parent, state = '') {
    this.parent = parent;
    this.state = state;
    this.frame = null;
    addEventListener('message', ({ data, source }) => {
      if (data === 'hardball-ready' && source === this.frame?.contentWindow) this.feed();
    });
  }

  /** Shows the recording of a run, with the camera of the one before. */
  show(run) {
    this.clear();
    this.run = run;
    this.frame = document.createElement('iframe');
    this.frame.title = 'The spheres, moving';
    this.frame.src = `view/index.html?source=port${this.state ? `#${this.state}` : ''}`;
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
    try {
      return this.frame.contentWindow.location.hash.slice(1) || this.state;
    } catch {
      return this.state;
    }
  }

  feed() {
    const { port1, port2 } = new MessageChannel();
    const { frame } = this;
    this.run.serve(port1).catch(() => {}); // if the run was closed meanwhile
    frame.contentWindow.postMessage('hardball-source', location.origin, [port2]);
    if (!matchMedia('(prefers-reduced-motion: reduce)').matches) this.playWhenReady(frame);
  }

  playWhenReady(frame) {
    if (this.frame !== frame) return;
    const viewer = frame.contentWindow.hardball;
    if (viewer?.state().isReady) viewer.play();
    else setTimeout(() => this.playWhenReady(frame), kPatience);
  }
}
