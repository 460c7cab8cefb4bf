//! The lines of a written program with the comments and block numbers of the old text.

use std::collections::BTreeSet;

use chordal::control::{Origin, ProgramWriter, WrittenProgram};

use super::recorded::is_main;
use super::remarks::SourceRemarks;

/// A text, and the step that each of its lines carries out.
#[derive(Debug, Default)]
pub(super) struct AssembledText {
    pub text: String,
    /// By line, from 0.
    pub steps: Vec<Option<usize>>,
    /// How many blocks it has; comments on lines of their own count.
    blocks: usize,
}

impl AssembledText {
    /// Adds a block, which may have several lines.
    fn push(&mut self, block: &str, step: Option<usize>) {
        for line in block.split('\n') {
            self.text.push_str(line);
            self.text.push('\n');
            self.steps.push(step);
        }
        self.blocks += 1;
    }

    /// The steps of lines, from 1.
    pub fn steps_of(&self, (from, to): (u32, u32)) -> impl Iterator<Item = usize> + '_ {
        let lines = self.steps.iter().skip(from.saturating_sub(1) as usize);
        lines.take((to + 1).saturating_sub(from) as usize).flatten().copied()
    }
}

/// Lines of the old text that the steps of a program come from.
pub(super) struct StepLines<'a> {
    pub remarks: &'a SourceRemarks,
    /// The lines of the main program that are carried out.
    pub carried_out: &'a BTreeSet<u32>,
    /// The line in the main program of each step; `None` within a call.
    pub lines: Vec<Option<u32>>,
}

/// The line of a block in the main program.
pub(super) fn main_line(origin: &Origin) -> Option<u32> {
    is_main(origin).then_some(origin.line)
}

/// Puts the text together.
pub(super) fn assemble(
    writer: &dyn ProgramWriter,
    written: &WrittenProgram,
    from: &StepLines<'_>,
) -> AssembledText {
    let mut text = AssembledText::default();
    let mut last = 0;
    let body = written.lines.iter().position(|line| line.step.is_some());
    let after_body = written.lines.iter().rposition(|line| line.step.is_some());
    let mut numbered = BTreeSet::new();
    for (at, line) in written.lines.iter().enumerate() {
        let own = line.step.and_then(|step| from.lines.get(step).copied().flatten());
        let is_first = body == Some(at) || body.is_none() && at == 0;
        let now = own.unwrap_or(last);
        if now > last || is_first {
            for comment in from.remarks.between(last, now, from.carried_out) {
                push_comment(&mut text, writer, comment);
            }
        }
        let is_new = own.is_some_and(|own| own > last || is_first) && numbered.insert(own);
        let number = own.filter(|_| is_new).and_then(|line| from.remarks.number(line));
        let comment = own.filter(|_| is_new).and_then(|line| from.remarks.at_line_end(line));
        let mut words = writer.block_start(number, text.blocks);
        words.push_str(&line.text);
        if let Some(comment) = comment {
            words.push(' ');
            words.push_str(&writer.comment(comment));
        }
        text.push(&words, line.step);
        last = last.max(now);
        if after_body == Some(at) {
            for comment in from.remarks.between(last, u32::MAX, from.carried_out) {
                push_comment(&mut text, writer, comment);
            }
        }
    }
    text
}

/// A comment on a line of its own.
fn push_comment(text: &mut AssembledText, writer: &dyn ProgramWriter, comment: &str) {
    let block = writer.block_start(None, text.blocks) + &writer.comment(comment);
    text.push(&block, None);
}
