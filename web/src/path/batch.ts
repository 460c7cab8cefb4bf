// Batches of path rows: the columns of a `path` frame as typed arrays.

import { type Frame, f32, u32, u8 } from "../protocol/frame";

/** Kinds of rows, in the low bits of `Batch.kind`; 1 is a straight cut. */
export const RAPID = 0;
export const ARC = 2;
export const SPIRAL = 3;
export const SPLINE = 4;
const KIND_BITS = 0x0f;
/** The position of the row on the part is known, so it is drawn. */
export const KNOWN_BIT = 0x10;

/** The bits of X, Y and Z in a mask of known axes. */
export const AXIS_BITS = [1, 2, 4] as const;
export const ALL_AXES_BITS = 7;
/** In `Batch.known` the axes known at the end of a row are this many bits above those known at its start. */
export const END_AXES_SHIFT = 3;

export type Vec3 = [number, number, number];

/** Consecutive rows of a path. */
export interface Batch {
  /** The number of its first row in the path. */
  first: number;
  rows: number;
  /** Both ends of each row on the part, relative to the origin, mm: six numbers a row. */
  points: Float32Array;
  kind: Uint8Array;
  /** Which of X, Y and Z are known at the start and at the end of each row; undefined: all of them in rows with `KNOWN_BIT`, none in the others. */
  known?: Uint8Array;
  tool: Uint32Array;
  /** The line of the block, from 1, and its file; file 0 is the program itself. */
  line: Uint32Array;
  file: Uint8Array;
  /** mm/min; 0 where no feed is active. */
  feed: Float32Array;
  /** Indices in the batch of the rows that are arcs or spirals, ascending. */
  arcRows: Uint32Array;
  /** `ARC_NUMBERS` numbers for each of them. */
  arcs: Float32Array;
  /** Both ends of each row as programmed; undefined where no rotary axis turns the part: then they are `points`. */
  programmed?: Float32Array;
  /** A, B and C at both ends of each row, rad; undefined where all of them are zero. */
  rotaryAngles?: Float32Array;
  /** S of each row; undefined unless it may be the power of a laser. */
  power?: Float32Array;
  /** Points along splines, and along rows that are curved because the part turns, by index in the batch. */
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
    ...("turns" in frame.columns ? { rotaryAngles: f32(frame, "turns") } : {}),
  };
}

/** The points along each row that is neither a line nor an arc, by index in the batch. */
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
