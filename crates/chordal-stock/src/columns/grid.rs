//! The cells of a stock, their tiles and blocks.
//!
//! A tile has 64 × 64 cells, in 8 × 8 blocks of 8 × 8 cells. The first cell begins at the corner of the stock's box
//! with the least coordinates; the last ones may reach over its edge, and count only with the part inside.

use chordal_geometry::Aabb;

/// Cells along a side of a block.
pub(crate) const BLOCK: usize = 8;
/// Blocks along a side of a tile.
pub(crate) const BLOCKS: usize = 8;
/// Cells along a side of a tile.
pub(crate) const TILE: usize = BLOCK * BLOCKS;
/// Cells of a block.
pub(crate) const CELLS: usize = BLOCK * BLOCK;

/// Cells that are processed at once.
pub(crate) const LANES: usize = 4;
/// Groups of [`LANES`] cells in a block.
pub(crate) const GROUPS: usize = CELLS / LANES;

/// The cells of a stock.
#[derive(Clone, Debug, PartialEq)]
pub struct StockGrid {
    bounds: Aabb,
    resolution: f64,
    cells: [u32; 2],
    tiles: [u32; 2],
}

/// The number of cells along a length, mm.
pub(crate) fn count(length: f64, resolution: f64) -> f64 {
    /// A box that exceeds a whole number of cells by less than this share of a cell gets no further cell.
    const CELL_ROUNDING_SHARE: f64 = 1e-9;
    (length / resolution - CELL_ROUNDING_SHARE).ceil().max(1.0)
}

impl StockGrid {
    pub(crate) fn new(bounds: Aabb, resolution: f64) -> StockGrid {
        let size = bounds.size();
        let cells = [size.x, size.y].map(|length| count(length, resolution) as u32);
        StockGrid {
            bounds,
            resolution,
            cells,
            tiles: cells.map(|cells| cells.div_ceil(TILE as u32)),
        }
    }

    /// The box of the stock, mm.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// The side of a cell, mm.
    pub fn resolution(&self) -> f64 {
        self.resolution
    }

    /// Cells along X and along Y.
    pub fn cells(&self) -> [u32; 2] {
        self.cells
    }

    /// The least and the largest corner of a cell (column, row) within the box, mm.
    pub fn corners(&self, column: u32, row: u32) -> [[f64; 2]; 2] {
        let at = |n: u32, from: f64, to: f64| (from + self.resolution * f64::from(n)).min(to);
        let (min, max) = (self.bounds.min, self.bounds.max);
        [
            [at(column, min.x, max.x), at(row, min.y, max.y)],
            [at(column + 1, min.x, max.x), at(row + 1, min.y, max.y)],
        ]
    }

    /// Number of tiles.
    pub(crate) fn tiles(&self) -> usize {
        self.tiles[0] as usize * self.tiles[1] as usize
    }

    /// Tiles along X and along Y.
    pub(crate) fn tile_counts(&self) -> [u32; 2] {
        self.tiles
    }

    /// The first cell of a tile.
    pub(crate) fn first_cell(&self, tile: usize) -> [u32; 2] {
        let across = self.tiles[0] as usize;
        [(tile % across * TILE) as u32, (tile / across * TILE) as u32]
    }

    /// The corner of a tile, mm.
    pub(crate) fn corner(&self, tile: usize) -> [f64; 2] {
        let [column, row] = self.first_cell(tile);
        [
            self.bounds.min.x + self.resolution * f64::from(column),
            self.bounds.min.y + self.resolution * f64::from(row),
        ]
    }

    /// The box of a tile within that of the stock, mm.
    pub(crate) fn box_of(&self, tile: usize) -> Aabb {
        let [column, row] = self.first_cell(tile);
        let last = |first: u32, cells: u32| (first + TILE as u32).min(cells) - 1;
        let [low, _] = self.corners(column, row);
        let [_, high] = self.corners(last(column, self.cells[0]), last(row, self.cells[1]));
        let (mut min, mut max) = (self.bounds.min, self.bounds.max);
        (min.x, min.y) = (low[0], low[1]);
        (max.x, max.y) = (high[0], high[1]);
        Aabb { min, max }
    }

    /// The tile of a cell, the cell's block, and its index in the block.
    pub(crate) fn tile_of(&self, column: u32, row: u32) -> (usize, [usize; 2]) {
        let (column, row) = (column as usize, row as usize);
        let tile = row / TILE * self.tiles[0] as usize + column / TILE;
        let block = row % TILE / BLOCK * BLOCKS + column % TILE / BLOCK;
        (tile, [block, row % BLOCK * BLOCK + column % BLOCK])
    }

    /// The sides of the cells of a block along X and Y, inside the stock's box, mm; zero outside.
    pub(crate) fn sides(&self, tile: usize, block: usize) -> [[f64; BLOCK]; 2] {
        let [column, row] = self.first_cell(tile);
        let first =
            [column as usize + block % BLOCKS * BLOCK, row as usize + block / BLOCKS * BLOCK];
        let mut sides = [[self.resolution; BLOCK]; 2];
        let size = self.bounds.size();
        for (axis, length) in [size.x, size.y].into_iter().enumerate() {
            let cells = self.cells[axis] as usize;
            if first[axis] + BLOCK < cells {
                continue;
            }
            for (n, side) in sides[axis].iter_mut().enumerate() {
                let cell = first[axis] + n;
                *side = match (cell + 1).cmp(&cells) {
                    core::cmp::Ordering::Less => self.resolution,
                    core::cmp::Ordering::Equal => length - self.resolution * cell as f64,
                    core::cmp::Ordering::Greater => 0.0,
                };
            }
        }
        sides
    }
}
