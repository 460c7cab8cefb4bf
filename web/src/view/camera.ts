// The camera: its standard views, its control by the pointer, and fitting of the path.

import { Matrix4, OrthographicCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Bounds, Vec3 } from "../path/batch";
import { type ViewEdges, ViewExtent } from "./extent";

export type ViewName = "top" | "front" | "right" | "iso";

/** The direction from the path to the camera, for each view. */
const VIEW_DIRECTIONS: Record<ViewName, Vec3> = {
  top: [0, 0, 1],
  front: [0, -1, 0],
  right: [1, 0, 0],
  iso: [1, -1, 1],
};

/** The side of the axis on which a lathe has its turret. */
export type TurretSide = "rear" | "front";

/** The direction to the camera and the up vector of each view of a lathe: Z points right on the screen, X to the side of the turret. */
function latheView(turret: TurretSide, view: ViewName): { from: Vec3; up: Vec3 } {
  const side = turret === "rear" ? 1 : -1;
  const up: Vec3 = [side, 0, 0];
  switch (view) {
    case "top":
      return { from: [0, side, 0], up };
    case "front":
      return { from: [-side, 0, 0], up: [0, side, 0] };
    case "right":
      return { from: [0, 0, 1], up };
    case "iso":
      return { from: [0.5 * side, side, 0.7], up };
  }
}

/** How much of the view a fitted path takes up. */
const FIT_FRACTION = 0.86;
/** The same for a path that still grows: with room to grow it is not fitted and drawn again for each batch. */
const GROWING_FIT_FRACTION = 0.55;

/** Distance of the near and far planes, mm: larger than any machine, and small enough for a depth resolution of 0.01 mm. */
const CLIP_DISTANCE_MM = 5e4;

export class ViewCamera {
  readonly camera = new OrthographicCamera(-1, 1, 1, -1, -CLIP_DISTANCE_MM, CLIP_DISTANCE_MM);
  private controls: OrbitControls;
  private view: ViewName = "iso";
  private turret: TurretSide | undefined;
  /** Width of the canvas, CSS pixels. */
  private width = 1;
  /** The user has moved the camera: the path is no longer fitted automatically. */
  userMoved = false;

  constructor(
    private canvas: HTMLCanvasElement,
    private moved: () => void,
  ) {
    this.camera.up.set(0, 0, 1);
    this.controls = this.makeControls();
  }

  private makeControls(): OrbitControls {
    const controls = new OrbitControls(this.camera, this.canvas);
    controls.enableDamping = false;
    controls.zoomToCursor = true;
    controls.rotateSpeed = 0.8;
    controls.addEventListener("change", this.moved);
    controls.addEventListener("start", () => (this.userMoved = true));
    return controls;
  }

  /** Sets the side of a lathe's turret, undefined for a mill; returns whether it has changed. */
  setLathe(turret: TurretSide | undefined): boolean {
    if (turret === this.turret) return false;
    this.turret = turret;
    this.look(turret ? "top" : "iso");
    return true;
  }

  /** Sets the up vector, about which the pointer orbits; the controls read it only when they are constructed. */
  private setUp([x, y, z]: Vec3): void {
    const { up } = this.camera;
    if (up.x === x && up.y === y && up.z === z) return;
    up.set(x, y, z);
    const { target } = this.controls;
    this.controls.dispose();
    this.controls = this.makeControls();
    this.controls.target.copy(target);
  }

  look(view: ViewName): void {
    this.view = view;
    this.userMoved = false;
  }

  resize(width: number, height: number): void {
    this.width = width;
    // Half the height of the view at zoom 1, mm.
    const half = 50;
    const aspect = width / height;
    Object.assign(this.camera, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
    this.camera.updateProjectionMatrix();
  }

  /** Fits the content of a box into the view; `edgesOf` gives the edges of the content for a view matrix. With `grows` there is room for more. */
  fit({ low, high }: Bounds, edgesOf: (inverse: ArrayLike<number>) => ViewEdges, grows: boolean): void {
    const { camera } = this;
    const center = new Vector3(...low).add(new Vector3(...high)).multiplyScalar(0.5);
    const diagonal = new Vector3(...high).sub(new Vector3(...low)).length() || 1;
    const direction = this.turret ? latheView(this.turret, this.view) : { from: VIEW_DIRECTIONS[this.view], up: [0, 0, 1] as Vec3 };
    const from = new Vector3(...direction.from).normalize();
    // From exactly above, the rotation about Z would be undefined.
    if (!this.turret && this.view === "top") from.y -= 1e-5;
    this.setUp(direction.up);
    const lookAt = (target: Vector3) => {
      camera.position.copy(target).addScaledVector(from, diagonal * 4 + 10);
      this.controls.target.copy(target);
      camera.lookAt(target);
      camera.updateMatrixWorld();
    };
    lookAt(center);
    const [left, right, bottom, top] = edgesOf(camera.matrixWorldInverse.elements);
    const m = camera.matrixWorld.elements;
    center
      .addScaledVector(new Vector3(m[0]!, m[1]!, m[2]!), (left + right) / 2)
      .addScaledVector(new Vector3(m[4]!, m[5]!, m[6]!), (bottom + top) / 2);
    lookAt(center);
    // A path that is a point in this view must not be enlarged without limit.
    const minSize = diagonal * 1e-3;
    camera.zoom = (grows ? GROWING_FIT_FRACTION : FIT_FRACTION) * Math.min(
      (camera.right - camera.left) / Math.max(right - left, minSize),
      (camera.top - camera.bottom) / Math.max(top - bottom, minSize),
    );
    camera.updateProjectionMatrix();
    this.controls.update();
  }

  /** Zooms so that a box takes up a fraction of the view, without rotating it. */
  zoomTo(box: Bounds, fraction: number): void {
    const { camera, controls } = this;
    const center = new Vector3(...box.low).add(new Vector3(...box.high)).multiplyScalar(0.5);
    camera.position.sub(controls.target).add(center);
    controls.target.copy(center);
    camera.updateMatrixWorld();
    const extent = new ViewExtent(camera.matrixWorldInverse.elements);
    extent.addBox(box);
    const [left, right, bottom, top] = extent.edges;
    const { left: l, right: r, top: t, bottom: b } = camera;
    camera.zoom = fraction * Math.min((r - l) / Math.max(right - left, 1e-9), (t - b) / Math.max(top - bottom, 1e-9));
    camera.updateProjectionMatrix();
    this.userMoved = true;
    controls.update();
  }

  /** Whether points are in the view; of the coordinates only those of a point every `step` numbers are checked. */
  contains(points: Float32Array, step: number): boolean {
    const extent = new ViewExtent(this.camera.matrixWorldInverse.elements);
    extent.add(points, step);
    const [left, right, bottom, top] = extent.edges;
    const { camera } = this;
    return (
      extent.isEmpty ||
      (left >= camera.left / camera.zoom && right <= camera.right / camera.zoom &&
        bottom >= camera.bottom / camera.zoom && top <= camera.top / camera.zoom)
    );
  }

  /** World length of a CSS pixel, mm. */
  pixel(): number {
    return (this.camera.right - this.camera.left) / this.camera.zoom / this.width;
  }

  /** The directions to the right and up on the screen, and the world length of a pixel, mm. */
  screen(): { right: Vec3; up: Vec3; pixel: number } {
    const m = this.camera.matrixWorld.elements;
    return { right: [m[0]!, m[1]!, m[2]!], up: [m[4]!, m[5]!, m[6]!], pixel: this.pixel() };
  }

  /** World length of the shorter side of the view, mm. */
  shorterSide(): number {
    const { left, right, top, bottom, zoom } = this.camera;
    return Math.min(right - left, top - bottom) / zoom;
  }

  /** Takes points to normalized device coordinates. */
  matrix(): Matrix4 {
    return new Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse);
  }

  /** The position on the canvas, CSS pixels, of a point relative to the origin of the path. */
  project(at: Vec3): [number, number] {
    const v = new Vector3(...at).project(this.camera);
    const { clientWidth, clientHeight } = this.canvas;
    return [((v.x + 1) / 2) * clientWidth, ((1 - v.y) / 2) * clientHeight];
  }

  /** The directions of X, Y and Z on the screen: right, up and towards the viewer. */
  axes(): Vec3[] {
    const { elements } = this.camera.matrixWorldInverse;
    return [0, 4, 8].map((column) => [elements[column]!, elements[column + 1]!, elements[column + 2]!] as Vec3);
  }
}
