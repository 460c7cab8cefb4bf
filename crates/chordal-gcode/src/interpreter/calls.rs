//! Subprograms, subroutines, local calls, returns and their limits.

use chordal_dialect::table::SubroutineForm;
use chordal_dialect::{Action, AfterCode, code_number};
use std::collections::HashMap;

use chordal_command::SpindleState;
use chordal_diagnostics::{Code, Diagnostic, Severity, Span, TextRange};
use chordal_syntax::{Block, BlockPosition as TextPosition, Letters, Word, is_program_name};

use super::custom_codes::CustomCodeCall;
use super::{BlockFlow, CallFrame, EndReason, Interpreter};

/// Built-in subroutines of the L form: L91… to L99….
const FIXED: std::ops::RangeInclusive<u32> = 91..=99;

impl Interpreter<'_> {
    /// Reads the L100, L200 … sections before the main program.
    pub(super) fn read_subroutine_section(&mut self) {
        if self.control.table.subroutines == SubroutineForm::None {
            return;
        }
        let begin = self.reader.position();
        let mut block = Block::new();
        let mut in_section = false;
        loop {
            let more = self.reader.read(&mut block);
            let read = self.reader.position().offset;
            self.look_at_range(TextRange::new(begin.offset, read));
            if !more {
                break;
            }
            if block.words.is_empty() || block.letters().has(b'O') {
                continue;
            }
            match subroutine_head(&block) {
                Some(number) => {
                    in_section = true;
                    let after = self.reader.position();
                    if self.subroutines.insert(number, after).is_some() {
                        self.report_second_head(&block, number);
                    }
                }
                None if !in_section => {
                    // The first block is not a head: there is no section.
                    self.reader.seek(begin);
                    return;
                }
                None if self.ends_section(&block) => return,
                None => {}
            }
        }
        // No M30 after the subroutines: there is no main program.
        self.reader.seek(begin);
        if in_section {
            self.subroutines_without_end(begin);
        }
    }

    fn ends_section(&self, block: &Block) -> bool {
        block.all(b'M').any(|word| {
            let code = word.number().and_then(code_number);
            code.and_then(|code| self.control.m_code(code)).is_some_and(|row| {
                matches!(row.action, Action::After(AfterCode::ProgramEnd { rewind: true }))
            })
        })
    }

    fn report_second_head(&mut self, block: &Block, number: u32) {
        let span = self.words_span(block, Letters::of("L"));
        self.kernel.report(
            Diagnostic::new(
                Code::DuplicateProgram,
                span,
                format!("subroutine L{number}00 is there twice"),
            )
            .label("this one counts")
            .help("give one of them another number"),
        );
    }

    fn subroutines_without_end(&mut self, begin: TextPosition) {
        let span = Span::new(self.file, begin.offset, begin.offset);
        self.kernel.report(
            Diagnostic::new(
                Code::HeaderOutOfPlace,
                span,
                "the subroutine section is not closed by M30, so there is no main program",
            )
            .help("put M30 after the last subroutine, and the main program after it"),
        );
        let end = self.reader.text().len() as u32;
        self.reader.seek(TextPosition { offset: end, line: begin.line });
    }

    /// `L201`: subroutine 2, once.
    pub(super) fn call_subroutine(&mut self, word: &Word, value: u32) {
        let (number, repeats) = (value / 100, value % 100);
        if FIXED.contains(&number) {
            let message = format!("the fixed subroutine L{value} is not followed");
            return self.lose_path(word.range, message);
        }
        if repeats == 0 {
            let alone = self.subroutines.contains_key(&number);
            let (code, message) = if alone {
                (Code::BadWordValue, format!("L{value} calls subroutine {number} zero times"))
            } else {
                (
                    Code::HeaderOutOfPlace,
                    format!("the subroutine L{value} begins outside the subroutine section"),
                )
            };
            let help = if alone {
                format!("write L{} to call it once", number * 100 + 1)
            } else {
                "put it before the M30 that closes the subroutines".to_string()
            };
            self.kernel.report(Diagnostic::new(code, self.span(word.range), message).help(help));
            return;
        }
        let in_subprogram = self.frames.iter().any(|frame| !frame.subroutine);
        if in_subprogram {
            self.kernel.report(
                Diagnostic::new(
                    Code::CallNotAllowed,
                    self.span(word.range),
                    "a subprogram (O, M98) may not call a subroutine (L)",
                )
                .help("call another subprogram with M98, or move the call to the main program"),
            );
            return;
        }
        let Some(start) = self.subroutines.get(&number).copied() else {
            self.kernel.report(
                Diagnostic::new(
                    Code::MissingSubprogram,
                    self.span(word.range),
                    format!("there is no subroutine L{number}00"),
                )
                .label(format!("calls subroutine {number}, {repeats} times"))
                .help(format!("write the subroutine L{number}00 before the main program")),
            );
            return;
        };
        let main = self.program;
        self.enter(word, main, start, repeats, true);
    }

    /// M98.
    pub(super) fn call_program(&mut self, block: &Block, at: usize) {
        let start_letter = self.control.table.call_start_label;
        let start_word = start_letter.and_then(|letter| block.last(letter).copied());
        let Some(word) = block.last(b'P').copied() else {
            return match start_word {
                // Without a program's number the block is one of this program.
                Some(word) => self.call_from_label(block, &word),
                None => self.report_call_without_program(block, at),
            };
        };
        let Some(written) = self.count(&word) else { return };
        let by_q = self.control.parameters.calls_counted_by_q && !block.letters().has(b'L');
        let letter = if by_q { b'Q' } else { b'L' };
        let times = match block.letters().has(letter) {
            true => self.count_of(block, letter).unwrap_or(1),
            false => 1,
        };
        if self.control.table.lexicon.o_words
            && let Some(start) = self.label_ahead(written)
        {
            let times = self.cut_to_limit(&word, times);
            if times > 0 {
                self.enter(&word, self.program, start, times, false);
            }
            return;
        }
        let (number, repeats) = self.unpacked(written, times);
        let Some(program) = self.library.find(number, self.file) else {
            let call = CustomCodeCall { block: Some(block), arguments: &[] };
            if self.shop_program(&word, number, repeats, call).is_none() {
                self.report_missing_program(&word, number);
            }
            return;
        };
        let mut start = self.library.programs()[program].head.start;
        if let Some(start_word) = start_word {
            let Some(label) = self.literal(&start_word) else { return };
            match self.label(program, label.to_integer().unwrap_or(-1)) {
                Some(position) => start = position,
                None => {
                    return self.report_missing_label(block, start_word.letter, &label.to_string());
                }
            }
        }
        let repeats = self.cut_to_limit(&word, repeats);
        if repeats > 0 {
            self.enter(&word, program, start, repeats, false);
        }
    }

    /// The number of the called program and its repeats, when P may contain both (`P50012`). A program with the whole
    /// number takes precedence.
    fn unpacked(&self, written: u32, times: u32) -> (u32, u32) {
        let packed =
            self.control.parameters.packed_calls && written > 9999 && !is_program_name(written);
        if packed && self.library.find(written, self.file).is_none() {
            (written % 10_000, written / 10_000)
        } else {
            (written, times)
        }
    }

    fn report_call_without_program(&mut self, block: &Block, at: usize) {
        let span = self.span(block.words[at].range);
        let text = self.reader.text();
        // A path, or a name with an extension; the full stop of a sentence is not one.
        let has_extension = |text: &[u8]| {
            text.windows(3).any(|part| {
                part[0].is_ascii_alphanumeric() && part[1] == b'.' && part[2].is_ascii_alphabetic()
            })
        };
        let names_file = |text: &[u8]| text.contains(&b'/') || has_extension(text);
        if !block.comments.iter().any(|comment| names_file(comment.slice(text))) {
            let message = "M98 without a program number".to_string();
            return self.kernel.missing_word(span, message, "write P and the program's number");
        }
        let message = "a subprogram named by its file in a comment is not followed";
        self.lose_path(span.range, message.into());
    }

    pub(super) fn report_missing_program(&mut self, word: &Word, number: u32) {
        if !self.missing.contains(&number) {
            self.missing.push(number);
        }
        let name = match is_program_name(number) {
            true => String::from_utf8_lossy(word.range.slice(self.reader.text())).into_owned(),
            false => format!("O{number}"),
        };
        let mut help = format!(
            "put {name} into the file, or a file {} into its folder",
            name.trim_matches(['<', '>'])
        );
        if !is_program_name(number) {
            help += &format!("; or say in the machine file what it does: `[shop_codes.{name}]`");
        }
        self.report_once(
            Diagnostic::new(
                Code::MissingSubprogram,
                self.span(word.range),
                format!("there is no program {name} in this file or its folder"),
            )
            .label("the call is skipped: what it moves is missing from the path")
            .help(help),
        );
    }

    /// M97.
    pub(super) fn call_label(&mut self, block: &Block, at: usize) {
        let Some(word) = block.last(b'P').copied() else {
            let span = self.span(block.words[at].range);
            let message = "M97 without an N number".to_string();
            return self.kernel.missing_word(span, message, "write P and the N number");
        };
        self.call_from_label(block, &word);
    }

    /// Calls the running program from the block whose N number a word gives.
    fn call_from_label(&mut self, block: &Block, word: &Word) {
        let Some(label) = self.count(word) else { return };
        let repeats = match block.letters().has(b'L') {
            true => self.count_of(block, b'L').unwrap_or(1),
            false => 1,
        };
        let repeats = self.cut_to_limit(word, repeats);
        match self.label(self.program, i64::from(label)) {
            Some(start) if repeats > 0 => {
                let program = self.program;
                self.enter(word, program, start, repeats, false);
            }
            Some(_) => {}
            None => self.report_missing_label(block, word.letter, &label.to_string()),
        }
    }

    /// Enters a program; false when it is nested too deeply, which is reported.
    pub(super) fn enter(
        &mut self,
        word: &Word,
        program: usize,
        start: TextPosition,
        repeats: u32,
        subroutine: bool,
    ) -> bool {
        let depth = self.frames.len() as u32 + 1;
        let limit = self.control.parameters.nesting;
        if depth > limit {
            self.kernel.report(
                Diagnostic::new(
                    Code::NestingTooDeep,
                    self.span(word.range),
                    format!("this call would be {depth} levels deep; the control allows {limit}"),
                )
                .label("not called")
                .help("a program that calls itself never returns; check the calls above"),
            );
            return false;
        }
        let mut callee = self.reader_of(program);
        callee.seek(start);
        let entered = self.kernel.calls.enter(self.kernel.call, self.kernel.origin.span);
        let path = std::mem::replace(&mut self.kernel.call, entered);
        let reader = std::mem::replace(&mut self.reader, callee);
        let caller = std::mem::replace(&mut self.program, program);
        self.file = self.program_at(program).file;
        self.frames.push(CallFrame {
            reader,
            program: caller,
            path,
            start,
            remaining: repeats - 1,
            subroutine,
            loops: std::mem::take(&mut self.macros.loops),
            modal_calls: self.macros.active,
            own_locals: false,
            by_alias: false,
            of_shop: false,
            entry: [self.kernel.state.position[0], self.kernel.state.position[1]],
            contour: None,
        });
        true
    }

    /// M17.
    pub(super) fn return_from_subroutine(&mut self, block: &Block, at: usize) {
        match self.frames.last() {
            Some(frame) if frame.subroutine => self.leave(None),
            _ => self.report_return_without_call(block, at),
        }
    }

    fn report_return_without_call(&mut self, block: &Block, at: usize) {
        let span = self.span(block.words[at].range);
        self.kernel.report(
            Diagnostic::new(Code::ReturnWithoutCall, span, "a return where nothing was called")
                .help("remove it, or end the program with M30"),
        );
    }

    /// M99.
    pub(super) fn return_from_program(&mut self, block: &Block, at: usize) -> BlockFlow {
        let label = match block.letters().has(b'P') {
            true => self.count_of(block, b'P').map(i64::from),
            false => None,
        };
        let in_call = self.frames.last().is_some_and(|frame| !frame.subroutine);
        if in_call && !(label.is_some() && self.control.parameters.return_label_in_callee) {
            self.leave(label.map(|label| (block, label)));
            if self.lost_jump {
                return BlockFlow::End(EndReason::LostJump);
            }
            return BlockFlow::Next;
        }
        match label {
            Some(label) => self.jump(block, at, label),
            None => {
                let span = self.span(block.words[at].range);
                self.report_repeat(span, "M99 in the main program");
                BlockFlow::End(EndReason::Repeats)
            }
        }
    }

    /// Reports M99 in a main program, or M47. A program without tool and spindle is probably a subprogram of another
    /// file.
    pub(super) fn report_repeat(&mut self, span: Span, what: &str) {
        let state = &self.kernel.state;
        let is_part = state.tool == 0 && state.spindle == SpindleState::Off && state.rpm == 0.0;
        let diagnostic = Diagnostic::new(
            Code::EndlessLoop,
            span,
            format!("{what} starts the program again without end"),
        );
        self.kernel.report(match is_part {
            true => diagnostic
                .label("shown once")
                .severity(Severity::Note)
                .help("nothing in this file calls it: if it is a subprogram, this is right"),
            false => diagnostic
                .label("shown once")
                .severity(Severity::Warning)
                .help("end the program with M30, unless the repeat is intended"),
        });
    }

    /// A jump within the running program.
    fn jump(&mut self, block: &Block, at: usize, label: i64) -> BlockFlow {
        let taken = self.jumps.entry(block.range.start).or_insert(0);
        *taken += 1;
        // Without macros only positions change between two passes, so a second pass through the same jump
        // is followed by a third.
        if *taken > 1 && self.frames.is_empty() && !self.macros.used {
            let span = self.span(block.words[at].range);
            self.kernel.report(
                Diagnostic::new(Code::EndlessLoop, span, "this jump repeats without end")
                    .label("stopped here")
                    .help("nothing ends the loop: check the N number it jumps to"),
            );
            return BlockFlow::End(EndReason::Repeats);
        }
        match self.label(self.program, label) {
            Some(position) => {
                self.go_to(position);
                BlockFlow::Next
            }
            None => {
                self.report_missing_label(block, b'P', &label.to_string());
                BlockFlow::End(EndReason::LostJump)
            }
        }
    }

    /// Continues at a position of this program; blocks that are then repeated count against the budget.
    pub(super) fn go_to(&mut self, target: TextPosition) {
        let here = self.kernel.origin.span.range;
        if target.offset <= here.start && self.frames.is_empty() {
            self.repeat_until = self.repeat_until.max(here.end.max(1));
        }
        self.reader.seek(target);
    }

    /// Continues at a label of the caller. If call and return are in one block, only that block is repeated.
    fn return_to(&mut self, target: TextPosition) {
        let resumed = self.reader.position().offset;
        if target.offset < resumed && self.frames.is_empty() {
            self.repeat_until = self.repeat_until.max(resumed);
        }
        self.reader.seek(target);
    }

    /// Returns to the caller, or repeats the called text.
    pub(super) fn leave(&mut self, label: Option<(&Block, i64)>) {
        let Some(frame) = self.frames.last_mut() else { return };
        if frame.remaining > 0 && label.is_none() {
            frame.remaining -= 1;
            let start = frame.start;
            self.macros.loops.clear();
            self.reader.seek(start);
            return;
        }
        self.check_contour_of_call();
        if !self.kept_modes.is_empty() {
            self.modes_at_return(self.frames.len());
        }
        let Some(frame) = self.frames.pop() else { return };
        self.reader = frame.reader;
        self.macros.loops = frame.loops;
        // Modal calls that the called program has cancelled stay cancelled.
        self.macros.active = frame.modal_calls.min(self.macros.modal_calls());
        self.macros.in_alias -= u32::from(frame.by_alias);
        if frame.own_locals {
            self.macros.store.leave();
            self.macros.names.leave();
        }
        self.program = frame.program;
        self.kernel.call = frame.path;
        let callee_file = self.file;
        self.file = self.program_at(self.program).file;
        if let Some((block, label)) = label {
            match self.label(self.program, label) {
                Some(position) => self.return_to(position),
                None => {
                    let here = std::mem::replace(&mut self.file, callee_file);
                    self.report_missing_label(block, b'P', &label.to_string());
                    self.file = here;
                    self.lost_jump = true;
                }
            }
        }
    }

    /// Reports that the text of a called program ends without a return, and returns.
    pub(super) fn text_ended_in_call(&mut self) {
        if self.frames.last().is_some_and(|frame| frame.of_shop) {
            return self.leave(None);
        }
        let subroutine = self.frames.last().is_some_and(|frame| frame.subroutine);
        let code = if subroutine { "M17" } else { "M99" };
        let span = self.kernel.origin.span;
        self.kernel.report(
            Diagnostic::new(
                Code::ProgramWithoutEnd,
                span,
                format!("the called program ends without {code}"),
            )
            .severity(Severity::Error)
            .label("the last block")
            .help(format!("put {code} at its end")),
        );
        self.leave(None);
    }

    /// True when a block is the head of the next subroutine, which ends the running one.
    pub(super) fn is_next_subroutine_head(&self, block: &Block) -> bool {
        self.frames.last().is_some_and(|frame| frame.subroutine)
            && subroutine_head(block).is_some_and(|n| self.subroutines.contains_key(&n))
    }

    pub(super) fn report_missing_label(&mut self, block: &Block, letter: u8, label: &str) {
        let span = self.words_span(block, Letters(1 << (letter - b'A')));
        self.kernel.report(
            Diagnostic::new(Code::MissingLabel, span, format!("no block has the number N{label}"))
                .help(format!("put N{label} before the block you mean")),
        );
    }

    /// The start of the block with an N number. The numbers of a program are read once.
    pub(super) fn label(&mut self, program: usize, label: i64) -> Option<TextPosition> {
        self.labels(program, label).first().copied()
    }

    /// The next block with an N number below an offset, else the first.
    pub(super) fn label_below(
        &mut self,
        program: usize,
        label: i64,
        below: u32,
    ) -> Option<TextPosition> {
        let places = self.labels(program, label);
        let next = places.partition_point(|place| place.offset <= below);
        places.get(next).or(places.first()).copied()
    }

    /// The last block with an N number above an offset.
    pub(super) fn label_above(
        &mut self,
        program: usize,
        label: i64,
        above: u32,
    ) -> Option<TextPosition> {
        let places = self.labels(program, label);
        let next = places.partition_point(|place| place.offset < above);
        places[..next].last().copied()
    }

    fn labels(&mut self, program: usize, label: i64) -> &[TextPosition] {
        let mut reader = self.reader_of(program);
        let table = self.control.table;
        let labels = self.labels.entry(program).or_insert_with(|| {
            let mut labels: HashMap<i64, Vec<TextPosition>> = HashMap::new();
            let mut block = Block::new();
            let mut is_data = false;
            loop {
                if !reader.read(&mut block) {
                    return labels;
                }
                // In a data line (after G10 L50), N is the number of a parameter.
                is_data = is_data && block.word(b'G').is_none() && block.word(b'M').is_none();
                let number = block.word(b'N').and_then(|word| word.number());
                if !is_data && let Some(number) = number.and_then(|n| n.to_integer()) {
                    let line = block.line;
                    let start = TextPosition { offset: block.range.start, line };
                    labels.entry(number).or_default().push(start);
                }
                is_data |= table.begins_data(&block);
            }
        });
        labels.get(&label).map_or(&[], Vec::as_slice)
    }
}

/// The number of the subroutine that begins with this block: `L100` alone is subroutine 1. `None` for other blocks.
pub fn subroutine_head(block: &Block) -> Option<u32> {
    if !block.letters().within(Letters::of("LN")) {
        return None;
    }
    let value = block.word(b'L')?.number()?.to_integer()?;
    let head = value >= 100 && value % 100 == 0;
    if head { u32::try_from(value / 100).ok() } else { None }
}
