//! Macro programs: words with expressions, statements, loops, calls, output.
//!
//! `words` puts numbers in the place of expressions; `statements` carries out what stands in a
//! macro statement; `flow` jumps and loops; `system` reads and writes system variables.

mod alarms;
mod assignments;
mod calls;
mod comments;
mod flow;
mod letters;
mod lines;
mod memory;
mod modal;
mod named;
mod output;
mod owords;
mod probe;
mod statements;
mod system;
mod unknown;
mod words;

use chordal_command::Position;
use chordal_dialect::macros::MacroRules;
use chordal_dialect::{Control, ControlTable};
use std::collections::{BTreeMap, BTreeSet, HashMap};

use chordal_diagnostics::{Code, Diagnostic, FileId, TextRange};
use chordal_machine::{AXES, Machine};
use chordal_syntax::{
    AssignTarget, BlockPosition as TextPosition, Expression, ExpressionParser, StackOp, Word,
};

pub(super) use memory::MacroMemory;
pub(super) use system::initial_references;

use super::Interpreter;

use crate::macros::evaluate::{EvaluationError, ValuePurpose, VariableReader, evaluate};
use crate::macros::names::NamedVariables;
use crate::macros::value::{MacroValue, Truth};
use crate::macros::variables::VariableStore;

/// What depends on a condition.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum ConditionOf {
    /// IF.
    Branch,
    /// WHILE: it is met again after each pass.
    Loop,
}

/// The ENDs of a text between two places.
#[derive(Debug, Default)]
struct LoopEnds {
    /// From here on they were looked for; `None`: not yet.
    from: Option<u32>,
    /// Here the search goes on; `None`: at the end.
    next: Option<TextPosition>,
    /// Where each begins, its number, and where the block behind it begins; in order.
    found: Vec<(u32, u32, TextPosition)>,
}

/// What a run keeps for its macro statements.
pub(super) struct MacroState<'a> {
    /// Reads statements and expressions; taken out while its steps are carried out.
    parser: ExpressionParser<'a>,
    stack: Vec<MacroValue>,
    words: Vec<Word>,
    pub(super) store: VariableStore,
    /// Values of system variables that the program or the machine file gives.
    pub(super) kept: BTreeMap<u32, f64>,
    /// Loops that run in this program, outermost first.
    pub(super) loops: Vec<ActiveLoop>,
    /// The ENDs of each program of each file, as far as they were looked for.
    loop_ends: HashMap<(FileId, usize), LoopEnds>,
    /// Places of which a problem was told: a loop would tell it again and again.
    reported: BTreeSet<(FileId, u32, Code)>,
    /// A macro statement was carried out: what comes is no longer the text alone.
    pub(super) used: bool,
    /// Modal calls, the first one first.
    modal: Vec<calls::ModalCall>,
    /// How many of them are in force here.
    pub(super) active: usize,
    /// Running programs that were called by a code that a setting makes a call.
    pub(super) in_alias: u32,
    /// The words of the last such call.
    last_words: [Option<f64>; 26],
    /// Where the last skip move stopped, as #5061 shows it: mm, rad.
    skip: Position,
    /// POPEN.
    port_open: bool,
    /// Bytes printed.
    printed: usize,
    /// Named variables.
    pub(super) names: NamedVariables,
    /// O words.
    owords: owords::OWords,
    /// Macro lines.
    lines: lines::MacroLineState,
    /// Probe moves.
    pub(super) probe: probe::ProbeResults,
    /// Values that the run met and nobody knows.
    pub(super) unknown: unknown::UnknownValues,
}

/// A loop that runs.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct ActiveLoop {
    /// n of DOn.
    number: u32,
    /// Its first block.
    head: TextPosition,
}

impl MacroState<'_> {
    pub fn new(table: &ControlTable, machine: &Machine) -> Self {
        let mut store = VariableStore::new(table.macros);
        let mut kept = BTreeMap::new();
        for (&number, &value) in &machine.macros.variables {
            if store.write(number, MacroValue::Number(value)).is_err() {
                kept.insert(number, value);
            }
        }
        for &number in &machine.macros.vacant {
            let _ = store.write(number, MacroValue::Vacant);
        }
        MacroState {
            parser: ExpressionParser::new(&[], FileId(0), table.lexicon.grammar),
            stack: Vec::new(),
            words: Vec::new(),
            store,
            kept,
            loops: Vec::new(),
            loop_ends: HashMap::new(),
            reported: BTreeSet::new(),
            used: false,
            modal: Vec::new(),
            active: 0,
            in_alias: 0,
            last_words: [None; 26],
            skip: [0.0; AXES],
            port_open: false,
            printed: 0,
            names: NamedVariables::default(),
            owords: owords::OWords::default(),
            lines: lines::MacroLineState::default(),
            probe: probe::ProbeResults::default(),
            unknown: unknown::UnknownValues::default(),
        }
    }
}

impl<'a> Interpreter<'a> {
    pub(super) fn rules(&self) -> &'a MacroRules {
        let control: &'a Control = self.control;
        &control.macros
    }

    /// Takes the parser out, so that its steps can be carried out; to be given back.
    fn take_parser(&mut self) -> ExpressionParser<'a> {
        let grammar = self.control.table.lexicon.grammar;
        std::mem::replace(&mut self.macros.parser, ExpressionParser::new(&[], self.file, grammar))
    }

    /// The value of an expression; `None` when it has none, which is told.
    fn value_of(
        &mut self,
        parser: &ExpressionParser<'a>,
        expression: Expression,
        purpose: ValuePurpose,
    ) -> Option<MacroValue> {
        let mut stack = std::mem::take(&mut self.macros.stack);
        let rules = self.rules();
        let result = evaluate(parser.steps(expression), rules, purpose, &mut stack, self);
        self.macros.stack = stack;
        result.map_err(|fault| self.report_fault(fault)).ok()
    }

    /// The value of an expression as a number, where vacant counts as zero. `None` when it has none or when
    /// nobody knows it; both are told, the latter with what the value is for: "N of GOTO".
    fn number_of(
        &mut self,
        parser: &ExpressionParser<'a>,
        expression: Expression,
        purpose: ValuePurpose,
        what: &str,
    ) -> Option<f64> {
        match self.value_of(parser, expression, purpose)?.counted() {
            Ok(number) => Some(number),
            Err(cause) => {
                self.lose_path_by(expression.range, what, cause);
                None
            }
        }
    }

    /// Whether a condition holds. One that depends on an unknown value is assumed.
    fn holds(
        &mut self,
        parser: &ExpressionParser<'a>,
        condition: Expression,
        of: ConditionOf,
    ) -> bool {
        let Some(value) = self.value_of(parser, condition, ValuePurpose::CONDITION) else {
            return false;
        };
        self.is_true(value, condition.range, of)
    }

    /// The same of a value that is there already.
    fn is_true(&mut self, value: MacroValue, range: TextRange, of: ConditionOf) -> bool {
        match Truth::from(value) {
            Truth::Holds => true,
            Truth::Fails => false,
            Truth::Unknown(cause) => self.assume(range, cause, of),
        }
    }

    /// Writes a variable.
    fn assign(&mut self, parser: &ExpressionParser<'a>, target: &AssignTarget, value: MacroValue) {
        let index = match target.kind {
            StackOp::ReadNamed(_) => 0.0,
            _ => {
                let what = "the number of the variable that is written";
                let Some(index) = self.number_of(parser, target.index, ValuePurpose::VALUE, what)
                else {
                    return;
                };
                index
            }
        };
        if let Err(fault) = self.write_target(target.kind, index, value, target.range) {
            self.report_fault(fault);
        }
    }

    fn write_target(
        &mut self,
        kind: StackOp,
        index: f64,
        value: MacroValue,
        range: TextRange,
    ) -> Result<(), EvaluationError> {
        match kind {
            StackOp::Read => self.write_number(index, value, range),
            StackOp::ReadNamed(name) => self.write_named(name, value, range),
            StackOp::Letters(letters) => self.write_letters(letters, index, value, range),
            _ => Ok(()),
        }
    }

    fn report_fault(&mut self, fault: EvaluationError) {
        if fault.is_reported() {
            return;
        }
        let diagnostic = Diagnostic::new(fault.code, self.span(fault.range), fault.message);
        let diagnostic =
            if fault.help.is_empty() { diagnostic } else { diagnostic.help(fault.help) };
        self.report_once(diagnostic);
    }

    /// Reports a problem the first time that its place shows one.
    pub(super) fn report_once(&mut self, diagnostic: Diagnostic) {
        let span = diagnostic.primary.span;
        if self.macros.reported.insert((span.file, span.range.start, diagnostic.code)) {
            self.kernel.report(diagnostic);
        }
    }

    fn report_problems(&mut self, parser: &mut ExpressionParser<'a>) {
        for problem in std::mem::take(&mut parser.problems) {
            self.report_once(problem);
        }
    }

    /// The whole number of a variable, where the value is near enough to one.
    fn variable_number(&self, number: f64, range: TextRange) -> Result<u32, EvaluationError> {
        let whole = libm::round(number);
        let near = (number - whole).abs() <= self.rules().index_tolerance;
        if near && (0.0..=9_999_999.0).contains(&whole) {
            return Ok(whole as u32);
        }
        Err(system::no_variable(number, range))
    }
}

impl VariableReader for Interpreter<'_> {
    fn read(&mut self, number: f64, range: TextRange) -> Result<MacroValue, EvaluationError> {
        let number = self.variable_number(number, range)?;
        let value = match self.macros.store.read(number) {
            Ok(value) => value,
            Err(_) => self.read_system(number, range)?,
        };
        self.note_unknown(value, range);
        Ok(value)
    }

    fn read_named(
        &mut self,
        name: TextRange,
        range: TextRange,
    ) -> Result<MacroValue, EvaluationError> {
        self.named(name, range)
    }

    fn is_set(&mut self, name: TextRange) -> bool {
        self.is_named(name)
    }

    fn read_letters(
        &mut self,
        letters: u8,
        number: f64,
        range: TextRange,
    ) -> Result<MacroValue, EvaluationError> {
        let value = self.letter_variable(letters, number, range)?;
        self.note_unknown(value, range);
        Ok(value)
    }

    fn radians(&self) -> bool {
        self.macros.lines.radians
    }
}

impl Interpreter<'_> {
    fn write_number(
        &mut self,
        number: f64,
        value: MacroValue,
        range: TextRange,
    ) -> Result<(), EvaluationError> {
        let number = self.variable_number(number, range)?;
        if number == 0 {
            return Err(system::read_only(number, range));
        }
        match self.macros.store.write(number, value) {
            Ok(()) => Ok(()),
            Err(_) => self.write_system(number, value, range),
        }
    }
}
