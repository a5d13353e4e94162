// What the page costs: its size, how fast it drives by itself, and the main thread for each frame. The times real time are by
// the clock and are judged: that needs a machine that does nothing else. The cost of a frame is printed only.

import assert from "node:assert/strict";
import { existsSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";

import type { Browser } from "puppeteer-core";

import { browserOf, Cabin, programOf } from "./cabin.js";
import { costsOfFrames, quantile } from "./trace.js";
import { evc, folder } from "./page.js";

const SHARED = process.env["OPENEVC_SHARED"] ?? "../shared";
const RECORDED = join(SHARED, "lines", "amsterdam_utrecht.json");
const noBrowser = programOf("chrome") === undefined && "chromium is not installed";
const noLine = !existsSync(RECORDED) && `${RECORDED} is not there (OPENEVC_SHARED)`;

let browser: Browser | undefined;
before(async () => {
  if (noBrowser === false) browser = await browserOf("chrome");
});
after(async () => browser?.close());

interface Summary {
  output_hash: string;
  modes: string[];
  cycles: number;
}
function summaryOf(words: string[]): Summary {
  const out = folder();
  evc("run", ...words, "-o", out);
  const { output_hash, modes, cycles } = JSON.parse(readFileSync(join(out, "summary.json"), "utf8")) as Summary;
  return { output_hash, modes, cycles };
}

test("by itself it gives the hash of evc run, at least 1000 times as fast as real time", { skip: noBrowser || noLine }, async () => {
  const page = join(folder(), "cab.html");
  evc("cab", RECORDED, "-o", page);
  const { size } = statSync(page);
  console.log(`page: ${size} bytes`);
  assert.ok(size <= 3_000_000, `${size} bytes`);
  const expected = summaryOf([RECORDED]);
  const times = (ms: number): number => Math.round((expected.cycles * 0.1 * 1000) / ms);
  // The best of three: the machine may do something else meanwhile.
  let best = Infinity;
  for (let n = 0; n < 3; ++n) {
    const cab = await Cabin.begin(browser as Browser, [RECORDED], "?auto=perfect&speed=max");
    await cab.page.waitForFunction(() => document.body.dataset["evcDone"] !== undefined, { polling: 20, timeout: 300_000 });
    const driven = await cab.page.evaluate(() => {
      const [measure] = performance.getEntriesByName("journey", "measure");
      return { ms: measure?.duration ?? 0, since_opened_ms: (measure?.startTime ?? 0) + (measure?.duration ?? 0) };
    });
    assert.deepEqual(JSON.parse(await cab.page.evaluate(() => document.body.dataset["evcDone"] ?? "")), expected);
    console.log(`${expected.cycles} cycles in ${Math.round(driven.ms)} ms: ${times(driven.ms)} times real time; ` +
      `with opening the page ${times(driven.since_opened_ms)}`);
    best = Math.min(best, driven.ms);
    await cab.close();
  }
  assert.ok(times(best) >= 1000, `${times(best)} times real time`);
});

const SECONDS = 10;
test("a frame of the main thread", { skip: noBrowser }, async () => {
  // At ten times real time each frame has a cycle and is drawn.
  const cab = await Cabin.begin(browser as Browser, [], "?auto=perfect&speed=10");
  await cab.advance(600);
  const file = join(folder(), "trace.json");
  await cab.page.tracing.start({ path: file, categories: ["-*", "devtools.timeline", "disabled-by-default-devtools.timeline"] });
  await new Promise((resolve) => setTimeout(resolve, SECONDS * 1000));
  await cab.page.tracing.stop();
  const costs = costsOfFrames(readFileSync(file, "utf8"));
  const text = (share: number): string => `${quantile(costs, share).toFixed(2)} ms`;
  console.log(`${costs.length} frames in ${SECONDS} s, main thread: median ${text(0.5)}, 90 % ${text(0.9)}, most ${text(1)}`);
  assert.ok(costs.length > 5 * SECONDS, `${costs.length} frames`);
  await cab.close();
});
