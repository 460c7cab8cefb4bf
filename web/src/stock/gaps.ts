// Gaps in columns at any moment: what undercuts have removed below the tops, and cavities that are open from below.

/** Floor and roof of each gap of a column, from the lowest up, mm from the top of the stock. */
export type Bands = readonly number[];

const NO_BANDS: Bands = [];
/** A gap whose roof is less than this below the top of its column is none, mm. */
const MIN_BELOW_TOP_MM = 1e-4;

export class Gaps {
  /** How many changes have been carried out. */
  at = 0;
  private column: number[] = [];
  private moment: number[] = [];
  private after: Bands[] = [];
  private before: Bands[] = [];
  /** The gaps of each column after the last change. */
  private last = new Map<number, Bands>();
  /** The present gaps of each column that has any. */
  private now = new Map<number, Bands>();

  get count(): number {
    return this.column.length;
  }

  /** The largest number of gaps that a column ever has. */
  maxPerColumn = 0;

  /** Adds changes in the order of the run: after the row and fraction, the column has `counts` gaps. */
  add(columns: Uint32Array, rows: Uint32Array, fractions: Float32Array, counts: Uint32Array, gaps: Float32Array): void {
    let from = 0;
    for (let n = 0; n < columns.length; n++) {
      const column = columns[n]!;
      const bands = [...gaps.subarray(from, from + 2 * counts[n]!)];
      from += 2 * counts[n]!;
      this.column.push(column);
      this.moment.push(rows[n]! + fractions[n]!);
      this.before.push(this.last.get(column) ?? NO_BANDS);
      this.after.push(bands);
      this.last.set(column, bands);
      this.maxPerColumn = Math.max(this.maxPerColumn, counts[n]!);
    }
  }

  /** Goes to the moment when `rows` rows of the path are done; calls `changed` with the gaps of each changed column before and after. */
  seek(rows: number, changed: (column: number, bands: Bands) => void): void {
    const setGaps = (change: number, bands: Bands) => {
      const column = this.column[change]!;
      changed(column, this.of(column));
      if (bands.length > 0) this.now.set(column, bands);
      else this.now.delete(column);
      changed(column, bands);
    };
    for (; this.at < this.count && this.moment[this.at]! <= rows; this.at++) setGaps(this.at, this.after[this.at]!);
    while (this.at > 0 && this.moment[this.at - 1]! > rows) {
      this.at--;
      setGaps(this.at, this.before[this.at]!);
    }
  }

  /** The present gaps of a column. */
  of(column: number): Bands {
    return this.now.get(column) ?? NO_BANDS;
  }

  /** The columns that have gaps at present. */
  get columns(): IterableIterator<[number, Bands]> {
    return this.now.entries();
  }
}

/** The grid of columns and their heights, mm from the top of the stock. */
export interface ColumnGrid {
  /** Along X and Y. */
  columns: readonly [number, number];
  /** The side of a column, mm. */
  pitch: number;
  /** Of the stock along X and Y, mm. */
  size: readonly [number, number];
  bottom: number;
  /** Horizontal rectangles are wider by this to each side, mm, so that there are no cracks between them. */
  overlap: number;
  heightAt: (x: number, y: number) => number;
}

/** A growing array of the corners of triangles. */
class TriangleCorners {
  all = new Float32Array(1 << 12);
  count = 0;

  /** Adds a rectangle as two triangles. */
  rectangle(a: number[], b: number[], c: number[], d: number[]): void {
    if (this.count + 18 > this.all.length) {
      const grown = new Float32Array(2 * this.all.length);
      grown.set(this.all);
      this.all = grown;
    }
    for (const corner of [a, b, c, a, c, d]) {
      this.all.set(corner, this.count);
      this.count += 3;
    }
  }
}

/**
 * The surfaces of gaps as triangles, nine numbers each, relative to the lowest X and Y and the top of the stock, mm: floors, roofs,
 * and the walls between a gap and adjacent columns. Equal rectangles that follow each other along X are merged.
 */
export function gapSurfaces(gaps: Gaps, grid: ColumnGrid): Float32Array {
  const { columns: [nx, ny], pitch, size, overlap } = grid;
  const corners = new TriangleCorners();
  let [left, right, low, high] = [nx, -1, ny, -1];
  for (const [column] of gaps.columns) {
    const [x, y] = [column % nx, Math.floor(column / nx)];
    [left, right, low, high] = [Math.min(left, x), Math.max(right, x), Math.min(low, y), Math.max(high, y)];
  }
  /** Adds a horizontal rectangle. */
  const addHorizontal = (x0: number, y0: number, x1: number, y1: number, z: number) => {
    const [left, right, front, back] = [Math.min(x0, x1) - overlap, Math.max(x0, x1) + overlap, y0 - overlap, y1 + overlap];
    corners.rectangle([left, front, z], [right, front, z], [right, back, z], [left, back, z]);
  };
  const columnStart = (axis: 0 | 1, column: number) => Math.min(size[axis], column * pitch);
  const isIn = (x: number, y: number) => x >= 0 && y >= 0 && x < nx && y < ny;
  /** The gaps of a column below its height. */
  const bands = (x: number, y: number): Bands => {
    const all = isIn(x, y) ? gaps.of(y * nx + x) : NO_BANDS;
    const last = all.at(-1);
    if (last === undefined || last < grid.heightAt(x, y) - MIN_BELOW_TOP_MM) return all;
    const height = grid.heightAt(x, y) - MIN_BELOW_TOP_MM;
    // The roof of the gap decides for both of its numbers.
    return all.filter((_, index) => all[index | 1]! < height);
  };
  /** Whether a height is above the top of a column of the grid. */
  const isAboveTop = (x: number, y: number, z: number) => isIn(x, y) && grid.heightAt(x, y) <= z;
  /** The intervals of a column without stock, the one above its top included. */
  const air = (x: number, y: number): Bands => (isIn(x, y) ? [...bands(x, y), grid.heightAt(x, y), Infinity] : [-Infinity, Infinity]);

  for (let y = low; y <= high; y++) {
    const [y0, y1] = [columnStart(1, y), columnStart(1, y + 1)];
    /** Rectangles that may continue in the next column of the row, by a key of their kind and heights. */
    let open = new Map<string, { from: number; add: (x0: number, x1: number) => void }>();
    for (let x = left; x <= right + 1; x++) {
      const next: typeof open = new Map();
      const columnBands = x <= right ? bands(x, y) : NO_BANDS;
      const extend = (key: string, add: (x0: number, x1: number) => void) => next.set(key, { from: open.get(key)?.from ?? x, add });
      for (let index = 0; index < columnBands.length; index += 2) {
        const [floor, roof] = [columnBands[index]!, columnBands[index + 1]!];
        if (floor > grid.bottom + MIN_BELOW_TOP_MM) extend(`f${floor}`, (x0, x1) => addHorizontal(x0, y0, x1, y1, floor));
        extend(`t${roof}`, (x0, x1) => addHorizontal(x0, y0, x1, y1, roof));
        // The drawn surface slopes from the middle of one column to that of the next: floors and roofs reach to that middle.
        for (const [z, inside] of [[floor, floor + MIN_BELOW_TOP_MM], [roof, roof - MIN_BELOW_TOP_MM]] as const) {
          if (z <= grid.bottom + MIN_BELOW_TOP_MM) continue;
          for (const [dy, from, to] of [[-1, y0 - pitch / 2, y0], [1, y1, y1 + pitch / 2]] as const) {
            if (isAboveTop(x, y + dy, inside)) extend(`${dy} ${z}`, (x0, x1) => addHorizontal(x0, from, x1, to, z));
          }
          for (const [dx, wall] of [[-1, columnStart(0, x)], [1, columnStart(0, x + 1)]] as const) {
            if (isAboveTop(x + dx, y, inside)) addHorizontal(wall, y0, wall + (dx * pitch) / 2, y1, z);
          }
        }
        for (const [side, dy, wall] of [["a", -1, y0], ["b", 1, y1]] as const) {
          for (const [from, to] of withoutBands(floor, roof, air(x, y + dy))) {
            extend(`${side}${from} ${to}`, (x0, x1) => corners.rectangle([x0, wall, from], [x1, wall, from], [x1, wall, to], [x0, wall, to]));
          }
        }
        for (const [dx, wall] of [[-1, columnStart(0, x)], [1, columnStart(0, x + 1)]] as const) {
          for (const [from, to] of withoutBands(floor, roof, air(x + dx, y))) {
            corners.rectangle([wall, y0, from], [wall, y1, from], [wall, y1, to], [wall, y0, to]);
          }
        }
      }
      for (const [key, { from, add }] of open) if (!next.has(key)) add(columnStart(0, from), columnStart(0, x));
      open = next;
    }
  }
  return corners.all.subarray(0, corners.count);
}

/** The parts of an interval outside of others, which are ascending. */
function withoutBands(from: number, to: number, others: Bands): [number, number][] {
  const parts: [number, number][] = [];
  let start = from;
  for (let n = 0; n < others.length; n += 2) {
    const [floor, roof] = [others[n]!, others[n + 1]!];
    if (floor > start) parts.push([start, Math.min(floor, to)]);
    start = Math.max(start, roof);
    if (start >= to) break;
  }
  if (start < to) parts.push([start, to]);
  return parts.filter(([a, b]) => b - a > MIN_BELOW_TOP_MM);
}
