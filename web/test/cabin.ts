// A driver in front of the page in a browser: what he sees is the display list, what he does are presses of the places that
// it shows. So a test reads as a script of what happens in the cab.

import assert from "node:assert/strict";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import { launch, type Browser, type Page } from "puppeteer-core";

import type { Evc } from "../src/cab.js";
import { evc, folder } from "./page.js";

export type BrowserName = "chrome" | "firefox";
const PROGRAMS: Record<BrowserName, string[]> = {
  chrome: [process.env["CHROMIUM"] ?? "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"],
  firefox: [process.env["FIREFOX"] ?? "/usr/bin/firefox-esr", "/usr/bin/firefox"],
};

/// Where the browser is; undefined: it is not installed.
export function programOf(browser: BrowserName): string | undefined {
  return PROGRAMS[browser].find((path) => existsSync(path));
}

export async function browserOf(browser: BrowserName): Promise<Browser> {
  const executablePath = programOf(browser);
  assert.ok(executablePath !== undefined, `${browser} is not installed; tools/setup cab report`);
  const args =
    browser === "chrome"
      ? ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-sync"]
      : [];
  return launch({ browser, executablePath, headless: true, args, userDataDir: folder(), protocolTimeout: 600_000 });
}

/// A line that `evc make-line` makes of tests/data/cab/NAME.description.json, with `more` keys of a line (docs/line.md).
export function madeLine(name: string, more: Record<string, unknown> = {}): string {
  const file = join(folder(), `${name}.json`);
  evc("make-line", `tests/data/cab/${name}.description.json`, "-o", file);
  writeFileSync(file, JSON.stringify({ ...JSON.parse(readFileSync(file, "utf8")), ...more }));
  return file;
}

/// How a place of the display is pressed: by `window.evc`, or by real events on the canvas.
export type By = "evc" | "mouse" | "touch";

interface Place {
  name: string;
  abs: [number, number, number, number];
  action: string;
  enabled: boolean;
  type: string;
}
interface Labelled {
  n: number;
  label: string;
  value?: string;
  state?: string;
}
/// What a driver sees.
export interface Seen {
  window: string;
  places: Place[];
  keys: Labelled[];
  fields: Labelled[];
  echoes: Labelled[];
  symbols: { area: string; id: string }[];
  texts: string[];
}
/// The members of an output line that the tests look at (docs/replay.md).
export interface Line {
  mode: string;
  level: string;
  lrbg: { NID_C: number; NID_BG: number } | null;
  est_front_m: number;
  v_kmh: number;
  V_P: number | null;
  V_MRSP: number | null;
  eb: boolean;
  sb: boolean;
  brake_reasons: string[];
  driver: { requests: string[]; texts: string[]; symbols: string[] };
  data: Record<string, { value: unknown; status: string }>;
  trip_reason: string | null;
  enabled: string[];
}

/// What a driver waits for: all that is given.
export interface Until {
  mode?: string;
  level?: string;
  /// The name of an acknowledgement that the display offers.
  asks?: string;
  /// The front end has run so far from where it was at power-up, by the estimate of the on-board.
  run_m?: number;
  stands?: boolean;
  window?: string;
  /// A place of the display, by its name or what it does, that is enabled.
  offers?: string;
}

/// The train data that a driver enters in these tests, by the labels of the window.
export const TRAIN = {
  "Train category": "PASS 3",
  "Length (m)": "180",
  "Brake percentage": "135",
  "Maximum speed (km/h)": "140",
  "Axle load category": "C2",
  Airtight: "No",
  "Loading gauge": "G1",
} as const;

const VIEW = { width: 1400, height: 1000 };

export class Cabin {
  private constructor(
    readonly page: Page,
    private readonly by: By,
    /// What the console said that it should not: errors and warnings, and exceptions of the page.
    readonly complaints: string[],
  ) {}

  /// The page that `evc cab` writes with these words, opened from a file. Time stands; it passes by what the test does.
  static async open(browser: Browser, words: string[], by: By = "evc"): Promise<Cabin> {
    const cabin = await Cabin.begin(browser, words, "", by);
    await cabin.page.keyboard.press("p");
    return cabin;
  }

  /// The same with a query, and time passes.
  static async begin(browser: Browser, words: string[], query: string, by: By = "evc"): Promise<Cabin> {
    const file = join(folder(), "cab.html");
    evc("cab", ...words, "-o", file);
    const page = await browser.newPage();
    await page.setViewport({ ...VIEW, hasTouch: by === "touch" });
    const complaints: string[] = [];
    page.on("console", (message) => {
      if (["error", "warn", "assert"].includes(message.type())) complaints.push(message.text());
    });
    page.on("pageerror", (error) => complaints.push(String(error)));
    page.on("dialog", (dialog) => complaints.push(`dialog: ${dialog.message()}`));
    await page.goto(`${pathToFileURL(file).href}${query}`);
    await page.waitForFunction(() => window.evc !== undefined, { timeout: 60_000 });
    return new Cabin(page, by, complaints);
  }

  async close(): Promise<void> {
    await this.page.close();
    assert.deepEqual(this.complaints, []);
  }

  /// The last output line of the on-board.
  async line(): Promise<Line> {
    return this.page.evaluate(() => (window.evc as Evc).state() as Line);
  }
  async advance(seconds: number): Promise<void> {
    await this.page.evaluate((s) => (window.evc as Evc).advance(s), seconds);
  }

  async see(): Promise<Seen> {
    return this.page.evaluate(() => {
      interface Item {
        kind: string;
        n?: number;
        id?: string;
        area?: string;
        label?: string;
        value?: string;
        state?: string;
        enabled?: boolean;
      }
      const list = (window.evc as Evc).screen() as { window: string; items: Item[]; touch: Place[] };
      const labelled = (kind: string): Labelled[] =>
        list.items
          .filter((item) => item.kind === kind && item.label !== undefined)
          .map((item) => ({ n: item.n ?? 0, label: item.label ?? "", value: item.value ?? "", state: item.state ?? "" }));
      return {
        window: list.window,
        places: list.touch,
        keys: labelled("key"),
        fields: list.items
          .filter((item) => item.kind === "field")
          .map((item) => ({ n: item.n ?? 0, label: item.label ?? "", value: item.value ?? "", state: item.state ?? "" })),
        echoes: labelled("echo"),
        symbols: list.items
          .filter((item) => item.kind === "symbol")
          .map((item) => ({ area: item.area ?? "", id: item.id ?? "" })),
        texts: list.items.filter((item) => item.kind === "text").map((item) => item.value ?? ""),
      };
    });
  }

  /// The values of a window of data view.
  async viewed(): Promise<string[]> {
    return this.page.evaluate(() => {
      const list = (window.evc as Evc).screen() as { items: { kind: string; value?: string }[] };
      return list.items.filter((item) => item.kind === "view_item").map((item) => item.value ?? "");
    });
  }

  /// Key and direction controller, by the keyboard of the page.
  async openDesk(): Promise<void> {
    await this.page.keyboard.press("k");
    await this.page.keyboard.press("f");
    await this.advance(2);
  }
  /// The key out of the lock and in again.
  async closeDesk(): Promise<void> {
    await this.page.keyboard.press("k");
    await this.advance(2);
  }

  /// Presses a place by its name or by what it does, as long as it needs to act. While the on-board works (hour glass) it
  /// is disabled: then the driver waits.
  async press(label: string): Promise<void> {
    await this.wait({ offers: label }, 30);
    const seen = await this.see();
    const actions = [label, label.toLowerCase()]; // menus are small
    const place = seen.places.find((candidate) => candidate.name === label || actions.includes(candidate.action));
    assert.ok(place?.enabled, `${label}: ${await this.situation(seen)}`);
    await this.touch(place);
  }

  /// A window by its button on the default window.
  async openMenu(window: string): Promise<void> {
    if ((await this.see()).window !== window) await this.press(window);
    assert.equal((await this.see()).window, window);
  }

  /// Acknowledges what the display offers, waiting for it as long as it may be late (a second after the one before).
  async acknowledge(what: string): Promise<void> {
    await this.wait({ asks: what }, 5);
    await this.press(`ack ${what}`);
  }

  /// Enters values in a window of data entry: one, or those of its fields by their labels.
  async enter(window: string, values: string | Record<string, string>): Promise<void> {
    await this.wait({ window }, 10);
    if (typeof values === "string") return this.enterField(values);
    for (const [label, value] of Object.entries(values)) {
      const seen = await this.see();
      const field = seen.fields.find((candidate) => candidate.label === label);
      assert.ok(field !== undefined, `${label}: ${await this.situation(seen)}`);
      if (field.state !== "selected") await this.press(`field ${this.placeOf(seen, field)}`);
      await this.enterField(value);
    }
    await this.press("Yes");
  }

  /// Start of mission in level 1 (5.4.3) up to the Main window where Start may be pressed, and on into SR.
  async prepareLevel1(): Promise<void> {
    await this.openDesk();
    await this.enter("Driver ID", "1234");
    await this.enter("Level", "Level 1");
    await this.enterTrainData();
  }
  async startInLevel1(): Promise<void> {
    await this.prepareLevel1();
    await this.startInSR();
  }
  /// Start, and the acknowledgement of SR.
  async startInSR(): Promise<void> {
    await this.press("Start");
    await this.acknowledge("SR");
    await this.wait({ mode: "SR" }, 10);
  }

  /// From the Main window through train data, their validation and the train running number, and back (015560 11.7.2).
  async enterTrainData(): Promise<void> {
    await this.press("Train data");
    await this.enter("Train data", TRAIN);
    await this.enter("Validate train data", "Yes");
    await this.enter("Train running number", "4711");
    await this.wait({ window: "Main" }, 10);
  }

  /// The journal replayed outside (`evc replay`): the output lines, of which the last one is that of the page.
  async replayed(): Promise<string[]> {
    const file = join(folder(), "inputs.jsonl");
    // Of one moment: time may pass.
    const [inputs, last] = await this.page.evaluate(() => {
      const cab = window.evc as Evc;
      return [cab.inputs(), cab.state()] as const;
    });
    writeFileSync(file, inputs);
    const lines = evc("replay", file).trimEnd().split("\n");
    assert.deepEqual(JSON.parse(lines.at(-1) ?? ""), last);
    return lines;
  }

  /// Lets time pass, the train braked as it is, until it is so.
  async wait(until: Until, seconds: number): Promise<Line> {
    return this.until(until, seconds, undefined);
  }
  /// Drives at the permitted speed, at most `kmh`, until it is so.
  async drive(until: Until, kmh = 60, seconds = 900): Promise<Line> {
    return this.until(until, seconds, kmh);
  }
  /// Brakes to a stand.
  async stop(): Promise<void> {
    await this.page.evaluate(() => (window.evc as Evc).desk({ lever: -1 }));
    await this.wait({ stands: true }, 120);
    await this.advance(1);
  }

  /// The on-board's mode and level now.
  async expect(what: Partial<Line>): Promise<void> {
    const line = await this.line();
    for (const [key, value] of Object.entries(what))
      assert.deepEqual(line[key as keyof Line], value, `${key}: ${await this.situation(await this.see())}`);
  }

  /// Types or chooses the value of the selected field, and presses the field.
  private async enterField(value: string): Promise<void> {
    await this.type(value);
    const seen = await this.see();
    const selected = seen.fields.find((field) => field.state === "selected");
    assert.ok(selected !== undefined, `no field is selected: ${await this.situation(seen)}`);
    await this.press(`field ${this.placeOf(seen, selected)}`);
  }

  /// Fields are numbered on their page from 1, their places of touch through all pages.
  private placeOf(seen: Seen, field: Labelled): number {
    const places = seen.places.filter((place) => place.action === "field");
    return Number(places[field.n - 1]?.name.split(" ")[1]);
  }

  private async type(value: string): Promise<void> {
    const { keys } = await this.see();
    const whole = keys.find((key) => key.label === value);
    if (whole !== undefined && value.length > 1) return this.press(`key ${whole.n}`);
    if (value.length > 1 && !keys.some((key) => key.label.startsWith("1"))) {
      // More choices than keys: the last key shows the others.
      for (let page = 0; page < 8; ++page) {
        await this.press("key 12");
        const key = (await this.see()).keys.find((candidate) => candidate.label === value);
        if (key !== undefined) return this.press(`key ${key.n}`);
      }
      assert.fail(`no key ${value}: ${await this.situation(await this.see())}`);
    }
    let before = 0;
    for (const character of value) {
      const key = keys.find((candidate) => candidate.label.replace(" ", "").includes(character));
      assert.ok(key !== undefined, `no key for ${character}`);
      const letters = key.label.replace(" ", "");
      // The same key at once would change the letter (015560 10.3.2.5).
      if (key.n === before && letters.length > 1) await this.advance(2.2);
      for (let n = 0; n <= letters.indexOf(character); ++n) await this.press(`key ${key.n}`);
      before = key.n;
    }
  }

  private async touch(place: Place): Promise<void> {
    const [left, top, width, height] = place.abs;
    const cell = { x: Math.floor(left + width / 2), y: Math.floor(top + height / 2) };
    if (this.by === "evc") {
      const hit = await this.page.evaluate(({ x, y }) => (window.evc as Evc).press(x, y), cell);
      assert.ok(hit, place.name);
      await this.advance(0.3);
      return;
    }
    const at = await this.pixelOf(cell);
    if (this.by === "mouse") {
      await this.page.mouse.move(at.x, at.y);
      await this.page.mouse.down();
    } else {
      await this.page.touchscreen.touchStart(at.x, at.y);
    }
    await this.advance(place.type === "delay" ? 2.1 : 0.1);
    if (this.by === "mouse") await this.page.mouse.up();
    else await this.page.touchscreen.touchEnd();
    await this.advance(0.4);
  }

  /// Where a cell of the display is on the page.
  async pixelOf(cell: { x: number; y: number }): Promise<{ x: number; y: number }> {
    return this.page.evaluate(({ x, y }) => {
      const box = (document.querySelector("#dmi") as HTMLCanvasElement).getBoundingClientRect();
      return { x: box.left + ((x + 0.5) * box.width) / 640, y: box.top + ((y + 0.5) * box.height) / 480 };
    }, cell);
  }

  private async until(until: Until, seconds: number, kmh: number | undefined): Promise<Line> {
    const done = await this.page.evaluate(
      (wanted, most, fastest) => {
        const cab = window.evc as Evc;
        const reached = (line: Line): boolean => {
          if (wanted.mode !== undefined && line.mode !== wanted.mode) return false;
          if (wanted.level !== undefined && line.level !== wanted.level) return false;
          if (wanted.stands === true && line.v_kmh !== 0) return false;
          if (wanted.run_m !== undefined && line.est_front_m < wanted.run_m) return false;
          const place = wanted.asks === undefined ? wanted.offers : `ack ${wanted.asks}`;
          if (place === undefined && wanted.window === undefined) return true;
          const screen = cab.screen() as { window: string; touch: { name: string; action: string; enabled: boolean }[] };
          if (wanted.window !== undefined && screen.window !== wanted.window) return false;
          if (place === undefined) return true;
          const actions = [place, place.toLowerCase()];
          return screen.touch.some((t) => (actions.includes(t.action) || t.name === place) && t.enabled);
        };
        const STEP_S = 0.3;
        for (let t = 0; t <= most; t += STEP_S) {
          const line = cab.state() as Line;
          if (reached(line)) return true;
          if (fastest !== undefined) {
            // Two km/h below what is permitted, the gentler the nearer.
            const aim = Math.min(fastest, line.V_P ?? fastest) - 2;
            cab.desk({ lever: Math.max(-1, Math.min(0.8, (aim - line.v_kmh) / 4)) });
          }
          cab.advance(STEP_S);
        }
        return false;
      },
      until,
      seconds,
      kmh,
    );
    const line = await this.line();
    assert.ok(done, `not within ${seconds} s: ${JSON.stringify(until)}; ${await this.situation(await this.see())}`);
    return line;
  }

  /// For the message of a failure.
  private async situation(seen: Seen): Promise<string> {
    const line = await this.line();
    const places = seen.places.map((place) => `${place.name} (${place.action})${place.enabled ? "" : " -"}`).join(" | ");
    const { mode, level, lrbg, est_front_m, v_kmh, V_P, eb, sb, brake_reasons, driver } = line;
    const now = { mode, level, lrbg, est_front_m, v_kmh, V_P, eb, sb, brake_reasons, driver };
    return `window ${seen.window}: ${places}; ${JSON.stringify(now)}`;
  }
}
