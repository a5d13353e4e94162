import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { Journey, lastValue } from "../src/journey.js";
import { DRIVERS, type Desk } from "../src/module.js";
import { evc, folder, rideOf } from "./page.js";

const FORWARD: Desk = { lever: 1, direction: "forward", key: true, emergency: false };

function summaryOf(words: string[]): { output_hash: string; modes: string[]; cycles: number } {
  const out = folder();
  evc("run", ...words, "-o", out);
  return JSON.parse(readFileSync(join(out, "summary.json"), "utf8")) as ReturnType<typeof summaryOf>;
}

for (const driver of DRIVERS)
  test(`the ${driver} driver in WebAssembly gives the bytes of evc run`, async () => {
    const ride = await rideOf([], { driver });
    while (ride.advance(100).cycles > 0);
    const { output_hash, modes, cycles } = summaryOf(["--driver", driver]);
    assert.deepEqual(ride.summary(), { output_hash, modes, cycles });
  });

test("with an edition and a clock it gives the bytes of evc run", async () => {
  const ride = await rideOf([], { driver: "perfect", edition: "4.0.0", utc: Date.UTC(2026, 0, 1, 8) / 1000 });
  while (ride.advance(100).cycles > 0);
  const { output_hash, modes, cycles } = summaryOf(["--srs", "4.0.0", "--utc", "2026-01-01T08:00:00Z"]);
  assert.deepEqual(ride.summary(), { output_hash, modes, cycles });
  assert.notEqual(output_hash, summaryOf([]).output_hash);
});

test("with a train of a file it gives the bytes of evc run", async () => {
  const train = ["--train", "data/trains/freight_P.json"];
  const ride = await rideOf(train, { driver: "perfect" });
  while (ride.advance(100).cycles > 0);
  assert.equal(ride.summary().output_hash, summaryOf(train).output_hash);
});

test("the journal of a journey by hand replays outside to the same bytes", async () => {
  const journey = new Journey(await rideOf([]));
  let outputs = "";
  const drive = (cycles: number): void => {
    for (let n = 0; n < cycles; ++n) {
      journey.advance(1);
      outputs += `${journey.output}\n`;
    }
  };
  drive(10);
  journey.setDesk(FORWARD);
  drive(200);
  journey.setDesk({ ...FORWARD, lever: -0.5, direction: "backward" });
  drive(50);
  journey.setDesk({ ...FORWARD, key: false });
  drive(20);
  const file = join(folder(), "inputs.jsonl");
  writeFileSync(file, journey.inputs);
  assert.equal(evc("replay", file), outputs);
});

test("gone back and driven on in the same way, a journey is the same", async () => {
  const script = (journey: Journey): void => {
    journey.setDesk(FORWARD);
    journey.advance(900);
    journey.setDesk({ ...FORWARD, lever: -1 });
    journey.advance(700);
  };
  const straight = new Journey(await rideOf([]));
  straight.advance(100);
  script(straight);
  const back = new Journey(await rideOf([]));
  back.advance(100);
  back.setDesk({ ...FORWARD, direction: "backward" });
  back.advance(1300);
  const branchAt = back.cycles;
  back.goBack(100);
  assert.equal(back.cycles, 100);
  assert.ok(branchAt > 1000);
  script(back);
  assert.equal(back.inputs, straight.inputs);
  assert.equal(back.output, straight.output);
  assert.deepEqual(back.ride.summary(), straight.ride.summary());
  assert.equal(back.branches.length, 1);
  assert.notEqual(back.branches[0]?.colour, back.colour);
});

test("going back keeps what was done between the snapshot and the moment", async () => {
  const journey = new Journey(await rideOf([]));
  journey.advance(650);
  journey.setDesk(FORWARD);
  journey.advance(100);
  const { inputs, output } = journey;
  const at = lastValue(journey.points, "x_m");
  journey.advance(500);
  journey.goBack(750);
  assert.equal(journey.inputs, inputs);
  assert.equal(journey.output, output);
  assert.equal(lastValue(journey.points, "x_m"), at);
  assert.deepEqual(journey.desk, FORWARD);
});

test("a brake command has its cause", async () => {
  const journey = new Journey(await rideOf([]));
  journey.setDesk(FORWARD);
  journey.advance(300);
  // 3.14.4: at standstill in SB the train may not roll.
  const command = journey.brakeCommands[0];
  assert.ok(command !== undefined);
  assert.ok(command.reasons.length > 0);
  const line = JSON.parse(journey.output) as { brake_reasons: string[] };
  assert.ok(Array.isArray(line.brake_reasons));
});

/// The place of the display with this name, touched as long as its type needs.
function tap(journey: Journey, name: string): void {
  interface Touch {
    name: string;
    abs: [number, number, number, number];
    type: string;
    enabled: boolean;
  }
  const { window, touch } = journey.ride.screen() as { window: string; touch: Touch[] };
  const place = touch.find((candidate) => candidate.name === name);
  assert.ok(place?.enabled, `${window} has no ${name}`);
  const [x, y, w, h] = place.abs;
  assert.ok(journey.touch(Math.floor(x + w / 2), Math.floor(y + h / 2)));
  journey.advance(place.type === "delay" ? 21 : 1);
  journey.lift();
  journey.advance(5);
}
/// How far the start of mission is.
function dialogue(journey: Journey): string {
  const line = JSON.parse(journey.output) as { dialogue: { step: string; waits_for: string }; level: string };
  return `${line.dialogue.step} ${line.dialogue.waits_for} ${line.level}`;
}

test("the start of mission goes on by touches of the display (5.4.3.2)", async () => {
  const journey = new Journey(await rideOf([]));
  journey.setDesk({ ...FORWARD, lever: -1 });
  journey.advance(20);
  assert.equal((journey.ride.screen() as { window: string }).window, "Driver ID");
  tap(journey, "key 4");
  tap(journey, "field 1");
  assert.equal(dialogue(journey), "S2 level 0");
  tap(journey, "key 1");
  tap(journey, "field 1");
  assert.equal(dialogue(journey), "S10 train_data 1");
  const before = journey.inputs;
  tap(journey, "Train data");
  assert.equal((journey.ride.screen() as { window: string }).window, "Train data");
  assert.ok(journey.inputs.slice(before.length).includes('"window":{"opened":"train_data"}'));
  // Back before the level was entered: the display is there too.
  journey.goBack(30);
  assert.equal(dialogue(journey), "S2 level 0");
  assert.equal((journey.ride.screen() as { window: string }).window, "Level");
  const file = join(folder(), "inputs.jsonl");
  writeFileSync(file, journey.inputs);
  assert.equal(evc("replay", file).trimEnd().split("\n").at(-1), journey.output);
});

test("a touch of nothing is not taken", async () => {
  const journey = new Journey(await rideOf([]));
  journey.setDesk({ ...FORWARD, lever: -1 });
  journey.advance(20);
  assert.equal(journey.touch(2, 2), false);
  assert.equal(journey.touch(-5, 9999), false);
});
