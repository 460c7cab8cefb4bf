// Fewer lines that show the same path: lines are joined within a tolerance, and of many passes some are left out.

import type { LineArrays } from "./lines";

/** Lines that one line may replace: each is checked again whenever one more is tried. */
const MAX_MERGED_LINES = 64;
/** Lines of a strand at most, so that a path without corners has strands to choose from, too. */
const MAX_STRAND_LINES = 2048;
/** A corner ends a strand only after so many lines: a step over to the next pass is no strand of its own. */
const MIN_STRAND_LINES = 8;
/** Cosine of the turn at which a strand ends. */
const CORNER_COSINE = 0.5;

/** Simplified lines, and where each strand of them begins: at a corner or a gap. */
export interface PathStrands {
  lines: LineArrays;
  /** Numbers of the first lines, in order. */
  starts: Uint32Array;
}

/**
 * Joins lines that follow on each other while no end between is further than `tolerance`, mm, from
 * the line that replaces them. The time is proportional to the number of lines.
 */
export function strands(source: LineArrays, tolerance: number): PathStrands {
  const { points: p, count, rows } = source;
  const points = new Float32Array(6 * count);
  const own = new Uint32Array(count);
  const starts: number[] = [];
  let made = 0;
  let inStrand = 0;
  for (let first = 0; first < count; ) {
    const last = lastJoined(p, count, first, tolerance * tolerance);
    const ends = inStrand >= MAX_STRAND_LINES || (inStrand >= MIN_STRAND_LINES && (!follows(p, first) || isCorner(p, first)));
    if (made === 0 || ends) {
      starts.push(made);
      inStrand = 0;
    }
    for (let axis = 0; axis < 3; axis++) {
      points[6 * made + axis] = p[6 * first + axis]!;
      points[6 * made + 3 + axis] = p[6 * last + 3 + axis]!;
    }
    own[made++] = rows ? rows[first]! : first;
    inStrand += last - first + 1;
    first = last + 1;
  }
  const lines = { points: points.slice(0, 6 * made), rows: own.slice(0, made), count: made };
  return { lines, starts: Uint32Array.from(starts) };
}

/** The last line that the one from the start of `first` may replace. */
function lastJoined(p: Float32Array, count: number, first: number, square: number): number {
  const most = Math.min(count, first + MAX_MERGED_LINES);
  let last = first;
  while (last + 1 < most && follows(p, last + 1) && !isCorner(p, last + 1) && isNear(p, first, last + 1, square)) last++;
  return last;
}

/** Whether a line begins where the one before ends. */
function follows(p: Float32Array, line: number): boolean {
  const at = 6 * line;
  return line > 0 && p[at] === p[at - 3] && p[at + 1] === p[at - 2] && p[at + 2] === p[at - 1];
}

/** Whether the path turns sharply into a line. */
function isCorner(p: Float32Array, line: number): boolean {
  if (line === 0) return false;
  const at = 6 * line;
  let dot = 0;
  let one = 0;
  let two = 0;
  for (let axis = 0; axis < 3; axis++) {
    const before = p[at - 3 + axis]! - p[at - 6 + axis]!;
    const next = p[at + 3 + axis]! - p[at + axis]!;
    dot += before * next;
    one += before * before;
    two += next * next;
  }
  return dot < CORNER_COSINE * Math.sqrt(one * two);
}

/** Whether all ends between lie near the line from the start of `first` to the end of `last`. */
function isNear(p: Float32Array, first: number, last: number, square: number): boolean {
  // Names of their own, not arrays: this is where the time goes.
  const x = p[6 * first]!;
  const y = p[6 * first + 1]!;
  const z = p[6 * first + 2]!;
  const ux = p[6 * last + 3]! - x;
  const uy = p[6 * last + 4]! - y;
  const uz = p[6 * last + 5]! - z;
  const length = ux * ux + uy * uy + uz * uz;
  for (let line = first; line < last; line++) {
    const vx = p[6 * line + 3]! - x;
    const vy = p[6 * line + 4]! - y;
    const vz = p[6 * line + 5]! - z;
    const share = length > 0 ? Math.min(1, Math.max(0, (ux * vx + uy * vy + uz * vz) / length)) : 0;
    const dx = vx - share * ux;
    const dy = vy - share * uy;
    const dz = vz - share * uz;
    if (dx * dx + dy * dy + dz * dz > square) return false;
  }
  return true;
}

/** The golden ratio: its multiples lie evenly, and fall in step with no pattern of a path. */
const GOLDEN_RATIO = (Math.sqrt(5) - 1) / 2;

/** A share of the strands; `before` of them were in the parts of the path before. */
export function someStrands({ lines, starts }: PathStrands, share: number, before: number): LineArrays {
  if (share >= 1) return lines;
  const { points, rows, count } = lines;
  const ranges: [number, number][] = [];
  let total = 0;
  for (let strand = 0; strand < starts.length; strand++) {
    if (((before + strand) * GOLDEN_RATIO) % 1 >= share) continue;
    const from = starts[strand]!;
    const to = strand + 1 < starts.length ? starts[strand + 1]! : count;
    ranges.push([from, to]);
    total += to - from;
  }
  const some = { points: new Float32Array(6 * total), rows: new Uint32Array(total), count: total };
  let at = 0;
  for (const [from, to] of ranges) {
    some.points.set(points.subarray(6 * from, 6 * to), 6 * at);
    some.rows.set(rows!.subarray(from, to), at);
    at += to - from;
  }
  return some;
}
