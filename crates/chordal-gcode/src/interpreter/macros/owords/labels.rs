//! Checks of the labels of O words, and the labels that M98 calls.

use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_syntax::{
    Block, BlockPosition as TextPosition, ExpressionParser, FlowWord, OLabel, OWord,
};

use super::{FlowIndex, Interpreter, NONE, label_text};

impl<'a> Interpreter<'a> {
    /// Reports a `continue` in a `do` with a `break` below it.
    pub(super) fn report_passed_break(&mut self, line: &OWord) {
        self.report_once(
            Diagnostic::new(
                Code::LoopMismatch,
                self.span(line.range),
                "this continue ends the loop: on its way to the end of `do` the control carries out the \
                 break below it",
            )
            .severity(Severity::Warning)
            .help("put the break before the continue, or write the loop with while and endwhile"),
        );
    }

    /// Reports a label of two structures, and a subroutine inside another.
    pub(super) fn check_label(&mut self, index: &FlowIndex, line: &OWord, here: usize) {
        let row = index.lines[here];
        let title = self.control.table.title;
        if row.same != NONE && row.open == here && row.close != NONE {
            let before = index.lines[row.same].at.line;
            self.report_once(
                Diagnostic::new(
                    Code::LoopMismatch,
                    self.span(line.range),
                    format!("this label is used twice: line {before} begins with it, too"),
                )
                .alarm(format!(
                    "{title}: duplicate O-word label - already defined in line {before}"
                ))
                .help("give each structure of a subroutine a label of its own"),
            );
        }
        let inner = (here + 1..row.close.min(index.lines.len()))
            .find(|inner| row.word == FlowWord::Sub && index.lines[*inner].word == FlowWord::Sub);
        if let Some(inner) = inner.filter(|_| row.close != NONE) {
            let inner = index.lines[inner].at.line;
            self.report_once(
                Diagnostic::new(
                    Code::LoopMismatch,
                    self.span(line.range),
                    format!("line {inner} defines a subroutine inside of this one"),
                )
                .alarm(format!("{title}: Nested subroutine definition"))
                .help("end this subroutine before the other one begins"),
            );
        }
    }

    /// Reports and skips a subroutine that is already defined in its file; false for any other.
    pub(super) fn is_again(&mut self, index: &FlowIndex, line: &OWord, here: usize) -> bool {
        let OLabel::Text(range) = line.label else { return false };
        let label = label_text(range.slice(self.reader.text()));
        let Some(first) = index.subs.get(&label).copied().filter(|first| *first != here) else {
            return false;
        };
        let title = self.control.table.title;
        let before = index.lines[first].at.line;
        self.report_once(
            Diagnostic::new(
                Code::LoopMismatch,
                self.span(line.range),
                format!("the subroutine `{label}` is defined again; line {before} defines it"),
            )
            .alarm(format!("{title}: redefining sub: o|{label}| already defined"))
            .help("give one of them another name"),
        );
        let close = index.lines[here].close;
        if let Some(row) = index.lines.get(close) {
            self.go_to(row.after);
        }
        true
    }

    /// Reports text after an O word other than a comment.
    pub(super) fn check_line_end(&mut self, parser: &mut ExpressionParser<'a>) {
        let mark = parser.next_mark_after_comments();
        let rest = parser.rest();
        if rest.is_empty() || matches!(mark, b';' | b'\n' | b'\r' | b'/') {
            return;
        }
        let title = self.control.table.title;
        self.report_once(
            Diagnostic::new(
                Code::BadStatement,
                self.span(rest),
                "there is something after the O word of this line",
            )
            .label("not read")
            .alarm(format!("{title}: Unexpected character after O-word"))
            .help("write it on a line of its own, or in a comment"),
        );
    }

    /// The line `O5` of the program that M98 P5 calls: the one found by an earlier call, else the next one below;
    /// `None` when there is none.
    pub(in super::super::super) fn label_ahead(&mut self, number: u32) -> Option<TextPosition> {
        self.look_at(self.program);
        let program = self.program;
        if !self.macros.owords.heads.contains_key(&program) {
            let heads = self.find_heads();
            self.macros.owords.heads.insert(program, heads);
        }
        if let Some(place) = self.macros.owords.called.get(&(program, number)) {
            return Some(*place);
        }
        let from = self.reader.position().offset;
        let heads = &self.macros.owords.heads[&program];
        let mut ahead = heads.iter().filter(|(_, place)| place.offset >= from);
        let is_meant = |head: &&(u32, TextPosition)| head.0 == number;
        let upwards = self.control.parameters.calls_upwards;
        let above = || heads.iter().find(is_meant).filter(|_| upwards);
        let (_, place) = *ahead.find(is_meant).or_else(above)?;
        self.macros.owords.called.insert((program, number), place);
        Some(place)
    }

    pub(super) fn find_heads(&self) -> Vec<(u32, TextPosition)> {
        let mut reader = self.reader_of(self.program);
        let mut block = Block::new();
        let mut heads = Vec::new();
        loop {
            let place = reader.position();
            if !reader.read(&mut block) {
                return heads;
            }
            let number = block.word(b'O').and_then(|word| word.number()?.to_integer());
            if let Some(number) = number.and_then(|number| u32::try_from(number).ok()) {
                heads.push((number, place));
            }
        }
    }
}
