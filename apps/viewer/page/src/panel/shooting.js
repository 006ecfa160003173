// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { FilmFile, offeredFormats } from '../film/film_file.js';
import { Plan } from '../film/plan.js';
import { download } from './download.js';
import { showCount } from './numbers.js';

const kMostPixels = 8192; // of a side

const element = (id) => document.getElementById(id);
const number = (id) => Number(element(id).value);

/** Pictures and films of any size, over the page. */
export class Shooting {
  constructor(viewer) {
    this.viewer = viewer;
    this.dialog = element('shooting');
    /** Whether a film is being made, and whether it is to be ended early. */
    this.isFilming = false;
    this.isStopped = false;
    element('screenshot').addEventListener('click', () => this.open());
    element('shooting-close').addEventListener('click', () => this.dialog.close());
    this.dialog.addEventListener('click', ({ target }) => target === this.dialog && this.dialog.close());
    this.dialog.addEventListener('close', () => (this.isStopped = true));
    element('save-picture').addEventListener('click', () => this.savePicture().catch((error) => this.say(error.message)));
    element('save-film').addEventListener('click', () => this.toggleFilm().catch((error) => this.say(error.message)));
    for (const input of this.dialog.querySelectorAll('input')) input.addEventListener('input', () => this.describe());
  }

  get isOpen() {
    return this.dialog.open;
  }

  open() {
    const { viewer } = this;
    const { canvas } = viewer.view;
    const { begin } = viewer.source.header;
    const put = (id, value) => (element(id).value = Number(value.toPrecision(6)));
    put('picture-width', Math.round(canvas.clientWidth * devicePixelRatio));
    put('picture-height', Math.round(canvas.clientHeight * devicePixelRatio));
    put('film-from', begin);
    element('film-to').value = viewer.player.knownEnd;
    put('film-speed', viewer.player.speed);
    // What cannot be turned does not move where no time passes.
    const canTurn = !viewer.box.isFlat;
    element('film-turn-row').hidden = !canTurn;
    element('film-turn').value = viewer.isStill && canTurn ? 360 : 0;
    element('film').hidden = true;
    this.say('');
    this.describe();
    this.dialog.showModal();
    if (canTurn || !viewer.isStill) this.offerFormats();
  }

  // A browser may be able to write films in some formats, or in none.
  async offerFormats() {
    const { width, height } = this.evenSize;
    const formats = await offeredFormats(width, height);
    element('film-format').replaceChildren(...formats.map((name) => new Option(name === 'webm' ? 'WebM' : 'MP4', name)));
    element('film').hidden = formats.length === 0;
  }

  get size() {
    const side = (id) => Math.min(kMostPixels, Math.max(16, Math.round(number(id)) || 0));
    return { width: side('picture-width'), height: side('picture-height') };
  }

  // Encoders take an even number of pixels.
  get evenSize() {
    const { width, height } = this.size;
    return { width: width - (width % 2), height: height - (height % 2) };
  }

  get plan() {
    const { header } = this.viewer.source;
    const end = this.viewer.player.knownEnd;
    const within = (time) => Math.min(Math.max(time, header.begin), end);
    const from = this.viewer.isStill ? header.begin : within(number('film-from'));
    const to = this.viewer.isStill ? from : within(number('film-to'));
    return new Plan({ from, to, speed: number('film-speed'), fps: number('film-fps'), turn: number('film-turn') });
  }

  // How long the film will be.
  describe() {
    const { count, seconds } = this.plan;
    const isMeant = Number.isFinite(count) && count > 0;
    element('film-length').textContent = isMeant ? `${showCount(count)} frames, ${seconds.toFixed(1)} s` : '';
    element('save-film').disabled = !isMeant;
  }

  async savePicture() {
    const { viewer } = this;
    const { canvas } = viewer.view;
    const time = viewer.player.time;
    let picture = null;
    await viewer.shoot(Plan.ofPicture(time), this.size, () => {
      picture = new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
    });
    download(await picture, `hardball_${time.toPrecision(6)}.png`);
    this.dialog.close();
  }

  // Makes the film, or ends it early if it is being made: what there is of it is saved.
  async toggleFilm() {
    this.isStopped = this.isFilming;
    if (this.isFilming) return;
    const { viewer, plan } = this;
    const format = element('film-format').value;
    const film = new FilmFile(format, viewer.view.canvas, plan.fps);
    this.setFilming(true);
    try {
      await film.begin();
      await viewer.shoot(plan, this.evenSize, async (frame) => {
        await film.add(frame);
        element('film-progress').value = (frame + 1) / plan.count;
        this.say(`${showCount(frame + 1)} of ${showCount(plan.count)} frames`);
        // The page stays alive.
        await new Promise((resolve) => setTimeout(resolve));
        return !this.isStopped;
      });
      download(await film.close(), `hardball.${format}`);
      this.say('Saved');
    } catch (error) {
      await film.cancel();
      throw error;
    } finally {
      this.setFilming(false);
    }
  }

  setFilming(isFilming) {
    this.isFilming = isFilming;
    element('save-film').textContent = isFilming ? 'End it here' : 'Save film';
    element('save-picture').disabled = isFilming;
    element('film-progress').hidden = !isFilming;
    for (const input of this.dialog.querySelectorAll('input, select')) input.disabled = isFilming;
  }

  say(text) {
    element('shooting-text').textContent = text;
  }
}
