//! Checks that the words of a block may be combined: repeated words, codes that exclude each other, and letters that
//! no active code or mode uses.

use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_dialect::table::MotionModality;
use chordal_dialect::{Action, ModeCode, MotionCode, OnceCode};
use chordal_dialect::{CodeGroup, CodeRow};
use chordal_kernel::ModalMotion;
use chordal_kernel::rules::{SpiralForm, TurnCycle};
use chordal_syntax::{Block, Letters};

use super::Interpreter;

/// Letters that every block may contain.
pub(super) const ALWAYS: Letters = Letters::of("NOGMFSTHDXYZABC");

impl Interpreter<'_> {
    pub(super) fn check_groups(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        self.check_pairs(block, codes);
        self.check_m_groups(block, codes);
        let g_words = block.all(b'G').count();
        for (row, at) in codes {
            let word = &block.words[*at];
            if g_words > 1 && word.letter == b'G' && self.control.table.alone.contains(&row.code) {
                let title = self.control.table.title;
                let name = row.name(b'G');
                self.kernel.report(
                    Diagnostic::new(
                        Code::NotAlone,
                        self.span(word.range),
                        format!("on a {title} {name} must be the only G code of its block"),
                    )
                    .help("put the other G codes into the block before"),
                );
            }
        }
    }

    /// Compares each code with those before it.
    fn check_pairs(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        if codes.len() < 2 {
            return;
        }
        // Each different code once, so that long lines of repeated codes take linear time.
        let mut before: Vec<(&'static CodeRow, usize)> = Vec::new();
        for second in codes {
            let letter = block.words[second.1].letter;
            let has_letter = |first: &(&CodeRow, usize)| block.words[first.1].letter == letter;
            let clash = before.iter().find(|first| {
                has_letter(first)
                    && self.one_group(first.0.group, second.0.group)
                    && !self.is_cycle_cancel_with_motion(first.0, second.0)
                    && excludes(first.0, second.0, self.control.table.distance_left_to_right)
                    && !self.allows_probe(first.0, second.0)
            });
            if let Some(first) = clash {
                self.same_group(block, *first, *second);
            } else if let Some(first) = before.iter().find(|(row, _)| share(row, second.0)) {
                self.report_shared_words(block, *first, *second);
            } else if let Some(alarm) = self.control.parameters.one_code_takes_axes
                && let Some(first) = before.iter().find(|(row, _)| both_take_axes(row, second.0))
            {
                self.report_two_takers(block, *first, *second, alarm);
            }
            let is_known =
                |first: &(&CodeRow, usize)| has_letter(first) && std::ptr::eq(first.0, second.0);
            if !before.iter().any(is_known) {
                before.push(*second);
            }
        }
    }

    /// Reports two frames in one block, or a frame with another code that uses its axis words.
    fn report_shared_words(
        &mut self,
        block: &Block,
        first: (&CodeRow, usize),
        second: (&CodeRow, usize),
    ) {
        let names = [first.0.name(b'G'), second.0.name(b'G')];
        let message = format!(
            "{} and {} in one block: both use its axis words, and only {} is carried out",
            names[0], names[1], names[1]
        );
        self.kernel.report(self.two_codes(block, first.1, second.1, message, "not carried out"));
    }

    /// The problem of two codes that cannot be in one block.
    fn two_codes(
        &self,
        block: &Block,
        first: usize,
        second: usize,
        message: String,
        first_label: &str,
    ) -> Diagnostic {
        Diagnostic::new(Code::SameGroup, self.span(block.words[second].range), message)
            .also(self.span(block.words[first].range), first_label)
            .help("write them in two blocks")
    }

    /// Reports a motion code with another code that uses the axis words.
    fn report_two_takers(
        &mut self,
        block: &Block,
        first: (&CodeRow, usize),
        second: (&CodeRow, usize),
        alarm: &str,
    ) {
        let title = self.control.table.title;
        let (one, two) = (first.0.name(b'G'), second.0.name(b'G'));
        let message = format!("{one} and {two} in one block: both use its axis words");
        let diagnostic = self.two_codes(block, first.1, second.1, message, "the first");
        self.kernel.report(diagnostic.alarm(format!("{title}: {alarm}")));
    }

    /// True for a probe move with a code that does not use the axis words: G4, G92.1.
    fn allows_probe(&self, first: &CodeRow, second: &CodeRow) -> bool {
        let dwells = self.control.parameters.dwell_with_motion;
        let probes = |row: &CodeRow| matches!(row.action, Action::Once(OnceCode::Probe { .. }));
        let leaves = |row: &CodeRow| row.action.leaves_axes(dwells);
        probes(first) && leaves(second) || leaves(first) && probes(second)
    }

    /// Reports two M codes of one group, on controls with such groups.
    fn check_m_groups(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        for group in self.control.parameters.m_groups {
            let own = |at: &usize, row: &CodeRow| {
                block.words[*at].letter == b'M' && group.contains(&row.code)
            };
            let mut found = codes.iter().filter(|(row, at)| own(at, row));
            let (Some(first), Some(second)) = (found.next(), found.next()) else { continue };
            let names = [first.0.name(b'M'), second.0.name(b'M')];
            let title = self.control.table.title;
            let message = format!("{} and {} cannot be in one block", names[0], names[1]);
            let diagnostic = self.two_codes(block, first.1, second.1, message, "the first");
            self.kernel.report(match self.control.parameters.m_groups_alarm {
                Some(alarm) => diagnostic.alarm(format!("{title}: {alarm}")),
                // More than one M code is an option of that control, and its manual does not say what two spindle codes
                // do.
                None if self.control.table.last_of_group_counts => {
                    diagnostic.severity(Severity::Warning)
                }
                None => diagnostic,
            });
        }
    }

    #[inline]
    pub(super) fn check_repeated_words(&mut self, block: &Block) {
        const MAY_REPEAT: Letters = Letters::of("GM");
        if !block.repeated().within(MAY_REPEAT) {
            self.report_repeated_words(block);
        }
    }

    #[cold]
    fn report_repeated_words(&mut self, block: &Block) {
        let mut seen = Letters::NONE;
        for word in &block.words {
            // On controls where R names registers, two R words may name different ones.
            let again = seen.has(word.letter)
                && !matches!(word.letter, b'G' | b'M')
                && !word.comma
                && word.register.is_none();
            // The words of a second return (`G28 Z0 G28 X0 Y0`) are reported with the codes.
            if again {
                let letter = word.letter as char;
                let first = block.word(word.letter).map_or(word.range, |w| w.range);
                self.kernel.report(
                    Diagnostic::new(
                        Code::RepeatedWord,
                        self.span(word.range),
                        format!("`{letter}` appears more than once in this block"),
                    )
                    .label("the last one is used")
                    .also(self.span(first), "the first")
                    .help("keep one of them"),
                );
            }
            seen.insert(word.letter);
        }
    }

    /// The letters that the codes of the block and the active modes use.
    pub(super) fn claims(&self, block: &Block, codes: &[(&'static CodeRow, usize)]) -> Letters {
        let parameters = &self.control.parameters;
        let mut claims = ALWAYS.without(parameters.words_of_codes);
        for (letter, _) in parameters.increments {
            claims = claims.without(Letters(1 << (letter - b'A')));
        }
        // Codes that use the axis words list the incremental letters they use.
        let by_increments = |row: &CodeRow| {
            !row.takes_axes()
                || row.action.once().is_some_and(|code| {
                    code == OnceCode::PresetPosition
                        || code == OnceCode::ReturnFromReference
                        || matches!(
                            code,
                            OnceCode::ReturnToReference { .. } | OnceCode::Probe { .. }
                        )
                })
        };
        if codes.iter().all(|(row, _)| by_increments(row)) {
            for (letter, _) in self.control.parameters.increments {
                claims.insert(*letter);
            }
        }
        for (row, _) in codes {
            claims = claims.union(self.words_of(row));
            let rough = OnceCode::Turning(TurnCycle::Rough);
            let face = OnceCode::Turning(TurnCycle::RoughFace);
            if (row.action == Action::Once(rough) || row.action == Action::Once(face))
                && block.letters().meets(Letters::of("PQ"))
                && let Some(letter) = parameters.rules.turning.pockets_by
            {
                claims.insert(letter);
            }
        }
        let table = self.control.table;
        if table.work_names.by_e {
            claims.insert(b'E');
        }
        if table.lexicon.registers {
            claims.insert(b'R');
        }
        if let Some(cycle) = self.kernel.state.cycle
            && let Some(row) = table.g_codes.iter().find(|r| r.action == Action::Cycle(cycle.kind))
        {
            claims = claims.union(self.words_of(row));
        }
        if self.kernel.state.tool_by_vector {
            claims = claims.union(Letters::of("IJK"));
        }
        if self.kernel.reads_contour_words() {
            claims = claims.union(Letters::of("ACUW"));
        }
        // While a cycle is active, a block makes a hole, not an arc.
        let ends = |row: &CodeRow| row.action == Action::Mode(ModeCode::CancelCycle);
        let drills = self.kernel.state.cycle.is_some() && !codes.iter().any(|(row, _)| ends(row));
        let takes = |row: &CodeRow| {
            let leaves = row.action.leaves_axes(self.control.parameters.dwell_with_motion);
            row.takes_axes() && !leaves || row.action.cycle().is_some()
        };
        let drills = drills || codes.iter().any(|(row, _)| takes(row));
        let own = self.control.parameters.corner_words_in_g1
            && codes.iter().any(|(row, _)| row.action.motion().is_some());
        // A motion code in the block ends the active motion, whose words then do not count.
        let armed = self.control.table.motion == MotionModality::Armed;
        let ended = !armed && codes.iter().any(|(row, _)| row.action.motion().is_some());
        if !drills
            && !own
            && !ended
            && let Some(words) = self.modal_arc_words()
        {
            claims = claims.union(words);
        }
        claims
    }

    /// The letters that a block without a motion code may contain because of the active motion; `None` for no others.
    pub(super) fn modal_arc_words(&self) -> Option<Letters> {
        let code = match self.kernel.state.motion {
            ModalMotion::Arc(_) => 20,
            ModalMotion::Linear if self.control.parameters.corner_words_in_g1 => 10,
            ModalMotion::Spiral(_) => 21,
            ModalMotion::Turn(_) | ModalMotion::Thread
                if !self.control.parameters.increments.is_empty() =>
            {
                return self.active_motion_words();
            }
            ModalMotion::ThreadPasses => return self.active_motion_words(),
            ModalMotion::Thread => 330,
            ModalMotion::RigidTap => 331,
            ModalMotion::Spline(form) => {
                let code = Action::Motion(MotionCode::Spline(form));
                let rows = self.control.table.g_codes.iter();
                return rows
                    .into_iter()
                    .find(|row| row.action == code)
                    .map(|row| self.words_of(row));
            }
            _ if self.control.table.motion == MotionModality::Armed => 20,
            _ => return None,
        };
        self.control.g_code(code).map(|row| self.words_of(row))
    }

    /// The letters of the active motion code.
    fn active_motion_words(&self) -> Option<Letters> {
        let action = Action::from(self.kernel.state.motion_mode()?);
        let rows = self.control.table.g_codes;
        rows.iter().find(|row| row.action == action).map(|row| self.words_of(row))
    }

    /// The letters that a code uses with the active parameters: Q and L on an arc only if they make it a spiral.
    pub(super) fn words_of(&self, row: &CodeRow) -> Letters {
        let arc = matches!(
            row.action,
            Action::Motion(MotionCode::ArcCw) | Action::Motion(MotionCode::ArcCcw)
        );
        let spirals = matches!(
            self.control.parameters.rules.arc.spiral,
            SpiralForm::IncrementCount | SpiralForm::IncrementHeightCount
        );
        let mut words =
            if arc && !spirals { row.words.without(Letters::of("QL")) } else { row.words };
        if matches!(row.action, Action::Cycle(_)) {
            words.insert(self.control.parameters.rules.cycles.repeat_letter);
        }
        words
    }

    pub(super) fn check_unused(&mut self, block: &Block, claims: Letters) {
        if block.letters().within(claims) {
            return self.check_comma_words(block);
        }
        for index in 0..block.words.len() {
            let word = block.words[index];
            if !word.comma && !claims.has(word.letter) {
                self.unused_word(&word);
            }
        }
        self.check_comma_words(block);
    }

    pub(super) fn check_comma_words(&mut self, block: &Block) {
        for word in block.words.iter().filter(|word| word.comma) {
            if word.letter == b'R' && self.tap_stands_in(block) {
                continue;
            }
            if word.letter == b'A' && self.control.parameters.corner_words_in_g1 {
                continue;
            }
            if self.is_corner_word(word) {
                self.open_corner = true;
                continue;
            }
            let letter = word.letter as char;
            let message = format!("`,{letter}` (corner rounding or chamfer) is not followed");
            self.lose_path(word.range, message);
        }
    }
}

/// True for two codes of one group that cannot be in one block.
fn excludes(first: &CodeRow, second: &CodeRow, distance_left_to_right: bool) -> bool {
    match second.group {
        CodeGroup::Distance => !distance_left_to_right && first.code != second.code,
        CodeGroup::OneShot => first.takes_axes() && second.takes_axes(),
        CodeGroup::Auxiliary | CodeGroup::Calling | CodeGroup::Coolant | CodeGroup::Spindle => {
            false
        }
        _ => first.code != second.code,
    }
}

/// True for two codes that both use the axis words of a block, one of them a frame.
fn share(first: &CodeRow, second: &CodeRow) -> bool {
    let frame = |row: &CodeRow| {
        matches!(row.group, CodeGroup::Scaling | CodeGroup::Rotation | CodeGroup::Mirror)
    };
    let takes = |row: &CodeRow| row.action.once().is_some() && row.takes_axes();
    takes(first) && takes(second) && (frame(first) || frame(second)) && first.group != second.group
}

/// True for a motion code with a code that uses the axis words: G10, G28, G30, G52, G92.
fn both_take_axes(first: &CodeRow, second: &CodeRow) -> bool {
    let moves = |row: &CodeRow| row.action.motion().is_some() || row.action.cycle().is_some();
    let takes = |row: &CodeRow| {
        matches!(
            row.action,
            Action::Once(
                OnceCode::SetData
                    | OnceCode::ReturnToReference { .. }
                    | OnceCode::LocalShift
                    | OnceCode::PresetPosition
            )
        )
    };
    moves(first) && takes(second) || takes(first) && moves(second)
}
