//! What is left of columns, as intervals of material.

use chordal_stock::{ColumnStock, RemovedSpan};

/// Which material of a column is meant.
#[derive(Clone, Copy)]
pub(super) enum ColumnKnowledge {
    /// What may be left anywhere in it.
    Maybe,
    /// What is certainly left everywhere in it.
    Surely,
    /// What is left in its middle.
    InTheMiddle,
}

/// What is left of a column below a height, as intervals, mm.
pub(super) fn intervals_of(
    stock: &ColumnStock,
    [column, row]: [u32; 2],
    known: ColumnKnowledge,
    height: f64,
) -> Vec<[f64; 2]> {
    let bottom = stock.grid().bounds().min.z;
    let mut left = if bottom < height { vec![[bottom, height]] } else { Vec::new() };
    let [surely, maybe] = stock.gaps_at(column, row);
    let gaps = match known {
        ColumnKnowledge::Maybe => surely,
        ColumnKnowledge::Surely => maybe,
        ColumnKnowledge::InTheMiddle => stock.gaps_in_middle(column, row),
    };
    for RemovedSpan { floor, top } in &gaps {
        left = without(&left, [*floor, *top]);
    }
    left
}

/// Intervals without another one.
pub(super) fn without(intervals: &[[f64; 2]], [floor, top]: [f64; 2]) -> Vec<[f64; 2]> {
    let parts =
        intervals.iter().flat_map(|[from, to]| [[*from, to.min(floor)], [from.max(top), *to]]);
    parts.filter(|[from, to]| from < to).collect()
}
