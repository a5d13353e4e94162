// What the tests share: the page that `make cab` made, opened without a browser, and the command.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { bytesOfBase64, Ride, type Driver } from "../src/module.js";

export const EVC = process.env["EVC"] ?? "build/release/evc";

export function evc(...words: string[]): string {
  return execFileSync(EVC, words, { encoding: "utf8", maxBuffer: 1 << 30 });
}
export function folder(): string {
  return mkdtempSync(join(tmpdir(), "evc-cab-"));
}

/// The text of an element of the page.
export function contentOf(page: string, id: string): string {
  const found = new RegExp(`<script id="${id}"[^>]*>([^<]*)</script>`).exec(page);
  if (found?.[1] === undefined) throw new Error(`the page has no #${id}`);
  return found[1];
}

/// A ride of the page that `evc cab` writes with these words.
export async function rideOf(words: string[], driver?: Driver): Promise<Ride> {
  const file = join(folder(), "cab.html");
  evc("cab", ...words, "-o", file);
  const page = readFileSync(file, "utf8");
  return Ride.begin(bytesOfBase64(contentOf(page, "module")), bytesOfBase64(contentOf(page, "given")), driver);
}
