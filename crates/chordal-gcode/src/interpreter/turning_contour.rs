//! The blocks from P to Q that are the contour of a turning cycle.

use chordal_command::CompensationSide;
use chordal_diagnostics::{Code, Diagnostic};
use chordal_dialect::table::TurnFault;
use chordal_dialect::{Action, OnceCode, code_number};
use chordal_kernel::ContourProfile;
use chordal_syntax::{Block, BlockPosition as TextPosition, Letters};

use super::{BlockFlow, EndReason, Interpreter};

const X: usize = 0;
const Z: usize = 2;

/// The blocks of a contour.
pub(super) struct ContourBlocks {
    /// The position of the first block.
    pub first: TextPosition,
    /// The first block names both axes, even by W0.
    pub names_both: bool,
    /// The position after the last block.
    pub end: TextPosition,
}

/// A contour whose end is nearer to its start than this fraction of its length counts as returning to it.
const RETURN_SHARE: f64 = 0.1;

impl Interpreter<'_> {
    /// True when the contour does not reverse along the passes; otherwise this is reported.
    pub(super) fn check_contour_direction(
        &mut self,
        block: &Block,
        profile: &ContourProfile,
        along_x: bool,
    ) -> bool {
        let axis = usize::from(!along_x);
        // The passes run towards the end of the contour; if that is near the start again, towards the side of most of
        // its points.
        let (first, last) = (profile.start[axis], profile.end()[axis]);
        let mut away: Vec<f64> = profile.edges.iter().map(|edge| edge.to[axis] - first).collect();
        away.sort_by(f64::total_cmp);
        let length = away.iter().fold(0.0, |most: f64, by| most.max(by.abs()));
        let middle = away.get(away.len() / 2).copied().unwrap_or(0.0);
        let returns = (last - first).abs() < RETURN_SHARE * length;
        let forth = if (if returns { middle } else { last - first }) < 0.0 { -1.0 } else { 1.0 };
        let back = profile.edges.iter().find(|edge| {
            let by = (edge.to[axis] - edge.from[axis]) * forth;
            by < -1e-6
        });
        let Some(edge) = back else { return true };
        let letter = if along_x { 'X' } else { 'Z' };
        let by = self.kernel.length_text((edge.to[axis] - edge.from[axis]).abs());
        let span = edge.origin.span;
        let cycle = self.span(block.range);
        let diagnostic = Diagnostic::new(
            Code::BadWordValue,
            span,
            format!("this contour turns back in {letter}, by {by}: a roughing cycle cannot cut it"),
        )
        .also(cycle, "the cycle; it is not carried out")
        .help(format!("write the contour so that {letter} goes one way only"));
        self.report_turn_fault(diagnostic, TurnFault::TurnsBack);
        false
    }

    /// Finds the blocks from N P to N Q for a roughing or a finishing cycle; `None` when they are missing, which is
    /// reported.
    pub(super) fn contour(
        &mut self,
        block: &Block,
        at: usize,
        finishes: bool,
    ) -> Option<ContourBlocks> {
        if self.control.parameters.rules.turning.contour_program
            && let Some(word) = block.last(b'A').copied()
        {
            let message = "A, the program that holds the contour, is not followed".to_string();
            self.lose_path(word.range, message);
            return None;
        }
        let name = self.code_text(block, at);
        let span = self.span(block.words[at].range);
        let (p, q) = (self.count_of(block, b'P'), self.count_of(block, b'Q'));
        let (Some(p), Some(q)) = (p, q) else {
            let message = format!("{name} needs P and Q, the first and last block of its contour");
            let help = match self.control.parameters.rules.turning.two_blocks {
                true => "write the N numbers of these blocks with P and Q",
                false => {
                    "write the N numbers of these blocks with P and Q, and all else of the cycle, into this block"
                }
            };
            let diagnostic = Diagnostic::new(Code::MissingWord, span, message).help(help);
            self.report_turn_fault(diagnostic, TurnFault::NoContour);
            return None;
        };
        let here = block.range.start;
        // The control remembers the contour of the roughing cycle, and G70 cuts that one (common knowledge about Fanuc):
        // of several blocks with this number, the last one above.
        let roughed = match finishes {
            true => self.label_above(self.program, i64::from(p), here),
            false => None,
        };
        let first = roughed.or_else(|| self.label_below(self.program, i64::from(p), here));
        let first = match first {
            Some(first) => first,
            None => {
                self.report_missing_label(block, b'P', &p.to_string());
                return None;
            }
        };
        let last = self.label_below(self.program, i64::from(q), first.offset.saturating_sub(1));
        let Some(last) = last.filter(|last| last.offset >= first.offset) else {
            self.report_missing_label(block, b'Q', &q.to_string());
            return None;
        };
        let mut reader = self.reader_of(self.program);
        reader.seek(last);
        let mut found = Block::new();
        reader.read(&mut found);
        let end = reader.position();
        reader.seek(first);
        reader.read(&mut found);
        let letters = found.letters();
        let names_both = letters.meets(Letters::of("XU")) && letters.meets(Letters::of("ZW"));
        Some(ContourBlocks { first, names_both, end })
    }

    /// Reads the moves of a contour; its blocks have no other effect. `None` without moves, which is reported.
    pub(super) fn read_contour(
        &mut self,
        block: &Block,
        at: usize,
    ) -> Option<(ContourBlocks, ContourProfile)> {
        let contour = self.contour(block, at, false)?;
        let commands = self.collect_contour(&contour, block, None);
        let profile = ContourProfile::of(&commands);
        if profile.as_ref().is_none_or(|profile| profile.edges.is_empty()) {
            let span = self.span(block.range);
            let message = "the contour of this cycle has no moves".to_string();
            self.refuse_cycle(
                span,
                message,
                "it needs a first move and a contour after it",
                TurnFault::FirstBlock,
            );
            self.continue_after(&contour);
            return None;
        }
        Some((contour, profile?))
    }

    /// The commands of a contour, which are not carried out. It begins at `start`, or at the present position (`None`).
    pub(super) fn collect_contour(
        &mut self,
        contour: &ContourBlocks,
        block: &Block,
        start: Option<[f64; 2]>,
    ) -> Vec<chordal_command::Command> {
        let memory = self.kernel.memory();
        self.kernel.collected = Some(Vec::new());
        // The cycle's block gives feed and spindle: nothing is missing here.
        self.kernel.reported.missing_feed = true;
        self.kernel.reported.spindle_for_tool = Some(self.kernel.state.tool);
        self.kernel.state.side = CompensationSide::Off;
        if let Some([x, z]) = start {
            (self.kernel.state.position[X], self.kernel.state.position[Z]) = (x, z);
        }
        self.run_contour(contour, block);
        let commands = self.kernel.collected.take().unwrap_or_default();
        let repeated = self.kernel.repeated;
        self.kernel.recall(memory);
        self.kernel.repeated = repeated;
        self.set_units(self.kernel.state.units);
        commands
    }

    /// Continues the program after the contour, if that follows the cycle.
    pub(super) fn continue_after(&mut self, contour: &ContourBlocks) {
        if contour.end.offset > self.reader.position().offset {
            self.reader.seek(contour.end);
        }
    }

    /// Carries out the blocks of a contour, then returns to the block after the cycle.
    pub(super) fn run_contour(&mut self, contour: &ContourBlocks, cycle: &Block) {
        let here = self.reader.position();
        let origin = self.kernel.origin;
        self.reader.seek(contour.first);
        let mut block = Block::new();
        let depth = self.frames.len();
        while self.reader.position().offset < contour.end.offset && self.reader.read(&mut block) {
            // After a statement or before blanks, the reader's position may be before the end although no block is left.
            if block.range.start >= contour.end.offset {
                break;
            }
            if !self.kernel.count_repeated() {
                break;
            }
            if let Some(word) = self.forbidden_in_contour(&block) {
                let range = block.words[word].range;
                let name = self.code_text(&block, word);
                let span = self.span(range);
                self.kernel.report(
                    Diagnostic::new(
                        Code::CallNotAllowed,
                        span,
                        format!("{name} may not be in the contour of a cycle"),
                    )
                    .also(self.span(cycle.range), "the cycle")
                    .label("this block is skipped")
                    .help("a contour has moves, feeds and speeds only"),
                );
                continue;
            }
            if self.kernel.reads_contour_words() && !self.read_as_contour(&mut block) {
                continue;
            }
            if let BlockFlow::End(EndReason::Budget) = self.execute(&mut block) {
                break;
            }
            if block.commas || self.kernel.waits_at_corner() {
                self.end_corner_block(&block);
            }
        }
        if self.kernel.reads_contour_words() {
            self.kernel.end_corners_of_contour();
        }
        while self.frames.len() > depth {
            self.leave(None);
        }
        self.reader.seek(here);
        self.kernel.origin = origin;
    }

    /// The incremental letters and their axes: those of the control, or of a contour with words of its own.
    pub(super) fn increments(&self) -> &'static [(u8, u8)] {
        match self.kernel.reads_contour_words() {
            true => &[(b'U', b'X'), (b'W', b'Z')],
            false => self.control.parameters.increments,
        }
    }

    /// Reads A and C in a contour block as corner words, not as axes. False when the control refuses the block.
    fn read_as_contour(&mut self, block: &mut Block) -> bool {
        for (letter, axis) in self.increments() {
            let (Some(path), Some(place)) = (block.word(*letter), block.word(*axis)) else {
                continue;
            };
            let [letter, axis] = [*letter, *axis].map(char::from);
            let diagnostic = Diagnostic::new(
                Code::BadWordValue,
                self.span(path.range),
                format!("{letter} and {axis} in one block of a contour"),
            )
            .label("the block is not read")
            .also(self.span(place.range), "the same axis")
            .help("keep one of them");
            let alarm = format!("G7x error: Cannot use {letter} and {axis} in the same block");
            self.report_refused(diagnostic, &alarm);
            return false;
        }
        for word in block.words.iter_mut().filter(|word| b"AC".contains(&word.letter)) {
            word.letter = if word.letter == b'A' { b'R' } else { b'C' };
            word.comma = true;
            block.commas = true;
        }
        true
    }

    /// The index of a word that is not permitted in a contour: calls, ends, other cycles; `None` without one.
    fn forbidden_in_contour(&self, block: &Block) -> Option<usize> {
        block.words.iter().position(|word| {
            let code = word.number().and_then(code_number);
            let row = code.and_then(|code| match word.letter {
                b'G' => self.control.g_code(code),
                b'M' => self.control.m_code(code),
                _ => None,
            });
            row.is_some_and(|row| {
                matches!(
                    row.action,
                    Action::Call(_)
                        | Action::Once(OnceCode::Turning(_))
                        | Action::After(chordal_dialect::AfterCode::ProgramEnd { .. })
                )
            })
        })
    }
}
