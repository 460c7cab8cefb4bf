// Rows of a path that are marked, cut anew as the zoom asks.

import { Group, type Plane } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { type Tolerance, someRows } from "./lines";
import { Path, type Vec3 } from "./path";

/** Rows that are marked at most, where nothing else is said. */
const MOST = 50_000;

export class Marked {
  readonly object = new Group();
  private lines: LineSegments2;
  private material: LineMaterial;
  private edge: LineMaterial | undefined;
  private edges: LineSegments2 | undefined;
  private path = new Path();
  private ranges: [number, number][] = [];

  /** Lines of a width in pixels, for so many rows at most, with edges of a width on both sides. */
  constructor(
    width: number,
    private most = MOST,
    edge = 0,
  ) {
    this.material = new LineMaterial({ linewidth: width, depthTest: false });
    if (edge > 0) {
      this.edge = new LineMaterial({ linewidth: width + 2 * edge, depthTest: false });
      this.edges = this.add(this.edge);
    }
    this.lines = this.add(this.material);
    this.object.visible = false;
  }

  private add(material: LineMaterial): LineSegments2 {
    const lines = new LineSegments2();
    lines.material = material;
    lines.frustumCulled = false;
    this.object.add(lines);
    return lines;
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
    this.lines.geometry.dispose();
    this.lines.geometry = new LineSegmentsGeometry().setPositions(points);
    if (this.edges) this.edges.geometry = this.lines.geometry;
  }

  /** How far the origin of its path is from that of the shown one. */
  place(by: Vec3): void {
    this.object.position.set(...by);
  }

  setColor(color: string, edge = color): void {
    this.material.color.set(color);
    this.edge?.color.set(edge);
  }

  clip(planes: Plane[]): void {
    for (const material of [this.material, this.edge]) {
      if (!material) continue;
      material.clippingPlanes = planes;
      material.needsUpdate = true;
    }
  }
}
