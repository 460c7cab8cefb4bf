// Ranges of the lines of objects, which are drawn one after the other, and what drawing them costs.

import type { LineSegments, Object3D } from "three";
import type { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import type { Batch } from "../path/batch";
import type { LineArrays } from "../path/lines";
import type { LineMesh } from "./line-mesh";
import { linesOnRows } from "./progress";

/** The cost of a wide line; a line of one pixel costs 1. Wide lines are drawn as triangles. */
const WIDE_LINE_COST = 8;

/** A range of the lines of an object. */
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

/** The lines of all visible descendants of an object. */
export function drawGroups(root: Object3D): DrawGroup[] {
  const groups: DrawGroup[] = [];
  root.traverseVisible((object) => {
    if ("geometry" in object) groups.push(wholeGroup(object as LineSegments));
  });
  return groups;
}

/** All lines of an object. */
export function wholeGroup(object: LineSegments | LineSegments2): DrawGroup {
  const { attributes, instanceCount } = object.geometry as LineSegments2["geometry"];
  const count = isWide(object) ? Math.min(instanceCount, attributes.instanceStart!.count) : attributes.position!.count / 2;
  return { object, from: 0, count };
}

export function isWide(object: LineSegments | LineSegments2): object is LineSegments2 {
  return "isLineSegments2" in object;
}

/** The cost of one line of an object, in lines of one pixel. */
export function drawCost(object: LineSegments | LineSegments2): number {
  return isWide(object) ? WIDE_LINE_COST : 1;
}

/** The cost of all lines of groups, in lines of one pixel. */
export function drawWeight(groups: DrawGroup[]): number {
  return groups.reduce((sum, { object, count }) => sum + count * drawCost(object), 0);
}

/** The drawn lines on the rows `from` to `to`, both included; of an object with wide lines all of them. */
export function drawGroupsOn(parts: DrawnBatch[], from: number, to: number, withRapids: boolean): DrawGroup[] {
  const groups: DrawGroup[] = [];
  for (const { batch, lines, cuts, rapids } of parts) {
    if (batch.first > to || batch.first + batch.rows <= from) continue;
    const addLines = (arrays: LineArrays, object: DrawGroup["object"] | undefined) => {
      const [first, end] = linesOnRows(arrays, from - batch.first, to - batch.first);
      if (!object || end <= first) return;
      groups.push(isWide(object) ? wholeGroup(object) : { object, from: first, count: end - first });
    };
    addLines(lines.cuts, cuts?.object);
    if (withRapids) addLines(lines.rapids, rapids);
  }
  return groups;
}
