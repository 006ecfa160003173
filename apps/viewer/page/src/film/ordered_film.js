// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { splitState } from '../link.js';
import { FilmFile } from './film_file.js';
import { Plan } from './plan.js';

/**
 * A film that the program has ordered, as its command `film` does: this page, in a browser without a window, draws its frames
 * and sends the file back, piece by piece.
 */
export class OrderedFilm {
  /** `token`: the one in the page's address, which every request needs. */
  constructor(token) {
    this.token = token;
  }

  /** Gets the order, and gives the picture its size. Error: the program does not answer. */
  async begin() {
    this.order = await (await this.tell({}, { method: 'GET' })).json();
    const { style } = document.querySelector('main');
    style.width = `${this.order.width}px`;
    style.height = `${this.order.height}px`;
    document.body.classList.add('is-film');
  }

  /** Shoots the film with `viewer`, which has begun, and sends it. */
  async shoot(viewer) {
    const { order } = this;
    const { canvas } = viewer.view;
    const plan = new Plan({
      from: order.from ?? viewer.source.header.begin,
      to: order.to ?? viewer.player.knownEnd,
      speed: order.speed ?? viewer.player.speed,
      fps: order.fps,
      turn: order.turn,
    });
    viewer.setQuality(order.quality);
    if (order.turn !== 0 && splitState(location.hash).cam === undefined) viewer.resetCamera(viewer.surroundings.extent, true);
    const send = (data, position) => this.tell({ position }, { body: data });
    const film = new FilmFile(order.format, canvas, order.fps, send);
    await film.begin();
    await viewer.shoot(plan, order, async (number) => {
      const picture = order.frames ? new Promise((resolve) => canvas.toBlob(resolve, 'image/png')) : null;
      const added = film.add(number);
      if (picture) await this.tell({ frame: number }, { body: await picture });
      await added;
      await this.tell({ shown: number + 1, of: plan.count });
    });
    await film.close();
    await this.tell({ ended: plan.count });
  }

  /** Says that there will be no film, and why. */
  fail(error) {
    return this.tell({ failed: error.message });
  }

  async tell(what, options = {}) {
    const query = new URLSearchParams({ ...what, token: this.token });
    const response = await fetch(`api/film?${query}`, { method: 'POST', cache: 'no-store', ...options });
    if (!response.ok) throw new Error(`${response.status}: ${(await response.text()).trim()}`);
    return response;
  }
}
