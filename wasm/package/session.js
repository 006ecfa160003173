// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { HardballError } from './error.js';
import { kTypes, nativeOf } from './native.js';
import { Recorded } from './recorded.js';

// The enumerations of the C API, in its order.
const kFields = ['id', 'position', 'velocity', 'radius', 'mass', 'spin', 'species'];
const kEngines = ['automatic', 'cells', 'neighbors', 'all_pairs', 'paper'];
const kKinds = [null, 'collision', 'wall'];
const kRunStatus = ['time', 'contacts', 'steps', 'stopped'];
const kBoundaries = ['wall', 'periodic', 'open', 'flat'];

const kSlice = 8; // as long as a run goes on before others have their turn [ms]
const kMostContacts = 0xffff_ffff_ffff_ffffn;

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

// As TOML has it.
function valueText(value) {
  if (Array.isArray(value)) return `[${value.map(valueText).join(', ')}]`;
  return typeof value === 'string' ? JSON.stringify(value) : String(value);
}

function engineNumber(engine) {
  const number = kEngines.indexOf(engine);
  if (number >= 0) return number;
  throw new HardballError({
    problem: `there is no engine '${engine}'`,
    where: 'engine',
    remedy: `choose among ${kEngines.join(', ')}`,
  });
}

/** A simulation in this thread; Simulation of index.js has the same methods, and index.d.ts says what they do. */
export class Session {
  constructor(native, address, until) {
    this.native = native;
    this.module = native.module;
    this.address = address;
    this.until = until;
    this.isStopped = false;
    this.isRunning = false;
    this.kept = []; // contacts of slices, as bytes
    this.keptCount = 0;
    this.mostKept = 0;
    this.recorded = null;
    this.failure = null; // of the last run
  }

  static async open(text, { name = 'scenario.toml', values = {}, files = {}, engine = 'automatic', wasm } = {}) {
    const native = await nativeOf(wasm);
    const { module, layout } = native;
    const number = engineNumber(engine);
    return native.scoped((scope) => {
      const overrides = Object.entries(values).map(([key, value]) => scope.text(`${key}=${valueText(value)}`));
      const list = scope.copy(Uint32Array.from(overrides));
      const options = scope.struct('hb_options');
      const [out, until] = [scope.bytes(4), scope.bytes(8)];
      const [textAt, nameAt] = [scope.text(text), scope.text(name)];
      native.view.setUint32(options + layout.hb_options.threads, 1, true);
      native.view.setInt32(options + layout.hb_options.engine, number, true);
      native.withFiles(files, () =>
        native.check(module._hb_start_scenario(textAt, nameAt, list, overrides.length, options, out, until)),
      );
      const end = native.number(until);
      return new this(native, native.whole(out), Number.isFinite(end) ? end : null);
    });
  }

  static async load(bytes, { wasm } = {}) {
    const native = await nativeOf(wasm);
    return native.scoped((scope) => {
      const out = scope.bytes(4);
      native.check(native.module._hb_load(scope.copy(bytes), bytes.length, out));
      return new this(native, native.whole(out), null);
    });
  }

  facts() {
    const { native, module } = this;
    return native.scoped((scope) => {
      const [size, boundary] = [scope.bytes(24), scope.bytes(12)];
      native.check(module._hb_get_box(this.address, size, boundary));
      return {
        until: this.until,
        box: {
          size: native.numbers(size, 3),
          boundary: [0, 4, 8].map((offset) => kBoundaries[native.whole(boundary + offset)]),
        },
        version: native.text(module._hb_version()),
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
    this.failure = null;
    try {
      const end = this.#contactCount() + contacts;
      let steps = 256;
      for (;;) {
        const begin = performance.now();
        const reason = this.#runSlice(until, end - this.#contactCount(), steps);
        this.#keep();
        if (reason !== 'steps') return this.status(reason);
        const elapsed = Math.max(performance.now() - begin, 0.1);
        steps = Math.max(1, Math.round(steps * Math.min(2, Math.max(0.1, slice / elapsed))));
        told(this.status());
        await pause();
        if (this.isStopped) return this.status('stopped');
      }
    } catch (error) {
      this.failure = error.message;
      throw error;
    } finally {
      this.isRunning = false;
    }
  }

  #contactCount() {
    return Number(this.module._hb_collisions(this.address) + this.module._hb_wall_contacts(this.address));
  }

  #runSlice(until, contacts, steps) {
    const { native } = this;
    const layout = native.layout.hb_limits;
    return native.scoped((scope) => {
      const [limits, out] = [scope.struct('hb_limits'), scope.bytes(4)];
      const { view } = native;
      view.setFloat64(limits + layout.until, until, true);
      view.setBigUint64(limits + layout.contacts, Number.isFinite(contacts) ? BigInt(contacts) : kMostContacts, true);
      view.setBigUint64(limits + layout.steps, BigInt(steps), true);
      native.check(this.module._hb_run(this.address, limits, out));
      return kRunStatus[native.whole(out)];
    });
  }

  keepContacts(keep, most = 1e6) {
    this.mostKept = keep ? most : 0;
    this.native.check(this.module._hb_keep_contacts(this.address, keep ? 1 : 0));
  }

  #keep() {
    if (this.keptCount >= this.mostKept) return;
    this.native.scoped((scope) => {
      const out = scope.bytes(4);
      const begin = this.module._hb_contacts(this.address, out);
      const count = Math.min(this.native.whole(out), this.mostKept - this.keptCount);
      if (count > 0) this.kept.push(this.module.HEAPU8.slice(begin, begin + count * this.native.layout.hb_contact.size));
      this.keptCount += count;
    });
  }

  contacts() {
    const layout = this.native.layout.hb_contact;
    const count = this.keptCount;
    const columns = {
      length: count,
      time: new Float64Array(count),
      kind: new Uint8Array(count),
      outcome: new Uint8Array(count),
      first: new Uint32Array(count),
      second: new Uint32Array(count),
      point: new Float64Array(3 * count),
      normal: new Float64Array(3 * count),
      impulse: new Float64Array(3 * count),
      impactSpeed: new Float64Array(count),
    };
    let row = 0;
    for (const bytes of this.kept) {
      const view = new DataView(bytes.buffer);
      for (let at = 0; at < bytes.byteLength; at += layout.size, ++row) {
        columns.time[row] = view.getFloat64(at + layout.time, true);
        columns.impactSpeed[row] = view.getFloat64(at + layout.impact_speed, true);
        for (const name of ['kind', 'outcome', 'first', 'second']) columns[name][row] = view.getUint32(at + layout[name], true);
        for (const name of ['point', 'normal', 'impulse'])
          for (let k = 0; k < 3; ++k) columns[name][3 * row + k] = view.getFloat64(at + layout[name] + 8 * k, true);
      }
    }
    this.kept = [];
    this.keptCount = 0;
    return columns;
  }

  /** The numbers of a field in a typed array: `out`, or a new one. */
  read(field, out) {
    const rows = this.module._hb_size(this.address);
    const width = ['position', 'velocity', 'spin'].includes(field) ? 3 : 1;
    const isWhole = field === 'id' || field === 'species';
    const Kind = isWhole ? Uint32Array : out instanceof Float32Array ? Float32Array : Float64Array;
    const type = isWhole ? kTypes.u32 : Kind === Float32Array ? kTypes.f32 : kTypes.f64;
    const array = out instanceof Kind && out.length >= rows * width ? out : new Kind(rows * width);
    const stride = Kind.BYTES_PER_ELEMENT * width;
    this.native.scoped((scope) => {
      const data = scope.bytes(rows * stride);
      const description = scope.array(data, stride, type);
      this.native.check(this.module._hb_read(this.address, kFields.indexOf(field), 0, rows, description));
      array.set(new Kind(this.module.HEAPU8.buffer, data, rows * width));
    });
    return array;
  }

  totals() {
    const { native } = this;
    const layout = native.layout.hb_totals;
    return native.scoped((scope) => {
      const totals = scope.struct('hb_totals');
      native.check(this.module._hb_get_totals(this.address, totals));
      return {
        energy: native.number(totals + layout.energy),
        kineticEnergy: native.number(totals + layout.kinetic_energy),
        rotationalEnergy: native.number(totals + layout.rotational_energy),
        momentum: native.numbers(totals + layout.momentum, 3),
        mass: native.number(totals + layout.mass),
      };
    });
  }

  nextContact(until) {
    const { native } = this;
    const layout = native.layout.hb_future_contact;
    return native.scoped((scope) => {
      const out = scope.struct('hb_future_contact');
      native.check(this.module._hb_next_contact(this.address, until, out));
      const kind = kKinds[native.whole(out + layout.kind)];
      return (
        kind && {
          time: native.number(out + layout.time),
          kind,
          first: native.whole(out + layout.first),
          second: native.whole(out + layout.second),
        }
      );
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
    this.native.scoped((scope) => {
      const rows = scope.array(scope.copy(Float64Array.from(velocities)), 24, kTypes.f64);
      const idsAt = scope.copy(Uint32Array.from(ids));
      this.native.check(this.module._hb_change_velocities(this.address, ids.length, idsAt, rows));
    });
  }

  add({ position, velocity = [0, 0, 0], radius = 0.5, mass = 1, spin = [0, 0, 0], inertiaFactor = 0.4, species = 0 }) {
    const { native } = this;
    const layout = native.layout.hb_sphere;
    return native.scoped((scope) => {
      const [sphere, id] = [scope.struct('hb_sphere'), scope.bytes(4)];
      const { view } = native;
      const set = (member, ...numbers) =>
        numbers.forEach((number, k) => view.setFloat64(sphere + layout[member] + 8 * k, number, true));
      set('position', ...position);
      set('velocity', ...velocity);
      set('radius', radius);
      set('mass', mass);
      set('spin', ...spin);
      set('inertia_factor', inertiaFactor);
      view.setUint32(sphere + layout.species, species, true);
      native.check(this.module._hb_add(this.address, sphere, id));
      return native.whole(id);
    });
  }

  remove(id) {
    this.native.check(this.module._hb_remove(this.address, id));
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
    const { native } = this;
    const { size } = native.layout.hb_ray_hit;
    return native.scoped((scope) => {
      const rows = (numbers) => scope.array(scope.copy(Float64Array.from(numbers)), 24, kTypes.f64);
      const out = scope.bytes(count * size);
      native.check(this.module._hb_rays(this.address, count, rows(origins), rows(directions), most, 0, 1, out));
      return Array.from({ length: count }, (_, k) => this.#hitAt(out + k * size));
    });
  }

  #hitAt(address) {
    const { native } = this;
    const layout = native.layout.hb_ray_hit;
    const kind = kKinds[native.whole(address + layout.kind)];
    return (
      kind && {
        kind,
        body: native.whole(address + layout.body),
        distance: native.number(address + layout.distance),
        point: native.numbers(address + layout.point, 3),
        normal: native.numbers(address + layout.normal, 3),
      }
    );
  }

  keepMeasures(keep) {
    this.native.check(this.module._hb_keep_measures(this.address, keep ? 1 : 0));
  }

  measures() {
    return this.native.scoped((scope) => {
      const json = scope.bytes(4);
      this.native.check(this.module._hb_get_measures(this.address, json, 0));
      return JSON.parse(this.native.text(this.native.whole(json)));
    });
  }

  beginRecording() {
    const recorded = new Recorded(this.module, this.module._hb_size(this.address));
    this.native.scoped((scope) => {
      this.native.check(this.module._hb_begin_recording(this.address, scope.text(recorded.path)));
    });
    this.recorded?.remove();
    this.recorded = recorded;
    recorded.begin();
  }

  endRecording() {
    this.native.check(this.module._hb_end_recording(this.address));
    if (this.recorded) this.recorded.isComplete = true;
  }

  recording() {
    return this.#completed().read();
  }

  serveRecording(port) {
    const answers = {
      header: () => {
        const { header } = this.#completed();
        return { header, spheres: this.recorded.spheres() };
      },
      status: ({ from }) => {
        const recorded = this.#completed();
        recorded.update();
        const { time, spheres, collisions, wallContacts, hash } = this.status();
        return {
          ends: recorded.chunks.slice(from).map(({ end }) => end),
          status: {
            finished: recorded.isComplete,
            failed: this.failure,
            damaged: null,
            reached: time,
            collisions,
            mergers: recorded.spheresAtBegin - spheres,
            walls: wallContacts,
            event_log_hash: hash,
          },
        };
      },
      chunk: ({ number }) => {
        const { at, length } = this.recorded.chunks[number];
        return { buffer: this.recorded.read(at, length).buffer };
      },
    };
    port.onmessage = ({ data: { id, what, ...parts } }) => {
      try {
        const answer = answers[what](parts);
        const moved = [answer.buffer, answer.spheres?.buffer].filter(Boolean);
        port.postMessage({ id, ...answer }, moved);
      } catch (error) {
        port.postMessage({ id, error: error.message });
      }
    };
  }

  // The recording, complete up to the last contact.
  #completed() {
    if (!this.recorded) {
      throw new HardballError({ problem: 'there is no recording', where: 'recording', remedy: 'call beginRecording before' });
    }
    if (!this.recorded.isComplete) this.native.check(this.module._hb_flush_recording(this.address, 0));
    return this.recorded;
  }

  save() {
    return this.native.scoped((scope) => {
      const [bytes, count] = [scope.bytes(4), scope.bytes(4)];
      this.native.check(this.module._hb_save(this.address, bytes, count));
      const begin = this.native.whole(bytes);
      return this.module.HEAPU8.slice(begin, begin + this.native.whole(count));
    });
  }

  close() {
    this.stop();
    this.module._hb_free(this.address);
    this.address = 0;
    this.recorded?.remove();
  }
}
