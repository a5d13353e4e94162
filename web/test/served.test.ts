// The page that `evc serve` gives at /, in Chromium: connected with a unit of the server, touched, and driven by lines of an
// odometer from elsewhere.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { test } from "node:test";

import type { Page } from "puppeteer-core";

import { browserOf } from "./cabin.js";
import { EVC } from "./page.js";

/// What of `window.evc` is used here; it runs in the page.
interface Evc {
  state(): { mode: string; level: string; v_kmh: number; eb: boolean } | null;
  screen(): { window: string; touch: Touch[] };
  press(x: number, y: number): boolean;
  desk(part: object): void;
  advance(seconds: number): Promise<void>;
  give(lines: string): void;
  inputs(): string;
}
interface Touch {
  name: string;
  abs: [number, number, number, number];
  action: string;
  enabled: boolean;
}
declare const window: { evc: Evc };

/// A server with a free port; its address.
async function serve(...words: string[]): Promise<{ address: string; said: () => string; end: () => Promise<void> }> {
  const process = spawn(EVC, ["serve", "--port", "0", ...words], { stdio: ["ignore", "pipe", "inherit"] });
  const ended = new Promise<void>((done) => process.once("exit", () => done()));
  let said = "";
  const address = await new Promise<string>((done) =>
    process.stdout.on("data", (text: Buffer) => {
      said += text.toString();
      if (said.includes("\n")) done(said.slice(0, said.indexOf("\n")));
    }),
  );
  const end = (): Promise<void> => (process.kill("SIGTERM"), ended);
  return { address, said: () => said, end };
}

/// Touches what has this action or name; the window that is open then.
async function press(page: Page, what: string): Promise<string> {
  return page.evaluate(async (wanted) => {
    const { touch } = window.evc.screen();
    const found = touch.find((one) => one.enabled && (one.action === wanted || one.name === wanted));
    if (found === undefined) throw new Error(`nothing enabled is ${wanted}: ${JSON.stringify(touch)}`);
    const [x, y, w, h] = found.abs;
    if (!window.evc.press(Math.floor(x + w / 2), Math.floor(y + h / 2))) throw new Error(`${wanted} was not hit`);
    await window.evc.advance(0.5);
    return window.evc.screen().window;
  }, what);
}

async function withPage(address: string, act: (page: Page, errors: string[]) => Promise<void>): Promise<void> {
  const browser = await browserOf("chrome");
  try {
    const page = await browser.newPage();
    const errors: string[] = [];
    page.on("pageerror", (error) => errors.push(String(error)));
    page.on("console", (message) => {
      if (message.type() === "error" && !message.text().includes("favicon") && !message.location().url?.endsWith("/favicon.ico"))
        errors.push(message.text());
    });
    await page.goto(address);
    await page.waitForFunction(() => "evc" in window && window.evc.state() !== null);
    await act(page, errors);
    assert.deepEqual(errors, []);
  } finally {
    await browser.close();
  }
}

const mode = (page: Page): Promise<string | undefined> => page.evaluate(() => window.evc.state()?.mode);

test("the page of the server is the display and the desk of its unit", { timeout: 120_000 }, async () => {
  const server = await serve();
  try {
    await withPage(server.address, async (page) => {
      assert.equal(await mode(page), "SB");
      await page.click("#key");
      await page.click('[data-direction="forward"]');
      await page.evaluate(() => window.evc.advance(0.5));
      const driverId = await page.evaluate(() => window.evc.screen().window);
      assert.equal(driverId, "Driver ID");
      await press(page, "key 4");
      await press(page, "key 7");
      const after = await press(page, "field 1");
      assert.notEqual(after, "Driver ID");
      const inputs = await page.evaluate(() => window.evc.inputs());
      assert.match(inputs, /"desk_open":true/);
      assert.match(inputs, /"direction_controller":"forward"/);
      assert.match(inputs, /"driver":\{"enter":\{"driver_id":"47"\}\}/);
      // The train moves as lines from elsewhere say: in stand-by the unit brakes.
      await page.type(
        "#lines",
        '{"odometer":{"nominal_m":5,"min_m":4,"max_m":6,"speed_mps":2,"speed_min_mps":1.9,"speed_max_mps":2.1,"accel_mps2":0}}',
      );
      await page.click("#give");
      await page.waitForFunction(() => document.querySelector<HTMLElement>("#lamp")?.dataset["on"] === "true");
      assert.match(await page.$eval("#lamp", (lamp) => lamp.textContent ?? ""), /brake/);
      assert.ok(await page.$eval("#strip", (strip) => getComputedStyle(strip).display === "none"));
    });
  } finally {
    await server.end();
  }
});

test("in real time too, and the server tells the times of the session", { timeout: 120_000 }, async () => {
  const server = await serve("--real-time");
  try {
    await withPage(server.address, async (page) => {
      await page.click("#key");
      await page.waitForFunction(() => window.evc.screen().window === "Driver ID");
    });
  } finally {
    await server.end();
  }
  assert.match(server.said(), /\nsession ended: \d+ cycles, \d+ missed; begin after due median [\d.]+, /);
});
