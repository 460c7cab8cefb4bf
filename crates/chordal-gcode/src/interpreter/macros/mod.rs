//! Macro programs: words with expressions, statements, loops, calls, output.
//!
//! `words` replaces expressions by numbers; `statements` carries out macro statements; `flow` jumps and loops;
//! `system` reads and writes system variables.

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

/// The kind of statement that has a condition.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum ConditionOf {
    /// IF.
    Branch,
    /// WHILE: evaluated again after each pass.
    Loop,
}

/// The END statements found in a part of a text.
#[derive(Debug, Default)]
struct LoopEnds {
    /// Start of the searched part; `None` before a search.
    from: Option<u32>,
    /// Where the search continues; `None` at the end of the text.
    next: Option<TextPosition>,
    /// Offset and number of each END, and the start of the block after it; sorted.
    found: Vec<(u32, u32, TextPosition)>,
}

/// The state of a run's macro statements.
pub(super) struct MacroState<'a> {
    /// Reads statements and expressions; taken out of the state while its steps are evaluated.
    parser: ExpressionParser<'a>,
    stack: Vec<MacroValue>,
    words: Vec<Word>,
    pub(super) store: VariableStore,
    /// Values of system variables that the program or the machine file gives.
    pub(super) kept: BTreeMap<u32, f64>,
    /// Loops that run in this program, outermost first.
    pub(super) loops: Vec<ActiveLoop>,
    /// The END statements of each program of each file, as far as searched.
    loop_ends: HashMap<(FileId, usize), LoopEnds>,
    /// Positions and codes of reported problems, so that a loop does not repeat them.
    reported: BTreeSet<(FileId, u32, Code)>,
    /// A macro statement was carried out: the run no longer depends on the text alone.
    pub(super) used: bool,
    /// Modal calls, in the order they were started.
    modal: Vec<calls::ModalCall>,
    /// How many of them are active here.
    pub(super) active: usize,
    /// Number of running programs that were called by a code of a setting.
    pub(super) in_alias: u32,
    /// The words of the last such call.
    last_words: [Option<f64>; 26],
    /// End of the last skip move, as #5061 shows it, mm and rad.
    skip: Position,
    /// POPEN was carried out, and PCLOS not since.
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
    /// Unknown values that the run has used.
    pub(super) unknown: unknown::UnknownValues,
}

/// A running loop.
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

    /// Takes the parser out of the state, so that its steps can be evaluated; the caller puts it back.
    fn take_parser(&mut self) -> ExpressionParser<'a> {
        let grammar = self.control.table.lexicon.grammar;
        std::mem::replace(&mut self.macros.parser, ExpressionParser::new(&[], self.file, grammar))
    }

    /// The value of an expression; `None` when it has none, which is reported.
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

    /// The value of an expression as a number; vacant counts as zero. `None` when it has none or is unknown, which is
    /// reported, with the use of the value (`what`) for an unknown one.
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

    /// True when a condition holds. One that depends on an unknown value is assumed.
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

    /// The same for a computed value.
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

    /// Reports a problem the first time it occurs at its position.
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

    /// The number of a variable, if the value is near enough to a whole number.
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
