// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { compiledModule } from './compile.js';
import { HardballError } from './error.js';
import instantiate from './module.js';

export const kTypes = { f64: 0, f32: 1, u32: 2, u64: 3 };

// Memory of the module that is freed when a call is over.
class Scope {
  constructor(native) {
    this.native = native;
    this.addresses = [];
  }

  bytes(count) {
    const address = this.native.module._malloc(Math.max(count, 1));
    if (address === 0) {
      throw new HardballError({ problem: 'there is not enough memory', remedy: 'use fewer spheres, or close other simulations' });
    }
    this.addresses.push(address);
    return address;
  }

  /** A struct of the C API whose first member is its size, if it has one. */
  struct(name) {
    const { size, struct_size } = this.native.layout[name];
    const address = this.bytes(size);
    this.native.module.HEAPU8.fill(0, address, address + size);
    if (struct_size !== undefined) this.native.view.setUint32(address + struct_size, size, true);
    return address;
  }

  /** A text that ends in a zero. */
  text(text) {
    const bytes = new TextEncoder().encode(text);
    const address = this.bytes(bytes.length + 1);
    this.native.module.HEAPU8.set(bytes, address);
    this.native.module.HEAPU8[address + bytes.length] = 0;
    return address;
  }

  /** A copy of a typed array. */
  copy(numbers) {
    const address = this.bytes(numbers.byteLength);
    this.native.module.HEAPU8.set(new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength), address);
    return address;
  }

  /** The description of rows of numbers at an address. */
  array(data, stride, type) {
    const address = this.struct('hb_array');
    const { view, layout } = this.native;
    view.setUint32(address + layout.hb_array.data, data, true);
    view.setInt32(address + layout.hb_array.stride, stride, true);
    view.setInt32(address + layout.hb_array.type, type, true);
    return address;
  }

  free() {
    for (const address of this.addresses) this.native.module._free(address);
  }
}

/** The C API in this thread: its memory, its structs, its files and its errors. */
export class Native {
  constructor(module) {
    this.module = module;
    this.layout = this.#readLayout();
  }

  /** Anew after each call that may take memory. */
  get view() {
    return new DataView(this.module.HEAPU8.buffer);
  }

  /** Calls use(scope), and frees the memory of the scope. */
  scoped(use) {
    const scope = new Scope(this);
    try {
      return use(scope);
    } finally {
      scope.free();
    }
  }

  text(address) {
    const bytes = this.module.HEAPU8;
    return new TextDecoder().decode(bytes.subarray(address, bytes.indexOf(0, address)));
  }

  number(address) {
    return this.view.getFloat64(address, true);
  }

  numbers(address, count) {
    return Array.from({ length: count }, (_, k) => this.number(address + 8 * k));
  }

  whole(address) {
    return this.view.getUint32(address, true);
  }

  /** Throws what a call has refused. */
  check(status) {
    if (status === 0) return;
    const error = this.module._hb_last_error();
    const part = (name) => this.text(this.whole(error + this.layout.hb_error[name]));
    throw new HardballError({ problem: part('problem'), where: part('where'), remedy: part('remedy') });
  }

  /** Calls use() in a folder with these files, a map of names to bytes or texts, and removes it. */
  withFiles(files, use) {
    const { FS } = this.module;
    const folder = '/scenario';
    const remove = (path) => {
      for (const name of FS.readdir(path).filter((entry) => entry !== '.' && entry !== '..')) {
        const inner = `${path}/${name}`;
        if (FS.isDir(FS.stat(inner).mode)) remove(inner);
        else FS.unlink(inner);
      }
      FS.rmdir(path);
    };
    FS.mkdir(folder);
    try {
      for (const [name, content] of Object.entries(files)) {
        const path = `${folder}/${name}`;
        FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
        FS.writeFile(path, content);
      }
      FS.chdir(folder);
      return use();
    } finally {
      FS.chdir('/');
      remove(folder);
    }
  }

  // Where the members of structs lie, and how large structs are: { hb_array: { data: 0, ..., size: 12 } }, from layout.c.
  #readLayout() {
    const layout = {};
    const { view } = this;
    for (let at = this.module._hardball_layout(); view.getUint32(at, true) !== 0; at += 8) {
      const [struct, member] = this.text(view.getUint32(at, true)).split('.');
      (layout[struct] ??= {})[member] = view.getUint32(at + 4, true);
    }
    return layout;
  }
}

const natives = new Map();

/** The C API in this thread; `wasm`: as for compiledModule. */
export async function nativeOf(wasm) {
  const compiled = await compiledModule(wasm);
  if (!natives.has(compiled)) {
    const module = await new Promise((resolve, reject) => {
      instantiate({
        instantiateWasm: (imports, receive) => {
          WebAssembly.instantiate(compiled, imports).then(receive, reject);
          return {};
        },
      }).then(resolve, reject);
    });
    natives.set(compiled, new Native(module));
  }
  return natives.get(compiled);
}
