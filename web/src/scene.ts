// The path in space: three.js, drawn when something has changed and not otherwise.

import {
  Box3,
  Color,
  ColorManagement,
  Group,
  LinearSRGBColorSpace,
  LineBasicMaterial,
  LineDashedMaterial,
  LineSegments,
  Matrix4,
  OrthographicCamera,
  Plane,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { Coarse } from "./coarse";
import { type ColorBy, type Palette, colorOf } from "./colors";
import { type Edges, Extent, difference, longest } from "./fit";
import { Fixed } from "./fixed";
import { type Keep, type Lines, drawn, nearest, someRows } from "./lines";
import { type Batch, type Bounds, Path, type Vec3, arcReach } from "./path";
import { MOST_WIDE, StrokeMaterials, Strokes, geometryOf } from "./strokes";
import { ToolShape } from "./tool";

export type ViewName = "top" | "front" | "right" | "iso";

/** From where each view looks. */
const VIEWS: Record<ViewName, Vec3> = {
  top: [0, 0, 1],
  front: [0, -1, 0],
  right: [1, 0, 0],
  iso: [1, -1, 1],
};

/** Rows from which on fewer lines are drawn while the view turns. */
const MANY = 120_000;
/** How long the view must be still before all of it is drawn again, ms. */
const STILL = 160;
/** How far from a line a click may be, pixels. */
const REACH = 8;

// Colours are drawn as they are written: the page has no light that would need linear ones.
ColorManagement.enabled = false;

interface DrawnBatch {
  batch: Batch;
  cuts: Strokes | undefined;
  rapids: LineSegments | undefined;
  lines: { cuts: Lines; rapids: Lines };
}

export interface Picked {
  row: number;
  /** How far along the row, from 0 to 1. */
  share: number;
  /** Relative to the origin of the path, mm; an end of the row where one is near. */
  at: Vec3;
}

/** What of the path is shown; what is not said is all. */
export interface Section {
  tool?: number;
  /** Lines of the program, from and to, both counted. */
  lines?: [number, number];
  /** Lowest and highest place, in the frame of the run, mm. */
  depth?: [number, number];
}

/** How much of the view a fitted path takes. */
const ROOM = 0.86;

/** How near an end must be to be meant, pixels. */
const SNAP = 9;

export class PathView {
  private scene = new Scene();
  private camera = new OrthographicCamera(-1, 1, 1, -1, -1e6, 1e6);
  private renderer: WebGLRenderer;
  private controls: OrbitControls;
  private path = new Path();
  private drawnBatches: DrawnBatch[] = [];
  private cuts = new Group();
  private rapids = new Group();
  private coarse = new Coarse();
  private contour = new Group();
  private ghost = new Group();
  private chords = new Group();
  private fixed = new Fixed();
  private mark = new LineSegments2();
  private markMaterial = new LineMaterial({ linewidth: 4, depthTest: false });
  private cutMaterials = new StrokeMaterials();
  private rapidMaterial = new LineDashedMaterial({ transparent: true, opacity: 0.75 });
  private contourMaterial = new LineDashedMaterial({ transparent: true, opacity: 0.9 });
  private ghostMaterial = new LineBasicMaterial({ transparent: true, opacity: 0.55 });
  private chordMaterial = new LineBasicMaterial({ depthTest: false });
  private tool: ToolShape;
  private palette: Palette;
  private colorBy: ColorBy = "tool";
  private turning = false;
  private stillTimer = 0;
  private wanted = false;
  /** World length of a pixel when arcs were cut last. */
  private cutFor = 0;
  private userMoved = false;
  private view: ViewName = "iso";
  private section: Section = {};
  private planes = [new Plane(new Vector3(0, 0, 1)), new Plane(new Vector3(0, 0, -1))];
  private measured = new LineSegments2();
  private measuredMaterial = new LineMaterial({ linewidth: 2, depthTest: false });
  /** Frames that were drawn: for measurements. */
  drawnFrames = 0;
  onDrawn: () => void = () => {};

  constructor(
    private canvas: HTMLCanvasElement,
    palette: Palette,
  ) {
    this.palette = palette;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: false });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.rotateSpeed = 0.8;
    this.controls.addEventListener("change", () => this.moved());
    this.controls.addEventListener("start", () => (this.userMoved = true));
    this.tool = new ToolShape(palette);
    this.mark.renderOrder = 5;
    this.mark.frustumCulled = false;
    this.mark.material = this.markMaterial;
    this.measured.material = this.measuredMaterial;
    this.measured.renderOrder = 6;
    this.measured.frustumCulled = false;
    this.measured.visible = false;
    this.renderer.localClippingEnabled = true;
    this.mark.visible = false;
    this.chords.renderOrder = 4;
    this.scene.add(
      this.fixed.object, this.ghost, this.rapids, this.cuts, this.coarse.object, this.contour, this.chords,
      this.mark, this.measured, this.tool.object,
    );
    this.setPalette(palette);
    this.setView("iso");
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement!);
    this.resize();
  }

  get origin(): Vec3 {
    return this.path.origin;
  }

  /** A new path begins; the old one stays until the first batch of the new one is there. */
  begin(path: Path): void {
    this.clearPath();
    this.path = path;
  }

  private clearPath(): void {
    for (const group of [this.cuts, this.rapids, this.contour, this.chords]) empty(group);
    this.coarse.clear();
    this.drawnBatches = [];
    this.mark.visible = false;
  }

  add(batch: Batch): void {
    const isFirst = this.drawnBatches.length === 0;
    if (!this.userMoved) this.fit(false);
    this.cutFor = this.pixel();
    const part: DrawnBatch = {
      batch,
      cuts: undefined,
      rapids: undefined,
      lines: drawn(batch, this.tolerance(), this.keep(batch)),
    };
    this.drawnBatches.push(part);
    this.put(part);
    if (isFirst && !this.userMoved) this.fit();
    this.render();
  }

  /** The whole path is there. */
  finish(): void {
    if (this.path.rows > MOST_WIDE) {
      // The first batches did not know that there would be so many.
      for (const part of this.drawnBatches) if (part.cuts?.isWide) this.put(part);
    }
    if (!this.userMoved) this.fit();
    this.refine(true);
    this.makeCoarse();
    if (this.colorBy === "speed") this.recolor();
    this.render();
  }

  /** Puts the lines of a batch into the scene, instead of those before. */
  private put(part: DrawnBatch): void {
    part.cuts?.remove();
    remove(part.rapids);
    const { cuts, rapids } = part.lines;
    part.cuts = undefined;
    part.rapids = undefined;
    if (cuts.count > 0) {
      const wide = this.path.rows <= MOST_WIDE && cuts.count <= MOST_WIDE;
      part.cuts = new Strokes(cuts.points, this.colors(part.batch, cuts), this.cutMaterials, wide);
      this.cuts.add(part.cuts.object);
    }
    if (rapids.count > 0) {
      part.rapids = new LineSegments(geometryOf(rapids.points), this.rapidMaterial);
      part.rapids.computeLineDistances();
      part.rapids.frustumCulled = false;
      this.rapids.add(part.rapids);
    }
  }

  private makeCoarse(): void {
    const { tool, lines } = this.section;
    if (this.path.rows < MANY || tool !== undefined || lines) return this.coarse.clear();
    const batches = this.drawnBatches.map(({ batch }) => batch);
    this.coarse.build(batches, this.path.rows, (batch, lines) => this.colors(batch, lines), this.cutMaterials);
  }

  /** The colours of both ends of each line. */
  private colors(batch: Batch, lines: Lines): Uint8Array {
    const colors = new Uint8Array(6 * lines.count);
    const { tool, feed } = batch;
    const range: [number, number] = [this.path.minFeed, this.path.maxFeed];
    let last = -1;
    let rgb: [number, number, number] = [0, 0, 0];
    for (let at = 0; at < lines.count; at++) {
      const row = lines.rows ? lines.rows[at]! : at;
      if (row !== last) rgb = colorOf(this.palette, this.colorBy, tool[row]!, feed[row]!, range);
      last = row;
      const [r, g, b] = rgb;
      colors[6 * at] = colors[6 * at + 3] = r;
      colors[6 * at + 1] = colors[6 * at + 4] = g;
      colors[6 * at + 2] = colors[6 * at + 5] = b;
    }
    return colors;
  }

  private recolor(): void {
    for (const part of this.drawnBatches) {
      part.cuts?.setColors(this.colors(part.batch, part.lines.cuts));
    }
    this.makeCoarse();
  }

  setColorBy(by: ColorBy): void {
    this.colorBy = by;
    this.recolor();
    this.render();
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.renderer.setClearColor(new Color(palette.background));
    this.rapidMaterial.color.set(palette.rapid);
    this.contourMaterial.color.set(palette.contour);
    this.ghostMaterial.color.set(palette.ghost);
    this.chordMaterial.color.set(palette.chord);
    this.fixed.setColor(palette.travel);
    this.markMaterial.color.set(palette.mark);
    this.measuredMaterial.color.set(palette.measure);
    this.tool.setPalette(palette);
    this.recolor();
    this.render();
  }

  /** What compensation was programmed for, beside the path of the tool centre. */
  addContour(batch: Batch, origin: Vec3): void {
    const lines = drawn(batch, this.tolerance());
    const object = new LineSegments(geometryOf(lines.cuts.points), this.contourMaterial);
    object.computeLineDistances();
    object.position.set(...difference(origin, this.path.origin));
    this.contour.add(object);
    this.render();
  }

  /** The path of another machine, where it differs. */
  setGhost(points: number[], origin: Vec3): void {
    empty(this.ghost);
    if (points.length > 0) {
      const object = new LineSegments(geometryOf(new Float32Array(points)), this.ghostMaterial);
      object.position.set(...difference(origin, this.path.origin));
      this.ghost.add(object);
      if (!this.userMoved) this.fit();
    }
    this.render();
  }

  setChords(points: Float32Array | undefined, origin: Vec3): void {
    empty(this.chords);
    if (points && points.length > 0) {
      const object = new LineSegments(geometryOf(points), this.chordMaterial);
      object.position.set(...difference(origin, this.path.origin));
      object.renderOrder = 4;
      this.chords.add(object);
    }
    this.render();
  }

  /** Zeros of work offsets, and the box that the machine can reach; both in the frame of the run. */
  setFixed(zeros: Vec3[], travel: Bounds | undefined): void {
    const own = this.path.origin;
    const box = travel && { low: difference(travel.low, own), high: difference(travel.high, own) };
    const size = longest(this.path.bounds, 120) / 12;
    this.fixed.set(zeros.map((zero) => difference(zero, own)), box, size);
    this.render();
  }

  showTravel(shown: boolean): void {
    this.fixed.showTravel(shown);
    this.render();
  }

  showRapids(shown: boolean): void {
    this.rapids.visible = shown;
    this.render();
  }

  /** Marks rows; none: nothing is marked. */
  markRows(rows: [number, number] | undefined): void {
    this.mark.visible = false;
    if (rows) {
      const points: number[] = [];
      for (const { batch } of this.drawnBatches) {
        const from = Math.max(0, rows[0] - batch.first);
        const to = Math.min(batch.rows - 1, rows[1] - batch.first, from + 50_000);
        if (from <= to) points.push(...someRows(batch, from, to, this.tolerance()));
      }
      if (points.length > 0) {
        this.mark.geometry.dispose();
        this.mark.geometry = new LineSegmentsGeometry().setPositions(points);
        this.mark.visible = true;
      }
    }
    this.render();
  }

  /** Shows the tool at a place, relative to the origin of the path. */
  placeTool(at: Vec3 | undefined): void {
    this.tool.place(at);
    this.render();
  }

  shapeTool(diameter: number | null, length: number | null, corner: number | null): void {
    this.tool.shape(diameter, length, corner, longest(this.path.bounds, 50));
    this.render();
  }

  /** Shows a part of the path only. */
  setSection(section: Section): void {
    this.section = section;
    const tolerance = this.tolerance();
    for (const part of this.drawnBatches) {
      part.lines = drawn(part.batch, tolerance, this.keep(part.batch));
      this.put(part);
    }
    this.cutDepth();
    this.makeCoarse();
    this.render();
  }

  private keep(batch: Batch): Keep | undefined {
    const { tool, lines } = this.section;
    if (tool === undefined && !lines) return undefined;
    const [from, to] = lines ?? [0, Infinity];
    return (row) =>
      (tool === undefined || batch.tool[row] === tool) &&
      (!lines || (batch.file[row] === 0 && batch.line[row]! >= from && batch.line[row]! <= to));
  }

  /** Two planes cut off what is below and above. */
  private cutDepth(): void {
    const { depth } = this.section;
    const planes = depth ? this.planes : [];
    if (depth) {
      this.planes[0]!.constant = -(depth[0] - this.path.origin[2]);
      this.planes[1]!.constant = depth[1] - this.path.origin[2];
    }
    const { thin, wide } = this.cutMaterials;
    for (const material of [thin, wide, this.rapidMaterial, this.contourMaterial, this.chordMaterial]) {
      material.clippingPlanes = planes;
      material.needsUpdate = true;
    }
  }

  /** A line between two places, relative to the origin of the path. */
  showMeasured(from: Vec3 | undefined, to: Vec3 | undefined): void {
    this.measured.visible = from !== undefined;
    if (from) {
      const size = 5 * this.pixel();
      const cross = (at: Vec3) =>
        [0, 1, 2].flatMap((axis) => [-size, size].flatMap((by) => at.map((value, i) => (i === axis ? value + by : value))));
      const points = [...cross(from), ...(to ? [...cross(to), ...from, ...to] : [])];
      this.measured.geometry.dispose();
      this.measured.geometry = new LineSegmentsGeometry().setPositions(points);
    }
    this.render();
  }

  /** The row at a place of the canvas. */
  pick(x: number, y: number): Picked | undefined {
    const matrix = new Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse);
    const { clientWidth, clientHeight } = this.canvas;
    let best: (Picked & { distance: number }) | undefined;
    const [low, high] = this.section.depth ?? [-Infinity, Infinity];
    for (const { batch, lines } of this.drawnBatches) {
      // A cut is meant rather than the rapid over it.
      for (const [own, handicap] of [[lines.cuts, 0], [lines.rapids, 3]] as const) {
        if (own === lines.rapids && !this.rapids.visible) continue;
        const found = nearest(own, matrix.elements, clientWidth, clientHeight, x, y, REACH);
        if (!found || (best && found.distance + handicap >= best.distance)) continue;
        const picked = this.picked(batch, own, found.index, found.share, x, y);
        const z = picked.at[2] + this.path.origin[2];
        if (z < low - 1e-3 || z > high + 1e-3) continue;
        best = { ...picked, distance: found.distance + handicap };
      }
    }
    return best;
  }

  private picked(batch: Batch, lines: Lines, index: number, share: number, x: number, y: number): Picked {
    const own = (at: number) => (lines.rows ? lines.rows[at]! : at);
    const row = own(index);
    let first = index;
    let last = index;
    while (first > 0 && own(first - 1) === row) first--;
    while (last < lines.count - 1 && own(last + 1) === row) last++;
    const p = lines.points;
    const mix = (axis: number) => p[6 * index + axis]! + (p[6 * index + 3 + axis]! - p[6 * index + axis]!) * share;
    const ends: [number, Vec3][] = [
      [0, [p[6 * first]!, p[6 * first + 1]!, p[6 * first + 2]!]],
      [1, [p[6 * last + 3]!, p[6 * last + 4]!, p[6 * last + 5]!]],
    ];
    for (const [end, at] of ends) {
      const [ex, ey] = this.project(at);
      if (Math.hypot(ex - x, ey - y) < SNAP) return { row: batch.first + row, share: end, at };
    }
    const along = (index - first + share) / (last - first + 1);
    return { row: batch.first + row, share: along, at: [mix(0), mix(1), mix(2)] };
  }

  /** Where a place, relative to the origin of the path, is on the canvas, pixels. */
  project(at: Vec3): [number, number] {
    const v = new Vector3(...at).project(this.camera);
    const { clientWidth, clientHeight } = this.canvas;
    return [((v.x + 1) / 2) * clientWidth, ((1 - v.y) / 2) * clientHeight];
  }

  /** The directions of X, Y and Z on the screen: right, up and towards the eye. */
  axes(): Vec3[] {
    const { elements } = this.camera.matrixWorldInverse;
    return [0, 4, 8].map((at) => [elements[at]!, elements[at + 1]!, elements[at + 2]!] as Vec3);
  }

  setView(view: ViewName): void {
    this.view = view;
    this.userMoved = false;
    this.fit();
  }

  /** Everything that is drawn fills the view. */
  fit(render = true): void {
    const { low, high } = this.seen();
    const center = new Vector3(...low).add(new Vector3(...high)).multiplyScalar(0.5);
    const reach = new Vector3(...high).sub(new Vector3(...low)).length() || 1;
    const from = new Vector3(...VIEWS[this.view]).normalize();
    // Seen from exactly above the turn about Z would be undefined.
    if (this.view === "top") from.y -= 1e-5;
    const look = (at: Vector3) => {
      this.camera.up.set(0, 0, 1);
      this.camera.position.copy(at).addScaledVector(from, reach * 4 + 10);
      this.controls.target.copy(at);
      this.camera.lookAt(at);
      this.camera.updateMatrixWorld();
    };
    look(center);
    const [left, right, bottom, top] = this.edges({ low, high });
    const m = this.camera.matrixWorld.elements;
    center
      .addScaledVector(new Vector3(m[0]!, m[1]!, m[2]!), (left + right) / 2)
      .addScaledVector(new Vector3(m[4]!, m[5]!, m[6]!), (bottom + top) / 2);
    look(center);
    const least = reach * 1e-3;
    this.camera.zoom = ROOM * Math.min(
      (this.camera.right - this.camera.left) / Math.max(right - left, least),
      (this.camera.top - this.camera.bottom) / Math.max(top - bottom, least),
    );
    this.camera.updateProjectionMatrix();
    this.controls.update();
    if (render) this.moved();
  }

  /** The box of everything that is to be seen, relative to the origin. */
  private seen(): Bounds {
    const box = new Box3();
    const { bounds } = this.path;
    if (bounds) box.set(new Vector3(...bounds.low), new Vector3(...bounds.high));
    box.union(new Box3().setFromObject(this.ghost));
    if (box.isEmpty()) box.set(new Vector3(-10, -10, -10), new Vector3(10, 10, 10));
    return { low: box.min.toArray(), high: box.max.toArray() };
  }

  /** What is drawn takes of the view, mm from the camera's target. */
  private edges(box: Bounds): Edges {
    const extent = new Extent(this.camera.matrixWorldInverse.elements);
    // Of a long path some points tell enough.
    const step = 3 * Math.max(1, Math.floor(this.path.rows / 50_000));
    for (const { lines } of this.drawnBatches) {
      extent.add(lines.cuts.points, step);
      extent.add(lines.rapids.points);
    }
    if (extent.isEmpty || this.ghost.children.length > 0) extent.addBox(box);
    return extent.edges;
  }

  /** World length of a pixel, mm. */
  private pixel(): number {
    return (this.camera.right - this.camera.left) / this.camera.zoom / Math.max(1, this.canvas.clientWidth);
  }

  /** A quarter of a pixel, for arcs that can be seen; the others stay as coarse as they may. */
  private tolerance(): (arcs: Float32Array, index: number) => number {
    const pixel = this.pixel();
    const matrix = new Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse);
    const center = new Vector3();
    const many = this.path.rows > MANY;
    return (arcs, index) => {
      const reach = arcReach(arcs, index);
      center.set(arcs[13 * index]!, arcs[13 * index + 1]!, arcs[13 * index + 2]!).applyMatrix4(matrix);
      const margin = 1 + (2 * reach * this.camera.zoom) / Math.min(this.camera.right - this.camera.left, this.camera.top - this.camera.bottom);
      const seen = Math.abs(center.x) < margin && Math.abs(center.y) < margin;
      return seen ? pixel * (many ? 0.5 : 0.25) : Math.max(pixel, reach / 20);
    };
  }

  /** Cuts arcs anew when the zoom has changed so much that it shows. */
  private refine(always = false): void {
    const pixel = this.pixel();
    const has = this.drawnBatches.some(({ batch }) => batch.arcRows.length > 0);
    const near = pixel < this.cutFor / 1.5 || pixel > this.cutFor * 4;
    // Where arcs out of sight were left coarse, another part of the path needs its own, too.
    if (!has || !(near || always || this.userMoved)) return;
    this.cutFor = pixel;
    const tolerance = this.tolerance();
    for (const part of this.drawnBatches) {
      if (part.batch.arcRows.length === 0) continue;
      part.lines = drawn(part.batch, tolerance, this.keep(part.batch));
      this.put(part);
    }
  }

  private moved(): void {
    const many = this.path.rows >= MANY && this.coarse.isReady;
    if (many && this.userMoved) this.setTurning(true);
    window.clearTimeout(this.stillTimer);
    this.stillTimer = window.setTimeout(() => {
      this.setTurning(false);
      this.refine();
      this.render();
    }, STILL);
    this.render();
  }

  private setTurning(turning: boolean): void {
    this.turning = turning;
    this.coarse.show(turning);
    this.cuts.visible = !turning;
  }

  get isTurning(): boolean {
    return this.turning;
  }

  private resize(): void {
    const parent = this.canvas.parentElement!;
    const [width, height] = [Math.max(1, parent.clientWidth), Math.max(1, parent.clientHeight)];
    this.renderer.setSize(width, height, false);
    const half = 50;
    const aspect = width / height;
    Object.assign(this.camera, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
    this.camera.updateProjectionMatrix();
    this.markMaterial.resolution.set(width, height);
    this.measuredMaterial.resolution.set(width, height);
    this.cutMaterials.wide.resolution.set(width, height);
    if (!this.userMoved) this.fit(false);
    this.render();
  }

  render(): void {
    if (this.wanted) return;
    this.wanted = true;
    requestAnimationFrame((now) => {
      this.wanted = false;
      this.coarse.frame(now);
      // Dashes keep their length on the screen.
      const pixel = this.pixel();
      this.rapidMaterial.dashSize = 6 * pixel;
      this.rapidMaterial.gapSize = 4 * pixel;
      this.contourMaterial.dashSize = 3 * pixel;
      this.contourMaterial.gapSize = 2 * pixel;
      this.renderer.render(this.scene, this.camera);
      this.drawnFrames++;
      this.onDrawn();
    });
  }
}

function remove(object: LineSegments | undefined): void {
  if (!object) return;
  object.geometry.dispose();
  object.removeFromParent();
}

function empty(group: Group): void {
  for (const object of [...group.children]) remove(object as LineSegments);
}
