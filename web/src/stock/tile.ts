// The size of the tiles that the surface of a stock is divided into.

/** Cells along a side of a tile, a power of two: a tile is divided as a quadtree. */
export const TILE_CELLS = 32;
/** Corners along a side of a tile. */
export const TILE_CORNERS = TILE_CELLS + 1;
