//! `,R` and `,C`: a rounding or a chamfer between the end of this block and the next move.

use chordal_diagnostics::{Code, Diagnostic};
use chordal_dialect::MotionCode;
use chordal_kernel::ModalMotion;
use chordal_kernel::rules::CornerMoves;
use chordal_kernel::{CornerForm, ProgrammedCorner};
use chordal_syntax::{Block, Letters, Word};

use super::Interpreter;

impl Interpreter<'_> {
    /// True for `,R` and `,C` where the control has them.
    pub(super) fn is_corner_word(&self, word: &Word) -> bool {
        word.comma
            && matches!(word.letter, b'R' | b'C')
            && (self.control.parameters.rules.corner.moves != CornerMoves::None
                || self.kernel.reads_contour_words())
    }

    /// Requests the corner at the end of a block, before its motion.
    pub(super) fn take_corner(&mut self, block: &Block) {
        self.open_corner = false;
        if !block.commas {
            return self.take_corner_of_line(block);
        }
        if self.tap_stands_in(block) {
            return;
        }
        let mut words = block.words.iter().filter(|word| self.is_corner_word(word)).copied();
        let Some(first) = words.next() else { return };
        let in_contour = self.kernel.reads_contour_words();
        if let Some(second) = words.next() {
            let alarm = in_contour.then(|| {
                let title = self.control.table.title;
                format!("{title}: G7X error: Both A and C parameters on a corner")
            });
            let mut problem = Diagnostic::new(
                Code::CornerBlock,
                self.span(second.range),
                "a block ends in one rounding or one chamfer",
            )
            .label("neither is made")
            .also(self.span(first.range), "the first")
            .help("keep one of them");
            problem.alarm = alarm;
            self.kernel.report(problem);
            return;
        }
        let (name, form) = match (first.letter, in_contour) {
            (b'R', true) => ("A", CornerForm::Rounding),
            (_, true) => ("C", CornerForm::ChordOfRounding),
            (b'R', false) => (",R", CornerForm::Rounding),
            (_, false) => (",C", CornerForm::Chamfer),
        };
        let Some(size_mm) = self.length(&first) else { return };
        // The sign has no meaning in a contour.
        let size_mm = if in_contour { size_mm.abs() } else { size_mm };
        let word = self.span(first.range);
        if size_mm < 0.0 {
            let message = format!("`{name}` is a length from the corner and cannot be negative");
            self.kernel
                .report(Diagnostic::new(Code::BadWordValue, word, message).help("remove the sign"));
        } else if size_mm > 0.0 {
            let corner = ProgrammedCorner { word, name, form, size_mm, block: None, feed: None };
            self.kernel.request_corner(corner);
        }
    }

    /// True for a block with a straight cut, by its own code or by the active one.
    pub(super) fn cuts_line(&self, block: &Block) -> bool {
        let own = block.all(b'G').find_map(|word| {
            let row = self.control.row_of(word)?;
            let takes = row.takes_axes() || row.action.cycle().is_some();
            let cuts = row.action.motion().map(|code| code == MotionCode::Linear);
            cuts.or(takes.then_some(false))
        });
        match own {
            Some(cuts) => cuts,
            None => {
                self.kernel.state.motion == ModalMotion::Linear && self.kernel.state.cycle.is_none()
            }
        }
    }

    /// Requests the corner of I, K or R of a straight cut, on lathes that write them without a comma.
    fn take_corner_of_line(&mut self, block: &Block) {
        let letters = block.letters();
        if !self.control.parameters.corner_words_in_g1
            || !letters.meets(Letters::of("IKR"))
            || !self.cuts_line(block)
        {
            return;
        }
        let (name, letter, form) = match (letters.has(b'R'), letters.has(b'I')) {
            (true, _) => ("R", b'R', CornerForm::Rounding),
            (false, true) => ("I", b'I', CornerForm::Chamfer),
            (false, false) => ("K", b'K', CornerForm::Chamfer),
        };
        let Some(word) = block.last(letter).copied() else { return };
        // The sign repeats the direction of the next block, which is known from that block.
        let Some(size_mm) = self.length(&word).map(f64::abs).filter(|size| *size > 0.0) else {
            return;
        };
        self.kernel.request_corner(ProgrammedCorner {
            word: self.span(word.range),
            name,
            form,
            size_mm,
            block: None,
            feed: None,
        });
    }

    /// Called after each block: reports a corner word without a move, and blocks between a corner and its next move.
    pub(super) fn end_corner_block(&mut self, block: &Block) {
        if std::mem::take(&mut self.open_corner) {
            let word = block.words.iter().find(|word| self.is_corner_word(word));
            let span = self.span(word.map_or(block.range, |word| word.range));
            self.kernel.report(
                Diagnostic::new(
                    Code::CornerBlock,
                    span,
                    "a rounding or a chamfer in a block that makes no move of its own",
                )
                .help("write it into a block that cuts a line or an arc in the active plane"),
            );
        }
        // A line that ends in the next block (`,A`) moves with that block.
        if self.open_line.is_none() {
            self.kernel.corner_block_done();
        }
    }
}
