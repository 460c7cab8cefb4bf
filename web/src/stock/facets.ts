// Triangulation of a tile as a quadtree: large squares where the surface is flat.

import { TILE_CORNERS, TILE_CELLS } from "./tile";

/** The corners of a tile, row by row. */
export interface TileCorners {
  /** Heights, mm from the top of the stock. */
  z: Float32Array;
  /** Colour slots of the tools that cut them; 0 where none did. */
  slot: Uint8Array;
  /** Heights of the target. */
  target?: Float32Array | undefined;
  /** Offsets along X and Y, in 127ths of a column; undefined where corners are not moved. */
  shift?: Int8Array | undefined;
}

/** Which corners on the four edges of a tile are corners of squares; the edges follow each other: lowest and highest Y, lowest and highest X. */
export type TileEdges = Uint8Array;

export const noEdges = (): TileEdges => new Uint8Array(4 * TILE_CORNERS);

/** For each edge, the offset of the adjacent tile along X and Y, and which of its edges is the shared one. */
export const ADJACENT_TILES = [[0, -1, 1], [0, 1, 0], [-1, 0, 3], [1, 0, 2]] as const;

/** How often a tile is halved until its squares are cells. */
const HALVINGS = Math.log2(TILE_CELLS);
/** A column that is lower above the bottom has no stock left, mm. */
export const MIN_HEIGHT_MM = 1e-4;

/** For each size of a square, from cells up, which squares are flat and cut by one tool. */
const flat = Array.from({ length: HALVINGS + 1 }, (_, halving) => new Uint8Array((TILE_CELLS >> halving) ** 2));
/** Which corners are corners of squares. */
const used = new Uint8Array(TILE_CORNERS * TILE_CORNERS);
/** The first corner and the size of each square that is larger than a cell. */
const largeSquares = new Uint16Array(2 * TILE_CELLS * TILE_CELLS);

/**
 * Writes the triangles of a tile to `index`, and returns how many indices they take. A square that is flat and cut by one tool is
 * two triangles; where smaller squares lie next to it, also in adjacent tiles (`neighbors`), its edge has their corners too, so
 * that there are no cracks. The corners on the edges of the tile itself are written to `own`. Squares without stock are left out,
 * and none crosses the column or row of corners `open`.
 */
export function triangles(
  corners: TileCorners,
  index: Uint16Array,
  bottom = -Infinity,
  open: [number, number] = [-1, -1],
  edges?: { own: TileEdges; neighbors: TileEdges },
): number {
  findFlat(corners, open);
  used.fill(0);
  const { z } = corners;
  let count = 0;
  const addTriangle = (a: number, b: number, c: number) => {
    index[count++] = a;
    index[count++] = b;
    index[count++] = c;
  };
  let squares = 0;
  const hasStock = (a: number) => z[a]! > bottom + MIN_HEIGHT_MM;
  const divide = (halving: number, x: number, y: number) => {
    const size = 1 << halving;
    const a = y * TILE_CORNERS + x;
    const isFlat = flat[halving]![(y >> halving) * (TILE_CELLS >> halving) + (x >> halving)];
    if (!isFlat && halving > 0) {
      const half = size >> 1;
      divide(halving - 1, x, y);
      divide(halving - 1, x + half, y);
      divide(halving - 1, x, y + half);
      divide(halving - 1, x + half, y + half);
      return;
    }
    const [b, c, d] = [a + size, a + size * TILE_CORNERS, a + size * TILE_CORNERS + size];
    used[a] = used[b] = used[c] = used[d] = 1;
    if (isFlat && !hasStock(a)) return;
    if (halving > 0) {
      largeSquares[squares++] = a;
      largeSquares[squares++] = size;
    } else if (Math.abs(z[a]! - z[d]!) > Math.abs(z[b]! - z[c]!)) {
      // Divided along the less steep diagonal, so that walls are straight.
      addTriangle(a, b, c);
      addTriangle(b, d, c);
    } else {
      addTriangle(a, b, d);
      addTriangle(a, d, c);
    }
  };
  divide(HALVINGS, 0, 0);
  if (edges) exchangeEdges(edges);
  for (let square = 0; square < squares; square += 2) {
    const [a, size] = [largeSquares[square]!, largeSquares[square + 1]!];
    const [b, c, d] = [a + size, a + size * TILE_CORNERS, a + size * TILE_CORNERS + size];
    const sides = [[a, b, 1], [b, d, TILE_CORNERS], [d, c, -1], [c, a, -TILE_CORNERS]] as const;
    if (!sides.some(([from, to, step]) => isDivided(from, to, step))) {
      addTriangle(a, b, d);
      addTriangle(a, d, c);
      continue;
    }
    const middle = a + (size >> 1) * (TILE_CORNERS + 1);
    for (const [from, to, step] of sides) {
      let before: number = from;
      for (let corner = from + step; ; corner += step) {
        if (!used[corner]) continue;
        addTriangle(middle, before, corner);
        before = corner;
        if (corner === to) break;
      }
    }
  }
  return count;
}

/** Writes the used corners on the edges of the tile to `own`, and marks those of the adjacent tiles as used. */
function exchangeEdges({ own, neighbors }: { own: TileEdges; neighbors: TileEdges }): void {
  const cornersAt = (n: number) => [n, TILE_CELLS * TILE_CORNERS + n, n * TILE_CORNERS, n * TILE_CORNERS + TILE_CELLS];
  for (let n = 0; n < TILE_CORNERS; n++) cornersAt(n).forEach((corner, edge) => (own[edge * TILE_CORNERS + n] = used[corner]!));
  for (let n = 0; n < TILE_CORNERS; n++) cornersAt(n).forEach((corner, edge) => (used[corner]! |= neighbors[edge * TILE_CORNERS + n]!));
}

/** Whether there are used corners between two corners of a square. */
function isDivided(from: number, to: number, step: number): boolean {
  for (let corner = from + step; corner !== to; corner += step) if (used[corner]) return true;
  return false;
}

/** Fills `flat`: squares of equal corners that `open` does not touch. */
function findFlat({ z, slot, target }: TileCorners, open: [number, number]): void {
  const cells = flat[0]!;
  for (let y = 0, cell = 0; y < TILE_CELLS; y++) {
    for (let x = 0; x < TILE_CELLS; x++, cell++) {
      const a = y * TILE_CORNERS + x;
      const c = a + TILE_CORNERS;
      cells[cell] = Number(
        z[a] === z[a + 1] && z[a] === z[c] && z[a] === z[c + 1] &&
        slot[a] === slot[a + 1] && slot[a] === slot[c] && slot[a] === slot[c + 1] &&
        (!target || (target[a] === target[a + 1] && target[a] === target[c] && target[a] === target[c + 1])),
      );
    }
  }
  for (let halving = 1; halving <= HALVINGS; halving++) {
    const [across, size] = [TILE_CELLS >> halving, 1 << halving];
    const [squares, quarters] = [flat[halving]!, flat[halving - 1]!];
    const isOpen = (from: number, line: number) => line >= from && line <= from + size;
    for (let y = 0; y < across; y++) {
      for (let x = 0; x < across; x++) {
        const first = 4 * y * across + 2 * x;
        const areFlat = quarters[first]! & quarters[first + 1]! & quarters[first + 2 * across]! & quarters[first + 2 * across + 1]!;
        squares[y * across + x] = areFlat && !isOpen(x * size, open[0]) && !isOpen(y * size, open[1]) ? 1 : 0;
      }
    }
  }
}
