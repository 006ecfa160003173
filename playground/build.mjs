// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// build.mjs PROJECT FOLDER: makes the folder of the playground, of static files, from src/, package/ and the project.
import { createHash } from 'node:crypto';
import { existsSync } from 'node:fs';
import { copyFile, cp, mkdir, readFile, readdir, rm, writeFile } from 'node:fs/promises';
import { join, relative } from 'node:path';
import { build, transform } from 'esbuild';
import { marked } from 'marked';

const [project, folder] = process.argv.slice(2);
const kTarget = ['chrome103', 'firefox113', 'safari16.4'];
const kDataFile = /\.(obj|stl|ply|txt|csv)$/;

// --- scenarios and lessons ---

function titleOf(name) {
  const words = name.replaceAll('_', ' ');
  return words[0].toUpperCase() + words.slice(1);
}

// The first comment of a scenario, up to an empty line.
function descriptionOf(text) {
  const lines = [];
  for (const line of text.split('\n')) {
    if (line.startsWith('#:')) continue;
    const [, comment] = /^#\s?(.*)$/.exec(line) ?? [];
    if (!comment) break;
    lines.push(comment);
  }
  return lines.join(' ');
}

// The hashes of first contacts that all machines and compilers agree on.
async function nativeHashes() {
  const text = await readFile(join(project, 'tests/golden/expected_scenarios.txt'), 'utf8');
  return Object.fromEntries(
    text
      .trim()
      .split('\n')
      .map((line) => line.split(' ')),
  );
}

async function scenariosIn(source, hashes) {
  const names = (await readdir(source)).filter((name) => name.endsWith('.toml')).sort();
  return Promise.all(
    names.map(async (file) => {
      const text = await readFile(join(source, file), 'utf8');
      const name = file.slice(0, -'.toml'.length);
      return { name, title: titleOf(name), description: descriptionOf(text), text, hash: hashes[file] };
    }),
  );
}

// A text in Markdown, after lines "key: value" between two lines "---"; the scenario is named relative to it.
async function lessonOf(source, file, scenarios) {
  const lesson = await readFile(join(source, file), 'utf8');
  const [, head, body] = /^---\n(.*?)\n---\n(.*)$/s.exec(lesson) ?? [];
  if (head === undefined) throw new Error(`${file}: it does not begin with its title, scenario and order between lines ---`);
  const facts = Object.fromEntries(head.split('\n').map((line) => line.match(/^(\w+):\s*(.*)$/).slice(1)));
  const name = file.slice(0, -'.md'.length);
  const text = await readFile(join(source, facts.scenario), 'utf8');
  const { hash } = scenarios.find((scenario) => scenario.text === text) ?? {};
  return { name, title: facts.title, order: Number(facts.order), description: facts.summary, html: marked.parse(body), text, hash };
}

async function lessonsIn(source, scenarios) {
  if (!existsSync(source)) return [];
  const names = (await readdir(source)).filter((name) => name.endsWith('.md'));
  const lessons = await Promise.all(names.map((file) => lessonOf(source, file, scenarios)));
  return lessons.sort((one, other) => one.order - other.order);
}

async function writeLibrary() {
  const lessonFolder = join(project, 'playground/lessons');
  const scenarioFolder = join(project, 'scenarios');
  const files = [];
  await mkdir(join(folder, 'scenarios'));
  for (const source of [scenarioFolder, lessonFolder]) {
    if (!existsSync(source)) continue;
    for (const name of (await readdir(source)).filter((each) => kDataFile.test(each))) {
      await copyFile(join(source, name), join(folder, 'scenarios', name));
      files.push(name);
    }
  }
  const scenarios = await scenariosIn(scenarioFolder, await nativeHashes());
  const lessons = await lessonsIn(lessonFolder, scenarios);
  await writeFile(join(folder, 'library.json'), JSON.stringify({ scenarios, lessons, files }));
}

// --- page ---

// The licenses of the packages that are in a bundle.
async function noticeOf(metafile) {
  const inputs = Object.keys(metafile.inputs).map((path) => /^node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(path)?.[1]);
  const names = [...new Set(inputs.filter(Boolean))].sort();
  const licenses = await Promise.all(
    names.map(async (name) => `${name}:\n${await readFile(`node_modules/${name}/LICENSE`, 'utf8')}`),
  );
  return `/*\nHardball: SPDX-License-Identifier: MIT\n\nContains\n\n${licenses.join('\n').replaceAll('*/', '')}*/\n`;
}

async function bundle() {
  const options = { bundle: true, minify: true, format: 'esm', target: kTarget, charset: 'utf8', legalComments: 'none', logLevel: 'warning' };
  const entryPoints = ['src/page.js', 'src/worker.js', 'src/checker.js'];
  // What the module has for node.
  const external = ['node:*', 'fs', 'path', 'url', 'crypto', 'module', 'worker_threads'];
  const { metafile, outputFiles } = await build({ ...options, entryPoints, external, outdir: folder, metafile: true, write: false });
  const notice = await noticeOf(metafile);
  for (const { path, text } of outputFiles) await writeFile(path, path.endsWith('page.js') ? notice + text : text);
  await build({ ...options, entryPoints: ['src/page.css'], outdir: folder });
}

// --- all ---

async function filesIn(directory) {
  const entries = await readdir(directory, { withFileTypes: true });
  const inner = entries.map((entry) => {
    const path = join(directory, entry.name);
    return entry.isDirectory() ? filesIn(path) : [path];
  });
  return (await Promise.all(inner)).flat();
}

async function writeServiceWorker() {
  const files = {};
  for (const path of (await filesIn(folder)).sort())
    files[relative(folder, path)] = createHash('sha256').update(await readFile(path)).digest('hex').slice(0, 16);
  const { code } = await transform(await readFile('src/service_worker.js', 'utf8'), { minify: true, target: kTarget });
  await writeFile(join(folder, 'service_worker.js'), `const kFiles = ${JSON.stringify(files)};\n${code}`);
}

await rm(folder, { recursive: true, force: true });
await mkdir(join(folder, 'view'), { recursive: true });
await cp(join(project, 'apps/viewer/page/src/index.html'), join(folder, 'view/index.html'));
for (const name of ['page.js', 'page.css']) await copyFile(join(project, 'apps/viewer/page/dist', name), join(folder, 'view', name));
await copyFile('src/index.html', join(folder, 'index.html'));
await copyFile('package/module.wasm', join(folder, 'module.wasm'));
await copyFile(join(project, 'scenarios/scenario.schema.json'), join(folder, 'scenario.schema.json'));
await copyFile(join(project, 'LICENSE'), join(folder, 'LICENSE'));
await bundle();
await writeLibrary();
await writeServiceWorker();
