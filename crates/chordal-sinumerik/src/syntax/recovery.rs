//! Faults: a statement that cannot be read is left out, and reading goes on after the next blank outside of texts and
//! parentheses.

use super::ast::SyntaxFault;
use super::parser::BlockParser;
use super::pending_fault::PendingFault;
use super::scanner::is_blank;
use chordal_diagnostics::TextRange;

/// A line with more faults is no block of a program; its rest is one fault.
const MAX_FAULTS_OF_BLOCK: usize = 16;

impl BlockParser<'_> {
    /// Notes a fault at the next byte. The first fault of a statement counts.
    pub fn fail<T>(&mut self, message: impl Into<String>) -> Option<T> {
        self.scan.skip_blanks();
        if self.pending.is_none() {
            self.pending = Some(PendingFault { at: self.scan.at, message: message.into() });
        }
        None
    }

    /// Skips the statement that began at `start` and adds its fault to the block.
    pub fn recover(&mut self, start: usize) {
        let pending = self.pending.take();
        let (at, message) = pending.map_or_else(
            || (start, "this cannot be read".to_string()),
            |fault| (fault.at, fault.message),
        );
        self.scan.at = start;
        if self.block.faults.len() + 1 >= MAX_FAULTS_OF_BLOCK {
            self.scan.skip_to_comment();
        } else {
            self.skip_statement(at.max(start + 1));
        }
        let begin = if at < self.scan.at { at } else { start };
        let range = TextRange::new(begin as u32, self.scan.at as u32);
        self.block.faults.push(SyntaxFault { range, message });
    }

    /// Skips to the first blank at or after `least` that is outside of texts and parentheses, or to the comment.
    fn skip_statement(&mut self, least: usize) {
        let mut open = 0_u32;
        loop {
            let Some(&byte) = self.scan.rest().first() else { return };
            match byte {
                b';' => return,
                b'"' => {
                    self.scan.skip_text();
                    continue;
                }
                b'(' | b'[' => open += 1,
                b')' | b']' => open = open.saturating_sub(1),
                _ if open == 0 && self.scan.at >= least && is_blank(byte) => return,
                _ => {}
            }
            self.scan.at += 1;
        }
    }
}
