//! Cycles of lathes that stay although the new control cuts them in other passes: where they are, and what differs, measured
//! on both runs.

use chordal::control::{Action, OnceCode, TurnCycle, TurnFamily};
use chordal_compare::{FreePasses, LastPass};

use super::codes;
use super::context::ConvertContext;
use super::layout::TextLayout;
use super::plan::ConvertPlan;
use crate::Certificate;
use crate::source::code_action;

/// A block whose passes are others.
#[derive(Clone, Debug, PartialEq)]
pub struct PassChange {
    /// Its line in the old and in the new text, from 1.
    pub lines: [u32; 2],
    /// The cycle, by its code on the old control.
    pub cycle: String,
    /// What the old control does, and what the new one does.
    pub readings: [PassReading; 2],
}

/// The passes of a cycle, as they were run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PassReading {
    /// How many cuts.
    pub cuts: usize,
    /// Their length, mm.
    pub length_mm: f64,
    /// The largest distance of two levels, mm on the radius.
    pub largest_step_mm: Option<f64>,
}

/// The cycle that a block cuts in passes of its control.
fn cycle_of(context: &ConvertContext, at: usize) -> Option<(TurnCycle, LastPass)> {
    context.source.blocks[at].words.iter().find_map(|word| {
        let cycle = code_action(word, context.from)?.turning_cycle()?;
        let last = match cycle.family() {
            TurnFamily::Rough | TurnFamily::Pattern => LastPass::Contour,
            TurnFamily::Thread => LastPass::Cut,
            TurnFamily::Peck => LastPass::Plunges,
            TurnFamily::Finish | TurnFamily::Subroutine | TurnFamily::LineThread => return None,
        };
        Some((cycle, last))
    })
}

/// The lines of both texts whose cycles may be cut in other passes: those that are kept.
pub(crate) fn lines(
    context: &ConvertContext,
    plan: &ConvertPlan,
    layout: &TextLayout,
) -> [FreePasses; 2] {
    let mut lines = [FreePasses::new(), FreePasses::new()];
    for (at, block) in context.source.blocks.iter().enumerate() {
        if let Some((_, last)) = cycle_of(context, at).filter(|_| plan.is_kept(at)) {
            lines[0].insert(block.line, last);
        }
    }
    for (line, at) in (1..).zip(&layout.from) {
        let own = at.filter(|at| plan.is_kept(*at)).and_then(|at| cycle_of(context, at));
        if let Some((_, last)) = own {
            lines[1].insert(line, last);
        }
    }
    lines
}

/// What the comparison has found, block by block.
pub(crate) fn changes(context: &ConvertContext, certificate: &Certificate) -> Vec<PassChange> {
    let mut changes: Vec<PassChange> = Vec::new();
    for pair in &certificate.comparison.passes {
        let lines = pair.each_ref().map(|passes| passes.place.line);
        let mut blocks = context.source.blocks_on(lines[0], lines[0]);
        let Some((cycle, _)) = blocks.find_map(|at| cycle_of(context, at)) else { continue };
        let action = Action::Once(OnceCode::Turning(cycle));
        let cycle = codes::name(action, context.from, context.style()).unwrap_or_default();
        let readings = pair.each_ref().map(|passes| PassReading {
            cuts: passes.count,
            length_mm: passes.length_mm,
            largest_step_mm: passes.largest_step_mm,
        });
        let change = PassChange { lines, cycle, readings };
        if changes.last() != Some(&change) {
            changes.push(change);
        }
    }
    changes
}
