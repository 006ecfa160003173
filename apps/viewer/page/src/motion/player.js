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
    /** Whether only moments are recorded, each at the begin of a chunk, and not the motion between them. */
    this.hasMoments = source.header.moments !== undefined;
    const bodies = new Bodies(source.radii, source.masses);
    this.playback = new Playback(source.header.spheres, (number) => store.get(number), bodies);
    this.playback.hasMoments = this.hasMoments;
    /** The time that would be shown if all were recorded [T]. */
    this.clock = source.header.begin;
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
    return this.clock >= this.knownEnd;
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
    const number = this.numberAt(wanted);
    this.store.focus(number);
    await this.store.load(number);
    this.wanted = wanted;
    this.show();
  }

  /** Advances by `seconds` of real time, as far as the recording is in memory. */
  advance(seconds) {
    if (this.wanted === null && this.isPlaying) {
      const next = this.clock + this.speed * Math.min(seconds, kLongestFrame);
      this.wanted = Math.min(next, this.knownEnd);
      if (this.isAtEnd && this.source.status.finished) this.isPlaying = false;
    }
    if (this.wanted !== null) this.show();
    this.store.focus(
      this.wanted === null ? Math.max(this.playback.number, 0) : this.numberAt(this.wanted),
    );
  }

  show() {
    if (this.source.ends.length === 0) return;
    const number = this.numberAt(this.wanted);
    const chunk = this.store.get(number);
    this.isBuffering = chunk === undefined;
    if (this.isBuffering) return;
    this.clock = this.wanted;
    this.playback.moveTo(this.hasMoments ? chunk.begin : this.wanted, chunk, number);
    this.wanted = null;
    for (const resolve of this.waiting.splice(0)) resolve(this.time);
  }

  /** The number of the chunk that shows `time` [T]: at its end, that of a moment is over. */
  numberAt(time) {
    const number = this.store.numberAt(time);
    return this.hasMoments && time >= this.source.ends[number] ? Math.min(number + 1, this.source.ends.length - 1) : number;
  }

  /**
   * Shows the time of the next contact, of sphere `id` or, if that is null, of any; the end of what is known if
   * there is none. Of moments it shows the next.
   */
  async stepForward(id = null) {
    this.pause();
    if (this.hasMoments) return this.seek(this.playback.chunk.end);
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
    if (this.hasMoments) return this.seek((await this.store.load(Math.max(0, this.playback.number - 1))).begin);
    for (let number = this.playback.number; number >= 0; --number) {
      const chunk = await this.store.load(number);
      for (let k = chunk.contacts - 1; k >= 0; --k) {
        if (chunk.time(k) < time && chunk.isContact(k, id)) return this.seek(chunk.time(k));
      }
    }
    return this.seek(this.source.header.begin);
  }
}
