// Fewer lines that show the same path: lines are merged within a tolerance, and some of many passes are left out.

import type { LineArrays } from "./lines";

/** Lines that one line may replace: all of them are checked again for each further one, so the work is quadratic in this. */
const MAX_MERGED_LINES = 64;
/** A strand, the run of lines that is drawn or left out as a whole, is no longer than this, so that a path without corners has several. */
const MAX_STRAND_LINES = 2048;
/** A corner ends a strand only after this number of lines, so that a stepover does not become a strand. */
const MIN_STRAND_LINES = 8;
/** Cosine of the change of direction, 60°, from which on it is a corner. */
const CORNER_COSINE = 0.5;

/** Simplified lines, and where each strand of them begins. */
export interface PathStrands {
  lines: LineArrays;
  /** Index of the first line of each strand, ascending. */
  starts: Uint32Array;
}

/**
 * Merges consecutive lines while no end between them is further than `tolerance`, mm, from the line that replaces them. Takes
 * time proportional to the number of lines.
 */
export function strands(source: LineArrays, tolerance: number): PathStrands {
  const { points: p, count, rows } = source;
  const points = new Float32Array(6 * count);
  const sourceRows = new Uint32Array(count);
  const starts: number[] = [];
  let merged = 0;
  let linesInStrand = 0;
  for (let first = 0; first < count; ) {
    const last = lastMerged(p, count, first, tolerance * tolerance);
    const endsStrand = linesInStrand >= MAX_STRAND_LINES || (linesInStrand >= MIN_STRAND_LINES && (!follows(p, first) || isCorner(p, first)));
    if (merged === 0 || endsStrand) {
      starts.push(merged);
      linesInStrand = 0;
    }
    for (let axis = 0; axis < 3; axis++) {
      points[6 * merged + axis] = p[6 * first + axis]!;
      points[6 * merged + 3 + axis] = p[6 * last + 3 + axis]!;
    }
    sourceRows[merged++] = rows ? rows[first]! : first;
    linesInStrand += last - first + 1;
    first = last + 1;
  }
  const lines = { points: points.slice(0, 6 * merged), rows: sourceRows.slice(0, merged), count: merged };
  return { lines, starts: Uint32Array.from(starts) };
}

/** The last of the lines from `first` on that one line may replace. */
function lastMerged(p: Float32Array, count: number, first: number, squaredTolerance: number): number {
  const end = Math.min(count, first + MAX_MERGED_LINES);
  let last = first;
  while (last + 1 < end && follows(p, last + 1) && !isCorner(p, last + 1) && isNear(p, first, last + 1, squaredTolerance)) last++;
  return last;
}

/** Whether a line begins where the one before ends. */
function follows(p: Float32Array, line: number): boolean {
  const offset = 6 * line;
  return line > 0 && p[offset] === p[offset - 3] && p[offset + 1] === p[offset - 2] && p[offset + 2] === p[offset - 1];
}

/** Whether there is a corner at the start of a line. */
function isCorner(p: Float32Array, line: number): boolean {
  if (line === 0) return false;
  const offset = 6 * line;
  let dot = 0;
  let squaredBefore = 0;
  let squaredNext = 0;
  for (let axis = 0; axis < 3; axis++) {
    const before = p[offset - 3 + axis]! - p[offset - 6 + axis]!;
    const next = p[offset + 3 + axis]! - p[offset + axis]!;
    dot += before * next;
    squaredBefore += before * before;
    squaredNext += next * next;
  }
  return dot < CORNER_COSINE * Math.sqrt(squaredBefore * squaredNext);
}

/** Whether all ends between lie within the tolerance of the line from the start of `first` to the end of `last`. */
function isNear(p: Float32Array, first: number, last: number, squaredTolerance: number): boolean {
  // Scalars instead of arrays: this is the inner loop.
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
    const fraction = length > 0 ? Math.min(1, Math.max(0, (ux * vx + uy * vy + uz * vz) / length)) : 0;
    const dx = vx - fraction * ux;
    const dy = vy - fraction * uy;
    const dz = vz - fraction * uz;
    if (dx * dx + dy * dy + dz * dz > squaredTolerance) return false;
  }
  return true;
}

/** The fractional parts of its multiples are evenly distributed and coincide with no period of a path. */
const GOLDEN_RATIO = (Math.sqrt(5) - 1) / 2;

/** An evenly distributed fraction of the strands of a batch; the batches before have `strandsBefore`. */
export function someStrands({ lines, starts }: PathStrands, fraction: number, strandsBefore: number): LineArrays {
  if (fraction >= 1) return lines;
  const { points, rows, count } = lines;
  const ranges: [number, number][] = [];
  let total = 0;
  for (let strand = 0; strand < starts.length; strand++) {
    if (((strandsBefore + strand) * GOLDEN_RATIO) % 1 >= fraction) continue;
    const from = starts[strand]!;
    const to = strand + 1 < starts.length ? starts[strand + 1]! : count;
    ranges.push([from, to]);
    total += to - from;
  }
  const chosen = { points: new Float32Array(6 * total), rows: new Uint32Array(total), count: total };
  let line = 0;
  for (const [from, to] of ranges) {
    chosen.points.set(points.subarray(6 * from, 6 * to), 6 * line);
    chosen.rows.set(rows!.subarray(from, to), line);
    line += to - from;
  }
  return chosen;
}
