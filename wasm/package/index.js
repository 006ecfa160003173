// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { compiledModule } from './compile.js';
import { HardballError } from './error.js';
import { Session } from './session.js';

export { HardballError };

// A session in this thread.
class Direct {
  async start(method, parts) {
    this.session = await Session[method](...parts);
    return this.session.facts();
  }

  async call(method, parts, told) {
    return method === 'run' ? this.session.run(...parts, told) : this.session[method](...parts);
  }

  end() {
    this.session.close();
  }
}

// A session in a worker of its own.
class Remote {
  constructor(worker, listen) {
    this.worker = worker;
    this.calls = new Map();
    this.last = 0;
    listen((message) => this.receive(message), (error) => this.fail(error));
  }

  static async make() {
    const address = new URL('./worker.js', import.meta.url);
    if (typeof Worker === 'function') {
      const worker = new Worker(address, { type: 'module' });
      return new Remote(worker, (receive, fail) => {
        worker.onmessage = ({ data }) => receive(data);
        worker.onerror = (event) => fail(new Error(event.message ?? 'the worker has failed'));
      });
    }
    const { Worker: NodeWorker } = await import('node:worker_threads');
    const worker = new NodeWorker(address);
    return new Remote(worker, (receive, fail) => worker.on('message', receive).on('error', fail));
  }

  start(method, parts) {
    return this.call(method, parts);
  }

  call(method, parts, told, transfer = []) {
    return new Promise((resolve, reject) => {
      const call = ++this.last;
      this.calls.set(call, { resolve, reject, told });
      this.worker.postMessage({ call, method, parts }, transfer);
    });
  }

  receive({ call, status, result, error }) {
    const { resolve, reject, told } = this.calls.get(call);
    if (status) return told?.(status);
    this.calls.delete(call);
    if (!error) return resolve(result);
    return reject(error.isOurs ? new HardballError(error) : new Error(error.problem));
  }

  fail(error) {
    for (const { reject } of this.calls.values()) reject(error);
    this.calls.clear();
  }

  end() {
    this.worker.terminate();
    this.fail(new HardballError({ problem: 'the simulation is closed', remedy: 'open or load another one' }));
  }
}

/** Spheres in motion. index.d.ts says what each method does. */
class Simulation {
  constructor(engine, { until, box, version }) {
    this.engine = engine;
    this.until = until;
    this.box = box;
    this.version = version;
  }

  async run({ until, contacts, slice, signal, onProgress } = {}) {
    signal?.throwIfAborted();
    // A simulation that is closed has stopped.
    const stop = () => this.engine.call('stop', []).catch(() => {});
    signal?.addEventListener('abort', stop);
    try {
      return await this.engine.call('run', [{ until, contacts, slice }], onProgress);
    } finally {
      signal?.removeEventListener('abort', stop);
    }
  }

  stop() {
    return this.engine.call('stop', []);
  }

  status() {
    return this.engine.call('status', []);
  }

  positions(out) {
    return this.#read('position', out);
  }

  velocities(out) {
    return this.#read('velocity', out);
  }

  spins(out) {
    return this.#read('spin', out);
  }

  radii(out) {
    return this.#read('radius', out);
  }

  masses(out) {
    return this.#read('mass', out);
  }

  species(out) {
    return this.#read('species', out);
  }

  ids(out) {
    return this.#read('id', out);
  }

  totals() {
    return this.engine.call('totals', []);
  }

  keepContacts(keep, most) {
    return this.engine.call('keepContacts', [keep, most]);
  }

  contacts() {
    return this.engine.call('contacts', []);
  }

  nextContact(until = Infinity) {
    return this.engine.call('nextContact', [until]);
  }

  setVelocities(ids, velocities) {
    return this.engine.call('setVelocities', [ids, velocities]);
  }

  add(sphere) {
    return this.engine.call('add', [sphere]);
  }

  remove(id) {
    return this.engine.call('remove', [id]);
  }

  rays(origins, directions, most = Infinity) {
    return this.engine.call('rays', [origins, directions, most]);
  }

  keepMeasures(keep) {
    return this.engine.call('keepMeasures', [keep]);
  }

  measures() {
    return this.engine.call('measures', []);
  }

  beginRecording() {
    return this.engine.call('beginRecording', []);
  }

  endRecording() {
    return this.engine.call('endRecording', []);
  }

  recording() {
    return this.engine.call('recording', []);
  }

  serveRecording(port) {
    return this.engine.call('serveRecording', [port], undefined, [port]);
  }

  save() {
    return this.engine.call('save', []);
  }

  close() {
    this.engine.end();
  }

  // An array that is given moves to the worker and back.
  #read(field, out) {
    return this.engine.call('read', [field, out], undefined, out ? [out.buffer] : []);
  }
}

async function started(method, first, { worker = true, wasm, ...options } = {}) {
  const engine = worker ? await Remote.make() : new Direct();
  try {
    const facts = await engine.start(method, [first, { ...options, wasm: await compiledModule(wasm) }]);
    return new Simulation(engine, facts);
  } catch (error) {
    if (worker) engine.end();
    throw error;
  }
}

/** Starts what a scenario describes. */
export function open(text, options) {
  return started('open', text, options);
}

/** Continues a simulation that was saved, here or anywhere. */
export function load(bytes, options) {
  return started('load', bytes, options);
}

/** What a scenario is refused for, or null. */
export async function check(text, options) {
  try {
    (await started('open', text, options)).close();
    return null;
  } catch (error) {
    if (error instanceof HardballError) return error;
    throw error;
  }
}
