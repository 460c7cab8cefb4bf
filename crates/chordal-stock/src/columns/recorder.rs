//! Records which columns a job lowers, and when.

use super::grid::{BLOCK, BLOCKS, CELLS, TILE};
use super::heights::BlockHeights;
use crate::sweep::SweepPiece;

/// A column that a move has lowered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoweredColumn {
    /// The index of the column: that at (x, y) is `y · columns + x`.
    pub cell: u32,
    /// The index of the move in the list.
    pub number: u32,
    /// The share of the move that is done when the axis of the tool passes the column: from 0 to 1.
    pub share: f32,
    /// Its new outer height relative to the top of the stock, mm.
    pub height: f32,
}

/// For each piece of a plan, the shares of its move at its start and end.
pub(crate) fn shares(pieces: &[SweepPiece]) -> Vec<[f32; 2]> {
    let of_move = |move_: &[SweepPiece]| {
        let count = move_.len() as f32;
        (0..move_.len())
            .map(move |n| [n as f32 / count, (n + 1) as f32 / count])
            .collect::<Vec<_>>()
    };
    pieces.chunk_by(|a, b| a.number == b.number).flat_map(of_move).collect()
}

/// Records the changes on a tile.
#[derive(Debug)]
pub(crate) struct TileRecorder<'a> {
    shares: &'a [[f32; 2]],
    /// The first column of the tile, along X and Y; `columns` is the length of a row of the stock.
    first: [u32; 2],
    columns: u32,
    /// The middle of the tile's first column, mm.
    middle: [f64; 2],
    cell: f64,
    now: Option<(SweepPiece, [f32; 2])>,
    pub lowered: Vec<LoweredColumn>,
}

impl<'a> TileRecorder<'a> {
    /// A recorder for a tile with this first column, corner (mm) and side of a column (mm).
    pub fn new(
        shares: &'a [[f32; 2]],
        first: [u32; 2],
        columns: u32,
        corner: [f64; 2],
        cell: f64,
    ) -> TileRecorder<'a> {
        let middle = corner.map(|at| at + cell / 2.0);
        TileRecorder { shares, first, columns, middle, cell, now: None, lowered: Vec::new() }
    }

    /// Assigns the following changes to a piece, with its number in the plan.
    pub fn begin(&mut self, piece: &SweepPiece, number: u32) {
        self.now = Some((*piece, self.shares[number as usize]));
    }

    /// Records the difference between the heights of a block before and after. `within`: number of columns of the
    /// tile inside the stock, along X and Y.
    pub fn changed(
        &mut self,
        block: usize,
        before: &BlockHeights,
        after: &BlockHeights,
        within: [usize; 2],
    ) {
        let Some((piece, [from, to])) = &self.now else { return };
        for cell in 0..CELLS {
            if after.outer[cell] == before.outer[cell] {
                continue;
            }
            let column = block % BLOCKS * BLOCK + cell % BLOCK;
            let row = block / BLOCKS * BLOCK + cell / BLOCK;
            debug_assert!(column < TILE && row < TILE);
            if column >= within[0] || row >= within[1] {
                continue;
            }
            let x = self.middle[0] + self.cell * column as f64 - piece.start.x;
            let y = self.middle[1] + self.cell * row as f64 - piece.start.y;
            let along = x * piece.along[0] + y * piece.along[1];
            // A vertical piece counts at its end.
            let done =
                if piece.length > 0.0 { (along / piece.length).clamp(0.0, 1.0) } else { 1.0 };
            let (x, y) = (self.first[0] + column as u32, self.first[1] + row as u32);
            self.lowered.push(LoweredColumn {
                cell: y * self.columns + x,
                number: piece.number,
                share: from + (to - from) * done as f32,
                height: after.outer[cell],
            });
        }
    }
}
