//! The vertices at a corner of four cells with gaps.

use super::super::cover::NONE;
use super::super::node::{FaceKind, LevelMeeting};

/// The intervals of a cell, and the rectangles of their ends.
#[derive(Clone, Copy, Default)]
pub(super) struct LayerCell<'a> {
    pub intervals: &'a [[f64; 2]],
    pub rectangles: &'a [[u32; 2]],
}

impl LayerCell<'_> {
    fn is_solid_above(&self, height: f64) -> bool {
        self.intervals.iter().any(|[from, to]| *from <= height && height < *to)
    }

    fn is_solid_below(&self, height: f64) -> bool {
        self.intervals.iter().any(|[from, to]| *from < height && height <= *to)
    }

    /// The kind of the end at a height, and the number of its rectangle.
    fn rectangle(&self, height: f64) -> (usize, u32) {
        let ends = self.intervals.iter().zip(self.rectangles);
        let mut ends =
            ends.flat_map(|(heights, of)| [0, 1].map(|end| (heights[end], end, of[end])));
        ends.find(|(at, ..)| *at == height).map_or((0, NONE), |(_, end, number)| (end, number))
    }
}

/// A level of a corner, with its vertices.
pub(super) struct LayerLevel {
    pub height: f64,
    /// The number of its first vertex.
    pub first: u32,
    pub meeting: LevelMeeting,
}

/// The levels of a corner that have vertices, from the lowest.
pub(super) struct LayerCorner {
    pub levels: Vec<LayerLevel>,
}

/// Whether only straight edges of the same rectangles pass through a corner, so that it has no vertex.
pub(super) fn is_passed(cells: &[LayerCell<'_>; 4]) -> bool {
    let same = |a: usize, b: usize| cells[a].rectangles == cells[b].rectangles;
    (same(0, 1) && same(2, 3)) || (same(1, 2) && same(3, 0))
}

impl LayerCorner {
    /// The corner of four cells, with vertices numbered from `first` on.
    pub fn new(cells: &[LayerCell<'_>; 4], first: u32) -> LayerCorner {
        let heights = heights(cells);
        let mut corner = LayerCorner { levels: Vec::with_capacity(heights.len()) };
        let mut first = first;
        for height in heights {
            let of = cells.map(|cell| cell.rectangle(height));
            if of[0].1 != NONE && of.iter().all(|one| *one == of[0]) {
                // In the middle of a rectangle.
                continue;
            }
            let above = cells.map(|cell| cell.is_solid_above(height));
            let below = cells.map(|cell| cell.is_solid_below(height));
            let meeting = LevelMeeting::of(above, below);
            corner.levels.push(LayerLevel { height, first, meeting });
            first += meeting.count as u32;
        }
        corner
    }

    /// The vertex of a face at a height; `None` where there is none.
    pub fn vertex(&self, height: f64, face: FaceKind) -> Option<u32> {
        let level = self.levels.iter().find(|level| level.height == height)?;
        Some(level.first + level.meeting.vertex(face))
    }

    /// The vertices of a wall between two heights, with their heights.
    pub fn line(&self, wall: usize, [low, high]: [f64; 2], into: &mut Vec<(f64, u32)>) {
        into.clear();
        for LayerLevel { height, first, meeting } in &self.levels {
            if low <= *height && *height <= high {
                let face = if *height < high { FaceKind::Up(wall) } else { FaceKind::Down(wall) };
                into.push((*height, first + meeting.vertex(face)));
            }
        }
    }
}

/// The ends of all intervals, and a height between the ends of each edge in which two cells touch diagonally: there
/// the two bodies have separate vertices, even if they share those at the ends.
fn heights(cells: &[LayerCell<'_>; 4]) -> Vec<f64> {
    let mut heights: Vec<f64> =
        cells.iter().flat_map(|cell| cell.intervals.iter().flatten().copied()).collect();
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    let between: Vec<f64> = heights
        .windows(2)
        .filter(|pair| {
            let [a, b, c, d] = cells.map(|cell| cell.is_solid_above(pair[0]));
            a == c && b == d && a != b
        })
        .map(|pair| 0.5 * (pair[0] + pair[1]))
        .collect();
    heights.extend(between);
    heights.sort_by(f64::total_cmp);
    heights
}
