// Line segments for the graphics card: pairs of points, and the row of each pair. Arcs are divided into chords as fine as
// the view needs; a straight path is drawn from the array that the server sent.

import { arcIndex, arcChordCount, arcPoint } from "./arcs";
import { type Batch, KNOWN_BIT, RAPID, kindOf } from "./batch";

/** Line segments: both ends, six numbers each, relative to the origin, mm. */
export interface LineArrays {
  points: Float32Array;
  /** The row of each segment, as an index in its batch; undefined where segment n is row n. */
  rows: Uint32Array | undefined;
  count: number;
}

export interface DrawnLines {
  cuts: LineArrays;
  rapids: LineArrays;
}

/** How far the chords of an arc may be from it, mm. */
export type ArcTolerance = (arcs: Float32Array, index: number) => number;

/** Whether a row of a batch is shown. */
export type RowFilter = (row: number) => boolean;

/** The segments of a batch's cuts and rapids, of the rows that pass `filter`. */
export function linesOf(batch: Batch, tolerance: ArcTolerance, filter?: RowFilter): DrawnLines {
  const { rows, kind, arcRows, arcs, points } = batch;
  const chords = new Uint32Array(arcRows.length);
  const isShown = (row: number) => (kind[row]! & KNOWN_BIT) !== 0 && (!filter || filter(row));
  /** Segments beyond one for each row. */
  let extra = 0;
  for (let arc = 0; arc < arcRows.length; arc++) {
    chords[arc] = arcChordCount(arcs, arc, tolerance(arcs, arc));
    extra += chords[arc]! - 1;
  }
  const curves = batch.curves;
  for (const [row, curve] of curves ?? []) if (isShown(row)) extra += curve.length / 3 - 2;
  let rapids = 0;
  let hidden = 0;
  for (let row = 0; row < rows; row++) {
    if (!isShown(row)) hidden++;
    else if (kindOf(kind[row]!) === RAPID) rapids++;
  }
  if (rapids === 0 && hidden === 0 && arcRows.length === 0 && !curves?.size) {
    return { cuts: { points, rows: undefined, count: rows }, rapids: new SegmentList(0).lines() };
  }
  const cut = new SegmentList(rows - rapids - hidden + extra);
  const rapid = new SegmentList(rapids + extra);
  let arc = 0;
  for (let row = 0; row < rows; row++) {
    const isArc = arc < arcRows.length && arcRows[arc] === row;
    const curve = curves?.get(row);
    if (curve && isShown(row)) (kindOf(kind[row]!) === RAPID ? rapid : cut).curve(curve, row);
    else if (isShown(row)) {
      if (isArc) cut.arc(batch, row, arc, chords[arc]!);
      else (kindOf(kind[row]!) === RAPID ? rapid : cut).row(points, row);
    }
    if (isArc) arc++;
  }
  return { cuts: cut.lines(), rapids: rapid.lines() };
}

/** Segments that are added row by row, with room for `size` of them. */
class SegmentList {
  private points: Float32Array;
  private rows: Uint32Array;
  private count = 0;

  constructor(size: number) {
    this.points = new Float32Array(6 * size);
    this.rows = new Uint32Array(size);
  }

  row(points: Float32Array, row: number): void {
    this.points.set(points.subarray(6 * row, 6 * row + 6), 6 * this.count);
    this.rows[this.count++] = row;
  }

  curve(curve: Float32Array, row: number): void {
    for (let offset = 0; offset + 6 <= curve.length; offset += 3) {
      this.points.set(curve.subarray(offset, offset + 6), 6 * this.count);
      this.rows[this.count++] = row;
    }
  }

  arc(batch: Batch, row: number, arc: number, chords: number): void {
    const { points, arcs } = batch;
    let from = [points[6 * row]!, points[6 * row + 1]!, points[6 * row + 2]!];
    for (let chord = 1; chord <= chords; chord++) {
      // The last end is that of the row, free of the rounding of the arc.
      const to =
        chord === chords
          ? [points[6 * row + 3]!, points[6 * row + 4]!, points[6 * row + 5]!]
          : arcPoint(arcs, arc, chord / chords);
      this.points.set(from, 6 * this.count);
      this.points.set(to, 6 * this.count + 3);
      this.rows[this.count++] = row;
      from = to;
    }
  }

  lines(): LineArrays {
    const { count } = this;
    return {
      points: this.points.subarray(0, 6 * count),
      rows: this.rows.subarray(0, count),
      count,
    };
  }
}

/** The segments of the drawn rows from `from` to `to` of a batch, both included: six numbers each. */
export function segmentsOfRows(batch: Batch, from: number, to: number, tolerance: ArcTolerance): number[] {
  const points: number[] = [];
  for (let row = from; row <= to; row++) {
    if (!(batch.kind[row]! & KNOWN_BIT)) continue;
    const curve = batch.curves?.get(row);
    if (curve) {
      for (let offset = 0; offset + 6 <= curve.length; offset += 3) points.push(...curve.subarray(offset, offset + 6));
      continue;
    }
    const arc = arcIndex(batch, row);
    const p = batch.points;
    if (arc < 0) {
      points.push(...p.subarray(6 * row, 6 * row + 6));
      continue;
    }
    const chords = arcChordCount(batch.arcs, arc, tolerance(batch.arcs, arc));
    let before = [p[6 * row]!, p[6 * row + 1]!, p[6 * row + 2]!];
    for (let chord = 1; chord <= chords; chord++) {
      const next =
        chord === chords
          ? [p[6 * row + 3]!, p[6 * row + 4]!, p[6 * row + 5]!]
          : arcPoint(batch.arcs, arc, chord / chords);
      points.push(...before, ...next);
      before = next;
    }
  }
  return points;
}

/**
 * The segment nearest to a point (`x`, `y`) on a canvas of `width` times `height`, all in pixels, no further away than `reach`;
 * undefined where there is none. `matrix` (column-major) takes points to normalized device coordinates, without perspective.
 */
export function nearestSegment(
  lines: LineArrays,
  matrix: ArrayLike<number>,
  width: number,
  height: number,
  x: number,
  y: number,
  reach: number,
): { index: number; distance: number; fraction: number } | undefined {
  const m = matrix;
  const p = lines.points;
  // To pixels: x grows to the right, y downwards.
  const [ax, bx, cx, dx] = [m[0]!, m[4]!, m[8]!, m[12]!].map((v, i) => ((i === 3 ? v + 1 : v) * width) / 2) as [number, number, number, number];
  const [ay, by, cy, dy] = [m[1]!, m[5]!, m[9]!, m[13]!].map((v, i) => ((i === 3 ? 1 - v : -v) * height) / 2) as [number, number, number, number];
  let best: { index: number; distance: number; fraction: number } | undefined;
  let limit = reach * reach;
  for (let index = 0; index < lines.count; index++) {
    const offset = 6 * index;
    const x0 = ax * p[offset]! + bx * p[offset + 1]! + cx * p[offset + 2]! + dx - x;
    const y0 = ay * p[offset]! + by * p[offset + 1]! + cy * p[offset + 2]! + dy - y;
    const ex = ax * (p[offset + 3]! - p[offset]!) + bx * (p[offset + 4]! - p[offset + 1]!) + cx * (p[offset + 5]! - p[offset + 2]!);
    const ey = ay * (p[offset + 3]! - p[offset]!) + by * (p[offset + 4]! - p[offset + 1]!) + cy * (p[offset + 5]! - p[offset + 2]!);
    const square = ex * ex + ey * ey;
    const fraction = square > 0 ? Math.min(1, Math.max(0, -(x0 * ex + y0 * ey) / square)) : 0;
    const ox = x0 + fraction * ex;
    const oy = y0 + fraction * ey;
    const squaredDistance = ox * ox + oy * oy;
    if (squaredDistance < limit) {
      limit = squaredDistance;
      best = { index, distance: Math.sqrt(squaredDistance), fraction };
    }
  }
  return best;
}
