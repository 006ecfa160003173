// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Makes dist/: page.js and page.css, which index.html refers to and which need nothing else.
import { readFile } from 'node:fs/promises';
import { build } from 'esbuild';

const licenses = await Promise.all(
  ['three', 'uplot', 'mediabunny'].map(
    async (name) => `${name}:\n${await readFile(`node_modules/${name}/LICENSE`, 'utf8')}`,
  ),
);
const notice = `/*\nHardball: SPDX-License-Identifier: MIT\n\nContains\n\n${licenses.join('\n').replaceAll('*/', '')}*/`;

await build({
  entryPoints: ['src/page.js', 'src/page.css'],
  outdir: 'dist',
  bundle: true,
  minify: true,
  format: 'iife',
  target: ['chrome100', 'firefox100', 'safari15.4'],
  charset: 'utf8',
  legalComments: 'none',
  banner: { js: notice, css: '/* Hardball, with parts of uPlot: their licenses are in page.js. */' },
  logLevel: 'warning',
});
