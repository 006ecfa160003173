// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import { PortSource } from '../../../apps/viewer/page/src/recording/port_source.js';

const kStatus = { finished: false, failed: null, damaged: null, reached: 2, collisions: 5, mergers: 0, walls: 1 };

// A source at one end of a channel, and `answer` at the other.
function sourceOf(answer) {
  const { port1, port2 } = new MessageChannel();
  port2.onmessage = ({ data: { id, ...question } }) => port2.postMessage({ id, ...answer(question) });
  return { source: new PortSource(port1), close: () => port2.close() };
}

test('a recording comes through a port while it grows', async () => {
  const ends = [1, 2];
  const asked = [];
  const { source, close } = sourceOf((question) => {
    asked.push(question);
    if (question.what === 'header') return { header: { spheres: 2 }, spheres: Float64Array.of(0.5, 1, 3, 4) };
    return { ends: ends.slice(question.from), status: kStatus };
  });
  await source.open();
  assert.deepEqual([[...source.radii], [...source.masses]], [
    [0.5, 1],
    [3, 4],
  ]);
  assert.deepEqual([source.ends, source.status], [[1, 2], kStatus]);
  ends.push(3);
  await source.poll();
  assert.deepEqual(source.ends, [1, 2, 3]);
  assert.deepEqual(asked, [{ what: 'header' }, { what: 'status', from: 0 }, { what: 'status', from: 2 }]);
  assert.equal(source.replayAddress, '');
  close();
});

test('what cannot be answered is an error, and the next question is answered', async () => {
  let isThere = false;
  const { source, close } = sourceOf(() => (isThere ? { ends: [], status: kStatus } : { error: 'there is no recording' }));
  await assert.rejects(source.poll(), /there is no recording/);
  isThere = true;
  await source.poll();
  assert.equal(source.status.reached, 2);
  close();
});

test('answers find their questions, in whatever order they come', async () => {
  const { port1, port2 } = new MessageChannel();
  const ids = [];
  port2.onmessage = ({ data: { id } }) => ids.push(id) === 2 && ids.reverse().forEach((each) => port2.postMessage({ id: each, number: each }));
  const source = new PortSource(port1);
  const [first, second] = await Promise.all([source.ask('a'), source.ask('b')]);
  assert.deepEqual([first.number, second.number], [1, 2]);
  port2.close();
});
