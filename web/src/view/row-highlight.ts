// Marked rows of a path, whose arcs are cut again when the zoom changes.

import { type Plane, Group, InstancedBufferAttribute } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Batch, Vec3 } from "../path/batch";
import { type ArcTolerance, segmentsOfRows } from "../path/lines";
import { Path } from "../path/path";
import type { PathProgress } from "./progress";

/** Rows that are marked at most by default. */
const MAX_ROWS = 50_000;

export class RowHighlight {
  readonly object = new Group();
  private lines: LineSegments2;
  private material: LineMaterial;
  private edge: LineMaterial | undefined;
  private edges: LineSegments2 | undefined;
  private path = new Path();
  private ranges: [number, number][] = [];

  /**
   * Lines of a width in pixels, for `most` rows at most, with edges of a width on both sides;
   * what is not done yet is pale where a progress is given.
   */
  constructor(
    width: number,
    private most = MAX_ROWS,
    edge = 0,
    progress?: PathProgress,
  ) {
    this.material = new LineMaterial({ linewidth: width, depthTest: false });
    progress?.attach(this.material, true);
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

  /** Marks ranges of rows of a path instead of those before. */
  set(path: Path, ranges: [number, number][], tolerance: ArcTolerance): void {
    [this.path, this.ranges] = [path, ranges];
    this.cut(tolerance);
  }

  clear(): void {
    this.ranges = [];
    this.object.visible = false;
  }

  /** Cuts arcs as fine as they must be now. */
  cut(tolerance: ArcTolerance): void {
    const points: number[] = [];
    const spans: number[] = [];
    let left = this.most;
    for (const [first, last] of this.ranges) {
      for (let row = first; row <= last && left > 0; ) {
        const found = this.path.find(row);
        if (!found) break;
        const [batch, from] = found;
        const to = Math.min(batch.rows - 1, last - batch.first, from + left - 1);
        left -= to - from + 1;
        for (let own = from; own <= to; own++) this.row(batch, own, tolerance, points, spans);
        row = batch.first + to + 1;
      }
    }
    this.object.visible = points.length > 0;
    if (points.length === 0) return;
    this.lines.geometry.dispose();
    this.lines.geometry = new LineSegmentsGeometry().setPositions(points);
    this.lines.geometry.setAttribute("rowSpan", new InstancedBufferAttribute(new Float32Array(spans), 2));
    if (this.edges) this.edges.geometry = this.lines.geometry;
  }

  /** The lines of a row of a batch, and the fraction of the row at both ends of each. */
  private row(batch: Batch, row: number, tolerance: ArcTolerance, points: number[], spans: number[]): void {
    const own = segmentsOfRows(batch, row, row, tolerance);
    for (const value of own) points.push(value);
    const lines = own.length / 6;
    for (let line = 0; line < lines; line++) spans.push(batch.first + row + line / lines, batch.first + row + (line + 1) / lines);
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
