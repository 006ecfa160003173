// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import instantiate from './module.js';
import { HardballError } from './error.js';
import * as layout from './layout.js';
import { moduleOf } from './module_of.js';

const kFolder = '/scenario';

// As long as a run may last before others have their turn [ms].
const kSlice = 8;

/** The library in this thread: its memory, its strings, and its errors. */
class Library {
  constructor(module) {
    this.module = module;
    this.folders = 0;
  }

  get view() {
    return new DataView(this.module.HEAPU8.buffer);
  }

  /** Calls use(address) with so many bytes, which are freed afterwards. */
  with(bytes, use) {
    const address = this.module._malloc(Math.max(bytes, 1));
    if (address === 0) throw new HardballError({ problem: 'there is not enough memory' });
    try {
      return use(address);
    } finally {
      this.module._free(address);
    }
  }

  /** Calls use(address) with a text that ends in a zero. */
  withText(text, use) {
    const bytes = new TextEncoder().encode(text);
    return this.with(bytes.length + 1, (address) => {
      this.module.HEAPU8.set(bytes, address);
      this.module.HEAPU8[address + bytes.length] = 0;
      return use(address);
    });
  }

  text(address) {
    const bytes = this.module.HEAPU8;
    return new TextDecoder().decode(bytes.subarray(address, bytes.indexOf(0, address)));
  }

  /** Throws what a call has refused. */
  check(status) {
    if (status === 0) return;
    const error = this.module._hb_last_error();
    const part = (offset) => this.text(this.view.getUint32(error + offset, true));
    const { problem, where, remedy } = layout.kError;
    throw new HardballError({ problem: part(problem), where: part(where), remedy: part(remedy) });
  }

  /** A folder with these files: a map of names to bytes or texts. */
  folderOf(files) {
    const { FS } = this.module;
    const folder = `${kFolder}${this.folders++}`;
    FS.mkdir(folder);
    for (const [name, content] of Object.entries(files)) {
      const path = `${folder}/${name}`;
      FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
      FS.writeFile(path, content);
    }
    return folder;
  }
}

const libraries = new Map();

async function libraryOf(wasm) {
  const compiled = await moduleOf(wasm);
  if (!libraries.has(compiled)) {
    const module = await new Promise((resolve, reject) => {
      instantiate({
        instantiateWasm: (imports, receive) => {
          WebAssembly.instantiate(compiled, imports).then(receive, reject);
          return {};
        },
      }).then(resolve, reject);
    });
    libraries.set(compiled, new Library(module));
  }
  return libraries.get(compiled);
}

// Lets messages and other tasks have their turn.
function pause() {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}

/** A simulation in this thread; Simulation of index.js has the same methods, and says what they do. */
export class Session {
  constructor(library, address, until) {
    this.library = library;
    this.module = library.module;
    this.address = address;
    this.until = until;
    this.isStopped = false;
    this.isRunning = false;
    this.kept = []; // contacts of slices, as bytes
    this.mostKept = 0;
  }

  static async open(text, { name = 'scenario.toml', values = {}, files = {}, engine = 'automatic', wasm } = {}) {
    const library = await libraryOf(wasm);
    const { module } = library;
    const folder = library.folderOf(files);
    const number = layout.kEngines.indexOf(engine);
    if (number < 0) {
      throw new HardballError({
        problem: `there is no engine '${engine}'`,
        where: 'engine',
        remedy: `choose among ${layout.kEngines.join(', ')}`,
      });
    }
    const overrides = Object.entries(values).map(([key, value]) => `${key}=${valueText(value)}`);
    const withTexts = (texts, use, addresses = []) =>
      addresses.length === texts.length
        ? use(addresses)
        : library.withText(texts[addresses.length], (at) => withTexts(texts, use, [...addresses, at]));
    return withTexts([text, `${folder}/${name}`, ...overrides], ([textAt, nameAt, ...at]) =>
      library.with(layout.kOptions.size + 16 + 4 * at.length, (options) => {
        const [out, until, list] = [0, 8, 16].map((offset) => options + layout.kOptions.size + offset);
        const { view } = library;
        view.setUint32(options, layout.kOptions.size, true);
        view.setFloat64(options + layout.kOptions.cellEdge, 0, true);
        view.setUint32(options + layout.kOptions.threads, 1, true);
        view.setInt32(options + layout.kOptions.engine, number, true);
        at.forEach((address, k) => view.setUint32(list + 4 * k, address, true));
        try {
          library.check(module._hb_start_scenario(textAt, nameAt, list, at.length, options, out, until));
        } catch (error) {
          throw error instanceof HardballError ? withoutFolder(error, folder) : error;
        }
        const end = library.view.getFloat64(until, true);
        return new Session(library, library.view.getUint32(out, true), Number.isFinite(end) ? end : null);
      }),
    );
  }

  static async load(bytes, { wasm } = {}) {
    const library = await libraryOf(wasm);
    return library.with(bytes.length, (at) =>
      library.with(4, (out) => {
        library.module.HEAPU8.set(bytes, at);
        library.check(library.module._hb_load(at, bytes.length, out));
        return new Session(library, library.view.getUint32(out, true), null);
      }),
    );
  }

  facts() {
    return this.library.with(48, (at) => {
      this.library.check(this.module._hb_get_box(this.address, at, at + 24));
      const { view } = this.library;
      return {
        until: this.until,
        box: {
          size: [0, 8, 16].map((offset) => view.getFloat64(at + offset, true)),
          boundary: [24, 28, 32].map((offset) => layout.kBoundaries[view.getInt32(at + offset, true)]),
        },
        version: this.library.text(this.module._hb_version()),
      };
    });
  }

  status(reason = null) {
    return {
      time: this.module._hb_time(this.address),
      spheres: this.module._hb_size(this.address),
      collisions: Number(this.module._hb_collisions(this.address)),
      wallContacts: Number(this.module._hb_wall_contacts(this.address)),
      hash: BigInt.asUintN(64, this.module._hb_hash(this.address)).toString(16).padStart(16, '0'),
      reason,
    };
  }

  stop() {
    this.isStopped = true;
  }

  /** `told(status)` is called after each slice. */
  async run({ until = Infinity, contacts = Infinity, slice = kSlice } = {}, told = () => {}) {
    if (this.isRunning) {
      throw new HardballError({ problem: 'the simulation is running', where: 'run', remedy: 'wait for the run, or stop it' });
    }
    this.isRunning = true;
    this.isStopped = false;
    try {
      const before = this.contactCount_();
      let steps = 256;
      for (;;) {
        const begin = performance.now();
        const left = contacts - (this.contactCount_() - before);
        const reason = this.slice_(until, left, steps);
        this.keep_();
        if (reason !== 'steps') return this.status(reason);
        if (this.isStopped) return this.status('stopped');
        const elapsed = performance.now() - begin;
        steps = Math.max(1, Math.round(steps * Math.min(2, Math.max(0.1, slice / Math.max(elapsed, 0.1)))));
        told(this.status());
        await pause();
        if (this.isStopped) return this.status('stopped');
      }
    } finally {
      this.isRunning = false;
    }
  }

  /** Whether contacts are kept for contacts(), and how many at most. */
  keepContacts(keep, most = 1e6) {
    this.mostKept = keep ? most : 0;
    this.library.check(this.module._hb_keep_contacts(this.address, keep ? 1 : 0));
  }

  keep_() {
    const kept = this.kept.reduce((sum, { byteLength }) => sum + byteLength, 0) / layout.kContact.size;
    if (kept >= this.mostKept) return;
    this.library.with(4, (at) => {
      const begin = this.module._hb_contacts(this.address, at);
      const count = Math.min(this.library.view.getUint32(at, true), this.mostKept - kept);
      if (count > 0) this.kept.push(this.module.HEAPU8.slice(begin, begin + count * layout.kContact.size));
    });
  }

  /** The contacts since the last call, as columns. */
  contacts() {
    const size = layout.kContact.size;
    const count = this.kept.reduce((sum, { byteLength }) => sum + byteLength, 0) / size;
    const columns = {
      length: count,
      time: new Float64Array(count),
      kind: new Uint8Array(count),
      outcome: new Uint8Array(count),
      first: new Uint32Array(count),
      second: new Uint32Array(count),
      impactSpeed: new Float64Array(count),
    };
    for (const name of ['point', 'normal', 'impulse']) columns[name] = new Float64Array(3 * count);
    let row = 0;
    for (const bytes of this.kept) {
      const view = new DataView(bytes.buffer);
      for (let at = 0; at < bytes.byteLength; at += size, ++row) {
        columns.time[row] = view.getFloat64(at, true);
        columns.kind[row] = view.getInt32(at + layout.kContact.kind, true);
        columns.outcome[row] = view.getInt32(at + layout.kContact.outcome, true);
        columns.first[row] = view.getUint32(at + layout.kContact.first, true);
        columns.second[row] = view.getUint32(at + layout.kContact.second, true);
        columns.impactSpeed[row] = view.getFloat64(at + layout.kContact.impactSpeed, true);
        for (const name of ['point', 'normal', 'impulse'])
          for (let k = 0; k < 3; ++k)
            columns[name][3 * row + k] = view.getFloat64(at + layout.kContact[name] + 8 * k, true);
      }
    }
    this.kept = [];
    return columns;
  }

  contactCount_() {
    return Number(this.module._hb_collisions(this.address) + this.module._hb_wall_contacts(this.address));
  }

  slice_(until, contacts, steps) {
    const most = 0xffffffffffffffffn;
    return this.library.with(layout.kLimits.size + 4, (limits) => {
      const { view } = this.library;
      view.setUint32(limits, layout.kLimits.size, true);
      view.setFloat64(limits + layout.kLimits.until, until, true);
      view.setBigUint64(limits + layout.kLimits.contacts, Number.isFinite(contacts) ? BigInt(contacts) : most, true);
      view.setBigUint64(limits + layout.kLimits.steps, BigInt(steps), true);
      view.setUint32(limits + layout.kLimits.stop, 0, true);
      view.setUint32(limits + layout.kLimits.context, 0, true);
      this.library.check(this.module._hb_run(this.address, limits, limits + layout.kLimits.size));
      return layout.kRunStatus[this.library.view.getInt32(limits + layout.kLimits.size, true)];
    });
  }

  /** The numbers of a field in a typed array: `out`, or a new one. */
  read(field, out) {
    const rows = this.module._hb_size(this.address);
    const width = ['position', 'velocity', 'spin'].includes(field) ? 3 : 1;
    const isWhole = field === 'id' || field === 'species';
    const Kind = isWhole ? Uint32Array : out instanceof Float32Array ? Float32Array : Float64Array;
    const array = out instanceof Kind && out.length >= rows * width ? out : new Kind(rows * width);
    const bytes = Kind.BYTES_PER_ELEMENT * width;
    const type = isWhole ? layout.kTypes.u32 : Kind === Float32Array ? layout.kTypes.f32 : layout.kTypes.f64;
    this.library.with(rows * bytes, (data) =>
      this.withArray(data, bytes, type, (description) => {
        this.library.check(this.module._hb_read(this.address, layout.kFields[field], 0, rows, description));
        array.set(new Kind(this.module.HEAPU8.buffer, data, rows * width));
      }),
    );
    return array;
  }

  withArray(data, stride, type, use) {
    return this.library.with(layout.kArray.size, (at) => {
      const { view } = this.library;
      view.setUint32(at, data, true);
      view.setInt32(at + layout.kArray.stride, stride, true);
      view.setInt32(at + layout.kArray.type, type, true);
      return use(at);
    });
  }

  // Calls use(address) with a copy of an array of numbers.
  withNumbers(numbers, use) {
    return this.library.with(numbers.byteLength, (at) => {
      const bytes = new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength);
      this.module.HEAPU8.set(bytes, at);
      return use(at);
    });
  }

  totals() {
    return this.library.with(layout.kTotals.size, (at) => {
      this.library.view.setUint32(at, layout.kTotals.size, true);
      this.library.check(this.module._hb_get_totals(this.address, at));
      const number = (offset) => this.library.view.getFloat64(at + offset, true);
      const { energy, kineticEnergy, rotationalEnergy, momentum, mass } = layout.kTotals;
      return {
        energy: number(energy),
        kineticEnergy: number(kineticEnergy),
        rotationalEnergy: number(rotationalEnergy),
        momentum: [0, 8, 16].map((offset) => number(momentum + offset)),
        mass: number(mass),
      };
    });
  }

  nextContact(until) {
    return this.library.with(layout.kFutureContact.size, (at) => {
      this.library.check(this.module._hb_next_contact(this.address, until, at));
      const { view } = this.library;
      const kind = layout.kKinds[view.getInt32(at + layout.kFutureContact.kind, true)];
      if (kind === null) return null;
      const id = (offset) => view.getUint32(at + offset, true);
      return {
        time: view.getFloat64(at, true),
        kind,
        first: id(layout.kFutureContact.first),
        second: id(layout.kFutureContact.second),
      };
    });
  }

  setVelocities(ids, velocities) {
    if (velocities.length !== 3 * ids.length) {
      throw new HardballError({
        problem: `there are ${velocities.length} numbers for ${ids.length} velocities`,
        where: 'velocities',
        remedy: 'give three for each id',
      });
    }
    this.withNumbers(Uint32Array.from(ids), (idsAt) =>
      this.withNumbers(Float64Array.from(velocities), (data) =>
        this.withArray(data, 24, layout.kTypes.f64, (description) =>
          this.library.check(this.module._hb_change_velocities(this.address, ids.length, idsAt, description)),
        ),
      ),
    );
  }

  add({ position, velocity = [0, 0, 0], radius = 0.5, mass = 1, spin = [0, 0, 0], inertiaFactor = 0.4, species = 0 }) {
    return this.library.with(layout.kSphere.size + 4, (at) => {
      const { view } = this.library;
      const vector = (offset, three) => three.forEach((part, k) => view.setFloat64(at + offset + 8 * k, part, true));
      view.setUint32(at, layout.kSphere.size, true);
      vector(layout.kSphere.position, position);
      vector(layout.kSphere.velocity, velocity);
      vector(layout.kSphere.radius, [radius]);
      vector(layout.kSphere.mass, [mass]);
      vector(layout.kSphere.spin, spin);
      vector(layout.kSphere.inertiaFactor, [inertiaFactor]);
      view.setUint32(at + layout.kSphere.species, species, true);
      this.library.check(this.module._hb_add(this.address, at, at + layout.kSphere.size));
      return this.library.view.getUint32(at + layout.kSphere.size, true);
    });
  }

  remove(id) {
    this.library.check(this.module._hb_remove(this.address, id));
  }

  rays(origins, directions, most) {
    const count = origins.length / 3;
    if (origins.length !== directions.length || !Number.isInteger(count)) {
      throw new HardballError({
        problem: `there are ${origins.length} and ${directions.length} numbers`,
        where: 'rays',
        remedy: 'give three for each origin and each direction',
      });
    }
    const f64 = layout.kTypes.f64;
    return this.withNumbers(Float64Array.from(origins), (from) =>
      this.withNumbers(Float64Array.from(directions), (along) =>
        this.withArray(from, 24, f64, (fromArray) =>
          this.withArray(along, 24, f64, (alongArray) =>
            this.library.with(count * layout.kRayHit.size, (out) => {
              this.library.check(
                this.module._hb_rays(this.address, count, fromArray, alongArray, most, 0, 1, out),
              );
              return Array.from({ length: count }, (_, k) => this.hit_(out + k * layout.kRayHit.size));
            }),
          ),
        ),
      ),
    );
  }

  hit_(at) {
    const { view } = this.library;
    const kind = layout.kKinds[view.getInt32(at + layout.kRayHit.kind, true)];
    if (kind === null) return null;
    const vector = (offset) => [0, 8, 16].map((part) => view.getFloat64(at + offset + part, true));
    return {
      kind,
      body: view.getUint32(at + layout.kRayHit.body, true),
      distance: view.getFloat64(at, true),
      point: vector(layout.kRayHit.point),
      normal: vector(layout.kRayHit.normal),
    };
  }

  save() {
    return this.library.with(8, (at) => {
      this.library.check(this.module._hb_save(this.address, at, at + 4));
      const begin = this.library.view.getUint32(at, true);
      return this.module.HEAPU8.slice(begin, begin + this.library.view.getUint32(at + 4, true));
    });
  }

  close() {
    this.stop();
    this.module._hb_free(this.address);
    this.address = 0;
  }
}

// As TOML has it.
function valueText(value) {
  if (Array.isArray(value)) return `[${value.map(valueText).join(', ')}]`;
  return typeof value === 'string' ? JSON.stringify(value) : String(value);
}

function withoutFolder({ problem, where, remedy }, folder) {
  const short = (text) => text.replaceAll(`${folder}/`, '');
  return new HardballError({ problem: short(problem), where: short(where), remedy: short(remedy) });
}
