// The path of a run, put together from the batches of the server, and the questions that the page asks of it.

import { arcEighths, arcIndex, arcPoint, curvePoint } from "./arcs";
import { type Batch, type Bounds, type Vec3, ALL_AXES_BITS, END_AXES_SHIFT, KNOWN_BIT, RAPID, kindOf } from "./batch";

/** Points of a row that are compared first to find how much of it is done. */
const SHARE_SAMPLES = 32;

/** A path that grows batch by batch. */
export class Path {
  batches: Batch[] = [];
  rows = 0;
  origin: Vec3 = [0, 0, 0];
  tools: number[] = [];
  /** Tools that cut, in the order of their first cut. */
  cutters: number[] = [];
  /** Lowest and highest point of all cuts, and the highest of those that move across, relative to the origin, mm. */
  private heights: [number, number] = [Infinity, -Infinity];
  private highestAcross = -Infinity;
  /** The bits of axes that the program does not name: they are drawn at zero. */
  notNamed = 0;
  maxFeed = 0;
  minFeed = Infinity;
  /** Least and most S of cuts, where it may be the power of a laser. */
  minPower = Infinity;
  maxPower = 0;
  bounds: Bounds | undefined;
  /** First and last row of each line of the program itself, plus one; 0: the line moves nothing. */
  private firstRow = new Uint32Array(1024);
  private lastRow = new Uint32Array(1024);
  lines = 0;

  add(batch: Batch, origin: Vec3): void {
    if (this.rows === 0) this.origin = origin;
    this.batches.push(batch);
    this.rows = batch.first + batch.rows;
    this.note(batch);
  }

  private note(batch: Batch): void {
    const { points, kind, tool, line, file, feed, power } = batch;
    const low: Vec3 = this.bounds ? [...this.bounds.low] : [Infinity, Infinity, Infinity];
    const high: Vec3 = this.bounds ? [...this.bounds.high] : [-Infinity, -Infinity, -Infinity];
    let lastTool = -1;
    let lastCutter = -1;
    for (let row = 0; row < batch.rows; row++) {
      if (file[row] === 0) this.noteLine(line[row]!, batch.first + row);
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
        const isAcross = points[6 * row] !== points[6 * row + 3] || points[6 * row + 1] !== points[6 * row + 4];
        this.noteHeight(points[6 * row + 2]!, isAcross);
        this.noteHeight(points[6 * row + 5]!, isAcross);
      }
      for (let end = 0; end < 6; end += 3) {
        for (let axis = 0; axis < 3; axis++) {
          const value = points[6 * row + end + axis]!;
          if (value < low[axis]!) low[axis] = value;
          if (value > high[axis]!) high[axis] = value;
        }
      }
    }
    // An arc bulges out of the box of its ends.
    for (let at = 0; at < batch.arcRows.length; at++) {
      if (!(kind[batch.arcRows[at]!]! & KNOWN_BIT)) continue;
      const steps = arcEighths(batch.arcs, at);
      for (let step = 1; step < steps; step++) {
        const point = arcPoint(batch.arcs, at, step / steps);
        this.noteHeight(point[2], true);
        for (let axis = 0; axis < 3; axis++) {
          low[axis] = Math.min(low[axis]!, point[axis]!);
          high[axis] = Math.max(high[axis]!, point[axis]!);
        }
      }
    }
    for (const curve of batch.curves?.values() ?? []) {
      for (let at = 0; at < curve.length; at++) {
        const axis = at % 3;
        low[axis] = Math.min(low[axis]!, curve[at]!);
        high[axis] = Math.max(high[axis]!, curve[at]!);
      }
    }
    if (low[0] <= high[0]) this.bounds = { low, high };
  }

  private noteHeight(z: number, isAcross: boolean): void {
    if (z < this.heights[0]) this.heights[0] = z;
    if (z > this.heights[1]) this.heights[1] = z;
    if (isAcross && z > this.highestAcross) this.highestAcross = z;
  }

  /**
   * Lowest and highest point of the cuts, relative to the origin, mm; the highest one that also moves in XY, if there is
   * one above the lowest: otherwise the feed down from the clearance plane would take most of the scale.
   */
  get depths(): [number, number] {
    const [low, high] = this.heights;
    return [low, this.highestAcross > low ? this.highestAcross : high];
  }

  /** The number of a tool in the order in which the tools cut first; the first for one that never cuts. */
  cutterIndex(tool: number): number {
    return Math.max(0, this.cutters.indexOf(tool));
  }

  private noteLine(line: number, row: number): void {
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

  /** First and last row that a line of the program makes. */
  rowsOfLine(line: number): [number, number] | undefined {
    const first = this.firstRow[line] ?? 0;
    return first === 0 ? undefined : [first - 1, this.lastRow[line]! - 1];
  }

  /** How many rows are done once a line has run; of a line without rows, the nearest line before counts. */
  doneAfterLine(line: number): number {
    for (let at = Math.min(line, this.lines); at > 0; at--) {
      const rows = this.rowsOfLine(at);
      if (rows) return rows[1] + 1;
    }
    return 0;
  }

  /** The bits of the axes that are known where so much of a row is done. */
  knownOn(row: number, share: number): number {
    const found = this.find(row);
    if (!found) return 0;
    const [batch, at] = found;
    if (!batch.known) return batch.kind[at]! & KNOWN_BIT ? ALL_AXES_BITS : 0;
    const [from, to] = [batch.known[at]! & ALL_AXES_BITS, (batch.known[at]! >> END_AXES_SHIFT) & ALL_AXES_BITS];
    return share <= 0 ? from : share >= 1 ? to : from & to;
  }

  /** Whether the position where so much of a row is done can be drawn; within a row only where that is drawn. */
  isPlace(row: number, share: number): boolean {
    const isEnd = share <= 0 || share >= 1;
    return isEnd ? (this.knownOn(row, share) | this.notNamed) === ALL_AXES_BITS : this.isDrawn(row);
  }

  private isDrawn(row: number): boolean {
    const found = this.find(row);
    return found !== undefined && (found[0].kind[found[1]]! & KNOWN_BIT) !== 0;
  }

  /** The batch that has a row, and its place in it. */
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

  lineOf(row: number): { line: number; own: boolean } | undefined {
    const found = this.find(row);
    if (!found) return undefined;
    const [batch, at] = found;
    return { line: batch.line[at]!, own: batch.file[at] === 0 };
  }

  /** A point on a row as it is programmed, relative to the origin, mm; approximate within a row that turns the part. */
  programmedOn(row: number, share: number): Vec3 | undefined {
    const found = this.find(row);
    if (!found) return undefined;
    const [batch, at] = found;
    if (!batch.programmed) return this.pointOn(row, share);
    const points = batch.programmed;
    const mix = (axis: number) => points[6 * at + axis]! * (1 - share) + points[6 * at + 3 + axis]! * share;
    return [mix(0), mix(1), mix(2)];
  }

  /** A, B and C on a row, rad. */
  turnOn(row: number, share: number): Vec3 {
    const found = this.find(row);
    const turns = found?.[0].turns;
    if (!found || !turns) return [0, 0, 0];
    const mix = (axis: number) => {
      const from = turns[6 * found[1] + axis]!;
      return from + (turns[6 * found[1] + 3 + axis]! - from) * share;
    };
    return [mix(0), mix(1), mix(2)];
  }

  /** The share of a row, from 0 to 1, that is done when the tool is at a position, relative to the origin, mm. */
  shareOf(row: number, at: Vec3): number {
    const far = (share: number) => {
      const point = this.pointOn(row, share);
      return point ? Math.hypot(point[0] - at[0], point[1] - at[1], point[2] - at[2]) : Infinity;
    };
    let best = 0;
    let least = far(0);
    for (let step = 1; step <= SHARE_SAMPLES; step++) {
      const distance = far(step / SHARE_SAMPLES);
      if (distance < least) [best, least] = [step / SHARE_SAMPLES, distance];
    }
    // Between the neighbours of the best one.
    let low = Math.max(0, best - 1 / SHARE_SAMPLES);
    let high = Math.min(1, best + 1 / SHARE_SAMPLES);
    for (let round = 0; round < 20; round++) {
      const [a, b] = [low + (high - low) / 3, high - (high - low) / 3];
      if (far(a) <= far(b)) high = b;
      else low = a;
    }
    return (low + high) / 2;
  }

  /** A point on a row, relative to the origin, mm. */
  pointOn(row: number, share: number): Vec3 | undefined {
    const found = this.find(row);
    if (!found) return undefined;
    const [batch, at] = found;
    const curve = batch.curves?.get(at);
    if (curve) return curvePoint(curve, share);
    const arc = arcIndex(batch, at);
    if (arc >= 0 && share > 0 && share < 1) return arcPoint(batch.arcs, arc, share);
    const p = batch.points;
    const mix = (axis: number) => {
      const from = p[6 * at + axis]!;
      return from + (p[6 * at + 3 + axis]! - from) * share;
    };
    return [mix(0), mix(1), mix(2)];
  }
}
