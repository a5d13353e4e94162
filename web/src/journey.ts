// A journey in time: driven on, gone back in, driven on from there. What was driven after the moment gone back to stays
// as a branch, to be looked at.

import { AT, POINT_SIZE, type Desk, type Driven, type PointField, type Ride, type RideEvent } from "./module.js";

export const CYCLE_S = 0.1;
/// Cycles between two snapshots: a minute of the journey. A snapshot has the size of the module's memory.
const BETWEEN_SNAPSHOTS = 600;
/// Cycles of one call of the module: its memory has to hold what they give.
const CYCLES_OF_CALL = 100;
/// Of the branches: they can be seen on a light ground and on a dark one.
const COLOURS = ["#2d82dc", "#cf7a10", "#2e9a4f", "#a463e0", "#e0524f", "#1a97a0"] as const;

/// What the driver did before a cycle.
type Act =
  | { what: "desk"; desk: Desk }
  | { what: "touch" | "slide"; x: number; y: number }
  | { what: "lift" };
interface DatedAct {
  cycle: number;
  act: Act;
}

/// A command of the brakes that began, and why.
export interface BrakeCommand {
  cycle: number;
  t_s: number;
  brakes: number;
  reasons: string[];
  events: string[];
}

/// Where the record stood at a snapshot.
interface Snapshot {
  cycle: number;
  memory: Uint8Array;
  inputs: number;
  points: number;
  events: number;
  brakes: number;
  acts: number;
  last: string;
}

/// The way of a branch, for its drawing.
export interface Branch {
  colour: string;
  /// The first cycle that belongs to it alone.
  from: number;
  points: readonly Float64Array[];
}

const DESK_AT_START: Desk = { lever: -1, direction: "neutral", key: false, emergency: false };

export class Journey {
  private inputsOf: string[] = [];
  private pointsOf: Float64Array[] = [];
  private eventsOf: RideEvent[] = [];
  private brakesOf: BrakeCommand[] = [];
  private acts: DatedAct[] = [];
  private snapshots: Snapshot[] = [];
  private left: Branch[] = [];
  private lastOutput = "";
  private cycle = 0;
  private begunAt = 0;
  private branchNumber = 0;
  private deskNow: Desk = DESK_AT_START;

  constructor(readonly ride: Ride) {
    this.remember();
  }

  get cycles(): number {
    return this.cycle;
  }
  get seconds(): number {
    return this.cycle * CYCLE_S;
  }
  get desk(): Desk {
    return this.deskNow;
  }
  get events(): readonly RideEvent[] {
    return this.eventsOf;
  }
  get brakeCommands(): readonly BrakeCommand[] {
    return this.brakesOf;
  }
  get points(): readonly Float64Array[] {
    return this.pointsOf;
  }
  /// Branches that were left, the oldest first.
  get branches(): readonly Branch[] {
    return this.left;
  }
  get colour(): string {
    return COLOURS[this.branchNumber % COLOURS.length] ?? COLOURS[0];
  }
  /// The last output line as it was written; empty before the first cycle.
  get output(): string {
    return this.lastOutput;
  }
  /// The journal, inputs.jsonl, up to now.
  get inputs(): string {
    return this.inputsOf.join("");
  }

  setDesk(desk: Desk): void {
    this.do({ what: "desk", desk });
  }
  touch(x: number, y: number): boolean {
    return this.do({ what: "touch", x, y });
  }
  slide(x: number, y: number): void {
    this.do({ what: "slide", x, y });
  }
  lift(): void {
    this.do({ what: "lift" });
  }

  /// Drives so many cycles, fewer at the end of the journey: how many.
  advance(cycles: number): number {
    let done = 0;
    while (done < cycles) {
      // A snapshot is between two calls.
      const most = BETWEEN_SNAPSHOTS - (this.cycle % BETWEEN_SNAPSHOTS);
      const driven = this.ride.advance(Math.min(cycles - done, most, CYCLES_OF_CALL));
      if (driven.cycles === 0) break;
      this.add(driven);
      done += driven.cycles;
      if (this.cycle % BETWEEN_SNAPSHOTS === 0) this.remember();
    }
    return done;
  }

  /// Back to the moment after `cycle` cycles. What comes behind it is left as a branch.
  goBack(cycle: number): void {
    if (cycle < 0 || cycle >= this.cycle) return;
    this.left.push({ colour: this.colour, from: cycle, points: this.pointsOf.slice() });
    const earlier = this.acts.filter((dated) => dated.cycle < cycle);
    let snapshot = this.snapshots[0];
    for (const candidate of this.snapshots) if (candidate.cycle <= cycle) snapshot = candidate;
    if (snapshot === undefined) throw new Error("a journey without a snapshot");
    this.restore(snapshot);
    // From the snapshot on as it was driven.
    for (const dated of earlier.slice(snapshot.acts)) {
      this.advance(dated.cycle - this.cycle);
      this.do(dated.act);
    }
    this.advance(cycle - this.cycle);
    this.begunAt = cycle;
    ++this.branchNumber;
  }

  /// A value of each cycle from which the branch is its own.
  get begins(): number {
    return this.begunAt;
  }

  private do(act: Act): boolean {
    this.acts.push({ cycle: this.cycle, act });
    switch (act.what) {
      case "desk":
        this.deskNow = act.desk;
        this.ride.setDesk(act.desk);
        return true;
      case "touch":
        return this.ride.touch(act.x, act.y);
      case "slide":
        this.ride.slide(act.x, act.y);
        return true;
      case "lift":
        this.ride.lift();
        return true;
    }
  }

  private add(driven: Driven): void {
    this.noteBrakes(driven);
    this.inputsOf.push(driven.inputs);
    this.pointsOf.push(driven.points);
    this.eventsOf.push(...driven.events);
    this.cycle += driven.cycles;
    const end = driven.outputs.lastIndexOf("\n", driven.outputs.length - 2);
    this.lastOutput = driven.outputs.slice(end + 1, -1);
  }

  /// The commands that began in these cycles, with the reasons of their output line.
  private noteBrakes(driven: Driven): void {
    let before = lastValue(this.pointsOf, "brakes") ?? 0;
    let lines: string[] | undefined;
    for (let n = 0; n < driven.cycles; ++n) {
      const now = driven.points[n * POINT_SIZE + AT.brakes] ?? 0;
      if ((now & ~before) !== 0) {
        lines ??= driven.outputs.split("\n");
        const line = JSON.parse(lines[n] ?? "{}") as { brake_reasons?: string[]; events?: string[] };
        this.brakesOf.push({
          cycle: this.cycle + n,
          t_s: driven.points[n * POINT_SIZE + AT.t_s] ?? 0,
          brakes: now,
          reasons: line.brake_reasons ?? [],
          events: line.events ?? [],
        });
      }
      before = now;
    }
  }

  private remember(): void {
    this.snapshots.push({
      cycle: this.cycle,
      memory: this.ride.snapshot(),
      inputs: this.inputsOf.length,
      points: this.pointsOf.length,
      events: this.eventsOf.length,
      brakes: this.brakesOf.length,
      acts: this.acts.length,
      last: this.lastOutput,
    });
  }

  private restore(snapshot: Snapshot): void {
    this.ride.restore(snapshot.memory);
    this.cycle = snapshot.cycle;
    this.inputsOf.length = snapshot.inputs;
    this.pointsOf.length = snapshot.points;
    this.eventsOf.length = snapshot.events;
    this.brakesOf.length = snapshot.brakes;
    this.acts.length = snapshot.acts;
    this.lastOutput = snapshot.last;
    this.snapshots = this.snapshots.filter((s) => s.cycle <= snapshot.cycle);
    this.deskNow = DESK_AT_START;
    for (const { act } of this.acts) if (act.what === "desk") this.deskNow = act.desk;
  }
}

/// The last value of a field; undefined before the first cycle.
export function lastValue(points: readonly Float64Array[], field: PointField): number | undefined {
  const chunk = points[points.length - 1];
  return chunk?.[chunk.length - POINT_SIZE + AT[field]];
}
