// The cab: joins the journey, the display, the desk, the strip and the clock.

import { DESK_KEYS, DeskView } from "./desk.js";
import { CYCLE_S, Journey, lastValue } from "./journey.js";
import { DRIVERS, EDITIONS, type Begin, type Desk, type Direction, type Ride, type Summary } from "./module.js";
import { element, followHand, showLamp } from "./page.js";
import { Painter } from "./painter.js";
import { Strip } from "./strip.js";
import { timeText, Why } from "./why.js";

export const SPEEDS = [1, 2, 5, 10, 20] as const;
/// Cycles of a step of `speed=max` between two pictures.
const CYCLES_AT_MAX = 3000;
const BACK_S = 30;
/// The name of the measure of the browser's timeline that says how long `speed=max` took.
export const JOURNEY = "journey";
/// A delay button acts after 2 s of touch.
const CYCLES_OF_DELAY = 21;

const KEYS = [
  ...DESK_KEYS,
  { keys: "P", does: "pause, go on" },
  { keys: "1 to 5", does: "1, 2, 5, 10, 20 times as fast" },
  { keys: "← / backspace", does: `${BACK_S} s back` },
  { keys: "J", does: "save the journal, inputs.jsonl" },
  { keys: "?", does: "this sheet" },
];

/// What the address asks for: `?auto=perfect&speed=max&srs=4.0.0&utc=2026-01-01T08:00:00Z`.
export interface Wanted extends Begin {
  /// Times real time; Infinity for max.
  speed: number;
}
/// Seconds since 1970 of "2026-01-01T08:00:00Z"; nothing for another text.
function utcOf(text: string): number | undefined {
  if (!/^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$/.test(text)) return undefined;
  const seconds = Date.parse(text) / 1000;
  return seconds >= 0 ? seconds : undefined;
}
export function wantedOf(query: string): Wanted {
  const asked = new URLSearchParams(query);
  const speed = asked.get("speed");
  const wanted: Wanted = { speed: speed === "max" ? Infinity : Math.min(20, Math.max(1, Number(speed) || 1)) };
  const driver = DRIVERS.find((name) => name === asked.get("auto"));
  if (driver !== undefined) wanted.driver = driver;
  const edition = EDITIONS.find((name) => name === asked.get("srs"));
  if (edition !== undefined) wanted.edition = edition;
  const utc = utcOf(asked.get("utc") ?? "");
  if (utc !== undefined) wanted.utc = utc;
  return wanted;
}

/// For tests and for those who look into it: `window.evc`.
export interface Evc {
  state(): unknown;
  screen(): unknown;
  press(x: number, y: number): boolean;
  desk(part: { lever?: number; direction?: Direction; key?: boolean; emergency?: boolean }): void;
  advance(seconds: number): void;
  inputs(): string;
}

export class Cab implements Evc {
  private readonly journey: Journey;
  private readonly painter = new Painter(element("#dmi"));
  private readonly strip: Strip;
  private readonly desk_: DeskView;
  private readonly why = new Why(element("#events"), element("#brakes"), element("#cause"));
  private paused: boolean;
  private speed: number;
  private before: number | undefined;
  private owed = 0;
  private shown = "";
  private stale = false;

  constructor(
    private readonly ride: Ride,
    private readonly wanted: Wanted,
  ) {
    const scene = ride.scene();
    document.title = `${scene.line}: cab`;
    element("#title").textContent = `${scene.line} · ${scene.train}${wanted.driver ? ` · driver: ${wanted.driver}` : ""}`;
    this.journey = new Journey(ride);
    this.speed = wanted.speed;
    this.paused = false;
    this.strip = new Strip(element("#strip"), scene);
    this.desk_ = new DeskView(element("#desk"), this.journey.desk, (desk) => this.journey.setDesk(desk));
    element<HTMLElement>("#desk").toggleAttribute("inert", wanted.driver !== undefined);
    this.connect();
    // The first cycle shows what the unit says at power-up.
    this.journey.advance(1);
    this.show();
  }

  /// Begins to let time pass.
  go(): void {
    if (this.speed === Infinity) {
      performance.mark(JOURNEY);
      this.goToTheEnd();
    } else requestAnimationFrame((now) => this.frame(now));
  }

  // window.evc
  state(): unknown {
    return this.journey.output === "" ? null : (JSON.parse(this.journey.output) as unknown);
  }
  screen(): unknown {
    return this.ride.screen();
  }
  press(x: number, y: number): boolean {
    const hit = this.journey.touch(x, y);
    this.journey.advance(this.isDelayedAt(x, y) ? CYCLES_OF_DELAY : 1);
    this.journey.lift();
    this.journey.advance(1);
    this.showSoon();
    return hit;
  }
  desk(part: Partial<Desk>): void {
    this.journey.setDesk({ ...this.journey.desk, ...part });
    this.showSoon();
  }
  advance(seconds: number): void {
    this.journey.advance(Math.round(seconds / CYCLE_S));
    this.showSoon();
  }
  inputs(): string {
    return this.journey.inputs;
  }

  /// Whether the topmost place of touch at this cell is a delay button.
  private isDelayedAt(x: number, y: number): boolean {
    const { touch } = this.ride.screen() as { touch: { abs: [number, number, number, number]; type: string }[] };
    const place = touch.find(({ abs: [left, top, w, h] }) => x >= left && x < left + w && y >= top && y < top + h);
    return place?.type === "delay";
  }

  private frame(now: number): void {
    const passed = this.before === undefined ? 0 : Math.min(0.25, (now - this.before) / 1000);
    this.before = now;
    if (!this.paused) {
      this.owed += passed * this.speed;
      const cycles = Math.floor(this.owed / CYCLE_S);
      if (cycles > 0) {
        this.owed -= cycles * CYCLE_S;
        if (this.journey.advance(cycles) < cycles) this.end();
        this.show();
      }
    }
    requestAnimationFrame((next) => this.frame(next));
  }

  private goToTheEnd(): void {
    const done = this.journey.advance(CYCLES_AT_MAX);
    this.show();
    if (done === CYCLES_AT_MAX) {
      setTimeout(() => this.goToTheEnd(), 0);
      return;
    }
    performance.measure(JOURNEY, JOURNEY);
    this.end();
  }

  private end(): void {
    this.paused = true;
    const summary: Summary = this.ride.summary();
    document.body.dataset["evcDone"] = JSON.stringify(summary);
    element("#done").textContent = `end of the journey: ${summary.cycles} cycles, outputs ${summary.output_hash.slice(0, 12)}…`;
  }

  private goBack(seconds: number): void {
    this.journey.goBack(Math.max(0, Math.round(seconds / CYCLE_S)));
    delete document.body.dataset["evcDone"];
    element("#done").textContent = "";
    this.desk_.show(this.journey.desk);
    this.show();
  }

  /// With the next frame: a test drives many times between two.
  private showSoon(): void {
    if (this.stale) return;
    this.stale = true;
    requestAnimationFrame(() => {
      this.stale = false;
      this.show();
    });
  }

  /// What stands in the page's other elements is written when it is another: the browser lays out again what is written.
  private show(): void {
    this.painter.paint(this.ride.drawing());
    this.strip.draw(this.journey);
    this.why.show(this.journey);
    this.desk_.show(this.journey.desk);
    const brakes = lastValue(this.journey.points, "brakes") ?? 0;
    const clock = timeText(this.journey.seconds);
    const now = `${clock} ${brakes} ${this.journey.colour} ${this.paused} ${this.speed}`;
    if (now === this.shown) return;
    this.shown = now;
    showLamp(brakes);
    element("#clock").textContent = clock;
    element<HTMLElement>("#clock").style.color = this.journey.colour;
    element("#pause").textContent = this.paused ? "▶" : "❚❚";
    for (const button of document.querySelectorAll<HTMLButtonElement>("[data-speed]"))
      button.setAttribute("aria-pressed", `${Number(button.dataset["speed"]) === this.speed}`);
    const slider = element<HTMLInputElement>("#moment");
    if (document.activeElement !== slider) {
      slider.max = `${this.journey.cycles}`;
      slider.value = slider.max;
    }
  }

  private connect(): void {
    followHand(this.painter, this.journey);
    // Another edition is another on-board: the journey begins anew.
    const edition = element<HTMLSelectElement>("#edition");
    edition.value = this.wanted.edition ?? "3.6.0";
    edition.addEventListener("change", () => {
      const query = new URLSearchParams(location.search);
      query.set("srs", edition.value);
      location.search = query.toString();
    });
    element("#pause").addEventListener("click", () => this.pause());
    element("#back").addEventListener("click", () => this.goBack(this.journey.seconds - BACK_S));
    for (const button of document.querySelectorAll<HTMLButtonElement>("[data-speed]"))
      button.addEventListener("click", () => (this.speed = Number(button.dataset["speed"])));
    const slider = element<HTMLInputElement>("#moment");
    slider.addEventListener("change", () => {
      this.goBack(Number(slider.value) * CYCLE_S);
      slider.blur();
    });
    element("#save").addEventListener("click", () => this.save());
    element("#help").addEventListener("click", () => this.help());
    element("#keys").replaceChildren(
      ...KEYS.flatMap(({ keys, does }) => {
        const term = document.createElement("dt");
        term.textContent = keys;
        const meaning = document.createElement("dd");
        meaning.textContent = does;
        return [term, meaning];
      }),
    );
    document.addEventListener("keydown", (event) => this.key(event));
    window.addEventListener("resize", () => this.show());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      this.strip.recolour();
      this.show();
    });
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target instanceof HTMLSelectElement) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (this.wanted.driver === undefined && this.desk_.press(key)) {
      event.preventDefault();
      return;
    }
    const number = Number(key);
    if (key === "p") this.pause();
    else if (key === "j") this.save();
    else if (key === "?") this.help();
    else if (key === "ArrowLeft" || key === "Backspace") this.goBack(this.journey.seconds - BACK_S);
    else if (number >= 1 && number <= SPEEDS.length) this.speed = SPEEDS[number - 1] ?? 1;
    else return;
    event.preventDefault();
    this.show();
  }

  private pause(): void {
    this.paused = !this.paused;
    this.show();
  }

  private help(): void {
    const sheet = element<HTMLDialogElement>("#sheet");
    if (sheet.open) sheet.close();
    else sheet.showModal();
  }

  private save(): void {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([this.journey.inputs], { type: "application/x-ndjson" }));
    link.download = "inputs.jsonl";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }
}
