// Pressing at random, seeded: whatever a hand does on the page, nothing fails, and the journal still says what happened.

import type { Browser } from "puppeteer-core";

import { Cabin } from "./cabin.js";

/// The same numbers for the same seed (xorshift).
export class Chance {
  private state: number;
  constructor(seed: number) {
    this.state = (seed * 2654435761) >>> 0 || 1;
  }
  below(limit: number): number {
    this.state ^= this.state << 13;
    this.state ^= this.state >>> 17;
    this.state ^= this.state << 5;
    this.state >>>= 0;
    return this.state % limit;
  }
  of<T>(choices: readonly T[]): T {
    return choices[this.below(choices.length)] as T;
  }
}

const KEYS = [
  "ArrowUp", "ArrowUp", "ArrowUp", "w", "ArrowDown", "s", "x", "f", "f", "n", "b", "k", "Space", "Space", "p", "1", "4", "5",
  "ArrowLeft", "Backspace", "?", "Escape", "Tab", "Enter", "j",
] as const;

/// Presses for so many seconds by the clock, at a time that passes twenty times as fast, and on where the machine was too busy
/// for a place each second; `inMission`: of a train that drives.
export async function pressAtRandom(
  browser: Browser, words: string[], seed: number, seconds: number, inMission: boolean,
): Promise<string> {
  const chance = new Chance(seed);
  const cab = await Cabin.begin(browser, words, "?speed=20");
  if (inMission) {
    await cab.page.keyboard.press("p");
    await cab.startInLevel1();
    await cab.drive({ mode: "FS" }, 30);
    await cab.page.keyboard.press("p");
  } else {
    await cab.openDesk();
  }
  const counts = { places: 0, cells: 0, page: 0, keys: 0 };
  const modes = new Set<string>();
  const end = Date.now() + seconds * 1000;
  const press = async (at: { x: number; y: number }): Promise<void> => {
    await cab.page.mouse.move(at.x, at.y);
    await cab.page.mouse.down();
    const held = chance.below(5) === 0 ? 130 : 10;
    await new Promise((resolve) => setTimeout(resolve, held));
    if (chance.below(8) === 0) await cab.page.mouse.move(at.x + chance.below(60) - 30, at.y + chance.below(60) - 30);
    await cab.page.mouse.up();
  };
  while (Date.now() < end || counts.places <= seconds) {
    const what = chance.below(20);
    if (what < 14) {
      ++counts.places;
      const places = (await cab.see()).places.filter((place) => place.enabled);
      if (places.length === 0) continue;
      const [x, y, w, h] = chance.of(places).abs;
      await press(await cab.pixelOf({ x: x + chance.below(w), y: y + chance.below(h) }));
    } else if (what === 14) {
      ++counts.cells;
      await press(await cab.pixelOf({ x: chance.below(640), y: chance.below(480) }));
    } else if (what === 15) {
      ++counts.page;
      await press({ x: chance.below(1400), y: chance.below(1000) });
    } else {
      ++counts.keys;
      await cab.page.keyboard.press(chance.of(KEYS));
    }
    // Gone back to the begin there is no cycle yet, and none is said.
    modes.add((await cab.line())?.mode ?? "");
  }
  await cab.advance(1);
  await cab.replayed();
  await cab.close();
  return `seed ${seed}: ${JSON.stringify(counts)}, modes ${[...modes].join(" ")}`;
}
