import { after, before, test } from "node:test";

import type { Browser } from "puppeteer-core";

import { browserOf, madeLine, programOf } from "./cabin.js";
import { pressAtRandom } from "./random.js";

const SEED = Number(process.env["SEED"] ?? 1);
const SECONDS = Number(process.env["SECONDS_EACH"] ?? 60);
const skip = programOf("chrome") === undefined && "chromium is not installed";

let browser: Browser | undefined;
before(async () => {
  if (skip === false) browser = await browserOf("chrome");
});
after(async () => browser?.close());

for (const inMission of [false, true])
  test(`pressing at random ${inMission ? "in a mission" : "from power-up"} ends in no error of the console`, { skip }, async () => {
    console.log(await pressAtRandom(browser as Browser, [madeLine("level_1")], SEED, SECONDS, inMission));
  });
