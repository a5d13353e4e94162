// The WebAssembly module: kernel, simulator and display. Its exports are those of src/ride/module.cpp.

import type { Shape } from "./painter.js";

export type Direction = "neutral" | "forward" | "backward";
/// As DirectionController (port/inputs.h).
const DIRECTIONS: readonly Direction[] = ["neutral", "forward", "backward"];

export interface Desk {
  /// 1 full traction, 0 coasting, -1 full service brake.
  lever: number;
  direction: Direction;
  /// The key: the desk is open.
  key: boolean;
  emergency: boolean;
}

/// As DriverKind (sim/driver_kind.h).
export const DRIVERS = ["perfect", "late", "reckless"] as const;
export type Driver = (typeof DRIVERS)[number];

/// As SrsVersion (terms/srs_version.h): the editions of the on-board and of its display.
export const EDITIONS = ["3.4.0", "3.6.0", "4.0.0"] as const;
export type Edition = (typeof EDITIONS)[number];

/// How a journey begins. Without a driver it is driven by hand.
export interface Begin {
  driver?: Driver;
  seed?: number;
  /// 3.6.0 unless said.
  edition?: Edition;
  /// The on-board's clock at the begin, in seconds since 1970. Unless said 08:00 by hand, none with a driver.
  utc?: number;
}

/// One cycle for the strip, the fields of ride::Point in their order; NaN where there is no value.
export const POINT_FIELDS = [
  "t_s", "x_m", "v", "V_P", "V_W", "V_SBI", "V_EBI", "V_MRSP", "V_target", "V_release", "target_m", "EOA_m", "SvL_m",
  "least_m", "most_m", "brakes", "mode", "level", "status",
] as const;
export type PointField = (typeof POINT_FIELDS)[number];
export const POINT_SIZE = POINT_FIELDS.length;
export const AT = Object.fromEntries(POINT_FIELDS.map((name, place) => [name, place])) as Record<PointField, number>;

export interface RideEvent {
  t_s: number;
  x_m: number;
  text: string;
}

/// What does not change in a journey. Triples are begin, end, value.
export interface Scene {
  line: string;
  train: string;
  train_length_m: number;
  start_m: number;
  end_m: number;
  gradient: [number, number, number][];
  speeds: [number, number, number][];
  groups: number[];
}

export interface Summary {
  output_hash: string;
  modes: string[];
  cycles: number;
}

/// What the cycles of one call of `advance` gave.
export interface Driven {
  cycles: number;
  outputs: string;
  inputs: string;
  points: Float64Array;
  events: RideEvent[];
}

interface Exports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  take(size: number): number;
  free_taken(memory: number): void;
  begin(bytes: number, size: number, driver: number, seed: number, srs: number, utc: number): number;
  advance(page: number, cycles: number): number;
  finished(page: number): number;
  desk(page: number, lever: number, direction: number, open: number, emergency: number): void;
  remote_begin(): number;
  remote_show(page: number, bytes: number, size: number): number;
  remote_desk(page: number, direction: number, open: number): void;
  remote_acts(page: number, t_ms: number): void;
  touch(page: number, x: number, y: number): number;
  slide(page: number, x: number, y: number): void;
  lift(page: number): void;
  part(page: number, part: number): number;
  part_size(page: number): number;
}

/// As Part in module.cpp.
const PARTS = ["outputs", "inputs", "points", "events", "summary", "scene", "drawing", "screen", "acts"] as const;
type Part = (typeof PARTS)[number];

/// The C library of the module asks for these and never needs them: it opens no file and reads no clock. Each answers
/// that there is no such function (ENOSYS).
function noSystem(module: WebAssembly.Module): WebAssembly.Imports {
  const imports: Record<string, Record<string, () => number>> = {};
  for (const wanted of WebAssembly.Module.imports(module)) (imports[wanted.module] ??= {})[wanted.name] = () => 52;
  return imports;
}

async function exportsOf(code: BufferSource): Promise<Exports> {
  const module = await WebAssembly.compile(code);
  const instance = await WebAssembly.instantiate(module, noSystem(module));
  const exports = instance.exports as unknown as Exports;
  exports._initialize();
  return exports;
}

/// The driver's place in the module: the display, and texts in the memory of the module.
class Place {
  protected constructor(
    protected readonly exports: Exports,
    protected readonly page: number,
  ) {}

  /// A finger on the display, in its cells. Whether it touches something that is enabled.
  touch(x: number, y: number): boolean {
    return this.exports.touch(this.page, x, y) !== 0;
  }
  slide(x: number, y: number): void {
    this.exports.slide(this.page, x, y);
  }
  lift(): void {
    this.exports.lift(this.page);
  }
  /// The display list, evc-screen/1.
  screen(): unknown {
    return JSON.parse(this.text("screen"));
  }
  /// The display as shapes, in drawing order.
  drawing(): Shape[] {
    return JSON.parse(this.text("drawing")) as Shape[];
  }

  protected bytes(part: Part): Uint8Array {
    const place = PARTS.indexOf(part);
    const from = this.exports.part(this.page, place);
    const size = this.exports.part_size(this.page);
    return new Uint8Array(this.exports.memory.buffer, from, size).slice();
  }
  protected text(part: Part): string {
    return new TextDecoder().decode(this.bytes(part));
  }
}

/// The place at a unit that runs elsewhere (src/ride/remote.h).
export class Remote extends Place {
  static async begin(code: BufferSource): Promise<Remote> {
    const exports = await exportsOf(code);
    return new Remote(exports, exports.remote_begin());
  }

  /// Shows the record `dmi` of an output line; false: it is none.
  show(record: string): boolean {
    const bytes = new TextEncoder().encode(record);
    const taken = this.exports.take(bytes.length);
    new Uint8Array(this.exports.memory.buffer).set(bytes, taken);
    const shown = this.exports.remote_show(this.page, taken, bytes.length) !== 0;
    this.exports.free_taken(taken);
    return shown;
  }
  setDesk(desk: Desk): void {
    this.exports.remote_desk(this.page, DIRECTIONS.indexOf(desk.direction), desk.key ? 1 : 0);
  }
  /// The lines of what the driver did up to the cycle at a time; at first, without one, those that begin a session.
  acts(t_ms?: number): string {
    if (t_ms !== undefined) this.exports.remote_acts(this.page, t_ms);
    return this.text("acts");
  }
}

/// A journey in the module.
export class Ride extends Place {

  /// `given`: the bytes that `evc cab` wrote.
  static async begin(code: BufferSource, given: Uint8Array, begin: Begin = {}): Promise<Ride> {
    const { driver, seed = 1, edition = "3.6.0", utc = -1 } = begin;
    const exports = await exportsOf(code);
    const bytes = exports.take(given.length);
    new Uint8Array(exports.memory.buffer).set(given, bytes);
    const kind = driver === undefined ? -1 : DRIVERS.indexOf(driver);
    const page = exports.begin(bytes, given.length, kind, seed, EDITIONS.indexOf(edition), utc);
    if (page === 0) throw new Error("the page's line and train are of another version than its module");
    return new Ride(exports, page);
  }

  advance(cycles: number): Driven {
    const done = this.exports.advance(this.page, cycles);
    const points = this.bytes("points");
    const lines = this.text("events").split("\n");
    return {
      cycles: done,
      outputs: this.text("outputs"),
      inputs: this.text("inputs"),
      points: new Float64Array(points.buffer, 0, points.length / 8),
      events: lines.filter((line) => line !== "").map((line) => JSON.parse(line) as RideEvent),
    };
  }

  finished(): boolean {
    return this.exports.finished(this.page) !== 0;
  }

  setDesk(desk: Desk): void {
    const direction = DIRECTIONS.indexOf(desk.direction);
    this.exports.desk(this.page, desk.lever, direction, desk.key ? 1 : 0, desk.emergency ? 1 : 0);
  }

  summary(): Summary {
    return JSON.parse(this.text("summary")) as Summary;
  }
  scene(): Scene {
    return JSON.parse(this.text("scene")) as Scene;
  }

  /// The whole journey: on-board, world, display and desk. All of it is in the memory of the module.
  snapshot(): Uint8Array {
    return new Uint8Array(this.exports.memory.buffer).slice();
  }
  restore(snapshot: Uint8Array): void {
    const memory = new Uint8Array(this.exports.memory.buffer);
    memory.set(snapshot);
    memory.fill(0, snapshot.length);
  }
}

export function bytesOfBase64(text: string): Uint8Array<ArrayBuffer> {
  const characters = atob(text.trim());
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < characters.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

/// What was packed with gzip.
export async function unpacked(bytes: Uint8Array<ArrayBuffer>): Promise<ArrayBuffer> {
  const packed = new Blob([bytes]).stream();
  return new Response(packed.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}
