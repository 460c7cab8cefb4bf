//! Finds where the operations of a run begin.

use chordal_command::{CallPath, Origin};
use chordal_diagnostics::{FileId, Span, TextRange};
use chordal_kernel::TokenClass;
use chordal_syntax::{Block, BlockReader};

use crate::job::Job;

/// What divides a run into operations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OperationStart {
    /// Every tool change.
    #[default]
    ToolChange,
    /// Every tool change, and every comment on a line of its own in the main program, with an N number or without,
    /// after a move. Of consecutive comment lines only the first counts.
    Comment,
}

/// The role of a step in its operation, where it has one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OperationMark {
    /// The operation begins with this step; the comment before it with its parentheses or semicolon, `None` without
    /// one.
    Begins(Option<Span>),
    /// A comment comes before this step while the operation has not moved yet, and so names it.
    Names(Span),
}

/// Finds the first steps of operations.
#[derive(Debug, Default)]
pub(super) struct OperationFinder {
    /// Comments on lines of their own, in order.
    comments: Vec<Span>,
    /// How many comments come before the newest step.
    passed: usize,
    /// Whether the operation has a step.
    begun: bool,
    moved: bool,
}

impl OperationFinder {
    pub fn new(job: &Job<'_>, start: OperationStart) -> OperationFinder {
        let comments = match start {
            OperationStart::ToolChange => Vec::new(),
            OperationStart::Comment => comments(job),
        };
        OperationFinder { comments, ..OperationFinder::default() }
    }

    /// Decides whether an operation begins with this step. After a jump back in the program, as in a loop, its
    /// comments count again.
    pub fn step(
        &mut self,
        origin: &Origin,
        tool_change: bool,
        moves: bool,
    ) -> Option<OperationMark> {
        let mut comment = None;
        if origin.span.file == FileId(0) && origin.call == CallPath::default() {
            let before = |span: &Span| span.range.start < origin.span.range.start;
            let passed = self.comments.partition_point(before);
            if passed != self.passed {
                comment = passed.checked_sub(1).map(|last| self.comments[last]);
            }
            self.passed = passed;
        }
        let begins = !self.begun || tool_change || (comment.is_some() && self.moved);
        if begins {
            (self.begun, self.moved) = (true, false);
        }
        self.moved |= moves;
        if begins {
            Some(OperationMark::Begins(comment))
        } else {
            comment.map(OperationMark::Names)
        }
    }
}

/// The comments of the first text on lines without words other than N.
fn comments(job: &Job<'_>) -> Vec<Span> {
    let Some(source) = job.sources().get(FileId(0)) else { return Vec::new() };
    let Some(control) = job.word_address() else {
        let whole = TextRange::new(0, source.text().len() as u32);
        let tokens = job.program_set().tokens(whole).into_iter();
        let comments = tokens.filter(|token| token.class == TokenClass::Comment);
        return comments.map(|token| token.range.in_file(FileId(0))).collect();
    };
    let mut reader = BlockReader::new(source.text(), FileId(0), control.table.lexicon);
    let mut block = Block::new();
    let (mut firsts, mut goes_on) = (Vec::new(), false);
    while reader.read(&mut block) {
        let alone = block.words.iter().all(|word| word.letter == b'N');
        match block.comments.first() {
            Some(comment) if alone => {
                if !goes_on {
                    firsts.push(comment.in_file(FileId(0)));
                }
                goes_on = true;
            }
            _ => goes_on = false,
        }
    }
    firsts
}
