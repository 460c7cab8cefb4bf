//! Where cuts from one side have removed material, for the other sides and for the part as a whole.

use std::collections::BTreeMap;

use chordal_geometry::{Aabb, Transform};
use chordal_stock::{ColumnStock, RemovedSpan};

use super::earlier_side::InitialStock;
use super::solid_intervals::{ColumnKnowledge, intervals_of};

/// Columns along the side of a block. One height is kept for each block.
const BLOCK: u32 = 16;
/// Heights that differ by less than this are equal, mm.
const EQUAL_HEIGHT_MM: f64 = 1e-6;

/// The columns of another orientation of the part.
#[derive(Debug)]
pub(super) struct OtherSide {
    pub stock: ColumnStock,
    pub removed: SideRemoval,
    /// Transforms the part from its given orientation to this one.
    pub there: Transform,
}

/// How deep the columns of one side are cut.
#[derive(Debug)]
pub(super) struct SideRemoval {
    low: [f64; 2],
    side: f64,
    blocks: [usize; 2],
    /// For each block of columns, the height below which nothing is removed; infinite where nothing is removed at
    /// all, mm.
    floors: Vec<f64>,
    /// For each column, whether it is cut from above.
    is_cut: Vec<bool>,
    /// What undercuts have certainly removed, by column number.
    gaps: BTreeMap<usize, Vec<RemovedSpan>>,
}

impl SideRemoval {
    pub fn of(stock: &ColumnStock, begun: &InitialStock<'_>) -> SideRemoval {
        let grid = stock.grid();
        let [columns, rows] = grid.cells();
        let blocks = [columns, rows].map(|count| count.div_ceil(BLOCK) as usize);
        let mut floors = vec![f64::INFINITY; blocks[0] * blocks[1]];
        let mut is_cut = vec![false; columns as usize * rows as usize];
        let mut gaps = BTreeMap::new();
        let pairs = stock.height_pairs();
        // Columns are kept in single precision, relative to the top.
        let rounding = EQUAL_HEIGHT_MM + grid.bounds().size().z * f64::from(f32::EPSILON);
        for row in 0..rows {
            for column in 0..columns {
                let index = row as usize * columns as usize + column as usize;
                let corners @ [low, high] = grid.corners(column, row);
                let own =
                    cut_gaps(stock, [column, row], &begun.shape.hollows(corners)[0], rounding);
                if !own.is_empty() {
                    gaps.insert(index, own);
                }
                is_cut[index] = pairs[index].inner < begun.of(low, high)[1] - rounding;
                let left =
                    intervals_of(stock, [column, row], ColumnKnowledge::Surely, pairs[index].inner);
                let [_, filled] = begun.shape.filled(corners);
                let lowest = lowest_removed(&filled, &left, rounding);
                if lowest.is_finite() {
                    let block = (row / BLOCK) as usize * blocks[0] + (column / BLOCK) as usize;
                    floors[block] = floors[block].min(lowest);
                }
            }
        }
        let min = grid.bounds().min;
        let side = f64::from(BLOCK) * grid.resolution();
        SideRemoval { low: [min.x, min.y], side, blocks, floors, is_cut, gaps }
    }

    /// Whether everything that is removed is above a box.
    pub fn is_above(&self, body: &Aabb) -> bool {
        let range = |axis: usize, from: f64, to: f64| {
            let at = |place: f64| ((place - self.low[axis]) / self.side).floor();
            let last = self.blocks[axis] as f64 - 1.0;
            (at(from - EQUAL_HEIGHT_MM).clamp(0.0, last) as usize)
                ..=(at(to + EQUAL_HEIGHT_MM).clamp(0.0, last) as usize)
        };
        range(1, body.min.y, body.max.y).all(|row| {
            range(0, body.min.x, body.max.x).all(|column| {
                body.max.z <= self.floors[row * self.blocks[0] + column] - EQUAL_HEIGHT_MM
            })
        })
    }

    /// Whether anything is removed.
    pub fn is_any(&self) -> bool {
        self.floors.iter().any(|floor| floor.is_finite())
    }

    /// Whether a height is in what undercuts have certainly removed from the column with this number.
    pub fn is_in_gap(&self, column: usize, height: f64) -> bool {
        let gaps = self.gaps.get(&column);
        gaps.is_some_and(|gaps| gaps.iter().any(|gap| gap.floor < height && height < gap.top))
    }

    /// Whether the column with this number is cut from above.
    pub fn is_cut(&self, column: usize) -> bool {
        self.is_cut[column]
    }
}

/// The certain gaps of a column that were not there before the first cut.
fn cut_gaps(
    stock: &ColumnStock,
    [column, row]: [u32; 2],
    hollows: &[RemovedSpan],
    rounding: f64,
) -> Vec<RemovedSpan> {
    let [mut surely, _] = stock.gaps_at(column, row);
    surely.retain(|gap| {
        let holds = |hollow: &RemovedSpan| {
            hollow.floor <= gap.floor + rounding && gap.top <= hollow.top + rounding
        };
        !hollows.iter().any(holds)
    });
    surely
}

/// The lowest height that was filled and is not left; infinite where there is none, mm. Less than
/// `rounding` does not count, mm.
fn lowest_removed(filled: &[[f64; 2]], left: &[[f64; 2]], rounding: f64) -> f64 {
    for &[from, to] in filled {
        // Nothing of the interval is removed below this height.
        let mut at = from;
        for &[floor, top] in left {
            if floor <= at + rounding {
                at = at.max(top);
            }
        }
        if at < to - rounding {
            return at;
        }
    }
    f64::INFINITY
}

#[cfg(test)]
mod tests {
    use super::{EQUAL_HEIGHT_MM as ROUNDING_MM, lowest_removed};

    #[test]
    fn what_is_removed_begins_where_nothing_is_left() {
        assert_eq!(lowest_removed(&[[0.0, 10.0]], &[[0.0, 6.0]], ROUNDING_MM), 6.0);
        assert_eq!(lowest_removed(&[[3.0, 10.0]], &[[3.0, 10.0]], ROUNDING_MM), f64::INFINITY);
        assert_eq!(
            lowest_removed(&[[0.0, 2.0], [5.0, 10.0]], &[[0.0, 2.0], [6.0, 10.0]], ROUNDING_MM),
            5.0
        );
        assert_eq!(lowest_removed(&[[0.0, 10.0]], &[[0.0, 4.0], [5.0, 10.0]], ROUNDING_MM), 4.0);
        assert_eq!(lowest_removed(&[], &[], ROUNDING_MM), f64::INFINITY);
    }
}
