// The display on a canvas: shapes in cells of 640 x 480. Symbols and letters are outlines, so they look as in the pictures of
// `evc dmi`. The page of `evc cab` and the report of `evc run` have this same source; a report is made without node, so it is
// no TypeScript, and types are in comments.

/**
 * Colour, width of the line (0: filled), path as in SVG counted from its begin, and where that is.
 * @typedef {[colour: string, stroke: number, path: string, x: number, y: number]} Shape
 */

export const CELLS = Object.freeze({ width: 640, height: 480 });

export class Painter {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    const context = canvas.getContext("2d", { alpha: false });
    if (context === null) throw new Error("no canvas");
    this.canvas = canvas;
    this.context = context;
    /** @type {Map<string, Path2D>} */
    this.paths = new Map();
  }

  /** @param {readonly Shape[]} shapes */
  paint(shapes) {
    const scale = fitToPixels(this.canvas) / CELLS.width;
    for (const [colour, stroke, path, x, y] of shapes) {
      this.context.setTransform(scale, 0, 0, scale, x * scale, y * scale);
      const outline = this.pathOf(path);
      if (stroke === 0) {
        this.context.fillStyle = colour;
        this.context.fill(outline);
      } else {
        this.context.strokeStyle = colour;
        this.context.lineWidth = stroke;
        this.context.stroke(outline);
      }
    }
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
   * @param {string} path
   * @returns {Path2D}
   */
  pathOf(path) {
    let known = this.paths.get(path);
    if (known === undefined) {
      // Most shapes return; a moving pointer does not.
      if (this.paths.size > 4000) this.paths.clear();
      known = new Path2D(path);
      this.paths.set(path, known);
    }
    return known;
  }
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
