// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kSlow = 1 / 18; // seconds of a frame
const kFramesLooked = 24;
const kFewestFrames = 3;
const kSecondsLooked = 2;

/** Drawing qualities, best first. */
export const kWays = [
  { name: 'full', spheres: 'impostors', mostPixelRatio: 2 },
  { name: 'reduced', spheres: 'impostors', mostPixelRatio: 1 },
  { name: 'points', spheres: 'points', mostPixelRatio: 1 },
  { name: 'coarse', spheres: 'points', mostPixelRatio: 0.6 },
];

/** Watches how long frames take, and lowers the quality if the machine is too slow. */
export class Quality {
  /** `pixelRatio`: that of the screen; `onChange(way)` is called on each change. */
  constructor(pixelRatio, onChange) {
    this.pixelRatio = pixelRatio;
    this.onChange = onChange;
    this.level = 0;
    this.isFixed = false;
    /** Recent frames per second; 0 if unknown. */
    this.framesPerSecond = 0;
    this.seconds = 0;
    this.frames = 0;
  }

  get way() {
    return kWays[this.level];
  }

  /** Whether there is a quality `name`. */
  isWay(name) {
    return kWays.some((way) => way.name === name);
  }

  /** Starts with quality `name`. */
  begin(name) {
    this.choose(kWays.findIndex((way) => way.name === name));
  }

  /** Fixes quality `name` from here on. */
  fix(name) {
    this.isFixed = true;
    this.begin(name);
  }

  /** Records a frame drawn `seconds` after the previous one. */
  note(seconds) {
    this.seconds += seconds;
    ++this.frames;
    if (this.frames < kFewestFrames || (this.frames < kFramesLooked && this.seconds < kSecondsLooked)) return;
    const mean = this.seconds / this.frames;
    this.framesPerSecond = 1 / mean;
    this.seconds = this.frames = 0;
    if (!this.isFixed && mean > kSlow && this.level + 1 < kWays.length) this.choose(this.nextLevel());
  }

  /** Discards the frames recorded: drawing was interrupted. */
  restart() {
    this.seconds = this.frames = 0;
  }

  // Skips a step that changes nothing on this screen.
  nextLevel() {
    const isWorse = (way) =>
      way.spheres !== this.way.spheres ||
      way.mostPixelRatio < Math.min(this.pixelRatio, this.way.mostPixelRatio);
    const next = kWays.findIndex((way, level) => level > this.level && isWorse(way));
    return next < 0 ? this.level : next;
  }

  choose(level) {
    if (level === this.level) return;
    this.level = level;
    this.restart();
    this.onChange(this.way);
  }
}
