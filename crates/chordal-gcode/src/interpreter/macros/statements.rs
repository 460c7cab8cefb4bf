//! Macro statements of the macro B family.

use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_dialect::macros::ThenClause;
use chordal_syntax::{
    Block, BlockKind, BlockPosition as TextPosition, BlockReader, ConditionBranch, MacroStatement,
    parse_statement,
};

use super::super::{BlockFlow, Interpreter};
use super::ConditionOf;
use crate::macros::evaluate::ValuePurpose;

/// How to continue after a statement.
enum StatementFlow {
    /// With the rest of the line.
    Rest(TextRange),
    /// With the rest of the line, which belongs to a condition.
    Then(TextRange),
    /// With the next block or the end.
    Over(BlockFlow),
}

impl Interpreter<'_> {
    /// Carries out a block with a macro statement: its words, the statement, and the rest of the line, in this order.
    pub(in super::super) fn macro_block(&mut self, block: &mut Block) -> BlockFlow {
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
                if let end @ BlockFlow::End(_) = self.carry_out(block) {
                    return end;
                }
            }
            let Some(range) = statement else { return BlockFlow::Next };
            let rest = match self.statement(range) {
                StatementFlow::Rest(rest) => {
                    before = before.or(Some(range));
                    rest
                }
                StatementFlow::Then(rest) => {
                    before = None;
                    rest
                }
                StatementFlow::Over(flow) => return flow,
            };
            // The rest is read as a block of its own; it gets shorter each time, so the loop ends.
            let lexicon = self.control.table.lexicon;
            let mut reader = BlockReader::new(self.reader.text(), self.file, lexicon);
            reader.seek(TextPosition { offset: rest.start, line });
            reader.limit(rest.end);
            if !reader.read(block) {
                return BlockFlow::Next;
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

    fn statement(&mut self, range: TextRange) -> StatementFlow {
        let mut parser = self.take_parser();
        parser.start(self.reader.text(), self.file, range);
        let statement = parse_statement(&mut parser);
        let sound = parser.problems.is_empty();
        self.report_problems(&mut parser);
        let mut next = StatementFlow::Rest(parser.rest());
        match statement {
            MacroStatement::Empty if parser.rest().start == range.start => {
                next = StatementFlow::Over(BlockFlow::Next);
            }
            _ if !sound => next = StatementFlow::Over(BlockFlow::Next),
            MacroStatement::Empty | MacroStatement::Unknown(_) => {}
            MacroStatement::Assign { target, value, text } => {
                if let Some(value) = self.value_of(&parser, value, ValuePurpose::VALUE) {
                    self.message = text;
                    self.assign(&parser, &target, value);
                    self.message = None;
                }
            }
            MacroStatement::If { condition, branch } => {
                let holds = self.holds(&parser, condition, ConditionOf::Branch);
                match branch {
                    _ if !holds => next = StatementFlow::Over(BlockFlow::Next),
                    ConditionBranch::Goto(label) => {
                        let label = self.label_of(&parser, label);
                        next = StatementFlow::Over(self.goto(range, label));
                    }
                    ConditionBranch::Then => {
                        self.check_then(parser.rest());
                        next = StatementFlow::Then(parser.rest());
                    }
                    ConditionBranch::Rest => next = StatementFlow::Then(parser.rest()),
                }
            }
            MacroStatement::Goto(label) => {
                let label = self.label_of(&parser, label);
                next = StatementFlow::Over(self.goto(range, label));
            }
            MacroStatement::While { condition, number } => {
                let holds = match condition {
                    None => true,
                    Some(condition) => self.holds(&parser, condition, ConditionOf::Loop),
                };
                next = StatementFlow::Over(self.while_loop(range, number, holds));
            }
            MacroStatement::End(number) => {
                next = StatementFlow::Over(self.end_of_loop(range, number))
            }
            MacroStatement::Output(output) => self.print(range, output),
        }
        self.macros.parser = parser;
        if let Some(reason) = self.stopped.take() {
            return StatementFlow::Over(BlockFlow::End(reason));
        }
        next
    }

    /// Reports words after THEN, on controls that only allow a statement there.
    fn check_then(&mut self, rest: TextRange) {
        let text = rest.slice(self.reader.text());
        let first = text.iter().find(|byte| !byte.is_ascii_whitespace()).copied();
        let statement = first == Some(b'#');
        if self.rules().then == ThenClause::Anything || statement {
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
