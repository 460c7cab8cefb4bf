// Which lines of the path are drawn with which objects, and what that costs.

import type { LineSegments, Object3D } from "three";
import type { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import type { Batch } from "../path/batch";
import type { LineArrays } from "../path/lines";
import type { LineMesh } from "./line-mesh";
import { linesOnRows } from "./progress";

/** What a wide line costs more than one of a pixel. */
const WIDE_COST = 8;
/** Some lines of an object. */
export interface DrawGroup {
  object: LineSegments | LineSegments2;
  from: number;
  count: number;
}

/** A batch, and what draws it. */
export interface DrawnBatch {
  batch: Batch;
  cuts: LineMesh | undefined;
  rapids: LineSegments | undefined;
  lines: { cuts: LineArrays; rapids: LineArrays };
}

/** All visible lines below an object. */
export function drawGroups(root: Object3D): DrawGroup[] {
  const found: DrawGroup[] = [];
  root.traverseVisible((object) => {
    if ("geometry" in object) found.push(wholeGroup(object as LineSegments));
  });
  return found;
}

export function wholeGroup(object: LineSegments | LineSegments2): DrawGroup {
  const { attributes, instanceCount } = object.geometry as LineSegments2["geometry"];
  const count = isWide(object) ? Math.min(instanceCount, attributes.instanceStart!.count) : attributes.position!.count / 2;
  return { object, from: 0, count };
}

export function isWide(object: LineSegments | LineSegments2): object is LineSegments2 {
  return "isLineSegments2" in object;
}

export function drawCost(object: LineSegments | LineSegments2): number {
  return isWide(object) ? WIDE_COST : 1;
}

/** Lines, each counted as what it costs. */
export function drawWeight(groups: DrawGroup[]): number {
  return groups.reduce((sum, { object, count }) => sum + count * drawCost(object), 0);
}

/** The lines of the picture that are on rows, from and to, both counted. */
export function drawGroupsOn(parts: DrawnBatch[], from: number, to: number, withRapids: boolean): DrawGroup[] {
  const found: DrawGroup[] = [];
  for (const { batch, lines, cuts, rapids } of parts) {
    if (batch.first > to || batch.first + batch.rows <= from) continue;
    const on = (own: LineArrays, object: DrawGroup["object"] | undefined) => {
      const [first, end] = linesOnRows(own, from - batch.first, to - batch.first);
      if (!object || end <= first) return;
      found.push(isWide(object) ? wholeGroup(object) : { object, from: first, count: end - first });
    };
    on(lines.cuts, cuts?.object);
    if (withRapids) on(lines.rapids, rapids);
  }
  return found;
}
