// Where the differences of two programs are: lines of the text, rows of the paths, boxes in the view.

import { arcSampleCount, arcIndex, arcPoint } from "../path/arcs";
import { type Bounds, type Vec3, KNOWN_BIT } from "../path/batch";
import type { Path } from "../path/path";
import type { BlockRange, Difference } from "../protocol/messages";

/** Lines of the program that are marked: what differs may be all of a long one. */
const MAX_LINES = 10_000;
/** Ranges of rows of one difference: a loop makes one for each turn. */
const MAX_RANGES = 1_000;
/** Half of the view that shows a difference, as a multiple of its distance. */
const MARGIN_FACTOR = 2.5;
/** Half of that view is no smaller than this, mm: positions in the page have single precision. */
const MIN_HALF_SIDE_MM = 0.02;

/** The lines of a side that differ, in order, each once. */
export function differingLines(differences: Difference[], side: 0 | 1): number[] {
  const lines = new Set<number>();
  for (const { sides } of differences) {
    const { blocks, lacks } = sides[side];
    // Where it lacks what the other has, the block only says after which one that would come.
    if (!blocks || blocks.file !== 0 || lacks) continue;
    for (let line = blocks.from; line <= blocks.to && lines.size < MAX_LINES; line++) lines.add(line);
  }
  return [...lines].sort((a, b) => a - b);
}

/** The ranges of rows that blocks make. */
export function rowsOf(path: Path, { file, from, to }: BlockRange): [number, number][] {
  return rowsWhere(path, (own, line) => own === file && line >= from && line <= to);
}

/** The ranges of rows that lines of the program make. */
export function rowsOfLines(path: Path, lines: number[]): [number, number][] {
  if (lines.length === 0) return [];
  const meant = new Set(lines);
  return rowsWhere(path, (file, line) => file === 0 && meant.has(line));
}

function rowsWhere(path: Path, isMeant: (file: number, line: number) => boolean): [number, number][] {
  const ranges: [number, number][] = [];
  for (const batch of path.batches) {
    for (let at = 0; at < batch.rows; at++) {
      if (!isMeant(batch.file[at]!, batch.line[at]!)) continue;
      const row = batch.first + at;
      const last = ranges.at(-1);
      if (last && last[1] === row - 1) last[1] = row;
      else if (ranges.length < MAX_RANGES) ranges.push([row, row]);
      else return ranges;
    }
  }
  return ranges;
}

/** The box of ranges of rows, in the frame of the run, mm. */
export function boxOf(path: Path, ranges: [number, number][]): Bounds | undefined {
  const low: Vec3 = [Infinity, Infinity, Infinity];
  const high: Vec3 = [-Infinity, -Infinity, -Infinity];
  const grow = (at: ArrayLike<number>, first: number) => {
    for (let axis = 0; axis < 3; axis++) {
      const value = at[first + axis]! + path.origin[axis]!;
      low[axis] = Math.min(low[axis]!, value);
      high[axis] = Math.max(high[axis]!, value);
    }
  };
  for (const [from, to] of ranges) {
    for (let row = from; row <= to; row++) {
      const found = path.find(row);
      if (!found) break;
      const [batch, at] = found;
      if (!(batch.kind[at]! & KNOWN_BIT)) continue;
      grow(batch.points, 6 * at);
      grow(batch.points, 6 * at + 3);
      const curve = batch.curves?.get(at);
      for (let point = 0; curve && point + 2 < curve.length; point += 3) grow(curve, point);
      const arc = curve ? -1 : arcIndex(batch, at);
      const steps = arc < 0 ? 0 : arcSampleCount(batch.arcs, arc);
      for (let step = 1; step < steps; step++) grow(arcPoint(batch.arcs, arc, step / steps), 0);
    }
  }
  return low[0] <= high[0] ? { low, high } : undefined;
}

/** A box around two points in which both can be distinguished. */
export function boxAround([a, b]: [Vec3, Vec3]): Bounds {
  const distance = Math.hypot(...a.map((value, axis) => value - b[axis]!));
  const half = Math.max(MARGIN_FACTOR * distance, MIN_HALF_SIDE_MM);
  const middle = a.map((value, axis) => (value + b[axis]!) / 2);
  return { low: middle.map((value) => value - half) as Vec3, high: middle.map((value) => value + half) as Vec3 };
}

/** The box around some boxes, with no side smaller than a length. */
export function boxUnion(boxes: (Bounds | undefined)[], least: number): Bounds | undefined {
  const all = boxes.filter((box) => box !== undefined);
  if (all.length === 0) return undefined;
  const low = [0, 1, 2].map((axis) => Math.min(...all.map((box) => box.low[axis]!))) as Vec3;
  const high = [0, 1, 2].map((axis) => Math.max(...all.map((box) => box.high[axis]!))) as Vec3;
  for (let axis = 0; axis < 3; axis++) {
    const more = Math.max(0, least - (high[axis]! - low[axis]!)) / 2;
    low[axis]! -= more;
    high[axis]! += more;
  }
  return { low, high };
}

/** `line 7`, `lines 7–9`, `line 7 of another file`. */
export function linesText(blocks: BlockRange | null): string {
  if (!blocks) return "nowhere";
  const { file, from, to } = blocks;
  const lines = from === to ? `line ${from}` : `lines ${from}–${to}`;
  return file === 0 ? lines : `${lines} of another file`;
}

/** The next difference in a direction, round and round; -1: none is chosen yet, or there is none. */
export function step(chosen: number, by: 1 | -1, count: number): number {
  if (count === 0) return -1;
  if (chosen < 0) return by > 0 ? 0 : count - 1;
  return (chosen + by + count) % count;
}
