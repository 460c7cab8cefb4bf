//! `,R` and `,C` at the end of a block: kept where the new control makes the same of them, else the
//! shortened moves and what stands between them are written out.

use chordal::Command;
use chordal::control::{Action, Control, CornerMoves, MotionCode, Position};
use chordal::geometry::tolerance::COINCIDENT_MM;
use chordal::syntax::{Block, Word};

use super::context::ConvertContext;
use super::draft::NeedsExpansion;
use super::trace::{BlockExecution, ProgramTrace};
use crate::source::SourceBlocks;

/// True for the words of a rounding or a chamfer, where the control has them.
pub(super) fn is_corner_word(word: &Word, control: &Control) -> bool {
    word.comma
        && matches!(word.letter, b'R' | b'C')
        && control.parameters.rules.corner.moves != CornerMoves::None
}

fn asks(block: &Block, control: &Control) -> bool {
    block.commas && block.words.iter().any(|word| is_corner_word(word, control))
}

/// The move of a run goes on from the move before it, and not from where the program has left the tool:
/// there was a corner between.
fn begins_after_corner(trace: &ProgramTrace, run: &BlockExecution) -> bool {
    let (before, own) = trace.commands.split_at(run.commands.start);
    let motion = |command: &Command| command.kind.motion().copied();
    let own = own[..run.commands.len()].iter().find_map(motion);
    let before = before.iter().rev().find_map(motion);
    let (Some(before), Some(own)) = (before, own) else { return false };
    let is =
        |place: &Position| place.iter().zip(&own.from).all(|(a, b)| (a - b).abs() <= COINCIDENT_MM);
    is(&before.to) && !is(&run.before.position)
}

/// True when the new control makes the same of every corner of the program.
pub(super) fn keeps_corners(
    source: &SourceBlocks,
    trace: &ProgramTrace,
    from: &Control,
    to: &Control,
) -> bool {
    let [own, new] = [from, to].map(|control| control.parameters.rules.corner);
    let arc = |run: &BlockExecution| {
        let codes = [MotionCode::ArcCw, MotionCode::ArcCcw].map(Action::Motion);
        run.after.motion.is_some_and(|motion| codes.contains(&motion))
    };
    let makes = |run: &BlockExecution, next: Option<&BlockExecution>| {
        let Some(next) = next else { return true };
        let made = begins_after_corner(trace, next);
        // Without its corner at once: a block between, or a corner that is nearly straight.
        let plain =
            new.dwells_between >= own.dwells_between && new.straight_deg == own.straight_deg;
        let arcs = new.moves == CornerMoves::LinesAndArcs || !(arc(run) || arc(next));
        arcs && (made || plain)
    };
    let none = !source.blocks.iter().any(|block| asks(block, from));
    none || new.moves != CornerMoves::None
        && trace.execs.iter().enumerate().all(|(at, run)| {
            let corner = run.block.is_some_and(|block| asks(&source.blocks[block], from));
            !corner || makes(run, trace.execs.get(at + 1))
        })
}

impl ConvertContext<'_> {
    /// A block that ends in a corner, or that begins after one.
    pub(super) fn corners(&self, block: &Block, at: usize) -> Result<(), NeedsExpansion> {
        let Some(run) = self.run(at) else { return Ok(()) };
        if self.same_control() || self.keeps_corners || self.in_cycle(run) {
            return Ok(());
        }
        let title = self.to.table.title;
        if asks(block, self.from) {
            let has = self.to.parameters.rules.corner.moves != CornerMoves::None;
            return Err(NeedsExpansion(match has {
                true => format!("{title} makes something else of `,R` and `,C`"),
                false => format!("{title} has no `,R` and `,C`"),
            }));
        }
        if begins_after_corner(self.trace, run) {
            return Err(NeedsExpansion(
                "this move begins at the end of the corner before it".into(),
            ));
        }
        Ok(())
    }
}
