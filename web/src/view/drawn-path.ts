// The lines of the path as they are drawn, batch by batch, and the fewer lines that are drawn instead while the view turns.

import { Group, LineDashedMaterial, LineSegments } from "three";
import type { Batch } from "../path/batch";
import { type LineArrays, linesOf } from "../path/lines";
import type { ArcTolerance, RowFilter } from "../path/lines";
import { Path } from "../path/path";
import { type ColorBy, type Palette, colorsOf } from "./colors";
import type { DrawnBatch } from "./draw-groups";
import { yieldToEventLoop } from "./event-loop";
import { longest } from "./extent";
import { LineMaterials, LineMesh, emptyGroup, geometryOf, removeLines } from "./line-mesh";
import { PathLevels } from "./lod";
import type { Painter } from "./painter";
import { type PathProgress, spansOf } from "./progress";

/** Rows from which on fewer lines are drawn while the view turns, and work is done a batch at a time. */
export const SIMPLIFIED_FROM_ROWS = 20_000;
/** Rows from which on lines are drawn one pixel wide: wide ones are eight times the work. */
const MAX_WIDE_ROWS = 20_000;
const MAX_WIDE_ROWS_SOFTWARE = 2_000;

/** No lines. */
const NONE: LineArrays = { points: new Float32Array(0), rows: undefined, count: 0 };

export class DrawnPath {
  path = new Path();
  batches: DrawnBatch[] = [];
  colorBy: ColorBy = "tool";
  readonly cuts = new Group();
  readonly levels = new PathLevels();
  readonly cutMaterials: LineMaterials;
  readonly rapidMaterial = new LineDashedMaterial();
  private painter!: Painter;
  /** The number of the newest recolouring: an older one stops between two batches. */
  private recoloring = 0;

  /** `render` draws the next frame. */
  constructor(progress: PathProgress, private palette: Palette, private render: () => void) {
    this.cutMaterials = new LineMaterials(progress);
    progress.attach(this.rapidMaterial);
  }

  /** The painter is made with the groups of this path, so it comes after it. */
  attach(painter: Painter): void {
    this.painter = painter;
  }

  clear(): void {
    emptyGroup(this.cuts);
    emptyGroup(this.painter.rapids);
    this.levels.clear();
    this.batches = [];
  }

  add(batch: Batch, tolerance: ArcTolerance, filter: RowFilter | undefined): DrawnBatch {
    const drawn: DrawnBatch = { batch, cuts: undefined, rapids: undefined, lines: { cuts: NONE, rapids: NONE } };
    this.batches.push(drawn);
    this.cut(drawn, tolerance, filter);
    return drawn;
  }

  /** Lines of a path of more rows are one pixel wide. */
  get maxWideRows(): number {
    return this.painter.isSoftware ? MAX_WIDE_ROWS_SOFTWARE : MAX_WIDE_ROWS;
  }

  /** The first batches were drawn before it was known that there would be so many. */
  thinFirstBatches(): void {
    if (this.path.rows <= this.maxWideRows) return;
    for (const drawn of this.batches) if (drawn.cuts?.isWide) this.put(drawn);
  }

  /** Cuts the arcs of a batch again and puts its lines into the scene. */
  cut(drawn: DrawnBatch, tolerance: ArcTolerance, filter: RowFilter | undefined): void {
    drawn.lines = linesOf(drawn.batch, tolerance, filter);
    this.put(drawn);
  }

  /** Puts the lines of a batch into the scene, instead of those before. */
  private put(drawn: DrawnBatch): void {
    // A picture that is being drawn must not use what is removed.
    if (drawn.cuts || drawn.rapids) this.painter.changed();
    drawn.cuts?.removeLines();
    removeLines(drawn.rapids);
    const { batch, lines: { cuts, rapids } } = drawn;
    drawn.cuts = undefined;
    drawn.rapids = undefined;
    if (cuts.count > 0) {
      const isWide = this.path.rows <= this.maxWideRows && cuts.count <= this.maxWideRows;
      drawn.cuts = new LineMesh(cuts.points, this.colors(batch, cuts), spansOf(batch.first, cuts), this.cutMaterials, isWide);
      this.cuts.add(drawn.cuts.object);
    }
    if (rapids.count > 0) {
      drawn.rapids = new LineSegments(geometryOf(rapids.points, spansOf(batch.first, rapids)), this.rapidMaterial);
      drawn.rapids.computeLineDistances();
      drawn.rapids.frustumCulled = false;
      this.painter.rapids.add(drawn.rapids);
    }
  }

  /** Makes the fewer lines of a long path. */
  async simplify(): Promise<void> {
    if (this.path.rows < SIMPLIFIED_FROM_ROWS) return this.levels.clear();
    const size = longest(this.path.bounds, 1);
    const colors = (batch: Batch, lines: LineArrays) => this.colors(batch, lines);
    const isBuilt = await this.levels.build(this.batches, size, colors, this.cutMaterials, this.rapidMaterial);
    if (isBuilt) this.render();
  }

  /** The colours of both ends of each line. */
  private colors(batch: Batch, lines: LineArrays): Uint8Array {
    const { cutters, minFeed, maxFeed, depths, maxPower } = this.path;
    return colorsOf(this.palette, { by: this.colorBy, tools: cutters, feeds: [minFeed, maxFeed], depths, powers: [0, maxPower] }, batch, lines);
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.rapidMaterial.color.set(palette.rapid);
  }

  /** Gives all lines their colours again, a batch at a time. */
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
