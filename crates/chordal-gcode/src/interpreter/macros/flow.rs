//! GOTO, WHILE and END.

use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_syntax::{
    Block, BlockKind, BlockPosition as TextPosition, Expression, ExpressionParser, MacroStatement,
    parse_statement,
};

use super::super::{BlockFlow, EndReason, Interpreter};
use super::{ActiveLoop, LoopEnds};
use crate::macros::evaluate::ValuePurpose;

/// Largest number of running loops that are remembered.
const MAX_LOOPS: usize = 127;

impl<'a> Interpreter<'a> {
    /// The block number of a GOTO; `None` when it is not known.
    pub(super) fn label_of(
        &mut self,
        parser: &ExpressionParser<'a>,
        label: Expression,
    ) -> Option<f64> {
        self.number_of(parser, label, ValuePurpose::VALUE, "the block that GOTO means")
    }

    /// GOTO: jumps to the next block below with that number, else to the first from the top.
    pub(super) fn goto(&mut self, range: TextRange, label: Option<f64>) -> BlockFlow {
        let Some(label) = label else { return BlockFlow::Next };
        let number = libm::round(label);
        let here = self.kernel.origin.span.range.start;
        let found = if number.abs() < 1e9 {
            self.label_below(self.program, number as i64, here)
        } else {
            None
        };
        let Some(target) = found else {
            self.kernel.report(
                Diagnostic::new(
                    Code::MissingLabel,
                    self.span(range),
                    format!("no block has the number N{number}"),
                )
                .help(format!("put N{number} before the block you mean")),
            );
            return BlockFlow::End(EndReason::LostJump);
        };
        self.leave_loops(target);
        self.go_to(target);
        BlockFlow::Next
    }

    /// Ends the loops that a jump leaves.
    fn leave_loops(&mut self, target: TextPosition) {
        while let Some(last) = self.macros.loops.last().copied() {
            let end = self.loop_end(last.head, last.number);
            let inside = target.offset > last.head.offset
                && end.is_none_or(|end| target.offset < end.offset);
            if inside {
                return;
            }
            self.macros.loops.pop();
        }
    }

    /// WHILE and DO.
    pub(super) fn while_loop(&mut self, range: TextRange, number: u32, holds: bool) -> BlockFlow {
        let rules = self.rules();
        if number == 0 || number > rules.last_loop {
            let last = rules.last_loop;
            let message = format!("DO needs a number from 1 to {last}, not {number}");
            self.report_loop(Code::BadLoopNumber, range, message, "use another number");
            return BlockFlow::Next;
        }
        let head = TextPosition {
            offset: self.kernel.origin.span.range.start,
            line: self.kernel.origin.line,
        };
        let running = self.macros.loops.iter().position(|entry| entry.head == head);
        match running {
            Some(at) => self.macros.loops.truncate(at + 1),
            None => self.begin_loop(range, ActiveLoop { number, head }),
        }
        if holds {
            return BlockFlow::Next;
        }
        self.macros.loops.pop();
        match self.loop_end(head, number) {
            Some(end) => {
                self.reader.seek(end);
                BlockFlow::Next
            }
            None => {
                self.report_open_loop(range, number);
                BlockFlow::End(EndReason::LostJump)
            }
        }
    }

    fn begin_loop(&mut self, range: TextRange, entry: ActiveLoop) {
        let number = entry.number;
        let same = self.macros.loops.iter().any(|running| running.number == number);
        let deepest = self.rules().loop_depth as usize;
        if same {
            let message = format!("DO{number} is inside the loop DO{number}");
            let help = "give the inner loop another number";
            self.report_loop(Code::BadLoopNumber, range, message, help);
        } else if self.macros.loops.len() >= deepest {
            let message = format!("loops are nested more than {deepest} levels deep");
            let help = "put the inner loops into a subprogram";
            self.report_loop(Code::BadLoopNumber, range, message, help);
        }
        // Also when the condition holds, so that the end is not needed yet.
        if self.loop_end(entry.head, number).is_none() {
            self.report_open_loop(range, number);
        }
        if self.macros.loops.len() < MAX_LOOPS {
            self.macros.loops.push(entry);
        }
    }

    fn report_open_loop(&mut self, range: TextRange, number: u32) {
        let message = format!("DO{number} has no END{number} below it");
        let help = "write END and the number after the last block of the loop";
        self.report_loop(Code::LoopMismatch, range, message, help);
    }

    /// END.
    pub(super) fn end_of_loop(&mut self, range: TextRange, number: u32) -> BlockFlow {
        let Some(at) = self.macros.loops.iter().rposition(|entry| entry.number == number) else {
            let message = format!("END{number} without a running DO{number}");
            let help = "a GOTO may leave a loop, but not jump into one";
            self.report_loop(Code::LoopMismatch, range, message, help);
            return BlockFlow::Next;
        };
        if at + 1 < self.macros.loops.len() {
            let inner = self.macros.loops[at + 1].number;
            let message = format!("END{number} comes before END{inner}: the loops cross");
            let help = "end the inner loop first";
            self.report_loop(Code::LoopMismatch, range, message, help);
            self.macros.loops.truncate(at + 1);
        }
        let head = self.macros.loops[at].head;
        self.go_to(head);
        BlockFlow::Next
    }

    fn report_loop(&mut self, code: Code, range: TextRange, message: String, help: &str) {
        self.report_once(Diagnostic::new(code, self.span(range), message).help(help));
    }

    /// The start of the block after the END of a loop; `None` when there is none. The text is searched once for all
    /// loops.
    fn loop_end(&mut self, head: TextPosition, number: u32) -> Option<TextPosition> {
        let mut reader = self.reader_of(self.program);
        let ends = self.macros.loop_ends.entry((self.file, self.program)).or_default();
        // A backward jump may lead to a loop before the searched part.
        if ends.from.is_none_or(|from| head.offset < from) {
            *ends = LoopEnds { from: Some(head.offset), next: Some(head), found: Vec::new() };
        }
        let following = ends.found.partition_point(|(at, ..)| *at <= head.offset);
        let known = ends.found[following..].iter().find(|(_, own, _)| *own == number);
        if let Some((.., end)) = known {
            return Some(*end);
        }
        reader.seek(ends.next?);
        let lexicon = self.control.table.lexicon;
        let mut block = Block::new();
        let mut parser = ExpressionParser::new(reader.text(), self.file, lexicon.grammar);
        while reader.read(&mut block) {
            let BlockKind::Macro(range) = block.kind else { continue };
            parser.start(reader.text(), self.file, range);
            if !parser.take_text("END") {
                continue;
            }
            parser.start(reader.text(), self.file, range);
            if let MacroStatement::End(own) = parse_statement(&mut parser) {
                let end = reader.position();
                ends.found.push((range.start, own, end));
                ends.next = Some(end);
                if own == number && range.start > head.offset {
                    return Some(end);
                }
            }
        }
        ends.next = None;
        None
    }
}
