//! What is left of columns as stretches of material.

use chordal_stock::{Span, Stock};

/// Of a column what may be left (0), or what is surely left (1), as stretches below its height, mm.
pub(super) fn stretches_of(stock: &Stock, at: [u32; 2], side: usize, height: f64) -> Vec<[f64; 2]> {
    let bottom = stock.grid().bounds().min.z;
    let mut left = if bottom < height { vec![[bottom, height]] } else { Vec::new() };
    for Span { floor, top } in &stock.gaps_at(at[0], at[1])[side] {
        left = without(&left, [*floor, *top]);
    }
    left
}

/// Stretches less another one.
pub(super) fn without(stretches: &[[f64; 2]], [floor, top]: [f64; 2]) -> Vec<[f64; 2]> {
    let parts =
        stretches.iter().flat_map(|[from, to]| [[*from, to.min(floor)], [from.max(top), *to]]);
    parts.filter(|[from, to]| from < to).collect()
}
