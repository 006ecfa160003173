// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kSlow = 1 / 18; // seconds of a frame
const kFramesLooked = 24;
const kFewestFrames = 3;
const kSecondsLooked = 2;

/** Ways of drawing, the best first. */
export const kWays = [
  { name: 'full', spheres: 'impostors', mostPixelRatio: 2 },
  { name: 'reduced', spheres: 'impostors', mostPixelRatio: 1 },
  { name: 'points', spheres: 'points', mostPixelRatio: 1 },
  { name: 'coarse', spheres: 'points', mostPixelRatio: 0.6 },
];

/** Watches how long frames take, and takes a cheaper way of drawing where the machine is too slow. */
export class Quality {
  /** `pixelRatio`: that of the screen; `onChange(way)` is told of each new way. */
  constructor(pixelRatio, onChange) {
    this.pixelRatio = pixelRatio;
    this.onChange = onChange;
    this.level = 0;
    this.isFixed = false;
    /** Frames drawn in a second, as of late; 0 if it is not known. */
    this.framesPerSecond = 0;
    this.seconds = 0;
    this.frames = 0;
  }

  get way() {
    return kWays[this.level];
  }

  /** Begins with the way called `name`. */
  begin(name) {
    this.choose(kWays.findIndex((way) => way.name === name));
  }

  /** Keeps to the way called `name` from here on. */
  fix(name) {
    this.isFixed = true;
    this.begin(name);
  }

  /** Takes note of a frame that came `seconds` after the one before it. */
  note(seconds) {
    this.seconds += seconds;
    ++this.frames;
    if (this.frames < kFewestFrames || (this.frames < kFramesLooked && this.seconds < kSecondsLooked)) return;
    const mean = this.seconds / this.frames;
    this.framesPerSecond = 1 / mean;
    this.seconds = this.frames = 0;
    if (!this.isFixed && mean > kSlow && this.level + 1 < kWays.length) this.choose(this.nextLevel());
  }

  /** Forgets the frames noted: the drawing was interrupted. */
  restart() {
    this.seconds = this.frames = 0;
  }

  // A step that changes nothing on this screen is left out.
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
