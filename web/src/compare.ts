// What two machines make of the same text: the lines whose motion differs.

import { KNOWN, type Path, type Vec3, kindOf } from "./path";

/** Ends this near are the same, mm: what single precision leaves of a part of some metres. */
const SAME_MM = 2e-3;

export interface Difference {
  /** Lines of the program whose motion differs. */
  lines: number[];
  /** The rows of the older path that those lines made, as ranges. */
  rows: [number, number][];
}

/** Lines whose rows differ in kind, number or place between two paths of the same text. */
export function differences(one: Path, other: Path): Difference {
  const shift = [0, 1, 2].map((axis) => one.origin[axis]! - other.origin[axis]!) as Vec3;
  const lines: number[] = [];
  const rows: [number, number][] = [];
  for (let line = 1; line <= Math.max(one.lines, other.lines); line++) {
    const a = one.rowsOfLine(line);
    const b = other.rowsOfLine(line);
    if (!a && !b) continue;
    if (a && b && same(one, a, other, b, shift)) continue;
    lines.push(line);
    if (a) rows.push(a);
  }
  return { lines, rows };
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
