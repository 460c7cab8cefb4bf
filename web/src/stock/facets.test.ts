import { type BufferGeometry, type Mesh, ShaderMaterial } from "three";
import { expect, test } from "vitest";
import { CoarseSurface } from "./coarse-surface";
import { type TileCorners, triangles } from "./facets";
import type { StockBefore } from "./stock-timeline";
import { StockSurface } from "./surface";
import { TILE_CORNERS, TILE_CELLS } from "./tile";
import { TileMeshes } from "./tile-meshes";

const corners = (): TileCorners => ({ z: new Float32Array(TILE_CORNERS * TILE_CORNERS), slot: new Uint8Array(TILE_CORNERS * TILE_CORNERS) });
const index = new Uint16Array(6 * TILE_CELLS * TILE_CELLS);
const at = (x: number, y: number) => y * TILE_CORNERS + x;

/** The triangles as corners in the tile. */
function drawn(of: TileCorners, ...more: [number?, [number, number]?]) {
  const count = triangles(of, index, ...more);
  return Array.from({ length: count / 3 }, (_, n) => [...index.subarray(3 * n, 3 * n + 3)].map((corner) => [corner % TILE_CORNERS, Math.floor(corner / TILE_CORNERS)] as const));
}

const area = (all: ReturnType<typeof drawn>) => all.reduce((sum, [a, b, c]) => {
  return sum + Math.abs((b![0] - a![0]) * (c![1] - a![1]) - (c![0] - a![0]) * (b![1] - a![1])) / 2;
}, 0);

/** Corners that lie on an edge of a triangle between its ends: a pixel may be missed there. */
function loose(all: ReturnType<typeof drawn>): number {
  const used = new Set(all.flat().map(([x, y]) => at(x, y)));
  let found = 0;
  for (const three of all) {
    for (const [from, to] of [[0, 1], [1, 2], [2, 0]] as const) {
      const [a, b] = [three[from]!, three[to]!];
      const parts = Math.max(Math.abs(b[0] - a[0]), Math.abs(b[1] - a[1]));
      for (let part = 1; part < parts; part++) {
        const [x, y] = [a[0] + ((b[0] - a[0]) * part) / parts, a[1] + ((b[1] - a[1]) * part) / parts];
        if (Number.isInteger(x) && Number.isInteger(y) && used.has(at(x, y))) found++;
      }
    }
  }
  return found;
}

test("a flat tile is two triangles, and none where nothing is left", () => {
  expect(drawn(corners()).length).toBe(2);
  expect(drawn(corners(), 0).length).toBe(0);
  expect(drawn(corners(), -1).length).toBe(2);
});

test("around what is not flat squares are small, and no corner lies within the edge of another", () => {
  const some = corners();
  some.z[at(11, 11)] = -2;
  let all = drawn(some);
  expect(area(all)).toBe(TILE_CELLS * TILE_CELLS);
  expect(loose(all)).toBe(0);
  expect(all.length).toBeLessThan(120);
  // A pocket with an island, and a target and owners of their own.
  for (let y = 3; y < 29; y++) for (let x = 5; x < 30; x++) if (Math.hypot(x - 16, y - 15) > 5) some.z[at(x, y)] = -3;
  for (let x = 0; x < TILE_CORNERS; x++) some.slot[at(x, 2)] = 1;
  some.target = new Float32Array(TILE_CORNERS * TILE_CORNERS);
  some.target[at(20, 31)] = 1;
  all = drawn(some);
  expect(area(all)).toBe(TILE_CELLS * TILE_CELLS);
  expect(loose(all)).toBe(0);
});

test("a flat tile has on its edge the corners of the tile beside it", () => {
  const stock: StockBefore = { low: [0, 0, -10], high: [100, 100, 0], pitch: 1, columns: [100, 100], heights: new Float32Array(10_000), toleranceMm: 0 };
  const surface = new StockSurface(stock);
  for (let n = 0; n < 9; n++) surface.set((40 + n) * 100 + 66 + n, -3, 1);
  const tiles = new TileMeshes(surface, new ShaderMaterial());
  tiles.choose(tiles.all);
  const [left, right] = [1 + surface.tiles[0], 2 + surface.tiles[0]].map((tile) => {
    const { geometry } = tiles.group.children[tile] as Mesh<BufferGeometry>;
    return new Set(geometry.index!.array.subarray(0, geometry.drawRange.count) as Uint16Array);
  });
  const rows = [...Array(TILE_CORNERS).keys()];
  const shared = rows.filter((y) => right!.has(at(0, y)));
  expect(shared.length).toBeGreaterThan(5);
  expect(rows.filter((y) => left!.has(at(TILE_CELLS, y)))).toEqual(shared);
});

test("a hole is left out, its walls are not", () => {
  const some = corners();
  for (let y = 8; y <= 16; y++) for (let x = 8; x <= 16; x++) some.z[at(x, y)] = -10;
  expect(area(drawn(some, -10))).toBe(TILE_CELLS * TILE_CELLS - 64);
});

test("no square is one piece where the stock is cut open", () => {
  const all = drawn(corners(), undefined, [12, -1]);
  expect(loose(all)).toBe(0);
  const column = all.filter((three) => three.every(([x]) => x >= 11 && x <= 13));
  expect(area(column)).toBe(2 * TILE_CELLS);
});

test("the coarse surface has heights of the stock, and both its edges", () => {
  const stock: StockBefore = { low: [0, 0, -10], high: [100, 50, 0], pitch: 1, columns: [100, 50], heights: new Float32Array(5000), toleranceMm: 0 };
  const fine = new StockSurface(stock);
  const coarse = new CoarseSurface(fine, 200);
  expect(coarse.surface.stock.columns).toEqual([20, 10]);
  for (let y = 0; y < 50; y++) for (let x = 0; x < 100; x++) fine.set(100 * y + x, -0.1 * x, x < 50 ? 1 : 2);
  coarse.update();
  const row = [...coarse.surface.z.subarray(coarse.surface.width, 2 * coarse.surface.width)];
  expect(row.length).toBe(22);
  const ends = [row[0], row[1], row.at(-2), row.at(-1)];
  [-10, 0, -9.9, -10].forEach((z, n) => expect(ends[n]).toBeCloseTo(z, 5));
  expect(row[5]).toBeCloseTo(-0.1 * 22, 6);
  expect([...coarse.surface.slot.subarray(coarse.surface.width + 1, coarse.surface.width + 21)].indexOf(2)).toBe(10);
});
