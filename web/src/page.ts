// What the cab and the page of a unit elsewhere share: their elements, the lamp of the brakes, the hand on the display.

import type { Painter } from "./painter.js";
import { brakeText } from "./why.js";

export function element<T extends Element>(selector: string, root: ParentNode = document): T {
  const found = root.querySelector<T>(selector);
  if (found === null) throw new Error(`the page has no ${selector}`);
  return found;
}

/// `brakes`: bits, as in the samples of a ride: 1 traction cut-off, 2 service brake, 4 emergency brake.
export function showLamp(brakes: number): void {
  const lamp = element<HTMLElement>("#lamp");
  lamp.textContent = brakes === 0 ? "no brake command" : brakeText(brakes);
  lamp.dataset["on"] = `${brakes !== 0}`;
}

/// What a finger or the mouse does on the display; places in cells.
export interface Hand {
  touch(x: number, y: number): void;
  slide(x: number, y: number): void;
  lift(): void;
}

export function followHand(painter: Painter, hand: Hand): void {
  const dmi = element<HTMLCanvasElement>("#dmi");
  dmi.addEventListener("pointerdown", (event) => {
    dmi.setPointerCapture(event.pointerId);
    const cell = painter.cellOf(event);
    hand.touch(cell.x, cell.y);
  });
  dmi.addEventListener("pointermove", (event) => {
    if (event.buttons === 0) return;
    const cell = painter.cellOf(event);
    hand.slide(cell.x, cell.y);
  });
  for (const kind of ["pointerup", "pointercancel"]) dmi.addEventListener(kind, () => hand.lift());
}
