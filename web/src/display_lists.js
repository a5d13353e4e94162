// The display of a run, as src/run/display_lists.cpp writes it: the shapes once, and of each list what is different from the
// one before. In the report of `evc run`, and in its tests.

/** @typedef {import("./painter.js").Shape} Shape */
/** @typedef {[colour: string, stroke: number, path: string]} Form a shape without its place */

/**
 * A list is its time in seconds, and numbers: a shape of its own is its number in `shapes`, counted from 1, with its place x, y,
 * and takes the place of one of the list before; -n stands for the next n of the list before; 0, n goes on in the list
 * before n places further (or back).
 * @typedef {{ least_s: number, shapes: readonly Form[], lists: readonly (readonly number[])[] }} Written
 */

/** Whole lists are kept at every so many, so that a jump need not begin at the first. */
const KEPT_EACH = 32;

export class DisplayLists {
  /** @param {Written} written */
  constructor(written) {
    this.written = written;
    /** @type {readonly number[]} the time of each list, in seconds */
    this.times = written.lists.map((list) => list[0] ?? 0);
    /** @type {Map<number, Shape[]>} whole lists */
    this.whole = new Map();
    this.last = -1;
    /** @type {Shape[]} the list `last` */
    this.shapes = [];
  }

  /**
   * The number of the list that is on the screen at a time in seconds: the last one that is not later. -1: there is none.
   * @param {number} seconds
   * @returns {number}
   */
  at(seconds) {
    let from = 0;
    let to = this.times.length;
    while (from < to) {
      const middle = (from + to) >> 1;
      if ((this.times[middle] ?? 0) <= seconds) from = middle + 1;
      else to = middle;
    }
    return Math.max(from - 1, Math.min(0, this.times.length - 1));
  }

  /**
   * The shapes of list `number`, in drawing order.
   * @param {number} number
   * @returns {readonly Shape[]}
   */
  list(number) {
    if (number === this.last) return this.shapes;
    const kept = number - (number % KEPT_EACH);
    let from = this.last < number && this.last >= kept ? this.last : -1;
    let shapes = from < 0 ? [] : this.shapes;
    if (from < 0) {
      from = kept;
      while (from > 0 && !this.whole.has(from)) from -= KEPT_EACH;
      shapes = this.whole.get(from) ?? this.next([], from);
      this.keep(from, shapes);
    }
    while (from < number) {
      shapes = this.next(shapes, ++from);
      this.keep(from, shapes);
    }
    this.last = number;
    this.shapes = shapes;
    return shapes;
  }

  /**
   * @param {number} number
   * @param {Shape[]} shapes
   */
  keep(number, shapes) {
    if (number % KEPT_EACH === 0) this.whole.set(number, shapes);
  }

  /**
   * List `number` from the one before.
   * @param {readonly Shape[]} before
   * @param {number} number
   * @returns {Shape[]}
   */
  next(before, number) {
    const written = this.written.lists[number] ?? [];
    /** @type {Shape[]} */
    const shapes = [];
    let at = 0;
    for (let i = 1; i < written.length; ) {
      const what = written[i++] ?? 0;
      if (what < 0) {
        shapes.push(...before.slice(at, at - what));
        at -= what;
      } else if (what === 0) {
        at += written[i++] ?? 0;
      } else {
        const form = this.written.shapes[what - 1];
        if (form === undefined) throw new Error(`list ${number}: there is no shape ${what}`);
        shapes.push([...form, written[i++] ?? 0, written[i++] ?? 0]);
        ++at;
      }
    }
    return shapes;
  }
}
