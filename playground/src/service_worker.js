// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/* global kFiles -- a map of paths to hashes, which the build puts before this */

// Keeps the playground for times without a network. A file is kept under its hash, so that a new version loads only what is new.
const kCache = 'hardball-playground';
const base = new URL('./', self.location);

function keyOf(path) {
  return new URL(`${path}?${kFiles[path]}`, base).href;
}

async function keepAll() {
  const cache = await caches.open(kCache);
  const keep = async (path) => {
    if (await cache.match(keyOf(path))) return;
    const response = await fetch(new URL(path, base), { cache: 'no-cache' });
    if (!response.ok) throw new Error(`${path}: ${response.status}`);
    await cache.put(keyOf(path), response);
  };
  await Promise.all(Object.keys(kFiles).map(keep));
}

async function forgetOthers() {
  const cache = await caches.open(kCache);
  const kept = new Set(Object.keys(kFiles).map(keyOf));
  for (const { url } of await cache.keys()) if (!kept.has(url)) await cache.delete(url);
  await self.clients.claim();
}

async function answer(request, path) {
  try {
    return await fetch(request);
  } catch (offline) {
    const kept = await (await caches.open(kCache)).match(keyOf(path));
    if (kept) return kept;
    throw offline;
  }
}

self.addEventListener('install', (event) => event.waitUntil(keepAll()));
self.addEventListener('activate', (event) => event.waitUntil(forgetOthers()));
self.addEventListener('fetch', (event) => {
  const { origin, pathname } = new URL(event.request.url);
  if (origin !== base.origin || !pathname.startsWith(base.pathname)) return;
  const path = pathname.slice(base.pathname.length).replace(/(^|\/)$/, '$1index.html');
  if (path in kFiles) event.respondWith(answer(event.request, path));
});
