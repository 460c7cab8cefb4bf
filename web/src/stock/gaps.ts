// Gaps in columns, moment by moment: what undercuts have removed below the tops, and what is hollow from below.

/** Floor and top of each gap of a column from below, from the top of the box, mm. */
export type Bands = readonly number[];

const NONE: Bands = [];
/** A gap that ends less than this below the top of its column is none, mm. */
const MIN_BELOW_TOP_MM = 1e-4;

export class Gaps {
  /** How many changes are carried out. */
  at = 0;
  private column: number[] = [];
  private moment: number[] = [];
  private after: Bands[] = [];
  private before: Bands[] = [];
  private last = new Map<number, Bands>();
  private now = new Map<number, Bands>();

  get count(): number {
    return this.column.length;
  }

  /** The most gaps that a column ever has. */
  most = 0;

  /** Adds changes in the order of the run; `counts` says how many gaps each has. */
  add(columns: Uint32Array, rows: Uint32Array, fractions: Float32Array, counts: Uint32Array, gaps: Float32Array): void {
    let from = 0;
    for (let n = 0; n < columns.length; n++) {
      const column = columns[n]!;
      const bands = [...gaps.subarray(from, from + 2 * counts[n]!)];
      from += 2 * counts[n]!;
      this.column.push(column);
      this.moment.push(rows[n]! + fractions[n]!);
      this.before.push(this.last.get(column) ?? NONE);
      this.after.push(bands);
      this.last.set(column, bands);
      this.most = Math.max(this.most, counts[n]!);
    }
  }

  /** Goes to the moment when so much of the path is done, and reports which columns have other gaps. */
  seek(rows: number, changed: (column: number, bands: Bands) => void): void {
    const put = (at: number, bands: Bands) => {
      const column = this.column[at]!;
      changed(column, this.of(column));
      if (bands.length > 0) this.now.set(column, bands);
      else this.now.delete(column);
      changed(column, bands);
    };
    for (; this.at < this.count && this.moment[this.at]! <= rows; this.at++) put(this.at, this.after[this.at]!);
    while (this.at > 0 && this.moment[this.at - 1]! > rows) {
      this.at--;
      put(this.at, this.before[this.at]!);
    }
  }

  /** The gaps of a column now. */
  of(column: number): Bands {
    return this.now.get(column) ?? NONE;
  }

  /** Columns with gaps now. */
  get columns(): IterableIterator<[number, Bands]> {
    return this.now.entries();
  }
}

/** What a gap mesh is made of: columns in a grid with their heights. */
export interface ColumnGrid {
  columns: readonly [number, number];
  pitch: number;
  size: readonly [number, number];
  bottom: number;
  /** Rectangles that look up or down are wider by this to each side, mm, so that no pixel is missed between them. */
  overlap: number;
  heightAt: (x: number, y: number) => number;
}

/** Numbers that grow. */
class Corners {
  all = new Float32Array(1 << 12);
  count = 0;

  /** A rectangle of four corners as two triangles. */
  rectangle(a: number[], b: number[], c: number[], d: number[]): void {
    if (this.count + 18 > this.all.length) {
      const more = new Float32Array(2 * this.all.length);
      more.set(this.all);
      this.all = more;
    }
    for (const corner of [a, b, c, a, c, d]) {
      this.all.set(corner, this.count);
      this.count += 3;
    }
  }
}

/**
 * The surfaces of gaps as triangles, nine numbers each, from the least corner and the top: floors, roofs, and the walls between a
 * gap and the columns next to it. Equal ones along X are one.
 */
export function gapSurfaces(gaps: Gaps, grid: ColumnGrid): Float32Array {
  const { columns: [nx, ny], pitch, size, overlap } = grid;
  const corners = new Corners();
  let [left, right, low, high] = [nx, -1, ny, -1];
  for (const [column] of gaps.columns) {
    const [x, y] = [column % nx, Math.floor(column / nx)];
    [left, right, low, high] = [Math.min(left, x), Math.max(right, x), Math.min(low, y), Math.max(high, y)];
  }
  /** A rectangle that looks up or down. */
  const level = (x0: number, y0: number, x1: number, y1: number, z: number) => {
    const [left, right, front, back] = [Math.min(x0, x1) - overlap, Math.max(x0, x1) + overlap, y0 - overlap, y1 + overlap];
    corners.rectangle([left, front, z], [right, front, z], [right, back, z], [left, back, z]);
  };
  const place = (axis: 0 | 1, at: number) => Math.min(size[axis], at * pitch);
  const isIn = (x: number, y: number) => x >= 0 && y >= 0 && x < nx && y < ny;
  /** The gaps of a column that are below its height. */
  const bands = (x: number, y: number): Bands => {
    const own = isIn(x, y) ? gaps.of(y * nx + x) : NONE;
    const last = own.at(-1);
    if (last === undefined || last < grid.heightAt(x, y) - MIN_BELOW_TOP_MM) return own;
    const height = grid.heightAt(x, y) - MIN_BELOW_TOP_MM;
    return own.filter((_, at) => own[at | 1]! < height);
  };
  /** Everything that is air in a column. */
  /** Whether a column in the grid is open above at a height, and no gap there. */
  const isAir = (x: number, y: number, z: number) => isIn(x, y) && grid.heightAt(x, y) <= z;
  const air = (x: number, y: number): Bands => (isIn(x, y) ? [...bands(x, y), grid.heightAt(x, y), Infinity] : [-Infinity, Infinity]);

  for (let y = low; y <= high; y++) {
    const [y0, y1] = [place(1, y), place(1, y + 1)];
    /** Rectangles along the row that go on from column to column, by what they are. */
    let open = new Map<string, { from: number; put: (x0: number, x1: number) => void }>();
    for (let x = left; x <= right + 1; x++) {
      const next: typeof open = new Map();
      const own = x <= right ? bands(x, y) : NONE;
      const keep = (name: string, put: (x0: number, x1: number) => void) => next.set(name, { from: open.get(name)?.from ?? x, put });
      for (let at = 0; at < own.length; at += 2) {
        const [floor, top] = [own[at]!, own[at + 1]!];
        if (floor > grid.bottom + MIN_BELOW_TOP_MM) keep(`f${floor}`, (x0, x1) => level(x0, y0, x1, y1, floor));
        keep(`t${top}`, (x0, x1) => level(x0, y0, x1, y1, top));
        // The walls of the stock lie between the middles of columns: what is open reaches to them.
        for (const [z, into] of [[floor, floor + MIN_BELOW_TOP_MM], [top, top - MIN_BELOW_TOP_MM]] as const) {
          if (z <= grid.bottom + MIN_BELOW_TOP_MM) continue;
          for (const [dy, from, to] of [[-1, y0 - pitch / 2, y0], [1, y1, y1 + pitch / 2]] as const) {
            if (isAir(x, y + dy, into)) keep(`${dy} ${z}`, (x0, x1) => level(x0, from, x1, to, z));
          }
          for (const [dx, at] of [[-1, place(0, x)], [1, place(0, x + 1)]] as const) {
            if (isAir(x + dx, y, into)) level(at, y0, at + (dx * pitch) / 2, y1, z);
          }
        }
        for (const [side, dy, wall] of [["a", -1, y0], ["b", 1, y1]] as const) {
          for (const [from, to] of without(floor, top, air(x, y + dy))) {
            keep(`${side}${from} ${to}`, (x0, x1) => corners.rectangle([x0, wall, from], [x1, wall, from], [x1, wall, to], [x0, wall, to]));
          }
        }
        for (const [dx, wall] of [[-1, place(0, x)], [1, place(0, x + 1)]] as const) {
          for (const [from, to] of without(floor, top, air(x + dx, y))) {
            corners.rectangle([wall, y0, from], [wall, y1, from], [wall, y1, to], [wall, y0, to]);
          }
        }
      }
      for (const [name, { from, put }] of open) if (!next.has(name)) put(place(0, from), place(0, x));
      open = next;
    }
  }
  return corners.all.subarray(0, corners.count);
}

/** The parts of an interval that are in none of some others, which are in rising order. */
function without(from: number, to: number, others: Bands): [number, number][] {
  const left: [number, number][] = [];
  let at = from;
  for (let n = 0; n < others.length; n += 2) {
    const [floor, top] = [others[n]!, others[n + 1]!];
    if (floor > at) left.push([at, Math.min(floor, to)]);
    at = Math.max(at, top);
    if (at >= to) break;
  }
  if (at < to) left.push([at, to]);
  return left.filter(([a, b]) => b - a > MIN_BELOW_TOP_MM);
}
