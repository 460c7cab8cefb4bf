// Levels of detail: simplified lines of a path, for while the view turns; made once for a path.

import { type LineDashedMaterial, Group, LineSegments } from "three";
import type { Batch } from "../path/batch";
import type { LineArrays } from "../path/lines";
import { type PathStrands, someStrands, strands } from "../path/simplification";
import { yieldToEventLoop } from "./event-loop";
import { type LineMaterials, LineMesh, lineGeometry } from "./line-mesh";
import { rowsAtEndsOf } from "./progress";

/** Approximate number of lines of each level. */
export const LEVEL_LINES = [60_000, 20_000, 8_000, 3_000];
/** Rapids of a level, as a fraction of its lines. */
const RAPIDS_FRACTION = 1 / 4;
/** How far a simplified line may be from the path, as a fraction of the path's size: in the first half of the levels, and in the others. */
const FINE_TOLERANCE_FRACTION = 1 / 2000;
const COARSE_TOLERANCE_FRACTION = 1 / 500;

export interface PathPart {
  batch: Batch;
  lines: { cuts: LineArrays; rapids: LineArrays };
}

export class PathLevels {
  readonly object = new Group();
  private levels: Group[] = [];
  private cuts: LineMesh[] = [];
  private rapids: LineSegments[] = [];
  private rapidsShown = true;
  /** Number of the newest build: an older one stops between two batches. */
  private builds = 0;

  constructor() {
    this.object.visible = false;
  }

  get isReady(): boolean {
    return this.levels.length > 0;
  }

  clear(): void {
    this.builds++;
    this.cuts.forEach((cuts) => cuts.dispose());
    this.rapids.forEach((rapids) => rapids.geometry.dispose());
    this.rapids = [];
    this.levels.forEach((level) => level.removeFromParent());
    this.cuts = [];
    this.levels = [];
  }

  /** Makes the levels, a batch at a time; false if a newer build has superseded it. `size` is that of the path, mm. */
  async build(parts: PathPart[], size: number, colors: (batch: Batch, lines: LineArrays) => Uint8Array, materials: LineMaterials, rapidMaterial: LineDashedMaterial): Promise<boolean> {
    const number = ++this.builds;
    const fine: PathStrands[] = [];
    const coarse: PathStrands[] = [];
    for (const { lines } of parts) {
      fine.push(strands(lines.cuts, size * FINE_TOLERANCE_FRACTION));
      coarse.push(strands(fine.at(-1)!.lines, size * COARSE_TOLERANCE_FRACTION));
      await yieldToEventLoop();
      if (number !== this.builds) return false;
    }
    const levels: Group[] = [];
    const cuts: LineMesh[] = [];
    const rapids: LineSegments[] = [];
    for (const [index, lineCount] of LEVEL_LINES.entries()) {
      const simplified = index < LEVEL_LINES.length / 2 ? fine : coarse;
      const level = new Group();
      const fraction = lineCount / simplified.reduce((sum, { lines }) => sum + lines.count, 0);
      let strandsBefore = 0;
      for (const [part, pathStrands] of simplified.entries()) {
        const lines = someStrands(pathStrands, fraction, strandsBefore);
        strandsBefore += pathStrands.starts.length;
        if (lines.count === 0) continue;
        const { batch } = parts[part]!;
        const mesh = new LineMesh(lines.points, colors(batch, lines), rowsAtEndsOf(batch.first, lines), materials, false);
        cuts.push(mesh);
        level.add(mesh.object);
      }
      const levelRapids = someRapids(parts, lineCount * RAPIDS_FRACTION, rapidMaterial);
      rapids.push(levelRapids);
      level.add(levelRapids);
      levels.push(level);
      await yieldToEventLoop();
      if (number !== this.builds) {
        cuts.forEach((mesh) => mesh.dispose());
        rapids.forEach((lines) => lines.geometry.dispose());
        return false;
      }
    }
    // The levels before are replaced only now.
    this.clear();
    this.levels = levels;
    this.cuts = cuts;
    this.rapids = rapids;
    this.showRapids(this.rapidsShown);
    this.object.add(...levels);
    return true;
  }

  showRapids(shown: boolean): void {
    this.rapidsShown = shown;
    this.rapids.forEach((rapids) => (rapids.visible = shown));
  }

  /** Shows a level, by its index, or none. */
  show(shown: boolean, level: number): void {
    this.object.visible = shown;
    this.levels.forEach((group, index) => (group.visible = index === level));
  }
}

/** Every n-th rapid of the path, so that there are no more than `maxLines`. */
export function someRapids(parts: { batch: Pick<Batch, "first">; lines: Pick<PathPart["lines"], "rapids"> }[], maxLines: number, material: LineDashedMaterial): LineSegments {
  const total = parts.reduce((sum, { lines }) => sum + lines.rapids.count, 0);
  const every = Math.max(1, Math.ceil(total / maxLines));
  const points: number[] = [];
  const rowsAtEnds: number[] = [];
  let rapidsBefore = 0;
  for (const { batch, lines } of parts) {
    const { rapids } = lines;
    for (let line = (every - (rapidsBefore % every)) % every; line < rapids.count; line += every) {
      points.push(...rapids.points.subarray(6 * line, 6 * line + 6));
      const row = batch.first + (rapids.rows ? rapids.rows[line]! : line);
      rowsAtEnds.push(row, row + 1);
    }
    rapidsBefore += rapids.count;
  }
  const object = new LineSegments(lineGeometry(new Float32Array(points), new Float32Array(rowsAtEnds)), material);
  object.computeLineDistances();
  object.frustumCulled = false;
  return object;
}
