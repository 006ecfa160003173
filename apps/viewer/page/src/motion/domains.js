// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kNone = [];

/** How a live run divides the box among domains, of which each has a block. */
export class Domains {
  constructor() {
    this.divisions = [];
  }

  /** Takes over the divisions of a status: a list of {from, blocks: [{low, high}]}; null is infinite. */
  update(divisions = []) {
    for (const { from, blocks } of divisions.slice(this.divisions.length)) {
      const ends = (place, infinity) => place.map((x) => x ?? infinity);
      this.divisions.push({
        from,
        blocks: blocks.map(({ low, high }) => ({ low: ends(low, -Infinity), high: ends(high, Infinity) })),
      });
    }
  }

  /** Whether there are several domains, at any time. */
  get areSeveral() {
    return this.divisions.some(({ blocks }) => blocks.length > 1);
  }

  /** The blocks at `time` [T]; none if the run has no domains. */
  at(time) {
    return (this.divisions.findLast(({ from }) => from <= time) ?? this.divisions[0])?.blocks ?? kNone;
  }
}

/**
 * The number of the block that `center` is in, three numbers inside the box [L]; of the nearest, should rounding have
 * put it beside all. -1 if there are none.
 */
export function nearestBlock(blocks, center) {
  let nearest = -1;
  let least = Infinity;
  for (let k = 0; k < blocks.length; ++k) {
    const { low, high } = blocks[k];
    let outside = -Infinity;
    for (let axis = 0; axis < 3; ++axis)
      outside = Math.max(outside, low[axis] - center[axis], center[axis] - high[axis]);
    if (nearest < 0 || outside < least) [nearest, least] = [k, outside];
  }
  return nearest;
}
