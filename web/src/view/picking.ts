// Finds the row of the path at a position on the screen.

import type { Batch, Vec3 } from "../path/batch";
import { type LineArrays, nearestSegment } from "../path/lines";
import type { ViewCamera } from "./camera";

/** How far from a line a click may be, pixels. */
const REACH_PIXELS = 8;
/** An end within this distance is picked, pixels. */
const SNAP_PIXELS = 9;
/** A cut is picked rather than the rapid over it: the rapid counts as so much further away, pixels. */
const RAPID_HANDICAP_PIXELS = 3;

export interface PickedPoint {
  row: number;
  /** How far along the row, from 0 to 1. */
  fraction: number;
  /** Relative to the origin of the path, mm; an end of the row where one is near. */
  at: Vec3;
  /** Whether it is an end of the row. */
  snapped: boolean;
}

export interface Pickable {
  batch: Batch;
  lines: { cuts: LineArrays; rapids: LineArrays };
}

/** Projects points, relative to the origin of a path, onto the screen. */
export type PointProjection = Pick<ViewCamera, "matrix" | "project">;

/** The row nearest to a position on the canvas, of those whose place there `counts`. */
export function pick(
  parts: Pickable[],
  camera: PointProjection,
  canvas: HTMLCanvasElement,
  [x, y]: [number, number],
  withRapids: boolean,
  counts: (at: Vec3) => boolean,
): PickedPoint | undefined {
  const { elements } = camera.matrix();
  let best: (PickedPoint & { distance: number }) | undefined;
  for (const { batch, lines } of parts) {
    for (const [own, handicap] of [[lines.cuts, 0], [lines.rapids, RAPID_HANDICAP_PIXELS]] as const) {
      if (own === lines.rapids && !withRapids) continue;
      const found = nearestSegment(own, elements, canvas.clientWidth, canvas.clientHeight, x, y, REACH_PIXELS);
      if (!found || (best && found.distance + handicap >= best.distance)) continue;
      const picked = pickedOn(batch, own, found, (at) => {
        const [ex, ey] = camera.project(at);
        return Math.hypot(ex - x, ey - y) < SNAP_PIXELS;
      });
      if (counts(picked.at)) best = { ...picked, distance: found.distance + handicap };
    }
  }
  return best;
}

function pickedOn(batch: Batch, lines: LineArrays, { index, fraction }: { index: number; fraction: number }, isNear: (at: Vec3) => boolean): PickedPoint {
  const own = (at: number) => (lines.rows ? lines.rows[at]! : at);
  const row = own(index);
  let first = index;
  let last = index;
  while (first > 0 && own(first - 1) === row) first--;
  while (last < lines.count - 1 && own(last + 1) === row) last++;
  const p = lines.points;
  const ends: [number, Vec3][] = [
    [0, [p[6 * first]!, p[6 * first + 1]!, p[6 * first + 2]!]],
    [1, [p[6 * last + 3]!, p[6 * last + 4]!, p[6 * last + 5]!]],
  ];
  for (const [end, at] of ends) if (isNear(at)) return { row: batch.first + row, fraction: end, at, snapped: true };
  const along = (index - first + fraction) / (last - first + 1);
  const mix = (axis: number) => p[6 * index + axis]! + (p[6 * index + 3 + axis]! - p[6 * index + axis]!) * fraction;
  return { row: batch.first + row, fraction: along, at: [mix(0), mix(1), mix(2)], snapped: false };
}
