// The report of `evc run`: the display of the run, in node and in headless Chromium, compared with the pictures of `evc dmi`.

import assert from "node:assert/strict";
import { existsSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { isDeepStrictEqual } from "node:util";

import { DisplayLists, type Written } from "../src/display_lists.js";
import type { Shape } from "../src/painter.js";
import { domOf, evc, folder } from "./page.js";

interface Run {
  folder: string;
  page: string;
  lists: DisplayLists;
  /// When and where the driver's Start is touched, for `evc dmi`: the driver of a run has no fingers.
  start: string;
}

function run(...words: string[]): Run {
  const out = folder();
  evc("run", ...words, "-o", out);
  const page = readFileSync(join(out, "report.html"), "utf8");
  const written = /new DisplayLists\((\{[^]*?\})\);\n/.exec(page)?.[1];
  assert.ok(written !== undefined);
  const inputs = readFileSync(join(out, "inputs.jsonl"), "utf8").split("\n");
  const start = inputs.find((line) => line.includes('"select":"start"'));
  assert.ok(start !== undefined);
  const t_ms = (JSON.parse(start) as { t_ms: number }).t_ms;
  return {
    folder: out,
    page,
    lists: new DisplayLists(JSON.parse(written) as Written),
    // In time to be released before that cycle.
    start: `410,90@${(t_ms - 110) / 1000}`,
  };
}

/// 12.34 cells as in a picture.
function cells(hundredths: number): string {
  const size = Math.abs(hundredths);
  const rest = String(size % 100).padStart(2, "0").replace(/0+$/, "");
  return `${hundredths < 0 ? "-" : ""}${Math.floor(size / 100)}${rest === "" ? "" : `.${rest}`}`;
}

/// A shape as an element of the picture.
function elementOf([colour, stroke, path, x, y]: Shape): string {
  let places = 0;
  const moved = path.replace(/-?[\d.]+/g, (value) =>
    cells(Math.round(Number(value) * 100) + Math.round((places++ % 2 === 0 ? x : y) * 100)),
  );
  const look = stroke === 0 ? `fill="${colour}"` : `fill="none" stroke="${colour}" stroke-width="${stroke}"`;
  return `<path d="${moved}" ${look}/>`;
}

/// The elements of the picture of `evc dmi` at a time of the run.
function pictureAt(of: Run, seconds: number): string[] {
  const file = join(folder(), "dmi.svg");
  const touched = seconds * 1000 > Number(of.start.split("@")[1]) * 1000 ? ["--press", of.start] : [];
  evc("dmi", join(of.folder, "inputs.jsonl"), ...touched, "--at", String(seconds), "-o", file);
  return readFileSync(file, "utf8").split("\n").filter((line) => line.startsWith("<path"));
}

const BACKGROUND = '<path d="M0 0L640 0L640 480L0 480Z" fill="#031122"/>';

/// In any order: jumps back and on, to neighbours, to both ends.
const PARTS = [0.5, 0.002, 0.98, 0.3, 0.301, 0.29, 0, 1, 0.75, 0.6, 0.61, 0.45];

/// The passage that is no part of the product.
const RECORDED = join(process.env["OPENEVC_SHARED"] ?? "../shared", "lines/amsterdam_utrecht.json");

for (const [name, words, skip] of [
  ["the shipped line", [], false],
  ["a reckless driver", ["--driver", "reckless"], false],
  ["the recorded line", [RECORDED], !existsSync(RECORDED) && `needs ${RECORDED}`],
] as const)
  test(`the lists of ${name} are the pictures of evc dmi`, { skip }, () => {
    const of = run(...words);
    const { lists } = of;
    for (const part of PARTS) {
      const number = Math.round(part * (lists.times.length - 1));
      const seconds = lists.times[number] ?? 0;
      assert.deepEqual(lists.list(number).map(elementOf), [BACKGROUND, ...pictureAt(of, seconds)], `${seconds} s`);
    }
  });

test("the list at a time is the last one that is not later", () => {
  const { lists } = run();
  for (const [number, seconds] of lists.times.entries()) {
    assert.equal(lists.at(seconds), number);
    if (number > 0) assert.equal(lists.at(seconds - 0.01), number - 1);
    const before = lists.times[number - 1];
    if (before !== undefined) assert.ok(Math.round((seconds - before) * 1000) >= 1000, `${seconds} s`);
  }
  assert.equal(lists.at(-1), 0);
  assert.equal(lists.at(1e9), lists.times.length - 1);
  assert.equal(new DisplayLists({ least_s: 0, shapes: [], lists: [] }).at(5), -1);
});

test("the page has at most 5 MB, and asks nobody for anything", () => {
  const of = run();
  assert.ok(statSync(join(of.folder, "report.html")).size <= 5_000_000);
  assert.ok(!/https?:/.test(of.page));
});

for (const [name, written, hidden, says] of [
  ["thinned", { least_s: 4, shapes: [["#DFDF00", 0, "M0 0L9 9Z"]], lists: [[0, 1, 5, 5]] }, false, "at most once in 4 s"],
  ["left out", { least_s: 0, shapes: [], lists: [] }, true, "is left out"],
] as const)
  test(`a page whose displays are ${name} says so`, { timeout: 120_000 }, async () => {
    const of = run();
    const file = join(of.folder, "other.html");
    const text = `new DisplayLists(${JSON.stringify(written)});\n`;
    writeFileSync(file, of.page.replace(/new DisplayLists\(\{[^]*?\}\);\n/, text));
    const dom = await domOf(file, "");
    assert.ok(/<span id="kept">[^<]*/.exec(dom)?.[0].includes(says));
    assert.equal(/<figure class="unit" id="unit" hidden/.test(dom), hidden);
    // The script has come to its end: the events are listed.
    assert.ok(/<em[^>]*>[^<]*mode NP/.test(dom));
  });

/// Stands before the scripts of the page: notes what is painted on the display, with the places of the shapes in cells.
const NOTES = `<script>
// Nobody looks, so Chromium makes a frame only now and then, whatever its virtual time.
window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 16);
const OutlineOfThePage = Path2D;
window.Path2D = class extends OutlineOfThePage { constructor(path) { super(path); this.text = path; } };
window.notes = [];
for (const kind of ["fill", "stroke"]) {
  const original = CanvasRenderingContext2D.prototype[kind];
  CanvasRenderingContext2D.prototype[kind] = function (path, ...rest) {
    if (this.canvas.id === "display") {
      const { a, e, f } = this.getTransform(), cells = (v) => Math.round(v * 100) / 100;
      window.notes.push([kind === "fill" ? this.fillStyle : this.strokeStyle, kind === "fill" ? 0 : cells(this.lineWidth), path.text, cells(e / a), cells(f / a)]);
    }
    return original.call(this, ...(path === undefined ? [] : [path, ...rest]));
  };
}
</script>`;

/// Stands behind them: moves the cursor in each of the ways, and writes down what was painted after each.
const MOVES = `<script type="module">
const chart = document.getElementById("chart"), display = document.getElementById("display");
const frames = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
const pointer = (kind, part, type) => {
  const box = chart.getBoundingClientRect();
  chart.dispatchEvent(new PointerEvent(kind, { pointerId: 1, pointerType: type, clientX: box.left + 60 + part * (box.width - 80), clientY: box.top + 200, bubbles: true }));
};
chart.setPointerCapture = () => {};
const key = (of, name, shiftKey) => of.dispatchEvent(new KeyboardEvent("keydown", { key: name, shiftKey, bubbles: true, cancelable: true }));
const moves = {
  mouse: () => pointer("pointermove", 0.3, "mouse"),
  "mouse further": () => pointer("pointermove", 0.62, "mouse"),
  touch: () => { pointer("pointerdown", 0.8, "touch"); pointer("pointerup", 0.8, "touch"); },
  "arrow key": () => key(chart, "ArrowLeft", true),
  "display before": () => key(display, "ArrowLeft", false),
  "display before that": () => document.getElementById("back").click(),
  "first display": () => key(display, "Home", false),
  "last display": () => key(display, "End", false),
  "event": () => document.querySelectorAll("#events button")[40].click(),
  "over time": () => [...document.querySelectorAll(".tool")].find((b) => b.textContent === "Over time").click(),
  "mouse over time": () => pointer("pointermove", 0.25, "mouse"),
};
/// How far a pixel is from those of the whole list, painted at once: the page paints only what changed.
const farthest = (shapes) => {
  const [own, shown] = [0, 1].map(() => Object.assign(document.createElement("canvas"), { width: display.width, height: display.height }));
  const c = own.getContext("2d"), scale = own.width / 640;
  for (const [colour, stroke, path, x, y] of shapes) {
    c.setTransform(scale, 0, 0, scale, x * scale, y * scale);
    c.fillStyle = c.strokeStyle = colour;
    c.lineWidth = stroke;
    if (stroke === 0) c.fill(new Path2D(path)); else c.stroke(new Path2D(path));
  }
  shown.getContext("2d").drawImage(display, 0, 0);
  const [a, b] = [own, shown].map((canvas) => canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data);
  return a.reduce((most, value, n) => Math.max(most, Math.abs(value - b[n])), 0);
};
const seen = {};
await frames();
for (const [name, move] of Object.entries(moves)) {
  const before = display.dataset.seconds;
  window.notes = [];
  move();
  await frames();
  const seconds = Number(display.dataset.seconds), shapes = window.notes;
  seen[name] = { seconds, farthest: farthest(window.lists.list(window.lists.at(seconds))), moved: display.dataset.seconds !== before, time: document.getElementById("r_t").textContent, shapes };
}
const box = display.getBoundingClientRect();
document.body.dataset.seen = JSON.stringify({ seen, width: box.width, height: box.height, wide: document.documentElement.scrollWidth <= innerWidth });
</script>`;

interface Seen {
  seen: Record<string, { seconds: number; farthest: number; moved: boolean; time: string; shapes: Shape[] }>;
  width: number;
  height: number;
  wide: boolean;
}

for (const width of [1400, 800, 420])
  test(`in Chromium, ${width} wide, the display follows the cursor`, { timeout: 120_000 }, async () => {
    const of = run();
    const file = join(of.folder, "watched.html");
    const page = of.page.replace("= new DisplayLists({", "= window.lists = new DisplayLists({");
    writeFileSync(file, page.replace("<head>", `<head>${NOTES}`).replace("</body>", `${MOVES}</body>`));
    const dom = await domOf(file, "", `${width},1000`);
    const text = /data-seen="([^"]*)"/.exec(dom)?.[1]?.replaceAll("&quot;", '"').replaceAll("&amp;", "&");
    assert.ok(text !== undefined, "the page's script did not reach its end");
    const { seen, width: shown, height, wide } = JSON.parse(text) as Seen;
    const times = new Set(of.lists.times);
    for (const [name, { seconds, farthest, moved, time, shapes }] of Object.entries(seen)) {
      assert.ok(times.has(seconds), name);
      if (name !== "over time") assert.ok(moved, `${name} shows another display`);
      // A display that stayed is not painted again, and of another one only what changed.
      if (!moved) assert.equal(shapes.length, 0, name);
      else {
        const expected = of.lists.list(of.lists.at(seconds));
        for (const [colour, ...rest] of shapes)
          assert.ok(
            expected.some((shape) => isDeepStrictEqual(shape, [colour.toUpperCase(), ...rest])),
            `${name}: ${JSON.stringify([colour, ...rest])}`,
          );
      }
      // Smooth edges come out a little different by where they are cut; a shape that was missed is another colour.
      assert.ok(farthest <= 64, `${name}: ${farthest} of 255`);
      // What is on the screen is not more than the longest time without a change older than the values beside it.
      const [minutes, rest] = time.split(":").map(Number);
      const at = (minutes ?? 0) * 60 + (rest ?? 0);
      assert.equal(of.lists.at(at + 0.999) >= of.lists.at(seconds) && of.lists.at(at) <= of.lists.at(seconds), true, name);
    }
    assert.equal(seen["first display"]?.seconds, of.lists.times[0]);
    assert.equal(seen["last display"]?.seconds, of.lists.times.at(-1));
    assert.ok(Math.abs(shown / height - 4 / 3) < 0.02, `${shown} x ${height}`);
    assert.ok(wide, "nothing is wider than the window");
  });
