// The surface of a stock as a grid of corners in tiles, and which parts of it have changed.

import type { TileCorners } from "./facets";
import type { StockBefore } from "./stock-timeline";
import { TILE_CORNERS, TILE_CELLS } from "./tile";
import type { ToolFloor } from "./tool-floor";

/** Ranges of columns, rows of columns and heights in which something has changed. */
export interface TouchedBox {
  columns: [number, number];
  rows: [number, number];
  heights: [number, number];
}

/** Corners are in the middles of columns; a ring of corners around them at the bottom makes the sides. So column x is corner x + 1. */
export class StockSurface {
  readonly width: number;
  readonly height: number;
  /** Heights of corners, mm from the top of the stock. */
  readonly z: Float32Array;
  /** Colour slots of the tools that cut the corners; 0 where none did. */
  readonly slot: Uint8Array;
  /** Heights of the target; undefined where there is none. */
  readonly target: Float32Array | undefined;
  /** Offsets of corners along X and Y, in 127ths of a column; undefined where they are not moved. */
  readonly shift: Int8Array | undefined;
  /** Height of the bottom, mm from the top of the stock. */
  readonly bottom: number;
  /** Number of tiles along X and Y. */
  readonly tiles: [number, number];
  /** 1 for each tile whose corners have changed since its mesh was updated. */
  readonly stale: Uint8Array;
  private touched: TouchedBox | undefined;
  /** The columns that the tool lowers at its present position. */
  private loweredColumns: number[] = [];

  /** With `hasShift` corners may be moved out of the middles of columns. */
  constructor(readonly stock: StockBefore, hasShift = false) {
    const [nx, ny] = stock.columns;
    [this.width, this.height] = [nx + 2, ny + 2];
    this.bottom = stock.low[2] - stock.high[2];
    this.z = new Float32Array(this.width * this.height).fill(this.bottom);
    this.slot = new Uint8Array(this.z.length);
    this.shift = hasShift ? new Int8Array(2 * this.z.length) : undefined;
    this.target = stock.target && new Float32Array(this.z.length).fill(this.bottom);
    for (let row = 0; row < ny; row++) {
      const [from, to] = [row * nx, this.corner(0, row)];
      this.z.set(stock.heights.subarray(from, from + nx), to);
      this.target?.set(stock.target!.subarray(from, from + nx), to);
    }
    this.tiles = [Math.ceil((nx + 1) / TILE_CELLS), Math.ceil((ny + 1) / TILE_CELLS)];
    this.stale = new Uint8Array(this.tiles[0] * this.tiles[1]).fill(1);
  }

  /** The index of the corner of a column. */
  private corner(column: number, row: number): number {
    return (row + 1) * this.width + column + 1;
  }

  /** Sets the height of a column, and the colour slot of the tool that cut it last. */
  set(column: number, z: number, slot: number): void {
    const nx = this.stock.columns[0];
    const [x, y] = [column % nx, Math.floor(column / nx)];
    const at = this.corner(x, y);
    const before = this.z[at]!;
    if (before === z && this.slot[at] === slot) return;
    this.z[at] = z;
    this.slot[at] = slot;
    this.touch(x, y, Math.min(before, z), Math.max(before, z));
    this.outdate(x, y);
  }

  /** Moves the corner of a column by fractions of a column, -1 to 1, and the corners of the ring next to it. */
  move(column: number, [dx, dy]: [number, number]): void {
    const [nx, ny] = this.stock.columns;
    const [x, y] = [column % nx, Math.floor(column / nx)];
    const at = this.corner(x, y);
    const shift = this.shift!;
    const moved = [Math.round(127 * dx), Math.round(127 * dy)] as const;
    if (shift[2 * at] === moved[0] && shift[2 * at + 1] === moved[1]) return;
    shift.set(moved, 2 * at);
    if (x === 0) shift.set(moved, 2 * (at - 1));
    if (x === nx - 1) shift.set(moved, 2 * (at + 1));
    if (y === 0) shift.set(moved, 2 * (at - this.width));
    if (y === ny - 1) shift.set(moved, 2 * (at + this.width));
    this.outdate(x, y);
  }

  /** Marks the tiles of a column as stale. */
  private outdate(x: number, y: number): void {
    // Corner x + 1 also belongs to the tile of cell x.
    const [across] = this.tiles;
    const [left, right] = [Math.floor(x / TILE_CELLS), Math.floor((x + 1) / TILE_CELLS)];
    const [low, high] = [Math.floor(y / TILE_CELLS), Math.floor((y + 1) / TILE_CELLS)];
    this.stale[low * across + left] = 1;
    this.stale[low * across + right] = 1;
    this.stale[high * across + left] = 1;
    this.stale[high * across + right] = 1;
  }

  /** Sets all columns: faster than one by one where many have changed. */
  setAll(heights: Float32Array, slots: Uint8Array): void {
    const [nx, ny] = this.stock.columns;
    const { z, slot, stale, tiles: [across] } = this;
    for (let y = 0; y < ny; y++) {
      const [from, to] = [y * nx, this.corner(0, y)];
      const [below, above] = [Math.floor(y / TILE_CELLS) * across, Math.floor((y + 1) / TILE_CELLS) * across];
      for (let x0 = 0, tile = 0; x0 < nx; x0 += TILE_CELLS, tile++) {
        const end = Math.min(nx, x0 + TILE_CELLS);
        let [first, last, low, high] = [-1, -1, Infinity, -Infinity];
        for (let x = x0; x < end; x++) {
          const before = z[to + x]!;
          const after = heights[from + x]!;
          if (before === after && slot[to + x] === slots[from + x]) continue;
          z[to + x] = after;
          slot[to + x] = slots[from + x]!;
          if (first < 0) first = x;
          last = x;
          low = Math.min(low, before, after);
          high = Math.max(high, before, after);
        }
        if (first < 0) continue;
        this.touch(first, y, low, high);
        this.touch(last, y, low, high);
        // Corner x + 1 also belongs to the tile of cell x.
        const right = last === x0 + TILE_CELLS - 1 ? tile + 1 : tile;
        stale[below + tile] = stale[below + right] = stale[above + tile] = stale[above + right] = 1;
      }
    }
  }

  /** Records that a column has changed between two heights. */
  mark(column: number, low: number, high: number): void {
    const nx = this.stock.columns[0];
    this.touch(column % nx, Math.floor(column / nx), low, high);
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

  /** The box of the changes since the last call; undefined where there are none. */
  takeTouched(): TouchedBox | undefined {
    const { touched } = this;
    this.touched = undefined;
    return touched;
  }

  /** Lowers the columns that a tool cuts at a position in the frame of the run; the next call restores them. */
  cutUnderTool(tool: { floor: ToolFloor; slot: number; at: [number, number, number] } | undefined, heights: Float32Array, slots: Uint8Array): void {
    for (const column of this.loweredColumns) this.set(column, heights[column]!, slots[column]!);
    this.loweredColumns = [];
    if (!tool) return;
    const { low, high, pitch, columns: [nx, ny] } = this.stock;
    const { floor: { radius, heightAt }, at: [tx, ty, tz] } = tool;
    const first = (axis: 0 | 1, from: number) => Math.max(0, Math.ceil((from - low[axis]) / pitch - 0.5));
    const last = (axis: 0 | 1, to: number, count: number) => Math.min(count - 1, Math.floor((to - low[axis]) / pitch - 0.5));
    const tip = tz - high[2];
    for (let y = first(1, ty - radius); y <= last(1, ty + radius, ny); y++) {
      for (let x = first(0, tx - radius); x <= last(0, tx + radius, nx); x++) {
        const distance = Math.hypot(low[0] + (x + 0.5) * pitch - tx, low[1] + (y + 0.5) * pitch - ty);
        if (distance > radius) continue;
        const column = y * nx + x;
        const z = Math.max(this.bottom, tip + heightAt(distance));
        if (z >= heights[column]!) continue;
        this.set(column, z, tool.slot);
        this.loweredColumns.push(column);
      }
    }
  }

  /** The first corner of a tile. */
  firstCorner(tile: number): [number, number] {
    const [across] = this.tiles;
    return [(tile % across) * TILE_CELLS, Math.floor(tile / across) * TILE_CELLS];
  }

  /** The column or row of corners along which the stock is cut open: no flat square crosses it. */
  open: { column?: number; row?: number } = {};

  /** Opens the stock along a column or a row of corners, or nowhere. */
  setOpen(open: { column?: number; row?: number }): void {
    if (open.column === this.open.column && open.row === this.open.row) return;
    this.open = open;
    this.stale.fill(1);
  }

  /** Writes the downhill direction at the corners of a tile, -127 to 127 along X and Y, found with a Sobel filter: for the light on walls. */
  downhill(tile: number, to: Int8Array): void {
    const { z, width, height } = this;
    const [x0, y0] = this.firstCorner(tile);
    let at = 0;
    for (let row = 0; row < TILE_CORNERS; row++) {
      const y = Math.min(height - 1, y0 + row);
      const [below, above] = [Math.max(0, y - 1) * width, Math.min(height - 1, y + 1) * width];
      for (let column = 0; column < TILE_CORNERS; column++, at += 2) {
        const x = Math.min(width - 1, x0 + column);
        const [left, right] = [Math.max(0, x - 1), Math.min(width - 1, x + 1)];
        const center = y * width;
        const [a, b, c] = [z[below + left]!, z[below + x]!, z[below + right]!];
        const [d, e] = [z[center + left]!, z[center + right]!];
        const [f, g, h] = [z[above + left]!, z[above + x]!, z[above + right]!];
        const dx = a + 2 * d + f - c - 2 * e - h;
        const dy = a + 2 * b + c - f - 2 * g - h;
        const size = Math.hypot(dx, dy);
        to[at] = size > 0 ? (127 * dx) / size : 0;
        to[at + 1] = size > 0 ? (127 * dy) / size : 0;
      }
    }
  }

  /** Copies the corners of a tile, those beyond the ring repeated; returns the lowest and the highest, mm. */
  copy(tile: number, { z, slot, target, shift }: TileCorners): [number, number] {
    const [x0, y0] = this.firstCorner(tile);
    let [low, high] = [Infinity, -Infinity];
    for (let y = 0, to = 0; y < TILE_CORNERS; y++) {
      const row = Math.min(this.height - 1, y0 + y) * this.width;
      for (let x = 0; x < TILE_CORNERS; x++, to++) {
        const from = row + Math.min(this.width - 1, x0 + x);
        const value = this.z[from]!;
        z[to] = value;
        slot[to] = this.slot[from]!;
        if (target) target[to] = this.target![from]!;
        if (shift) shift.set(this.shift!.subarray(2 * from, 2 * from + 2), 2 * to);
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    return [low, high];
  }
}
