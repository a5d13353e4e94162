// The browser's own trace: what a frame costs the main thread.

interface TraceEvent {
  name: string;
  ph: string;
  pid: number;
  tid: number;
  ts: number;
  dur?: number;
  /// Time of the processor; absent where the system gives none.
  tdur?: number;
}

/// Of each frame in which the page's script drew, the time of the main thread in ms: the tasks from the one that runs
/// the script (FireAnimationFrame) up to that of the next frame; so script, style, layout and paint, and what else runs
/// there. Time of the processor where the trace has it, so that other programs on the machine do not count.
export function costsOfFrames(trace: string): number[] {
  const { traceEvents } = JSON.parse(trace) as { traceEvents: TraceEvent[] };
  const frames = traceEvents.filter((event) => event.name === "FireAnimationFrame" && event.ph === "X");
  const first = frames[0];
  if (first === undefined) return [];
  const main = traceEvents
    .filter((event) => event.pid === first.pid && event.tid === first.tid && event.ph === "X")
    .sort((a, b) => a.ts - b.ts || (b.dur ?? 0) - (a.dur ?? 0));
  // Events contain one another; the outermost ones are the tasks.
  const tasks: TraceEvent[] = [];
  let end = -Infinity;
  for (const event of main) {
    if (event.ts < end) continue;
    tasks.push(event);
    end = event.ts + (event.dur ?? 0);
  }
  const begins = frames.map((frame) => frame.ts).sort((a, b) => a - b);
  const costs: number[] = [];
  let frame = -1;
  for (const task of tasks) {
    const last = task.ts + (task.dur ?? 0);
    while (frame + 1 < begins.length && (begins[frame + 1] ?? Infinity) <= last) {
      ++frame;
      costs.push(0);
    }
    if (frame >= 0) costs[frame] = (costs[frame] ?? 0) + (task.tdur ?? task.dur ?? 0) / 1000;
  }
  // The first and the last one may be cut.
  return costs.slice(1, -1);
}

export function quantile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? NaN;
}
