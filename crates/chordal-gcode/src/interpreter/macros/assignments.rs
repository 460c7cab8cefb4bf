//! Lines with assignments of LinuxCNC. First all values of a line are computed with the variables as they were
//! before it, then the assignments are made, then its words are carried out ("Numbered Parameters":
//! `#3=6 G1 X#3` uses the old #3).

use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_syntax::{
    AssignTarget, Block, BlockKind, BlockPosition as TextPosition, BlockReader, MacroStatement,
    Word, parse_statement,
};

use super::super::{BlockFlow, Interpreter};
use crate::macros::evaluate::ValuePurpose;
use crate::macros::value::MacroValue;

/// Largest number of assignments of a line; the control's lines have up to 255 characters.
const MAX_ASSIGNMENTS: usize = 200;

/// A computed assignment that is not made yet.
struct PendingAssignment {
    target: AssignTarget,
    index: f64,
    value: MacroValue,
}

impl Interpreter<'_> {
    /// Carries out a line with a statement: assignments and words in any order, or an O word.
    pub(in super::super) fn parameter_line(
        &mut self,
        block: &mut Block,
        range: TextRange,
    ) -> BlockFlow {
        self.carried_out = true;
        self.macros.used = true;
        let line = block.line;
        let first = range.slice(self.reader.text()).first().copied().unwrap_or(b' ');
        if first.eq_ignore_ascii_case(&b'O') {
            if !self.rules().o_flow {
                let title = self.control.table.title;
                let message = format!("{title} has no flow control by O words: LinuxCNC has");
                self.lose_path(range, message);
                return BlockFlow::Next;
            }
            return self.flow_line(range);
        }
        let mut pending = Vec::new();
        let mut words: Vec<Word> = Vec::new();
        let mut comments: Vec<TextRange> = Vec::new();
        loop {
            if block.expressions {
                self.resolve_words(block);
            }
            words.extend_from_slice(&block.words);
            words.extend_from_slice(&block.polar);
            comments.extend_from_slice(&block.comments);
            let BlockKind::Macro(range) = block.kind else { break };
            if pending.len() >= MAX_ASSIGNMENTS {
                self.report_too_many(range);
                break;
            }
            let Some(rest) = self.assignment(range, &mut pending) else { break };
            // The rest is read as a block of its own; it gets shorter each time, so the loop ends.
            let lexicon = self.control.table.lexicon;
            let mut reader = BlockReader::new(self.reader.text(), self.file, lexicon);
            reader.seek(TextPosition { offset: rest.start, line });
            reader.limit(rest.end);
            if !reader.read(block) {
                break;
            }
            for problem in std::mem::take(&mut block.problems) {
                self.report_once(problem);
            }
        }
        for assignment in pending {
            self.make(&assignment);
        }
        if !comments.is_empty()
            && let Some(flow) = self.acting_comment(&comments)
        {
            return flow;
        }
        if words.is_empty() {
            return BlockFlow::Next;
        }
        block.truncate(0);
        block.kind = BlockKind::Words;
        block.range = self.kernel.origin.span.range;
        words.into_iter().for_each(|word| block.push_any(word));
        if let Some(number) = block.word(b'N').and_then(|word| word.number()) {
            self.sequence = Some(number);
        }
        self.carry_out(block)
    }

    fn report_too_many(&mut self, range: TextRange) {
        self.report_once(
            Diagnostic::new(
                Code::BadStatement,
                self.span(range),
                format!("this line has more than {MAX_ASSIGNMENTS} assignments"),
            )
            .label("the rest of the line is not read")
            .help("write them on several lines"),
        );
    }

    /// Reads an assignment and computes it. Returns the rest of the line; `None` when it cannot be read.
    fn assignment(
        &mut self,
        range: TextRange,
        pending: &mut Vec<PendingAssignment>,
    ) -> Option<TextRange> {
        let mut parser = self.take_parser();
        parser.start(self.reader.text(), self.file, range);
        let statement = parse_statement(&mut parser);
        let sound = parser.problems.is_empty();
        self.report_problems(&mut parser);
        let mut rest = Some(parser.rest());
        match statement {
            MacroStatement::Assign { target, value, text } if sound => {
                let what = "the number of the variable that is written";
                let index = match target.index.is_empty() {
                    true => Some(0.0),
                    false => self.number_of(&parser, target.index, ValuePurpose::VALUE, what),
                };
                let value = self.value_of(&parser, value, ValuePurpose::VALUE);
                if let (Some(index), Some(value)) = (index, value) {
                    pending.push(PendingAssignment { target, index, value });
                }
                // The comment after it is a comment of the line.
                if let Some(text) = text {
                    rest = rest.map(|rest| TextRange::new(text.start - 1, rest.end));
                }
            }
            MacroStatement::Assign { .. } | MacroStatement::Unknown(_) => rest = None,
            MacroStatement::Empty => rest = None,
            _ => {
                self.report_once(
                    Diagnostic::new(
                        Code::BadStatement,
                        self.span(range),
                        "this control does not have this macro statement",
                    )
                    .label("skipped")
                    .help("flow control is written with O words: `o100 if [#1 GT 2]`"),
                );
                rest = None;
            }
        }
        self.macros.parser = parser;
        rest
    }

    fn make(&mut self, assignment: &PendingAssignment) {
        if let Err(fault) = self.write_target(
            assignment.target.kind,
            assignment.index,
            assignment.value,
            assignment.target.range,
        ) {
            self.report_fault(fault);
        }
    }
}
