// The path of another program, over that of the shown one: one colour, dashed, so that both are visible
// where they are the same.

import { type Object3D, type Plane, Group, LineDashedMaterial, LineSegments, Matrix4 } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Batch, Bounds, Vec3 } from "../path/batch";
import { type ArcTolerance, type LineArrays, linesOf } from "../path/lines";
import { Path } from "../path/path";
import { yieldToEventLoop } from "../view/event-loop";
import { difference } from "../view/extent";
import { geometryOf } from "../view/line-mesh";
import { type Pickable, type PickedPoint, type PointProjection, pick } from "../view/picking";
import { RowHighlight } from "../view/row-highlight";

/** After a batch of more rows the page may do other work before the next. */
const UNINTERRUPTED_ROWS = 20_000;
/** Dashes and gaps on the screen, pixels. */
const CUT_DASH_PIXELS: [number, number] = [6, 8];
const RAPID_DASH_PIXELS: [number, number] = [2, 5];

interface OtherPathPart extends Pickable {
  objects: (LineSegments | LineSegments2)[];
}

export class OtherPath {
  /** What is drawn with the path of the program. */
  readonly object = new Group();
  /** The rows of the chosen difference. */
  readonly mark = new RowHighlight(2);
  /** The mark, which is hidden with the path. */
  readonly over = new Group();
  path = new Path();
  private parts: OtherPathPart[] = [];
  private rapids = new Group();
  private cuts = new Group();
  private thin = new LineDashedMaterial({ depthTest: false });
  private wide = new LineMaterial({ linewidth: 1.5, dashed: true, depthTest: false });
  private rapid = new LineDashedMaterial({ depthTest: false, transparent: true, opacity: 0.7 });
  private refining = 0;

  /** `changes` is called before lines are removed; `under` is shown and hidden with the path. */
  constructor(
    private changes: () => void,
    under: Object3D,
  ) {
    this.object.add(under, this.cuts, this.rapids);
    this.over.add(this.mark.object);
  }

  /** Whether any of it is visible. */
  get isShown(): boolean {
    return this.object.visible && this.parts.length > 0;
  }

  begin(path: Path): void {
    this.refining++;
    this.changes();
    for (const { objects } of this.parts) objects.forEach(remove);
    this.parts = [];
    this.path = path;
    this.mark.clear();
  }

  add(batch: Batch, tolerance: ArcTolerance, mostWide: number): void {
    const part: OtherPathPart = { batch, lines: linesOf(batch, tolerance), objects: [] };
    this.parts.push(part);
    this.put(part, mostWide);
  }

  private put(part: OtherPathPart, mostWide: number): void {
    if (part.objects.length > 0) this.changes();
    part.objects.forEach(remove);
    const { cuts, rapids } = part.lines;
    part.objects = [];
    if (cuts.count > 0) {
      const isWide = this.path.rows <= mostWide && cuts.count <= mostWide;
      const object = isWide ? this.wideLines(cuts) : lines(cuts, this.thin);
      this.cuts.add(object);
      part.objects.push(object);
    }
    if (rapids.count > 0) {
      const object = lines(rapids, this.rapid);
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

  /** Cuts arcs for the present zoom; false if a newer call has taken over. */
  async refine(tolerance: ArcTolerance, mostWide: number): Promise<boolean> {
    const number = ++this.refining;
    this.mark.cut(tolerance);
    for (const part of [...this.parts]) {
      const isFirstThin = part.objects.some((object) => "isLineSegments2" in object) && this.path.rows > mostWide;
      if (part.batch.arcRows.length === 0 && !isFirstThin) continue;
      part.lines = linesOf(part.batch, tolerance);
      this.put(part, mostWide);
      if (part.batch.rows < UNINTERRUPTED_ROWS) continue;
      await yieldToEventLoop();
      if (number !== this.refining) return false;
    }
    return true;
  }

  /** Where its places are, relative to the origin of the shown path. */
  place(origin: Vec3): void {
    const by = difference(this.path.origin, origin);
    this.object.position.set(...by);
    this.mark.place(by);
  }

  /** Its box, relative to the origin of the shown path. */
  bounds(origin: Vec3): Bounds | undefined {
    const { bounds } = this.path;
    if (!bounds || !this.isShown) return undefined;
    const by = difference(this.path.origin, origin);
    const moved = (at: Vec3) => at.map((value, axis) => value + by[axis]!) as Vec3;
    return { low: moved(bounds.low), high: moved(bounds.high) };
  }

  /** Its row at a position on the canvas, as the shown path is seen. */
  pick(camera: PointProjection, canvas: HTMLCanvasElement, at: [number, number]): PickedPoint | undefined {
    if (!this.object.visible) return undefined;
    const by = this.object.position;
    const sight: PointProjection = {
      matrix: () => camera.matrix().multiply(new Matrix4().makeTranslation(by)),
      project: (place) => camera.project([place[0] + by.x, place[1] + by.y, place[2] + by.z]),
    };
    return pick(this.parts, sight, canvas, at, this.rapids.visible, () => true);
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

  /** Dashes keep their length on the screen. */
  dash(pixel: number): void {
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

function lines({ points, count }: LineArrays, material: LineDashedMaterial): LineSegments {
  const object = new LineSegments(geometryOf(points.subarray(0, 6 * count)), material);
  object.computeLineDistances();
  object.frustumCulled = false;
  return object;
}

function remove(object: LineSegments | LineSegments2): void {
  object.geometry.dispose();
  object.removeFromParent();
}
