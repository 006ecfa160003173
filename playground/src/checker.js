// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The worker that reads scenarios while they are edited: {id, text, name, files, wasm} is answered by {id, until} or {id, error}.
import { HardballError } from '../package/error.js';
import { nativeOf } from '../package/native.js';

function check(native, { text, name, files }) {
  return native.scoped((scope) => {
    const until = scope.bytes(8);
    const [textAt, nameAt] = [scope.text(text), scope.text(name)];
    native.withFiles(files, () => native.check(native.module._playground_check(textAt, nameAt, until)));
    const end = native.number(until);
    return { until: Number.isFinite(end) ? end : null };
  });
}

onmessage = async ({ data }) => {
  try {
    postMessage({ id: data.id, ...check(await nativeOf(data.wasm), data) });
  } catch (error) {
    if (!(error instanceof HardballError)) throw error;
    const { problem, remedy, message, place } = error;
    postMessage({ id: data.id, error: { problem, remedy, message, place } });
  }
};
