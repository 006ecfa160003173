// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { Cells } from './motion/cells.js';
import { knownUntil, nextContact, recentPaths } from './motion/contacts_of.js';
import { typicalScales } from './motion/default_speed.js';
import { Box } from './motion/box.js';
import { Domains, nearestBlock } from './motion/domains.js';
import { countContacts } from './motion/forces.js';
import { readCenter, readVelocity } from './motion/path.js';
import { Player } from './motion/player.js';
import { partnerName, readSurfaces } from './motion/surfaces.js';
import { ChunkStore } from './recording/chunk_store.js';
import { kPathNumbers } from './recording/chunk.js';
import { Link } from './link.js';
import { ColorLegend, showEventLegend, showForceLegend, showSurfaceLegend } from './panel/legend.js';
import { show, showCount } from './panel/numbers.js';
import { Help } from './panel/help.js';
import { Shooting } from './panel/shooting.js';
import { Notices } from './panel/notices.js';
import { Plots } from './panel/plots.js';
import { showRunStatus } from './panel/run_status.js';
import { ScaleBar } from './panel/scale_bar.js';
import { SpherePanel } from './panel/sphere_panel.js';
import { Slice } from './panel/slice.js';
import { Transport } from './panel/transport.js';
import { WindowsPanel } from './panel/windows_panel.js';
import { CellLayer, kFew } from './scene/cell_layer.js';
import { kSpeciesColors } from './scene/colors.js';
import { EventFlashes } from './scene/event_flashes.js';
import { BondLines } from './scene/bond_lines.js';
import { ForceLines } from './scene/force_lines.js';
import { pick } from './scene/pick.js';
import { Quality } from './scene/quality.js';
import { Trails, VelocityArrows } from './scene/motion_lines.js';
import { kColorBy, kMeasured, Spheres } from './scene/spheres.js';
import { NeighborQuery } from './scene/surroundings.js';
import { Trail } from './scene/trail.js';
import { View } from './scene/view.js';
import { countNeighbors } from './statistics/neighbors.js';
import { Sizes } from './statistics/sizes.js';
import { findKinds, quantile, readSpecies, roundUp } from './statistics/speeds.js';

const kFewEnoughForFlashes = 3000; // spheres; with more, contacts would hide everything else
const kFlashSeconds = 0.6; // how long a flash lasts while playing
const kManyForSoftware = 2000; // spheres; with more, an emulated graphics card draws points from the start
const kContactsOfTrail = 24;
const kFewEnoughForNeighbors = 100_000; // spheres
const kFewEnoughForLines = 20_000; // spheres; with more, arrows and trails would hide each other
const kArrowRadii = 2.5; // length of the arrow of a typical sphere
const kTrailTimes = 3; // as long in time as arrows
const kSecondsBetweenPanels = 0.1;
const kSecondsBetweenPlots = 0.5;
const kScaleAmongForces = 0.4; // of radii, so that lines are seen
const kFirstDirection = [0.62, 0.42, 1]; // of the camera: to the right, upward, to the front
const kPollSeconds = 0.7;
const kRetrySeconds = 2;

// Of colorings, where numbers have one.
const kUnits = { speed: 'L T⁻¹', size: 'L', spin: 'T⁻¹', 'last contact': 'T', energy: 'M L² T⁻²' };

const element = (id) => document.getElementById(id);
const number = (id) => Number(element(id).value);

// The choice of a coloring.
function optionOf(name) {
  return new Option(name[0].toUpperCase() + name.slice(1), name);
}

// The unit vector against gravity; y if there is none.
function upwardOf(gravity) {
  const size = Math.hypot(...gravity);
  return size > 0 ? gravity.map((part) => -part / size) : [0, 1, 0];
}

/** The whole viewer: what is shown of a recording, and what its user does. */
export class Viewer {
  /** Precondition: `source` is open. */
  constructor(source) {
    this.source = source;
    const { header, radii, masses } = source;
    this.box = new Box(header.box, header.gravity);
    this.surfaces = readSurfaces(header);
    this.store = new ChunkStore(source, {
      onLoad: (chunk, number) => this.plots.add(chunk, number),
      onLost: () => this.lose(),
    });
    this.player = new Player(source, this.store);
    this.playback = this.player.playback;
    this.playback.surfaces = this.surfaces;
    this.bodies = this.playback.bodies;
    this.spheresAtStart = this.bodies.count;
    /** Whether spheres may spin, merge, and pass through each other. */
    this.canTurn = header.bodies;
    /** Whether the recording is of one moment, as that of a packing is. */
    this.isStill = header.until !== null && header.until <= header.begin && this.player.knownEnd <= header.begin;
    /** Whether it is, and no sphere moves at that moment; known from the first frame on. */
    this.isAtRest = false;
    /** The species that the recording names, or null. */
    this.species = readSpecies(header);
    this.kinds = this.species ?? findKinds(radii, masses);
    this.sizes = new Sizes(radii);
    this.largestRadius = this.sizes.largest;
    /** Of a live run; none of a recorded one. */
    this.domains = new Domains();

    this.view = new View(element('canvas'), this.box, upwardOf(this.box.gravity));
    /** How many others each sphere touches, where the recording says what touches; otherwise null. */
    this.contacts = header.forces?.length > 0 ? countContacts(header.forces, header.spheres) : null;
    this.spheres = new Spheres(this.bodies, this.kinds.of, this.box, this.canTurn, this.contacts);
    this.flashes = new EventFlashes(this.bodies.radii, this.box, this.surfaces);
    this.trail = new Trail(this.box);
    this.cellLayer = new CellLayer(this.bodies.radii, this.box);
    this.forceLines = new ForceLines(header.forces ?? [], this.bodies, this.box, this.spheres.uniforms);
    this.bondLines = new BondLines(header.bonds ?? [], this.bodies, this.box, this.spheres.uniforms);
    const { radii: radiiNow } = this.bodies;
    this.surroundings = new NeighborQuery(this.surfaces, radiiNow, this.box, this.spheres, this.largestRadius);
    this.arrows = new VelocityArrows(this.bodies, this.box, this.spheres.uniforms);
    this.trails = new Trails(this.bodies, this.box, this.spheres.uniforms);
    const lines = [this.forceLines, this.bondLines, this.arrows, this.trails];
    const layers = [this.flashes, this.trail, this.cellLayer, ...lines, this.surroundings];
    for (const { object } of [this.spheres, ...layers]) this.view.scene.add(object);

    this.notices = new Notices();
    this.plots = new Plots(source, this.player, this.box, this.surfaces);
    this.legend = new ColorLegend();
    this.transport = new Transport(this);
    this.spherePanel = new SpherePanel(this);
    this.windowsPanel = new WindowsPanel();
    this.scaleBar = new ScaleBar();
    this.help = new Help(this);
    this.shooting = new Shooting(this);
    this.slice = new Slice(this);
    this.quality = new Quality(window.devicePixelRatio, (way) => this.draw(way));

    this.link = new Link(this);

    /** The ends of the scale of colors, if they are to stay as they are; otherwise null. */
    this.fixedRange = null;
    /** The id of the followed sphere, or null. */
    this.followed = null;
    this.next = undefined;
    this.scales = null;
    this.cells = header.cell_edge[0] > 0 ? new Cells(header.cell_edge, header.cell_origin, this.box) : null;
    /** The edge of cells that was chosen [L], or null. */
    this.cellEdge = null;
    this.isLost = false;
    /** Whether pictures are drawn for others than the page. */
    this.isShooting = false;
    this.begun = new Promise((resolve) => (this.tellBegun = resolve));
    this.isDark = matchMedia('(prefers-color-scheme: dark)');
    this.last = { frame: 0, panels: -Infinity, plots: -Infinity, time: NaN };
    this.listen();
    this.style();
    showSurfaceLegend(this.surfaces, this.surroundings.layer.colors);
    this.legend.showKinematic(masses.filter((mass) => mass === Infinity).length);
    showForceLegend(this.hasForces);
    element('bonds-label').hidden = !this.hasBonds;
    element('spin-label').hidden = !this.canTurn;
    element('walls-label').hidden = this.surfaces.length === 0;
    element('images-label').hidden = !this.surroundings.images.isPeriodic;
    document.body.classList.toggle('is-still', this.isStill);
    document.body.classList.toggle('has-moments', this.player.hasMoments);
    if (this.player.hasMoments) this.showMoments();
    element('plots').hidden = this.isStill && this.plots.histogram === null;
    element('surroundings').hidden = this.surfaces.length === 0 && !this.surroundings.images.isPeriodic;
    this.showEvents();
    this.noteDomains();
  }

  /** Starts the animation. */
  start() {
    this.poll();
    requestAnimationFrame((now) => this.frame(now));
  }

  // --- what the user does ---

  togglePlay() {
    if (this.player.isPlaying) this.player.pause();
    else this.player.play();
    this.quality.restart();
  }

  /** Goes to the next contact, or to the previous one if `direction` < 0: any, or one of the followed sphere. */
  step(direction, isOfFollowed) {
    const id = isOfFollowed ? this.followed : null;
    const stepped = direction > 0 ? this.player.stepForward(id) : this.player.stepBack(id);
    return stepped.then(() => this.nameContacts(id)).catch(() => {});
  }

  // Says what meets at the time shown, of sphere `id` if it is not null.
  nameContacts(id) {
    const { chunk, cursor, time } = this.playback;
    const met = [];
    for (let k = cursor - 1; k >= 0 && chunk.time(k) === time; --k) {
      if (chunk.isContact(k, id)) met.unshift(k);
    }
    if (met.length === 0) return;
    const [first, second] = [chunk.first(met[0]), partnerName(chunk.second(met[0]), this.surfaces)];
    const more = met.length > 1 ? `, and ${showCount(met.length - 1)} more` : '';
    this.notices.show('contact', `Sphere ${first} meets ${second}${more}`);
    this.namedAt = time;
  }

  goToBegin() {
    return this.player.seek(this.source.header.begin);
  }

  goToEnd() {
    return this.player.seek(this.player.knownEnd);
  }

  /** Plays `speed` [T] in a second. */
  setSpeed(speed) {
    const low = 10 ** Number(this.transport.speed.min);
    const high = 10 ** Number(this.transport.speed.max);
    this.player.speed = Math.min(high, Math.max(low, speed));
    this.view.isStale = true;
  }

  /** Follows sphere `id`, or none if it is null. */
  follow(id) {
    const isThere = id !== null && Number.isInteger(id) && id >= 0 && id < this.source.header.spheres;
    this.followed = isThere ? id : null;
    this.spheres.uniforms.followed.value = this.followed ?? -1;
    this.trail.object.visible = isThere;
    this.trailKey = null;
    this.cellsGathered = null;
    this.view.isStale = true;
    this.last.panels = -Infinity;
  }

  /** Moves the camera to the followed sphere, so that the surrounding cells are seen best. */
  approach() {
    if (this.followed === null) return;
    element('near-only').checked = this.source.header.spheres > kFew;
    this.view.zoomTo(this.center(this.followed), 2.4 * this.reach);
  }

  /** Shows everything. */
  fit() {
    element('near-only').checked = false;
    element('camera-follows').checked = false;
    if (this.playback.chunk) this.view.fit(this.surroundings.measure(this.playback));
  }

  /** Shows everything as at the start. */
  resetView() {
    this.fit();
    if (this.playback.chunk) this.resetCamera(this.surroundings.measure(this.playback));
  }

  /**
   * Moves the camera to where it sees an extent, two corners [L], from the first direction; if `isTurned`, from all to which it
   * can turn aside.
   */
  resetCamera(extent, isTurned = false) {
    this.surroundings.extent = extent;
    this.view.fit(extent, kFirstDirection, isTurned);
  }

  /** Lets what surrounds the spheres reach over an extent, two corners [L]. */
  span(extent) {
    this.surroundings.extent = extent;
    this.view.span(extent);
  }

  /** The next picture follows from what it shows alone, and not from what was shown before. */
  settle() {
    this.spheres.forget();
    this.trailKey = null;
    this.cellsGathered = null;
    this.view.isStale = true;
  }

  /** What the spheres can be colored by. */
  get colorings() {
    return [...element('color-by').options].map(({ value }) => value);
  }

  /** Colors the spheres by one of kColorBy. */
  setColorBy(name) {
    element('color-by').value = name;
    this.spheres.uniforms.colorBy.value = kColorBy.indexOf(name);
    if (name === 'species') this.showSpecies();
    if (name === 'domain') this.showDomains();
    if (name !== this.colorBy) this.fixedRange = null; // it has other units
    this.colorBy = name;
    this.spheres.measured = null;
    this.spheres.forget();
    if (this.playback.chunk) this.measure();
    this.view.isStale = true;
    if (this.scales) this.updateColors();
  }

  /** Keeps the ends of the scale of colors, two different numbers; lets them follow what is shown if they are null. */
  fixRange(ends) {
    const isMeant = ends !== null && ends.every(Number.isFinite) && ends[0] !== ends[1];
    const isLogarithmic = this.spheres.uniforms.colorIsLogarithmic.value;
    this.fixedRange = isMeant && (!isLogarithmic || ends.every((end) => end > 0)) ? ends : null;
    if (this.scales) this.updateColors();
  }

  /** Draws in one of the qualities of Quality, and keeps it. */
  setQuality(name) {
    this.quality.fix(name);
    this.notices.hide('quality');
  }

  // --- positions ---

  /** Center of sphere `id` at the time shown, folded into the box [L]. */
  center(id) {
    return readCenter(this.playback.paths, kPathNumbers * id, this.playback.time, this.box, [0, 0, 0]);
  }

  /** Velocity of sphere `id` at the time shown [L/T]. */
  velocity(id) {
    return readVelocity(this.playback.paths, kPathNumbers * id, this.playback.time, this.box, [0, 0, 0]);
  }

  /** The orientation of sphere `id` at the time shown: a quaternion, its real part last. */
  orientation(id) {
    return this.bodies.orientation(id, this.playback.time - this.playback.paths[kPathNumbers * id + 6]);
  }

  /** The number of the domain in whose block sphere `id` is at the time shown; -1 without domains. */
  domainOf(id) {
    return nearestBlock(this.domains.at(this.playback.time), this.center(id));
  }

  /** Center of sphere `id` at `time` [T], or at the moment shown then, folded into the box [L]. Error: the chunk cannot be loaded. */
  async centerAt(id, time) {
    const chunk = await this.store.load(this.player.numberAt(time));
    const shown = this.player.hasMoments ? chunk.begin : time;
    const path = new Float64Array(kPathNumbers);
    chunk.readPath(id, chunk.contactsUntil(shown), path);
    return readCenter(path, 0, shown, this.box, [0, 0, 0]);
  }

  /** Whether the recording says what holds the spheres. */
  get hasForces() {
    return this.forceLines.forces.length > 0;
  }

  get hasBonds() {
    return this.bondLines.bonds.length > 0;
  }

  /** How far the neighborhood of the followed sphere reaches [L]. */
  get reach() {
    const edge = this.cells ? Math.max(...this.cells.edge) : 0;
    return Math.max(7 * this.largestRadius, Math.min(1.6 * edge, 25 * this.largestRadius));
  }

  // --- frame by frame ---

  frame(now) {
    requestAnimationFrame((next) => this.frame(next));
    if (this.isShooting) return;
    const seconds = (now - this.last.frame) / 1000;
    this.last.frame = now;
    this.player.advance(seconds);
    if (!this.playback.chunk) {
      this.notices.show(
        'wait',
        this.source.ends.length > 0 ? 'Loading …' : 'Waiting for the first contacts …',
      );
      return;
    }
    if (!this.scales) this.begin();
    const hasMoved = this.playback.time !== this.last.time;
    if (this.playback.time !== this.namedAt) this.notices.hide('contact');
    this.last.time = this.playback.time;
    this.view.controls.update();
    if (hasMoved || this.view.isStale) this.drawMoment();
    if (this.player.isPlaying && hasMoved) this.quality.note(seconds);
    else this.quality.restart();
    this.updateNumbers(now / 1000);
    this.link.update(now / 1000);
  }

  // The first frame: what depends on typical scales.
  begin() {
    this.scales = typicalScales(this.playback.chunk, this.source.radii, this.source.header);
    this.isAtRest = this.isStill && this.bodies.radii.every((_, id) => this.velocity(id).every((part) => part === 0));
    document.body.classList.toggle('is-at-rest', this.isAtRest);
    /** The time in which spheres go as far as their arrows [T]. */
    this.arrowTime = roundUp((kArrowRadii * this.largestRadius) / (this.scales.speed || 1));
    const times = [this.arrowTime, kTrailTimes * this.arrowTime].map((time) => `${show(time, 2)} T`);
    element('motion-text').textContent = `An arrow is the way in ${times[0]}, a trail that of the last ${times[1]}.`;
    element('motion').hidden = this.source.header.spheres > kFewEnoughForLines;
    this.transport.center(this.scales.playing);
    this.player.speed = this.scales.playing;
    this.plots.update(this.playback);
    this.view.resize();
    if (this.view.isSoftware && this.source.header.spheres > kManyForSoftware) this.quality.begin('points');
    this.view.fit(this.surroundings.measure(this.playback), kFirstDirection);
    element('show-events').checked =
      this.source.header.spheres <= kFewEnoughForFlashes && !this.player.hasMoments && !this.wantsCalm;
    this.showCellEdge();
    element('color-by').replaceChildren(...kColorBy.filter((name) => this.offersColoring(name)).map(optionOf));
    this.setColorBy(this.firstColoring());
    this.plots.resize();
    this.link.begin().then(this.tellBegun);
  }

  /**
   * Draws the moments of `plan`, in pictures of `size` {width, height}, and calls `take(number)` for each, which must read the
   * picture before it waits for anything; false ends it. Then the page shows what it has shown before. Error: a picture is too
   * large, or a chunk cannot be loaded.
   */
  async shoot(plan, size, take) {
    const { player, view } = this;
    const [pose, time, wasPlaying] = [view.pose, player.time, player.isPlaying];
    player.pause();
    this.isShooting = true;
    try {
      view.takeSize(size);
      for (let number = 0; number < plan.count; ++number) {
        await player.showAt(plan.timeOf(number));
        if (plan.turn !== 0) view.place(pose);
        if (plan.turn !== 0) view.turn(plan.angleOf(number), 0);
        if (this.plots.update(this.playback)) this.updateColors();
        this.spheres.forget();
        this.drawMoment();
        if ((await take(number)) === false) break;
      }
    } finally {
      view.takeSize(null);
      view.place(pose);
      await player.showAt(time);
      if (wasPlaying) player.play();
      this.isShooting = false;
      this.last.frame = performance.now();
    }
  }

  drawMoment() {
    const { uniforms } = this.spheres;
    const followed = this.followed ?? -1;
    const window = kFlashSeconds * this.player.speed;
    this.measure();
    this.spheres.divide(this.domains.at(this.playback.time));
    this.spheres.update(this.playback);
    this.largestRadius = this.surroundings.largestRadius = this.playback.scale * this.sizes.largest;
    const [walls, images] = [element('show-walls').checked, element('show-images').checked];
    this.surroundings.update(this.playback, { walls, images });
    this.forceLines.object.visible = this.hasForces && element('show-forces').checked;
    if (this.forceLines.object.visible) {
      this.forceLines.update(this.playback);
      uniforms.scale.value *= kScaleAmongForces;
    }
    this.bondLines.object.visible = this.hasBonds && element('show-bonds').checked;
    if (this.bondLines.object.visible) this.bondLines.update(this.playback);
    this.updateMotion();
    uniforms.hasMarks.value = this.canTurn && element('show-spin').checked;
    uniforms.leastPixels.value = this.sizes.leastPixels * this.view.pixelRatio;
    if (followed >= 0) {
      const center = this.center(followed);
      uniforms.followedCenter.value.set(...center);
      if (element('camera-follows').checked) this.view.lookAlong(center);
      this.updateTrail(center);
    }
    uniforms.reach.value = followed >= 0 && element('near-only').checked ? this.reach : 0;
    this.flashes.object.visible = element('show-events').checked;
    if (this.flashes.object.visible) this.flashes.update(this.playback, window);
    this.cellLayer.object.visible = element('show-cells').checked && this.cells !== null;
    if (this.cellLayer.object.visible) this.updateCells(followed, window);
    for (const { pixels } of [uniforms, this.flashes.rings.uniforms, this.trail.rings.uniforms])
      pixels.value = this.view.pixels;
    this.view.prepare(uniforms.haze.value);
    uniforms.fromCamera.value.setFromMatrix4(this.view.camera.matrixWorld);
    this.view.render();
    this.scaleBar.update(this.view.lengthOfPixel);
  }

  // What spheres are colored by, if it is measured for each picture.
  measure() {
    if (!kMeasured.includes(this.colorBy)) return;
    const { bodies, playback, box } = this;
    if (this.colorBy === 'energy') {
      const energy = (id) => (bodies.isKinematic(id) ? 0 : (bodies.masses[id] * Math.hypot(...this.velocity(id)) ** 2) / 2);
      this.spheres.measured = Float64Array.from(bodies.radii, (radius, id) => (radius > 0 ? energy(id) : 0));
    } else {
      const centers = Float64Array.from({ length: 3 * bodies.radii.length });
      for (let id = 0; id < bodies.radii.length; ++id) if (bodies.exists(id)) centers.set(this.center(id), 3 * id);
      this.spheres.measured = countNeighbors(centers, bodies.radii, box, playback.time);
    }
    this.spheres.forget();
  }

  // Velocities and trails of the spheres that are drawn.
  updateMotion() {
    const isShown = (id, center) => this.isDrawn(id, center);
    this.arrows.object.visible = element('show-arrows').checked;
    if (this.arrows.object.visible) this.arrows.update(this.playback, this.arrowTime, isShown);
    this.trails.object.visible = element('show-trails').checked;
    if (this.trails.object.visible) this.trails.update(this.playback, kTrailTimes * this.arrowTime, isShown);
  }

  // Whether sphere `id`, whose center is at `center` [L], is drawn.
  isDrawn(id, center) {
    const { reach, followedCenter } = this.spheres.uniforms;
    if (!this.slice.has(center)) return false;
    if (reach.value === 0 || id === this.followed) return true;
    const difference = center.map((place, axis) => place - followedCenter.value.getComponent(axis));
    return Math.hypot(...this.box.nearestApart(difference, this.playback.time)) <= reach.value;
  }

  updateTrail(center) {
    const { playback, followed, store } = this;
    const began = playback.paths[kPathNumbers * followed + 6];
    const known = knownUntil(store, playback.number);
    const key = `${followed} ${began} ${known} ${playback.number}`;
    if (key !== this.trailKey) {
      this.trailKey = key;
      const { hasMoments } = playback;
      this.past = hasMoments
        ? [{ numbers: playback.paths.slice(kPathNumbers * followed, kPathNumbers * (followed + 1)), until: Infinity }]
        : recentPaths(store, followed, playback.number, playback.cursor, kContactsOfTrail);
      this.next = hasMoments ? undefined : nextContact(store, followed, playback.number, playback.cursor);
    }
    this.trail.update(
      this.past,
      playback.time,
      this.next?.time ?? (playback.hasMoments ? playback.time : known),
      center,
      this.bodies.radii[followed],
    );
  }

  updateCells(followed, window) {
    const { time } = this.playback;
    // Which spheres are near changes slowly; their cells are exact anyway.
    const isDue = !(Math.abs(time - this.cellsGathered) < (0.2 * this.reach) / this.scales.speed);
    if (isDue && (followed >= 0 || this.source.header.spheres <= kFew)) {
      this.cellLayer.gather(this.playback, followed, 0.7 * this.reach);
      this.cellsGathered = time;
    }
    this.cellLayer.update(this.playback, followed, this.cells, window);
  }

  updateColors() {
    const range = this.spheres.uniforms.colorRange.value;
    this.measureBodies();
    if (this.colorBy === 'species') return this.showSpecies();
    if (this.colorBy === 'domain') return this.showDomains();
    if (this.colorBy === 'speed') range.set(0, this.plots.fast);
    const isLogarithmic = this.colorBy === 'size' && this.sizes.areWide;
    this.spheres.uniforms.colorIsLogarithmic.value = isLogarithmic;
    if (this.colorBy === 'size') range.set(...this.sizes.range(this.isDark.matches));
    if (this.colorBy === 'spin') range.set(0, this.typicalSpin());
    if (this.colorBy === 'collisions')
      range.set(0, Math.max(4, roundUp(quantile(this.playback.collisions, 0.99))));
    if (this.colorBy === 'energy') range.set(0, roundUp(quantile(this.spheres.measured, 0.94)));
    if (this.colorBy === 'neighbors') range.set(0, Math.max(1, quantile(this.spheres.measured, 1)));
    if (this.colorBy === 'contacts') range.set(0, Math.max(...this.contacts));
    if (this.colorBy === 'last contact')
      range.set(roundUp(this.scales.rate > 0 ? 1 / this.scales.rate : this.player.speed), 0);
    if (this.fixedRange) range.set(...this.fixedRange);
    this.legend.showRange(range.x, range.y, kUnits[this.colorBy] ?? '', isLogarithmic, this.fixedRange);
    this.view.isStale = true;
  }

  // The ends of the scale of colors, as people write them.
  get rangeShown() {
    return this.spheres.uniforms.colorRange.value.toArray().map((end) => Number(end.toPrecision(3)));
  }

  // Whether people want little to move by itself.
  get wantsCalm() {
    return matchMedia('(prefers-reduced-motion: reduce)').matches;
  }

  // Sizes and the number of each species change as spheres merge.
  measureBodies() {
    const { bodies } = this;
    if (bodies.count === this.measuredCount) return;
    this.measuredCount = bodies.count;
    this.sizes = new Sizes(bodies.baseRadii);
    for (const kind of this.kinds.list) kind.count = 0;
    for (let id = 0; id < bodies.radii.length; ++id)
      if (bodies.exists(id)) ++this.kinds.list[this.kinds.of[id]].count;
  }

  // Whether spheres merge is known as soon as some have.
  showEvents() {
    const hasMergers = this.source.status.mergers > 0;
    if (hasMergers === this.hasMergers) return;
    this.hasMergers = hasMergers;
    const hasWalls = this.source.header.box.boundary.includes('wall') || this.surfaces.length > 0;
    showEventLegend(hasWalls, hasMergers);
  }

  showSpecies() {
    this.legend.showSpecies(this.kinds.list);
  }

  // How many spheres are in the block of each domain at the time shown.
  showDomains() {
    const blocks = this.domains.at(this.playback.time);
    const counts = blocks.map(() => 0);
    for (let id = 0; id < this.bodies.radii.length; ++id)
      if (this.bodies.exists(id)) ++counts[nearestBlock(blocks, this.center(id))];
    this.legend.showDomains(counts);
  }

  // Whether there are domains is known as soon as the run is; there may be several only later.
  noteDomains() {
    this.domains.update(this.source.status.divisions);
    this.windowsPanel.update(this.source.status.windows, this.domains.areSeveral);
    if (this.domains.areSeveral && !this.colorings.includes('domain')) element('color-by').append(optionOf('domain'));
  }

  // Few spheres spin faster [1/T].
  typicalSpin() {
    const { bodies } = this;
    const rates = bodies.radii.map((_, id) => Math.hypot(...bodies.spin(id)));
    return roundUp(quantile(rates.filter((_, id) => bodies.exists(id)), 0.94));
  }

  // Whether spheres of this recording can differ in what the coloring shows. Domains are offered once there are
  // several.
  offersColoring(name) {
    if (name === 'speed' || name === 'energy') return !this.isAtRest;
    if (name === 'neighbors') return this.source.header.spheres <= kFewEnoughForNeighbors;
    if (name === 'collisions') return !this.isStill && !this.player.hasMoments;
    if (name === 'last contact') return !this.isStill;
    if (name === 'spin') return this.canTurn;
    if (name === 'contacts') return this.contacts !== null;
    return name !== 'domain';
  }

  // The coloring that shows most of what differs between spheres.
  firstColoring() {
    const { length } = this.kinds.list;
    if (length > 1 && length <= kSpeciesColors.length) return 'species';
    return this.isAtRest || this.sizes.largest > 2 * this.sizes.smallest ? 'size' : 'speed';
  }

  // Updates numbers and plots, as often as people can read them.
  updateNumbers(seconds) {
    this.transport.update();
    this.plots.mark(this.playback.time);
    const { player } = this;
    if (player.isBuffering)
      this.notices.show('wait', this.isLost ? 'This part could not be loaded' : 'Buffering …');
    else if (player.isPlaying && player.isAtEnd && !this.source.status.finished)
      this.notices.show('wait', 'Waiting for the run …');
    else this.notices.hide('wait');
    if (seconds - this.last.panels > kSecondsBetweenPanels) {
      this.last.panels = seconds;
      this.spherePanel.update();
      if (this.surroundings.widen(this.playback)) this.view.span(this.surroundings.extent);
      showRunStatus(this.source, this.spheresAtStart, this.isLost);
      this.showEvents();
      this.noteDomains();
    }
    if (seconds - this.last.plots > kSecondsBetweenPlots) {
      this.last.plots = seconds;
      if (this.plots.update(this.playback)) this.updateColors();
    }
  }

  // --- the server ---

  async poll() {
    try {
      await this.source.poll();
      if (this.isLost) this.recover();
    } catch {
      this.lose();
    }
    const { finished, failed, damaged } = this.source.status;
    if (failed) this.notices.show('failed', `The run failed: ${failed}`, { kind: 'bad' });
    if (damaged) this.notices.show('damaged', `${damaged[0].toUpperCase()}${damaged.slice(1)}`, { kind: 'bad' });
    if (this.isLost) this.pollIn(kRetrySeconds);
    else if (!finished) this.pollIn(kPollSeconds);
  }

  pollIn(seconds) {
    clearTimeout(this.nextPoll);
    this.nextPoll = setTimeout(() => this.poll(), 1000 * seconds);
  }

  lose() {
    if (this.isLost) return;
    this.isLost = this.store.isSuspended = true;
    this.notices.show('lost', 'The program does not answer. The loaded part can still be viewed.', {
      kind: 'bad',
    });
    this.pollIn(kRetrySeconds);
  }

  recover() {
    this.isLost = this.store.isSuspended = false;
    this.notices.hide('lost');
  }

  // --- the page ---

  // Takes over the colors of the page.
  style() {
    const style = getComputedStyle(document.documentElement);
    const value = (name) => style.getPropertyValue(name).trim();
    const parts = (name) => [1, 3, 5].map((start) => parseInt(value(name).slice(start, start + 2), 16) / 255);
    this.view.style(value('--space'), value('--ink'));
    this.spheres.uniforms.background.value.set(...parts('--space'));
    this.trail.style(parts('--ink'), this.largestRadius / 2);
    this.cellLayer.ink = parts('--quiet');
    this.cellLayer.accent = parts('--accent');
    this.plots.resize();
  }

  draw(way) {
    this.view.mostPixelRatio = way.mostPixelRatio;
    if (this.spheres.way !== way.spheres) this.spheres.drawAs(way.spheres);
    this.view.resize();
    if (this.quality.isFixed) return;
    this.notices.show('quality', 'Reduced quality for smooth playback.', {
      action: { label: 'Full quality', run: () => this.setQuality('full') },
    });
  }

  showCellEdge() {
    element('cell-edge').value = this.cells ? Number(this.cells.edge[0].toPrecision(5)) : '';
    element('cell-edge').placeholder = this.cells ? '' : show(4 * this.largestRadius);
  }

  setCellEdge(edge) {
    const { header } = this.source;
    this.cellEdge = edge > 0 ? edge : null;
    if (edge > 0) this.cells = Cells.fitting(Math.max(edge, this.largestRadius / 100), this.box);
    else
      this.cells = header.cell_edge[0] > 0 ? new Cells(header.cell_edge, header.cell_origin, this.box) : null;
    this.showCellEdge();
    this.cellsGathered = null;
    this.view.isStale = true;
  }

  // Cells are shown around a sphere: if none is followed, one is chosen.
  showCells(areShown) {
    this.view.isStale = true;
    if (!areShown || !this.playback.chunk) return;
    if (!this.cells) this.setCellEdge(4 * this.largestRadius);
    if (this.followed !== null || this.source.header.spheres <= kFew) return;
    const middle = this.view.controls.target;
    let nearest = 0;
    let least = Infinity;
    for (let id = 0; id < this.source.header.spheres; ++id) {
      if (!this.bodies.exists(id)) continue;
      const [x, y, z] = this.center(id);
      const apart = (x - middle.x) ** 2 + (y - middle.y) ** 2 + (z - middle.z) ** 2;
      if (apart < least) [nearest, least] = [id, apart];
    }
    this.follow(nearest);
    this.approach();
  }

  // Of a recording that has only moments, the page says so, and shows nothing of what is between them.
  showMoments() {
    const words = { back: 'Previous moment', forward: 'Next moment' };
    for (const [id, text] of Object.entries(words)) {
      element(id).setAttribute('aria-label', text);
      element(id).title = `${text} (${id === 'back' ? 'P' : 'N'})`;
    }
  }

  // So slow that the followed sphere, or a typical one, takes at least four seconds to cross a cell.
  slowDown() {
    const edge = this.cells ? this.cells.edge[0] : 4 * this.largestRadius;
    const own = this.followed === null ? 0 : Math.hypot(...this.velocity(this.followed));
    this.setSpeed(Math.min(this.player.speed, edge / (4 * (own || this.scales.speed || 1))));
  }

  listen() {
    const canvas = element('canvas');
    element('color-by').addEventListener('change', (event) => this.setColorBy(event.target.value));
    element('fix-scale').addEventListener('change', ({ target }) => this.fixRange(target.checked ? this.rangeShown : null));
    for (const id of ['scale-left', 'scale-right']) {
      element(id).addEventListener('change', () => this.fixRange([number('scale-left'), number('scale-right')]));
    }
    element('fit').addEventListener('click', () => this.fit());
    element('show-cells').addEventListener('change', (event) => this.showCells(event.target.checked));
    element('cell-edge').addEventListener('change', (event) => this.setCellEdge(Number(event.target.value)));
    element('slow').addEventListener('click', () => this.slowDown());
    const layers = ['events', 'walls', 'images', 'spin', 'forces', 'bonds', 'arrows', 'trails'].map((name) => `show-${name}`);
    for (const id of [...layers, 'camera-follows', 'near-only']) {
      element(id).addEventListener('change', () => (this.view.isStale = true));
    }
    if (this.source.replayAddress) element('save').href = this.source.replayAddress;
    else element('save').hidden = true;

    new ResizeObserver(() => this.view.resize()).observe(canvas);
    new ResizeObserver(() => this.plots.resize()).observe(element('plots'));
    this.isDark.addEventListener('change', () => {
      this.style();
      if (this.scales) this.updateColors();
    });

    document.addEventListener('visibilitychange', () => {
      this.last.frame = performance.now();
      this.quality.restart();
    });

    let pressed = null;
    canvas.addEventListener(
      'pointerdown',
      ({ clientX, clientY, isPrimary }) => (pressed = isPrimary ? [clientX, clientY] : null),
    );
    canvas.addEventListener('pointerup', (event) => {
      const isClick = pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < 5;
      if (isClick && event.button === 0) this.followAt(event);
    });
    canvas.addEventListener('dblclick', () => this.approach());
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.notices.show('context', 'The graphics card has lost the picture; reload the page.', {
        kind: 'bad',
      });
    });
  }

  followAt({ clientX, clientY, pointerType }) {
    if (!this.playback.chunk) return;
    const { left, top } = element('canvas').getBoundingClientRect();
    const ray = this.view.ray(clientX - left, clientY - top);
    const tolerance = (pointerType === 'touch' ? 14 : 4) * this.view.pixelTangent;
    const isShown = (id, center) => this.isDrawn(id, center);
    const leastSize = (this.sizes.leastPixels / 2) * this.view.pixelTangent;
    const options = { tolerance, leastSize, isShown, images: this.surroundings.images };
    const id = pick(this.playback, this.bodies.radii, this.box, ray, options);
    if (id >= 0) this.follow(id);
  }

}
