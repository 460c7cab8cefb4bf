// The marks of measuring: two points with a cross each and the line between them, and the feature under the pointer.

import { Group } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Vec3 } from "../path/batch";
import type { PathFeature } from "./geometry";

/** Half the width of a mark, pixels. */
const MARK_ARM_PIXELS = 6;
/** Sides of the ring at the centre of an arc. */
const RING_SIDES = 12;

/** The directions to the right and up on the screen, and the world length of a pixel, mm. */
export interface ScreenFrame {
  right: Vec3;
  up: Vec3;
  pixel: number;
}

export class MeasureOverlay {
  readonly object = new Group();
  private distanceLines = new LineSegments2();
  private featureLines = new LineSegments2();
  private material = new LineMaterial({ linewidth: 2, depthTest: false });
  private points: Vec3[] = [];
  private feature: PathFeature | undefined;

  constructor() {
    for (const object of [this.distanceLines, this.featureLines]) {
      object.material = this.material;
      object.frustumCulled = false;
      object.visible = false;
      this.object.add(object);
    }
  }

  setColor(color: string): void {
    this.material.color.set(color);
  }

  /** Shows the first point of a measurement, or both, relative to the origin of the path. */
  show(from: Vec3 | undefined, to: Vec3 | undefined, screen: ScreenFrame): void {
    this.points = from ? (to ? [from, to] : [from]) : [];
    this.draw(screen);
  }

  /** Marks the feature that a click would measure; undefined marks nothing. */
  showSnap(feature: PathFeature | undefined, screen: ScreenFrame): void {
    this.feature = feature;
    this.draw(screen);
  }

  /** The marked feature: for tests. */
  get snapped(): PathFeature | undefined {
    return this.featureLines.visible ? this.feature : undefined;
  }

  /** Draws the marks with the same size on the screen at any zoom. */
  draw(screen: ScreenFrame): void {
    const [from, to] = this.points;
    const crosses = this.points.flatMap((at) => cross(at, screen));
    setSegments(this.distanceLines, from && to ? [...crosses, ...from, ...to] : crosses);
    setSegments(this.featureLines, this.feature ? markOf(this.feature, screen) : []);
  }
}

function setSegments(object: LineSegments2, points: number[]): void {
  object.visible = points.length > 0;
  if (points.length === 0) return;
  object.geometry.dispose();
  object.geometry = new LineSegmentsGeometry().setPositions(points);
}

/** A point `x` pixels to the right and `y` pixels up of another. */
function shiftedBy(at: Vec3, { right, up, pixel }: ScreenFrame, x: number, y: number): Vec3 {
  return at.map((value, axis) => value + pixel * (x * right[axis]! + y * up[axis]!)) as Vec3;
}

/** Segments from corner to corner, whose offsets from `at` are in pixels. */
function polyline(at: Vec3, screen: ScreenFrame, corners: [number, number][], isClosed: boolean): number[] {
  const points = corners.map(([x, y]) => shiftedBy(at, screen, x, y));
  return points.flatMap((point, index) => {
    const next = points[index + 1] ?? (isClosed ? points[0] : undefined);
    return next ? [...point, ...next] : [];
  });
}

function cross(at: Vec3, screen: ScreenFrame): number[] {
  const arm = (x: number, y: number) => polyline(at, screen, [[-x, -y], [x, y]], false);
  return [...arm(MARK_ARM_PIXELS, MARK_ARM_PIXELS), ...arm(MARK_ARM_PIXELS, -MARK_ARM_PIXELS)];
}

/** A square at an end, a cross on a line, and a ring at the centre of an arc. */
function markOf(feature: PathFeature, screen: ScreenFrame): number[] {
  if (feature.kind === "point" && feature.of === "end") {
    return polyline(feature.at, screen, [[-MARK_ARM_PIXELS, -MARK_ARM_PIXELS], [MARK_ARM_PIXELS, -MARK_ARM_PIXELS], [MARK_ARM_PIXELS, MARK_ARM_PIXELS], [-MARK_ARM_PIXELS, MARK_ARM_PIXELS]], true);
  }
  if (feature.kind !== "arc") return cross(feature.at, screen);
  const ring = Array.from({ length: RING_SIDES }, (_, index): [number, number] => {
    const angle = (2 * Math.PI * index) / RING_SIDES;
    return [MARK_ARM_PIXELS * Math.cos(angle), MARK_ARM_PIXELS * Math.sin(angle)];
  });
  return [...polyline(feature.center, screen, ring, true), ...feature.center, ...feature.at, ...cross(feature.at, screen)];
}
