// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { Bodies } from './bodies.js';
import { Playback } from './playback.js';

const kLongestFrame = 0.1; // seconds; a page that was hidden continues where it was

/**
 * The clock: which time is shown, and which comes next.
 * If the chunk of a time is not in memory, it waits for it.
 */
export class Player {
  constructor(source, store) {
    this.source = source;
    this.store = store;
    const bodies = new Bodies(source.radii, source.masses);
    this.playback = new Playback(source.header.spheres, (number) => store.get(number), bodies);
    /** Time per second [T]. */
    this.speed = 1;
    this.isPlaying = false;
    /** Whether a chunk is being waited for. */
    this.isBuffering = true;
    /** The time to show as soon as its chunk is there [T]; null if it is shown. */
    this.wanted = source.header.begin;
    this.waiting = [];
  }

  /** The time shown [T]; the start of the recording while nothing is shown. */
  get time() {
    return this.playback.chunk ? this.playback.time : this.source.header.begin;
  }

  /** How far the recording is known [T]. */
  get knownEnd() {
    return this.source.ends.at(-1) ?? this.source.header.begin;
  }

  get isAtEnd() {
    return this.time >= this.knownEnd;
  }

  play() {
    if (this.isAtEnd && this.source.status.finished) this.seek(this.source.header.begin);
    this.isPlaying = true;
  }

  pause() {
    this.isPlaying = false;
  }

  /** Shows `time` [T], or the nearest known time; the promise resolves once it is shown. */
  seek(time) {
    this.wanted = Math.min(Math.max(time, this.source.header.begin), this.knownEnd);
    return new Promise((resolve) => this.waiting.push(resolve));
  }

  /** Shows `time` [T], or the nearest known time, without waiting for the next frame of the page. Error: its chunk cannot be loaded. */
  async showAt(time) {
    const wanted = Math.min(Math.max(time, this.source.header.begin), this.knownEnd);
    const number = this.store.numberAt(wanted);
    this.store.focus(number);
    await this.store.load(number);
    this.wanted = wanted;
    this.show();
  }

  /** Advances by `seconds` of real time, as far as the recording is in memory. */
  advance(seconds) {
    if (this.wanted === null && this.isPlaying) {
      const next = this.time + this.speed * Math.min(seconds, kLongestFrame);
      this.wanted = Math.min(next, this.knownEnd);
      if (this.isAtEnd && this.source.status.finished) this.isPlaying = false;
    }
    if (this.wanted !== null) this.show();
    this.store.focus(
      this.wanted === null ? Math.max(this.playback.number, 0) : this.store.numberAt(this.wanted),
    );
  }

  show() {
    if (this.source.ends.length === 0) return;
    const number = this.store.numberAt(this.wanted);
    const chunk = this.store.get(number);
    this.isBuffering = chunk === undefined;
    if (this.isBuffering) return;
    this.playback.moveTo(this.wanted, chunk, number);
    this.wanted = null;
    for (const resolve of this.waiting.splice(0)) resolve(this.time);
  }

  /**
   * Shows the time of the next contact, of sphere `id` or, if that is null, of any; the end of what is known if
   * there is none.
   */
  async stepForward(id = null) {
    this.pause();
    const { ends } = this.source;
    let number = Math.max(this.playback.number, 0);
    let from = this.playback.cursor;
    for (; number < ends.length; ++number, from = 0) {
      const chunk = await this.store.load(number);
      for (let k = from; k < chunk.contacts; ++k) {
        if (chunk.isContact(k, id)) return this.seek(chunk.time(k));
      }
    }
    return this.seek(this.knownEnd);
  }

  /** Shows the time of the last contact before the present one, as `stepForward` does; the start if there is none. */
  async stepBack(id = null) {
    this.pause();
    const time = this.time;
    for (let number = this.playback.number; number >= 0; --number) {
      const chunk = await this.store.load(number);
      for (let k = chunk.contacts - 1; k >= 0; --k) {
        if (chunk.time(k) < time && chunk.isContact(k, id)) return this.seek(chunk.time(k));
      }
    }
    return this.seek(this.source.header.begin);
  }
}
