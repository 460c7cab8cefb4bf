// A coarser surface that stands for the stock while the view turns, and while too much of it changes at once.

import type { StockBefore } from "./drops";
import { Surface } from "./surface";

export class CoarseSurface {
  readonly surface: Surface;
  /** The column of the fine surface that each of its columns has the height of, and the row. */
  private places: [number[], number[]];

  /** With so many columns at most. */
  constructor(private fine: Surface, most: number) {
    const { stock } = fine;
    const step = Math.max(1, Math.ceil(Math.sqrt((stock.columns[0] * stock.columns[1]) / most)));
    this.places = [placesOf(stock.columns[0], step), placesOf(stock.columns[1], step)];
    this.surface = new Surface(this.stock(stock, step));
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
    // A corner is a column and one.
    const nearest = (places: number[], corner: number | undefined) =>
      corner === undefined ? {} : { at: 1 + Math.max(0, places.findLastIndex((place) => place <= corner - 1)) };
    const [column_, row_] = [nearest(across, fine.open.column).at, nearest(up, fine.open.row).at];
    surface.setOpen({ ...(column_ === undefined ? {} : { column: column_ }), ...(row_ === undefined ? {} : { row: row_ }) });
  }
}

/** The middle of so many columns at a time; at both ends the outermost, which reaches to the edge. */
function placesOf(count: number, step: number): number[] {
  const places = Array.from({ length: Math.ceil(count / step) }, (_, at) => Math.min(count - 1, at * step + (step >> 1)));
  if (places.length > 1) [places[0], places[places.length - 1]] = [0, count - 1];
  return places;
}
