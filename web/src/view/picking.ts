// Finds the row of the path at a position on the canvas.

import type { Batch, Vec3 } from "../path/batch";
import { type LineArrays, nearestSegment } from "../path/lines";
import type { ViewCamera } from "./camera";

/** How far from a line a click may be, pixels. */
const PICK_RADIUS_PIXELS = 8;
/** An end of the row within this distance is picked, pixels. */
const SNAP_PIXELS = 9;
/** A rapid counts as this much further away, pixels, so that a cut under it is picked. */
const RAPID_HANDICAP_PIXELS = 3;

export interface PickedPoint {
  row: number;
  /** How far along the row, 0 to 1. */
  fraction: number;
  /** The point on the row, relative to the origin of the path, mm. */
  at: Vec3;
  /** Whether it was moved to an end of the row. */
  snapped: boolean;
}

export interface Pickable {
  batch: Batch;
  lines: { cuts: LineArrays; rapids: LineArrays };
}

/** Projects points, relative to the origin of a path, onto the screen. */
export type PointProjection = Pick<ViewCamera, "matrix" | "project">;

/** The nearest point of a row to a position on the canvas, pixels, among those that pass `isPickable`. */
export function pick(
  parts: Pickable[],
  camera: PointProjection,
  canvas: HTMLCanvasElement,
  [x, y]: [number, number],
  withRapids: boolean,
  isPickable: (at: Vec3) => boolean,
): PickedPoint | undefined {
  const { elements } = camera.matrix();
  let best: (PickedPoint & { distance: number }) | undefined;
  for (const { batch, lines } of parts) {
    for (const [segments, handicap] of [[lines.cuts, 0], [lines.rapids, RAPID_HANDICAP_PIXELS]] as const) {
      if (segments === lines.rapids && !withRapids) continue;
      const found = nearestSegment(segments, elements, canvas.clientWidth, canvas.clientHeight, x, y, PICK_RADIUS_PIXELS);
      if (!found || (best && found.distance + handicap >= best.distance)) continue;
      const picked = pickedOn(batch, segments, found, (at) => {
        const [ex, ey] = camera.project(at);
        return Math.hypot(ex - x, ey - y) < SNAP_PIXELS;
      });
      if (isPickable(picked.at)) best = { ...picked, distance: found.distance + handicap };
    }
  }
  return best;
}

/** The picked point on a segment, moved to an end of its row that is near. */
function pickedOn(batch: Batch, lines: LineArrays, { index, fraction }: { index: number; fraction: number }, isNear: (at: Vec3) => boolean): PickedPoint {
  const rowOf = (segment: number) => (lines.rows ? lines.rows[segment]! : segment);
  const row = rowOf(index);
  let first = index;
  let last = index;
  while (first > 0 && rowOf(first - 1) === row) first--;
  while (last < lines.count - 1 && rowOf(last + 1) === row) last++;
  const p = lines.points;
  const ends: [number, Vec3][] = [
    [0, [p[6 * first]!, p[6 * first + 1]!, p[6 * first + 2]!]],
    [1, [p[6 * last + 3]!, p[6 * last + 4]!, p[6 * last + 5]!]],
  ];
  for (const [end, at] of ends) if (isNear(at)) return { row: batch.first + row, fraction: end, at, snapped: true };
  const along = (index - first + fraction) / (last - first + 1);
  const lerp = (axis: number) => p[6 * index + axis]! + (p[6 * index + 3 + axis]! - p[6 * index + axis]!) * fraction;
  return { row: batch.first + row, fraction: along, at: [lerp(0), lerp(1), lerp(2)], snapped: false };
}
