// The camera: its views, how the pointer moves it, and how it fits the path.

import { Matrix4, OrthographicCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Bounds, Vec3 } from "../path/batch";
import { type ViewEdges, ViewExtent } from "./extent";

export type ViewName = "top" | "front" | "right" | "iso";

/** The direction from which each view looks. */
const VIEW_DIRECTIONS: Record<ViewName, Vec3> = {
  top: [0, 0, 1],
  front: [0, -1, 0],
  right: [1, 0, 0],
  iso: [1, -1, 1],
};

/** The side of the axis on which a lathe has its turret. */
export type TurretSide = "rear" | "front";

/** From where each view of a lathe looks, and what is up on the screen: Z to the right, X to the side of the turret. */
function turning(turret: TurretSide, view: ViewName): { from: Vec3; up: Vec3 } {
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

/** How much of the view a fitted path takes. */
const FIT_FRACTION = 0.86;
/** The same for a path that still grows: with more room it is not fitted and drawn for each batch. */
const GROWING_FIT_FRACTION = 0.55;

/** How far in front of and behind the camera is visible, mm: beyond every machine, and depths are distinguished to 0.01 mm. */
const DEPTH_MM = 5e4;

export class ViewCamera {
  readonly camera = new OrthographicCamera(-1, 1, 1, -1, -DEPTH_MM, DEPTH_MM);
  private controls: OrbitControls;
  private view: ViewName = "iso";
  private turret: TurretSide | undefined;
  /** Pixels from left to right. */
  private width = 1;
  /** The user has moved the camera: the path is not fitted automatically any more. */
  userMoved = false;

  constructor(
    private canvas: HTMLCanvasElement,
    private moved: () => void,
  ) {
    this.camera.up.set(0, 0, 1);
    this.controls = this.control();
  }

  private control(): OrbitControls {
    const controls = new OrbitControls(this.camera, this.canvas);
    controls.enableDamping = false;
    controls.zoomToCursor = true;
    controls.rotateSpeed = 0.8;
    controls.addEventListener("change", this.moved);
    controls.addEventListener("start", () => (this.userMoved = true));
    return controls;
  }

  /** Sets the side of a lathe's turret, undefined for a mill; true if that is a change. */
  setLathe(turret: TurretSide | undefined): boolean {
    if (turret === this.turret) return false;
    this.turret = turret;
    this.look(turret ? "top" : "iso");
    return true;
  }

  /** What is up: the pointer turns the view about it. */
  private upright([x, y, z]: Vec3): void {
    const { up } = this.camera;
    if (up.x === x && up.y === y && up.z === z) return;
    up.set(x, y, z);
    const { target } = this.controls;
    this.controls.dispose();
    this.controls = this.control();
    this.controls.target.copy(target);
  }

  look(view: ViewName): void {
    this.view = view;
    this.userMoved = false;
  }

  resize(width: number, height: number): void {
    this.width = width;
    const half = 50;
    const aspect = width / height;
    Object.assign(this.camera, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
    this.camera.updateProjectionMatrix();
  }

  /** Fits a box into the view, or rather its content, whose edges `edgesOf` gives. */
  fit({ low, high }: Bounds, edgesOf: (inverse: ArrayLike<number>) => ViewEdges, grows: boolean): void {
    const { camera } = this;
    const center = new Vector3(...low).add(new Vector3(...high)).multiplyScalar(0.5);
    const reach = new Vector3(...high).sub(new Vector3(...low)).length() || 1;
    const direction = this.turret ? turning(this.turret, this.view) : { from: VIEW_DIRECTIONS[this.view], up: [0, 0, 1] as Vec3 };
    const from = new Vector3(...direction.from).normalize();
    // From exactly above, the rotation about Z would be undefined.
    if (!this.turret && this.view === "top") from.y -= 1e-5;
    this.upright(direction.up);
    const look = (at: Vector3) => {
      camera.position.copy(at).addScaledVector(from, reach * 4 + 10);
      this.controls.target.copy(at);
      camera.lookAt(at);
      camera.updateMatrixWorld();
    };
    look(center);
    const [left, right, bottom, top] = edgesOf(camera.matrixWorldInverse.elements);
    const m = camera.matrixWorld.elements;
    center
      .addScaledVector(new Vector3(m[0]!, m[1]!, m[2]!), (left + right) / 2)
      .addScaledVector(new Vector3(m[4]!, m[5]!, m[6]!), (bottom + top) / 2);
    look(center);
    const least = reach * 1e-3;
    camera.zoom = (grows ? GROWING_FIT_FRACTION : FIT_FRACTION) * Math.min(
      (camera.right - camera.left) / Math.max(right - left, least),
      (camera.top - camera.bottom) / Math.max(top - bottom, least),
    );
    camera.updateProjectionMatrix();
    this.controls.update();
  }

  /** A box takes a fraction of the view, seen from where it is seen now. */
  show(box: Bounds, fraction: number): void {
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

  /** Whether points are in the view; only every `step / 3`-th of them is checked. */
  sees(points: Float32Array, step: number): boolean {
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

  /** World length of a pixel, mm. */
  pixel(): number {
    return (this.camera.right - this.camera.left) / this.camera.zoom / this.width;
  }

  /** What lies to the right and up on the screen, and how long a pixel is, mm. */
  screen(): { right: Vec3; up: Vec3; pixel: number } {
    const m = this.camera.matrixWorld.elements;
    return { right: [m[0]!, m[1]!, m[2]!], up: [m[4]!, m[5]!, m[6]!], pixel: this.pixel() };
  }

  /** World length of the shorter side of the view, mm. */
  shorterSide(): number {
    const { left, right, top, bottom, zoom } = this.camera;
    return Math.min(right - left, top - bottom) / zoom;
  }

  /** Takes points to the cube from -1 to 1. */
  matrix(): Matrix4 {
    return new Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse);
  }

  /** Where a point, relative to the origin of the path, is on the canvas, pixels. */
  project(at: Vec3): [number, number] {
    const v = new Vector3(...at).project(this.camera);
    const { clientWidth, clientHeight } = this.canvas;
    return [((v.x + 1) / 2) * clientWidth, ((1 - v.y) / 2) * clientHeight];
  }

  /** The directions of X, Y and Z on the screen: right, up and towards the viewer. */
  axes(): Vec3[] {
    const { elements } = this.camera.matrixWorldInverse;
    return [0, 4, 8].map((at) => [elements[at]!, elements[at + 1]!, elements[at + 2]!] as Vec3);
  }
}
