// Marks the differences of two paths: the rows of each, and a dot at each difference, so that a small one is visible on a large path.

import { type Plane, BufferGeometry, Points, PointsMaterial } from "three";
import type { Vec3 } from "../path/batch";
import type { ArcTolerance } from "../path/lines";
import type { Path } from "../path/path";
import { difference } from "../view/extent";
import { lineGeometry } from "../view/line-mesh";
import { RowHighlight } from "../view/row-highlight";

/** Rows that are marked at most, of each path: more wide lines would make rotating the view slow. */
const MAX_ROWS = 3_000;
const LINE_WIDTH_PIXELS = 3.4;
/** The diameter of a dot, pixels. */
const DOT_PIXELS = 7;

/** Ranges of rows of both paths, and a point of each difference in the frame of the run. */
export interface DifferenceRows {
  own: [number, number][];
  other: [number, number][];
  places: Vec3[];
}

export class DifferenceMarkers {
  readonly own = new RowHighlight(LINE_WIDTH_PIXELS, MAX_ROWS);
  readonly other = new RowHighlight(LINE_WIDTH_PIXELS, MAX_ROWS);
  readonly dots: Points;
  private material = new PointsMaterial({ size: DOT_PIXELS, sizeAttenuation: false, depthTest: false });

  constructor() {
    this.dots = new Points(new BufferGeometry(), this.material);
    this.dots.frustumCulled = false;
    this.dots.visible = false;
  }

  set({ own, other, places }: DifferenceRows, paths: [Path, Path], tolerances: [ArcTolerance, ArcTolerance]): void {
    this.own.set(paths[0], own, tolerances[0]);
    this.other.set(paths[1], other, tolerances[1]);
    this.dots.geometry.dispose();
    this.dots.geometry = lineGeometry(new Float32Array(places.flatMap((place) => difference(place, paths[0].origin))));
    this.dots.visible = places.length > 0;
  }

  clear(): void {
    this.own.clear();
    this.other.clear();
    this.dots.visible = false;
  }

  update(own: ArcTolerance, other: ArcTolerance): void {
    this.own.update(own);
    this.other.update(other);
  }

  setColor(color: string): void {
    this.own.setColor(color);
    this.other.setColor(color);
    this.material.color.set(color);
  }

  clip(planes: Plane[]): void {
    this.own.clip(planes);
    this.other.clip(planes);
  }
}
