// Rows of a path as typed arrays, as one message of the server has them.

import { type Frame, f32, u32, u8 } from "../protocol/frame";

export const RAPID = 0;
export const ARC = 2;
export const SPIRAL = 3;
export const SPLINE = 4;
const KIND_BITS = 0x0f;
export const KNOWN_BIT = 0x10;
export const INSERTED_BIT = 0x20;

/** The bits of X, Y and Z. */
export const axisBits = [1, 2, 4] as const;
export const ALL_AXES_BITS = 7;
/** The bits of the axes that are known at the end of a row are above those at its start. */
export const END_AXES_SHIFT = 3;

export type Vec3 = [number, number, number];

/** Consecutive rows of a path. */
export interface Batch {
  first: number;
  rows: number;
  /** Both ends of each row on the part, relative to the origin, mm: six numbers a row. */
  points: Float32Array;
  kind: Uint8Array;
  /** Which of X, Y and Z are known at both ends of each row; without it those of rows that are drawn. */
  known?: Uint8Array;
  tool: Uint32Array;
  line: Uint32Array;
  file: Uint8Array;
  /** mm/min; 0 where there is none. */
  feed: Float32Array;
  /** Rows of the batch that are arcs or spirals, in order, and 13 numbers for each. */
  arcRows: Uint32Array;
  arcs: Float32Array;
  /** Both ends of each row as they are programmed, where the part turns. */
  programmed?: Float32Array;
  /** A, B and C at both ends of each row, rad, where one of them is not zero. */
  turns?: Float32Array;
  /** S of each row, where it may be the power of a laser. */
  power?: Float32Array;
  /** Points along splines, and along rows that are curved because the part turns. */
  curves?: Map<number, Float32Array>;
}

export interface Bounds {
  low: Vec3;
  high: Vec3;
}

export function batchOf(frame: Frame): Batch {
  return {
    first: Number(frame.header.first ?? 0),
    rows: Number(frame.header.rows),
    points: f32(frame, "points"),
    kind: u8(frame, "kind"),
    ...("known" in frame.columns ? { known: u8(frame, "known") } : {}),
    tool: u32(frame, "tool"),
    line: u32(frame, "line"),
    file: u8(frame, "file"),
    feed: f32(frame, "feed"),
    ...("power" in frame.columns ? { power: f32(frame, "power") } : {}),
    arcRows: u32(frame, "arc_rows"),
    arcs: f32(frame, "arcs"),
    ...("curve_rows" in frame.columns ? { curves: curvesOf(frame) } : {}),
    ...("programmed" in frame.columns ? { programmed: f32(frame, "programmed") } : {}),
    ...("turns" in frame.columns ? { turns: f32(frame, "turns") } : {}),
  };
}

/** The points along each row that is neither a line nor an arc. */
function curvesOf(frame: Frame): Map<number, Float32Array> {
  const counts = u32(frame, "curve_counts");
  const points = f32(frame, "curve_points");
  const curves = new Map<number, Float32Array>();
  let from = 0;
  u32(frame, "curve_rows").forEach((row, index) => {
    const to = from + 3 * counts[index]!;
    curves.set(row, points.subarray(from, to));
    from = to;
  });
  return curves;
}

export function kindOf(flags: number): number {
  return flags & KIND_BITS;
}
