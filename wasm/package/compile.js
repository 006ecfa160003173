// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kBeside = new URL('./module.wasm', import.meta.url);

async function compiled(wasm) {
  if (wasm instanceof WebAssembly.Module) return wasm;
  if (wasm instanceof ArrayBuffer || ArrayBuffer.isView(wasm)) return WebAssembly.compile(wasm);
  const address = new URL(wasm, import.meta.url);
  if (address.protocol === 'file:' && typeof process === 'object') {
    const { readFile } = await import('node:fs/promises');
    return WebAssembly.compile(await readFile(address));
  }
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address}: ${response.status} ${response.statusText}`);
  // Some servers of static files do not know the type of WebAssembly.
  return response.headers.get('content-type') === 'application/wasm'
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}

const modules = new Map();

/** The compiled module, once for each place: an address, bytes, or the module itself; by default, beside this file. */
export function compiledModule(wasm = kBeside) {
  const key = wasm instanceof URL ? wasm.href : wasm;
  if (!modules.has(key)) modules.set(key, compiled(wasm));
  return modules.get(key);
}
