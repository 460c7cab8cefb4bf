// Highlighted rows of a path; the chords of their arcs are computed again when the zoom changes.

import { type Plane, Group, InstancedBufferAttribute } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Batch, Vec3 } from "../path/batch";
import { type ArcTolerance, segmentsOfRows } from "../path/lines";
import { Path } from "../path/path";
import type { PathProgress } from "./progress";

/** The default for the largest number of highlighted rows. */
const MAX_ROWS = 50_000;

export class RowHighlight {
  readonly object = new Group();
  private lines: LineSegments2;
  private material: LineMaterial;
  private outlineMaterial: LineMaterial | undefined;
  private outline: LineSegments2 | undefined;
  private path = new Path();
  private ranges: [number, number][] = [];

  /** Lines of `width` pixels, with an outline of `outline` pixels on both sides; with `progress` rows not reached yet are pale. */
  constructor(
    width: number,
    private maxRows = MAX_ROWS,
    outline = 0,
    progress?: PathProgress,
  ) {
    this.material = new LineMaterial({ linewidth: width, depthTest: false });
    progress?.attach(this.material, true);
    if (outline > 0) {
      this.outlineMaterial = new LineMaterial({ linewidth: width + 2 * outline, depthTest: false });
      this.outline = this.add(this.outlineMaterial);
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

  /** Highlights ranges of rows of a path, first and last row each, instead of those before. */
  set(path: Path, ranges: [number, number][], tolerance: ArcTolerance): void {
    [this.path, this.ranges] = [path, ranges];
    this.update(tolerance);
  }

  clear(): void {
    this.ranges = [];
    this.object.visible = false;
  }

  /** Computes the lines again, with chords within `tolerance` of the arcs. */
  update(tolerance: ArcTolerance): void {
    const points: number[] = [];
    const rowsAtEnds: number[] = [];
    let left = this.maxRows;
    for (const [first, last] of this.ranges) {
      for (let row = first; row <= last && left > 0; ) {
        const found = this.path.find(row);
        if (!found) break;
        const [batch, from] = found;
        const to = Math.min(batch.rows - 1, last - batch.first, from + left - 1);
        left -= to - from + 1;
        for (let index = from; index <= to; index++) this.addRow(batch, index, tolerance, points, rowsAtEnds);
        row = batch.first + to + 1;
      }
    }
    this.object.visible = points.length > 0;
    if (points.length === 0) return;
    this.lines.geometry.dispose();
    this.lines.geometry = new LineSegmentsGeometry().setPositions(points);
    this.lines.geometry.setAttribute("rowsAtEnds", new InstancedBufferAttribute(new Float32Array(rowsAtEnds), 2));
    if (this.outline) this.outline.geometry = this.lines.geometry;
  }

  /** Adds the segments of a row of a batch, and the row with its fraction at both ends of each. */
  private addRow(batch: Batch, index: number, tolerance: ArcTolerance, points: number[], rowsAtEnds: number[]): void {
    const segments = segmentsOfRows(batch, index, index, tolerance);
    for (const value of segments) points.push(value);
    const count = segments.length / 6;
    const row = batch.first + index;
    for (let n = 0; n < count; n++) rowsAtEnds.push(row + n / count, row + (n + 1) / count);
  }

  /** Sets the offset of the origin of its path from that of the program's path, mm. */
  setOffset(offset: Vec3): void {
    this.object.position.set(...offset);
  }

  setColor(color: string, outline = color): void {
    this.material.color.set(color);
    this.outlineMaterial?.color.set(outline);
  }

  clip(planes: Plane[]): void {
    for (const material of [this.material, this.outlineMaterial]) {
      if (!material) continue;
      material.clippingPlanes = planes;
      material.needsUpdate = true;
    }
  }
}
