// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What programs in TypeScript may write; it is compiled, and not run.
import { open, load, check, HardballError, type Simulation, type Status } from 'hardball';
const gas: Simulation = await open('x', { values: { 'run.seed': 2, 'box.size': [1, 2, 3] }, files: { 'a.obj': new Uint8Array(3) }, worker: false, wasm: new Uint8Array(3) });
const status: Status = await gas.run({ until: 2, onProgress: ({ time }) => console.log(time) });
const p: Float32Array = await gas.positions(new Float32Array(3));
const q: Float64Array = await gas.velocities();
const error: HardballError | null = await check('x');
if (error?.place) console.log(error.place.line + 1, status.hash.length, p.length, q.length);
const hits = await gas.rays([0, 0, 0], new Float64Array(3), 3);
console.log(hits[0]?.normal[2], (await gas.contacts()).point[0], (await load(await gas.save())).until);
await gas.keepMeasures(true);
const error_of_first: number | null | undefined = (await gas.measures())[0]?.quantities[0]?.error;
await gas.beginRecording();
await gas.serveRecording(new MessageChannel().port1);
console.log(error_of_first, (await gas.recording()).length);
await gas.add({ position: [1, 2, 3], mass: Infinity });
// @ts-expect-error: there is no such engine
await open('x', { engine: 'none' });
