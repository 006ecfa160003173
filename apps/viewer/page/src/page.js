// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { createApi } from './api.js';
import { OrderedFilm } from './film/ordered_film.js';
import { listenToKeys } from './panel/keyboard.js';
import { SavedSource } from './recording/saved_source.js';
import { ServerSource } from './recording/server_source.js';
import { Viewer } from './viewer.js';

const query = new URLSearchParams(location.search);
const film = query.has('film') ? new OrderedFilm(query.get('token') ?? '') : null;

async function open() {
  const saved = document.getElementById('recording');
  const source = saved ? new SavedSource(saved) : new ServerSource(query.get('token') ?? '');
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
