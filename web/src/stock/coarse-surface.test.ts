import { expect, test } from "vitest";
import { CoarseSurface } from "./coarse-surface";
import type { StockBefore } from "./stock-timeline";
import { StockSurface } from "./surface";

const COLUMNS = 180;
/** Columns of the fine surface along a side of a coarse one. */
const STEP = 6;
const DEPTH = 10;

function stock(): StockBefore {
  const heights = new Float32Array(COLUMNS * COLUMNS);
  return { low: [0, 0, -20], high: [COLUMNS, COLUMNS, 0], pitch: 1, columns: [COLUMNS, COLUMNS], heights, toleranceMm: 0 };
}

/** The coarse surface of a stock that is cut where a place is inside. */
function coarse(isInside: (x: number, y: number) => boolean): CoarseSurface {
  const fine = new StockSurface(stock());
  for (let y = 0; y < COLUMNS; y++) for (let x = 0; x < COLUMNS; x++) if (isInside(x + 0.5, y + 0.5)) fine.set(y * COLUMNS + x, -DEPTH, 1);
  const made = new CoarseSurface(fine, (COLUMNS / STEP) ** 2);
  made.update();
  return made;
}

/** Where a corner is drawn, as the shader has it, and its height. */
function corner({ surface }: CoarseSurface, x: number, y: number): { place: [number, number]; z: number } {
  const at = y * surface.width + x;
  const along = (axis: 0 | 1, number: number) => {
    if (number <= 1) return 0;
    const last = surface.stock.columns[axis];
    return number >= last ? COLUMNS : (number - 0.5 + surface.shift![2 * at + axis]! / 127) * surface.stock.pitch;
  };
  return { place: [along(0, x), along(1, y)], z: surface.z[at]! };
}

/** The ends of edges with a wall between them. */
function walls(made: CoarseSurface): [number, number][][] {
  const found: [number, number][][] = [];
  const { columns: [nx, ny] } = made.surface.stock;
  for (let y = 2; y < ny; y++) {
    for (let x = 2; x < nx; x++) {
      const here = corner(made, x, y);
      for (const next of [corner(made, x + 1, y), corner(made, x, y + 1)]) if (here.z !== next.z) found.push([here.place, next.place]);
    }
  }
  return found;
}

test("a round pocket is round on the coarse surface", () => {
  const [middle, radius] = [91.3, 47.8];
  const made = coarse((x, y) => Math.hypot(x - middle, y - middle) < radius);
  const ends = walls(made);
  expect(ends.length).toBeGreaterThan(50);
  for (const place of ends.flat()) {
    // A column is inside or outside as its middle is, and chords between walls cut the circle a little.
    expect(Math.abs(Math.hypot(place[0] - middle, place[1] - middle) - radius)).toBeLessThan(1.5);
  }
});

test("a straight wall is upright on the coarse surface, whichever way it runs", () => {
  for (const angle of [0, 0.2, Math.PI / 6, Math.PI / 4, 1.2, Math.PI / 2]) {
    const off = (x: number, y: number) => (x - 90.2) * Math.cos(angle) + (y - 90.2) * Math.sin(angle);
    const ends = walls(coarse((x, y) => off(x, y) > 0));
    expect(ends.length).toBeGreaterThan(20);
    for (const [x, y] of ends.flat()) expect(Math.abs(off(x, y))).toBeLessThan(1.5);
  }
});

test("no corner passes another one, and where there is no wall none moves", () => {
  const made = coarse((x, y) => Math.hypot(x - 60.1, y - 71.3) < 30.2 || (Math.abs(x - 130) < 7 && y > 50) || y > 150.3);
  const { width, height } = made.surface;
  for (let y = 1; y + 1 < height; y++) {
    for (let x = 1; x + 1 < width; x++) {
      const { place } = corner(made, x, y);
      if (x + 2 < width) expect(corner(made, x + 1, y).place[0]).toBeGreaterThan(place[0]);
      if (y + 2 < height) expect(corner(made, x, y + 1).place[1]).toBeGreaterThan(place[1]);
    }
  }
  const flat = coarse(() => false);
  expect(flat.surface.shift!.every((fraction) => fraction === 0)).toBe(true);
});
