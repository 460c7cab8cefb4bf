//! The blocks of the program that is to begin at a line, and which one that is.

use chordal_diagnostics::TextRange;
use chordal_kernel::{RestartFault, RestartObstacle};

use crate::syntax::{
    KlartextBlock, KlartextLabel, KlartextStatement, LineReader, PathFunction, block_of_lines,
};

/// A block with the lines that it takes.
#[derive(Clone, Debug)]
pub(super) struct SourceBlock {
    /// The block.
    pub block: KlartextBlock,
    /// Its lines from the first byte to the one after the last line end.
    pub lines: TextRange,
    /// The parts of its lines that are no comment.
    pub parts: Vec<TextRange>,
}

/// The blocks of a text.
pub(super) struct SourceText<'t> {
    pub text: &'t [u8],
    pub blocks: Vec<SourceBlock>,
    /// The number of lines.
    lines: u32,
}

/// Where a program is to begin.
#[derive(Clone, Copy, Debug)]
pub(super) struct BeginPlace {
    /// The first block that is carried out, by its index.
    pub at: usize,
    /// The first byte of the text that stays.
    pub from: u32,
}

/// A refusal.
pub(super) fn fault(
    obstacle: RestartObstacle,
    what: impl Into<String>,
    help: impl Into<String>,
) -> RestartFault {
    RestartFault { obstacle, what: what.into(), help: help.into() }
}

impl<'t> SourceText<'t> {
    /// Reads the blocks of a text.
    pub fn read(text: &'t [u8]) -> SourceText<'t> {
        let mut reader = LineReader::new(text);
        let mut blocks = Vec::new();
        loop {
            let start = reader.offset();
            let Some(lines) = reader.next() else { break };
            blocks.push(SourceBlock {
                block: block_of_lines(text, &lines),
                lines: TextRange::new(start, reader.offset()),
                parts: lines.parts,
            });
        }
        SourceText { text, blocks, lines: reader.line() - 1 }
    }

    /// The statement of a block.
    pub fn statement(&self, at: usize) -> &KlartextStatement {
        &self.blocks[at].block.statement
    }

    /// The line of a block.
    pub fn line(&self, at: usize) -> u32 {
        self.blocks[at].block.line
    }

    /// Whether a block does nothing: a comment, a heading, an empty line.
    fn is_remark(&self, at: usize) -> bool {
        *self.statement(at) == KlartextStatement::Nothing
    }

    /// The last block before one that is no remark.
    pub fn before(&self, at: usize) -> Option<usize> {
        (0..at).rev().find(|at| !self.is_remark(*at))
    }

    /// The first block of the program after its own first lines: BEGIN PGM, BLK FORM, TOOL DEF and remarks, as far as they are
    /// numbers.
    pub fn first_after_frame(&self) -> usize {
        let is_of_frame = |at: usize| {
            let is_kind = matches!(
                self.statement(at),
                KlartextStatement::Nothing
                    | KlartextStatement::Begin { .. }
                    | KlartextStatement::Blank { .. }
                    | KlartextStatement::ToolDefinition { .. }
            );
            is_kind && !super::values::has_parameter(self.text, &self.blocks[at].parts)
        };
        // A remark after them belongs to what follows.
        let end = (0..self.blocks.len()).find(|at| !is_of_frame(*at)).unwrap_or(self.blocks.len());
        self.before(end).map_or(0, |last| last + 1)
    }

    /// The block that a program begins at where a line is named.
    pub fn place_of(&self, line: u32) -> Result<BeginPlace, RestartFault> {
        if line == 0 || line > self.lines {
            let what = format!("the program has no line {line}");
            let help = format!("it ends at line {}", self.lines);
            return Err(fault(RestartObstacle::NoBlock, what, help));
        }
        let containing = self.blocks.partition_point(|own| own.block.line <= line) - 1;
        let is_inside = self.line(containing) < line;
        if is_inside && !self.is_remark(containing) {
            let what = "the line is inside of a block of several lines";
            let help = format!("begin at line {}, where it begins", self.line(containing));
            return Err(fault(RestartObstacle::NoBlock, what, help));
        }
        let first = containing + usize::from(is_inside);
        let at = (first..self.blocks.len()).find(|at| !self.is_remark(*at));
        let at = at.filter(|at| !matches!(self.statement(*at), KlartextStatement::End { .. }));
        let Some(at) = at else {
            let what = "nothing to do follows the line";
            return Err(fault(RestartObstacle::NoBlock, what, "name an earlier line"));
        };
        Ok(BeginPlace { at, from: self.blocks[first].lines.start })
    }

    /// Refuses a block that goes on with what a block before it has begun.
    pub fn check_alone(&self, at: usize) -> Result<(), RestartFault> {
        use KlartextStatement as Statement;
        let before = self.before(at);
        let open = |what: &str, first: usize| {
            let help = format!("begin at line {}, where that begins", self.line(first));
            Err(fault(RestartObstacle::Open, what, help))
        };
        let is_corner = |at: usize| {
            matches!(self.statement(at), Statement::Rounding(_) | Statement::Chamfer(..))
        };
        let is_free = |at: usize| {
            matches!(self.statement(at), Statement::FreeElement(_) | Statement::FreeSelection(_))
        };
        let first_of = |is: &dyn Fn(usize) -> bool| {
            (0..at).rev().take_while(|at| self.is_remark(*at) || is(*at)).last().unwrap_or(at)
        };
        if is_corner(at) || before.is_some_and(is_corner) {
            let mut first = before.unwrap_or(at);
            if is_corner(first) {
                first = self.before(first).unwrap_or(first);
            }
            return open("the line is between RND or CHF and one of its elements", first);
        }
        let goes_on = |at: usize| is_free(at) || is_corner(at);
        if is_free(at) && before.is_some_and(goes_on) {
            return open("the line is in a free contour (FK)", first_of(&goes_on));
        }
        if let Statement::CycleLine { number, line: 1.., .. } = self.statement(at) {
            let is_of_cycle = |at: usize| matches!(self.statement(at), Statement::CycleLine { number: own, .. } if own == number);
            let first = (0..at)
                .rev()
                .find(|at| matches!(self.statement(*at), Statement::CycleLine { line: 0, .. }));
            let first = first.unwrap_or_else(|| first_of(&is_of_cycle));
            return open("the line is in the definition of a cycle", first);
        }
        self.check_direction(at)
    }

    /// Refuses a place after which the first element takes its direction, or its kind, from the one before the line.
    fn check_direction(&self, at: usize) -> Result<(), RestartFault> {
        use KlartextStatement as Statement;
        use PathFunction as Function;
        let is_element = |at: &usize| {
            matches!(
                self.statement(*at),
                Statement::Path(..)
                    | Statement::FreeElement(_)
                    | Statement::Approach(..)
                    | Statement::Departure(..)
            )
        };
        let Some(element) = (at..self.blocks.len()).find(is_element) else { return Ok(()) };
        let last = (0..at).rev().find(is_element);
        let what = match self.statement(element) {
            Statement::Path(Function::TangentArc | Function::PolarTangentArc, _)
            | Statement::Departure(..) => "goes on in the direction of the element before it",
            Statement::FreeElement(words) if words.is_tangent => {
                "goes on in the direction of the element before it"
            }
            Statement::Path(Function::Repeated, _) if last.is_some_and(|at| !self.is_line(at)) => {
                "has no path function, and repeats that of the element before it"
            }
            _ => return Ok(()),
        };
        let what = format!("the element in line {} {what}", self.line(element));
        let help = match last {
            Some(last) => format!("begin at line {}, or at a line after it", self.line(last)),
            None => "begin at another line".into(),
        };
        Err(fault(RestartObstacle::Open, what, help))
    }

    fn is_line(&self, at: usize) -> bool {
        let is_repeated = |at: usize| {
            matches!(self.statement(at), KlartextStatement::Path(PathFunction::Repeated, _))
        };
        let first =
            (0..=at).rev().filter(|at| matches!(self.statement(*at), KlartextStatement::Path(..)));
        let first = first.into_iter().find(|at| !is_repeated(*at));
        first.is_none_or(|at| {
            matches!(self.statement(at), KlartextStatement::Path(PathFunction::Line, _))
        })
    }

    /// The block of a label.
    pub fn label(&self, label: &KlartextLabel) -> Option<usize> {
        (0..self.blocks.len())
            .find(|at| matches!(self.statement(*at), KlartextStatement::Label(own) if own == label))
    }
}
