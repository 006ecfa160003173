// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import uPlot from 'uplot';
import { readCenter } from '../motion/path.js';
import { kPathNumbers } from '../recording/chunk.js';
import { summarize } from '../statistics/chunk_summary.js';
import { Displacement } from '../statistics/displacement.js';
import { radialDistribution } from '../statistics/pairs.js';
import { density, findKinds, maxwellDensity, quantile, readSpeeds, roundUp } from '../statistics/speeds.js';

const kHeight = 132;
const kMostPoints = 1500;
const kIntervals = 32;
const kMostMilliseconds = 30; // of work at a time
const kPairsPause = 30; // while a run is played, the time between two g(r) over that of finding one
const kFewestSpheres = 20; // fewer have no distribution of speeds worth a plot

/** The plots beside the picture: collision rate, speeds, and the energy where it is lost. */
export class Plots {
  /** `player` knows how far the recording is known; `surfaces`: as read by readSurfaces. */
  constructor({ header, masses }, player, box, surfaces) {
    this.box = box;
    this.begin = header.begin;
    this.masses = masses;
    this.kinds = null;
    this.summaries = new Map();
    this.speeds = new Float64Array(masses.length);
    this.time = NaN;

    this.knownEnd = NaN;
    this.player = player;
    const hasWalls = header.box.boundary.includes('wall') || surfaces.length > 0;
    this.rate = timePlot(
      'plot-rate',
      hasWalls ? ['Collisions', 'Wall contacts'] : ['Collisions'],
      ['--accent', '--second'],
      player,
    );
    this.hasWalls = hasWalls;
    document.getElementById('rate-key').hidden = !hasWalls;
    const hasOwnFaces = header.box.faces !== undefined; // thermal, inelastic or sliding
    const changes =
      header.restitution !== 1 || hasOwnFaces || surfaces.some((surface) => surface.changesEnergy);
    // Along periodic axes there is no height.
    const hasHeight = box.gravity.every((part, axis) => part === 0 || box.period[axis] === 0);
    this.energy =
      (changes || box.hasGravity) && hasHeight
        ? timePlot('plot-energy', ['Energy'], ['--accent'], player)
        : null;
    document.getElementById('figure-energy').hidden = this.energy === null;
    document.getElementById('energy-name').textContent = energyName(header, box);
    this.histogram = masses.length >= kFewestSpheres ? histogramPlot('plot-speeds') : null;
    document.getElementById('figure-speeds').hidden = this.histogram === null;
    const hasPairs = this.histogram !== null && !box.boundary.includes('open');
    this.pairs = hasPairs ? linePlot('plot-pairs', 'g(r)') : null;
    this.pairsAt = NaN;
    this.pairsNext = 0;
    document.getElementById('figure-pairs').hidden = !hasPairs;
    // Places in a box whose images slide say little about diffusion.
    this.displacement = this.histogram !== null && !box.isSheared ? new Displacement(masses, box) : null;
    this.squares = this.displacement ? timePlot('plot-displacement', ['Mean square'], ['--accent'], player) : null;
    document.getElementById('figure-displacement').hidden = this.squares === null;
    /** Hardly any sphere is faster [L/T]. */
    this.fastest = 0;
    /** Few spheres are faster [L/T]; changes only by much. */
    this.fast = 0;
    /** The same, of the time shown last alone. */
    this.fastNow = 0;
  }

  get all() {
    return [this.rate, this.energy, this.histogram, this.pairs, this.squares].filter((plot) => plot !== null);
  }

  /** Adds chunk `number`. */
  add(chunk, number) {
    if (this.summaries.has(number)) return;
    this.summaries.set(number, summarize(chunk, this.masses, this.begin, this.box.gravity, this.player.hasMoments));
    this.isStale = true;
  }

  /** Draws what has changed up to the time of `playback`; returns whether the speeds have. */
  update(playback) {
    if (this.isStale || this.player.knownEnd !== this.knownEnd) this.drawTimes();
    this.addDisplacement();
    this.isStale = false;
    this.knownEnd = this.player.knownEnd;
    this.updatePairs(playback);
    if (playback.time === this.time) return false;
    this.time = playback.time;
    const { masses, radii, count: present } = playback.bodies;
    const { count, energy } = readSpeeds(playback.paths, playback.time, masses, this.box, this.speeds);
    if (count === 0) return true;
    const speeds = this.speeds.subarray(0, count);
    this.fastest = steady(this.fastest, 1.15 * quantile(speeds, 0.99));
    const few = quantile(speeds, 0.94);
    this.fastNow = steady(0, few);
    this.fast = steady(this.fast, few);
    // Spheres change only where their number does: they merge.
    if (this.kinds === null || present !== this.present) this.kinds = findKinds(radii, masses).list;
    this.present = present;
    if (this.histogram) this.drawSpeeds(speeds, energy);
    return true;
  }

  /** Begins anew with this scale of speeds [L/T]; with that of the time shown if it is zero. */
  restart(fast) {
    this.fast = fast;
    this.time = NaN;
  }

  /** Moves the mark of the present to `time`. */
  mark(time) {
    for (const plot of [this.rate, this.energy, this.squares]) {
      if (!plot) continue;
      const { min, max } = plot.scales.x;
      const left = ((time - min) / (max - min)) * plot.over.clientWidth;
      const isSeen = time >= min && time <= max;
      plot.present.style.transform = `translateX(${isSeen ? left.toFixed(1) : -9}px)`;
    }
  }

  /** Fits the plots to their elements, in the colors of the page. */
  resize() {
    for (const plot of this.all) {
      const width = plot.root.parentElement.clientWidth;
      if (width > 0) plot.setSize({ width, height: kHeight });
    }
  }

  drawTimes() {
    const rows = [];
    let last = null;
    for (const number of [...this.summaries.keys()].sort((a, b) => a - b)) {
      // A line is interrupted where data are unknown.
      if (last !== null && number !== last + 1)
        rows.push({
          time: this.summaries.get(number)[0]?.time ?? 0,
          collisions: null,
          walls: null,
          energy: null,
        });
      rows.push(...this.summaries.get(number));
      last = number;
    }
    const step = Math.ceil(rows.length / kMostPoints);
    const shown = rows.filter((_, k) => k % step === 0);
    const column = (name) => shown.map((row) => row[name]);
    const rates = [column('time'), column('collisions')];
    if (this.hasWalls) rates.push(column('walls'));
    this.rate.setData(rates);
    this.energy?.setData([column('time'), column('energy')]);
  }

  // As many chunks as follow each other in memory, and not for long.
  addDisplacement() {
    const { displacement } = this;
    if (!displacement || this.player.hasMoments) return;
    const begin = performance.now();
    const before = displacement.next;
    for (;;) {
      const chunk = this.player.store.get(displacement.next);
      if (!chunk || performance.now() - begin > kMostMilliseconds) break;
      displacement.add(chunk);
    }
    if (displacement.next === before) return;
    const step = Math.ceil(displacement.times.length / kMostPoints);
    const shown = (list) => list.filter((_, k) => k % step === 0);
    this.squares.setData([[this.begin, ...shown(displacement.times)], [0, ...shown(displacement.squares)]]);
  }

  // They take longer than all else: while a run is played, not for every picture.
  updatePairs(playback) {
    const begin = performance.now();
    if (!this.pairs || playback.time === this.pairsAt || (this.player.isPlaying && begin < this.pairsNext)) return;
    this.drawPairs(playback);
    this.pairsAt = playback.time;
    const end = performance.now();
    this.pairsNext = end + kPairsPause * (end - begin);
  }

  drawPairs({ paths, time, bodies }) {
    const centers = new Float64Array(3 * this.masses.length);
    const center = [0, 0, 0];
    let count = 0;
    let radius = 0;
    for (let id = 0; id < this.masses.length; ++id) {
      if (!bodies.exists(id)) continue;
      centers.set(readCenter(paths, kPathNumbers * id, time, this.box, center), 3 * count++);
      radius += bodies.radii[id];
    }
    const found = radialDistribution(centers.subarray(0, 3 * count), radius / count, this.box, time);
    document.getElementById('figure-pairs').hidden = found === null;
    if (found) this.pairs.setData(found);
  }

  drawSpeeds(speeds, energy) {
    const shares = density(speeds, this.fastest, kIntervals);
    const temperature = (2 * energy) / (this.box.dimensions * speeds.length);
    const middles = Array.from(shares, (_, k) => ((k + 0.5) * this.fastest) / kIntervals);
    const curve = middles.map((speed) =>
      temperature > 0 ? maxwellDensity(speed, this.kinds, temperature, this.box.dimensions) : null,
    );
    this.histogram.setData([middles, Array.from(shares), curve]);
  }
}

function energyName({ bodies }, box) {
  const parts = ['Kinetic', ...(bodies ? ['rotational'] : []), ...(box.hasGravity ? ['potential'] : [])];
  return `${parts.join(parts.length > 2 ? ', ' : ' and ')} energy`;
}

// The end of a range that contains `value` and follows only large changes of it, so that axes stay still.
function steady(end, value) {
  return value > 1.1 * end || value < 0.6 * end ? roundUp(value) : end;
}

function property(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

function axis(extra) {
  return {
    stroke: () => property('--quiet'),
    grid: { stroke: () => property('--line'), width: 1 },
    ticks: { show: false },
    font: '11px system-ui, sans-serif',
    gap: 4,
    ...extra,
  };
}

function create(id, series, options) {
  const place = document.getElementById(id);
  return new uPlot(
    {
      width: place.clientWidth || 280,
      height: kHeight,
      padding: [8, 8, 0, 0],
      legend: { show: false },
      cursor: { show: false },
      series: [{}, ...series],
      axes: [
        axis({ size: 22, values: (_, values) => values.map(short) }),
        axis({ size: 44, values: (_, values) => values.map(short) }),
      ],
      ...options,
    },
    [[], ...series.map(() => [])],
    place,
  );
}

function short(value) {
  const size = Math.abs(value);
  const trim = (number) => String(Number(number.toPrecision(3)));
  if (size >= 1e9) return `${trim(value / 1e9)}G`;
  if (size >= 1e6) return `${trim(value / 1e6)}M`;
  if (size >= 1e4) return `${trim(value / 1e3)}k`;
  return size > 0 && size < 1e-3 ? value.toExponential(0) : trim(value);
}

function timePlot(id, labels, colors, player) {
  const series = labels.map((label, k) => ({
    label,
    stroke: () => property(colors[k]),
    width: 1.5,
    points: { show: (plot) => plot.data[0].length === 1 },
  }));
  const plot = create(id, series, {
    scales: {
      x: { time: false, range: () => [player.source.header.begin, player.knownEnd] },
      y: { range: (_, low, high) => [Math.min(0, 1.08 * low), high > 0 ? 1.08 * high : low < 0 ? 0 : 1] },
    },
  });
  plot.present = document.createElement('div');
  plot.present.className = 'present';
  plot.over.append(plot.present);
  return plot;
}

function linePlot(id, label) {
  const series = [{ label, stroke: () => property('--accent'), width: 1.5, points: { show: false } }];
  return create(id, series, {
    scales: { x: { time: false }, y: { range: (_, low, high) => [0, high > 0 ? 1.08 * high : 1] } },
  });
}

function histogramPlot(id) {
  return create(
    id,
    [
      {
        label: 'Speeds',
        fill: () => property('--bars'),
        stroke: () => property('--bars'),
        width: 0,
        paths: uPlot.paths.bars({ size: [0.86, 40], gap: 0 }),
        points: { show: false },
      },
      { label: 'Maxwell', stroke: () => property('--second'), width: 1.8, points: { show: false } },
    ],
    { scales: { x: { time: false }, y: { range: (_, low, high) => [0, high > 0 ? 1.08 * high : 1] } } },
  );
}
