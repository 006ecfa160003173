// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { compiledModule } from '../package/compile.js';
import { Checks } from './checks.js';
import { Editor } from './editor.js';
import { fragmentOf, packed, partsOf, unpacked } from './link.js';
import { showMeasures } from './measures_table.js';
import { countText, shown } from './numbers.js';
import { kMostRecordedBytes, Run } from './run.js';
import { Sliders } from './sliders.js';
import { missingFeatures } from './support.js';
import { numbersOf } from './toml_numbers.js';
import { ViewerFrame } from './viewer_frame.js';

const kFirstScenario = 'bouncing_heap';
const kCheckAfter = 250; // ms without a change
const kRunAfter = 600;
const kMeasureEvery = 1000; // ms, and at most a tenth of the time

const element = (id) => document.getElementById(id);

async function json(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address}: ${response.status} ${response.statusText}`);
  return response.json();
}

function save(name, content, type) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** The whole page: what is edited, and the run of it. */
class Playground {
  constructor({ scenarios, lessons, files, schema }) {
    this.scenarios = new Map(scenarios.map((scenario) => [scenario.name, scenario]));
    this.lessons = new Map(lessons.map((lesson) => [lesson.name, lesson]));
    this.dataFiles = files;
    this.wasm = compiledModule(new URL('./module.wasm', import.meta.url));
    this.wasm.catch((error) => this.alert(`The module could not be loaded: ${error.message}`));
    this.checks = new Checks(this.wasm);
    this.editor = new Editor(element('editor'), schema, { onChange: (isByUser) => this.change(isByUser), onRun: () => this.toggleRun() });
    this.sliders = new Sliders(element('sliders'), schema, this.editor);
    this.viewer = new ViewerFrame(element('viewer'));
    /** The scenario or lesson that was chosen: {name, text, hash}, without a hash if it has none. */
    this.chosen = null;
    /** What was edited before something else was opened: as `chosen`, with the end of the run and the state of the viewer. */
    this.yours = [];
    this.run = null;
    this.state = 'idle'; // or starting, running, paused, ended
    /** Whether the end beside the button is another than that in the text. */
    this.isUntilGiven = false;
    /** Whether the scenario that was opened last has been run, or was to be. */
    this.wasRun = false;
    this.fillChoices();
    this.listen();
  }

  // --- what is edited ---

  fillChoices() {
    const options = (choices) => [...choices.values()].map(({ name, title }) => new Option(title, name));
    const yours = Object.assign(document.createElement('optgroup'), { id: 'yours', label: 'Yours', hidden: true });
    element('scenario').append(yours, ...options(this.scenarios), Object.assign(new Option('–', ''), { hidden: true }));
    element('lesson').append(...options(this.lessons));
    element('lesson-label').hidden = this.lessons.size === 0;
  }

  /** Opens what the parts of an address name. */
  async openParts(parts) {
    if (parts.s) {
      try {
        this.open({ name: parts.name || 'scenario', text: await unpacked(parts.s) }, parts);
        return;
      } catch {
        this.alert('The link is damaged: the scenario in it cannot be read. A scenario of the playground is shown instead.');
      }
    }
    const lesson = this.lessons.get(parts.lesson);
    const scenario = this.scenarios.get(parts.scenario);
    if ((parts.lesson && !lesson) || (parts.scenario && !scenario)) this.alert('There is no scenario or lesson of this name.');
    if (lesson) this.open(lesson, parts);
    else this.open(scenario ?? this.scenarios.get(kFirstScenario), parts);
  }

  /** Opens a scenario or a lesson of the playground, or one from a link, which has a name and a text. */
  open(chosen, { until, v = '' } = {}) {
    this.keep();
    this.discard();
    this.viewer.beginWith(v);
    this.chosen = chosen;
    const { kind } = this;
    const own = this.yours.indexOf(chosen);
    element('yours').replaceChildren(...this.yours.map(({ name }, k) => new Option(`${name}, edited`, `yours ${k}`)));
    element('yours').hidden = this.yours.length === 0;
    element('scenario').value = kind === 'scenario' ? chosen.name : own < 0 ? '' : `yours ${own}`;
    element('scenario').querySelector('[value=""]').textContent = kind === 'link' ? 'From a link' : '–';
    element('lesson').value = kind === 'lesson' ? chosen.name : '';
    element('description').textContent = chosen.description ?? '';
    element('lesson-text').innerHTML = chosen.html ?? '';
    element('lesson-text').hidden = kind !== 'lesson';
    element('lesson-text').scrollTop = 0;
    this.isUntilGiven = until !== undefined;
    element('until').value = until ?? '';
    this.editor.text = chosen.text;
    this.untilOfText = this.numberOfUntil?.value;
    this.wasRun = false;
    this.changed();
  }

  // Keeps what is edited, so that it can be chosen again.
  keep() {
    if (!this.chosen || (this.kind !== 'link' && this.isUnchanged)) return;
    const until = this.isUntilGiven ? element('until').value : undefined;
    const own = { name: this.chosen.name, text: this.editor.text, until, v: this.viewer.viewState };
    const place = this.yours.indexOf(this.chosen);
    if (place < 0) this.yours.push(own);
    else this.yours[place] = own;
  }

  /** What was chosen: a 'scenario' or a 'lesson' of the playground, or a 'link'. */
  get kind() {
    const { name } = this.chosen;
    return this.lessons.get(name) === this.chosen ? 'lesson' : this.scenarios.get(name) === this.chosen ? 'scenario' : 'link';
  }

  get isUnchanged() {
    return this.editor.text === this.chosen.text;
  }

  // Where the text says when the run ends; undefined if it does not.
  get numberOfUntil() {
    return numbersOf(this.editor.text).find(({ path }) => path === 'run.until');
  }

  // The files that the text names, of those that the playground has.
  async filesOf(text) {
    const names = this.dataFiles.filter((name) => text.includes(`"${name}"`));
    const load = async (name) => [name, new Uint8Array(await (await fetch(`scenarios/${name}`)).arrayBuffer())];
    return Object.fromEntries(await Promise.all(names.map(load)));
  }

  change(isByUser) {
    if (isByUser) this.changed();
  }

  changed() {
    this.sliders.update();
    // Of the end in the text and the one beside the button, the one that was changed last is meant.
    const until = this.numberOfUntil?.value;
    if (until !== this.untilOfText) this.isUntilGiven = false;
    this.untilOfText = until;
    this.showButtons();
    this.isChecked = false;
    clearTimeout(this.checkLater);
    this.checkLater = setTimeout(() => this.check(), kCheckAfter);
    clearTimeout(this.runLater);
    if (element('at-once').checked && this.wasRun) this.runLater = setTimeout(() => this.restart(), kRunAfter);
  }

  async check() {
    clearTimeout(this.checkLater);
    const { text } = this.editor;
    const found = await this.checks.check({ text, name: `${this.chosen.name}.toml`, files: this.filesOf(text) });
    if (!found || text !== this.editor.text) return;
    this.problem = found.error;
    this.showProblem(found.error);
    this.scenarioUntil = found.until ?? null;
    const { valueAsNumber } = element('until');
    if (!found.error && !this.isUntilGiven && valueAsNumber !== found.until) element('until').value = found.until ?? '';
    this.isChecked = this.isReady = true;
    this.writeAddress();
    if (this.state === 'idle') element('status').textContent = found.error ? 'The scenario has an error.' : 'Ready to run.';
    this.showButtons();
  }

  showProblem(error) {
    this.editor.showError(error);
    element('problem').hidden = !error;
    if (!error) return;
    this.problemPlace = error.place;
    element('problem-place').textContent = error.place ? `Line ${error.place.line}` : 'Scenario';
    element('problem-text').textContent = `${error.problem}${error.remedy ? `; ${error.remedy}` : ''}`;
  }

  // The end of the run, in the text if that gives one.
  giveUntil(time) {
    const number = this.numberOfUntil;
    if (number && Number.isFinite(time)) return this.editor.replace(number.from, number.to, String(time));
    this.isUntilGiven = Number.isFinite(time);
    this.showButtons();
    this.writeAddress();
  }

  // --- the address ---

  async parts() {
    const until = this.isUntilGiven ? element('until').value : null;
    const { name } = this.chosen;
    if (this.isUnchanged && this.kind !== 'link') return { [this.kind]: name, until };
    return { name, until, s: await packed(this.editor.text) };
  }

  async writeAddress() {
    history.replaceState(null, '', fragmentOf(await this.parts()));
  }

  // The whole scenario, even if it is one of the playground.
  async share() {
    const { until } = await this.parts();
    const s = await packed(this.editor.text);
    element('address').value = new URL(fragmentOf({ name: this.chosen.name, until, s, v: this.viewer.viewState }), location.href).href;
    element('copied').textContent = '';
    element('link').showModal();
    element('address').select();
  }

  async copy() {
    try {
      await navigator.clipboard.writeText(element('address').value);
      element('copied').textContent = 'Copied.';
    } catch {
      element('address').select();
      element('copied').textContent = 'Press Ctrl C to copy.';
    }
  }

  // --- the run ---

  async toggleRun() {
    if (element('run').disabled) return;
    if (this.state === 'running') return this.run.pause();
    if (this.state === 'paused' && this.isOfRun && !this.run.isFull) return this.goOn();
    this.showPart('spheres');
    return this.restart({ isAsked: true });
  }

  get isOfRun() {
    return this.run?.text === this.editor.text && this.run.until === Number(element('until').value);
  }

  /** Begins a new run. If it cannot begin and the user `isAsked` for it, the part of the page that says why is shown. */
  async restart({ isAsked = false } = {}) {
    const refuse = (message, part) => {
      this.enter('idle');
      this.fail(message);
      if (isAsked) this.showPart(part);
    };
    this.discard();
    this.wasRun = true;
    this.enter('starting');
    if (!this.isChecked) await this.check();
    if (this.state !== 'starting') return;
    if (this.problem) {
      refuse(this.problem.message, 'scenario');
      element('status').textContent = 'The scenario has an error.';
      return;
    }
    const until = element('until').valueAsNumber;
    if (!(until >= 0)) {
      refuse('The scenario does not say when it ends: give a time after "until".', 'results');
      element('until').focus();
      return;
    }
    const { text } = this.editor;
    const begun = new Run({
      text,
      name: this.chosen.name,
      files: await this.filesOf(text),
      wasm: this.wasm,
      until,
      measures: element('measure').checked,
      onProgress: () => this.showSoon(begun),
    });
    begun.expected = this.isUnchanged && until === this.scenarioUntil ? this.chosen.hash : undefined;
    begun.isMeasured = element('measure').checked;
    if (this.state !== 'starting') return;
    this.run = begun;
    try {
      await begun.start();
    } catch (error) {
      if (this.run !== begun) return;
      this.showProblem(error.problem ? error : null);
      this.discard();
      refuse(error.message, error.problem ? 'scenario' : 'results');
      return;
    }
    if (this.run !== begun) return begun.close();
    this.viewer.show(begun);
    await this.goOn();
  }

  async goOn() {
    const going = this.run;
    this.enter('running');
    try {
      const isAtEnd = await going.go();
      if (this.run !== going) return;
      if (isAtEnd) await this.end();
      else if (!going.isEnded) this.enter('paused');
      if (going.isFull) this.fail(`The recording has ${kMostRecordedBytes / 1e6} MB, so the run was paused. Stop it to save what there is.`);
    } catch (error) {
      if (this.run !== going) return;
      await this.end();
      this.fail(error.message);
    }
  }

  // Ends the run where it is.
  async end() {
    const ended = this.run;
    ended.pause();
    await ended.end();
    if (this.run === ended) this.enter('ended');
  }

  discard() {
    clearTimeout(this.runLater);
    this.run?.close();
    this.run = null;
    this.viewer.clear();
    this.fail('');
    showMeasures(element('measures'), []);
    element('measures').setAttribute('aria-busy', 'false');
    element('hashes').hidden = true;
    this.showComparison({});
    element('progress').value = 0;
    this.enter('idle');
    element('status').textContent = 'Ready to run.';
  }

  enter(state) {
    this.state = state;
    document.body.dataset.state = state;
    this.showButtons();
    this.showNow();
    if (state === 'running') this.measureLater();
    else if (state === 'paused' || state === 'ended') this.showLastMeasures();
  }

  measureLater(after = kMeasureEvery) {
    const measured = this.run;
    clearTimeout(this.measuring);
    this.measuring = setTimeout(async () => {
      if (this.run !== measured || this.state !== 'running') return;
      const begin = performance.now();
      await this.showMeasures(measured);
      this.measureLater(Math.max(kMeasureEvery, 10 * (performance.now() - begin)));
    }, after);
  }

  // Until they are known, those that are shown are of an earlier time.
  async showLastMeasures() {
    const { run } = this;
    element('measures').setAttribute('aria-busy', 'true');
    await this.showMeasures(run);
    if (this.run === run) element('measures').setAttribute('aria-busy', 'false');
  }

  async showMeasures(run) {
    if (!run?.isMeasured || !run.simulation) return;
    try {
      const measurements = await run.simulation.measures();
      if (this.run === run) showMeasures(element('measures'), measurements);
    } catch (error) {
      if (this.run === run) this.fail(error.message);
    }
  }

  // --- files ---

  async showReport() {
    const { report } = await this.run.results();
    element('report-page').srcdoc = report;
    element('report').showModal();
  }

  async saveFile(kind) {
    const { name } = this.chosen;
    if (kind === 'scenario') return save(`${name}.toml`, this.editor.text, 'application/toml');
    if (kind === 'recording') return save(`${name}.hbr`, await this.run.simulation.recording(), 'application/octet-stream');
    const { summary, report } = await this.run.results();
    return kind === 'report' ? save(`${name}.html`, report, 'text/html') : save(`${name}.json`, summary, 'application/json');
  }

  // --- what is shown ---

  showButtons() {
    const { state } = this;
    const goesOn = state === 'paused' && this.isOfRun && !this.run.isFull;
    element('run').textContent = state === 'starting' ? 'Starting …' : state === 'running' ? 'Pause' : goesOn ? 'Go on' : 'Run';
    element('run').disabled = state === 'starting' || !this.isReady;
    element('stop').disabled = !['running', 'paused', 'starting'].includes(state);
    for (const id of ['save-scenario', 'share']) element(id).disabled = !this.isReady;
    for (const id of ['show-report', 'save-recording', 'save-report', 'save-summary'])
      element(id).disabled = !['running', 'paused', 'ended'].includes(state);
  }

  // Once for each frame of the screen.
  showSoon(run) {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      if (this.run === run) this.showNow();
    });
  }

  showNow() {
    const { run, state } = this;
    if (state === 'starting') element('status').textContent = 'Placing the spheres …';
    if (!run?.status || state === 'idle') return;
    const { time, spheres, collisions, wallContacts, hash } = run.status;
    element('progress').value = run.until > 0 ? time / run.until : 1;
    const words = { starting: 'Starts', running: 'Runs', paused: 'Paused', ended: time < run.until ? 'Stopped' : 'Finished' }[state];
    const walls = wallContacts > 0 ? `, ${countText(wallContacts)} wall contacts` : '';
    const text = `${words} at time ${shown(time)} of ${shown(run.until)}: ${countText(spheres)} spheres, ${countText(collisions)} collisions${walls}`;
    element('status').textContent = text;
    // Of a status that changes all the time, only the ends are read aloud.
    element('status').setAttribute('aria-live', state === 'running' ? 'off' : 'polite');
    element('hashes').hidden = false;
    element('hash').textContent = hash;
    this.showComparison(run);
  }

  showComparison({ firstHash, expected }) {
    element('first-hash').textContent = firstHash ?? '…';
    const comparison = element('comparison');
    comparison.dataset.is = !firstHash || !expected ? '' : firstHash === expected ? 'same' : 'different';
    const words = { same: 'the same as natively', different: `natively it is ${expected}: please report this`, '': '' };
    comparison.textContent = words[comparison.dataset.is];
  }

  fail(message) {
    element('failure').hidden = !message;
    element('failure').textContent = message;
  }

  alert(message) {
    element('alert').hidden = false;
    element('alert').textContent = message;
  }

  showPart(part) {
    document.body.dataset.part = part;
    for (const button of document.querySelectorAll('#parts button'))
      button.setAttribute('aria-pressed', String(button.dataset.part === part));
  }

  listen() {
    const click = (id, action) => element(id).addEventListener('click', action);
    click('run', () => this.toggleRun());
    click('stop', () => (this.state === 'starting' ? this.discard() : this.end()));
    click('share', () => this.share());
    click('copy', () => this.copy());
    click('show-report', () => this.showReport());
    click('problem-place', () => this.editor.goTo(this.problemPlace));
    for (const kind of ['scenario', 'recording', 'report', 'summary']) click(`save-${kind}`, () => this.saveFile(kind));
    for (const button of document.querySelectorAll('#parts button'))
      button.addEventListener('click', () => this.showPart(button.dataset.part));
    for (const button of document.querySelectorAll('dialog .close'))
      button.addEventListener('click', () => button.closest('dialog').close());
    element('scenario').addEventListener('change', ({ target }) => {
      const own = this.yours[target.value.replace('yours ', '')];
      this.open(own ?? this.scenarios.get(target.value), own);
    });
    element('lesson').addEventListener('change', ({ target }) =>
      this.open(this.lessons.get(target.value) ?? this.scenarios.get(kFirstScenario)),
    );
    const until = element('until');
    until.addEventListener('focus', () => until.select());
    until.addEventListener('input', () => this.giveUntil(until.valueAsNumber));
    until.addEventListener('change', () => {
      if (until.value === '') until.value = this.scenarioUntil ?? '';
    });
    until.addEventListener('keydown', ({ key, ctrlKey, metaKey }) => {
      if (key === 'Enter' && !ctrlKey && !metaKey) this.toggleRun();
    });
    addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' || !(event.ctrlKey || event.metaKey) || event.defaultPrevented) return;
      event.preventDefault();
      this.toggleRun();
    });
    addEventListener('hashchange', () => this.openParts(partsOf(location.hash)));
  }
}

async function begin() {
  const missing = missingFeatures();
  if (missing.length > 0) {
    element('alert').hidden = false;
    element('alert').textContent = `This browser lacks ${missing.join(', ')}. A current Firefox, Chrome, Edge or Safari has it.`;
    return;
  }
  const [offered, schema] = await Promise.all([json('library.json'), json('scenario.schema.json')]);
  const parts = partsOf(location.hash);
  window.playground = new Playground({ ...offered, schema });
  await window.playground.openParts(parts);
  navigator.serviceWorker?.register('service_worker.js');
}

begin().catch((error) => {
  element('alert').hidden = false;
  element('alert').textContent = `The playground could not be loaded: ${error.message}`;
  throw error;
});
