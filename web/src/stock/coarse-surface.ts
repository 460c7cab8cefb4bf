// A coarser surface that is drawn instead of the stock while the view turns, and while too much changes at once.

import type { StockBefore } from "./stock-timeline";
import { StockSurface } from "./surface";

export class CoarseSurface {
  readonly surface: StockSurface;
  /** The columns and the rows of the fine surface whose heights it has. */
  private samples: [number[], number[]];
  /** How many columns of the fine surface one of its columns replaces, along X and along Y. */
  private step: number;

  constructor(private fine: StockSurface, maxColumns: number) {
    const { stock } = fine;
    const step = Math.max(1, Math.ceil(Math.sqrt((stock.columns[0] * stock.columns[1]) / maxColumns)));
    this.step = step;
    this.samples = [samplesOf(stock.columns[0], step), samplesOf(stock.columns[1], step)];
    this.surface = new StockSurface(this.coarseStock(stock, step), step > 1);
  }

  private coarseStock(stock: StockBefore, step: number): StockBefore {
    const [xs, ys] = this.samples;
    const sampled = (all: Float32Array) => Float32Array.from(ys.flatMap((y) => xs.map((x) => all[y * stock.columns[0] + x]!)));
    return {
      ...stock,
      pitch: step * stock.pitch,
      columns: [xs.length, ys.length],
      heights: sampled(stock.heights),
      target: stock.target && sampled(stock.target),
    };
  }

  /** Copies the present heights and the open section of the fine surface. */
  update(): void {
    const { fine, surface, samples: [xs, ys] } = this;
    let column = 0;
    for (const y of ys) {
      const row = (y + 1) * fine.width + 1;
      for (const x of xs) surface.set(column++, fine.z[row + x]!, fine.slot[row + x]!);
    }
    if (surface.shift) this.moveToWalls();
    // Corner x + 1 is column x.
    const cornerBefore = (samples: number[], corner: number) => 1 + Math.max(0, samples.findLastIndex((sample) => sample <= corner - 1));
    const { open } = fine;
    surface.setOpen({
      ...(open.column === undefined ? {} : { column: cornerBefore(xs, open.column) }),
      ...(open.row === undefined ? {} : { row: cornerBefore(ys, open.row) }),
    });
  }

  /** Moves the corners next to a wall to it: otherwise a wall would be a slope as wide as a coarse column, and a round wall steps of such slopes. */
  private moveToWalls(): void {
    const { surface, step, samples: [xs, ys] } = this;
    let index = 0;
    for (const [row, y] of ys.entries()) {
      for (const [column, x] of xs.entries()) {
        const walls = [this.distanceToWall(x, y, column, 0), this.distanceToWall(x, y, row, 1)] as const;
        const offset = offsetToWalls(...walls);
        // From the middle of the coarse column, as a fraction of it.
        const shift = (sample: number, number: number, moved: number) => (sample + 0.5 + moved) / step - (number + 0.5);
        const isAtWall = walls.some((columns) => columns !== undefined);
        surface.move(index++, isAtWall ? [shift(x, column, offset[0]), shift(y, row, offset[1])] : [0, 0]);
      }
    }
  }

  /** The distance along X (0) or Y (1) to the nearest wall before the next coarse corner, in fine columns; undefined where there is none. */
  private distanceToWall(x: number, y: number, number: number, axis: 0 | 1): number | undefined {
    const { fine, step, samples } = this;
    const from = (y + 1) * fine.width + x + 1;
    const stride = axis === 0 ? 1 : fine.width;
    const z = fine.z[from]!;
    let nearest: number | undefined;
    for (const side of [-1, 1]) {
      const next = samples[axis][number + side];
      if (next === undefined) continue;
      const count = Math.abs(next - samples[axis][number]!);
      const other = fine.z[from + side * count * stride]!;
      // Up to 45° it is a slope and no wall.
      if (Math.abs(other - z) <= step * fine.stock.pitch) continue;
      let columns = 1;
      while (columns < count && isNearer(fine.z[from + side * columns * stride]!, z, other)) columns++;
      if (nearest === undefined || columns - 1 < Math.abs(nearest)) nearest = side * (columns - 1);
    }
    return nearest;
  }
}

/** Whether a height is nearer to the first of two others. */
function isNearer(z: number, first: number, other: number): boolean {
  return Math.abs(z - first) <= Math.abs(z - other);
}

/** From a corner to the nearest point of the line through the walls that lie so far away along X and along Y. */
function offsetToWalls(x: number | undefined, y: number | undefined): [number, number] {
  if (x === undefined || y === undefined) return [x ?? 0, y ?? 0];
  const square = x * x + y * y;
  return square > 0 ? [(x * y * y) / square, (y * x * x) / square] : [0, 0];
}

/** The middle of every `step` columns; at both ends the outermost column, which reaches to the edge. */
function samplesOf(count: number, step: number): number[] {
  const samples = Array.from({ length: Math.ceil(count / step) }, (_, index) => Math.min(count - 1, index * step + (step >> 1)));
  if (samples.length > 1) [samples[0], samples[samples.length - 1]] = [0, count - 1];
  return samples;
}
