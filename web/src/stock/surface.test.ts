import { expect, test } from "vitest";
import type { StockBefore } from "./stock-timeline";
import { StockSurface } from "./surface";
import { TILE_CORNERS } from "./tile";
import { floorOf } from "./tool-floor";

function stock(nx: number, ny: number): StockBefore {
  return { low: [0, 0, -10], high: [nx, ny, 0], pitch: 1, columns: [nx, ny], heights: new Float32Array(nx * ny), toleranceMm: 0 };
}

test("columns are corners within a ring at the bottom", () => {
  const surface = new StockSurface(stock(3, 2));
  expect([surface.width, surface.height]).toEqual([5, 4]);
  expect([...surface.z.subarray(0, 5)]).toEqual([-10, -10, -10, -10, -10]);
  expect([...surface.z.subarray(5, 10)]).toEqual([-10, 0, 0, 0, -10]);
  surface.set(5, -3, 1);
  expect(surface.z[2 * 5 + 3]).toBe(-3);
  expect(surface.takeTouched()).toEqual({ columns: [2, 2], rows: [1, 1], heights: [-3, 0] });
  expect(surface.takeTouched()).toBeUndefined();
});

test("a column on the edge of a tile changes both, and no other", () => {
  const surface = new StockSurface(stock(100, 40));
  surface.stale.fill(0);
  // Column 31 is corner 32: the last of the first tile, and the first of the next.
  surface.set(31, -1, 1);
  expect([...surface.stale]).toEqual([1, 1, 0, 0, 0, 0, 0, 0]);
  surface.stale.fill(0);
  surface.set(30, -1, 1);
  expect([...surface.stale]).toEqual([1, 0, 0, 0, 0, 0, 0, 0]);
  // The same again is no change.
  surface.stale.fill(0);
  surface.set(30, -1, 1);
  expect(surface.stale.some(Boolean)).toBe(false);
});

test("the light on walls follows the way the surface falls", () => {
  const surface = new StockSurface(stock(100, 100));
  for (let y = 0; y < 100; y++) for (let x = 50; x < 100; x++) surface.set(y * 100 + x, -5, 1);
  const to = new Int8Array(2 * TILE_CORNERS * TILE_CORNERS);
  surface.downhill(1 + surface.tiles[0], to);
  // Column 49 is corner 50, 18 after the first of the tile.
  const at = (column: number) => [to[2 * (10 * TILE_CORNERS + column)], to[2 * (10 * TILE_CORNERS + column) + 1]];
  expect(at(18)).toEqual([127, 0]);
  expect(at(19)).toEqual([127, 0]);
  expect(at(25)).toEqual([0, 0]);
});

test("the tool cuts where it stands, and what it cut so is there again when it has gone", () => {
  const surface = new StockSurface(stock(20, 20));
  const heights = new Float32Array(400);
  const slots = new Uint8Array(400);
  heights[210] = -5;
  surface.set(210, -5, 1);
  slots[210] = 1;
  const floor = floorOf({ shape: "ball", diameter_mm: 6 })!;
  surface.cutUnderTool({ floor, slot: 2, at: [10.5, 10.5, -2] }, heights, slots);
  const at = (x: number, y: number) => surface.z[(y + 1) * surface.width + x + 1]!;
  // The tip is 2 mm below the top; 2 mm off the ball of 3 mm is 3 − √5 higher. What was deeper stays.
  expect(at(12, 10)).toBeCloseTo(-2 + 3 - Math.sqrt(5), 6);
  expect(at(10, 10)).toBe(-5);
  expect(at(14, 10)).toBe(0);
  surface.cutUnderTool(undefined, heights, slots);
  expect(at(12, 10)).toBe(0);
  expect(at(10, 10)).toBe(-5);
});

test("the floor of each shape is that of its outline", () => {
  const at = (tool: Parameters<typeof floorOf>[0], distance: number) => floorOf(tool)!.heightAt(distance);
  expect(at({ shape: "flat", diameter_mm: 10 }, 4.9)).toBe(0);
  expect(at({ shape: "bull", diameter_mm: 10, corner_radius_mm: 2 }, 4)).toBeCloseTo(2 - Math.sqrt(3), 9);
  expect(at({ shape: "drill", diameter_mm: 10, point_angle_rad: Math.PI / 2 }, 3)).toBeCloseTo(3, 9);
  expect(at({ shape: "chamfer", diameter_mm: 10, tip_diameter_mm: 2, point_angle_rad: Math.PI / 2 }, 3)).toBeCloseTo(2, 9);
  expect(at({ shape: "form", profile_mm: [[0, 0], [1, 4], [3, 4], [5, 6]] }, 2)).toBeCloseTo(0.5, 9);
  expect(at({ shape: "form", profile_mm: [[0, 0], [1, 4], [3, 4], [5, 6]] }, 5)).toBeCloseTo(4, 9);
  expect(floorOf({ shape: "flat" })).toBeUndefined();
  expect(floorOf(undefined)).toBeUndefined();
});

test("all columns at once are the same as one by one", () => {
  const [one, all] = [new StockSurface(stock(70, 40)), new StockSurface(stock(70, 40))];
  for (const surface of [one, all]) surface.stale.fill(0);
  const heights = new Float32Array(2800);
  const slots = new Uint8Array(2800);
  for (const column of [0, 31, 32, 69, 70 * 31 + 5, 70 * 32 + 31, 2799]) {
    [heights[column], slots[column]] = [-1 - (column % 3), 2];
    one.set(column, heights[column]!, 2);
  }
  all.setAll(heights, slots);
  expect([all.z, all.slot, all.stale]).toEqual([one.z, one.slot, one.stale]);
  expect(all.takeTouched()).toEqual(one.takeTouched());
});
