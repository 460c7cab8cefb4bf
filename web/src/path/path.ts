// The path of a run, built from the batches that the server sends, and look-ups by row, line and position.

import { arcSampleCount, arcIndex, arcPoint, curvePoint } from "./arcs";
import { type Batch, type Bounds, type Vec3, ALL_AXES_BITS, END_AXES_SHIFT, KNOWN_BIT, RAPID, kindOf } from "./batch";

/** Points of a row that are compared to find the nearest to a position, before the search is refined. */
const NEAREST_SAMPLES = 32;
/** Steps of that search; each keeps two thirds of the interval, so the last one is 2e-5 of a row. */
const NEAREST_STEPS = 20;

/** A path that grows batch by batch. */
export class Path {
  batches: Batch[] = [];
  rows = 0;
  /** In the frame of the run, mm: points are relative to it, so that single precision is enough. */
  origin: Vec3 = [0, 0, 0];
  tools: number[] = [];
  /** Tools that cut, in the order of their first cut. */
  cutters: number[] = [];
  /** Lowest and highest Z of all cuts, relative to the origin, mm. */
  private heights: [number, number] = [Infinity, -Infinity];
  /** Highest Z of the cuts that move in XY. */
  private highestAcross = -Infinity;
  /** The bits of axes that the program does not name: they are drawn at zero. */
  notNamed = 0;
  /** Of cuts with a feed, mm/min. */
  maxFeed = 0;
  minFeed = Infinity;
  /** Lowest and highest S of cuts, where it may be the power of a laser. */
  minPower = Infinity;
  maxPower = 0;
  /** Relative to the origin, mm; undefined while no row is drawn. */
  bounds: Bounds | undefined;
  /** First and last row of each line of the program itself, plus one; 0 for a line without rows. */
  private firstRow = new Uint32Array(1024);
  private lastRow = new Uint32Array(1024);
  lines = 0;

  add(batch: Batch, origin: Vec3): void {
    if (this.rows === 0) this.origin = origin;
    this.batches.push(batch);
    this.rows = batch.first + batch.rows;
    this.include(batch);
  }

  /** Extends tools, ranges and bounds by those of a batch. */
  private include(batch: Batch): void {
    const { points, kind, tool, line, file, feed, power } = batch;
    const low: Vec3 = this.bounds ? [...this.bounds.low] : [Infinity, Infinity, Infinity];
    const high: Vec3 = this.bounds ? [...this.bounds.high] : [-Infinity, -Infinity, -Infinity];
    let lastTool = -1;
    let lastCutter = -1;
    for (let row = 0; row < batch.rows; row++) {
      if (file[row] === 0) this.includeLine(line[row]!, batch.first + row);
      if (tool[row] !== lastTool) {
        lastTool = tool[row]!;
        if (!this.tools.includes(lastTool)) this.tools.push(lastTool);
      }
      if (kindOf(kind[row]!) !== RAPID && feed[row]! > 0) {
        this.maxFeed = Math.max(this.maxFeed, feed[row]!);
        this.minFeed = Math.min(this.minFeed, feed[row]!);
      }
      if (power && kindOf(kind[row]!) !== RAPID) {
        this.maxPower = Math.max(this.maxPower, power[row]!);
        this.minPower = Math.min(this.minPower, power[row]!);
      }
      if (!(kind[row]! & KNOWN_BIT)) continue;
      if (kindOf(kind[row]!) !== RAPID) {
        if (tool[row] !== lastCutter) {
          lastCutter = tool[row]!;
          if (!this.cutters.includes(lastCutter)) this.cutters.push(lastCutter);
        }
        const movesInXY = points[6 * row] !== points[6 * row + 3] || points[6 * row + 1] !== points[6 * row + 4];
        this.includeHeight(points[6 * row + 2]!, movesInXY);
        this.includeHeight(points[6 * row + 5]!, movesInXY);
      }
      for (let end = 0; end < 6; end += 3) {
        for (let axis = 0; axis < 3; axis++) {
          const value = points[6 * row + end + axis]!;
          if (value < low[axis]!) low[axis] = value;
          if (value > high[axis]!) high[axis] = value;
        }
      }
    }
    // An arc may leave the box of its ends.
    for (let arc = 0; arc < batch.arcRows.length; arc++) {
      if (!(kind[batch.arcRows[arc]!]! & KNOWN_BIT)) continue;
      const steps = arcSampleCount(batch.arcs, arc);
      for (let step = 1; step < steps; step++) {
        const point = arcPoint(batch.arcs, arc, step / steps);
        this.includeHeight(point[2], true);
        for (let axis = 0; axis < 3; axis++) {
          low[axis] = Math.min(low[axis]!, point[axis]!);
          high[axis] = Math.max(high[axis]!, point[axis]!);
        }
      }
    }
    for (const curve of batch.curves?.values() ?? []) {
      for (let index = 0; index < curve.length; index++) {
        const axis = index % 3;
        low[axis] = Math.min(low[axis]!, curve[index]!);
        high[axis] = Math.max(high[axis]!, curve[index]!);
      }
    }
    if (low[0] <= high[0]) this.bounds = { low, high };
  }

  private includeHeight(z: number, movesInXY: boolean): void {
    if (z < this.heights[0]) this.heights[0] = z;
    if (z > this.heights[1]) this.heights[1] = z;
    if (movesInXY && z > this.highestAcross) this.highestAcross = z;
  }

  /**
   * Lowest and highest Z of the cuts, relative to the origin, mm. Only cuts that move in XY count for the highest, unless all
   * of these are at the lowest Z: plunges from the clearance plane would take up most of the scale.
   */
  get depths(): [number, number] {
    const [low, high] = this.heights;
    return [low, this.highestAcross > low ? this.highestAcross : high];
  }

  /** The index of a tool in the order of the tools' first cuts; 0 for a tool that never cuts. */
  cutterIndex(tool: number): number {
    return Math.max(0, this.cutters.indexOf(tool));
  }

  private includeLine(line: number, row: number): void {
    if (line >= this.firstRow.length) {
      const size = Math.max(line + 1, 2 * this.firstRow.length);
      const grow = (old: Uint32Array) => {
        const grown = new Uint32Array(size);
        grown.set(old);
        return grown;
      };
      this.firstRow = grow(this.firstRow);
      this.lastRow = grow(this.lastRow);
    }
    if (this.firstRow[line] === 0) this.firstRow[line] = row + 1;
    this.lastRow[line] = row + 1;
    this.lines = Math.max(this.lines, line);
  }

  /** First and last row of a line of the program; undefined where it has none. */
  rowsOfLine(line: number): [number, number] | undefined {
    const first = this.firstRow[line] ?? 0;
    return first === 0 ? undefined : [first - 1, this.lastRow[line]! - 1];
  }

  /** How many rows are done at the end of a line; a line without rows ends with the nearest line before that has some. */
  doneAfterLine(line: number): number {
    for (let number = Math.min(line, this.lines); number > 0; number--) {
      const rows = this.rowsOfLine(number);
      if (rows) return rows[1] + 1;
    }
    return 0;
  }

  /** The bits of the axes that are known at a fraction of a row: within it, those known at both ends. */
  knownOn(row: number, fraction: number): number {
    const found = this.find(row);
    if (!found) return 0;
    const [batch, index] = found;
    if (!batch.known) return batch.kind[index]! & KNOWN_BIT ? ALL_AXES_BITS : 0;
    const [from, to] = [batch.known[index]! & ALL_AXES_BITS, (batch.known[index]! >> END_AXES_SHIFT) & ALL_AXES_BITS];
    return fraction <= 0 ? from : fraction >= 1 ? to : from & to;
  }

  /** Whether the position at a fraction of a row can be drawn: an end of which all axes are known or drawn at zero, or a point within a drawn row. */
  isDrawable(row: number, fraction: number): boolean {
    const isEnd = fraction <= 0 || fraction >= 1;
    return isEnd ? (this.knownOn(row, fraction) | this.notNamed) === ALL_AXES_BITS : this.isDrawn(row);
  }

  private isDrawn(row: number): boolean {
    const [batch, index] = this.find(row) ?? [];
    return batch !== undefined && (batch.kind[index!]! & KNOWN_BIT) !== 0;
  }

  /** The batch that contains a row, and the index of the row in it. */
  find(row: number): [Batch, number] | undefined {
    let low = 0;
    let high = this.batches.length - 1;
    while (low <= high) {
      const middle = (low + high) >> 1;
      const batch = this.batches[middle]!;
      if (row < batch.first) high = middle - 1;
      else if (row >= batch.first + batch.rows) low = middle + 1;
      else return [batch, row - batch.first];
    }
    return undefined;
  }

  /** The line of a row; `own` is false for one of another file. */
  lineOf(row: number): { line: number; own: boolean } | undefined {
    const found = this.find(row);
    if (!found) return undefined;
    const [batch, index] = found;
    return { line: batch.line[index]!, own: batch.file[index] === 0 };
  }

  /** The programmed position at a fraction of a row, relative to the origin, mm; approximate within a row that turns the part. */
  programmedOn(row: number, fraction: number): Vec3 | undefined {
    const found = this.find(row);
    if (!found) return undefined;
    const [batch, index] = found;
    if (!batch.programmed) return this.pointOn(row, fraction);
    const points = batch.programmed;
    const lerp = (axis: number) => points[6 * index + axis]! * (1 - fraction) + points[6 * index + 3 + axis]! * fraction;
    return [lerp(0), lerp(1), lerp(2)];
  }

  /** A, B and C at a fraction of a row, rad. */
  rotaryAnglesOn(row: number, fraction: number): Vec3 {
    const found = this.find(row);
    const angles = found?.[0].rotaryAngles;
    if (!found || !angles) return [0, 0, 0];
    const lerp = (axis: number) => {
      const from = angles[6 * found[1] + axis]!;
      return from + (angles[6 * found[1] + 3 + axis]! - from) * fraction;
    };
    return [lerp(0), lerp(1), lerp(2)];
  }

  /** The fraction of a row, 0 to 1, at its point nearest to a position, which is relative to the origin, mm. */
  fractionOf(row: number, position: Vec3): number {
    const distanceAt = (fraction: number) => {
      const point = this.pointOn(row, fraction);
      return point ? Math.hypot(point[0] - position[0], point[1] - position[1], point[2] - position[2]) : Infinity;
    };
    let best = 0;
    let minDistance = distanceAt(0);
    for (let step = 1; step <= NEAREST_SAMPLES; step++) {
      const distance = distanceAt(step / NEAREST_SAMPLES);
      if (distance < minDistance) [best, minDistance] = [step / NEAREST_SAMPLES, distance];
    }
    // Ternary search between the neighbours of the nearest sample.
    let low = Math.max(0, best - 1 / NEAREST_SAMPLES);
    let high = Math.min(1, best + 1 / NEAREST_SAMPLES);
    for (let round = 0; round < NEAREST_STEPS; round++) {
      const [a, b] = [low + (high - low) / 3, high - (high - low) / 3];
      if (distanceAt(a) <= distanceAt(b)) high = b;
      else low = a;
    }
    return (low + high) / 2;
  }

  /** The point at a fraction of a row, relative to the origin, mm. */
  pointOn(row: number, fraction: number): Vec3 | undefined {
    const found = this.find(row);
    if (!found) return undefined;
    const [batch, index] = found;
    const curve = batch.curves?.get(index);
    if (curve) return curvePoint(curve, fraction);
    const arc = arcIndex(batch, index);
    if (arc >= 0 && fraction > 0 && fraction < 1) return arcPoint(batch.arcs, arc, fraction);
    const p = batch.points;
    const lerp = (axis: number) => {
      const from = p[6 * index + axis]!;
      return from + (p[6 * index + 3 + axis]! - from) * fraction;
    };
    return [lerp(0), lerp(1), lerp(2)];
  }
}
