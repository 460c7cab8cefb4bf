//! Macro statements of the macro B family.

use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_dialect::macros::Then;
use chordal_syntax::{
    Block, BlockKind, BlockReader, Branch, Position as TextPosition, Statement, parse_statement,
};

use super::super::{Flow, Interpreter};
use super::ConditionOf;
use crate::macros::evaluate::Purpose;

/// What follows a statement.
enum Next {
    /// What is left of the line.
    Rest(TextRange),
    /// What is left of it and belongs to a condition.
    Then(TextRange),
    /// The next block.
    Over(Flow),
}

impl Interpreter<'_> {
    /// A block with a macro statement in it: its words, the statement, and what is left of the
    /// line, in this order.
    pub(in super::super) fn macro_block(&mut self, block: &mut Block) -> Flow {
        self.carried_out = true;
        self.macros.used = true;
        let line = block.line;
        let mut before = None;
        loop {
            let statement = match block.kind {
                BlockKind::Macro(range) => Some(range),
                _ => None,
            };
            if let Some(number) = block.word(b'N').and_then(|word| word.number()) {
                self.sequence = Some(number);
            }
            if block.words.iter().any(|word| word.letter != b'N') {
                if let Some(range) = statement.or(before) {
                    self.check_mixed(block, range);
                }
                if block.expressions {
                    self.resolve_words(block);
                }
                if let end @ Flow::End(_) = self.carry_out(block) {
                    return end;
                }
            }
            let Some(range) = statement else { return Flow::Next };
            let rest = match self.statement(range) {
                Next::Rest(rest) => {
                    before = before.or(Some(range));
                    rest
                }
                Next::Then(rest) => {
                    before = None;
                    rest
                }
                Next::Over(flow) => return flow,
            };
            // The rest is read as a block of its own. It is shorter every time.
            let lexicon = self.control.table.lexicon;
            let mut reader = BlockReader::new(self.reader.text(), self.file, lexicon);
            reader.seek(TextPosition { offset: rest.start, line });
            reader.limit(rest.end);
            if !reader.read(block) {
                return Flow::Next;
            }
            for problem in std::mem::take(&mut block.problems) {
                self.report_once(problem);
            }
        }
    }

    pub(super) fn check_mixed(&mut self, block: &Block, range: TextRange) {
        if self.rules().mixed_blocks {
            return;
        }
        let words = self.words_span(block, block.letters());
        self.report_once(
            Diagnostic::new(
                Code::MixedBlock,
                self.span(range),
                "a macro statement and NC words are in one block",
            )
            .label("the statement")
            .also(words, "the words")
            .help("write two blocks"),
        );
    }

    fn statement(&mut self, range: TextRange) -> Next {
        let mut parser = self.take_parser();
        parser.start(self.reader.text(), self.file, range);
        let statement = parse_statement(&mut parser);
        let sound = parser.problems.is_empty();
        self.report_problems(&mut parser);
        let mut next = Next::Rest(parser.rest());
        match statement {
            Statement::Empty if parser.rest().start == range.start => {
                next = Next::Over(Flow::Next);
            }
            _ if !sound => next = Next::Over(Flow::Next),
            Statement::Empty | Statement::Unknown(_) => {}
            Statement::Assign { target, value, text } => {
                if let Some(value) = self.value_of(&parser, value, Purpose::VALUE) {
                    self.message = text;
                    self.assign(&parser, &target, value);
                    self.message = None;
                }
            }
            Statement::If { condition, branch } => {
                let holds = self.holds(&parser, condition, ConditionOf::Branch);
                match branch {
                    _ if !holds => next = Next::Over(Flow::Next),
                    Branch::Goto(label) => {
                        let label = self.label_of(&parser, label);
                        next = Next::Over(self.goto(range, label));
                    }
                    Branch::Then => {
                        self.check_then(parser.rest());
                        next = Next::Then(parser.rest());
                    }
                    Branch::Rest => next = Next::Then(parser.rest()),
                }
            }
            Statement::Goto(label) => {
                let label = self.label_of(&parser, label);
                next = Next::Over(self.goto(range, label));
            }
            Statement::While { condition, number } => {
                let holds = match condition {
                    None => true,
                    Some(condition) => self.holds(&parser, condition, ConditionOf::Loop),
                };
                next = Next::Over(self.while_loop(range, number, holds));
            }
            Statement::End(number) => next = Next::Over(self.end_of_loop(range, number)),
            Statement::Output(output) => self.print(range, output),
        }
        self.macros.parser = parser;
        if let Some(reason) = self.stopped.take() {
            return Next::Over(Flow::End(reason));
        }
        next
    }

    /// What may stand behind THEN.
    fn check_then(&mut self, rest: TextRange) {
        let text = rest.slice(self.reader.text());
        let first = text.iter().find(|byte| !byte.is_ascii_whitespace()).copied();
        let statement = first == Some(b'#');
        if self.rules().then == Then::Anything || statement {
            return;
        }
        self.report_once(
            Diagnostic::new(
                Code::BadStatement,
                self.span(rest),
                "only a macro statement may come after THEN on this control",
            )
            .label("NC words")
            .help("skip the words with IF and GOTO"),
        );
    }
}
