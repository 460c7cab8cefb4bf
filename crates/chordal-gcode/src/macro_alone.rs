//! Finds macros that need a caller, because they read arguments that only a call gives.
//!
//! This is decided by the text, before a run: such a program returns (M99) and never ends (M2, M30), and reads local
//! variables that no line above sets. For LinuxCNC it is a text with nothing outside its subroutines.

use std::collections::BTreeSet;

use chordal_diagnostics::{FileId, TextRange};
use chordal_dialect::macros::MacroForm;
use chordal_dialect::{Action, AfterCode, CallCode, Control, code_number};
use chordal_syntax::{
    AssignTarget, Block, BlockKind, BlockPosition, BlockReader, ConditionBranch, Expression,
    ExpressionParser, FlowWord, LineStatement, MacroStatement, PrintItem, StackOp, WordValue,
    parse_line_statement, parse_o_word, parse_statement,
};

use crate::library::{Library, Program};
use crate::macros::arguments::type_one;

/// Macros are short: a longer text counts as a main program, bytes.
const MAX_MACRO_BYTES: usize = 1 << 20;

/// The call that a macro needs.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MissingCall {
    /// The head of the macro, or its first block.
    pub head: TextRange,
    /// Its arguments in words: `X, Y and R`.
    pub arguments: String,
}

/// A variable that a call gives.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum CallArgument {
    /// A local variable.
    Local(u32),
    /// A variable written with letters.
    Letters(u8, u32),
}

/// The call that a program needs; `None` for a main program.
pub(crate) fn missing_call(
    library: &Library<'_>,
    program: Program,
    control: &Control,
) -> Option<MissingCall> {
    let form = control.macros.form;
    let range = TextRange::new(program.head.start.offset, program.head.end);
    let text = range.slice(library.text(program.file));
    if form == MacroForm::None || text.len() > MAX_MACRO_BYTES || !may_be_macro(text, form) {
        return None;
    }
    let mut reader = library.reader(program, control.table.lexicon);
    let text = reader.text();
    let parser = ExpressionParser::new(text, program.file, control.table.lexicon.grammar);
    let mut scan = MacroScan {
        control,
        text,
        file: program.file,
        parser,
        read: BTreeSet::new(),
        set: BTreeSet::new(),
        returns: false,
    };
    let mut block = Block::new();
    let mut first = None;
    let mut sub = SubState::default();
    while reader.read(&mut block) {
        if !block.words.is_empty() || matches!(block.kind, BlockKind::Macro(_)) {
            first.get_or_insert(block.range);
        }
        match form {
            MacroForm::OWords => scan.line_of_subs(&mut block, &mut sub)?,
            MacroForm::Blocks => scan.block(&mut block)?,
            MacroForm::Lines => scan.macro_line(&block)?,
            MacroForm::None => {}
        }
    }
    let head = program.head.head;
    let head = if head.is_empty() { first? } else { head };
    let arguments = match form {
        MacroForm::OWords => (sub.found && !sub.inside).then(|| scan.numbers())?,
        _ => (scan.returns && !scan.read.is_empty()).then(|| scan.letters())?,
    };
    Some(MissingCall { head, arguments })
}

/// A fast search that excludes most programs.
fn may_be_macro(text: &[u8], form: MacroForm) -> bool {
    let has = |part: &[u8]| {
        let first = part[0];
        memchr::memchr2_iter(first.to_ascii_lowercase(), first.to_ascii_uppercase(), text)
            .filter_map(|at| text.get(at..at + part.len()))
            .any(|found| found.eq_ignore_ascii_case(part))
    };
    match form {
        MacroForm::OWords => has(b"endsub"),
        _ => has(b"M99") && (has(b"#") || has(b"R")),
    }
}

/// The state of the scan of a text with subroutines.
#[derive(Default)]
struct SubState {
    found: bool,
    inside: bool,
}

/// A scan of the text.
struct MacroScan<'a> {
    control: &'a Control,
    text: &'a [u8],
    file: FileId,
    parser: ExpressionParser<'a>,
    read: BTreeSet<CallArgument>,
    set: BTreeSet<CallArgument>,
    /// M99 was found.
    returns: bool,
}

impl<'a> MacroScan<'a> {
    /// Scans the words and statements of a macro B block. `None` when it shows a main program.
    fn block(&mut self, block: &mut Block) -> Option<()> {
        let line = block.line;
        loop {
            self.words(block)?;
            let BlockKind::Macro(range) = block.kind else { return Some(()) };
            let rest = self.statement(range);
            if rest.is_empty() || rest.start <= range.start {
                return Some(());
            }
            // The rest is read as a block of its own; it gets shorter each time, so the loop ends.
            let mut reader = BlockReader::new(self.text, self.file, self.control.table.lexicon);
            reader.seek(BlockPosition { offset: rest.start, line });
            reader.limit(rest.end);
            if !reader.read(block) {
                return Some(());
            }
        }
    }

    /// Scans the values of words. `None` for a program end, and for a tool number: then it is a main program that M99
    /// starts again.
    fn words(&mut self, block: &Block) -> Option<()> {
        let mut calls = false;
        for word in &block.words {
            match word.value {
                WordValue::Expression(range) => {
                    self.parser.start(self.text, self.file, range);
                    let value = self.parser.expression();
                    self.reads(value);
                }
                WordValue::Register { index, .. } => self.register(index, false),
                WordValue::Number(_) | WordValue::Missing => {}
            }
            if let Some(index) = word.register {
                self.register(index, true);
            }
            let code = word.number().and_then(code_number);
            let row = code.and_then(|code| match word.letter {
                b'G' => self.control.g_code(code),
                b'M' => self.control.m_code(code),
                _ => None,
            });
            match row.map(|row| row.action) {
                Some(Action::After(AfterCode::ProgramEnd { .. })) => return None,
                // M99 with P may be a jump in a main program.
                Some(Action::Call(CallCode::Return)) => self.returns |= !block.letters().has(b'P'),
                Some(Action::Call(_)) => calls = true,
                _ => {}
            }
        }
        let tool = block.last(b'T');
        let names_tool = tool.is_some_and(|tool| matches!(tool.value, WordValue::Number(_)));
        (calls || !names_tool).then_some(())
    }

    /// Scans what a statement reads and sets; returns the rest of its line.
    fn statement(&mut self, range: TextRange) -> TextRange {
        self.parser.start(self.text, self.file, range);
        match parse_statement(&mut self.parser) {
            MacroStatement::Assign { target, value, .. } => {
                self.reads(value);
                self.sets(&target);
            }
            MacroStatement::If { condition, branch } => {
                self.reads(condition);
                if let ConditionBranch::Goto(label) = branch {
                    self.reads(label);
                }
            }
            MacroStatement::Goto(label) => self.reads(label),
            MacroStatement::While { condition, .. } => {
                condition.into_iter().for_each(|condition| self.reads(condition));
            }
            MacroStatement::Empty
            | MacroStatement::End(_)
            | MacroStatement::Output(_)
            | MacroStatement::Unknown(_) => {}
        }
        self.parser.problems.clear();
        self.parser.rest()
    }

    /// Scans a macro line of a Fadal; `None` when it shows a main program.
    fn macro_line(&mut self, block: &Block) -> Option<()> {
        self.words(block)?;
        let BlockKind::Macro(range) = block.kind else { return Some(()) };
        let after = TextRange::new((range.start + 1).min(range.end), range.end);
        self.parser.start(self.text, self.file, after);
        loop {
            let before = self.parser.position();
            match parse_line_statement(&mut self.parser) {
                LineStatement::If(condition) if self.parser.position() > before => {
                    self.reads(condition);
                    continue;
                }
                LineStatement::Assign { target, value } => {
                    self.reads(value);
                    self.sets(&target);
                }
                LineStatement::Input(targets) => {
                    targets.iter().for_each(|target| self.sets(target))
                }
                LineStatement::Print { items, .. } => {
                    for item in items {
                        if let PrintItem::Value(value) = item {
                            self.reads(value);
                        }
                    }
                }
                _ => {}
            }
            self.parser.problems.clear();
            return Some(());
        }
    }

    /// Scans a line of LinuxCNC. `None` when something outside the subroutines moves or computes.
    fn line_of_subs(&mut self, block: &mut Block, state: &mut SubState) -> Option<()> {
        if let BlockKind::Macro(range) = block.kind {
            let first = range.slice(self.text).first().copied().unwrap_or(b' ');
            if first.eq_ignore_ascii_case(&b'O') {
                self.parser.start(self.text, self.file, range);
                let word = parse_o_word(&mut self.parser).word;
                self.parser.problems.clear();
                match word {
                    Some(FlowWord::Sub) => (state.found, state.inside) = (true, true),
                    Some(FlowWord::EndSub) => state.inside = false,
                    _ if !state.inside => return None,
                    _ => {
                        let value = self.parser.expression();
                        self.reads(value);
                        self.parser.problems.clear();
                    }
                }
                return Some(());
            }
            if !state.inside {
                return None;
            }
            return self.assignments(block);
        }
        if !state.inside && block.words.iter().any(|word| !self.is_idle(word)) {
            return None;
        }
        if state.inside {
            self.reads_of_words(block)
        }
        Some(())
    }

    /// Scans assignments and words of a line.
    fn assignments(&mut self, block: &mut Block) -> Option<()> {
        let line = block.line;
        loop {
            self.reads_of_words(block);
            let BlockKind::Macro(range) = block.kind else { return Some(()) };
            let rest = self.statement(range);
            if rest.is_empty() || rest.start <= range.start {
                return Some(());
            }
            let mut reader = BlockReader::new(self.text, self.file, self.control.table.lexicon);
            reader.seek(BlockPosition { offset: rest.start, line });
            reader.limit(rest.end);
            if !reader.read(block) {
                return Some(());
            }
        }
    }

    fn reads_of_words(&mut self, block: &Block) {
        for word in &block.words {
            if let WordValue::Expression(range) = word.value {
                self.parser.start(self.text, self.file, range);
                let value = self.parser.expression();
                self.reads(value);
                self.parser.problems.clear();
            }
        }
    }

    /// True for a block number or a program end.
    fn is_idle(&self, word: &chordal_syntax::Word) -> bool {
        let code = word.number().and_then(code_number);
        let row = code.and_then(|code| self.control.m_code(code));
        let ends = row
            .is_some_and(|row| matches!(row.action, Action::After(AfterCode::ProgramEnd { .. })));
        word.letter == b'N' || word.letter == b'M' && ends
    }

    /// Records the variables that an expression reads and that nothing above has set.
    fn reads(&mut self, expression: Expression) {
        let mut found = Vec::new();
        let mut before = None;
        for step in self.parser.steps(expression) {
            if let Some(argument) = self.argument(step.op, before) {
                found.push(argument);
            }
            before = Some(step.op);
        }
        found.retain(|argument| !self.set.contains(argument));
        self.read.extend(found);
        self.parser.problems.clear();
    }

    fn sets(&mut self, target: &AssignTarget) {
        let index = self.parser.steps(target.index).last().map(|step| step.op);
        if let Some(argument) = self.argument(target.kind, index) {
            self.set.insert(argument);
        }
    }

    fn argument(&self, op: StackOp, before: Option<StackOp>) -> Option<CallArgument> {
        let Some(StackOp::Number(number)) = before else { return None };
        let number = (0.0..=1e6).contains(&number).then_some(number as u32)?;
        match op {
            StackOp::Read => ((1..=self.control.macros.locals).contains(&number)
                && (self.control.macros.o_flow && !self.control.macros.macro_b
                    || letter_of(number).is_some()))
            .then_some(CallArgument::Local(number)),
            StackOp::Letters(letters) => {
                let names = self.control.table.lexicon.grammar.letter_variables;
                let name = names.get(letters as usize).copied()?;
                matches!(name, "V" | "R").then_some(CallArgument::Letters(letters, number))
            }
            _ => None,
        }
    }

    fn register(&mut self, index: u8, sets: bool) {
        let names = self.control.table.lexicon.grammar.letter_variables;
        let Some(at) = names.iter().position(|name| *name == "R") else { return };
        let argument = CallArgument::Letters(at as u8, u32::from(index));
        if sets {
            self.set.insert(argument);
        } else if !self.set.contains(&argument) {
            self.read.insert(argument);
        }
    }

    /// The arguments as letters.
    fn letters(&self) -> String {
        let names = self.control.table.lexicon.grammar.letter_variables;
        let name = |argument: &CallArgument| match *argument {
            CallArgument::Local(number) => {
                letter_of(number).map(|letter| char::from(letter).to_string())
            }
            CallArgument::Letters(letters, number) => {
                names.get(letters as usize).map(|name| format!("{name}{number}"))
            }
        };
        list(&self.read.iter().filter_map(name).collect::<Vec<_>>())
    }

    /// The arguments as variables.
    fn numbers(&self) -> String {
        let numbers = self.read.iter().filter_map(|argument| match argument {
            CallArgument::Local(number) => Some(format!("#{number}")),
            CallArgument::Letters(..) => None,
        });
        list(&numbers.collect::<Vec<_>>())
    }
}

/// The letter of an argument of type I; `None` for a variable without one.
fn letter_of(number: u32) -> Option<u8> {
    (b'A'..=b'Z').find(|letter| type_one(*letter) == number)
}

fn list(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}
