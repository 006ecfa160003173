// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { createApi } from './api.js';
import { OrderedFilm } from './film/ordered_film.js';
import { listenToKeys } from './panel/keyboard.js';
import { PortSource, portOfParent } from './recording/port_source.js';
import { SavedSource } from './recording/saved_source.js';
import { ServerSource } from './recording/server_source.js';
import { Viewer } from './viewer.js';

const query = new URLSearchParams(location.search);
const film = query.has('film') ? new OrderedFilm(query.get('token') ?? '') : null;

// The recording: in this page, from the page around this one, or from the program. A page that has room for one, and none
// there, has it from around it, too.
async function sourceOf() {
  const saved = document.getElementById('recording');
  if (saved?.textContent) return new SavedSource(saved);
  if (saved || query.get('source') === 'port') return new PortSource(await portOfParent());
  return new ServerSource(query.get('token') ?? '');
}

async function open() {
  const source = await sourceOf();
  await source.open();
  await film?.begin();
  const { name } = source.header;
  document.getElementById('name').textContent = name;
  document.title = name ? `${name} – Hardball` : 'Hardball';
  const viewer = new Viewer(source);
  listenToKeys(viewer);
  window.hardball = createApi(viewer);
  viewer.start();
  if (!film) return;
  await viewer.begun;
  await film.shoot(viewer);
}

open().catch((error) => {
  const notice = document.createElement('p');
  notice.dataset.kind = 'bad';
  notice.textContent = `Nothing can be shown: ${error.message}`;
  document.getElementById('notices').append(notice);
  document.getElementById('status').dataset.state = 'failed';
  document.getElementById('status-text').textContent = 'Failed';
  film?.fail(error);
  throw error;
});
