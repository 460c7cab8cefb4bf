// Rows of a path that are marked, cut anew as the zoom asks.

import type { Plane } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { type Tolerance, someRows } from "./lines";
import { Path, type Vec3 } from "./path";

/** Rows that are marked at most, where nothing else is said. */
const MOST = 50_000;

export class Marked {
  readonly object = new LineSegments2();
  private material: LineMaterial;
  private path = new Path();
  private ranges: [number, number][] = [];

  /** Lines of a width in pixels, for so many rows at most. */
  constructor(
    width: number,
    private most = MOST,
  ) {
    this.material = new LineMaterial({ linewidth: width, depthTest: false });
    this.object.material = this.material;
    this.object.frustumCulled = false;
    this.object.visible = false;
  }

  /** Marks ranges of rows of a path, and none of before. */
  set(path: Path, ranges: [number, number][], tolerance: Tolerance): void {
    [this.path, this.ranges] = [path, ranges];
    this.cut(tolerance);
  }

  clear(): void {
    this.ranges = [];
    this.object.visible = false;
  }

  /** Cuts arcs as fine as they must be now. */
  cut(tolerance: Tolerance): void {
    const points: number[] = [];
    let left = this.most;
    for (const [first, last] of this.ranges) {
      for (let row = first; row <= last && left > 0; ) {
        const found = this.path.find(row);
        if (!found) break;
        const [batch, from] = found;
        const to = Math.min(batch.rows - 1, last - batch.first, from + left - 1);
        left -= to - from + 1;
        for (const value of someRows(batch, from, to, tolerance)) points.push(value);
        row = batch.first + to + 1;
      }
    }
    this.object.visible = points.length > 0;
    if (points.length === 0) return;
    this.object.geometry.dispose();
    this.object.geometry = new LineSegmentsGeometry().setPositions(points);
  }

  /** How far the origin of its path is from that of the shown one. */
  place(by: Vec3): void {
    this.object.position.set(...by);
  }

  setColor(color: string): void {
    this.material.color.set(color);
  }

  clip(planes: Plane[]): void {
    this.material.clippingPlanes = planes;
    this.material.needsUpdate = true;
  }
}
