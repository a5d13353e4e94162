// Why: the last events with their clauses, and the brake commands with their causes.

import type { BrakeCommand, Journey } from "./journey.js";

const EVENTS_SHOWN = 40;

export function timeText(seconds: number): string {
  const s = Math.floor(seconds);
  const two = (n: number): string => `${n}`.padStart(2, "0");
  return `${Math.floor(s / 3600)}:${two(Math.floor(s / 60) % 60)}:${two(s % 60)}`;
}

/// The bits of Point::brakes in words.
export function brakeText(brakes: number): string {
  const names = ["traction cut-off", "service brake", "emergency brake"];
  return names.filter((_, bit) => (brakes & (1 << bit)) !== 0).join(", ");
}

export class Why {
  private shown = "";

  constructor(
    private readonly eventsRoot: HTMLElement,
    private readonly brakesRoot: HTMLElement,
    private readonly causeRoot: HTMLElement,
  ) {}

  show(journey: Journey): void {
    const now = `${journey.events.length} ${journey.brakeCommands.length} ${journey.branches.length}`;
    if (now === this.shown) return;
    this.shown = now;
    const events = journey.events.slice(-EVENTS_SHOWN).reverse();
    this.eventsRoot.replaceChildren(
      ...events.map((event) => line("li", `${timeText(event.t_s)}  ${(event.x_m / 1000).toFixed(2)} km  ${event.text}`)),
    );
    const commands = journey.brakeCommands.slice(-10).reverse();
    this.brakesRoot.replaceChildren(
      ...commands.map((command) => {
        const button = line("button", `${timeText(command.t_s)} ${brakeText(command.brakes)}`);
        button.addEventListener("click", () => this.showCause(command));
        return button;
      }),
    );
    if (commands.length === 0) this.causeRoot.replaceChildren();
  }

  private showCause(command: BrakeCommand): void {
    const reasons = command.reasons.length > 0 ? command.reasons : ["the output of this cycle names no cause"];
    this.causeRoot.replaceChildren(
      line("p", `At ${timeText(command.t_s)}: ${brakeText(command.brakes)}, because of`),
      ...reasons.map((reason) => line("p", `• ${reason}`)),
      ...command.events.map((event) => line("p", event)),
    );
  }
}

export function line<K extends keyof HTMLElementTagNameMap>(tag: K, text: string): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  made.textContent = text;
  return made;
}
