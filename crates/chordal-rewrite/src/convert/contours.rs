//! The blocks that cycles of a lathe take as their contour.

use std::ops::Range;

use chordal::Job;
use chordal::control::{Action, TurnCycle, TurnFamily};
use chordal::syntax::BlockKind;

use super::trace::BlockFacts;
use crate::source::{SourceBlocks, code_action, whole};
use crate::word_address::BlockControl;

/// Blocks that cycles take as their contour.
#[derive(Clone, Debug)]
pub(crate) struct CycleContour {
    pub blocks: Range<usize>,
    /// The cycles: their blocks, and whether the program continues after the contour.
    pub cycles: Vec<(usize, bool)>,
}

/// All of a program.
#[derive(Clone, Debug, Default)]
pub(crate) struct CycleContours {
    pub list: Vec<CycleContour>,
}

/// The cycle of a lathe that a block calls.
pub(crate) fn cycle_of(source: &SourceBlocks, at: usize, job: &Job) -> Option<TurnCycle> {
    let mut codes =
        source.blocks[at].words.iter().filter_map(|word| code_action(word, job.control()));
    codes.find_map(Action::turning_cycle)
}

impl CycleContours {
    pub fn of(source: &SourceBlocks, job: &Job) -> CycleContours {
        let mut contours = CycleContours::default();
        if !job.profile().turns {
            return contours;
        }
        for at in 0..source.blocks.len() {
            let Some(cycle) = cycle_of(source, at, job) else { continue };
            let (blocks, skips) = match cycle.family() {
                TurnFamily::Finish => (labelled(source, at), false),
                TurnFamily::Rough | TurnFamily::Pattern => (labelled(source, at), true),
                TurnFamily::Subroutine => (subroutine(source, at), true),
                TurnFamily::Peck | TurnFamily::Thread | TurnFamily::LineThread => continue,
            };
            let Some(blocks) = blocks else { continue };
            match contours.list.iter_mut().find(|contour| contour.blocks == blocks) {
                Some(contour) => contour.cycles.push((at, skips)),
                None => contours.list.push(CycleContour { blocks, cycles: vec![(at, skips)] }),
            }
        }
        contours
    }
}

impl CycleContour {
    /// Nothing runs it but cycles; what names a subroutine is only read.
    pub fn is_cycle_only(&self, source: &SourceBlocks, facts: &[BlockFacts]) -> bool {
        let is_text = |at: usize| matches!(source.blocks[at].kind, BlockKind::Macro(_));
        self.blocks.clone().all(|at| facts[at].runs == 0 || is_text(at))
    }

    /// The first block only names a subroutine.
    pub fn is_subroutine(&self, source: &SourceBlocks) -> bool {
        matches!(source.blocks[self.blocks.start].kind, BlockKind::Macro(_))
    }
}

/// From N P to N Q, searched from the cycle on.
fn labelled(source: &SourceBlocks, at: usize) -> Option<Range<usize>> {
    let block = &source.blocks[at];
    let (p, q) = (whole(block.last(b'P'))?, whole(block.last(b'Q'))?);
    let is = |label: u32| move |at: &usize| whole(source.blocks[*at].word(b'N')) == Some(label);
    let all = 0..source.blocks.len();
    let first = (at + 1..all.end).find(is(p)).or_else(|| all.clone().find(is(p)))?;
    let last = (first..all.end).find(is(q))?;
    Some(first..last + 1)
}

/// From `o100 sub` to `o100 endsub`.
fn subroutine(source: &SourceBlocks, at: usize) -> Option<Range<usize>> {
    let label = whole(source.blocks[at].last(b'Q'))?.to_string();
    let says = |at: usize, word: &str| {
        let block = &source.blocks[at];
        let text = source.words(at).to_ascii_lowercase();
        let text: String = text.split_whitespace().collect();
        matches!(block.kind, BlockKind::Macro(_)) && text == format!("o{label}{word}")
    };
    let first = (0..at).rev().find(|at| says(*at, "sub"))?;
    let last = (first..at).find(|at| says(*at, "endsub"))?;
    Some(first..last + 1)
}
