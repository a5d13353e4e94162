// The cab at a unit that runs elsewhere: the page that `evc serve` gives. It has the display and the desk; how the train
// moves and what trackside sends come from lines, which are typed here or sent by whoever has them.

import { DeskView } from "./desk.js";
import type { Desk, Remote } from "./module.js";
import { element, followHand, showLamp } from "./page.js";
import { Painter } from "./painter.js";
import { line, timeText } from "./why.js";

const CYCLE_MS = 100;
/// Cycles that are asked for without an answer; then the page waits for the unit.
const AHEAD = 20;
const EVENTS_SHOWN = 40;

/// What the page reads of an output line of `ports.md`.
interface Output {
  t_ms: number;
  mode: string;
  level: string;
  v_kmh: number;
  tco: boolean;
  sb: boolean;
  eb: boolean;
  brake_reasons: string[];
  events: string[];
  dmi: unknown;
  error?: string;
}

export class Live {
  private readonly painter: Painter;
  private readonly desk_: DeskView;
  private desk: Desk = { lever: 0, direction: "neutral", key: false, emergency: false };
  private socket: WebSocket | undefined;
  private journal = "";
  private output: Output | undefined;
  /// The last word of a session that ended by a wrong line.
  private failed: string | undefined;
  private asked = 0;
  private unanswered = 0;
  private finger: "none" | "down" | "to lift" = "none";
  private readonly waiting: { until: number; done: () => void }[] = [];

  constructor(private readonly remote: Remote) {
    document.body.dataset["live"] = "true";
    document.title = `${location.host}: cab`;
    element("#title").textContent = `the unit at ${location.host}`;
    this.painter = new Painter(element("#dmi"));
    this.desk_ = new DeskView(element("#desk"), this.desk, (desk) => this.setDesk(desk));
    this.listen();
    this.paint();
  }

  /// Connects, and lets time pass as long as the unit answers.
  go(): void {
    const socket = new WebSocket(`ws://${location.host}/unit?dmi`);
    this.socket = socket;
    socket.addEventListener("open", () => {
      this.say("connected");
      // Without a word of it the direction controller of a unit is forward.
      this.remote.setDesk(this.desk);
      this.send(this.remote.acts());
      this.cycle();
      setInterval(() => this.beat(), CYCLE_MS);
    });
    socket.addEventListener("message", (event: MessageEvent<string>) => this.answered(event.data));
    socket.addEventListener("close", () => this.say(`${this.failed ?? "the session has ended"}; load the page again for another unit`));
  }

  // window.evc
  state(): unknown {
    return this.output ?? null;
  }
  screen(): unknown {
    return this.remote.screen();
  }
  press(x: number, y: number): boolean {
    const hit = this.remote.touch(x, y);
    this.finger = "to lift";
    this.paint();
    return hit;
  }
  setDesk(part: Partial<Desk>): void {
    this.desk = { ...this.desk, ...part };
    this.desk_.show(this.desk);
    this.remote.setDesk(this.desk);
  }
  /// Resolved when the unit has answered the cycles of so many seconds.
  advance(seconds: number): Promise<void> {
    const until = (this.asked - 1) * CYCLE_MS + Math.round(seconds * 1000);
    return new Promise((done) => this.waiting.push({ until, done }));
  }
  inputs(): string {
    return this.journal;
  }
  /// Lines of `ports.md` from elsewhere; each gets the time of the next cycle.
  give(text: string): void {
    for (const line of text.split("\n").filter((one) => one.trim() !== "")) {
      try {
        const input = JSON.parse(line) as Record<string, unknown>;
        this.send(`${JSON.stringify({ ...input, t_ms: this.asked * CYCLE_MS })}\n`);
      } catch (error) {
        this.say(`not sent: ${String(error)}`);
      }
    }
  }

  private beat(): void {
    if (this.socket?.readyState !== WebSocket.OPEN || this.unanswered >= AHEAD) return;
    this.cycle();
  }

  /// What the driver did, and the end of the cycle. With `--real-time` the unit keeps its own time.
  private cycle(): void {
    const t_ms = this.asked * CYCLE_MS;
    this.send(this.remote.acts(t_ms));
    this.send(`{"t_ms":${t_ms},"end":true}\n`);
    ++this.asked;
    ++this.unanswered;
  }

  private send(lines: string): void {
    this.journal += lines;
    for (const line of lines.split("\n")) if (line !== "") this.socket?.send(line);
  }

  private answered(text: string): void {
    const output = JSON.parse(text) as Output;
    if (output.error !== undefined) {
      this.failed = output.error;
      return this.say(output.error);
    }
    this.unanswered = 0;
    this.output = output;
    this.remote.show(JSON.stringify(output.dmi));
    if (this.finger === "to lift") {
      this.finger = "none";
      this.remote.lift();
    }
    this.paint();
    this.tell(output);
    while (this.waiting[0] !== undefined && this.waiting[0].until <= output.t_ms) this.waiting.shift()?.done();
  }

  private tell(output: Output): void {
    element("#clock").textContent = timeText(output.t_ms / 1000);
    showLamp((output.tco ? 1 : 0) | (output.sb ? 2 : 0) | (output.eb ? 4 : 0));
    element("#cause").replaceChildren(...output.brake_reasons.map((reason) => line("p", `• ${reason}`)));
    const events = element("#events");
    for (const event of output.events) events.prepend(line("li", `${timeText(output.t_ms / 1000)}  ${event}`));
    while (events.childElementCount > EVENTS_SHOWN) events.lastElementChild?.remove();
  }

  private say(what: string): void {
    element("#done").textContent = what;
  }

  private paint(): void {
    this.painter.paint(this.remote.drawing());
  }

  private listen(): void {
    followHand(this.painter, {
      touch: (x, y) => {
        this.remote.touch(x, y);
        this.finger = "down";
        this.paint();
      },
      slide: (x, y) => this.remote.slide(x, y),
      // A finger lies on the display for a cycle at least, as a held button is one that time passes over.
      lift: () => {
        if (this.finger === "down") this.finger = "to lift";
      },
    });
    document.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || event.target instanceof HTMLTextAreaElement) return;
      const key = event.key.toLowerCase();
      if ("fnbk".includes(key) && this.desk_.press(key)) event.preventDefault();
    });
    const lines = element<HTMLTextAreaElement>("#lines");
    element("#give").addEventListener("click", () => this.give(lines.value));
    window.addEventListener("resize", () => this.paint());
  }
}
