// The view of the path with three.js; a frame is drawn only when something has changed.

import {
  Box3,
  Color,
  ColorManagement,
  Group,
  LineBasicMaterial,
  LineDashedMaterial,
  LineSegments,
  Plane,
  Vector3,
} from "three";
import { type DifferenceRows, DifferenceMarkers } from "../compare/difference-markers";
import { OtherPath } from "../compare/other-path";
import type { PathFeature } from "../measure/geometry";
import { MeasureOverlay } from "../measure/overlay";
import type { Batch, Bounds, Vec3 } from "../path/batch";
import { type RowFilter, linesOf } from "../path/lines";
import { Path } from "../path/path";
import { HalfSectionLayer } from "../stock/half-section-layer";
import type { HalfSections } from "../stock/half-sections";
import { StockLayer } from "../stock/stock-layer";
import type { StockBefore } from "../stock/stock-timeline";
import { type TurretSide, type ViewName, ViewCamera } from "./camera";
import type { ColorBy, Palette } from "./colors";
import { drawGroupsOn } from "./draw-groups";
import { DrawnPath, SIMPLIFIED_FROM_ROWS } from "./drawn-path";
import { yieldToEventLoop } from "./event-loop";
import { type ViewEdges, ViewExtent, difference, longestSide } from "./extent";
import { FixedObjects } from "./fixed-objects";
import { clearGroup, lineGeometry } from "./line-mesh";
import { MachineLayer } from "./machine-layer";
import { Painter } from "./painter";
import { type PickedPoint, pick } from "./picking";
import { PathProgress } from "./progress";
import { RowHighlight } from "./row-highlight";
import { type ArcTolerance, screenTolerance } from "./screen-tolerance";
import { type DrawnTool, ToolShape } from "./tool-shape";
import type { VisibleSection } from "./visible-section";

/** How long the view must rest before it is drawn in full detail again, ms. */
const REST_MS = 160;
/** How much of the view a box takes up that is zoomed to. */
const ZOOM_FRACTION = 0.8;
/** Dashes and gaps of rapids and contours, pixels. */
const RAPID_DASH_PIXELS: [number, number] = [6, 4];
const CONTOUR_DASH_PIXELS: [number, number] = [3, 2];
/** The chords of arcs are computed again when the view is enlarged or reduced by more than these factors. */
const REFINE_FACTOR = 1.5;
const COARSEN_FACTOR = 4;
/** Points of a long path that its extent is computed from, about. */
const EXTENT_POINTS = 50_000;
/** Every n-th point of a batch is checked for being in the view. */
const VISIBILITY_STRIDE = 16;

// Colours are used as they are: the page has no lights, which would need linear ones.
ColorManagement.enabled = false;

export class PathView {
  private camera: ViewCamera;
  private painter: Painter;
  private drawn: DrawnPath;
  /** The programmed contours of compensated moves. */
  private contour = new Group();
  private differences = new DifferenceMarkers();
  private other = new OtherPath(() => this.painter.changed(), this.differences.other.object);
  private chords = new Group();
  private fixed = new FixedObjects();
  private mark: RowHighlight;
  private progress = new PathProgress();
  private contourMaterial = new LineDashedMaterial({ transparent: true, opacity: 0.9 });
  private chordMaterial = new LineBasicMaterial({ depthTest: false });
  private tool: ToolShape;
  readonly stock: StockLayer;
  readonly machine: MachineLayer;
  /** The half section of a lathe. */
  readonly lathe: HalfSectionLayer;
  /** The size of the picture, CSS pixels. */
  private width = 0;
  private height = 0;
  /** The user is moving the camera. */
  private turning = false;
  /** The camera has moved since the last frame. */
  private hasMoved = false;
  /** The measured marks must be drawn again. */
  private areMarksStale = false;
  private restTimer = 0;
  private isFrameRequested = false;
  /** Number of the newest refinement: an older one stops between two batches. */
  private refinement = 0;
  /** World length of a pixel, mm, for which the chords of arcs were computed last. */
  private refinedForPixel = 0;
  private section: VisibleSection = {};
  private planes = [new Plane(new Vector3(0, 0, 1)), new Plane(new Vector3(0, 0, -1))];
  private measured = new MeasureOverlay();
  /** Number of frames so far: for measurements. */
  drawnFrames = 0;
  onDrawn: () => void = () => {};

  constructor(
    private canvas: HTMLCanvasElement,
    palette: Palette,
  ) {
    this.drawn = new DrawnPath(this.progress, palette, () => this.render());
    this.mark = new RowHighlight(3, undefined, 1.5, this.progress);
    this.camera = new ViewCamera(canvas, () => this.moved());
    this.painter = new Painter(canvas, this.camera.camera, this.drawn.cuts, this.drawn.levels, () => this.render());
    this.drawn.attach(this.painter);
    this.stock = new StockLayer(palette, this.painter.isSoftware, () => this.render());
    this.machine = new MachineLayer(palette, () => this.render());
    this.lathe = new HalfSectionLayer(palette, () => this.render());
    canvas.after(this.lathe.over);
    this.painter.underlay = () => this.lathe.underlay ?? this.stock.underlay;
    this.painter.hasFaces = () => this.machine.object.visible;
    this.tool = new ToolShape(palette);
    this.painter.extras.add(this.contour, this.chords, this.other.object);
    this.painter.own.add(this.differences.own.object);
    this.painter.over.add(this.machine.object, this.fixed.object, this.differences.dots, this.mark.object, this.other.over, this.measured.object, this.tool.object);
    this.setPalette(palette);
    this.setView("iso");
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement!);
    this.resize();
  }

  get origin(): Vec3 {
    return this.path.origin;
  }

  private get path(): Path {
    return this.drawn.path;
  }

  /** Replaces the path by a new one. */
  begin(path: Path): void {
    this.clearPath();
    this.drawn.path = path;
    this.painter.showsIncomplete = true;
    this.painter.changed();
  }

  private clearPath(): void {
    this.drawn.clear();
    for (const group of [this.contour, this.chords]) clearGroup(group);
    this.differences.clear();
    this.mark.clear();
  }

  add(batch: Batch): void {
    const isFirst = this.drawn.batches.length === 0;
    const drawn = this.drawn.add(batch, this.tolerance(), this.rowFilter(batch));
    if (isFirst) this.other.setViewOrigin(this.path.origin);
    if (!this.camera.userMoved && (isFirst || !this.camera.contains(batch.points, 3 * VISIBILITY_STRIDE))) this.fit(true);
    for (const lines of [drawn.cuts?.object, drawn.rapids]) if (lines) this.painter.added(lines);
    this.render();
  }

  /** Draws the path in full, after its last batch. */
  async finish(): Promise<void> {
    const { path } = this;
    this.other.setViewOrigin(path.origin);
    this.drawn.thinFirstBatches();
    // The levels of detail first: they are shown until the picture of the whole path is drawn.
    if (this.drawn.colorBy !== "tool") await this.drawn.recolor();
    else await this.drawn.simplify();
    if (path !== this.path) return;
    this.painter.showsIncomplete = false;
    if (!this.camera.userMoved) this.fit();
    else await this.refine(true);
    this.changed();
  }

  setColorBy(by: ColorBy): void {
    this.drawn.colorBy = by;
    void this.drawn.recolor();
    this.changed();
  }

  setPalette(palette: Palette): void {
    this.drawn.setPalette(palette);
    this.painter.renderer.setClearColor(new Color(palette.background));
    this.progress.setBackground(palette.background);
    this.contourMaterial.color.set(palette.contour);
    this.other.setColor(palette.other);
    this.differences.setColor(palette.difference);
    this.chordMaterial.color.set(palette.chord);
    this.fixed.setColor(palette.travel);
    this.mark.setColor(palette.mark, palette.markEdge);
    this.measured.setColor(palette.measure);
    this.tool.setPalette(palette);
    this.stock.setPalette(palette);
    this.machine.setPalette(palette);
    this.lathe.setPalette(palette);
    void this.drawn.recolor();
    this.changed();
  }

  /** Sets the stock of the path, which comes after the path, or none. */
  setStock(stock: StockBefore | undefined): void {
    this.stock.begin(stock, this.path.origin);
    if (stock && !this.camera.userMoved) this.fit();
    this.render();
  }

  /** Sets the half sections of a lathe's stock, or none; `slot` gives the colour index of a tool. */
  setHalfSections(sections: HalfSections | undefined, slot: (tool: number) => number): void {
    this.lathe.begin(sections, this.path.origin, slot);
    if (sections && !this.camera.userMoved) this.fit();
    this.render();
  }

  /** Sets the side of a lathe's turret, undefined for a mill. */
  setLathe(turret: TurretSide | undefined): void {
    if (this.camera.setLathe(turret)) this.fit();
  }

  /** Draws a frame after a change of the stock. */
  redraw(): void {
    this.render();
  }

  /** Adds the programmed contour of compensated moves, next to the path of the tool centre. */
  addContour(batch: Batch, origin: Vec3): void {
    const lines = linesOf(batch, this.tolerance());
    const object = new LineSegments(lineGeometry(lines.cuts.points), this.contourMaterial);
    object.computeLineDistances();
    object.position.set(...difference(origin, this.path.origin));
    this.contour.add(object);
    this.changed();
  }

  /** Begins another path of the other program, and removes the one before. */
  beginOther(path: Path): void {
    this.differences.clear();
    this.other.begin(path);
    this.changed();
  }

  addOther(batch: Batch): void {
    this.other.add(batch, this.tolerance(this.other.path), this.drawn.maxWideRows);
    this.other.setViewOrigin(this.path.origin);
    this.changed();
  }

  /** Draws the other path in full, after its last batch. */
  async finishOther(): Promise<void> {
    if (!this.camera.userMoved) return this.fit();
    if (await this.other.refine(this.tolerance(this.other.path), this.drawn.maxWideRows)) this.changed();
  }

  showOwn(shown: boolean): void {
    this.painter.own.visible = this.contour.visible = this.chords.visible = shown;
    this.changed();
  }

  showOther(shown: boolean): void {
    this.other.show(shown);
    this.changed();
  }

  /** Marks where the two paths differ. */
  markDifferences(differences: DifferenceRows): void {
    const { path, other } = this;
    this.differences.set(differences, [path, other.path], [this.tolerance(), this.tolerance(other.path)]);
    this.changed();
  }

  /** Zooms to a box in the frame of the run, without rotating the view. */
  zoomTo({ low, high }: Bounds): void {
    const { origin } = this.path;
    this.camera.zoomTo({ low: difference(low, origin), high: difference(high, origin) }, ZOOM_FRACTION);
    void this.refine();
    this.changed();
  }

  setChords(points: Float32Array | undefined, origin: Vec3): void {
    clearGroup(this.chords);
    if (points && points.length > 0) {
      const object = new LineSegments(lineGeometry(points), this.chordMaterial);
      object.position.set(...difference(origin, this.path.origin));
      this.chords.add(object);
    }
    this.changed();
  }

  /** Sets the zeros of work offsets and the travel box of the machine, in the frame of the run. */
  setFixed(zeros: Vec3[], travel: Bounds | undefined): void {
    const { origin } = this.path;
    const box = travel && { low: difference(travel.low, origin), high: difference(travel.high, origin) };
    const axisLength = longestSide(this.path.bounds, 120) / 12;
    this.fixed.set(zeros.map((zero) => difference(zero, origin)), box, axisLength);
    this.render();
  }

  showTravel(shown: boolean): void {
    this.fixed.showTravel(shown);
    this.render();
  }

  showRapids(shown: boolean): void {
    this.painter.rapids.visible = shown;
    this.drawn.levels.showRapids(shown);
    this.other.showRapids(shown);
    this.changed();
  }

  /** Marks the rows from the first to the last, or none, and removes the marks of the other path. */
  markRows(rows: [number, number] | undefined): void {
    this.markBoth(rows ? [rows] : [], []);
  }

  /** Marks ranges of rows of the path and of the other path. */
  markBoth(own: [number, number][], other: [number, number][]): void {
    this.mark.set(this.path, this.painter.own.visible ? own : [], this.tolerance());
    this.other.mark.set(this.other.path, other, this.tolerance(this.other.path));
    this.render();
  }

  /** Draws the path pale after `rows` rows; `Infinity` draws nothing pale. */
  showDone(rows: number): void {
    const before = this.progress.done;
    if (rows === before) return;
    this.progress.set(rows);
    // Going forward only changes the colour of the rows in between.
    if (rows > before && rows !== Infinity) {
      this.painter.repaint(drawGroupsOn(this.drawn.batches, Math.floor(before), Math.floor(rows), this.painter.rapids.visible));
    } else this.painter.changed();
    this.render();
  }

  /** Rows that are drawn as done: for tests. */
  get doneRows(): number {
    return this.progress.done;
  }

  /** Shows the tool at a position relative to the origin of the path, with its shank along a direction; undefined hides it. */
  placeTool(at: Vec3 | undefined, up: Vec3 = [0, 0, 1]): void {
    this.tool.place(at, up);
    this.render();
  }

  /** Position of the tool in the frame of the run, and the direction of its axis: for tests. */
  toolPose(): { at: Vec3; up: Vec3; width: number; isShown: boolean } {
    const { position, quaternion } = this.tool.object;
    const at = position.toArray().map((value, axis) => value + this.path.origin[axis]!) as Vec3;
    return { at, up: new Vector3(0, 0, 1).applyQuaternion(quaternion).toArray(), width: this.tool.width, isShown: this.tool.object.visible };
  }

  setToolShape(tool: DrawnTool | undefined): void {
    this.tool.setTool(tool, longestSide(this.path.bounds, 50));
    this.render();
  }

  /** Limits which part of the path is shown. */
  setSection(section: VisibleSection): void {
    const { tool, lines } = this.section;
    const isSame = section.tool === tool && String(section.lines) === String(lines);
    this.section = section;
    this.updateClipping();
    if (!isSame) {
      const tolerance = this.tolerance();
      for (const drawn of this.drawn.batches) this.drawn.update(drawn, tolerance, this.rowFilter(drawn.batch));
      void this.drawn.simplify();
    }
    this.changed();
  }

  private rowFilter(batch: Batch): RowFilter | undefined {
    const { tool, lines } = this.section;
    if (tool === undefined && !lines) return undefined;
    const [from, to] = lines ?? [0, Infinity];
    return (row) =>
      (tool === undefined || batch.tool[row] === tool) &&
      (!lines || (batch.file[row] === 0 && batch.line[row]! >= from && batch.line[row]! <= to));
  }

  /** Sets the clipping planes below and above the section. */
  private updateClipping(): void {
    const { depth } = this.section;
    const planes = depth ? this.planes : [];
    if (depth) {
      this.planes[0]!.constant = -(depth[0] - this.path.origin[2]);
      this.planes[1]!.constant = depth[1] - this.path.origin[2];
    }
    const { thin, wide } = this.drawn.cutMaterials;
    for (const material of [thin, wide, this.drawn.rapidMaterial, this.contourMaterial, this.chordMaterial]) {
      material.clippingPlanes = planes;
      material.needsUpdate = true;
    }
    this.differences.clip(planes);
    this.other.clip(planes);
  }

  /** Shows a measured distance between two points, relative to the origin of the path. */
  showMeasured(from: Vec3 | undefined, to: Vec3 | undefined): void {
    this.measured.show(from, to, this.camera.screen());
    this.render();
  }

  /** Marks the feature that a click would measure; undefined marks nothing. */
  showSnap(feature: PathFeature | undefined): void {
    this.measured.showSnap(feature, this.camera.screen());
    this.render();
  }

  /** The feature that is marked: for tests. */
  get snapped(): PathFeature | undefined {
    return this.measured.snapped;
  }

  /** The visible row at a position on the canvas, CSS pixels. */
  pick(x: number, y: number): PickedPoint | undefined {
    if (!this.painter.own.visible) return undefined;
    const [low, high] = this.section.depth ?? [-Infinity, Infinity];
    return pick(this.drawn.batches, this.camera, this.canvas, [x, y], this.painter.rapids.visible, (at) => {
      const z = at[2] + this.path.origin[2];
      return z >= low - 1e-3 && z <= high + 1e-3;
    });
  }

  /** The row of the other path at a position on the canvas, CSS pixels. */
  pickOther(x: number, y: number): PickedPoint | undefined {
    return this.other.pick(this.camera, this.canvas, [x, y]);
  }

  /** The position on the canvas, CSS pixels, of a point relative to the origin of the path. */
  project(at: Vec3): [number, number] {
    return this.camera.project(at);
  }

  /** The directions of X, Y and Z on the screen: right, up and towards the viewer. */
  axes(): Vec3[] {
    return this.camera.axes();
  }

  setView(view: ViewName): void {
    this.camera.look(view);
    this.fit();
  }

  /** Fits everything into the view; with `grows` there is room for more. */
  fit(grows = false): void {
    const box = this.drawnBox();
    this.camera.fit(box, (inverse) => this.edges(box, inverse), grows);
    this.moved();
    // Arcs that were out of sight may have coarse chords.
    if (!grows) void this.refine(true);
  }

  /** The box of path, other path and stock, relative to the origin, mm. */
  private drawnBox(): Bounds {
    const box = new Box3();
    const { bounds } = this.path;
    if (bounds) box.set(new Vector3(...bounds.low), new Vector3(...bounds.high));
    const other = this.other.bounds(this.path.origin);
    if (other) box.union(new Box3(new Vector3(...other.low), new Vector3(...other.high)));
    const stock = this.stock.bounds() ?? this.lathe.bounds(bounds);
    if (stock) box.union(new Box3(new Vector3(...stock.low), new Vector3(...stock.high)));
    if (box.isEmpty()) box.set(new Vector3(-10, -10, -10), new Vector3(10, 10, 10));
    return { low: box.min.toArray(), high: box.max.toArray() };
  }

  /** The extent of everything in the view, mm. */
  private edges(box: Bounds, inverse: ArrayLike<number>): ViewEdges {
    const extent = new ViewExtent(inverse);
    // Some points of a long path are enough.
    const step = 3 * Math.max(1, Math.floor(this.path.rows / EXTENT_POINTS));
    for (const { lines } of this.drawn.batches) {
      extent.add(lines.cuts.points, step);
      extent.add(lines.rapids.points);
    }
    if (extent.isEmpty || this.other.isShown || this.stock.bounds() || this.lathe.sections) extent.addBox(box);
    return extent.edges;
  }

  /** How far the chords of an arc may be from it at the present zoom. */
  private tolerance(path = this.path): ArcTolerance {
    return screenTolerance(this.camera, difference(path.origin, this.path.origin), path.rows > SIMPLIFIED_FROM_ROWS);
  }

  /** Computes the chords of arcs again, a batch at a time, when the zoom has changed so much that it is visible, or `always`. */
  private async refine(always = false): Promise<void> {
    const number = ++this.refinement;
    const pixel = this.camera.pixel();
    const curved = this.drawn.batches.filter(({ batch }) => batch.arcRows.length > 0);
    const isZoomed = pixel < this.refinedForPixel / REFINE_FACTOR || pixel > this.refinedForPixel * COARSEN_FACTOR;
    // The chords of arcs out of sight are coarse, so moving the view needs new ones, too.
    if (!(isZoomed || always || this.camera.userMoved)) return;
    this.mark.update(this.tolerance());
    this.differences.update(this.tolerance(), this.tolerance(this.other.path));
    if (await this.other.refine(this.tolerance(this.other.path), this.drawn.maxWideRows)) this.changed();
    if (curved.length === 0 || number !== this.refinement) return;
    this.refinedForPixel = pixel;
    const tolerance = this.tolerance();
    for (const drawn of curved) {
      this.drawn.update(drawn, tolerance, this.rowFilter(drawn.batch));
      if (drawn.batch.rows < SIMPLIFIED_FROM_ROWS) continue;
      await yieldToEventLoop();
      if (number !== this.refinement) return;
    }
    this.changed();
  }

  private moved(): void {
    this.hasMoved = this.areMarksStale = true;
    if (this.camera.userMoved && !this.turning) {
      this.turning = true;
      this.painter.pace.begin();
    }
    this.changed();
  }

  /** Draws in full detail once the view rests. */
  private rest(): void {
    this.turning = false;
    void this.refine();
    this.changed();
  }

  get isTurning(): boolean {
    return this.turning;
  }

  /** Whether everything is drawn in full detail, and the levels of detail are ready. */
  get isComplete(): boolean {
    const isReady = this.path.rows < SIMPLIFIED_FROM_ROWS || this.drawn.levels.isReady;
    return this.hasWindowSize && !this.turning && isReady && this.painter.isComplete && this.stock.isComplete && this.lathe.isComplete;
  }

  /** Whether the canvas has the size of its pane. */
  private get hasWindowSize(): boolean {
    const { clientWidth, clientHeight } = this.canvas.parentElement!;
    return this.width === Math.max(1, clientWidth) && this.height === Math.max(1, clientHeight);
  }

  /** Lines of the last frame that are one pixel wide: for tests and measurements. */
  get drawnLines(): number {
    return this.painter.drawnLines;
  }

  private resize(): void {
    const parent = this.canvas.parentElement!;
    const [width, height] = [Math.max(1, parent.clientWidth), Math.max(1, parent.clientHeight)];
    [this.width, this.height] = [width, height];
    this.camera.resize(width, height);
    this.painter.resize(width, height);
    if (!this.camera.userMoved) this.fit();
    this.render();
  }

  /** Draws the path again, after a change of it or of the camera. */
  private changed(): void {
    this.painter.changed();
    this.render();
  }

  /** Requests a frame. */
  private render(): void {
    if (this.isFrameRequested) return;
    this.isFrameRequested = true;
    requestAnimationFrame((now) => {
      this.isFrameRequested = false;
      if (this.turning && this.hasMoved) {
        this.hasMoved = false;
        this.painter.pace.frame(now);
        // Counted from the start of a frame, so that a slow frame is not taken for rest.
        window.clearTimeout(this.restTimer);
        this.restTimer = window.setTimeout(() => this.rest(), REST_MS);
      }
      // Dashes keep their length on the screen.
      const pixel = this.camera.pixel();
      for (const [material, [dash, gap]] of [[this.drawn.rapidMaterial, RAPID_DASH_PIXELS], [this.contourMaterial, CONTOUR_DASH_PIXELS]] as const) {
        material.dashSize = dash * pixel;
        material.gapSize = gap * pixel;
      }
      this.other.scaleDashes(pixel);
      if (this.areMarksStale) this.measured.draw(this.camera.screen());
      this.areMarksStale = false;
      this.stock.prepare(this.painter.renderer, this.camera.camera, this.turning);
      this.lathe.prepare(this.painter.renderer, this.camera.camera);
      this.painter.paint(this.turning);
      this.drawnFrames++;
      this.onDrawn();
    });
  }
}
