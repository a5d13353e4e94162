// The page in a browser, opened from a file: it drives the shipped line by itself and gives the hash of evc run.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { domOf, evc, folder } from "./page.js";

test("the page drives by itself in Chromium and gives the bytes of evc run", { timeout: 320_000 }, async () => {
  const page = join(folder(), "cab.html");
  evc("cab", "-o", page);
  const dom = await domOf(page, "?auto=perfect&speed=max");
  const done = /data-evc-done="([^"]*)"/.exec(dom)?.[1]?.replaceAll("&quot;", '"');
  assert.ok(done !== undefined, dom.replace(/<script id="(given|module)"[^<]*</g, "<").slice(0, 2000));
  const out = folder();
  evc("run", "-o", out);
  const summary = JSON.parse(readFileSync(join(out, "summary.json"), "utf8")) as Record<string, unknown>;
  assert.deepEqual(JSON.parse(done), {
    output_hash: summary["output_hash"],
    modes: summary["modes"],
    cycles: summary["cycles"],
  });
});

test("the page asks nobody for anything", () => {
  const page = join(folder(), "cab.html");
  evc("cab", "-o", page);
  const text = readFileSync(page, "utf8");
  for (const address of text.match(/(src|href)="[^"]*"/g) ?? []) assert.fail(address);
  assert.ok(!/https?:\/\//.test(text.replace(/<script id="(given|module)"[^<]*</g, "")));
});
