//! Skip moves (G31): a cut that a probe ends.

use chordal_diagnostics::{Code, Diagnostic};
use chordal_syntax::Block;

use super::Interpreter;
use crate::command::{AxisMask, CommandKind, Sink};

impl<S: Sink> Interpreter<'_, S> {
    /// G31. Where the probe touches depends on the part, so the move goes to its end, which
    /// the variables of the skip position show.
    pub(super) fn skip_move(&mut self, block: &Block, at: usize) {
        let (target, named) = self.target(block);
        if named == AxisMask::NONE {
            // A bare G31 only stops the reading ahead.
            return;
        }
        if !self.told.skip {
            self.told.skip = true;
            let span = self.span(block.words[at].range);
            self.report(
                Diagnostic::new(
                    Code::SkipAssumed,
                    span,
                    "where the probe touches is not known: the move is taken to its end",
                )
                .help("put the expected touch at the end of the move to see what follows"),
            );
        }
        let motion = self.moved_to(target, named);
        let feed = self.feed_for(block, &motion);
        self.emit(CommandKind::Line { motion, feed });
        self.note_skip_position();
    }
}
