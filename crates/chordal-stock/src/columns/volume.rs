//! Volumes, summed in a fixed order so that results are the same everywhere.

use super::gaps::ColumnGaps;
use super::grid::BLOCK;
use super::heights::{BlockHeights, HeightRange};

/// A volume between two bounds, mm³.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VolumeInterval {
    /// Lower bound, mm³.
    pub least: f64,
    /// Upper bound, mm³.
    pub most: f64,
}

impl VolumeInterval {
    pub(crate) fn plus(self, other: VolumeInterval) -> VolumeInterval {
        VolumeInterval { least: self.least + other.least, most: self.most + other.most }
    }
}

/// The tag of volume that was not removed by moves: see [`ColumnStock::lower`](super::ColumnStock::lower).
pub const OTHERS: u32 = u32::MAX;

/// The heights of a cell, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellHeights {
    /// Upper bound of the height of the stock anywhere on the cell.
    pub outer: f64,
    /// Everything on the cell below this, down to the bottom, is stock, except for gaps: see
    /// [`ColumnStock::gaps_at`](super::ColumnStock::gaps_at).
    pub inner: f64,
}

/// The sum of a value over the cells of a block, weighted by their areas.
pub(crate) fn integral(sides: &[[f64; BLOCK]; 2], value: impl Fn(usize) -> f64) -> f64 {
    let [widths, heights] = sides;
    let mut sum = 0.0;
    for (row, height) in heights.iter().enumerate() {
        let mut of_row = 0.0;
        for (column, width) in widths.iter().enumerate() {
            of_row += width * value(row * BLOCK + column);
        }
        sum += height * of_row;
    }
    sum
}

/// What the moves of each tag have removed from a tile: the blocks that the moves of one tag meet are kept as they
/// were before, until moves of another tag come.
#[derive(Clone, Debug, Default)]
pub(crate) struct TagVolumes {
    tag: Option<u32>,
    /// The blocks that are kept, as a bit set.
    met: u64,
    before: Vec<BlockSnapshot>,
    done: Vec<(u32, VolumeInterval)>,
}

/// The state of a block before a change.
#[derive(Clone, Debug)]
pub(crate) struct BlockSnapshot {
    pub block: usize,
    pub range: HeightRange,
    /// `None` for a block of one height.
    pub heights: Option<Box<BlockHeights>>,
    /// Its columns with gaps, by cell.
    pub gaps: Vec<(usize, ColumnGaps)>,
}

impl TagVolumes {
    /// Whether the current moves of this tag have not met a block yet.
    pub fn is_new(&self, tag: u32, block: usize) -> bool {
        self.tag != Some(tag) || self.met & (1 << block) == 0
    }

    /// Keeps the state of a block before the moves of a tag.
    pub fn keep(&mut self, kept: BlockSnapshot) {
        self.met |= 1 << kept.block;
        self.before.push(kept);
    }

    /// Begins the moves of another tag: `amount` is what those of the last tag have removed.
    pub fn turn(&mut self, tag: u32, amount: VolumeInterval) {
        if let Some(last) = self.tag {
            add(&mut self.done, last, amount);
        }
        self.tag = Some(tag);
        self.met = 0;
        self.before.clear();
    }

    /// The tag of the last moves, and the blocks that they met, in their state before.
    pub fn open(&self) -> (Option<u32>, &[BlockSnapshot]) {
        (self.tag, &self.before)
    }

    /// Adds what the moves of each tag have removed; `open` is that of the last tag.
    pub fn add_to(&self, open: VolumeInterval, to: &mut Vec<(u32, VolumeInterval)>) {
        for &(tag, amount) in &self.done {
            add(to, tag, amount);
        }
        if let Some(tag) = self.tag {
            add(to, tag, open);
        }
    }

    pub fn bytes(&self) -> usize {
        let heights = self.before.iter().filter(|kept| kept.heights.is_some()).count();
        self.before.capacity() * size_of::<BlockSnapshot>() + heights * size_of::<BlockHeights>()
    }
}

fn add(to: &mut Vec<(u32, VolumeInterval)>, tag: u32, amount: VolumeInterval) {
    match to.binary_search_by_key(&tag, |entry| entry.0) {
        Ok(at) => to[at].1 = to[at].1.plus(amount),
        Err(at) => to.insert(at, (tag, amount)),
    }
}
