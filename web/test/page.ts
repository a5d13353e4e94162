// What the tests share: the page that `make cab` made, opened without a browser, and the command.

import { execFile, execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { promisify } from "node:util";

import { bytesOfBase64, Ride, unpacked, type Begin } from "../src/module.js";

export const EVC = process.env["EVC"] ?? "build/release/evc";
export const CHROMIUM = process.env["CHROMIUM"] ?? "chromium";

export function evc(...words: string[]): string {
  return execFileSync(EVC, words, { encoding: "utf8", maxBuffer: 1 << 30 });
}
export function folder(): string {
  return mkdtempSync(join(tmpdir(), "evc-cab-"));
}

/// The document in headless Chromium after its script has come to the end. `query`: ends the address; `size`: of the window.
export async function domOf(page: string, query: string, size = "1400,1000"): Promise<string> {
  const words = [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", `--user-data-dir=${folder()}`, `--window-size=${size}`,
    "--virtual-time-budget=600000", "--dump-dom", `${pathToFileURL(page).href}${query}`,
  ];
  const { stdout } = await promisify(execFile)(CHROMIUM, words, { maxBuffer: 1 << 28, timeout: 300_000 });
  return stdout;
}

/// The text of an element of the page.
export function contentOf(page: string, id: string): string {
  const found = new RegExp(`<script id="${id}"[^>]*>([^<]*)</script>`).exec(page);
  if (found?.[1] === undefined) throw new Error(`the page has no #${id}`);
  return found[1];
}

/// A ride of the page that `evc cab` writes with these words.
export async function rideOf(words: string[], begin: Begin = {}): Promise<Ride> {
  const file = join(folder(), "cab.html");
  evc("cab", ...words, "-o", file);
  const page = readFileSync(file, "utf8");
  return Ride.begin(await unpacked(bytesOfBase64(contentOf(page, "module"))), bytesOfBase64(contentOf(page, "given")), begin);
}
