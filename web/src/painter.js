// The display on a canvas: shapes in cells of 640 x 480. Symbols and letters are outlines, so they look as in the pictures of
// `evc dmi`. The page of `evc cab` and the report of `evc run` have this same source; a report is made without node, so it is
// no TypeScript, and types are in comments.

/**
 * Colour, width of the line (0: filled), path as in SVG counted from its begin, and where that is.
 * @typedef {[colour: string, stroke: number, path: string, x: number, y: number]} Shape
 */

/**
 * @typedef {{ left: number, top: number, right: number, bottom: number }} Box
 * @typedef {{ path: Path2D, box: Box, number: number }} Outline a path, where it is, and a number for it
 * @typedef {{ shape: Shape, outline: Outline, cells: Box, key: string }} Painted `key` is that of the same shape alone
 */

export const CELLS = Object.freeze({ width: 640, height: 480 });

export class Painter {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    const context = canvas.getContext("2d", { alpha: false });
    if (context === null) throw new Error("no canvas");
    this.canvas = canvas;
    this.context = context;
    /** @type {Map<string, Outline>} */
    this.outlines = new Map();
    this.outlinesMade = 0;
    /** @type {readonly Painted[]} what the canvas shows */
    this.painted = [];
  }

  /**
   * Paints what is different from what the canvas shows: from one cycle to the next that is little.
   * @param {readonly Shape[]} shapes
   */
  paint(shapes) {
    const { canvas } = this;
    const [width, height] = [canvas.width, canvas.height];
    const scale = fitToPixels(canvas) / CELLS.width;
    const before = canvas.width === width && canvas.height === height ? this.painted : [];
    this.painted = shapes.map((shape) => this.paintedOf(shape));
    for (const box of changed(before, this.painted, scale)) this.paintIn(box, scale);
  }

  /**
   * @param {Box} box in pixels: no pixel is cut, so that its edges cannot be seen
   * @param {number} scale
   */
  paintIn(box, scale) {
    const c = this.context;
    c.save();
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.beginPath();
    c.rect(box.left, box.top, box.right - box.left, box.bottom - box.top);
    c.clip();
    for (const { shape, outline, cells } of this.painted) {
      if (!meet(pixelsOf(cells, scale), box)) continue;
      const [colour, stroke, , x, y] = shape;
      c.setTransform(scale, 0, 0, scale, x * scale, y * scale);
      if (stroke === 0) {
        c.fillStyle = colour;
        c.fill(outline.path);
      } else {
        c.strokeStyle = colour;
        c.lineWidth = stroke;
        c.stroke(outline.path);
      }
    }
    c.restore();
  }

  /**
   * The cell under a pointer.
   * @param {PointerEvent} event
   * @returns {{ x: number, y: number }}
   */
  cellOf(event) {
    const box = this.canvas.getBoundingClientRect();
    return {
      x: Math.floor(((event.clientX - box.left) / box.width) * CELLS.width),
      y: Math.floor(((event.clientY - box.top) / box.height) * CELLS.height),
    };
  }

  /**
   * @param {Shape} shape
   * @returns {Painted}
   */
  paintedOf(shape) {
    const [colour, stroke, path, x, y] = shape;
    const outline = this.outlineOf(path);
    const { left, top, right, bottom } = outline.box;
    // A corner of a line reaches out by up to ten times half its width (the limit of the canvas).
    const around = 5 * stroke;
    return {
      shape,
      outline,
      cells: { left: left + x - around, top: top + y - around, right: right + x + around, bottom: bottom + y + around },
      key: `${outline.number} ${colour} ${stroke} ${x} ${y}`,
    };
  }

  /**
   * @param {string} path
   * @returns {Outline}
   */
  outlineOf(path) {
    let known = this.outlines.get(path);
    if (known === undefined) {
      // Most shapes return; a moving pointer does not.
      if (this.outlines.size > 4000) this.outlines.clear();
      known = { path: new Path2D(path), box: boxOf(path), number: ++this.outlinesMade };
      this.outlines.set(path, known);
    }
    return known;
  }
}

/**
 * The points of a path, also those that only bend its curves, are in this box.
 * @param {string} path
 * @returns {Box}
 */
function boxOf(path) {
  const numbers = (path.match(/-?[\d.]+/g) ?? []).map(Number);
  const xs = numbers.filter((_, n) => n % 2 === 0);
  const ys = numbers.filter((_, n) => n % 2 === 1);
  return { left: Math.min(...xs), top: Math.min(...ys), right: Math.max(...xs), bottom: Math.max(...ys) };
}

/**
 * Whole pixels, with those that only a part of is painted.
 * @param {Box} cells
 * @param {number} scale
 * @returns {Box}
 */
function pixelsOf(cells, scale) {
  return {
    left: Math.floor(cells.left * scale) - 1,
    top: Math.floor(cells.top * scale) - 1,
    right: Math.ceil(cells.right * scale) + 1,
    bottom: Math.ceil(cells.bottom * scale) + 1,
  };
}

/**
 * @param {Box} a
 * @param {Box} b
 */
function meet(a, b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/**
 * Where two drawings differ: boxes that do not meet. Shapes that are in both lie over one another in the same order, or
 * everything differs.
 * @param {readonly Painted[]} before
 * @param {readonly Painted[]} after
 * @param {number} scale
 * @returns {Box[]}
 */
function changed(before, after, scale) {
  const all = pixelsOf({ left: 0, top: 0, right: CELLS.width, bottom: CELLS.height }, scale);
  const [goneOrStays, newOrStays] = [splitBy(before, after), splitBy(after, before)];
  const sameOrder = goneOrStays.stay.every(({ key }, n) => key === newOrStays.stay[n]?.key);
  if (!sameOrder || goneOrStays.stay.length !== newOrStays.stay.length || before.length === 0) return [all];
  /** @type {Box[]} */
  const boxes = [];
  for (const { cells } of [...goneOrStays.other, ...newOrStays.other]) {
    let box = pixelsOf(cells, scale);
    // Joined with those that it meets, until it meets none.
    for (let at = boxes.findIndex((b) => meet(b, box)); at >= 0; at = boxes.findIndex((b) => meet(b, box))) {
      const [other] = boxes.splice(at, 1);
      if (other !== undefined) box = joined(box, other);
    }
    boxes.push(box);
  }
  return boxes;
}

/**
 * @param {Box} a
 * @param {Box} b
 * @returns {Box}
 */
function joined(a, b) {
  return {
    left: Math.min(a.left, b.left),
    top: Math.min(a.top, b.top),
    right: Math.max(a.right, b.right),
    bottom: Math.max(a.bottom, b.bottom),
  };
}

/**
 * Those of a list that another one has too, and the others; a shape that is there twice counts twice.
 * @param {readonly Painted[]} list
 * @param {readonly Painted[]} another
 */
function splitBy(list, another) {
  /** @type {Map<string, number>} */
  const counts = new Map();
  for (const { key } of another) counts.set(key, (counts.get(key) ?? 0) + 1);
  /** @type {{ stay: Painted[], other: Painted[] }} */
  const split = { stay: [], other: [] };
  for (const painted of list) {
    const left = counts.get(painted.key) ?? 0;
    if (left > 0) counts.set(painted.key, left - 1);
    (left > 0 ? split.stay : split.other).push(painted);
  }
  return split;
}

/**
 * Gives the canvas one pixel of its own for each of the screen; its width in them.
 * @param {HTMLCanvasElement} canvas
 * @returns {number}
 */
export function fitToPixels(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  const height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  return width;
}
