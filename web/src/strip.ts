// The strip of the line: speed over position, the gradient, balise groups, the train, and what the on-board supervises.

import { lastValue, type Journey } from "./journey.js";
import { AT, POINT_SIZE, type PointField, type Scene } from "./module.js";
import { fitToPixels } from "./painter.js";

/// The colours of the strip: properties of the page's style, which has them for light and for dark surroundings.
const COLOURS = [
  "ground", "grid", "text", "line", "group", "train", "V_P", "V_SBI", "V_EBI", "SvL", "EOA", "target",
] as const;
type Colours = Record<(typeof COLOURS)[number], string>;

function coloursOf(canvas: HTMLCanvasElement): Colours {
  const style = getComputedStyle(canvas);
  return Object.fromEntries(COLOURS.map((name) => [name, style.getPropertyValue(`--strip-${name}`).trim()])) as Colours;
}

const LEFT = 46;
const BELOW = 92;
/// The supervised speeds that are drawn, the last one on top.
const CURVES = ["V_EBI", "V_SBI", "V_P"] as const;
/// What moves on the strip.
const NOW: readonly PointField[] = ["x_m", "v", "V_P", "EOA_m", "SvL_m", "target_m", "V_target"];

/// From metres and km/h to the canvas.
interface Frame {
  width: number;
  height: number;
  x(m: number): number;
  y(kmh: number): number;
  fastest: number;
}

export class Strip {
  private readonly context: CanvasRenderingContext2D;
  private colours: Colours;
  private from: number;
  private to: number;
  /// What was driven, as far as it is drawn: it only grows, until something else is to be looked at.
  private readonly driven = document.createElement("canvas");
  private drawn = { of: "", chunks: 0 };
  private shown = "";

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly scene: Scene,
  ) {
    const context = canvas.getContext("2d", { alpha: false });
    if (context === null) throw new Error("no canvas");
    this.context = context;
    this.colours = coloursOf(canvas);
    this.from = Math.min(scene.start_m - scene.train_length_m, 0);
    this.to = scene.end_m;
    canvas.addEventListener("wheel", (event) => this.zoom(event), { passive: false });
    canvas.addEventListener("dblclick", () => this.show(Math.min(scene.start_m - scene.train_length_m, 0), scene.end_m));
  }

  /// The surroundings have become light or dark: the next drawing is in their colours.
  recolour(): void {
    this.colours = coloursOf(this.canvas);
    this.drawn.of = "";
    this.shown = "";
  }

  /// The place under a pointer, in metres.
  placeAt(clientX: number): number {
    const box = this.canvas.getBoundingClientRect();
    const share = (clientX - box.left - LEFT) / Math.max(1, box.width - LEFT);
    return this.from + share * (this.to - this.from);
  }

  draw(journey: Journey): void {
    const pixels = fitToPixels(this.canvas);
    const ratio = pixels / Math.max(1, this.canvas.clientWidth);
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    const fastest = 20 * Math.ceil((Math.max(60, ...this.scene.speeds.map((s) => s[2])) + 25) / 20);
    const frame: Frame = {
      width,
      height,
      fastest,
      x: (m) => LEFT + ((m - this.from) / (this.to - this.from)) * (width - LEFT),
      y: (kmh) => (height - BELOW) * (1 - kmh / fastest) + 6,
    };
    const look = `${pixels} ${height} ${this.from} ${this.to} ${journey.branches.length}`;
    // Nothing that is as large as half a pixel has changed.
    const now = `${look} ${NOW.map((field) => this.pixelOf(frame, journey, field)).join(" ")}`;
    if (now === this.shown) return;
    this.shown = now;
    this.drawDriven(frame, journey, look, ratio);
    const c = this.context;
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.drawImage(this.driven, 0, 0);
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.drawNow(frame, journey);
  }

  private pixelOf(f: Frame, journey: Journey, field: PointField): number {
    const value = lastValue(journey.points, field) ?? NaN;
    return Math.round(2 * (field === "v" || field.startsWith("V_") ? f.y(value) : f.x(value)));
  }

  /// The line and the curves, in a canvas of their own: all of it when the look changes, else what has come.
  private drawDriven(f: Frame, journey: Journey, look: string, ratio: number): void {
    const { points } = journey;
    const c = this.driven.getContext("2d", { alpha: false });
    if (c === null) throw new Error("no canvas");
    if (this.drawn.of !== look || this.drawn.chunks > points.length) {
      this.driven.width = this.canvas.width;
      this.driven.height = this.canvas.height;
      c.setTransform(ratio, 0, 0, ratio, 0, 0);
      c.fillStyle = this.colours.ground;
      c.fillRect(0, 0, f.width, f.height);
      this.drawGrid(c, f);
      this.drawTrack(c, f);
      for (const branch of journey.branches) drawCurve(c, f, branch.points, "v", branch.colour, 1, branch.from);
      this.drawn = { of: look, chunks: 0 };
    }
    // One cycle before what has come, so that the lines join.
    const chunks = points.slice(Math.max(0, this.drawn.chunks - 1));
    const known = points[this.drawn.chunks - 1];
    const skip = known === undefined ? 0 : known.length / POINT_SIZE - 1;
    for (const field of CURVES) drawCurve(c, f, chunks, field, this.colours[field], 1, skip);
    drawCurve(c, f, chunks, "v", journey.colour, 2, skip);
    this.drawn.chunks = points.length;
  }

  private show(from: number, to: number): void {
    this.from = from;
    this.to = to;
  }

  private zoom(event: WheelEvent): void {
    event.preventDefault();
    const at = this.placeAt(event.clientX);
    const factor = Math.exp(event.deltaY / 500);
    const length = Math.min((this.to - this.from) * factor, 2 * (this.scene.end_m - this.scene.start_m));
    if (length < 200) return;
    const share = (at - this.from) / (this.to - this.from);
    this.show(at - share * length, at + (1 - share) * length);
  }

  private drawGrid(c: CanvasRenderingContext2D, f: Frame): void {
    c.font = "11px sans-serif";
    c.fillStyle = this.colours.text;
    c.strokeStyle = this.colours.grid;
    c.lineWidth = 1;
    c.beginPath();
    c.textAlign = "right";
    for (let v = 0; v <= f.fastest; v += 20) {
      c.moveTo(LEFT, f.y(v));
      c.lineTo(f.width, f.y(v));
      if (v % 40 === 0) c.fillText(`${v}`, LEFT - 6, f.y(v) + 4);
    }
    c.stroke();
    c.fillText("km/h", LEFT - 6, f.y(f.fastest) + 16);
    c.textAlign = "center";
    const step = niceStep((this.to - this.from) / Math.max(2, f.width / 90));
    // A number whose end would be beyond the strip is left out.
    for (let m = Math.ceil(this.from / step) * step; f.x(m) < f.width - 16; m += step)
      c.fillText(step >= 1000 ? `${m / 1000} km` : `${(m / 1000).toFixed(step >= 100 ? 1 : 2)} km`, f.x(m), f.height - 4);
  }

  /// The gradient as its course of height, with its figures, and the balise groups.
  private drawTrack(c: CanvasRenderingContext2D, f: Frame): void {
    const base = f.height - 46;
    let height = 0;
    let top = 1;
    const course: [number, number][] = [];
    for (const [from, to, permille] of this.scene.gradient) {
      course.push([from, height]);
      height += ((to - from) * permille) / 1000;
      course.push([to, height]);
      top = Math.max(top, Math.abs(height));
    }
    c.strokeStyle = this.colours.line;
    c.lineWidth = 2;
    c.beginPath();
    for (const [m, h] of course) c.lineTo(f.x(m), base - (h / top) * 16);
    if (course.length === 0) {
      c.moveTo(LEFT, base);
      c.lineTo(f.width, base);
    }
    c.stroke();
    c.fillStyle = this.colours.text;
    c.font = "10px sans-serif";
    c.textAlign = "center";
    for (const [from, to, permille] of this.scene.gradient)
      if (f.x(to) - f.x(from) > 26) c.fillText(`${permille > 0 ? "+" : ""}${permille} ‰`, f.x((from + to) / 2), base + 22);
    c.fillStyle = this.colours.group;
    for (const m of this.scene.groups) {
      c.beginPath();
      c.moveTo(f.x(m) - 3, f.height - 60 + 46);
      c.lineTo(f.x(m) + 3, f.height - 60 + 46);
      c.lineTo(f.x(m), f.height - 66 + 46);
      c.fill();
    }
    // The speeds of the line.
    c.strokeStyle = this.colours.line;
    c.setLineDash([4, 3]);
    c.lineWidth = 1;
    c.beginPath();
    for (const [from, to, kmh] of this.scene.speeds) {
      c.moveTo(f.x(from), f.y(kmh));
      c.lineTo(f.x(to), f.y(kmh));
    }
    c.stroke();
    c.setLineDash([]);
  }

  /// The train, and the ends of its authority.
  private drawNow(f: Frame, journey: Journey): void {
    const chunk = journey.points[journey.points.length - 1];
    if (chunk === undefined) return;
    const value = (field: PointField): number => chunk[chunk.length - POINT_SIZE + AT[field]] ?? NaN;
    const c = this.context;
    const front = value("x_m");
    const base = f.height - 36;
    c.fillStyle = this.colours.train;
    const rear = f.x(front - this.scene.train_length_m);
    c.fillRect(Math.min(rear, f.x(front) - 6), base - 26, Math.max(6, f.x(front) - rear), 6);
    c.strokeStyle = this.colours.train;
    c.beginPath();
    c.moveTo(f.x(front), 4);
    c.lineTo(f.x(front), base - 20);
    c.globalAlpha = 0.35;
    c.stroke();
    c.globalAlpha = 1;
    this.mark(f, value("SvL_m"), this.colours.SvL, "SvL");
    this.mark(f, value("EOA_m"), this.colours.EOA, "EOA");
    const target = value("target_m");
    if (!Number.isNaN(target)) {
      const speed = value("V_target");
      c.fillStyle = this.colours.target;
      c.beginPath();
      c.arc(f.x(target), f.y(Number.isNaN(speed) ? 0 : speed), 4, 0, 2 * Math.PI);
      c.fill();
    }
  }

  private mark(f: Frame, m: number, colour: string, label: string): void {
    if (Number.isNaN(m)) return;
    const c = this.context;
    c.strokeStyle = colour;
    c.fillStyle = colour;
    c.setLineDash([2, 3]);
    c.beginPath();
    // Below both labels: EOA and SvL are often near.
    c.moveTo(f.x(m), 30);
    c.lineTo(f.x(m), f.height - 56);
    c.stroke();
    c.setLineDash([]);
    c.textAlign = "center";
    c.fillText(label, f.x(m), label === "EOA" ? 14 : 26);
  }
}

/// A field over the position, from a cycle on. Cycles on the same pixel are one point.
function drawCurve(
  c: CanvasRenderingContext2D, f: Frame, chunks: readonly Float64Array[], field: PointField, colour: string, line: number, from: number,
): void {
  c.save();
  c.beginPath();
  c.rect(LEFT, 0, f.width - LEFT, f.height - BELOW + 8);
  c.clip();
  c.strokeStyle = colour;
  c.lineWidth = line;
  c.beginPath();
  let drawing = false;
  let lastX = NaN;
  let cycle = 0;
  const last = chunks.reduce((sum, chunk) => sum + chunk.length / POINT_SIZE, 0) - 1;
  for (const chunk of chunks)
    for (let i = 0; i < chunk.length; i += POINT_SIZE, ++cycle) {
      if (cycle < from) continue;
      const value = chunk[i + AT[field]] ?? NaN;
      const x = f.x(chunk[i + AT.x_m] ?? 0);
      if (Number.isNaN(value)) {
        drawing = false;
        continue;
      }
      if (drawing && Math.abs(x - lastX) < 0.4 && cycle % 16 !== 0 && cycle !== last) continue;
      if (drawing) c.lineTo(x, f.y(value));
      else c.moveTo(x, f.y(value));
      drawing = true;
      lastX = x;
    }
  c.stroke();
  c.restore();
}

/// 1, 2 or 5 times a power of ten, at least `least`.
export function niceStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(Math.max(least, 1)));
  for (const factor of [1, 2, 5]) if (factor * power >= least) return factor * power;
  return 10 * power;
}
