// Fewer lines, for while the view turns: levels of detail, made once for a path.

import { type LineDashedMaterial, Group, LineSegments } from "three";
import type { Batch } from "../path/batch";
import type { LineArrays } from "../path/lines";
import { type PathStrands, someStrands, strands } from "../path/simplification";
import { yieldToEventLoop } from "./event-loop";
import { type LineMaterials, LineMesh, geometryOf } from "./line-mesh";
import { spansOf } from "./progress";

/** Lines of each level, about. */
export const LEVEL_LINES = [60_000, 20_000, 8_000, 3_000];
/** Rapids of a level, as a fraction of its lines. */
const RAPIDS_FRACTION = 1 / 4;
/** How far a line may be from the path, as a fraction of the path's size. */
const FINE_FRACTION = 1 / 2000;
const ROUGH_FRACTION = 1 / 500;

export interface PathPart {
  batch: Batch;
  lines: { cuts: LineArrays; rapids: LineArrays };
}

export class PathLevels {
  readonly object = new Group();
  private levels: Group[] = [];
  private strokes: LineMesh[] = [];
  private rapids: LineSegments[] = [];
  private rapidsShown = true;
  /** The number of the newest build: an older one stops between two batches. */
  private builds = 0;

  constructor() {
    this.object.visible = false;
  }

  get isReady(): boolean {
    return this.levels.length > 0;
  }

  clear(): void {
    this.builds++;
    this.strokes.forEach((strokes) => strokes.removeLines());
    this.rapids.forEach((rapids) => rapids.geometry.dispose());
    this.rapids = [];
    this.levels.forEach((level) => level.removeFromParent());
    this.strokes = [];
    this.levels = [];
  }

  /** Makes the levels, a batch at a time; false if a newer build has taken over. */
  async build(parts: PathPart[], size: number, colors: (batch: Batch, lines: LineArrays) => Uint8Array, materials: LineMaterials, rapidMaterial: LineDashedMaterial): Promise<boolean> {
    const number = ++this.builds;
    const fine: PathStrands[] = [];
    const rough: PathStrands[] = [];
    for (const { lines } of parts) {
      fine.push(strands(lines.cuts, size * FINE_FRACTION));
      rough.push(strands(fine.at(-1)!.lines, size * ROUGH_FRACTION));
      await yieldToEventLoop();
      if (number !== this.builds) return false;
    }
    const levels: Group[] = [];
    const made: LineMesh[] = [];
    const rapids: LineSegments[] = [];
    for (const [index, most] of LEVEL_LINES.entries()) {
      const from = index < LEVEL_LINES.length / 2 ? fine : rough;
      const level = new Group();
      const fraction = most / from.reduce((sum, { lines }) => sum + lines.count, 0);
      let before = 0;
      for (const [at, part] of from.entries()) {
        const lines = someStrands(part, fraction, before);
        before += part.starts.length;
        if (lines.count === 0) continue;
        const { batch } = parts[at]!;
        const strokes = new LineMesh(lines.points, colors(batch, lines), spansOf(batch.first, lines), materials, false);
        made.push(strokes);
        level.add(strokes.object);
      }
      const some = someRapids(parts, most * RAPIDS_FRACTION, rapidMaterial);
      rapids.push(some);
      level.add(some);
      levels.push(level);
      await yieldToEventLoop();
      if (number !== this.builds) {
        made.forEach((strokes) => strokes.removeLines());
        rapids.forEach((some) => some.geometry.dispose());
        return false;
      }
    }
    // The levels before are replaced only now.
    this.clear();
    this.levels = levels;
    this.strokes = made;
    this.rapids = rapids;
    this.showRapids(this.rapidsShown);
    this.object.add(...levels);
    return true;
  }

  showRapids(shown: boolean): void {
    this.rapidsShown = shown;
    this.rapids.forEach((rapids) => (rapids.visible = shown));
  }

  show(shown: boolean, level: number): void {
    this.object.visible = shown;
    this.levels.forEach((group, index) => (group.visible = index === level));
  }
}

/** About so many of the rapids, evenly along the path. */
export function someRapids(parts: { batch: Pick<Batch, "first">; lines: Pick<PathPart["lines"], "rapids"> }[], most: number, material: LineDashedMaterial): LineSegments {
  const total = parts.reduce((sum, { lines }) => sum + lines.rapids.count, 0);
  const every = Math.max(1, Math.ceil(total / most));
  const points: number[] = [];
  const spans: number[] = [];
  let before = 0;
  for (const { batch, lines } of parts) {
    const { rapids } = lines;
    for (let at = (every - (before % every)) % every; at < rapids.count; at += every) {
      points.push(...rapids.points.subarray(6 * at, 6 * at + 6));
      const row = batch.first + (rapids.rows ? rapids.rows[at]! : at);
      spans.push(row, row + 1);
    }
    before += rapids.count;
  }
  const some = new LineSegments(geometryOf(new Float32Array(points), new Float32Array(spans)), material);
  some.computeLineDistances();
  some.frustumCulled = false;
  return some;
}
