// The path of the other program, drawn over that of the program: in one colour and dashed, so that both are visible where they
// coincide.

import { type Object3D, type Plane, Group, LineDashedMaterial, LineSegments, Matrix4 } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Batch, Bounds, Vec3 } from "../path/batch";
import { type ArcTolerance, type LineArrays, linesOf } from "../path/lines";
import { Path } from "../path/path";
import { yieldToEventLoop } from "../view/event-loop";
import { difference } from "../view/extent";
import { disposeLines, lineGeometry } from "../view/line-mesh";
import { type Pickable, type PickedPoint, type PointProjection, pick } from "../view/picking";
import { RowHighlight } from "../view/row-highlight";

/** The page handles its input after each batch of at least this number of rows. */
const UNINTERRUPTED_ROWS = 20_000;
/** Lengths of dashes and gaps, pixels. */
const CUT_DASH_PIXELS: [number, number] = [6, 8];
const RAPID_DASH_PIXELS: [number, number] = [2, 5];

interface OtherPathPart extends Pickable {
  objects: (LineSegments | LineSegments2)[];
}

export class OtherPath {
  /** Drawn with the path of the program. */
  readonly object = new Group();
  /** The rows of the chosen difference. */
  readonly mark = new RowHighlight(2);
  /** The mark, drawn over the paths, and hidden with this one. */
  readonly over = new Group();
  path = new Path();
  private parts: OtherPathPart[] = [];
  private rapids = new Group();
  private cuts = new Group();
  private thin = new LineDashedMaterial({ depthTest: false });
  private wide = new LineMaterial({ linewidth: 1.5, dashed: true, depthTest: false });
  private rapid = new LineDashedMaterial({ depthTest: false, transparent: true, opacity: 0.7 });
  /** Number of the newest refinement: an older one stops between two batches. */
  private refinement = 0;

  /** `onChange` is called before lines are removed; `underlay` is drawn under the path, and hidden with it. */
  constructor(
    private onChange: () => void,
    underlay: Object3D,
  ) {
    this.object.add(underlay, this.cuts, this.rapids);
    this.over.add(this.mark.object);
  }

  /** Whether there are lines, and they are shown. */
  get isShown(): boolean {
    return this.object.visible && this.parts.length > 0;
  }

  begin(path: Path): void {
    this.refinement++;
    this.onChange();
    for (const { objects } of this.parts) objects.forEach(disposeLines);
    this.parts = [];
    this.path = path;
    this.mark.clear();
  }

  add(batch: Batch, tolerance: ArcTolerance, maxWideRows: number): void {
    const part: OtherPathPart = { batch, lines: linesOf(batch, tolerance), objects: [] };
    this.parts.push(part);
    this.replaceObjects(part, maxWideRows);
  }

  private replaceObjects(part: OtherPathPart, maxWideRows: number): void {
    if (part.objects.length > 0) this.onChange();
    part.objects.forEach(disposeLines);
    const { cuts, rapids } = part.lines;
    part.objects = [];
    if (cuts.count > 0) {
      const isWide = this.path.rows <= maxWideRows && cuts.count <= maxWideRows;
      const object = isWide ? this.wideLines(cuts) : thinLines(cuts, this.thin);
      this.cuts.add(object);
      part.objects.push(object);
    }
    if (rapids.count > 0) {
      const object = thinLines(rapids, this.rapid);
      this.rapids.add(object);
      part.objects.push(object);
    }
  }

  private wideLines({ points }: LineArrays): LineSegments2 {
    const geometry = new LineSegmentsGeometry().setPositions(points);
    const object = new LineSegments2(geometry, this.wide);
    object.computeLineDistances();
    object.frustumCulled = false;
    return object;
  }

  /** Computes the chords of arcs for the present zoom; false if a newer call has superseded it. */
  async refine(tolerance: ArcTolerance, maxWideRows: number): Promise<boolean> {
    const number = ++this.refinement;
    this.mark.update(tolerance);
    for (const part of [...this.parts]) {
      const mustBecomeThin = part.objects.some((object) => "isLineSegments2" in object) && this.path.rows > maxWideRows;
      if (part.batch.arcRows.length === 0 && !mustBecomeThin) continue;
      part.lines = linesOf(part.batch, tolerance);
      this.replaceObjects(part, maxWideRows);
      if (part.batch.rows < UNINTERRUPTED_ROWS) continue;
      await yieldToEventLoop();
      if (number !== this.refinement) return false;
    }
    return true;
  }

  /** Sets the origin of the program's path, to which positions in the view are relative. */
  setViewOrigin(origin: Vec3): void {
    const offset = difference(this.path.origin, origin);
    this.object.position.set(...offset);
    this.mark.setOffset(offset);
  }

  /** Its box, relative to the origin of the program's path; undefined where nothing of it is shown. */
  bounds(origin: Vec3): Bounds | undefined {
    const { bounds } = this.path;
    if (!bounds || !this.isShown) return undefined;
    const offset = difference(this.path.origin, origin);
    const moved = (at: Vec3) => at.map((value, axis) => value + offset[axis]!) as Vec3;
    return { low: moved(bounds.low), high: moved(bounds.high) };
  }

  /** Its row at a position on the canvas, CSS pixels. */
  pick(camera: PointProjection, canvas: HTMLCanvasElement, at: [number, number]): PickedPoint | undefined {
    if (!this.object.visible) return undefined;
    const offset = this.object.position;
    const projection: PointProjection = {
      matrix: () => camera.matrix().multiply(new Matrix4().makeTranslation(offset)),
      project: (at) => camera.project([at[0] + offset.x, at[1] + offset.y, at[2] + offset.z]),
    };
    return pick(this.parts, projection, canvas, at, this.rapids.visible, () => true);
  }

  show(shown: boolean): void {
    this.object.visible = this.over.visible = shown;
  }

  showRapids(shown: boolean): void {
    this.rapids.visible = shown;
  }

  setColor(color: string): void {
    for (const material of [this.thin, this.wide, this.rapid]) material.color.set(color);
    this.mark.setColor(color);
  }

  /** Scales the dashes for the world length of a pixel, mm. */
  scaleDashes(pixel: number): void {
    for (const [material, [dash, gap]] of [[this.thin, CUT_DASH_PIXELS], [this.wide, CUT_DASH_PIXELS], [this.rapid, RAPID_DASH_PIXELS]] as const) {
      material.dashSize = dash * pixel;
      material.gapSize = gap * pixel;
    }
  }

  clip(planes: Plane[]): void {
    for (const material of [this.thin, this.wide, this.rapid]) {
      material.clippingPlanes = planes;
      material.needsUpdate = true;
    }
  }
}

function thinLines({ points, count }: LineArrays, material: LineDashedMaterial): LineSegments {
  const object = new LineSegments(lineGeometry(points.subarray(0, 6 * count)), material);
  object.computeLineDistances();
  object.frustumCulled = false;
  return object;
}

