// What two machines make of the same text: the lines whose motion differs.

import { someRows } from "./lines";
import { pause } from "./pause";
import { KNOWN, type Path, type Vec3, kindOf } from "./path";

/** Ends this near are the same, mm: what single precision leaves of a part of some metres. */
const SAME_MM = 2e-3;

export interface Difference {
  /** Lines of the program whose motion differs. */
  lines: number[];
  /** The rows of the older path that those lines made, as ranges. */
  rows: [number, number][];
}

/** Lines and rows that are looked at without a break: some milliseconds. */
const PIECE = 10_000;
/** Numbers of a drawn difference at most: half a million lines. */
const MOST_POINTS = 3_000_000;

/**
 * Lines whose rows differ in kind, number or place between two paths of the same text; none where it
 * is no longer wanted.
 */
export async function differences(one: Path, other: Path, isWanted: () => boolean): Promise<Difference | undefined> {
  const shift = [0, 1, 2].map((axis) => one.origin[axis]! - other.origin[axis]!) as Vec3;
  const lines: number[] = [];
  const rows: [number, number][] = [];
  for (let line = 1; line <= Math.max(one.lines, other.lines); line++) {
    if (line % PIECE === 0) {
      await pause();
      if (!isWanted()) return undefined;
    }
    const a = one.rowsOfLine(line);
    const b = other.rowsOfLine(line);
    if (!a && !b) continue;
    if (a && b && same(one, a, other, b, shift)) continue;
    lines.push(line);
    if (a) rows.push(a);
  }
  return { lines, rows };
}

/** The lines to draw for ranges of rows, as many as there is room for. */
export async function pointsOf(path: Path, rows: [number, number][], tolerance: number): Promise<Float32Array> {
  const points: number[] = [];
  let looked = 0;
  for (const [from, to] of rows) {
    for (let row = from; row <= to && points.length < MOST_POINTS; ) {
      const found = path.find(row);
      if (!found) break;
      const [batch, first] = found;
      const last = Math.min(batch.rows - 1, to - batch.first, first + PIECE);
      for (const value of someRows(batch, first, last, () => tolerance)) points.push(value);
      looked += last - first + 1;
      row = batch.first + last + 1;
      if (looked < PIECE) continue;
      looked = 0;
      await pause();
    }
  }
  return new Float32Array(points);
}

function same(one: Path, a: [number, number], other: Path, b: [number, number], shift: Vec3): boolean {
  if (a[1] - a[0] !== b[1] - b[0]) return false;
  // A line of a subprogram spans what it called in between: some rows of it tell.
  const count = Math.min(a[1] - a[0] + 1, 1000);
  for (let at = 0; at < count; at++) {
    const p = one.find(a[0] + at);
    const q = other.find(b[0] + at);
    if (!p || !q) return false;
    const [kindP, kindQ] = [p[0].kind[p[1]]!, q[0].kind[q[1]]!];
    if (kindOf(kindP) !== kindOf(kindQ)) return false;
    if (!(kindP & kindQ & KNOWN)) continue;
    for (const share of [0, 0.5, 1]) {
      const [u, v] = [one.pointOn(a[0] + at, share), other.pointOn(b[0] + at, share)];
      if (!u || !v) return false;
      for (let axis = 0; axis < 3; axis++) {
        if (Math.abs(u[axis]! - v[axis]! + shift[axis]!) > SAME_MM) return false;
      }
    }
  }
  return true;
}
