//! Programs that need a caller: macros, which read arguments that only a call gives.
//!
//! Decided by the text, before anything is run: a program that returns (M99) and nowhere ends (M2, M30), and
//! reads local variables that no line above sets. Of LinuxCNC a text with nothing outside its subroutines.

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

/// Macros are short: a longer text is taken for a program, bytes.
const MAX_MACRO_BYTES: usize = 1 << 20;

/// What a macro run by itself lacks.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MissingCall {
    /// The head of the macro, or its first block.
    pub head: TextRange,
    /// Its arguments, for people: `X, Y and R`.
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

/// What the program would need to be run; `None` for one that is a main program.
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

/// A quick look: most programs end here.
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

/// Where the lines of a text of subroutines are.
#[derive(Default)]
struct SubState {
    found: bool,
    inside: bool,
}

/// One pass over the text.
struct MacroScan<'a> {
    control: &'a Control,
    text: &'a [u8],
    file: FileId,
    parser: ExpressionParser<'a>,
    read: BTreeSet<CallArgument>,
    set: BTreeSet<CallArgument>,
    /// M99 was met.
    returns: bool,
}

impl<'a> MacroScan<'a> {
    /// A block of macro B: its words and its statements. `None` where it shows a main program.
    fn block(&mut self, block: &mut Block) -> Option<()> {
        let line = block.line;
        loop {
            self.words(block)?;
            let BlockKind::Macro(range) = block.kind else { return Some(()) };
            let rest = self.statement(range);
            if rest.is_empty() || rest.start <= range.start {
                return Some(());
            }
            // The rest is read as a block of its own. It is shorter every time.
            let mut reader = BlockReader::new(self.text, self.file, self.control.table.lexicon);
            reader.seek(BlockPosition { offset: rest.start, line });
            reader.limit(rest.end);
            if !reader.read(block) {
                return Some(());
            }
        }
    }

    /// Reads the values of words. `None` for an end of a program, and where a tool is named by its number: that
    /// is the work of a main program, which M99 starts again.
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
                // With P it may be a jump of a main program.
                Some(Action::Call(CallCode::Return)) => self.returns |= !block.letters().has(b'P'),
                Some(Action::Call(_)) => calls = true,
                _ => {}
            }
        }
        let tool = block.last(b'T');
        let names_tool = tool.is_some_and(|tool| matches!(tool.value, WordValue::Number(_)));
        (calls || !names_tool).then_some(())
    }

    /// Takes what a statement reads and sets, and gives what is left of its line.
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

    /// A macro line of a Fadal.
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

    /// A line of LinuxCNC. `None` where something outside of the subroutines moves or computes.
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

    /// Assignments and words of a line.
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

    /// A block number, or the end of the text.
    fn is_idle(&self, word: &chordal_syntax::Word) -> bool {
        let code = word.number().and_then(code_number);
        let row = code.and_then(|code| self.control.m_code(code));
        let ends = row
            .is_some_and(|row| matches!(row.action, Action::After(AfterCode::ProgramEnd { .. })));
        word.letter == b'N' || word.letter == b'M' && ends
    }

    /// Variables that an expression reads and nothing before has set.
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

    /// The arguments by their letters.
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

    /// The arguments by their places.
    fn numbers(&self) -> String {
        let numbers = self.read.iter().filter_map(|argument| match argument {
            CallArgument::Local(number) => Some(format!("#{number}")),
            CallArgument::Letters(..) => None,
        });
        list(&numbers.collect::<Vec<_>>())
    }
}

/// The letter of an argument of type I.
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
