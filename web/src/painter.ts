// The display on a canvas: shapes in cells of 640 x 480, as the module draws them. Symbols and letters are outlines, so
// they look as in the pictures of `evc dmi`.

import type { Shape } from "./module.js";

export const CELLS = { width: 640, height: 480 } as const;

export class Painter {
  private readonly context: CanvasRenderingContext2D;
  private readonly paths = new Map<string, Path2D>();

  constructor(private readonly canvas: HTMLCanvasElement) {
    const context = canvas.getContext("2d", { alpha: false });
    if (context === null) throw new Error("no canvas");
    this.context = context;
  }

  paint(shapes: readonly Shape[]): void {
    const scale = fitToPixels(this.canvas) / CELLS.width;
    this.context.setTransform(scale, 0, 0, scale, 0, 0);
    for (const [colour, stroke, path] of shapes) {
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

  /// The cell under a pointer.
  cellOf(event: PointerEvent): { x: number; y: number } {
    const box = this.canvas.getBoundingClientRect();
    return {
      x: Math.floor(((event.clientX - box.left) / box.width) * CELLS.width),
      y: Math.floor(((event.clientY - box.top) / box.height) * CELLS.height),
    };
  }

  private pathOf(path: string): Path2D {
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

/// Gives the canvas one pixel of its own for each of the screen; its width in them.
export function fitToPixels(canvas: HTMLCanvasElement): number {
  const ratio = window.devicePixelRatio || 1;
  const width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  const height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  return width;
}
