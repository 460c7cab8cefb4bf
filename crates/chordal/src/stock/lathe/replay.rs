//! The section after every pass, for an animation that goes forward and backward.

use std::collections::BTreeMap;

use chordal_stock::lathe::{OutlineSegment, Region};

/// A line or an arc of the outline, with the sections that have it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurnedPiece {
    /// The material lies to its left, seen with z to the right and r up. Its tag is the tool that made it; 0 is
    /// the stock.
    pub segment: OutlineSegment,
    /// The first section that has it: 0 is the stock before the first cut.
    pub from: u32,
    /// The first section that does not have it any more; `u32::MAX` where it stays.
    pub until: u32,
    /// True where it belongs to a part that was cut off.
    pub is_loose: bool,
}

/// The drawing of a tool relative to its programmed point: convex loops.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TurnedShape {
    /// The cutting edges.
    pub edges: Vec<Vec<OutlineSegment>>,
    /// Shank and holder; empty where they are not given.
    pub body: Vec<Vec<OutlineSegment>>,
}

/// The sections of a run, with the fixtures and tools to draw.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TurnedReplay {
    /// The lines and arcs of all sections.
    pub pieces: Vec<TurnedPiece>,
    /// For each section after the first, the index of the path segment that made it, among all of the run.
    pub rows: Vec<u32>,
    /// True where there is a section for every pass; otherwise there is at least one for every tool.
    pub is_whole: bool,
    /// The fixtures by name, without their clearances.
    pub fixtures: Vec<(String, Region)>,
    /// The tools that have a shape, by number.
    pub tools: BTreeMap<u32, TurnedShape>,
}
