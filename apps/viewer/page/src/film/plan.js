// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kSecondsOfTurn = 8; // how long the film of one moment takes, in which the camera goes around
const kRounding = 1e-9; // of a frame

/**
 * Which moments a film shows: from time `from` to `to` [T], `speed` [T] in a second, which has `fps` frames, while the camera
 * turns by `turn` degrees. Where no time passes, only the camera moves.
 */
export class Plan {
  constructor({ from, to, speed, fps, turn = 0 }) {
    Object.assign(this, { from, to, fps, turn });
    /** Between two frames [T]. */
    this.step = to > from ? speed / fps : 0;
    const still = turn === 0 ? 1 : Math.max(1, Math.round(kSecondsOfTurn * fps));
    /** How many frames there are. */
    this.count = to > from ? Math.floor((to - from) / this.step + kRounding) + 1 : still;
  }

  /** The plan of a single picture at `time` [T]. */
  static ofPicture(time) {
    return new Plan({ from: time, to: time, speed: 1, fps: 1 });
  }

  /** How long the film takes [s]. */
  get seconds() {
    return this.count / this.fps;
  }

  /** The time that frame `k` shows [T]: exact, and not the sum of steps. */
  timeOf(k) {
    return Math.min(this.from + k * this.step, this.to);
  }

  /** The angle to which the camera has turned in frame `k`: a film of a full turn can be repeated. */
  angleOf(k) {
    return ((this.turn * Math.PI) / 180) * (k / this.count);
  }
}
