// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/** What is wrong, where, and what to do instead. */
export class HardballError extends Error {
  readonly problem: string;
  /** "file:line:column", or an argument; empty if there is no such place. */
  readonly where: string;
  /** What would be accepted; empty if nothing can be done. */
  readonly remedy: string;
  /** The line and column of the scenario, from 1. */
  readonly place: { line: number; column: number } | null;
}

/** A value of a scenario. */
export type Value = number | boolean | string | readonly Value[];

export interface Options {
  /** Where module.wasm is, or what is in it; by default, beside the package. */
  wasm?: string | URL | BufferSource | WebAssembly.Module;
  /** Whether the simulation runs in a worker of its own: true by default. */
  worker?: boolean;
}

export interface ScenarioOptions extends Options {
  /** The name of the scenario in errors: "scenario.toml" by default. */
  name?: string;
  /** Values in place of those of the text, such as { 'run.seed': 2 }. */
  values?: Record<string, Value>;
  /** The files that the scenario names, by their names. */
  files?: Record<string, string | Uint8Array>;
  engine?: 'automatic' | 'cells' | 'neighbors' | 'all_pairs' | 'paper';
}

export type Boundary = 'wall' | 'periodic' | 'open' | 'flat';

export interface Status {
  /** [T] */
  time: number;
  spheres: number;
  collisions: number;
  wallContacts: number;
  /** The hash of all contacts so far, in 16 hexadecimal digits: equal histories have equal hashes, in every language. */
  hash: string;
  /** What has ended the run; null while it goes on, and without a run. */
  reason: 'time' | 'contacts' | 'stopped' | null;
}

export interface Limits {
  /** [T] */
  until?: number;
  /** Collisions and wall contacts of this run. */
  contacts?: number;
  /** As long as the run goes on before other calls are answered [ms]: 8 by default. It does not change the history. */
  slice?: number;
  /** Stops the run after its present slice. */
  signal?: AbortSignal;
  /** Is called after each slice. */
  onProgress?(status: Status): void;
}

/** Contacts as columns; points, normals and impulses have three numbers for each. */
export interface Contacts {
  readonly length: number;
  /** [T] */
  readonly time: Float64Array;
  /** 1 for a collision, 2 for a wall contact. */
  readonly kind: Uint8Array;
  /** 0 for a bounce, 1 if the spheres pass through each other, 2 if they merge. */
  readonly outcome: Uint8Array;
  readonly first: Uint32Array;
  /** The id of the other sphere, or the number of the wall. */
  readonly second: Uint32Array;
  /** Where the surfaces touch [L]. */
  readonly point: Float64Array;
  /** The unit vector from the first body toward the second [1]. */
  readonly normal: Float64Array;
  /** The momentum that the first body gained [M L/T]. */
  readonly impulse: Float64Array;
  /** Along the normal [L/T]. */
  readonly impactSpeed: Float64Array;
}

export interface FutureContact {
  /** [T] */
  time: number;
  kind: 'collision' | 'wall';
  first: number;
  /** The id of the other sphere, or the number of the wall. */
  second: number;
}

export interface RayHit {
  kind: 'collision' | 'wall';
  /** The id of the sphere, or the number of the wall. */
  body: number;
  /** [L] */
  distance: number;
  /** [L] */
  point: [number, number, number];
  /** The unit vector out of the body [1]. */
  normal: [number, number, number];
}

export interface Totals {
  /** Kinetic, rotational and potential [M L² T⁻²]. */
  energy: number;
  /** [M L² T⁻²] */
  kineticEnergy: number;
  /** [M L² T⁻²] */
  rotationalEnergy: number;
  /** [M L/T] */
  momentum: number[];
  /** [M] */
  mass: number;
}

export interface Sphere {
  /** Its center [L]. */
  position: readonly [number, number, number];
  /** [L/T]; at rest by default. */
  velocity?: readonly [number, number, number];
  /** [L]; 0.5 by default. */
  radius?: number;
  /** [M]; 1 by default, Infinity for a kinematic sphere, which no collision deflects. */
  mass?: number;
  /** Its angular velocity [1/T]. */
  spin?: readonly [number, number, number];
  /** Its moment of inertia over mass and squared radius [1]; 0.4 by default. */
  inertiaFactor?: number;
  /** From 0 to 255. */
  species?: number;
}

/** A measured number. */
export interface Quantity {
  readonly name: string;
  /** A product of powers of L, T and M, as in "L^2 T^-1"; "1" for a pure number. */
  readonly unit: string;
  readonly value: number | null;
  /** The standard error; 0 if the value is exact, null if it is not known. */
  readonly error: number | null;
  /** What theory expects, or null. */
  readonly theory: number | null;
  /** How far off theory may be; null if it is given for comparison only. */
  readonly tolerance: number | null;
  /** Why there is no value or no error; empty if there are both. */
  readonly reason: string;
}

/** A column of a function that was measured. */
export interface Column {
  readonly name: string;
  readonly unit: string;
  /** 'error' and 'theory' belong to the value column before them. */
  readonly role: 'argument' | 'value' | 'error' | 'theory';
  readonly values: readonly (number | null)[];
}

/** What a measure has found. */
export interface Measurement {
  readonly name: string;
  readonly title: string;
  /** How the numbers are defined, in LaTeX between dollar signs. */
  readonly formula: string;
  readonly source: string;
  readonly quantities: readonly Quantity[];
  readonly columns: readonly Column[];
  /** For how long it was measured [T]. */
  readonly duration: number | null;
  /** The initial part of this that means leave out [T]. */
  readonly transient: number | null;
  /** Whether means have settled; without, they have no errors. */
  readonly transient_over: boolean;
  /** Why they have not. */
  readonly unsettled: string;
  readonly logarithmic_in_argument: boolean;
  readonly logarithmic_in_value: boolean;
}

/**
 * Spheres in motion.
 *
 * Rows are in the order of ids. Arrays that are given as `out` are filled and returned; with a worker they move there and
 * back, and the array that comes back is another one of the same memory.
 */
export interface Simulation {
  /** The end that the scenario gives [T], or null. */
  readonly until: number | null;
  readonly box: { readonly size: number[]; readonly boundary: Boundary[] };
  /** The version of the library. */
  readonly version: string;
  /** Runs until the first of the limits. Error: the time is in the past; the run cannot continue. */
  run(limits?: Limits): Promise<Status>;
  /** Ends a run after its present slice. */
  stop(): Promise<void>;
  status(): Promise<Status>;
  /** Three numbers for each sphere, folded into a periodic box [L]. */
  positions<Numbers extends Float32Array | Float64Array = Float64Array>(out?: Numbers): Promise<Numbers>;
  /** Three numbers for each sphere [L/T]. */
  velocities<Numbers extends Float32Array | Float64Array = Float64Array>(out?: Numbers): Promise<Numbers>;
  /** Three numbers for each sphere [1/T]. */
  spins<Numbers extends Float32Array | Float64Array = Float64Array>(out?: Numbers): Promise<Numbers>;
  /** [L] */
  radii<Numbers extends Float32Array | Float64Array = Float64Array>(out?: Numbers): Promise<Numbers>;
  /** [M] */
  masses<Numbers extends Float32Array | Float64Array = Float64Array>(out?: Numbers): Promise<Numbers>;
  species(out?: Uint32Array): Promise<Uint32Array>;
  ids(out?: Uint32Array): Promise<Uint32Array>;
  totals(): Promise<Totals>;
  /** Whether contacts of runs are kept, a million at most unless `most` says otherwise. */
  keepContacts(keep: boolean, most?: number): Promise<void>;
  /** Those kept since the last call, in order. */
  contacts(): Promise<Contacts>;
  /** The next contact of all, up to `until` [T], without executing it. */
  nextContact(until?: number): Promise<FutureContact | null>;
  /** Changes velocities [L/T]: three numbers for each id. */
  setVelocities(ids: ArrayLike<number>, velocities: ArrayLike<number>): Promise<void>;
  /** Adds a sphere, and returns its id. Error: it overlaps another. */
  add(sphere: Sphere): Promise<number>;
  remove(id: number): Promise<void>;
  /** What each ray hits first, up to `most` [L]: three numbers for each origin [L] and direction. */
  rays(origins: ArrayLike<number>, directions: ArrayLike<number>, most?: number): Promise<(RayHit | null)[]>;
  /** Whether runs measure from now on, and anew, what the scenario names in [measures]. They do not at first. */
  keepMeasures(keep: boolean): Promise<void>;
  /** What has been measured, also while a run goes on. Error: runs do not measure. */
  measures(): Promise<Measurement[]>;
  /** Records runs from now on, in memory. Spheres can then be neither added nor removed. */
  beginRecording(): Promise<void>;
  /** Ends the recording at the present time. */
  endRecording(): Promise<void>;
  /** The recording up to the last contact, or the whole of one that has ended: a file for `hardball view`. */
  recording(): Promise<Uint8Array>;
  /** Answers the page of the viewer, which asks for the recording through this port. The port moves to the worker. */
  serveRecording(port: MessagePort): Promise<void>;
  /** The whole state, from which load() continues to the same history, in any language. */
  save(): Promise<Uint8Array>;
  /** Ends the worker and frees the memory. */
  close(): void;
}

/** Starts what a scenario describes. Error (HardballError), with line and column as its place: it is none. */
export function open(text: string, options?: ScenarioOptions): Promise<Simulation>;
/** Continues a simulation that was saved, here or in another language. Error: the bytes are damaged. */
export function load(bytes: Uint8Array, options?: Options): Promise<Simulation>;
/** What a scenario is refused for, or null. */
export function check(text: string, options?: ScenarioOptions): Promise<HardballError | null>;
