//! Macro lines: one statement after `#`, similar to BASIC (Fadal manual, section 18).

use chordal_command::{CallPath, CommandKind};
use chordal_dialect::macros::MAX_MACRO_LINE_CHARS;
use std::collections::{BTreeMap, BTreeSet, HashMap};

use chordal_diagnostics::{Code, Diagnostic, Severity, TextRange};
use chordal_syntax::{
    AssignTarget, Block, BlockKind, BlockPosition as TextPosition, ExpressionParser, LineStatement,
    PrintItem, StackOp, Word, WordValue as Written, parse_line_statement,
};

use super::super::literals::trim;
use super::super::{BlockFlow, EndReason, Interpreter};
use super::ConditionOf;
use crate::macros::evaluate::ValuePurpose;
use crate::macros::names::normalized;
use crate::macros::value::MacroValue;

/// Largest number of decimals of RND.
const MAX_PLACES: f64 = 5.0;

/// Smallest number that is not zero; smaller ones are out of range.
const SMALLEST_NUMBER: f64 = 1e-4;

/// Numbers from here on have too many digits.
const NUMBER_LIMIT: f64 = 1e12;

/// Largest number of programs that a run starts by START.
const MAX_STARTS: u32 = 1000;

/// Decimals that PRINT shows.
const PRINTED_DECIMALS: usize = 4;

/// The state of macro lines.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct MacroLineState {
    /// V1, V2, …; empty before the first is written. `None`: the unknown value from before the program.
    pub variables: Vec<Option<MacroValue>>,
    /// Variables of the machine that the program wrote, by name and number.
    pub written: BTreeMap<(u8, u32), MacroValue>,
    /// SET RADIANS.
    pub radians: bool,
    /// SET RND.
    places: u8,
    /// Text that PRINT keeps for the next PRINT.
    pending_print: String,
    /// Number of answers to INPUT that were used.
    answered: usize,
    /// Labels of each program.
    labels: HashMap<usize, HashMap<String, TextPosition>>,
    /// Programs that START has left.
    left: BTreeSet<usize>,
    /// Number of STARTs so far.
    starts: u32,
}

impl MacroLineState {
    /// The part to store in a checkpoint: all except labels, which are found again in the text.
    pub fn lasting(&self) -> MacroLineState {
        MacroLineState {
            variables: self.variables.clone(),
            written: self.written.clone(),
            pending_print: self.pending_print.clone(),
            labels: HashMap::new(),
            left: self.left.clone(),
            ..*self
        }
    }

    /// True when no text waits for the next PRINT and no program was left.
    pub fn is_settled(&self) -> bool {
        self.pending_print.is_empty() && self.left.is_empty() && self.starts == 0
    }
}

impl<'a> Interpreter<'a> {
    /// Carries out a block with a macro line.
    pub(in super::super) fn macro_line(
        &mut self,
        block: &mut Block,
        range: TextRange,
    ) -> BlockFlow {
        self.carried_out = true;
        self.macros.used = true;
        if let Some(number) = block.word(b'N').and_then(|word| word.number()) {
            self.sequence = Some(number);
        }
        if block.words.iter().any(|word| word.letter != b'N') {
            self.check_mixed(block, range);
            if let end @ BlockFlow::End(_) = self.carry_out(block) {
                return end;
            }
        }
        let length = range.slice(self.reader.text()).len();
        if length > MAX_MACRO_LINE_CHARS {
            self.report_length(range, length);
        }
        let mut parser = self.take_parser();
        let following = TextRange::new(range.start + 1, range.end);
        parser.start(self.reader.text(), self.file, following);
        let mut flow = BlockFlow::Next;
        loop {
            let statement = parse_line_statement(&mut parser);
            let sound = parser.problems.is_empty();
            self.report_problems(&mut parser);
            if !sound {
                break;
            }
            if let LineStatement::If(condition) = statement {
                let purpose = ValuePurpose { condition: true, ..self.line_purpose() };
                let value = self.value_of(&parser, condition, purpose);
                if value
                    .is_some_and(|value| self.is_true(value, condition.range, ConditionOf::Branch))
                {
                    continue;
                }
                break;
            }
            flow = self.line_statement(range, &parser, statement);
            break;
        }
        self.macros.parser = parser;
        flow
    }

    fn report_length(&mut self, range: TextRange, length: usize) {
        self.report_once(
            Diagnostic::new(
                Code::MacroLineTooLong,
                self.span(range),
                format!("this macro line has {length} characters; the control reads {MAX_MACRO_LINE_CHARS}"),
            )
            .help("compute a part of it in a line before it"),
        );
    }

    fn line_purpose(&self) -> ValuePurpose {
        ValuePurpose { round_digits: Some(self.macros.lines.places), condition: false }
    }

    /// The value of an expression; one outside the limits of the control is reported.
    fn line_value(
        &mut self,
        parser: &ExpressionParser<'a>,
        expression: chordal_syntax::Expression,
    ) -> Option<MacroValue> {
        let value = match self.value_of(parser, expression, self.line_purpose())?.counted() {
            Ok(value) => value,
            Err(cause) => return Some(MacroValue::Unknown(cause)),
        };
        let size = value.abs();
        if size < NUMBER_LIMIT && (size >= SMALLEST_NUMBER || size == 0.0) {
            return Some(MacroValue::Number(value));
        }
        let shown = if size < 1.0 { format!("{value:.3e}") } else { format!("{value}") };
        let what = if size < 1.0 { "nearer to zero than 0.0001" } else { "too large" };
        self.report_once(
            Diagnostic::new(
                Code::NumberOutOfRange,
                self.span(expression.range),
                format!("the result is {shown}, which is {what} for the control"),
            )
            .help("round it with RND, or test it with IF before"),
        );
        Some(MacroValue::Number(value))
    }

    fn line_statement(
        &mut self,
        range: TextRange,
        parser: &ExpressionParser<'a>,
        statement: LineStatement,
    ) -> BlockFlow {
        match statement {
            LineStatement::Assign { target, value } => {
                if let Some(value) = self.line_value(parser, value) {
                    self.assign(parser, &target, value);
                }
            }
            LineStatement::GotoLabel(label) => return self.goto_label(label),
            LineStatement::GotoNumber(number) => {
                let number = self.label_of(parser, number);
                return self.goto(range, number);
            }
            LineStatement::Start(number) => {
                return match self.line_value(parser, number).map(MacroValue::counted) {
                    Some(Ok(value)) => self.start_program(number.range, value),
                    Some(Err(cause)) => {
                        self.lose_path_by(number.range, "the program that START means", cause);
                        BlockFlow::Next
                    }
                    None => BlockFlow::Next,
                };
            }
            LineStatement::Print { items, holds } => self.print_items(parser, range, &items, holds),
            LineStatement::Input(targets) => self.input(parser, range, &targets),
            LineStatement::Clear(ranges) => {
                for (first, last) in ranges {
                    self.clear(parser, &first, &last);
                }
            }
            LineStatement::SetRadians(radians) => self.macros.lines.radians = radians,
            LineStatement::SetPlaces(places) => {
                if let Some(places) = self.line_value(parser, places).and_then(MacroValue::known) {
                    self.macros.lines.places = libm::round(places).clamp(0.0, MAX_PLACES) as u8;
                }
            }
            LineStatement::Empty
            | LineStatement::Label(_)
            | LineStatement::If(_)
            | LineStatement::Unknown(_) => {}
        }
        BlockFlow::Next
    }

    /// GOTO :LABEL.
    fn goto_label(&mut self, label: TextRange) -> BlockFlow {
        let name = normalized(label.slice(self.reader.text()));
        let program = self.program;
        self.look_at(program);
        if !self.macros.lines.labels.contains_key(&program) {
            let labels = self.find_labels(program);
            self.macros.lines.labels.insert(program, labels);
        }
        let labels = self.macros.lines.labels.get(&program);
        if let Some(target) = labels.and_then(|labels| labels.get(&name)).copied() {
            self.go_to(target);
            return BlockFlow::Next;
        }
        let shown = name.to_uppercase();
        self.kernel.report(
            Diagnostic::new(
                Code::MissingLabel,
                self.span(label),
                format!("there is no label `:{shown}` in this program"),
            )
            .help(format!("write `#:{shown}` on a line of its own where it is meant")),
        );
        BlockFlow::End(EndReason::LostJump)
    }

    /// The labels of a program; the first of a name counts.
    fn find_labels(&self, program: usize) -> HashMap<String, TextPosition> {
        let mut reader = self.reader_of(program);
        let mut labels = HashMap::new();
        let mut block = Block::new();
        while reader.read(&mut block) {
            let BlockKind::Macro(range) = block.kind else { continue };
            let line = range.slice(reader.text());
            let shown = |b: &&u8| !matches!(b, b'#' | b' ' | b'\t');
            if line.iter().find(shown) != Some(&b':') {
                continue;
            }
            let from = line.iter().position(|b| *b == b':').map_or(0, |at| at + 1);
            let named = |b: &&u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b' ' | b'\t');
            let name: Vec<u8> = line[from..].iter().take_while(named).copied().collect();
            let start = TextPosition { offset: block.range.start, line: block.line };
            labels.entry(normalized(&name)).or_insert(start);
        }
        labels
    }

    /// START: continues with another program, without a return.
    fn start_program(&mut self, range: TextRange, number: f64) -> BlockFlow {
        let number = libm::round(number).clamp(0.0, 99_999.0) as u32;
        let Some(program) = self.library.find(number, self.file) else {
            let word =
                Word { letter: b'O', register: None, comma: false, value: Written::Missing, range };
            self.report_missing_program(&word, number);
            return BlockFlow::End(EndReason::LostJump);
        };
        self.macros.lines.starts += 1;
        if self.macros.lines.starts > MAX_STARTS {
            self.kernel.report(
                Diagnostic::new(
                    Code::BudgetReached,
                    self.span(range),
                    format!("stopped after {MAX_STARTS} starts of programs"),
                )
                .help("the programs start each other without end"),
            );
            return BlockFlow::End(EndReason::Budget);
        }
        self.macros.lines.left.insert(self.program);
        if self.macros.lines.left.contains(&program) {
            // The program was started before: every block from here on counts as repeated.
            self.repeat_until = u32::MAX;
        }
        self.frames.clear();
        self.kernel.call = CallPath::default();
        self.macros.active = 0;
        self.program = program;
        self.file = self.program_at(program).file;
        self.reader = self.reader_of(program);
        self.carried_out = false;
        self.subroutines.clear();
        self.read_subroutine_section();
        BlockFlow::Next
    }

    fn print_items(
        &mut self,
        parser: &ExpressionParser<'a>,
        range: TextRange,
        items: &[PrintItem],
        holds: bool,
    ) {
        let mut line = std::mem::take(&mut self.macros.lines.pending_print);
        for item in items {
            match item {
                PrintItem::Text(text) => {
                    line += &String::from_utf8_lossy(text.slice(self.reader.text()));
                }
                PrintItem::Value(value) => {
                    if let Some(value) = self.value_of(parser, *value, self.line_purpose()) {
                        let shown = value.known().map(|value| trim(value, PRINTED_DECIMALS));
                        line += shown.as_deref().unwrap_or("?");
                    }
                }
            }
        }
        const MAX_PENDING_PRINT_BYTES: usize = 4096;
        if holds && line.len() < MAX_PENDING_PRINT_BYTES {
            self.macros.lines.pending_print = line;
        } else {
            self.print_text(range, line);
        }
    }

    /// At the end of the program: prints text that waits for another PRINT.
    pub(in super::super) fn print_pending(&mut self) {
        let pending = std::mem::take(&mut self.macros.lines.pending_print);
        if !pending.is_empty() {
            self.kernel.emit(CommandKind::Output { text: pending });
        }
    }

    /// INPUT: uses the next answer of the machine file.
    fn input(&mut self, parser: &ExpressionParser<'a>, range: TextRange, targets: &[AssignTarget]) {
        for target in targets {
            let answer = self.machine.macros.inputs.get(self.macros.lines.answered).copied();
            self.macros.lines.answered += 1;
            if answer.is_none() {
                let name = String::from_utf8_lossy(target.range.slice(self.reader.text()));
                let message = format!("the program asks for {name}, and no answer is given");
                let count = self.machine.macros.inputs.len();
                let note = format!("the machine file has {count} answers; 0 is used");
                self.report_once(
                    Diagnostic::new(Code::InputNotAnswered, self.span(range), message)
                        .label("the operator would type a number here")
                        .note(note)
                        .help("give the answers in the machine file: `[macros] inputs = [1.5, 2]`"),
                );
            }
            self.assign(parser, target, MacroValue::Number(answer.unwrap_or(0.0)));
        }
        self.kernel.emit(CommandKind::Stop { optional: false });
    }

    /// CLEAR V3-V7.
    fn clear(&mut self, parser: &ExpressionParser<'a>, first: &AssignTarget, last: &AssignTarget) {
        let index = |run: &mut Self, target: &AssignTarget| {
            let what = "the number of a variable that is cleared";
            let value = run.number_of(parser, target.index, run.line_purpose(), what);
            value.map(|value| libm::round(value).clamp(0.0, 1e6) as u32)
        };
        let (Some(from), Some(to)) = (index(self, first), index(self, last)) else { return };
        let same =
            matches!((first.kind, last.kind), (StackOp::Letters(a), StackOp::Letters(b)) if a == b);
        if !same || from > to {
            self.report_once(
                Diagnostic::new(
                    Code::BadVariable,
                    self.span(first.range.cover(last.range)),
                    "these are not the first and the last of a range of variables",
                )
                .severity(Severity::Error)
                .help("write the lower number first: `CLEAR V3-V7`"),
            );
            return;
        }
        // The first number that does not exist is reported and ends the range.
        for number in from..=to {
            let zero = MacroValue::Number(0.0);
            let written = self.write_target(first.kind, f64::from(number), zero, first.range);
            if let Err(fault) = written {
                return self.report_fault(fault);
            }
        }
    }
}
