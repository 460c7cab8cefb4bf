// Two places, each with a cross, and the line between them.

import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Vec3 } from "./path";

/** Of a cross from its middle, pixels. */
const REACH = 5;

export class Measured {
  readonly object = new LineSegments2();
  private material = new LineMaterial({ linewidth: 2, depthTest: false });

  constructor() {
    this.object.material = this.material;
    this.object.frustumCulled = false;
    this.object.visible = false;
  }

  setColor(color: string): void {
    this.material.color.set(color);
  }

  /** Places relative to the origin of the path, and how long a pixel is there. */
  show(from: Vec3 | undefined, to: Vec3 | undefined, pixel: number): void {
    this.object.visible = from !== undefined;
    if (!from) return;
    const size = REACH * pixel;
    const cross = (at: Vec3) =>
      [0, 1, 2].flatMap((axis) => [-size, size].flatMap((by) => at.map((value, i) => (i === axis ? value + by : value))));
    const points = [...cross(from), ...(to ? [...cross(to), ...from, ...to] : [])];
    this.object.geometry.dispose();
    this.object.geometry = new LineSegmentsGeometry().setPositions(points);
  }
}
