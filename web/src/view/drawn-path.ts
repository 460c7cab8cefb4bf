// The drawn lines of the path, batch by batch, and the simplified ones that replace them while the view turns.

import { Group, LineDashedMaterial, LineSegments } from "three";
import type { Batch } from "../path/batch";
import { type LineArrays, linesOf } from "../path/lines";
import type { ArcTolerance, RowFilter } from "../path/lines";
import { Path } from "../path/path";
import { type ColorBy, type Palette, colorsOf } from "./colors";
import type { DrawnBatch } from "./draw-groups";
import { yieldToEventLoop } from "./event-loop";
import { longestSide } from "./extent";
import { LineMaterials, LineMesh, clearGroup, lineGeometry, disposeLines } from "./line-mesh";
import { PathLevels } from "./lod";
import type { Painter } from "./painter";
import { type PathProgress, rowsAtEndsOf } from "./progress";

/** A path of more rows is simplified while the view turns, and the page handles input between its batches. */
export const SIMPLIFIED_FROM_ROWS = 20_000;
/** The lines of a path of more rows are one pixel wide: wide ones cost eight times as much. With a graphics card and without. */
const MAX_WIDE_ROWS = 20_000;
const MAX_WIDE_ROWS_SOFTWARE = 2_000;

const NO_LINES: LineArrays = { points: new Float32Array(0), rows: undefined, count: 0 };

export class DrawnPath {
  path = new Path();
  batches: DrawnBatch[] = [];
  colorBy: ColorBy = "tool";
  readonly cuts = new Group();
  readonly levels = new PathLevels();
  readonly cutMaterials: LineMaterials;
  readonly rapidMaterial = new LineDashedMaterial();
  private painter!: Painter;
  /** Number of the newest recolouring: an older one stops between two batches. */
  private recoloring = 0;

  /** `render` requests a frame. */
  constructor(progress: PathProgress, private palette: Palette, private render: () => void) {
    this.cutMaterials = new LineMaterials(progress);
    progress.attach(this.rapidMaterial);
  }

  /** Sets the painter, which is constructed with the groups of this path. */
  attach(painter: Painter): void {
    this.painter = painter;
  }

  clear(): void {
    clearGroup(this.cuts);
    clearGroup(this.painter.rapids);
    this.levels.clear();
    this.batches = [];
  }

  add(batch: Batch, tolerance: ArcTolerance, filter: RowFilter | undefined): DrawnBatch {
    const drawn: DrawnBatch = { batch, cuts: undefined, rapids: undefined, lines: { cuts: NO_LINES, rapids: NO_LINES } };
    this.batches.push(drawn);
    this.update(drawn, tolerance, filter);
    return drawn;
  }

  /** The lines of a path of more rows are one pixel wide. */
  get maxWideRows(): number {
    return this.painter.isSoftware ? MAX_WIDE_ROWS_SOFTWARE : MAX_WIDE_ROWS;
  }

  /** Makes the lines of the first batches thin where the path has become too long for wide ones. */
  thinFirstBatches(): void {
    if (this.path.rows <= this.maxWideRows) return;
    for (const drawn of this.batches) if (drawn.cuts?.isWide) this.replaceObjects(drawn);
  }

  /** Computes the lines of a batch again, with chords within `tolerance` of its arcs. */
  update(drawn: DrawnBatch, tolerance: ArcTolerance, filter: RowFilter | undefined): void {
    drawn.lines = linesOf(drawn.batch, tolerance, filter);
    this.replaceObjects(drawn);
  }

  /** Replaces the objects that draw the lines of a batch. */
  private replaceObjects(drawn: DrawnBatch): void {
    // The painter must not go on drawing objects that are disposed of.
    if (drawn.cuts || drawn.rapids) this.painter.changed();
    drawn.cuts?.dispose();
    disposeLines(drawn.rapids);
    const { batch, lines: { cuts, rapids } } = drawn;
    drawn.cuts = undefined;
    drawn.rapids = undefined;
    if (cuts.count > 0) {
      const isWide = this.path.rows <= this.maxWideRows && cuts.count <= this.maxWideRows;
      drawn.cuts = new LineMesh(cuts.points, this.colors(batch, cuts), rowsAtEndsOf(batch.first, cuts), this.cutMaterials, isWide);
      this.cuts.add(drawn.cuts.object);
    }
    if (rapids.count > 0) {
      drawn.rapids = new LineSegments(lineGeometry(rapids.points, rowsAtEndsOf(batch.first, rapids)), this.rapidMaterial);
      drawn.rapids.computeLineDistances();
      drawn.rapids.frustumCulled = false;
      this.painter.rapids.add(drawn.rapids);
    }
  }

  /** Makes the levels of detail of a long path. */
  async simplify(): Promise<void> {
    if (this.path.rows < SIMPLIFIED_FROM_ROWS) return this.levels.clear();
    const size = longestSide(this.path.bounds, 1);
    const colors = (batch: Batch, lines: LineArrays) => this.colors(batch, lines);
    const isBuilt = await this.levels.build(this.batches, size, colors, this.cutMaterials, this.rapidMaterial);
    if (isBuilt) this.render();
  }

  /** The colours of both ends of each segment. */
  private colors(batch: Batch, lines: LineArrays): Uint8Array {
    const { cutters, minFeed, maxFeed, depths, maxPower } = this.path;
    return colorsOf(this.palette, { by: this.colorBy, tools: cutters, feeds: [minFeed, maxFeed], depths, powers: [0, maxPower] }, batch, lines);
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.rapidMaterial.color.set(palette.rapid);
  }

  /** Computes the colours of all lines again, a batch at a time. */
  async recolor(): Promise<void> {
    const number = ++this.recoloring;
    for (const drawn of [...this.batches]) {
      drawn.cuts?.setColors(this.colors(drawn.batch, drawn.lines.cuts));
      if (drawn.batch.rows < SIMPLIFIED_FROM_ROWS) continue;
      await yieldToEventLoop();
      if (number !== this.recoloring) return;
    }
    this.painter.changed();
    this.render();
    await this.simplify();
  }
}
