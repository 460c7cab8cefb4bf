//! Branches, loops and jumps.

use super::ast::{Expression, JumpDirection, JumpStatement, JumpTarget, RepeatPart, StatementKind};
use super::parser::BlockParser;

/// The words of jumps.
const JUMP_WORDS: [(&str, JumpDirection); 5] = [
    ("GOTOF", JumpDirection::Forward),
    ("GOTOB", JumpDirection::Backward),
    ("GOTO", JumpDirection::Both),
    ("GOTOC", JumpDirection::BothOrNone),
    ("GOTOS", JumpDirection::ProgramStart),
];

impl BlockParser<'_> {
    /// What follows IF: a condition, and a jump when the block does not end with it.
    pub fn condition(&mut self) -> Option<StatementKind> {
        let condition = self.expression()?;
        let after = self.scan;
        if self.scan.is_at_end() {
            self.scan = after;
            return Some(StatementKind::If(condition));
        }
        self.jump(Some(condition)).map(StatementKind::Jump)
    }

    /// A jump with its target.
    pub fn jump(&mut self, condition: Option<Expression>) -> Option<JumpStatement> {
        self.scan.skip_blanks();
        let start = self.scan.at;
        let found = JUMP_WORDS.iter().find(|(word, _)| self.scan.is_word(word));
        let Some((word, direction)) = found else {
            return self.fail("a jump or the end of the block is missing");
        };
        self.scan.at += word.len();
        let has_target = *direction != JumpDirection::ProgramStart;
        let target = if has_target { Some(self.jump_target()?) } else { None };
        let range = self.scan.range_from(start);
        Some(JumpStatement { direction: *direction, target, condition, range })
    }

    /// `N100`, `:100`, a label or an expression with a text.
    fn jump_target(&mut self) -> Option<JumpTarget> {
        let first = self.scan.next_byte();
        let begin = self.scan;
        if matches!(first, b'N' | b'n' | b':') {
            self.scan.at += 1;
            if let Some(number) = self.scan.read_digits() {
                return Some(JumpTarget::Number(number, first == b':'));
            }
            self.scan = begin;
        }
        if let Some(label) = self.scan.read_whole_name() {
            let after = self.scan;
            let is_computed = match self.scan.next_byte() {
                b'[' | b'(' => true,
                b'<' => self.scan.peek_after(1) == b'<',
                _ => false,
            };
            if !is_computed {
                self.scan = after;
                return Some(JumpTarget::Label(self.scan.upper(label)));
            }
            self.scan = begin;
        }
        self.expression().map(JumpTarget::Computed)
    }

    /// `CASE value OF 1 GOTOF A … DEFAULT GOTOF B`.
    pub fn case(&mut self) -> Option<StatementKind> {
        let selector = self.expression()?;
        if !self.scan.take_word("OF") {
            return self.fail("OF is missing");
        }
        let (mut branches, mut default) = (Vec::new(), None);
        loop {
            let after = self.scan;
            if self.scan.is_at_end() {
                self.scan = after;
                return Some(StatementKind::Case { selector, branches, default });
            }
            if self.scan.take_word("DEFAULT") {
                default = Some(self.jump(None)?);
                return Some(StatementKind::Case { selector, branches, default });
            }
            let constant = self.expression()?;
            branches.push((constant, self.jump(None)?));
        }
    }

    /// What follows FOR: `variable = from TO to`.
    pub fn count_loop(&mut self) -> Option<StatementKind> {
        let variable = self.required_address()?;
        if !self.scan.take_equals() {
            return self.fail("an equals sign is missing");
        }
        let from = self.expression()?;
        if !self.scan.take_word("TO") {
            return self.fail("TO and the last value are missing");
        }
        let to = self.expression()?;
        Some(StatementKind::For { variable, from, to })
    }

    /// What follows REPEAT and REPEATB: nothing for a loop, or one or two labels and `P=n`.
    pub fn repeat(&mut self, is_single_block: bool) -> Option<StatementKind> {
        let after = self.scan;
        if self.scan.is_at_end() && !is_single_block {
            self.scan = after;
            return Some(StatementKind::RepeatLoop);
        }
        let (from, _) = self.required_name("the label")?;
        let to = if is_single_block { None } else { self.end_label() };
        let times = self.repetitions()?;
        Some(StatementKind::RepeatPart(RepeatPart { from, to, times, is_single_block }))
    }

    /// The second label, which is not `P=n`.
    fn end_label(&mut self) -> Option<String> {
        let begin = self.scan;
        self.scan.skip_blanks();
        let name = self.scan.read_name();
        match name {
            Some(name) if name.len() > 1 => Some(self.scan.upper(name)),
            _ => {
                self.scan = begin;
                None
            }
        }
    }

    /// `P=n` or `P3`; `Some(None)` without.
    fn repetitions(&mut self) -> Option<Option<Expression>> {
        let begin = self.scan;
        if !matches!(self.scan.next_byte(), b'P' | b'p') {
            self.scan = begin;
            return Some(None);
        }
        self.scan.at += 1;
        if !self.scan.take_equals() && !self.scan.peek().is_ascii_digit() {
            self.scan = begin;
            return Some(None);
        }
        self.expression().map(Some)
    }
}
