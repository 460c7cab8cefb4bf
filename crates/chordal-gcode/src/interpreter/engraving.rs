//! Engraved text (Haas G47): its start and an estimate of its time, not the letters.

use std::sync::Arc;

use chordal_command::{AxisMask, CommandKind, FeedMode};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_machine::Axis;
use chordal_syntax::Block;

use super::Interpreter;

const Z: usize = Axis::Z as usize;
const XY: AxisMask = AxisMask(1 << Axis::X as usize | 1 << Axis::Y as usize);
const Z_ALONE: AxisMask = AxisMask(1 << Z);

/// Length of the strokes of a letter, in letter heights: a mean of single-stroke letters.
const STROKES_PER_LETTER: f64 = 3.0;

/// Height of letters without J: 1 inch, mm.
const LETTER_HEIGHT_MM: f64 = 25.4;

impl Interpreter<'_> {
    /// Moves to the start of the text and down, waits for the estimated time of its letters, and moves up to R. The end
    /// of the last letter is not known, so X and Y are not known until the program names them.
    pub(super) fn engrave(&mut self, block: &Block, at: usize) {
        self.unused_axes(block, |axis, _| axis < 3);
        let (target, named) = self.target(block);
        let height = self.length_of(block, b'J').unwrap_or(LETTER_HEIGHT_MM).abs();
        let begin = named.and(XY);
        let mut place = self.kernel.state.position;
        for axis in begin.iter() {
            place[axis as usize] = target[axis as usize];
        }
        if begin != AxisMask::NONE {
            self.kernel.rapid(place, begin);
        }
        let clear = self.length_of(block, b'R').unwrap_or(place[Z]);
        place[Z] = clear;
        self.kernel.rapid(place, Z_ALONE);
        if named.has(Z) {
            place[Z] = target[Z];
            self.kernel.line(&self.at(block), place, Z_ALONE);
        }
        self.wait_for_letters(block, height);
        place[Z] = clear;
        self.kernel.rapid(place, Z_ALONE);
        let state = &mut self.kernel.state;
        state.known = state.known.without(XY);
        state.machine_known = state.machine_known.without(XY);
        self.note_letters(block, at);
    }

    /// Emits a dwell by the number of letters, their height and F.
    fn wait_for_letters(&mut self, block: &Block, height: f64) {
        let feed = self.kernel.state.feed.filter(|feed| *feed > 0.0);
        let per_time = self.kernel.state.feed_mode == FeedMode::PerTime;
        let Some(feed) = feed.filter(|_| per_time) else { return };
        let is_letter = |byte: &&u8| !byte.is_ascii_whitespace() && !matches!(byte, b'(' | b')');
        // From 32 on, P is the code of a single character.
        let one = block.last(b'P').and_then(|word| self.literal(word));
        let text = block.comments.first().filter(|_| one.is_none_or(|p| p.to_f64() < 32.0));
        let letters = text.map_or(1, |comment| {
            comment.slice(self.reader.text()).iter().filter(is_letter).count()
        });
        let seconds = letters as f64 * STROKES_PER_LETTER * height / feed;
        let label = Some(Arc::from("engraved letters, estimated"));
        self.kernel.emit(CommandKind::Dwell { seconds, label });
    }

    fn note_letters(&mut self, block: &Block, at: usize) {
        let name = self.code_text(block, at);
        let span = self.span(block.words[at].range);
        self.report_once(
            Diagnostic::new(
                Code::NotSimulated,
                span,
                format!(
                    "the letters that {name} engraves are not followed: their time is estimated"
                ),
            )
            .label("X and Y are not known until the program names them again")
            .help("check by other means what the letters touch"),
        );
    }
}
