//! A tile: 64 blocks, each with one height, or with one for each cell.

use chordal_geometry::Aabb;
use wide::f32x4;

use super::gaps::{ColumnGaps, SolidColumn, TileGaps, solid};
use super::grid::{BLOCK, BLOCKS, CELLS, GROUPS, LANES, StockGrid, TILE, count};
use super::heights::{
    BlockHeights, CellCeiling, CellHollows, HeightRange, POINT, bottom, round_down, round_up,
};
use super::volume::{BlockSnapshot, OTHERS, TagVolumes, integral};
use super::{ColumnOptions, Mode, VolumeInterval};
use crate::RemovedSpan;

/// Slot of a block of one height, which is that of its range.
const UNIFORM: u32 = u32::MAX;

#[derive(Clone, Copy, Debug)]
struct TileBlock {
    range: HeightRange,
    slot: u32,
}

/// The columns of a tile. A sampled tile stores one height per cell, which is outer and inner height; a tile with
/// middles stores three.
#[derive(Clone, Debug)]
pub(crate) struct StockTile {
    blocks: Box<[TileBlock]>,
    data: Vec<f32x4>,
    free: Vec<u32>,
    /// Groups of four heights per block: 16, 32 or 48.
    stride: usize,
    /// Upper bound of all outer heights, mm, as of the last job.
    top: f32,
    ledger: TagVolumes,
    /// What undercuts have removed below the tops of columns.
    gaps: TileGaps,
}

/// Most bytes of a tile. With volumes by tag, a copy of every block may be kept.
fn most_bytes(options: &ColumnOptions) -> usize {
    let kept =
        if options.by_tag { size_of::<BlockSnapshot>() + size_of::<BlockHeights>() } else { 0 };
    let block = size_of::<TileBlock>() + stride(options) * size_of::<f32x4>() + kept;
    BLOCKS * BLOCKS * block + size_of::<StockTile>()
}

/// Most bytes that columns of this resolution take.
pub(crate) fn bytes(bounds: Aabb, resolution: f64, options: &ColumnOptions) -> f64 {
    let size = bounds.size();
    let tiles = (count(size.x, resolution) / TILE as f64).ceil()
        * (count(size.y, resolution) / TILE as f64).ceil();
    tiles * most_bytes(options) as f64
}

/// The finest resolution at which a box fits in a budget of bytes, mm, within 0.1 %; infinite where none does.
pub(crate) fn finest(bounds: Aabb, options: &ColumnOptions) -> f64 {
    const FINER: f64 = 1.001;
    let size = bounds.size();
    let widest = size.x.max(size.y);
    if bytes(bounds, widest, options) > options.budget as f64 {
        return f64::INFINITY;
    }
    let mut resolution = widest;
    // Tiles are whole, so memory grows in steps. The search goes from coarse to fine until a size does not fit.
    while resolution > widest * 1e-9
        && bytes(bounds, resolution / FINER, options) <= options.budget as f64
    {
        resolution /= FINER;
    }
    resolution
}

fn stride(options: &ColumnOptions) -> usize {
    match options.mode {
        Mode::Certified if options.middles => WITH_MIDDLES,
        Mode::Certified => 2 * GROUPS,
        Mode::Sampled => GROUPS,
    }
}

/// Groups of a block that also stores the heights in the middles of its cells, after the outer and the inner ones.
const WITH_MIDDLES: usize = 3 * GROUPS;

/// The corners of the tiny cell that represents the middle of another one.
fn middle_of([low, high]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let off = |by: f64| [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]) + by);
    [off(-0.5 * POINT), off(0.5 * POINT)]
}

impl StockTile {
    pub fn new(
        grid: &StockGrid,
        options: &ColumnOptions,
        number: usize,
        heights: &impl Fn([f64; 2], [f64; 2]) -> [f64; 2],
    ) -> StockTile {
        let bottom = bottom(grid);
        let empty =
            TileBlock { range: HeightRange::uniform(bottom, bottom, bottom), slot: UNIFORM };
        let mut tile = StockTile {
            blocks: vec![empty; BLOCKS * BLOCKS].into_boxed_slice(),
            data: Vec::new(),
            free: Vec::new(),
            stride: stride(options),
            top: 0.0,
            ledger: TagVolumes::default(),
            gaps: TileGaps::default(),
        };
        let top = grid.bounds().max.z;
        let [column, row] = grid.first_cell(number);
        let [columns, rows] = grid.cells();
        for block in 0..BLOCKS * BLOCKS {
            let mut cells = BlockHeights { outer: [bottom; CELLS], inner: [bottom; CELLS] };
            let mut middles = [bottom; CELLS];
            for (cell, middle) in middles.iter_mut().enumerate() {
                let x = column + (block % BLOCKS * BLOCK + cell % BLOCK) as u32;
                let y = row + (block / BLOCKS * BLOCK + cell / BLOCK) as u32;
                // Cells beyond the box never count. They get the height of the last one, so that a block at the edge
                // may be uniform, too.
                let [low, high] = grid.corners(x.min(columns - 1), y.min(rows - 1));
                let [outer, inner] = heights(low, high);
                cells.outer[cell] = round_up(outer - top).clamp(bottom, 0.0);
                cells.inner[cell] = (round_down(inner - top)).clamp(bottom, cells.outer[cell]);
                *middle = cells.outer[cell];
                if options.keeps_middles() && inner < outer {
                    let [low, high] = middle_of([low, high]);
                    let [height, _] = heights(low, high);
                    let height = (height - top) as f32;
                    *middle = height.clamp(cells.inner[cell], cells.outer[cell]);
                }
            }
            if options.mode == Mode::Sampled {
                cells.inner = cells.outer;
            }
            tile.put(block, &cells, &middles);
        }
        tile.settle();
        tile
    }

    /// Upper bound of the tile's heights relative to the stock's top, mm.
    pub fn top(&self) -> f32 {
        self.top
    }

    /// Updates the top after heights were lowered.
    pub fn settle(&mut self) {
        let tops = self.blocks.iter().map(|block| block.range.outer[1]);
        self.top = tops.fold(f32::NEG_INFINITY, f32::max);
    }

    /// The range of a block.
    pub fn range(&self, block: usize) -> HeightRange {
        self.blocks[block].range
    }

    /// The heights of a block.
    pub fn get(&self, block: usize) -> BlockHeights {
        let TileBlock { range, slot } = self.blocks[block];
        if slot == UNIFORM {
            return range.even();
        }
        let at = slot as usize * self.stride;
        let data = &self.data[at..at + self.stride];
        let inner = if self.stride > GROUPS { GROUPS } else { 0 };
        BlockHeights {
            outer: cells_of(&data[..GROUPS]),
            inner: cells_of(&data[inner..inner + GROUPS]),
        }
    }

    /// The heights in the middles of the cells of a block; `None` where they are not kept.
    pub fn middles(&self, block: usize) -> Option<[f32; CELLS]> {
        if self.stride != WITH_MIDDLES {
            return None;
        }
        let TileBlock { range, slot } = self.blocks[block];
        if slot == UNIFORM {
            return Some([range.middle[0]; CELLS]);
        }
        let end = (slot as usize + 1) * self.stride;
        Some(cells_of(&self.data[end - GROUPS..end]))
    }

    /// The stored heights of a block: outer, inner and those in the middles, where they are kept; one list in a
    /// sampled tile. A uniform block gets storage for them.
    pub fn open(&mut self, block: usize) -> &mut [f32x4] {
        let TileBlock { range, slot } = self.blocks[block];
        let slot = if slot == UNIFORM {
            let slot = self.free.pop().unwrap_or((self.data.len() / self.stride) as u32);
            let at = slot as usize * self.stride;
            if at == self.data.len() {
                self.data.resize(at + self.stride, f32x4::ZERO);
            }
            let data = &mut self.data[at..at + self.stride];
            data[..GROUPS].fill(f32x4::splat(range.outer[0]));
            let (inner, middle) = data[GROUPS..].split_at_mut(GROUPS.min(self.stride - GROUPS));
            inner.fill(f32x4::splat(range.inner[0]));
            middle.fill(f32x4::splat(range.middle[0]));
            self.blocks[block].slot = slot;
            slot
        } else {
            slot
        };
        let at = slot as usize * self.stride;
        &mut self.data[at..at + self.stride]
    }

    /// Sets the range of a block; a uniform block gives up its storage.
    pub fn close(&mut self, block: usize, range: HeightRange) {
        let entry = &mut self.blocks[block];
        entry.range = range;
        if range.is_uniform() && entry.slot != UNIFORM {
            self.free.push(entry.slot);
            entry.slot = UNIFORM;
        }
    }

    /// Sets the heights of a block; `middles` is ignored where they are not kept.
    fn put(&mut self, block: usize, heights: &BlockHeights, middles: &[f32; CELLS]) {
        let ends = |cells: &[f32; CELLS]| {
            let least = cells.iter().copied().fold(f32::INFINITY, f32::min);
            [least, cells.iter().copied().fold(f32::NEG_INFINITY, f32::max)]
        };
        let middles = if self.stride == WITH_MIDDLES { middles } else { &heights.outer };
        let (outer, inner) = (ends(&heights.outer), ends(&heights.inner));
        let range = HeightRange { outer, inner, middle: ends(middles) };
        if !range.is_uniform() {
            let stride = self.stride;
            let data = self.open(block);
            let groups = |cells: &[f32; CELLS], to: &mut [f32x4]| {
                for (group, from) in to.iter_mut().zip(cells.chunks_exact(LANES)) {
                    group.as_array_mut().copy_from_slice(from);
                }
            };
            groups(&heights.outer, &mut data[..GROUPS]);
            if stride > GROUPS {
                groups(&heights.inner, &mut data[GROUPS..2 * GROUPS]);
            }
            if stride == WITH_MIDDLES {
                groups(middles, &mut data[2 * GROUPS..]);
            }
        }
        self.close(block, range);
    }

    /// The outer and the inner height of a cell of a block.
    pub fn heights(&self, [block, cell]: [usize; 2]) -> [f32; 2] {
        let heights = self.get(block);
        [heights.outer[cell], heights.inner[cell]]
    }

    /// The gaps of its columns.
    pub fn gaps(&self) -> &TileGaps {
        &self.gaps
    }

    /// Removes spans from a column, given as those certain, those possible and those in its middle: see
    /// [`TileGaps::add`].
    pub fn hollow(
        &mut self,
        place: [usize; 2],
        spans: [&[RemovedSpan]; 3],
        bottom: f32,
        limit: usize,
    ) {
        let [block, cell] = place;
        let (mut heights, mut middles) = (self.get(block), self.middles_or_outer(block));
        let before = [heights.outer[cell], heights.inner[cell], middles[cell]];
        let after = self.gaps.add(place, spans, before, bottom, limit);
        if after != before {
            [heights.outer[cell], heights.inner[cell], middles[cell]] = after;
            self.put(block, &heights, &middles);
        }
    }

    fn middles_or_outer(&self, block: usize) -> [f32; CELLS] {
        self.middles(block).unwrap_or_else(|| self.get(block).outer)
    }

    /// Merges gaps of a block that its lowered heights have reached.
    #[inline]
    pub fn settle_gaps(&mut self, block: usize) {
        let range = self.blocks[block].range;
        if self.gaps.may_reach(block, range.inner[0].min(range.middle[0])) {
            self.bring_to_light(block);
        }
    }

    fn bring_to_light(&mut self, block: usize) {
        let cells: Vec<usize> = self.gaps.of_block(block).map(|(cell, _)| cell).collect();
        let (mut heights, mut middles) = (self.get(block), self.middles_or_outer(block));
        for cell in cells {
            let before = [heights.outer[cell], heights.inner[cell], middles[cell]];
            let after = self.gaps.settle([block, cell], before);
            [heights.outer[cell], heights.inner[cell], middles[cell]] = after;
        }
        self.put(block, &heights, &middles);
    }

    /// Adds the hollows that columns have below their tops before the first cut.
    pub fn begin_hollow(
        &mut self,
        grid: &StockGrid,
        number: usize,
        limit: usize,
        hollows: &CellHollows<'_>,
    ) {
        let (top, bottom) = (grid.bounds().max.z, bottom(grid));
        let [column, row] = grid.first_cell(number);
        let [columns, rows] = grid.cells();
        for block in 0..BLOCKS * BLOCKS {
            for cell in 0..CELLS {
                let x = column + (block % BLOCKS * BLOCK + cell % BLOCK) as u32;
                let y = row + (block / BLOCKS * BLOCK + cell / BLOCK) as u32;
                if x >= columns || y >= rows {
                    continue;
                }
                let down = |span: RemovedSpan| RemovedSpan {
                    floor: span.floor - top,
                    top: span.top - top,
                };
                let ask = |corners: [[f64; 2]; 2]| {
                    hollows(corners)
                        .map(|spans| spans.into_iter().map(down).collect::<Vec<RemovedSpan>>())
                };
                let corners = grid.corners(x, y);
                let [surely, maybe] = ask(corners);
                if maybe.is_empty() {
                    continue;
                }
                let middle = if self.stride != WITH_MIDDLES {
                    Vec::new()
                } else if surely == maybe {
                    maybe.clone()
                } else {
                    let [_, middle] = ask(middle_of(corners));
                    middle
                };
                self.hollow([block, cell], [&surely, &maybe, &middle], bottom, limit);
            }
        }
        self.settle();
    }

    /// Lowers cells for a reason other than moves.
    pub fn lower(
        &mut self,
        grid: &StockGrid,
        number: usize,
        by_tag: bool,
        lower: &CellCeiling<'_>,
    ) {
        let (top, bottom) = (grid.bounds().max.z, bottom(grid));
        let [column, row] = grid.first_cell(number);
        let [columns, rows] = grid.cells();
        for block in 0..BLOCKS * BLOCKS {
            let before = self.get(block);
            let mut after = before;
            let mut middles = self.middles_or_outer(block);
            for (cell, middle) in middles.iter_mut().enumerate() {
                let x = column + (block % BLOCKS * BLOCK + cell % BLOCK) as u32;
                let y = row + (block / BLOCKS * BLOCK + cell / BLOCK) as u32;
                // As in `new`, cells beyond the box get the height of the last one.
                let corners = grid.corners(x.min(columns - 1), y.min(rows - 1));
                let known = before.outer[cell];
                let height = round_up(lower(corners, top + f64::from(known)) - top);
                after.outer[cell] = height.clamp(bottom, known);
                after.inner[cell] = before.inner[cell].min(after.outer[cell]);
                *middle = middle.min(after.outer[cell]);
            }
            if after != before {
                if by_tag {
                    self.keep(OTHERS, block, grid, number);
                }
                self.put(block, &after, &middles);
                self.settle_gaps(block);
            }
        }
        self.settle();
    }

    /// The volume that is left of it, mm³.
    pub fn left(&self, grid: &StockGrid, number: usize) -> VolumeInterval {
        let bottom = -grid.bounds().size().z;
        let volume = |block: usize| {
            let sides = grid.sides(number, block);
            let heights = self.get(block);
            let mut outer = heights.outer.map(|height| (f64::from(height) - bottom).max(0.0));
            let mut inner = heights.inner.map(|height| (f64::from(height) - bottom).max(0.0));
            for (cell, ColumnGaps { surely, maybe, .. }) in self.gaps.of_block(block) {
                outer[cell] = solid(heights.outer[cell], bottom, surely);
                inner[cell] = solid(heights.inner[cell], bottom, maybe);
            }
            VolumeInterval {
                least: integral(&sides, |cell| inner[cell]),
                most: integral(&sides, |cell| outer[cell]),
            }
        };
        (0..BLOCKS * BLOCKS).map(volume).fold(VolumeInterval::default(), VolumeInterval::plus)
    }

    /// Keeps the state of a block before the first of consecutive moves with a tag.
    #[inline]
    pub fn keep(&mut self, tag: u32, block: usize, grid: &StockGrid, number: usize) {
        if !self.ledger.is_new(tag, block) {
            return;
        }
        if self.ledger.open().0 != Some(tag) {
            let amount = self.removed_last(grid, number);
            self.ledger.turn(tag, amount);
        }
        let range = self.range(block);
        let heights = (!range.is_uniform()).then(|| Box::new(self.get(block)));
        let gaps = self.gaps.of_block(block).map(|(cell, column)| (cell, column.clone()));
        let gaps = gaps.collect();
        self.ledger.keep(BlockSnapshot { block, range, heights, gaps });
    }

    /// What the moves of the last tag have removed, mm³.
    fn removed_last(&self, grid: &StockGrid, number: usize) -> VolumeInterval {
        let removed = |kept: &BlockSnapshot| {
            let sides = grid.sides(number, kept.block);
            let even = kept.range.even();
            let before = kept.heights.as_deref().unwrap_or(&even);
            let after = self.get(kept.block);
            let drop = |from: f32, to: f32| (f64::from(from) - f64::from(to)).max(0.0);
            let mut least: [f64; CELLS] =
                core::array::from_fn(|cell| drop(before.inner[cell], after.outer[cell]));
            let mut most: [f64; CELLS] =
                core::array::from_fn(|cell| drop(before.outer[cell], after.inner[cell]));
            if !kept.gaps.is_empty() || self.gaps.is_in(kept.block) {
                let bottom = -grid.bounds().size().z;
                for cell in 0..CELLS {
                    let old =
                        kept.gaps.iter().find(|(at, _)| *at == cell).map(|(_, column)| column);
                    let new = self.gaps.of([kept.block, cell]);
                    let [old_outer, old_inner] = both(before, cell, old);
                    let [new_outer, new_inner] = both(&after, cell, new);
                    least[cell] = old_inner.without(&new_outer, bottom);
                    most[cell] = old_outer.without(&new_inner, bottom);
                }
            }
            VolumeInterval {
                least: integral(&sides, |cell| least[cell]),
                most: integral(&sides, |cell| most[cell]),
            }
        };
        self.ledger
            .open()
            .1
            .iter()
            .map(removed)
            .fold(VolumeInterval::default(), VolumeInterval::plus)
    }

    /// Adds what the moves of each tag have removed, mm³.
    pub fn removed(&self, grid: &StockGrid, number: usize, to: &mut Vec<(u32, VolumeInterval)>) {
        self.ledger.add_to(self.removed_last(grid, number), to);
    }

    pub fn bytes(&self) -> u64 {
        (size_of::<StockTile>()
            + self.blocks.len() * size_of::<TileBlock>()
            + self.data.capacity() * size_of::<f32x4>()
            + self.ledger.bytes()
            + self.gaps.bytes()) as u64
    }
}

/// The heights of cells from their groups.
fn cells_of(groups: &[f32x4]) -> [f32; CELLS] {
    let mut heights = [0.0; CELLS];
    for (to, group) in heights.chunks_exact_mut(LANES).zip(groups) {
        to.copy_from_slice(group.as_array_ref());
    }
    heights
}

/// A column of a block with its gaps, up to its outer and up to its inner height.
fn both<'a>(
    heights: &BlockHeights,
    cell: usize,
    column: Option<&'a ColumnGaps>,
) -> [SolidColumn<'a>; 2] {
    let [surely, maybe] =
        column.map_or([&[][..]; 2], |column| [&column.surely[..], &column.maybe[..]]);
    [
        SolidColumn { height: heights.outer[cell], gaps: surely },
        SolidColumn { height: heights.inner[cell], gaps: maybe },
    ]
}
