// A coarser surface that replaces the stock while the view turns, and while too much of it changes at once.

import type { StockBefore } from "./stock-timeline";
import { StockSurface } from "./surface";

export class CoarseSurface {
  readonly surface: StockSurface;
  /** The column of the fine surface that each of its columns has the height of, and the row. */
  private places: [number[], number[]];
  /** How many columns, and rows, of the fine surface make one. */
  private step: number;

  /** With so many columns at most. */
  constructor(private fine: StockSurface, most: number) {
    const { stock } = fine;
    const step = Math.max(1, Math.ceil(Math.sqrt((stock.columns[0] * stock.columns[1]) / most)));
    this.step = step;
    this.places = [placesOf(stock.columns[0], step), placesOf(stock.columns[1], step)];
    this.surface = new StockSurface(this.stock(stock, step), step > 1);
  }

  private stock(stock: StockBefore, step: number): StockBefore {
    const [across, up] = this.places;
    const every = (all: Float32Array) => Float32Array.from(up.flatMap((y) => across.map((x) => all[y * stock.columns[0] + x]!)));
    return {
      ...stock,
      pitch: step * stock.pitch,
      columns: [across.length, up.length],
      heights: every(stock.heights),
      target: stock.target && every(stock.target),
    };
  }

  /** Takes the heights as they are now, and where the stock is cut open. */
  take(): void {
    const { fine, surface, places: [across, up] } = this;
    let column = 0;
    for (const y of up) {
      const row = (y + 1) * fine.width + 1;
      for (const x of across) surface.set(column++, fine.z[row + x]!, fine.slot[row + x]!);
    }
    if (surface.shift) this.moveToWalls();
    // Corner x + 1 is column x.
    const nearest = (places: number[], corner: number | undefined) =>
      corner === undefined ? {} : { at: 1 + Math.max(0, places.findLastIndex((place) => place <= corner - 1)) };
    const [column_, row_] = [nearest(across, fine.open.column).at, nearest(up, fine.open.row).at];
    surface.setOpen({ ...(column_ === undefined ? {} : { column: column_ }), ...(row_ === undefined ? {} : { row: row_ }) });
  }

  /**
   * Corners next to a wall move to it: between them it would be a slope as wide as a coarse column, and stairs of such
   * slopes where it is round.
   */
  private moveToWalls(): void {
    const { surface, step, places: [across, up] } = this;
    let column = 0;
    for (const [row, y] of up.entries()) {
      for (const [at, x] of across.entries()) {
        const walls = [this.toWall(x, y, at, 0), this.toWall(x, y, row, 1)] as const;
        const offset = between(...walls);
        const fraction = (place: number, number: number, moved: number) => (place + 0.5 + moved) / step - (number + 0.5);
        const isAtWall = walls.some((columns) => columns !== undefined);
        surface.move(column++, isAtWall ? [fraction(x, at, offset[0]), fraction(y, row, offset[1])] : [0, 0]);
      }
    }
  }

  /** How many columns on along X (0) or Y (1) the nearest wall is, before the next corner; undefined where there is none. */
  private toWall(x: number, y: number, number: number, axis: 0 | 1): number | undefined {
    const { fine, step, places } = this;
    const from = (y + 1) * fine.width + x + 1;
    const along = axis === 0 ? 1 : fine.width;
    const own = fine.z[from]!;
    let nearest: number | undefined;
    for (const side of [-1, 1]) {
      const next = places[axis][number + side];
      if (next === undefined) continue;
      const count = Math.abs(next - places[axis][number]!);
      const other = fine.z[from + side * count * along]!;
      // If it is not steeper than that, it is a slope and no wall.
      if (Math.abs(other - own) <= step * fine.stock.pitch) continue;
      let columns = 1;
      while (columns < count && isNearer(fine.z[from + side * columns * along]!, own, other)) columns++;
      if (nearest === undefined || columns - 1 < Math.abs(nearest)) nearest = side * (columns - 1);
    }
    return nearest;
  }
}

function isNearer(z: number, own: number, other: number): boolean {
  return Math.abs(z - own) <= Math.abs(z - other);
}

/** From a corner to the line through walls along X and along Y, as far away as they are. */
function between(x: number | undefined, y: number | undefined): [number, number] {
  if (x === undefined || y === undefined) return [x ?? 0, y ?? 0];
  const square = x * x + y * y;
  return square > 0 ? [(x * y * y) / square, (y * x * x) / square] : [0, 0];
}

/** The middle of so many columns at a time; at both ends the outermost, which reaches to the edge. */
function placesOf(count: number, step: number): number[] {
  const places = Array.from({ length: Math.ceil(count / step) }, (_, at) => Math.min(count - 1, at * step + (step >> 1)));
  if (places.length > 1) [places[0], places[places.length - 1]] = [0, count - 1];
  return places;
}
