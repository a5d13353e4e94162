// The desk: combined lever, direction controller, cab key, emergency push button, and their keys.

import type { Desk, Direction } from "./module.js";
import { element } from "./page.js";

/// Notches of the lever on each side of coasting.
const NOTCHES = 10;

export interface DeskKeys {
  keys: string;
  does: string;
}
/// For the help sheet; what `DeskView.key` takes.
export const DESK_KEYS: readonly DeskKeys[] = [
  { keys: "↑ / W, ↓ / S", does: "lever: more traction or less brake, less traction or more brake" },
  { keys: "X", does: "lever to coasting" },
  { keys: "F, N, B", does: "direction controller: forward, neutral, backward" },
  { keys: "K", does: "cab key: open or close the desk" },
  { keys: "space", does: "emergency push button: press, release" },
];

export class DeskView {
  private readonly lever: HTMLInputElement;
  private readonly leverText: HTMLElement;
  private readonly key: HTMLButtonElement;
  private readonly emergency: HTMLButtonElement;
  private readonly directions: readonly HTMLButtonElement[];
  private desk: Desk;

  /// `change` is told what the driver does to the desk.
  constructor(
    root: HTMLElement,
    desk: Desk,
    private readonly change: (desk: Desk) => void,
  ) {
    this.lever = element("#lever", root);
    this.leverText = element("#lever-text", root);
    this.key = element("#key", root);
    this.emergency = element("#emergency", root);
    this.directions = [...root.querySelectorAll<HTMLButtonElement>("[data-direction]")];
    this.lever.addEventListener("input", () => this.set({ lever: Number(this.lever.value) / NOTCHES }));
    this.key.addEventListener("click", () => this.set({ key: !this.desk.key }));
    this.emergency.addEventListener("click", () => this.set({ emergency: !this.desk.emergency }));
    for (const button of this.directions)
      button.addEventListener("click", () => this.set({ direction: button.dataset["direction"] as Direction }));
    this.desk = { ...desk };
    this.show(desk);
  }

  /// Shows a desk as it is now, after a step in time or a call from outside.
  show(desk: Desk): void {
    if (desk === this.desk) return;
    this.desk = desk;
    const notch = Math.round(desk.lever * NOTCHES);
    this.lever.value = `${notch}`;
    this.leverText.textContent = notch === 0 ? "coasting" : `${notch > 0 ? "traction" : "brake"} ${Math.abs(notch) * 10} %`;
    this.key.setAttribute("aria-pressed", `${desk.key}`);
    this.emergency.setAttribute("aria-pressed", `${desk.emergency}`);
    for (const button of this.directions)
      button.setAttribute("aria-pressed", `${button.dataset["direction"] === desk.direction}`);
  }

  /// Takes a key of DESK_KEYS; false: it is another one.
  press(key: string): boolean {
    const notch = Math.round(this.desk.lever * NOTCHES);
    switch (key) {
      case "ArrowUp":
      case "w":
        this.set({ lever: Math.min(NOTCHES, notch + 1) / NOTCHES });
        return true;
      case "ArrowDown":
      case "s":
        this.set({ lever: Math.max(-NOTCHES, notch - 1) / NOTCHES });
        return true;
      case "x":
        this.set({ lever: 0 });
        return true;
      case "f":
        this.set({ direction: "forward" });
        return true;
      case "n":
        this.set({ direction: "neutral" });
        return true;
      case "b":
        this.set({ direction: "backward" });
        return true;
      case "k":
        this.set({ key: !this.desk.key });
        return true;
      case " ":
        this.set({ emergency: !this.desk.emergency });
        return true;
      default:
        return false;
    }
  }

  private set(part: Partial<Desk>): void {
    this.show({ ...this.desk, ...part });
    this.change(this.desk);
  }
}
