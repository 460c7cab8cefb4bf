//! Where operations begin.

use chordal_command::{CallPath, Origin};
use chordal_diagnostics::{FileId, Span};
use chordal_syntax::{Block, BlockReader};

use crate::job::Job;

/// What divides a run into operations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OperationStart {
    /// Every tool change.
    #[default]
    ToolChange,
    /// Every tool change, and every comment on a line of its own in the main program,
    /// with an N number or without, after a move. Of lines of comments below each other the first
    /// counts.
    Comment,
}

/// What a step is to its operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OperationMark {
    /// Its first step; the comment before it, its marks included.
    Begins(Option<Span>),
    /// Nothing has moved in it yet, and a comment comes before this step.
    Names(Span),
}

/// Finds the first steps of operations.
#[derive(Debug, Default)]
pub(super) struct OperationFinder {
    /// Comments on lines of their own, in order.
    comments: Vec<Span>,
    /// How many of them come before the newest step.
    passed: usize,
    /// The operation has a step, and a move.
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

    /// Whether an operation begins with this step. A jump back in the program, as for a loop,
    /// comes to the comment there again.
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

/// The comments of the first text on lines without words.
fn comments(job: &Job<'_>) -> Vec<Span> {
    let Some(source) = job.sources().get(FileId(0)) else { return Vec::new() };
    let lexicon = job.control().table.lexicon;
    let mut reader = BlockReader::new(source.text(), FileId(0), lexicon);
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
