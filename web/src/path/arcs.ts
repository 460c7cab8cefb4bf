// The exact arcs of a batch and curves of points: points on them, and how many chords an arc is drawn with.

import type { Batch, Vec3 } from "./batch";

/** The index of a row's arc among the arcs of its batch; -1 where the row is no arc. */
export function arcIndex(batch: Batch, row: number): number {
  let low = 0;
  let high = batch.arcRows.length - 1;
  while (low <= high) {
    const middle = (low + high) >> 1;
    const arcRow = batch.arcRows[middle]!;
    if (arcRow === row) return middle;
    if (arcRow < row) low = middle + 1;
    else high = middle - 1;
  }
  return -1;
}

/** Numbers of an arc: centre, unit vectors to the start and along the axis (three each), start and end radius, sweep (rad), rise along the axis; lengths in mm. */
export const ARC_NUMBERS = 13;

/** The point at a fraction, 0 to 1, of an arc, helix, spiral or cone, relative to the origin, mm. */
export function arcPoint(arcs: Float32Array, index: number, fraction: number): Vec3 {
  const offset = index * ARC_NUMBERS;
  const [ux, uy, uz] = [arcs[offset + 3]!, arcs[offset + 4]!, arcs[offset + 5]!];
  const [wx, wy, wz] = [arcs[offset + 6]!, arcs[offset + 7]!, arcs[offset + 8]!];
  const radius = arcs[offset + 9]! + (arcs[offset + 10]! - arcs[offset + 9]!) * fraction;
  const angle = arcs[offset + 11]! * fraction;
  const rise = arcs[offset + 12]! * fraction;
  const c = radius * Math.cos(angle);
  const s = radius * Math.sin(angle);
  // v = w × u
  return [
    arcs[offset]! + c * ux + s * (wy * uz - wz * uy) + rise * wx,
    arcs[offset + 1]! + c * uy + s * (wz * ux - wx * uz) + rise * wy,
    arcs[offset + 2]! + c * uz + s * (wx * uy - wy * ux) + rise * wz,
  ];
}

/** Into how many equal parts, of an eighth of a turn at most, an arc is divided to find its bounding box. */
export function arcSampleCount(arcs: Float32Array, index: number): number {
  const eighths = Math.ceil((8 * Math.abs(arcs[index * ARC_NUMBERS + 11]!)) / (2 * Math.PI));
  // At least 8 for short arcs, at most 512 for helices of many turns.
  return Math.max(8, Math.min(512, eighths));
}

/** How many chords an arc takes so that none is further from it than a tolerance, mm; at most 4096, none over more than 120°. */
export function arcChordCount(arcs: Float32Array, index: number, tolerance: number): number {
  const offset = index * ARC_NUMBERS;
  const radius = Math.max(arcs[offset + 9]!, arcs[offset + 10]!);
  const sweep = Math.abs(arcs[offset + 11]!);
  if (!(radius > 0) || !(sweep > 0)) return 1;
  // A chord over the angle a leaves the circle by r·(1 − cos a/2).
  const step = 2 * Math.acos(Math.max(0.5, 1 - tolerance / radius));
  return Math.max(1, Math.min(4096, Math.ceil(sweep / Math.max(step, 1e-3))));
}

/** An upper bound of the distance between the points of an arc and its centre, mm: an arc whose sphere is out of sight is not visible. */
export function arcReach(arcs: Float32Array, index: number): number {
  const offset = index * ARC_NUMBERS;
  return Math.max(arcs[offset + 9]!, arcs[offset + 10]!) + Math.abs(arcs[offset + 12]!);
}

/** The point at a fraction, 0 to 1, of a curve of evenly spaced points. */
export function curvePoint(curve: Float32Array, fraction: number): Vec3 {
  const last = curve.length / 3 - 1;
  const exact = Math.min(last, Math.max(0, fraction * last));
  const index = Math.min(last - 1, Math.floor(exact));
  const rest = exact - index;
  const lerp = (axis: number) => {
    const from = curve[3 * index + axis]!;
    return from + (curve[3 * index + 3 + axis]! - from) * rest;
  };
  return [lerp(0), lerp(1), lerp(2)];
}
