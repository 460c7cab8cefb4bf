// From rows to what a graphics card draws: pairs of points, and the row of each pair. Arcs are cut
// as fine as the view needs; a straight path is drawn from the server's own array.

import { arcIndex, arcPieces, arcPoint } from "./arcs";
import { type Batch, KNOWN_BIT, RAPID, kindOf } from "./batch";

/** Line segments: six numbers each, relative to the origin. */
export interface LineArrays {
  points: Float32Array;
  /** The row of each, within its batch; `undefined`: each is the row of its number. */
  rows: Uint32Array | undefined;
  count: number;
}

export interface DrawnLines {
  cuts: LineArrays;
  rapids: LineArrays;
}

export type ArcTolerance = (arcs: Float32Array, index: number) => number;

/** Whether a row of a batch is shown. */
export type RowFilter = (row: number) => boolean;

/**
 * Cuts and rapids of a batch, those that are kept; `tolerance` says how far an arc's pieces may be
 * from it, mm.
 */
export function linesOf(batch: Batch, tolerance: ArcTolerance, keep?: RowFilter): DrawnLines {
  const { rows, kind, arcRows, arcs, points } = batch;
  const pieces = new Uint32Array(arcRows.length);
  const isShown = (row: number) => (kind[row]! & KNOWN_BIT) !== 0 && (!keep || keep(row));
  let extra = 0;
  for (let at = 0; at < arcRows.length; at++) {
    pieces[at] = arcPieces(arcs, at, tolerance(arcs, at));
    extra += pieces[at]! - 1;
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
    return { cuts: { points, rows: undefined, count: rows }, rapids: gather(0) };
  }
  const cut = new Gatherer(rows - rapids - hidden + extra);
  const rapid = new Gatherer(rapids + extra);
  let arc = 0;
  for (let row = 0; row < rows; row++) {
    const isArc = arc < arcRows.length && arcRows[arc] === row;
    const curve = curves?.get(row);
    if (curve && isShown(row)) (kindOf(kind[row]!) === RAPID ? rapid : cut).curve(curve, row);
    else if (isShown(row)) {
      if (isArc) cut.arc(batch, row, arc, pieces[arc]!);
      else (kindOf(kind[row]!) === RAPID ? rapid : cut).row(points, row);
    }
    if (isArc) arc++;
  }
  return { cuts: cut.lines(), rapids: rapid.lines() };
}

function gather(size: number): LineArrays {
  return new Gatherer(size).lines();
}

class Gatherer {
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
    for (let at = 0; at + 6 <= curve.length; at += 3) {
      this.points.set(curve.subarray(at, at + 6), 6 * this.count);
      this.rows[this.count++] = row;
    }
  }

  arc(batch: Batch, row: number, arc: number, pieces: number): void {
    const { points, arcs } = batch;
    let from = [points[6 * row]!, points[6 * row + 1]!, points[6 * row + 2]!];
    for (let piece = 1; piece <= pieces; piece++) {
      // The ends are those of the program, whatever the record of the arc comes to.
      const to =
        piece === pieces
          ? [points[6 * row + 3]!, points[6 * row + 4]!, points[6 * row + 5]!]
          : arcPoint(arcs, arc, piece / pieces);
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

/** The segments of some rows of a batch, for marks. */
export function someRows(batch: Batch, from: number, to: number, tolerance: ArcTolerance): number[] {
  const points: number[] = [];
  for (let row = from; row <= to; row++) {
    if (!(batch.kind[row]! & KNOWN_BIT)) continue;
    const curve = batch.curves?.get(row);
    if (curve) {
      for (let at = 0; at + 6 <= curve.length; at += 3) points.push(...curve.subarray(at, at + 6));
      continue;
    }
    const arc = arcIndex(batch, row);
    const p = batch.points;
    if (arc < 0) {
      for (let at = 6 * row; at < 6 * row + 6; at++) points.push(p[at]!);
      continue;
    }
    const pieces = arcPieces(batch.arcs, arc, tolerance(batch.arcs, arc));
    let before = [p[6 * row]!, p[6 * row + 1]!, p[6 * row + 2]!];
    for (let piece = 1; piece <= pieces; piece++) {
      const next =
        piece === pieces
          ? [p[6 * row + 3]!, p[6 * row + 4]!, p[6 * row + 5]!]
          : arcPoint(batch.arcs, arc, piece / pieces);
      points.push(...before, ...next);
      before = next;
    }
  }
  return points;
}

/**
 * The segment nearest to a point on the screen, in pixels, no further away than `reach`; the
 * matrix (column-major) takes points to the cube from -1 to 1 without perspective.
 */
export function nearest(
  lines: LineArrays,
  matrix: ArrayLike<number>,
  width: number,
  height: number,
  x: number,
  y: number,
  reach: number,
): { index: number; distance: number; share: number } | undefined {
  const m = matrix;
  const p = lines.points;
  // To pixels: x grows to the right, y downwards.
  const [ax, bx, cx, dx] = [m[0]!, m[4]!, m[8]!, m[12]!].map((v, i) => ((i === 3 ? v + 1 : v) * width) / 2) as [number, number, number, number];
  const [ay, by, cy, dy] = [m[1]!, m[5]!, m[9]!, m[13]!].map((v, i) => ((i === 3 ? 1 - v : -v) * height) / 2) as [number, number, number, number];
  let best: { index: number; distance: number; share: number } | undefined;
  let limit = reach * reach;
  for (let index = 0; index < lines.count; index++) {
    const at = 6 * index;
    const x0 = ax * p[at]! + bx * p[at + 1]! + cx * p[at + 2]! + dx - x;
    const y0 = ay * p[at]! + by * p[at + 1]! + cy * p[at + 2]! + dy - y;
    const ex = ax * (p[at + 3]! - p[at]!) + bx * (p[at + 4]! - p[at + 1]!) + cx * (p[at + 5]! - p[at + 2]!);
    const ey = ay * (p[at + 3]! - p[at]!) + by * (p[at + 4]! - p[at + 1]!) + cy * (p[at + 5]! - p[at + 2]!);
    const square = ex * ex + ey * ey;
    const share = square > 0 ? Math.min(1, Math.max(0, -(x0 * ex + y0 * ey) / square)) : 0;
    const ox = x0 + share * ex;
    const oy = y0 + share * ey;
    const distance = ox * ox + oy * oy;
    if (distance < limit) {
      limit = distance;
      best = { index, distance: Math.sqrt(distance), share };
    }
  }
  return best;
}
