// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { show, showTime } from './numbers.js';

const kScrubSteps = 100000;

/** Play, pause, steps, the scrub bar, and the speed slider. */
export class Transport {
  constructor(viewer) {
    this.viewer = viewer;
    this.player = viewer.player;
    const element = (id) => document.getElementById(id);
    this.buttons = {
      play: element('play'),
      home: element('home'),
      back: element('back'),
      forward: element('forward'),
      end: element('end'),
    };
    this.time = element('time');
    this.scrub = element('scrub');
    this.speed = element('speed');
    this.speedText = element('speed-text');
    this.isScrubbing = false;

    this.buttons.play.addEventListener('click', () => viewer.togglePlay());
    this.buttons.home.addEventListener('click', () => viewer.goToBegin());
    this.buttons.end.addEventListener('click', () => viewer.goToEnd());
    this.buttons.back.addEventListener('click', (event) => viewer.step(-1, event.shiftKey));
    this.buttons.forward.addEventListener('click', (event) => viewer.step(1, event.shiftKey));
    this.scrub.addEventListener('input', () => {
      const { begin } = this.player.source.header;
      this.isScrubbing = true;
      this.player.seek(begin + (Number(this.scrub.value) / kScrubSteps) * (this.last - begin));
    });
    this.scrub.addEventListener('change', () => (this.isScrubbing = false));
    this.speed.addEventListener('input', () => viewer.setSpeed(10 ** Number(this.speed.value)));
  }

  /** Sets the range of the speed slider to three powers of ten below and two above `middle` [T per second]. */
  center(middle) {
    this.speed.min = Math.log10(middle) - 3;
    this.speed.max = Math.log10(middle) + 2;
  }

  /** The time at the end of the scrub bar [T]. */
  get last() {
    const { header, status } = this.player.source;
    const { knownEnd } = this.player;
    return status.finished || header.until === null ? knownEnd : Math.max(knownEnd, header.until);
  }

  update() {
    const { player } = this;
    const { begin } = player.source.header;
    const length = this.last - begin;
    const share = (time) => (length > 0 ? (time - begin) / length : 0);
    const text = showTime(player.time, Math.max(Math.min(length / 1e4, player.speed / 100), 1e-12));
    if (this.time.value !== `${text} T`) this.time.value = `${text} T`;
    if (!this.isScrubbing) {
      const value = String(Math.round(kScrubSteps * share(player.time)));
      if (this.scrub.value !== value) this.scrub.value = value;
    }
    set(this.scrub, 'aria-valuetext', `time ${text}`);
    property(this.scrub, '--at', (100 * Number(this.scrub.value)) / kScrubSteps);
    property(this.scrub, '--until', 100 * share(player.knownEnd));

    const { play } = this.buttons;
    set(play, 'aria-label', player.isPlaying ? 'Pause' : 'Play');
    set(play, 'data-playing', String(player.isPlaying));
    if (this.shownSpeed !== player.speed) {
      this.shownSpeed = player.speed;
      this.speed.value = Math.log10(player.speed);
      this.speedText.value = `${show(player.speed, 2)} T per s`;
      set(this.speed, 'aria-valuetext', `${show(player.speed, 2)} T per second`);
      property(
        this.speed,
        '--at',
        (100 * (this.speed.value - this.speed.min)) / (this.speed.max - this.speed.min),
      );
    }
  }
}

function set(element, name, value) {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

function property(element, name, percent) {
  const value = `${Math.min(100, Math.max(0, percent)).toFixed(2)}%`;
  if (element.style.getPropertyValue(name) !== value) element.style.setProperty(name, value);
}
