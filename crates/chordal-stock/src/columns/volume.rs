//! Volumes, as sums in a fixed order.

use super::gaps::ColumnGaps;
use super::grid::BLOCK;
use super::heights::{BlockHeights, HeightRange};

/// A volume that is known to lie between two, mm³.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VolumeInterval {
    /// At least, mm³.
    pub least: f64,
    /// At most, mm³.
    pub most: f64,
}

impl VolumeInterval {
    pub(crate) fn plus(self, other: VolumeInterval) -> VolumeInterval {
        VolumeInterval { least: self.least + other.least, most: self.most + other.most }
    }
}

/// The tag of what no move has removed: see [`ColumnStock::lower`](super::ColumnStock::lower).
pub const OTHERS: u32 = u32::MAX;

/// The heights of a cell, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellHeights {
    /// Nothing of the stock on the cell is higher.
    pub outer: f64,
    /// Below it, down to the bottom, all of the cell is stock, but for gaps: see [`ColumnStock::gaps_at`](super::ColumnStock::gaps_at).
    pub inner: f64,
}

/// The sum of a value over the cells of a block, by their areas.
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

/// What the moves of each tag have removed of a tile: the blocks that the moves of one tag meet are kept as
/// they were, until those of another come.
#[derive(Clone, Debug, Default)]
pub(crate) struct TagVolumes {
    tag: Option<u32>,
    /// Which blocks are kept.
    met: u64,
    before: Vec<BlockSnapshot>,
    done: Vec<(u32, VolumeInterval)>,
}

/// A block as it was.
#[derive(Clone, Debug)]
pub(crate) struct BlockSnapshot {
    pub block: usize,
    pub range: HeightRange,
    /// None for one that was even.
    pub heights: Option<Box<BlockHeights>>,
    /// Its columns with gaps.
    pub gaps: Vec<(usize, ColumnGaps)>,
}

impl TagVolumes {
    /// Whether a block has not been met by the moves of this tag, which follow all those before.
    pub fn is_new(&self, tag: u32, block: usize) -> bool {
        self.tag != Some(tag) || self.met & (1 << block) == 0
    }

    /// Keeps a block as it is before moves of a tag.
    pub fn keep(&mut self, kept: BlockSnapshot) {
        self.met |= 1 << kept.block;
        self.before.push(kept);
    }

    /// Moves of another tag follow: what those before have removed is final.
    pub fn turn(&mut self, tag: u32, amount: VolumeInterval) {
        if let Some(last) = self.tag {
            add(&mut self.done, last, amount);
        }
        self.tag = Some(tag);
        self.met = 0;
        self.before.clear();
    }

    /// The tag of the moves that came last, and the blocks that they met, as they were before.
    pub fn open(&self) -> (Option<u32>, &[BlockSnapshot]) {
        (self.tag, &self.before)
    }

    /// What the moves of each tag have removed; `open` by those that came last.
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
