// The triangles of a tile: large ones where the surface is flat.

import { TILE_CORNERS, TILE_CELLS } from "./tile";

/** Corners of a tile: heights, slots of the tools that cut them, and heights of the target where there is one. */
export interface TileCorners {
  z: Float32Array;
  slot: Uint8Array;
  target?: Float32Array | undefined;
  /** How far corners are moved, if they may be. */
  shift?: Int8Array | undefined;
}

/** Which corners squares have on the four edges of a tile, after each other: least and largest Y, least and largest X. */
export type TileEdges = Uint8Array;
export const noEdges = (): TileEdges => new Uint8Array(4 * TILE_CORNERS);

/** The tile that lies beyond each edge, in tiles along X and Y, and the edge of it that is the same. */
export const ADJACENT_TILES = [[0, -1, 1], [0, 1, 0], [-1, 0, 3], [1, 0, 2]] as const;

/** Squares of a tile are halved so often until they are cells. */
const HALVINGS = Math.log2(TILE_CELLS);
/** Below this height over the bottom nothing is left, mm. */
export const MIN_HEIGHT_MM = 1e-4;

/** For each size of a square, cells first, which of them are flat and of one owner. */
const flat = Array.from({ length: HALVINGS + 1 }, (_, halving) => new Uint8Array((TILE_CELLS >> halving) ** 2));
/** Which corners some square has. */
const used = new Uint8Array(TILE_CORNERS * TILE_CORNERS);
/** The first corners of squares that are larger than a cell, and their sizes: of each two numbers. */
const large = new Uint16Array(2 * TILE_CELLS * TILE_CELLS);

/**
 * Writes the triangles of a tile to `index` and gives how many numbers they take. A square that is flat and of one owner
 * is two; where smaller ones lie next to it, its edge has their corners too, so that no pixel is missed between them:
 * also those of the adjacent tiles, and its own are written to `own`. Nothing is drawn where nothing is left, and no square
 * lies across the column or row of corners `open`.
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
  const put = (a: number, b: number, c: number) => {
    index[count++] = a;
    index[count++] = b;
    index[count++] = c;
  };
  let squares = 0;
  const isThere = (a: number) => z[a]! > bottom + MIN_HEIGHT_MM;
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
    if (isFlat && !isThere(a)) return;
    if (halving > 0) {
      large[squares++] = a;
      large[squares++] = size;
    } else if (Math.abs(z[a]! - z[d]!) > Math.abs(z[b]! - z[c]!)) {
      // Along the diagonal that is less steep: walls are straight then.
      put(a, b, c);
      put(b, d, c);
    } else {
      put(a, b, d);
      put(a, d, c);
    }
  };
  divide(HALVINGS, 0, 0);
  if (edges) meet(edges);
  for (let at = 0; at < squares; at += 2) {
    const [a, size] = [large[at]!, large[at + 1]!];
    const [b, c, d] = [a + size, a + size * TILE_CORNERS, a + size * TILE_CORNERS + size];
    const edges = [[a, b, 1], [b, d, TILE_CORNERS], [d, c, -1], [c, a, -TILE_CORNERS]] as const;
    if (!edges.some(([from, to, step]) => isDivided(from, to, step))) {
      put(a, b, d);
      put(a, d, c);
      continue;
    }
    const middle = a + (size >> 1) * (TILE_CORNERS + 1);
    for (const [from, to, step] of edges) {
      let before: number = from;
      for (let corner = from + step; ; corner += step) {
        if (!used[corner]) continue;
        put(middle, before, corner);
        before = corner;
        if (corner === to) break;
      }
    }
  }
  return count;
}

/** Writes the corners on the edges of the tile, and takes those of the adjacent tiles. */
function meet({ own, neighbors }: { own: TileEdges; neighbors: TileEdges }): void {
  for (let at = 0; at < TILE_CORNERS; at++) {
    const places = [at, TILE_CELLS * TILE_CORNERS + at, at * TILE_CORNERS, at * TILE_CORNERS + TILE_CELLS];
    places.forEach((place, edge) => (own[edge * TILE_CORNERS + at] = used[place]!));
  }
  for (let at = 0; at < TILE_CORNERS; at++) {
    const places = [at, TILE_CELLS * TILE_CORNERS + at, at * TILE_CORNERS, at * TILE_CORNERS + TILE_CELLS];
    places.forEach((place, edge) => (used[place]! |= neighbors[edge * TILE_CORNERS + at]!));
  }
}

function isDivided(from: number, to: number, step: number): boolean {
  for (let corner = from + step; corner !== to; corner += step) if (used[corner]) return true;
  return false;
}

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
    const [own, parts] = [flat[halving]!, flat[halving - 1]!];
    const isOpen = (from: number, at: number) => at >= from && at <= from + size;
    for (let y = 0; y < across; y++) {
      for (let x = 0; x < across; x++) {
        const part = 4 * y * across + 2 * x;
        const areFlat = parts[part]! & parts[part + 1]! & parts[part + 2 * across]! & parts[part + 2 * across + 1]!;
        own[y * across + x] = areFlat && !isOpen(x * size, open[0]) && !isOpen(y * size, open[1]) ? 1 : 0;
      }
    }
  }
}
