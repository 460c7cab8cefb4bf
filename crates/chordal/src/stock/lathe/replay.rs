//! What is left after every pass, for a picture that goes forward and backward.

use std::collections::BTreeMap;

use chordal_stock::lathe::{OutlineSegment, Region};

/// A line or an arc that bounds what is left for a while.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurnedPiece {
    /// The material lies to its left, seen with z to the right and r up. Its tag is the tool that made it; 0 is
    /// the stock.
    pub segment: OutlineSegment,
    /// The first section that has it: 0 is the stock before the first cut.
    pub from: u32,
    /// The first section that has it no more; `u32::MAX` where it stays.
    pub until: u32,
    /// It belongs to a part that was cut off.
    pub is_loose: bool,
}

/// A tool as it is drawn, about its programmed point: convex loops.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TurnedShape {
    /// What cuts.
    pub edges: Vec<Vec<OutlineSegment>>,
    /// Shank and holder, where they are given.
    pub body: Vec<Vec<OutlineSegment>>,
}

/// The sections of a run, and what is drawn with them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TurnedReplay {
    /// The lines and arcs of all sections.
    pub pieces: Vec<TurnedPiece>,
    /// Of each section after the first the piece of path that made it, by its number among all of the run.
    pub rows: Vec<u32>,
    /// Whether there is a section for every pass; if not, there is one for every tool at least.
    pub is_whole: bool,
    /// The fixtures as they are, by name.
    pub fixtures: Vec<(String, Region)>,
    /// The tools that have a shape, by number.
    pub tools: BTreeMap<u32, TurnedShape>,
}
