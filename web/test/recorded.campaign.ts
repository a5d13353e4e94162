// The whole passage of the recorded line by presses.

import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";

import type { Browser } from "puppeteer-core";

import { browserOf, Cabin, programOf, type Line } from "./cabin.js";

const SHARED = process.env["OPENEVC_SHARED"] ?? "../shared";
const LINE = join(SHARED, "lines", "amsterdam_utrecht.json");
const skip = !existsSync(LINE)
  ? `${LINE} is not there (OPENEVC_SHARED)`
  : programOf("chrome") === undefined && "chromium is not installed";

let browser: Browser | undefined;
before(async () => {
  if (skip === false) browser = await browserOf("chrome");
});
after(async () => browser?.close());

test("the whole passage by presses: start of mission in level NTC, level 2, and back", { skip }, async () => {
  const cab = await Cabin.open(browser as Browser, [LINE]);
  await cab.openDesk();
  await cab.enter("Driver ID", "1234");
  await cab.enter("Level", "NTC 1");
  await cab.enterTrainData();
  await cab.press("Start");
  await cab.acknowledge("SN");
  await cab.wait({ mode: "SN" }, 5);
  // To the border, where level 2 is acknowledged (5.10.4); 40 km/h is the speed of the line there.
  await cab.drive({ asks: "level" }, 40);
  await cab.acknowledge("level");
  await cab.drive({ mode: "FS", level: "2" }, 40);
  await cab.drive({ asks: "level" }, 160, 3000);
  await cab.acknowledge("level");
  await cab.drive({ mode: "SN", level: "NTC" }, 140);
  await cab.drive({ run_m: 34_000 }, 140);
  await cab.stop();
  await cab.expect({ mode: "SN", level: "NTC", eb: false });
  // No intervention, and what was done replays outside to the same.
  const outputs = await cab.replayed();
  const lines = outputs.map((line) => JSON.parse(line) as Line);
  assert.deepEqual(lines.filter((line) => line.sb || line.eb).length, 0);
  const modes = lines.map((line) => line.mode).filter((mode, n, all) => mode !== all[n - 1]);
  assert.deepEqual(modes, ["SB", "SN", "FS", "SN"]);
  await cab.close();
});
