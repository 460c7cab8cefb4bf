// The exact arcs of a batch, and curves of points: points on them, and into how many straight pieces arcs are cut.

import type { Batch, Vec3 } from "./batch";

/** The number of a row's arc in its batch, or -1. */
export function arcIndex(batch: Batch, row: number): number {
  let low = 0;
  let high = batch.arcRows.length - 1;
  while (low <= high) {
    const middle = (low + high) >> 1;
    const found = batch.arcRows[middle]!;
    if (found === row) return middle;
    if (found < row) low = middle + 1;
    else high = middle - 1;
  }
  return -1;
}

/** Numbers of an arc's record: centre, towards the start, axis, both radii, sweep, rise. */
const ARC_NUMBERS = 13;

/** A point on an arc, a helix, a spiral or a cone, relative to the origin, mm. */
export function arcPoint(arcs: Float32Array, index: number, share: number): Vec3 {
  const at = index * ARC_NUMBERS;
  const [ux, uy, uz] = [arcs[at + 3]!, arcs[at + 4]!, arcs[at + 5]!];
  const [wx, wy, wz] = [arcs[at + 6]!, arcs[at + 7]!, arcs[at + 8]!];
  const radius = arcs[at + 9]! + (arcs[at + 10]! - arcs[at + 9]!) * share;
  const angle = arcs[at + 11]! * share;
  const rise = arcs[at + 12]! * share;
  const c = radius * Math.cos(angle);
  const s = radius * Math.sin(angle);
  // v = w × u
  return [
    arcs[at]! + c * ux + s * (wy * uz - wz * uy) + rise * wx,
    arcs[at + 1]! + c * uy + s * (wz * ux - wx * uz) + rise * wy,
    arcs[at + 2]! + c * uz + s * (wx * uy - wy * ux) + rise * wz,
  ];
}

/** Eighths of a turn that an arc has, about: between them its box is found. */
export function arcEighths(arcs: Float32Array, index: number): number {
  const eighths = Math.ceil((8 * Math.abs(arcs[index * ARC_NUMBERS + 11]!)) / (2 * Math.PI));
  return Math.max(8, Math.min(512, eighths));
}

/** How many straight pieces an arc takes so that none is further from it than a tolerance, mm. */
export function arcPieces(arcs: Float32Array, index: number, tolerance: number): number {
  const at = index * ARC_NUMBERS;
  const radius = Math.max(arcs[at + 9]!, arcs[at + 10]!);
  const sweep = Math.abs(arcs[at + 11]!);
  if (!(radius > 0) || !(sweep > 0)) return 1;
  // A chord over the angle a leaves the circle by r·(1 − cos a/2).
  const step = 2 * Math.acos(Math.max(0.5, 1 - tolerance / radius));
  return Math.max(1, Math.min(4096, Math.ceil(sweep / Math.max(step, 1e-3))));
}

/** Greatest distance of an arc from its centre along it, mm: what a view must see to show it. */
export function arcReach(arcs: Float32Array, index: number): number {
  const at = index * ARC_NUMBERS;
  return Math.max(arcs[at + 9]!, arcs[at + 10]!) + Math.abs(arcs[at + 12]!);
}

/** The point at a share of a curve of points at even distances. */
export function curvePoint(curve: Float32Array, share: number): Vec3 {
  const last = curve.length / 3 - 1;
  const exact = Math.min(last, Math.max(0, share * last));
  const index = Math.min(last - 1, Math.floor(exact));
  const part = exact - index;
  const mix = (axis: number) => {
    const from = curve[3 * index + axis]!;
    return from + (curve[3 * index + 3 + axis]! - from) * part;
  };
  return [mix(0), mix(1), mix(2)];
}
