// The extent of points in the view, for fitting them, and helpers for boxes.

import type { Bounds, Vec3 } from "../path/batch";

/** Left, right, bottom and top in the view, mm. */
export type ViewEdges = [number, number, number, number];

/** Finds the extent of points; the view matrix (column-major) takes them to the axes of the view. */
export class ViewExtent {
  readonly edges: ViewEdges = [Infinity, -Infinity, Infinity, -Infinity];

  constructor(private matrix: ArrayLike<number>) {}

  get isEmpty(): boolean {
    return this.edges[0] > this.edges[1];
  }

  /** Adds one point every `step` numbers. */
  add(points: ArrayLike<number>, step = 3): void {
    const { edges, matrix: m } = this;
    for (let offset = 0; offset + 2 < points.length; offset += step) {
      const [px, py, pz] = [points[offset]!, points[offset + 1]!, points[offset + 2]!];
      const x = m[0]! * px + m[4]! * py + m[8]! * pz + m[12]!;
      const y = m[1]! * px + m[5]! * py + m[9]! * pz + m[13]!;
      if (x < edges[0]) edges[0] = x;
      if (x > edges[1]) edges[1] = x;
      if (y < edges[2]) edges[2] = y;
      if (y > edges[3]) edges[3] = y;
    }
  }

  addBox(box: Bounds): void {
    for (let bits = 0; bits < 8; bits++) this.add(corner(box, bits));
  }
}

/** A corner of a box: bits 0, 1 and 2 choose the high end of X, Y and Z. */
export function corner({ low, high }: Bounds, bits: number): Vec3 {
  return [0, 1, 2].map((axis) => (bits & (1 << axis) ? high : low)[axis]!) as Vec3;
}

export function difference(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

/** The longestSide side of a box, mm; `fallback` where there is no box or it is a point. */
export function longestSide(box: Bounds | undefined, fallback: number): number {
  return box ? Math.max(...difference(box.high, box.low)) || fallback : fallback;
}
