//! Labels, calls, repeats, jumps, and the ends of programs.

use chordal_diagnostics::{Code, Diagnostic, Severity, TextRange};
use chordal_kernel::{EndReason, ProgramName};

use super::interpreter::KlartextInterpreter;
use super::program_texts::{blocks_with, called_name, file_stem, program_word};
use super::run_state::{KlartextFlow, ReturnPlace};
use crate::alarms::{LABEL_NOT_FOUND, LABEL_ZERO, NESTING};
use crate::syntax::{
    JumpComparison, JumpCondition, KlartextLabel, KlartextStatement, LineReader, ParameterBank,
    ParameterName, WordOperand, block_of_lines, contains_ignoring_case,
};

/// How often a condition with a value that is not known is taken as not fulfilled before it is taken as fulfilled.
const MAX_UNFULFILLED: u32 = 100;

/// The largest number of a label.
const MAX_LABEL: u32 = 65_535;

impl KlartextInterpreter<'_> {
    /// Finds the labels of the running program, and reports those that stand twice.
    pub(super) fn find_labels(&mut self) {
        let text = self.text();
        let mut lines = LineReader::new(text);
        let word: &[u8] = if lines.is_iso() { b"G98" } else { b"LBL" };
        loop {
            lines.pass_blocks_without(word);
            let Some(block) = lines.next() else { break };
            let has_label =
                block.parts.iter().any(|part| contains_ignoring_case(part.slice(text), word));
            if !has_label {
                continue;
            }
            let KlartextStatement::Label(name) = block_of_lines(text, &block).statement else {
                continue;
            };
            if name == KlartextLabel::Number(0) {
                continue;
            }
            if let KlartextLabel::Number(number) = name
                && number > MAX_LABEL
            {
                let message = format!("label {number} is above {MAX_LABEL}");
                self.problem(Code::BadWordValue, block.range, message);
            }
            let place = (lines.offset(), lines.line());
            if let Some(first) = self.running().labels.get(&name).copied() {
                let shown = shown_label(&name);
                self.report_double_label(block.range, &shown, first.1.saturating_sub(1));
                continue;
            }
            self.running().labels.insert(name, place);
        }
    }

    /// BEGIN PGM and END PGM: both must be there, with the same name and unit.
    pub(super) fn check_frame_of_program(&mut self) {
        let text = self.text();
        let program = self.running().program;
        let end =
            blocks_with(text, program_word(text, b"END")).find_map(|block| match block.statement {
                KlartextStatement::End { name, is_inch } => Some((block.range, name, is_inch)),
                _ => None,
            });
        let Some(head) = self.programs.texts[program].head.clone() else { return };
        let Some((range, name, is_inch)) = end else {
            let last = LineReader::new(text).last().map_or(head.range, |block| block.range);
            let unit = if head.is_inch { "G70" } else { "G71" };
            let (line, written) = match LineReader::new(text).is_iso() {
                true => ("its last line", format!("N99999999 %{} {unit} *", head.name)),
                false => ("END PGM", format!("END PGM {}", head.name)),
            };
            let message = format!("{line} is missing: the program may be cut off");
            let diagnostic = Diagnostic::new(Code::ProgramWithoutEnd, self.span(last), message);
            let help = format!("write {written} after the last block");
            return self.kernel.report(diagnostic.help(help));
        };
        let end_name = String::from_utf8_lossy(name.slice(text)).into_owned();
        if !end_name.eq_ignore_ascii_case(&head.name) {
            let message = format!("END PGM {end_name} ends a program that began as {}", head.name);
            let diagnostic = Diagnostic::new(Code::HeaderOutOfPlace, self.span(range), message);
            self.kernel.report(diagnostic.help("write the same name into both lines"));
        } else if is_inch != head.is_inch {
            let shown = |is_inch| if is_inch { "INCH" } else { "MM" };
            let message = format!(
                "END PGM says {}, and BEGIN PGM says {}: lengths are read in the latter",
                shown(is_inch),
                shown(head.is_inch)
            );
            self.problem(Code::HeaderOutOfPlace, range, message);
        }
    }

    /// LBL: 0 ends an open subprogram.
    pub(super) fn label(&mut self, name: &KlartextLabel) -> KlartextFlow {
        if *name == KlartextLabel::Number(0)
            && let Some(place) = self.running().returns.pop()
        {
            self.running().call = place.call;
            self.running().last_number = None;
            self.running().reader.seek(place.place.0, place.place.1);
        }
        KlartextFlow::Next
    }

    /// The label that a word names, with the value of a parameter; `None` if that is reported.
    fn resolved_label(&mut self, label: &KlartextLabel, range: TextRange) -> Option<KlartextLabel> {
        let KlartextLabel::Parameter(name) = label else { return Some(label.clone()) };
        if name.bank == ParameterBank::Text {
            let text = self.parameters.text(name.number).map(str::to_string);
            if text.is_none() {
                self.report_unset(range, *name);
            }
            return text.map(KlartextLabel::Text);
        }
        let operand = WordOperand::Parameter { is_negative: false, name: *name };
        let value = self.operand(operand, range)?;
        Some(KlartextLabel::Number(value.round().max(0.0) as u32))
    }

    /// The place of a label; a label that is not there is reported.
    pub(super) fn label_place(
        &mut self,
        label: &KlartextLabel,
        range: TextRange,
    ) -> Option<(u32, u32)> {
        let label = self.resolved_label(label, range)?;
        if label == KlartextLabel::Number(0) {
            let message = "label 0 ends subprograms and is not called";
            self.alarm(LABEL_ZERO, Code::CallNotAllowed, range, message);
            return None;
        }
        let place = self.running().labels.get(&label).copied();
        if place.is_none() {
            let help = "write LBL with this name at the start of the part, or correct the call";
            self.report_missing_label(&label, range, help);
        }
        place
    }

    /// Reports a label that the program does not have.
    pub(super) fn report_missing_label(
        &mut self,
        label: &KlartextLabel,
        range: TextRange,
        help: &str,
    ) {
        let message = format!("the program has no label {}", shown_label(label));
        let diagnostic = Diagnostic::new(Code::MissingLabel, self.span(range), message);
        self.report_alarm(LABEL_NOT_FOUND, diagnostic.help(help));
    }

    /// CALL LBL: a subprogram, or with REP a repeat of the part before.
    pub(super) fn call_label(
        &mut self,
        label: &KlartextLabel,
        repeats: Option<WordOperand>,
    ) -> KlartextFlow {
        let range = self.here;
        let Some(place) = self.label_place(label, range) else {
            return KlartextFlow::End(EndReason::LostJump);
        };
        if let Some(repeats) = repeats {
            let count = self.operand(repeats, range).unwrap_or(0.0).round();
            if count < 0.0 {
                let message = format!("REP is {count}: a part is repeated 0 times or more");
                self.problem(Code::BadWordValue, range, message);
            }
            let count = count.max(0.0);
            return self.repeat(place, count.min(f64::from(u32::MAX)) as u32);
        }
        let depth: usize = self.stack.iter().map(|running| running.returns.len()).sum();
        if depth >= self.programs.settings.label_nesting as usize {
            let message = format!("this call would be the {}th inside each other", depth + 1);
            let diagnostic = Diagnostic::new(Code::NestingTooDeep, self.span(range), message)
                .label(format!("at most {}", self.programs.settings.label_nesting))
                .help("check whether the subprogram calls itself");
            self.report_alarm(NESTING, diagnostic);
            return KlartextFlow::End(EndReason::Alarm);
        }
        let span = self.span(range);
        let call = self.running().call;
        let inner = self.kernel.calls.enter(call, span);
        let running = self.running();
        let back = (running.reader.offset(), running.reader.line());
        running.returns.push(ReturnPlace { place: back, call });
        running.call = inner;
        self.go_to(place);
        KlartextFlow::Next
    }

    fn repeat(&mut self, place: (u32, u32), count: u32) -> KlartextFlow {
        let block = self.here.start;
        let repeats = &mut self.running().repeats;
        let left = repeats.entry(block).or_insert(count);
        if *left == 0 {
            repeats.remove(&block);
            return KlartextFlow::Next;
        }
        *left -= 1;
        self.go_to(place);
        KlartextFlow::Next
    }

    /// Goes on at a block of the running program.
    fn go_to(&mut self, place: (u32, u32)) {
        if place.0 <= self.here.start {
            self.modes.has_jumped_back = true;
        }
        let running = self.running();
        running.last_number = None;
        running.reader.seek(place.0, place.1);
    }

    /// FN 9 to FN 12.
    pub(super) fn jump(
        &mut self,
        condition: &JumpCondition,
        label: &KlartextLabel,
    ) -> KlartextFlow {
        let range = self.here;
        let holds = match (self.unknown_of(condition), condition) {
            (Some(name), _) => self.assume_condition(name),
            (None, JumpCondition::Defined(name, is_defined)) => {
                self.parameters.is_set(*name) == *is_defined
            }
            (None, JumpCondition::Compared(first, comparison, second)) => {
                let (Some(first), Some(second)) =
                    (self.operand(*first, range), self.operand(*second, range))
                else {
                    return KlartextFlow::Next;
                };
                match comparison {
                    JumpComparison::Equal => first == second,
                    JumpComparison::NotEqual => first != second,
                    JumpComparison::Greater => first > second,
                    JumpComparison::Less => first < second,
                }
            }
        };
        if !holds {
            return KlartextFlow::Next;
        }
        match self.label_place(label, range) {
            Some(place) => {
                self.go_to(place);
                KlartextFlow::Next
            }
            None => KlartextFlow::End(EndReason::LostJump),
        }
    }

    /// The parameter of a condition whose value is not known here.
    fn unknown_of(&self, condition: &JumpCondition) -> Option<ParameterName> {
        let name_of = |operand: &WordOperand| match operand {
            WordOperand::Parameter { name, .. } => Some(*name),
            WordOperand::Number(_) => None,
        };
        let names = match condition {
            JumpCondition::Defined(name, _) => [Some(*name), None],
            JumpCondition::Compared(first, _, second) => [name_of(first), name_of(second)],
        };
        names.into_iter().flatten().find(|name| self.parameters.is_unknown(*name))
    }

    /// Assumes a condition that depends on a value that is not known here: not fulfilled, until it was met so often
    /// that only its fulfilment can end a loop.
    fn assume_condition(&mut self, name: ParameterName) -> bool {
        let range = self.here;
        let times = self.modes.assumed_conditions.entry((self.file(), range.start)).or_insert(0);
        *times += 1;
        let is_fulfilled = *times > MAX_UNFULFILLED;
        if self.is_first_report(&format!("condition at {}", range.start)) {
            let message = format!(
                "this depends on {name}, which is not known here: it is taken as not fulfilled"
            );
            let diagnostic = Diagnostic::new(Code::AssumedBranch, self.span(range), message)
                .label("from here on the path is assumed")
                .help("assign it at the start of the program to prove what follows");
            self.kernel.report(diagnostic);
        }
        is_fulfilled
    }

    /// CALL PGM.
    pub(super) fn call_program(&mut self, name: TextRange) -> KlartextFlow {
        let name = called_name(self.text(), name);
        self.call_named_program(&name)
    }

    /// Calls a program by its name, with or without folder and extension.
    pub(super) fn call_named_program(&mut self, name: &str) -> KlartextFlow {
        let range = self.here;
        let Some(program) = self.programs.find_name(name) else {
            self.missing.push(ProgramName::from(file_stem(name)));
            let message = format!("there is no program {name}");
            let diagnostic = Diagnostic::new(Code::MissingSubprogram, self.span(range), message);
            let help = "put the program next to this one; what it moves is missing here";
            self.kernel.report(diagnostic.help(help));
            return KlartextFlow::Next;
        };
        if self.stack.len() > self.programs.settings.label_nesting as usize {
            let message = format!("{} programs call each other", self.stack.len());
            self.alarm(NESTING, Code::NestingTooDeep, range, message);
            return KlartextFlow::End(EndReason::Alarm);
        }
        let span = self.span(range);
        let call = self.running().call;
        let inner = self.kernel.calls.enter(call, span);
        self.begin_program(program, inner);
        KlartextFlow::Next
    }

    /// END PGM or the end of the text: back to the calling program, or the end of the run.
    pub(super) fn program_ends(&mut self) -> KlartextFlow {
        self.check_open_subprograms();
        if self.stack.len() > 1
            && let Some(ended) = self.stack.pop()
        {
            self.parameters.restore_locals(ended.callers_locals);
            self.set_unit(ended.caller_is_inch);
            return KlartextFlow::Next;
        }
        KlartextFlow::End(EndReason::EndOfText)
    }

    /// A subprogram that is still open where its program ends.
    fn check_open_subprograms(&mut self) {
        let range = self.here;
        if self.running().returns.pop().is_some() {
            self.running().returns.clear();
            let message = "the program ends inside a called subprogram: its LBL 0 is missing";
            let diagnostic = Diagnostic::new(Code::ProgramWithoutEnd, self.span(range), message);
            let help = "write LBL 0 at the end of the subprogram";
            self.kernel.report(diagnostic.severity(Severity::Error).help(help));
        }
    }
}

/// A label as it is written.
fn shown_label(label: &KlartextLabel) -> String {
    match label {
        KlartextLabel::Number(number) => number.to_string(),
        KlartextLabel::Text(text) => format!("\"{text}\""),
        KlartextLabel::Parameter(name) => name.to_string(),
    }
}
