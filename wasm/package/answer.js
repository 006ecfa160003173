// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const isInPage = typeof WorkerGlobalScope !== 'undefined';

// The buffers of typed arrays in a result, which move instead of being copied.
function buffersOf(result) {
  if (ArrayBuffer.isView(result)) return [result.buffer];
  if (result === null || typeof result !== 'object') return [];
  return Object.values(result).flatMap((part) => (ArrayBuffer.isView(part) ? [part.buffer] : []));
}

/**
 * Makes the worker in which this runs, of a page or of node, one simulation: calls of the methods of `Session`, a class, arrive
 * as messages, and results go back.
 */
export async function answerCalls(Session) {
  const port = isInPage ? globalThis : (await import('node:worker_threads')).parentPort;
  let session = null;

  async function answer({ call, method, parts }) {
    const told = (status) => port.postMessage({ call, status });
    try {
      let result;
      if (method === 'open' || method === 'load') {
        session = await Session[method](...parts);
        result = session.facts();
      } else {
        result = await (method === 'run' ? session.run(...parts, told) : session[method](...parts));
      }
      port.postMessage({ call, result }, buffersOf(result));
    } catch (error) {
      const { problem, where, remedy, message } = error;
      port.postMessage({ call, error: { problem: problem ?? message, where, remedy, isOurs: problem !== undefined } });
    }
  }

  if (isInPage) port.onmessage = ({ data }) => answer(data);
  else port.on('message', answer);
}
