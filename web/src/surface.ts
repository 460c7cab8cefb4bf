// The surface of a stock as a grid of corners in tiles: what is drawn of it, and what has changed.

import type { StockBefore } from "./drops";
import type { Floor } from "./floor";

/** Cells along a side of a tile, and of the blocks that are one flat piece where they can. */
export const TILE = 32;
const BLOCK = 8;
/** Corners along a side of a tile. */
export const SIDE = TILE + 1;

/** Columns and heights between which something has changed. */
export interface Touched {
  columns: [number, number];
  rows: [number, number];
  heights: [number, number];
}

/**
 * Corners are the middles of columns, and a ring around them at the bottom: that makes the walls. So column x
 * is corner x + 1.
 */
export class Surface {
  readonly width: number;
  readonly height: number;
  /** From the top of the stock, mm. */
  readonly z: Float32Array;
  readonly slot: Uint8Array;
  readonly target: Float32Array | undefined;
  readonly bottom: number;
  readonly tiles: [number, number];
  /** Tiles whose corners have changed since they were taken. */
  readonly stale: Uint8Array;
  private touched: Touched | undefined;
  /** What the tool has cut where it stands. */
  private under: number[] = [];

  constructor(readonly stock: StockBefore) {
    const [nx, ny] = stock.columns;
    [this.width, this.height] = [nx + 2, ny + 2];
    this.bottom = stock.low[2] - stock.high[2];
    this.z = new Float32Array(this.width * this.height).fill(this.bottom);
    this.slot = new Uint8Array(this.z.length);
    this.target = stock.target && new Float32Array(this.z.length).fill(this.bottom);
    for (let row = 0; row < ny; row++) {
      const [from, to] = [row * nx, this.corner(0, row)];
      this.z.set(stock.heights.subarray(from, from + nx), to);
      this.target?.set(stock.target!.subarray(from, from + nx), to);
    }
    this.tiles = [Math.ceil((nx + 1) / TILE), Math.ceil((ny + 1) / TILE)];
    this.stale = new Uint8Array(this.tiles[0] * this.tiles[1]).fill(1);
  }

  private corner(column: number, row: number): number {
    return (row + 1) * this.width + column + 1;
  }

  /** A column has another height or another owner. */
  set(column: number, z: number, slot: number): void {
    const nx = this.stock.columns[0];
    const [x, y] = [column % nx, Math.floor(column / nx)];
    const at = this.corner(x, y);
    const before = this.z[at]!;
    if (before === z && this.slot[at] === slot) return;
    this.z[at] = z;
    this.slot[at] = slot;
    this.touch(x, y, Math.min(before, z), Math.max(before, z));
    // Corner x + 1 is of the tile of cell x, too.
    const [across] = this.tiles;
    const [left, right] = [Math.floor(x / TILE), Math.floor((x + 1) / TILE)];
    const [low, high] = [Math.floor(y / TILE), Math.floor((y + 1) / TILE)];
    this.stale[low * across + left] = 1;
    this.stale[low * across + right] = 1;
    this.stale[high * across + left] = 1;
    this.stale[high * across + right] = 1;
  }

  /** Every column has the height and the owner of these: quicker than one by one where many are others. */
  setAll(heights: Float32Array, slots: Uint8Array): void {
    const [nx, ny] = this.stock.columns;
    const { z, slot, stale, tiles: [across] } = this;
    for (let y = 0; y < ny; y++) {
      const [from, to] = [y * nx, this.corner(0, y)];
      const [below, above] = [Math.floor(y / TILE) * across, Math.floor((y + 1) / TILE) * across];
      for (let x = 0; x < nx; x++) {
        const [before, after] = [z[to + x]!, heights[from + x]!];
        if (before === after && slot[to + x] === slots[from + x]) continue;
        z[to + x] = after;
        slot[to + x] = slots[from + x]!;
        this.touch(x, y, Math.min(before, after), Math.max(before, after));
        const [left, right] = [Math.floor(x / TILE), Math.floor((x + 1) / TILE)];
        stale[below + left] = stale[below + right] = stale[above + left] = stale[above + right] = 1;
      }
    }
  }

  private touch(x: number, y: number, low: number, high: number): void {
    const { touched } = this;
    if (!touched) {
      this.touched = { columns: [x, x], rows: [y, y], heights: [low, high] };
      return;
    }
    const { columns, rows, heights } = touched;
    if (x < columns[0]) columns[0] = x;
    if (x > columns[1]) columns[1] = x;
    if (y < rows[0]) rows[0] = y;
    if (y > rows[1]) rows[1] = y;
    if (low < heights[0]) heights[0] = low;
    if (high > heights[1]) heights[1] = high;
  }

  /** What has changed since the last time. */
  takeTouched(): Touched | undefined {
    const { touched } = this;
    this.touched = undefined;
    return touched;
  }

  /** The tool cuts where it stands, at a place in the frame of the run: until the next time. */
  stand(tool: { floor: Floor; slot: number; at: [number, number, number] } | undefined, heights: Float32Array, slots: Uint8Array): void {
    for (const column of this.under) this.set(column, heights[column]!, slots[column]!);
    this.under = [];
    if (!tool) return;
    const { low, high, pitch, columns: [nx, ny] } = this.stock;
    const { floor: { radius, at: floorAt }, at: [tx, ty, tz] } = tool;
    const first = (axis: 0 | 1, from: number) => Math.max(0, Math.ceil((from - low[axis]) / pitch - 0.5));
    const last = (axis: 0 | 1, to: number, count: number) => Math.min(count - 1, Math.floor((to - low[axis]) / pitch - 0.5));
    const tip = tz - high[2];
    for (let y = first(1, ty - radius); y <= last(1, ty + radius, ny); y++) {
      for (let x = first(0, tx - radius); x <= last(0, tx + radius, nx); x++) {
        const distance = Math.hypot(low[0] + (x + 0.5) * pitch - tx, low[1] + (y + 0.5) * pitch - ty);
        if (distance > radius) continue;
        const column = y * nx + x;
        const z = Math.max(this.bottom, tip + floorAt(distance));
        if (z >= heights[column]!) continue;
        this.set(column, z, tool.slot);
        this.under.push(column);
      }
    }
  }

  /** The first corner of a tile. */
  firstCorner(tile: number): [number, number] {
    const [across] = this.tiles;
    return [(tile % across) * TILE, Math.floor(tile / across) * TILE];
  }

  /** No block is made one piece across this column or row of corners: the stock is cut open there. */
  open: { column?: number; row?: number } = {};

  /** Opens the stock along a column or a row of corners, or nowhere. */
  setOpen(open: { column?: number; row?: number }): void {
    if (open.column === this.open.column && open.row === this.open.row) return;
    this.open = open;
    this.stale.fill(1);
  }

  /** Which way the surface falls at the corners of a tile, from -127 to 127 along X and Y: for the light on walls. */
  falls(tile: number, to: Int8Array): void {
    const { z, width, height } = this;
    const [x0, y0] = this.firstCorner(tile);
    let at = 0;
    for (let row = 0; row < SIDE; row++) {
      const y = Math.min(height - 1, y0 + row);
      const [below, above] = [Math.max(0, y - 1) * width, Math.min(height - 1, y + 1) * width];
      for (let column = 0; column < SIDE; column++, at += 2) {
        const x = Math.min(width - 1, x0 + column);
        const [left, right] = [Math.max(0, x - 1), Math.min(width - 1, x + 1)];
        const own = y * width;
        const [a, b, c] = [z[below + left]!, z[below + x]!, z[below + right]!];
        const [d, e] = [z[own + left]!, z[own + right]!];
        const [f, g, h] = [z[above + left]!, z[above + x]!, z[above + right]!];
        const dx = a + 2 * d + f - c - 2 * e - h;
        const dy = a + 2 * b + c - f - 2 * g - h;
        const size = Math.hypot(dx, dy);
        to[at] = size > 0 ? (127 * dx) / size : 0;
        to[at + 1] = size > 0 ? (127 * dy) / size : 0;
      }
    }
  }

  /** Copies the corners of a tile; beyond the ring they are repeated. */
  copy(tile: number, z: Float32Array, slot: Uint8Array, target?: Float32Array): [number, number] {
    const [x0, y0] = this.firstCorner(tile);
    let [low, high] = [Infinity, -Infinity];
    for (let y = 0, to = 0; y < SIDE; y++) {
      const row = Math.min(this.height - 1, y0 + y) * this.width;
      for (let x = 0; x < SIDE; x++, to++) {
        const from = row + Math.min(this.width - 1, x0 + x);
        const value = this.z[from]!;
        z[to] = value;
        slot[to] = this.slot[from]!;
        if (target) target[to] = this.target![from]!;
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    return [low, high];
  }
}

/**
 * The triangles of a tile: two for a block that is flat and of one owner. Where a block that is not lies next to it,
 * its edge has the corners of both, so that no pixel is missed between them. Gives how many numbers of `index` they take.
 */
export function triangles(z: Float32Array, slot: Uint8Array, target: Float32Array | undefined, index: Uint16Array, open: [number, number] = [-1, -1]): number {
  let count = 0;
  const put = (a: number, b: number, c: number) => {
    index[count++] = a;
    index[count++] = b;
    index[count++] = c;
  };
  const across = TILE / BLOCK;
  const flat: boolean[] = [];
  const isOpen = (from: number, at: number) => at >= from && at <= from + BLOCK;
  for (let y = 0; y < TILE; y += BLOCK) {
    for (let x = 0; x < TILE; x += BLOCK) {
      flat.push(!isOpen(x, open[0]) && !isOpen(y, open[1]) && isFlat(z, slot, target, x, y));
    }
  }
  const cells = (x0: number, y0: number) => {
    for (let y = y0; y < y0 + BLOCK; y++) {
      for (let x = x0; x < x0 + BLOCK; x++) {
        const a = y * SIDE + x;
        const [b, c, d] = [a + 1, a + SIDE, a + SIDE + 1];
        // Along the diagonal that is less steep: walls are straight then.
        if (Math.abs(z[a]! - z[d]!) > Math.abs(z[b]! - z[c]!)) {
          put(a, b, c);
          put(b, d, c);
        } else {
          put(a, b, d);
          put(a, d, c);
        }
      }
    }
  };
  const piece = (x0: number, y0: number, fine: boolean[]) => {
    const a = y0 * SIDE + x0;
    const [b, c, d] = [a + BLOCK, a + BLOCK * SIDE, a + BLOCK * SIDE + BLOCK];
    if (!fine.some(Boolean)) {
      put(a, b, d);
      return put(a, d, c);
    }
    const middle = a + (BLOCK / 2) * SIDE + BLOCK / 2;
    const edge = (from: number, to: number, isFine: boolean) => {
      const parts = isFine ? BLOCK : 1;
      const step = (to - from) / parts;
      for (let part = 0; part < parts; part++) put(middle, from + part * step, from + (part + 1) * step);
    };
    edge(a, b, fine[0]!);
    edge(b, d, fine[1]!);
    edge(d, c, fine[2]!);
    edge(c, a, fine[3]!);
  };
  for (let block = 0; block < across * across; block++) {
    const [x, y] = [block % across, Math.floor(block / across)];
    if (!flat[block]) {
      cells(x * BLOCK, y * BLOCK);
      continue;
    }
    const isFine = (column: number, row: number) =>
      column >= 0 && column < across && row >= 0 && row < across && !flat[row * across + column];
    piece(x * BLOCK, y * BLOCK, [isFine(x, y - 1), isFine(x + 1, y), isFine(x, y + 1), isFine(x - 1, y)]);
  }
  return count;
}

function isFlat(z: Float32Array, slot: Uint8Array, target: Float32Array | undefined, x0: number, y0: number): boolean {
  const first = y0 * SIDE + x0;
  for (let y = y0; y <= y0 + BLOCK; y++) {
    for (let x = x0; x <= x0 + BLOCK; x++) {
      const at = y * SIDE + x;
      if (z[at] !== z[first] || slot[at] !== slot[first]) return false;
      if (target && target[at] !== target[first]) return false;
    }
  }
  return true;
}
