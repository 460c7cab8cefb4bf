// Where the differences of two programs are: lines of the text, rows of the paths, boxes in the view.

import { arcSampleCount, arcIndex, arcPoint } from "../path/arcs";
import { type Bounds, type Vec3, KNOWN_BIT } from "../path/batch";
import type { Path } from "../path/path";
import type { BlockRange, Difference } from "../protocol/messages";

/** Lines that are marked at most: all lines of a long program may differ. */
const MAX_LINES = 10_000;
/** Ranges of rows of one difference at most: a loop makes one for each iteration. */
const MAX_RANGES = 1_000;
/** Half the side of the box around a difference, as a multiple of its distance. */
const MARGIN_FACTOR = 2.5;
/** The smallest half side of that box, mm: positions in the page have single precision. */
const MIN_HALF_SIDE_MM = 0.02;

/** The lines of a side that differ, ascending. */
export function differingLines(differences: Difference[], side: 0 | 1): number[] {
  const lines = new Set<number>();
  for (const { sides } of differences) {
    const { blocks, lacks } = sides[side];
    // Where it lacks what the other has, `blocks` is only the block after which that would come.
    if (!blocks || blocks.file !== 0 || lacks) continue;
    for (let line = blocks.from; line <= blocks.to && lines.size < MAX_LINES; line++) lines.add(line);
  }
  return [...lines].sort((a, b) => a - b);
}

/** The ranges of rows of blocks, first and last row each. */
export function rowsOf(path: Path, { file, from, to }: BlockRange): [number, number][] {
  return rowsWhere(path, (rowFile, line) => rowFile === file && line >= from && line <= to);
}

/** The ranges of rows of lines of the program. */
export function rowsOfLines(path: Path, lines: number[]): [number, number][] {
  if (lines.length === 0) return [];
  const chosen = new Set(lines);
  return rowsWhere(path, (file, line) => file === 0 && chosen.has(line));
}

function rowsWhere(path: Path, isIncluded: (file: number, line: number) => boolean): [number, number][] {
  const ranges: [number, number][] = [];
  for (const batch of path.batches) {
    for (let index = 0; index < batch.rows; index++) {
      if (!isIncluded(batch.file[index]!, batch.line[index]!)) continue;
      const row = batch.first + index;
      const last = ranges.at(-1);
      if (last && last[1] === row - 1) last[1] = row;
      else if (ranges.length < MAX_RANGES) ranges.push([row, row]);
      else return ranges;
    }
  }
  return ranges;
}

/** The box of the drawn rows in ranges, in the frame of the run, mm; undefined where there are none. */
export function boxOf(path: Path, ranges: [number, number][]): Bounds | undefined {
  const low: Vec3 = [Infinity, Infinity, Infinity];
  const high: Vec3 = [-Infinity, -Infinity, -Infinity];
  const include = (points: ArrayLike<number>, offset: number) => {
    for (let axis = 0; axis < 3; axis++) {
      const value = points[offset + axis]! + path.origin[axis]!;
      low[axis] = Math.min(low[axis]!, value);
      high[axis] = Math.max(high[axis]!, value);
    }
  };
  for (const [from, to] of ranges) {
    for (let row = from; row <= to; row++) {
      const found = path.find(row);
      if (!found) break;
      const [batch, index] = found;
      if (!(batch.kind[index]! & KNOWN_BIT)) continue;
      include(batch.points, 6 * index);
      include(batch.points, 6 * index + 3);
      const curve = batch.curves?.get(index);
      for (let offset = 0; curve && offset + 2 < curve.length; offset += 3) include(curve, offset);
      const arc = curve ? -1 : arcIndex(batch, index);
      const steps = arc < 0 ? 0 : arcSampleCount(batch.arcs, arc);
      for (let step = 1; step < steps; step++) include(arcPoint(batch.arcs, arc, step / steps), 0);
    }
  }
  return low[0] <= high[0] ? { low, high } : undefined;
}

/** A cube around two points, large enough for both to be distinguished. */
export function boxAround([a, b]: [Vec3, Vec3]): Bounds {
  const distance = Math.hypot(...a.map((value, axis) => value - b[axis]!));
  const half = Math.max(MARGIN_FACTOR * distance, MIN_HALF_SIDE_MM);
  const middle = a.map((value, axis) => (value + b[axis]!) / 2);
  return { low: middle.map((value) => value - half) as Vec3, high: middle.map((value) => value + half) as Vec3 };
}

/** The box around several boxes, with no side shorter than `minSide`; undefined where there are none. */
export function boxUnion(boxes: (Bounds | undefined)[], minSide: number): Bounds | undefined {
  const all = boxes.filter((box) => box !== undefined);
  if (all.length === 0) return undefined;
  const low = [0, 1, 2].map((axis) => Math.min(...all.map((box) => box.low[axis]!))) as Vec3;
  const high = [0, 1, 2].map((axis) => Math.max(...all.map((box) => box.high[axis]!))) as Vec3;
  for (let axis = 0; axis < 3; axis++) {
    const margin = Math.max(0, minSide - (high[axis]! - low[axis]!)) / 2;
    low[axis]! -= margin;
    high[axis]! += margin;
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

/** The index of the next difference in a direction, cyclically; -1 where there is none. `chosen` is -1 before the first step. */
export function step(chosen: number, by: 1 | -1, count: number): number {
  if (count === 0) return -1;
  if (chosen < 0) return by > 0 ? 0 : count - 1;
  return (chosen + by + count) % count;
}
